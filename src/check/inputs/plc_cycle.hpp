// SPDX-License-Identifier: MIT
// PlcCycle: represents one cycle of a PLC by Boolean functions of the values before the cycle.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "circuit/circuit.hpp"
#include "ir/bit_terms.hpp"
#include "ir/slots.hpp"

namespace grafverif {

class PlcCycle {
public:
    using VariableId = Id<Network::Variable>;
    using Literal = Gates::Literal;
    /// Bits of (value - least value of the type), least significant bit first.
    using Bits = std::vector<Literal>;

    /// Requires that `network` is expanded. `shared` contains the variables that processes other than the PLC assign.
    /// All arguments must outlive the object.
    PlcCycle(const Network& network, const Network::Controller& controller, const std::set<VariableId>& shared)
        : network_(network), slots_(network, controller.process), waiting_(controller.waiting), shared_(shared) {}

    /// Computes the functions. Returns false if the paths have too many edges or the circuit has too many gates. Also
    /// returns false if two edges of a path read the same shared variable, because the value of the variable may change
    /// between the edges.
    bool build();

    Circuit circuit = {};                    ///< the circuit has no latches; the functions below are literals of its
                                             ///< gates
    std::map<VariableId, Bits> before = {};  ///< values before the cycle, of all variables that the PLC uses
    std::map<VariableId, Bits> next = {};    ///< values after the cycle, of all variables that the PLC assigns
    std::map<VariableId, Bits> first = {};   ///< values before the first cycle, of the variables in `next`

    /// `enabled`: the condition that a cycle is possible. `starts`: the condition that a path from the initial location
    /// to the first cycle is possible. Cycles and paths with a model error are included.
    Literal enabled = Gates::no, starts = Gates::no;
    /// The condition that a cycle, or a path to the first cycle, has a race or a value that is undefined or out of
    /// range.
    Literal error = Gates::no;

private:
    using Values = std::map<VariableId, std::vector<Gate>>;
    struct Path {
        Gate condition = {};
        Values values = {};
        std::set<VariableId> read = {};  // shared variables that the edges of the path have read
    };

    Type type_of(VariableId variable) const { return network_.variables[variable].type; }
    std::vector<Gate> now(VariableId variable);
    BitTerm<Gate> initial(VariableId variable) const;
    BitTerm<Gate> term_of(const std::vector<Gate>& value, VariableId variable) const;
    std::vector<Gate> bits_of(const BitTerm<Gate>& term, VariableId variable) const;
    bool follow(Id<Network::Location> location, const Path& start);
    bool take(const Network::Edge& edge, Path& path);
    Literal join(std::map<VariableId, Bits>& results);

    const Network& network_;
    const Slots slots_;
    const Id<Network::Location> waiting_;
    const std::set<VariableId>& shared_;
    std::vector<Path> paths_ = {};
    std::size_t taken_ = 0;  // total number of edges of the paths
    Gate error_ = {};
};

}  // namespace grafverif
