// SPDX-License-Identifier: MIT
// Localization: partition of a network into fragments ("cells"). There is one fragment per partial chart; it also
// contains the instances around this chart. A network is over-approximated by some of its fragments. The other
// fragments are replaced by an over-approximation of their effects on the chosen fragments.
//
// Each fragment has separate processes and variables. An instance that communicates with exactly one chart belongs to
// the fragment of that chart. Instances between charts, such as a buffer, form separate fragments. An instance that
// communicates only with other instances belongs to the fragment of one of them. In a network without controllers, each
// process is a fragment. A variable belongs to the fragment that writes it, if there is only one such fragment.
// Variables with several writers, the flags of a PLC and the PLCs do not belong to any fragment; a fragment can contain
// a part of a PLC.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

struct NetworkFragments {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    /// The value that a Boolean variable has in all states in which time can pass: while the variable has the other
    /// value, `process` stops time.
    struct Resting {
        bool value = false;
        std::uint32_t process = none;
    };

    std::uint32_t count = 0;
    std::vector<std::uint32_t> of_process = {};   ///< fragment per process; none for a PLC
    std::vector<std::uint32_t> of_variable = {};  ///< fragment per variable; none if it does not belong to a fragment
    std::vector<std::string> names = {};  ///< name per fragment: its partial chart, controller or first instance
    std::vector<Resting> resting = {};    ///< per variable; invalid if `process` equals none
};

/// Computes the fragments of `network`. Requires that `network` is expanded.
NetworkFragments cells_of(const Network& network);

/// Premises that tests omit on purpose to show that each premise is necessary.
struct LocalAblations {
    /// An urgent edge stops time even if it is enabled for only some values of the free variables.
    bool urgent_where_possible = false;
    bool silent = false;     ///< omitted processes write no kept variable
    bool steady = false;     ///< free variables keep their initial values
    bool break_off = false;  ///< model errors in a fragment, and unexplored fragments, are ignored
    bool unproven = false;   ///< properties of other fragments are assumed before they are proved
    /// Not a premise: the value of each auxiliary variable of a PLC, such as the request of a timer, is one free choice
    /// if it reads free variables. Otherwise this coarser abstraction is used only for edges that read many of them.
    bool joint = false;
};

/// An over-approximation of a network by some fragments and the PLCs that execute their charts. If a run of the
/// complete network is projected to the kept variables, the result is a run of this network. Omitted variables are
/// free: each read of such a variable returns an arbitrary value. The process `rest` performs, at any time, the writes
/// of omitted processes to kept variables. An urgent edge that reads free variables stops time only if it is enabled
/// for all values of these variables. `race` indicates only races on kept variables.
struct LocalNetwork {
    bool made = true;  ///< false if an edge reads too many free values; the network must not be used then
    Network network = {};
    std::vector<std::uint32_t> borders = {};  ///< other fragments that kept processes read, apart from flags of a PLC
    std::vector<std::uint32_t> tied = {};     ///< all other fragments whose variables are read
    std::vector<std::size_t> known = {};      ///< indices of the invariants that exclude some values of free variables
};

/// Builds the over-approximation. Requires that `network` is expanded and that each of its terms has a value in every
/// state. `chosen` contains fragments, in order. `properties` read only these fragments (see `cells_read`).
/// `invariants` hold in each state of the complete network. Choices of values that violate an invariant are excluded.
LocalNetwork localized(const Network& network, const NetworkFragments& cells, const std::vector<std::uint32_t>& chosen,
                       const std::vector<Property>& properties, const std::vector<Id<Expr>>& invariants = {},
                       const LocalAblations& ablations = {});

/// Returns the fragments whose variables and locations the operands of `property` read, in order. The result is empty
/// if the operands read no fragment. It is also empty if an operand reads a value that a localized network does not
/// preserve: `race`, a scratch variable, or the location of a PLC in its cycle.
std::vector<std::uint32_t> cells_read(const Network& network, const NetworkFragments& cells, const Property& property);

}  // namespace grafverif
