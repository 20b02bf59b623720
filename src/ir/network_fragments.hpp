// SPDX-License-Identifier: MIT
// Localization: partition of a network into fragments ("cells"). Each partial chart has a fragment, which also contains
// the instances that communicate only with this chart. The over-approximation of a network keeps some chosen fragments.
// All other fragments are omitted and replaced by an over-approximation of their effects on the chosen fragments.
//
// A process or variable belongs to at most one fragment. An instance that communicates with exactly one chart belongs
// to the fragment of that chart. An instance that communicates with several charts, such as a buffer, is a separate
// fragment. An instance that communicates only with other instances belongs to the fragment of one of these instances.
// In a network without controllers, each process is a fragment. A variable with exactly one writer (a process or a
// partial chart) belongs to the fragment of its writer. The PLC processes, the flags of a PLC and variables with
// several writers do not belong to any fragment. A fragment can contain variables of a PLC.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

struct NetworkFragments {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    /// The value that a Boolean variable has in all states in which time can pass. While the variable has the opposite
    /// value, `process` prevents time from passing.
    struct Resting {
        bool value = false;
        std::uint32_t process = none;
    };

    std::uint32_t count = 0;
    std::vector<std::uint32_t> of_process = {};  ///< fragment per process; `none` for the process of a PLC

    /// Fragment per variable; `none` if the variable does not belong to a fragment.
    std::vector<std::uint32_t> of_variable = {};
    std::vector<std::string> names = {};  ///< per fragment: name of its partial chart, controller or first instance
    std::vector<Resting> resting = {};    ///< per variable; valid only if `process` differs from `none`
};

/// Computes the fragments of `network`. Requires that `network` is expanded.
NetworkFragments cells_of(const Network& network);

/// Ablations of the premises of the over-approximation. If a member is true, one premise is dropped, so that tests can
/// show that this premise is necessary.
struct LocalAblations {
    /// True: an urgent edge stops time even if it is enabled for only some values of the free variables.
    bool urgent_where_possible = false;
    bool silent = false;     ///< true: omitted processes do not write kept variables
    bool steady = false;     ///< true: free variables keep their initial values
    bool break_off = false;  ///< true: model errors in a fragment, and unexplored fragments, are ignored
    bool unproven = false;   ///< true: properties of other fragments are assumed before they are proved

    /// Not a premise. If true, each auxiliary variable of a PLC that reads free variables, such as a timer request, has
    /// an arbitrary value. If false, this coarser abstraction is used only for edges that read many free variables.
    bool joint = false;
};

/// An over-approximation of a network by some fragments and the PLCs that execute their charts. The projection of each
/// run of the complete network to the kept variables is a run of `network`. Omitted variables are free: each read of
/// such a variable returns an arbitrary value. The process `rest` performs, at any time, the writes of omitted
/// processes to kept variables. An urgent edge that reads free variables stops time only if it is enabled for all
/// values of these variables. The flag `network.race` is set only by races on kept variables.
struct LocalNetwork {
    bool made = true;  ///< false if an edge reads too many free values; if false, `network` must not be used
    Network network = {};
    /// Omitted fragments that kept processes read, except to compute the values of flags of a PLC.
    std::vector<std::uint32_t> borders = {};
    std::vector<std::uint32_t> tied = {};  ///< all omitted fragments whose variables are read
    std::vector<std::size_t> known = {};   ///< indices of the invariants that exclude some values of free variables
};

/// Builds the over-approximation. Requires that `network` is expanded and that each of its terms has a value in every
/// state. `chosen` contains the kept fragments in increasing order. `properties` read only these fragments (see
/// `cells_read`). `invariants` must hold in each reachable state of the complete network. Values of free variables that
/// violate an invariant are excluded.
LocalNetwork localized(const Network& network, const NetworkFragments& cells, const std::vector<std::uint32_t>& chosen,
                       const std::vector<Property>& properties, const std::vector<Id<Expr>>& invariants = {},
                       const LocalAblations& ablations = {});

/// Returns the fragments whose variables and locations the operands of `property` read, in order. The result is empty
/// if the operands read no fragment. The result is also empty if an operand reads a value that a localized network does
/// not preserve: the flag `race`, a scratch variable, or the location of a PLC in its cycle.
std::vector<std::uint32_t> cells_read(const Network& network, const NetworkFragments& cells, const Property& property);

}  // namespace grafverif
