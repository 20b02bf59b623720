// SPDX-License-Identifier: MIT
// LatchPairs: invariants of two literals. A pair consists of two latches and a value of each; a state satisfies the
// pair if both latches have these values. The search computes pairs that no reachable state satisfies. For example, two
// steps of a sequence are never both active. All pairs of the result are proved together by induction (Houdini;
// Flanagan and Leino 2001: "Houdini, an annotation assistant for ESC/Java"; for circuits: Case, Mishchenko and Brayton
// 2007: "Inductively finding a reachable state space over-approximation").
//
// The candidates are all pairs that the initial state does not satisfy. A SAT solver searches for a step from a state
// that satisfies no candidate to a state that satisfies some candidates; these candidates are dropped. The search ends
// if no such step exists.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/pdr/certificate.hpp"

namespace grafverif::pdr {

/// A latch, identified by its name, and a value of the latch. A vector of such values (NamedCube) represents the states
/// that have all these values and in which Circuit::broken is false.
struct NamedValue {
    std::string latch = {};
    bool value = false;
};
using NamedCube = std::vector<NamedValue>;

class LatchPairs {
public:
    /// Maximum number of latches. Circuits with more latches have too many candidates; for these circuits, the result
    /// is empty.
    static constexpr std::size_t most_latches = 1024;

    /// All arguments must outlive the object. If `candidates` is not null and not empty, the search considers only the
    /// cubes in `candidates` whose latches the circuit contains. Usually, `candidates` is the result for an abstraction
    /// of the circuit.
    LatchPairs(const Circuit& circuit, LimitMonitor& watch, const std::vector<NamedCube>* candidates = nullptr);

    /// Returns cubes that contain no reachable state. The complement of the cubes is an inductive invariant (see
    /// `flaw`). Each cube contains one or two literals of latches, and the literal `not broken` (see Circuit::broken).
    /// Throws Exhausted if a limit is exceeded; the next call continues the search.
    const std::vector<Cube>& cubes();
    /// Returns the result of `cubes` with the names of the latches.
    std::vector<NamedCube> named_cubes();

private:
    using Bits = std::vector<std::uint64_t>;

    /// The candidates of a latch a. Candidate for each latch b in `both`: a and b are true. Candidate for each latch b
    /// in `without`: a is true and b is false. If `never` is true, the only candidate of the row is the single value
    /// "a is true".
    struct Row {
        Bits both = {}, without = {};
        bool never = true;
        int premise = 0;    // solver variable; if true, the current state satisfies no candidate of the row
        int violation = 0;  // solver variable; if true, the next state satisfies a candidate of the row
    };

    void set_candidates();
    void select_candidates();
    void begin();
    void assume(std::size_t latch);
    void require_violation(std::size_t latch);
    void drop(const std::vector<bool>& state);
    bool refute();

    const Circuit& circuit_;
    LimitMonitor& watch_;
    const std::vector<NamedCube>* candidates_;
    std::optional<Solver> solver_ = {};
    std::vector<Row> rows_ = {};
    std::vector<int> now_ = {}, next_ = {};  // solver literal of each latch, before and after a step
    std::optional<std::vector<Cube>> cubes_ = {};
};

}  // namespace grafverif::pdr
