// SPDX-License-Identifier: MIT
// Incremental solver for functions of one state of a circuit (CaDiCaL; Biere, Fazekas, Fleury and Heisinger 2020). A
// gate is translated to clauses on first use, so that a query only costs its cone.
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

/// Limits of the work.
struct SolverLimits {
    std::uint64_t memory = std::uint64_t{2} << 30U;  ///< bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

/// Thrown when a limit is exceeded; the current query of the solver has no result then.
struct Exhausted {
    enum class Cause { Memory, Stopped };
    Cause cause = Cause::Stopped;
};

/// Polls the limits, during the solver's work and for other callers.
class LimitMonitor final : public CaDiCaL::Terminator {
public:
    explicit LimitMonitor(const SolverLimits& bounds);

    /// From now on one of `parts` equal shares of the remaining time is the limit; work that exceeds it may continue in
    /// the next share.
    void share(std::size_t parts);
    /// From now on the given time is the limit, within the remaining time.
    void limit(std::chrono::steady_clock::duration time);
    /// From now on the work also ends if this flag is set; null: none.
    void end_with(const std::atomic<bool>* moot) { moot_ = moot; }
    std::optional<std::chrono::steady_clock::time_point> deadline() const { return share_; }
    /// True if a limit of all the work is exceeded, not only of a share.
    bool over() const;

    bool terminate() override;
    /// Throws Exhausted if a limit is exceeded.
    void look();
    std::uint64_t bytes() const;  ///< memory allocated since construction

private:
    SolverLimits bounds_;
    std::optional<std::chrono::steady_clock::time_point> share_ = {};  ///< the current deadline
    const std::atomic<bool>* moot_ = nullptr;
    std::uint64_t before_ = 0;
    std::uint32_t calls_ = 0;
    std::chrono::steady_clock::time_point weighed_ = {};  ///< time of the last memory measurement
    std::optional<Exhausted::Cause> met_ = {};
};

/// CaDiCaL with the bounds of a LimitMonitor. An exception from it, such as std::bad_alloc, leaves it unusable: it
/// aborts the process when it is called again, and its destructor may release a wrong address (Internal::enlarge in
/// 1.5.3). After one, every call throws std::bad_alloc, and the memory of the solver is not released.
class SatSolver {
public:
    explicit SatSolver(LimitMonitor& watch);
    ~SatSolver();
    SatSolver(const SatSolver&) = delete;
    SatSolver& operator=(const SatSolver&) = delete;

    /// For thousands of small queries: disables techniques that inspect all clauses.
    void expect_small_queries();
    void add(std::span<const int> clause);
    /// True if the assumptions are satisfiable, together with one of `one_of` if it is not empty. Throws Exhausted.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {});
    /// After a satisfiable query.
    bool is_true(int literal) const;
    /// After an unsatisfiable query: true if the assumption was needed for the refutation.
    bool failed(int assumption);

private:
    template <class Work>
    auto guarded(const Work& work) const;

    LimitMonitor& watch_;
    std::unique_ptr<CaDiCaL::Solver> solver_;
    mutable bool broken_ = false;
};

class Solver {
public:
    /// All arguments must outlive the object; the circuit may gain gates.
    Solver(const Circuit& circuit, LimitMonitor& watch);

    /// The solver's literal for one of the circuit; adds the clauses of its gates.
    int of(Literal literal);
    /// A new variable.
    int fresh() { return ++variables_; }
    /// Makes all latch variables false under `condition`: existing ones, and later ones.
    void all_false_under(int condition);

    void add(std::span<const int> clause);
    /// See SatSolver.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {}) {
        return solver_.solve(assumptions, one_of);
    }
    /// For the last query: the value of a literal that the solver knows; true if an assumption was needed for the
    /// refutation.
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
