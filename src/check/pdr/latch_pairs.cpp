// SPDX-License-Identifier: MIT
#include "check/pdr/latch_pairs.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace grafverif::pdr {

namespace {

constexpr std::size_t word_bits = 64;

bool bit(const std::vector<std::uint64_t>& bits, std::size_t k) {
    return (bits[k / word_bits] >> (k % word_bits) & 1U) != 0;
}

void set(std::vector<std::uint64_t>& bits, std::size_t k) { bits[k / word_bits] |= std::uint64_t{1} << k % word_bits; }

void reset(std::vector<std::uint64_t>& bits, std::size_t k) {
    bits[k / word_bits] &= ~(std::uint64_t{1} << k % word_bits);
}

}  // namespace

LatchPairs::LatchPairs(const Circuit& circuit, LimitMonitor& watch, const std::vector<NamedCube>* candidates)
    : circuit_(circuit), watch_(watch), candidates_(candidates) {}

/// Creates the rows with all pairs that the initial state does not satisfy and that do not contain the latch `broken`.
void LatchPairs::set_candidates() {
    const std::size_t count = circuit_.latches.size();
    Bits all(count / word_bits + 1, 0);
    for (std::size_t k = 0; k < count; ++k)
        if (2 * circuit_.latches[k].node != circuit_.broken) set(all, k);
    rows_.assign(count, {.both = all, .without = all});
    for (std::size_t k = 0; k < count; ++k) {
        if (!bit(all, k)) rows_[k] = {.both = Bits(all.size(), 0), .without = Bits(all.size(), 0), .never = false};
        reset(rows_[k].both, k);
        reset(rows_[k].without, k);
    }
}

/// Creates the rows with the pairs of `candidates_`.
void LatchPairs::select_candidates() {
    const std::size_t count = circuit_.latches.size();
    const Bits none(count / word_bits + 1, 0);
    rows_.assign(count, {.both = none, .without = none, .never = false});
    std::map<std::string_view, std::size_t> index;
    for (std::size_t k = 0; k < count; ++k) index.emplace(circuit_.latches[k].name, k);
    for (const NamedCube& cube : *candidates_) {
        std::vector<std::size_t> active, inactive;
        for (const auto& [latch, value] : cube)
            if (const auto found = index.find(latch); found != index.end())
                (value ? active : inactive).push_back(found->second);
        if (active.size() + inactive.size() != cube.size()) continue;  // a latch of the cube is missing
        Row& row = rows_[active[0]];
        if (cube.size() == 1) {
            row.never = true;
        } else if (inactive.empty()) {
            set(row.both, active[1]);
            set(rows_[active[1]].both, active[0]);
        } else {
            set(row.without, inactive[0]);
        }
    }
}

/// Creates a new solver for the candidates. A new solver is also necessary after an exception, which leaves the old
/// solver in an unknown state.
void LatchPairs::begin() {
    const std::size_t count = circuit_.latches.size();
    const bool selected = candidates_ != nullptr && !candidates_->empty();
    if (rows_.empty() && selected) select_candidates();
    else if (rows_.empty()) set_candidates();
    solver_.emplace(circuit_, watch_);
    now_.clear();
    next_.clear();
    for (const Circuit::Latch& latch : circuit_.latches) {
        now_.push_back(solver_->of(2 * latch.node));
        next_.push_back(solver_->of(latch.next));
        if (2 * latch.node == circuit_.broken) {
            solver_->add(std::array{-now_.back()});
            solver_->add(std::array{-next_.back()});
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        rows_[k].violation = solver_->fresh();
        solver_->add(std::array{-rows_[k].violation, next_[k]});
        require_violation(k);
        assume(k);
    }
}

/// Adds clauses for the candidates of a row: if the premise of the row, a new variable, is true, the current state
/// satisfies no candidate of the row.
void LatchPairs::assume(std::size_t latch) {
    Row& row = rows_[latch];
    row.premise = solver_->fresh();
    if (row.never) return solver_->add(std::array{-row.premise, -now_[latch]});
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        if (bit(row.both, k)) solver_->add(std::array{-row.premise, -now_[latch], -now_[k]});
        if (bit(row.without, k)) solver_->add(std::array{-row.premise, -now_[latch], now_[k]});
    }
}

