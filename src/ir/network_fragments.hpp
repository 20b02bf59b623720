// SPDX-License-Identifier: MIT
// Localization: partition of a network into fragments ("cells"), one per partial chart with the instances around it. A
// network is over-approximated by some of its fragments; the others are replaced by an upper bound of their behaviour
// at the borders.
//
// A fragment has its own processes and variables. Instances that communicate with only one chart belong to its
// fragment; instances between charts (a buffer) form separate fragments; so does each process of a network without
// controllers. A variable belongs to the only fragment that writes it. Variables with several writers and the flags of
// a PLC belong to no fragment; neither do the PLCs, of which each fragment has a part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

struct NetworkFragments {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    /// Fixed value of a Boolean variable in all states where time can pass: `process` stops time while the variable has
    /// the other value.
    struct Resting {
        bool value = false;
        std::uint32_t process = none;
    };

    std::uint32_t count = 0;
    std::vector<std::uint32_t> of_process = {};   ///< per process; none: a PLC
    std::vector<std::uint32_t> of_variable = {};  ///< per variable; none: it belongs to no fragment
    std::vector<std::string> names = {};          ///< per fragment: its partial chart, controller or first instance
    std::vector<Resting> resting = {};            ///< per variable; `process` equals none if the value is not fixed
};

/// Requires: `network` is expanded.
NetworkFragments cells_of(const Network& network);

/// Premises that are omitted on purpose, for tests that show that each of them is needed.
struct LocalAblations {
    bool urgent_where_possible = false;  ///< urgent edges stop time if some (not every) free value enables them
    bool silent = false;                 ///< omitted processes write no kept variable
    bool steady = false;                 ///< free variables keep their initial values
    bool break_off = false;              ///< model errors in a fragment, and unexplored fragments, are ignored
    bool unproven = false;               ///< properties of other fragments are assumed before they are proved
};

/// Over-approximation by some fragments and the PLCs that they have parts of: every run of the complete network,
/// projected to the kept variables, is a run of this network. Omitted variables are free: each read of one returns an
/// arbitrary value. The process `rest` performs, at any time, the writes of omitted processes to kept variables. An
/// urgent edge that reads free variables stops time only if all their values enable it. `race` concerns only kept
/// variables.
struct LocalNetwork {
    bool made = true;  ///< false: an edge reads too many free values; the network is unusable
    Network network = {};
    std::vector<std::uint32_t> borders = {};  ///< other fragments that kept processes read, flags of a PLC excepted
    std::vector<std::uint32_t> tied = {};     ///< all other fragments that are read
    std::vector<std::size_t> known = {};      ///< indices of the invariants that exclude some free values
};

/// Requires: `network` is expanded and each of its terms has a value in every state; `chosen` are fragments, in order;
/// `properties` read only these (cells_read); `invariants` hold in each state of the complete network. Edges do not
/// choose values that violate an invariant.
LocalNetwork localized(const Network& network, const NetworkFragments& cells, const std::vector<std::uint32_t>& chosen,
                       const std::vector<Property>& properties, const std::vector<Id<Expr>>& invariants = {},
                       const LocalAblations& ablations = {});

/// The fragments whose variables and locations the operands of `property` read, in order. Empty: none, or it reads a
/// value that a localized network does not preserve: `race`, a scratch variable, or the location of a PLC in its cycle.
std::vector<std::uint32_t> cells_read(const Network& network, const NetworkFragments& cells, const Property& property);

}  // namespace grafverif
