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

class Solver {
public:
    /// All outlive it; the circuit may gain gates.
    Solver(const Circuit& circuit, Watch& watch);
    ~Solver();
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    /// A literal of the circuit as one of the solver; its gates are clauses from now on.
    int of(Literal literal);
    /// A new variable.
    int fresh() { return ++variables_; }
    /// The latch variables that are false where `condition` holds: those that are there, and those to come.
    void all_false_under(int condition);

    void add(std::span<const int> clause);
    /// Whether the assumptions can be met, together with `one_of` where there is any. Throws Exhausted.
    bool solve(std::span<const int> assumptions, std::span<const int> one_of = {});
    /// Of the last answer: the value of a literal that the solver knows; whether an assumption was needed to refute.
    bool value(Literal literal) const;
    bool knows(Literal literal) const {
        return node_of(literal) < variable_.size() && variable_[node_of(literal)] != 0;
    }
    bool failed(int assumption) { return solver_->failed(assumption); }

    std::uint64_t clauses() const { return clauses_; }

private:
    int variable(std::uint32_t node);
    int literal(Literal literal) const;

    const Circuit& circuit_;
    Watch& watch_;
    std::unique_ptr<CaDiCaL::Solver> solver_;
    std::vector<int> variable_;   ///< per node; 0: none yet
    std::vector<bool> is_latch_;  ///< per node
    std::vector<int> latches_ = {};
    int variables_ = 0;
    int initial_ = 0;
    std::uint64_t clauses_ = 0;
};

}  // namespace grafverif::pdr