/// Adds a clause: if the violation of the row is true, the next state satisfies a candidate of the row. Earlier clauses
/// of the row, for more candidates, remain in the solver; the new clause implies them.
void LatchPairs::require_violation(std::size_t latch) {
    const Row& row = rows_[latch];
    if (row.never) return;
    std::vector<int> clause{-row.violation};
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        if (bit(row.both, k)) clause.push_back(next_[k]);
        if (bit(row.without, k)) clause.push_back(-next_[k]);
    }
    solver_->add(clause);
}

/// Drops the candidates that the state satisfies.
void LatchPairs::drop(const std::vector<bool>& state) {
    Bits values(rows_.size() / word_bits + 1, 0);
    for (std::size_t k = 0; k < state.size(); ++k)
        if (state[k]) set(values, k);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        if (!state[k]) continue;
        Row& row = rows_[k];
        bool changes = std::exchange(row.never, false);
        for (std::size_t w = 0; w < values.size(); ++w) {
            changes = changes || (row.both[w] & values[w]) != 0 || (row.without[w] & ~values[w]) != 0;
            row.both[w] &= ~values[w];
            row.without[w] &= values[w];
        }
        if (!changes) continue;
        require_violation(k);
        assume(k);
    }
}

/// Searches for a step from a state that satisfies no candidate to a state that satisfies some candidates, and drops
/// these candidates. Returns false if no such step exists.
bool LatchPairs::refute() {
    std::vector<int> premises, violations;
    for (const Row& row : rows_) {
        premises.push_back(row.premise);
        violations.push_back(row.violation);
    }
    if (!solver_->solve(premises, violations)) return false;
    std::vector<bool> state;
    for (const Circuit::Latch& latch : circuit_.latches) state.push_back(solver_->value(latch.next));
    drop(state);
    return true;
}

const std::vector<Cube>& LatchPairs::cubes() {
    if (cubes_) return *cubes_;
    if (circuit_.latches.empty() || circuit_.latches.size() > most_latches) return cubes_.emplace();
    begin();
    // Clauses of dropped candidates slow the solver down. A new solver replaces a solver with too many clauses.
    for (std::uint64_t useful = solver_->clauses(); refute();)
        if (solver_->clauses() > 2 * useful) {
            begin();
            useful = solver_->clauses();
        }
    solver_.reset();
    std::vector<Cube> made;
    const auto add = [&](Cube cube) {
        if (circuit_.broken != Gates::no) cube.push_back(circuit_.broken ^ 1U);
        std::ranges::sort(cube);
        made.push_back(std::move(cube));
    };
    const auto literal = [&](std::size_t k) { return 2 * circuit_.latches[k].node; };
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        if (rows_[k].never) add({literal(k)});
        for (std::size_t other = 0; other < rows_.size() && !rows_[k].never; ++other) {
            if (rows_[other].never) continue;
            if (other > k && bit(rows_[k].both, other)) add({literal(k), literal(other)});
            if (bit(rows_[k].without, other)) add({literal(k), literal(other) ^ 1U});
        }
    }
    return cubes_.emplace(std::move(made));
}

std::vector<NamedCube> LatchPairs::named_cubes() {
    std::vector<std::string_view> names(circuit_.gates.size());
    for (const Circuit::Latch& latch : circuit_.latches) names[latch.node] = latch.name;
    std::vector<NamedCube> made;
    for (const Cube& cube : cubes()) {
        NamedCube& named = made.emplace_back();
        for (const Literal literal : cube)
            if (node_of(literal) != node_of(circuit_.broken))
                named.push_back({std::string(names[node_of(literal)]), !is_inverted(literal)});
    }
    return made;
}

}  // namespace grafverif::pdr
