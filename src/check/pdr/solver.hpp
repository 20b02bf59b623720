// SPDX-License-Identifier: MIT
// Incremental solver for functions of one state of a circuit (CaDiCaL; Biere, Fazekas, Fleury and Heisinger 2020). A
// gate is translated to clauses on first use, so that the cost of a query depends only on its cone.
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

/// Time and memory limits, and the cancellation flag.
struct SolverLimits {
    std::uint64_t memory = std::uint64_t{2} << 30U;  ///< memory in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

/// Thrown when a limit is exceeded. The current query of the solver then has no result.
struct Exhausted {
    enum class Cause { Memory, Stopped };
    Cause cause = Cause::Stopped;
};

/// Polls the limits while the solver works, and for other callers.
class LimitMonitor final : public CaDiCaL::Terminator {
public:
    explicit LimitMonitor(const SolverLimits& bounds);

    /// Sets the deadline to the end of the first of `parts` equal shares of the remaining time. Work that exceeds it
    /// may continue in the next share.
    void share(std::size_t parts);
    /// Limits the following work to this time, within the remaining time.
    void limit(std::chrono::steady_clock::duration time);
    /// Also ends the following work if this flag is set; null means no flag.
    void end_with(const std::atomic<bool>* moot) { moot_ = moot; }
    std::optional<std::chrono::steady_clock::time_point> deadline() const { return share_; }
    /// True if a limit of the complete work is exceeded, not only the limit of a share.
    bool over() const;

    bool terminate() override;
    /// Throws Exhausted if a limit is exceeded.
    void look();
    std::uint64_t bytes() const;  ///< memory allocated since construction, in bytes

private:
    SolverLimits bounds_;
    std::optional<std::chrono::steady_clock::time_point> share_ = {};  ///< deadline of the current share
    const std::atomic<bool>* moot_ = nullptr;
    std::uint64_t before_ = 0;
    std::uint32_t calls_ = 0;
    std::chrono::steady_clock::time_point weighed_ = {};  ///< time of the last memory measurement
    std::optional<Exhausted::Cause> met_ = {};
};

/// CaDiCaL with the limits of a LimitMonitor. After an exception such as std::bad_alloc, CaDiCaL is unusable: if it is
/// called again, it aborts the process, and its destructor may release a wrong address (Internal::enlarge in 1.5.3).
/// Therefore every later call throws std::bad_alloc, and the memory of the solver is not released.
class SatSolver {
public:
    explicit SatSolver(LimitMonitor& watch);
    ~SatSolver();
    SatSolver(const SatSolver&) = delete;
    SatSolver& operator=(const SatSolver&) = delete;

    /// For thousands of small queries: disables techniques that inspect all clauses.
    void expect_small_queries();
    void add(std::span<const int> clause);
    /// True if the assumptions are satisfiable, together with at least one of `one_of` if it is not empty. Throws
    /// Exhausted.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {});
    /// Value of a literal after a satisfiable query.
    bool is_true(int literal) const;
    /// After an unsatisfiable query: true if the refutation needed the assumption.
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
    /// All arguments must outlive the object. Gates may be added to the circuit.
    Solver(const Circuit& circuit, LimitMonitor& watch);

    /// Returns the solver's literal for a literal of the circuit; adds the clauses of its gates.
    int of(Literal literal);
    /// Returns a new variable.
    int fresh() { return ++variables_; }
    /// Makes all existing and later latch variables false under `condition`.
    void all_false_under(int condition);

    void add(std::span<const int> clause);
    /// See SatSolver.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {}) {
        return solver_.solve(assumptions, one_of);
    }
    /// Return, for the last query, the value of a literal that the solver knows, and if the refutation needed an
    /// assumption.
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
    std::vector<int> variable_;   ///< variable of each node; 0 if it has none yet
    std::vector<bool> is_latch_;  ///< true if the node is a latch
    std::vector<int> latches_ = {};
    int variables_ = 0;
    int initial_ = 0;
    std::uint64_t clauses_ = 0;
};

}  // namespace grafverif::pdr
