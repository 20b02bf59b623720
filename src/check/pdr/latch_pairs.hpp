// SPDX-License-Identifier: MIT
// Invariants of two literals: pairs of latches that no reachable state contains with certain values, for example the
// activities of two steps of a sequence that are never active together. All pairs of the result are proved together by
// induction (Houdini; Flanagan and Leino 2001: "Houdini, an annotation assistant for ESC/Java"; for circuits: Case,
// Mishchenko and Brayton 2007: "Inductively finding a reachable state space over-approximation").
//
// The candidates are all pairs that the first state does not contain. A solver searches for a step from a state that
// contains no candidate to a state that contains some candidates, and these candidates are dropped. The search ends if
// there is no such step.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/pdr/certificate.hpp"

namespace grafverif::pdr {

/// A value of a latch, by its name. The vector NamedCube represents the states that have all its values and in which
/// Circuit::broken is false.
struct NamedValue {
    std::string latch = {};
    bool value = false;
};
using NamedCube = std::vector<NamedValue>;

class LatchPairs {
public:
    /// Circuits with more latches have too many candidates; the result is then empty.
    static constexpr std::size_t most_latches = 1024;

    /// All arguments must outlive the object. If `candidates` is not null and not empty, the candidates are its cubes
    /// whose latches the circuit contains; these are usually the result for an abstraction of the circuit.
    LatchPairs(const Circuit& circuit, LimitMonitor& watch, const std::vector<NamedCube>* candidates = nullptr);

    /// Returns cubes that contain no reachable state. The complement of the cubes is an inductive invariant (see
    /// `flaw`). A cube contains one or two literals, and the literal that Circuit::broken is false. Throws Exhausted if
    /// a limit is exceeded; the next call continues the search.
    const std::vector<Cube>& cubes();
    /// Returns the result of `cubes` with the names of the latches.
    std::vector<NamedCube> named_cubes();

private:
    using Bits = std::vector<std::uint64_t>;

    /// The candidates with latch `a`: no state contains `a` and a latch of `both`, and no state contains `a` without
    /// each latch of `without`. If `never` is true, no state contains `a`.
    struct Row {
        Bits both = {}, without = {};
        bool never = true;
        int premise = 0;    // while assumed, the current state contains no candidate of the row
        int violation = 0;  // implies that the next state contains a candidate of the row
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
    std::vector<int> now_ = {}, next_ = {};  // the solver's literals of each latch, before and after a step
    std::optional<std::vector<Cube>> cubes_ = {};
};

}  // namespace grafverif::pdr
