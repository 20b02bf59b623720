// SPDX-License-Identifier: MIT
// One state of a circuit, with the functions of it that anybody asks for, as clauses in a solver (CaDiCaL; Biere, Fazekas,
// Fleury and Heisinger 2020) that is asked again and again. A gate becomes clauses when it is first spoken of, so that what
// a question does not concern costs nothing.
#pragma once

#include <atomic>
#include <cadical.hpp>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "circuit/circuit.hpp"

namespace grafverif::pdr {

using Literal = Gates::Literal;

/// What bounds the work.
struct Bounds {
    std::uint64_t memory = std::uint64_t{2} << 30U;  ///< bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

/// Thrown where a bound is met; what a solver was asked last has no answer then.
struct Exhausted {
    enum class Cause { Memory, Stopped };
    Cause cause = Cause::Stopped;
};

/// Looks at the bounds while the solver works, and for who asks.
class Watch final : public CaDiCaL::Terminator {
public:
    explicit Watch(const Bounds& bounds);

    /// From now on a share of the time left counts, one of `parts` alike; whoever met that bound may go on in the next.
    void share(std::size_t parts);
    /// From now on there is that time at most, within what is left at all.
    void limit(std::chrono::steady_clock::duration time);
    /// From now on the work ends too where this is set; null: it does not.
    void end_with(const std::atomic<bool>* moot) { moot_ = moot; }
    std::optional<std::chrono::steady_clock::time_point> deadline() const { return share_; }
    /// Whether all is over, not a share alone.
    bool over() const;

    bool terminate() override;
    /// Throws Exhausted where a bound is met.
    void look();
    std::uint64_t bytes() const;  ///< memory taken since this was made

private:
    Bounds bounds_;
    std::optional<std::chrono::steady_clock::time_point> share_ = {};  ///< the deadline that counts now
    const std::atomic<bool>* moot_ = nullptr;
    std::uint64_t before_ = 0;
    std::uint32_t calls_ = 0;
    std::chrono::steady_clock::time_point weighed_ = {};  ///< when the memory was last looked at
    std::optional<Exhausted::Cause> met_ = {};
};

/// CaDiCaL with the bounds of a Watch. An exception from it, such as std::bad_alloc, leaves it unusable: it aborts the
/// process when it is called again, and its destructor may release a wrong address (Internal::enlarge in 1.5.3). After
/// one, every call throws std::bad_alloc, and the memory of the solver is not released.
class SatSolver {
public:
    explicit SatSolver(Watch& watch);
    ~SatSolver();
    SatSolver(const SatSolver&) = delete;
    SatSolver& operator=(const SatSolver&) = delete;

    /// For thousands of small queries: no technique that inspects all clauses.
    void expect_small_queries();
    void add(std::span<const int> clause);
    /// True if the assumptions can be met, together with one of `one_of` if it is not empty. Throws Exhausted.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {});
    /// After a query that can be met.
    bool is_true(int literal) const;
    /// After a query that cannot be met: true if the assumption was needed to refute it.
    bool failed(int assumption);

private:
    template <class Work>
    auto guarded(const Work& work) const;

    Watch& watch_;
    std::unique_ptr<CaDiCaL::Solver> solver_;
    mutable bool broken_ = false;
};

class Solver {
public:
    /// All outlive it; the circuit may gain gates.
    Solver(const Circuit& circuit, Watch& watch);

    /// A literal of the circuit as one of the solver; its gates are clauses from now on.
    int of(Literal literal);
    /// A new variable.
    int fresh() { return ++variables_; }
    /// The latch variables that are false where `condition` holds: those that are there, and those to come.
    void all_false_under(int condition);

    void add(std::span<const int> clause);
    /// See SatSolver.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {}) {
        return solver_.solve(assumptions, one_of);
    }
    /// Of the last answer: the value of a literal that the solver knows; whether an assumption was needed to refute.
    bool value(Literal literal) const;
    bool knows(Literal literal) const {
        return node_of(literal) < variable_.size() && variable_[node_of(literal)] != 0;
    }
    bool failed(int assumption) { return solver_.failed(assumption); }

    std::uint64_t clauses() const { return clauses_; }

private:
    int variable(std::uint32_t node);
    int literal(Literal literal) const;

    const Circuit& circuit_;
    SatSolver solver_;
    std::vector<int> variable_;   ///< per node; 0: none yet
    std::vector<bool> is_latch_;  ///< per node
    std::vector<int> latches_ = {};
    int variables_ = 0;
    int initial_ = 0;
    std::uint64_t clauses_ = 0;
};

}  // namespace grafverif::pdr
