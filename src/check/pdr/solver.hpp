// SPDX-License-Identifier: MIT
// Solver: an incremental SAT solver (CaDiCaL; Biere, Fazekas, Fleury and Heisinger 2020) for the gates of a circuit,
// which are Boolean functions of the latches and inputs. A gate is translated to clauses when a query first uses it.
// Therefore the cost of a query depends only on the gates in its cone of influence.
#pragma once

#include <atomic>
#include <cadical.hpp>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "circuit/circuit.hpp"

namespace grafverif::pdr {

using Literal = Gates::Literal;

/// The memory limit, the deadline and the cancellation flag of a computation.
struct SolverLimits {
    std::uint64_t memory = std::uint64_t{2} << 30U;  ///< memory limit in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

/// Exception: a limit is exceeded, or the work is cancelled. A solver query that throws Exhausted has no result.
struct Exhausted {
    enum class Cause { Memory, Stopped };
    Cause cause = Cause::Stopped;
};

/// Tests regularly whether a limit is exceeded, while the solver or another caller works.
class LimitMonitor final : public CaDiCaL::Terminator {
public:
    explicit LimitMonitor(const SolverLimits& bounds);

    /// Divides the remaining time into `parts` equal shares, and sets the deadline of the following work to the end of
    /// the first share. Work that exceeds its share can be continued in a later share.
    void share(std::size_t parts);
    /// Limits the following work to `time` or to the remaining time, whichever is shorter.
    void limit(std::chrono::steady_clock::duration time);
    /// Sets a second cancellation flag: the following work ends when this flag becomes true. A null pointer removes the
    /// flag.
    void end_with(const std::atomic<bool>* decided_elsewhere) { decided_elsewhere_ = decided_elsewhere; }
    std::optional<std::chrono::steady_clock::time_point> deadline() const { return share_; }
    /// True if the work was cancelled or the deadline of SolverLimits has passed. This function ignores the deadlines
    /// of shares and the memory limit.
    bool over() const;

    bool terminate() override;
    /// Throws Exhausted if a limit is exceeded or the work is cancelled.
    void look();
    std::uint64_t bytes() const;  ///< memory allocated since construction, in bytes

private:
    SolverLimits bounds_;
    std::optional<std::chrono::steady_clock::time_point> share_ = {};  ///< deadline of the current share
    const std::atomic<bool>* decided_elsewhere_ = nullptr;
    std::uint64_t before_ = 0;
    std::uint32_t calls_ = 0;
    std::chrono::steady_clock::time_point weighed_ = {};  ///< time of the last memory measurement
    std::optional<Exhausted::Cause> met_ = {};
};

/// The SAT solver CaDiCaL with the limits of a LimitMonitor. After an exception such as std::bad_alloc, CaDiCaL is
/// unusable: a further call aborts the process, and the destructor may release a wrong address (Internal::enlarge in
/// 1.5.3). Therefore every later call throws std::bad_alloc, and the memory of the solver is not released.
class SatSolver {
public:
    explicit SatSolver(LimitMonitor& watch);
    ~SatSolver();
    SatSolver(const SatSolver&) = delete;
    SatSolver& operator=(const SatSolver&) = delete;

    /// Disables solver techniques that inspect all clauses. These techniques are too expensive for thousands of small
    /// queries.
    void expect_small_queries();
    /// Writes a proof in DRAT, as text, to `file`. Must be called before the first clause is added.
    void write_proof(FILE* file);
    /// Completes the proof file. Requires that the last query was unsatisfiable.
    void end_proof();
    void add(std::span<const int> clause);
    /// True if the clauses are satisfiable under the assumptions; if `one_of` is not empty, at least one of its
    /// literals must also be true. Throws Exhausted if a limit is exceeded.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {});
    /// Returns the value of a literal after a satisfiable query.
    bool is_true(int literal) const;
    /// True if the proof of the last, unsatisfiable query used the assumption.
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

    /// Returns the solver's literal for a literal of the circuit, and adds the clauses of the gates in its cone.
    int of(Literal literal);
    /// Returns a new variable.
    int fresh() { return ++variables_; }
    /// Adds clauses which state that the variables of all latches are false if `condition` is true. Such clauses are
    /// also added for latches whose variables are created later.
    void all_false_under(int condition);

    void add(std::span<const int> clause);
    /// Solves a query; see SatSolver::solve.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {}) {
        return solver_.solve(assumptions, one_of);
    }
    /// `value` returns the value of a literal after a satisfiable query. `knows` is true if the solver has a variable
    /// for the literal. `failed` is true if the proof of the last, unsatisfiable query used the assumption.
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
    std::vector<int> variable_;   ///< variable of each node; 0 if the node has no variable yet
    std::vector<bool> is_latch_;  ///< true if the node is a latch
    std::vector<int> latches_ = {};
    int variables_ = 0;
    int initial_ = 0;
    std::uint64_t clauses_ = 0;
};

}  // namespace grafverif::pdr
