// SPDX-License-Identifier: MIT
// Cells: a network cut into a partial chart each, with the instances around it; and a network with only some of its
// cells left, the others replaced by what they may do at their borders at most.
//
// A cell has processes and variables of its own. The instances that talk to one chart only are of its cell; those between
// charts (a buffer) are cells of their own; so is each process of a network without controllers. A variable belongs to the
// cell that alone writes it. Those that several write, and the flags of a PLC, belong to nobody; neither do the PLCs
// themselves, of which each cell has its part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

struct NetworkCells {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    /// What a Boolean variable is wherever time passes: `process` stops time while it is anything else.
    struct Resting {
        bool value = false;
        std::uint32_t process = none;
    };

    std::uint32_t count = 0;
    std::vector<std::uint32_t> of_process = {};   ///< per process; none: a PLC
    std::vector<std::uint32_t> of_variable = {};  ///< per variable; none: nobody's
    std::vector<std::string> names = {};          ///< per cell: its partial chart, controller, or first instance
    std::vector<Resting> resting = {};            ///< per variable; `process` none: it may be anything
};

/// Requires: `network` is expanded.
NetworkCells cells_of(const Network& network);

/// Premises left out on purpose, for laws that see what each is good for.
struct LocalAblations {
    bool urgent_where_possible = false;  ///< urgent edges stop time where some free value enables them, not all
    bool silent = false;                 ///< what is left out writes nothing that is kept
    bool steady = false;                 ///< free values stay what they are at first
    bool break_off = false;              ///< that a search breaks off says nothing of it, nor that another does
    bool unproven = false;               ///< what is asked of other cells is known before it is found to hold
};

/// Some cells of a network, and the PLCs that they have a part of, as a network of its own that can do whatever the whole
/// does, seen in what is kept; perhaps more. What is left out is free: whoever reads it finds any value, each time anew.
/// What it may write of what is kept, the process `rest` writes at any moment. An urgent edge that reads what is free
/// stops time only where every value enables it. `race` is told of what is kept.
struct LocalNetwork {
    bool made = true;  ///< false: an edge reads too many free values; the network is of no use
    Network network = {};
    std::vector<std::uint32_t> borders = {};  ///< other cells that kept processes read, but for flags of a PLC
    std::vector<std::uint32_t> tied = {};     ///< all other cells that are read
    std::vector<std::size_t> known = {};      ///< the invariants that keep some free values away
};

/// Requires: `network` is expanded, and each of its terms has a value in every state; `chosen` are cells, in order, and
/// `properties` read nothing but these (cells_read); `invariants` are true in each state of the whole. An edge chooses no
/// values that break one of these.
LocalNetwork localized(const Network& network, const NetworkCells& cells, const std::vector<std::uint32_t>& chosen,
                       const std::vector<Property>& properties, const std::vector<Id<Expr>>& invariants = {},
                       const LocalAblations& ablations = {});

/// The cells whose variables and locations the operands of `property` read, in order. Empty: none, or it reads what no
/// local network tells: `race`, a scratch variable, where a PLC is in its cycle.
std::vector<std::uint32_t> cells_read(const Network& network, const NetworkCells& cells, const Property& property);

}  // namespace grafverif
