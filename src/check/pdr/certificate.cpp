// SPDX-License-Identifier: MIT
#include "check/pdr/certificate.hpp"

#include <algorithm>
#include <unordered_map>

namespace grafverif::pdr {

namespace {

/// A SAT solver with the clauses of all gates of the circuit. Variable n + 1 of the solver represents node n.
class CircuitClauses {
public:
    CircuitClauses(const Circuit& circuit, LimitMonitor& watch)
        : solver_(watch), variables_(static_cast<int>(circuit.gates.size())) {
        clause({-1});
        for (std::uint32_t node = 1; node < circuit.gates.size(); ++node) {
            if (!circuit.gates.is_gate(node)) continue;
            const int out = of(2 * node), left = of(circuit.gates[node].left), right = of(circuit.gates[node].right);
            clause({-out, left});
            clause({-out, right});
            clause({out, -left, -right});
        }
    }

    static int of(Literal literal) {
        const int variable = static_cast<int>(node_of(literal)) + 1;
        return is_inverted(literal) ? -variable : variable;
    }
    void clause(const std::vector<int>& literals) { solver_.add(literals); }
    int fresh() { return ++variables_; }
    /// True if the clauses and the assumptions are satisfiable. If `one_of` is not empty, at least one of its literals
    /// must also be true.
    bool possible(const std::vector<int>& assumptions, const std::vector<int>& one_of = {}) {
        return solver_.solve(assumptions, one_of);
    }

private:
    SatSolver solver_;
    int variables_;
};

}  // namespace

std::string flaw(const Circuit& circuit, Literal bad, const std::vector<Cube>& cubes, LimitMonitor& watch) {
    std::unordered_map<std::uint32_t, Literal> next;
    for (const Circuit::Latch& latch : circuit.latches) next[latch.node] = latch.next;
    CircuitClauses solver(circuit, watch);
    for (const Cube& cube : cubes) {
        std::vector<int> outside;
        for (const Literal literal : cube) {
            if (!next.contains(node_of(literal))) return "the invariant contains a literal that is not a latch";
            outside.push_back(-CircuitClauses::of(literal));
        }
        if (std::ranges::all_of(cube, is_inverted)) return "the invariant excludes an initial state";
        solver.clause(outside);
    }
    if (solver.possible({CircuitClauses::of(bad)})) return "the invariant does not exclude the bad states";
    std::vector<int> entered;  // for each cube: a solver variable; if it is true, the next state belongs to the cube
    for (const Cube& cube : cubes) {
        entered.push_back(solver.fresh());
        for (const Literal literal : cube)
            solver.clause({-entered.back(), CircuitClauses::of(next[node_of(literal)] ^ (literal & 1U))});
    }
    if (!entered.empty() && solver.possible({}, entered)) return "the invariant is not inductive";
    return {};
}

}  // namespace grafverif::pdr
