// SPDX-License-Identifier: MIT
#include "check/pdr/equal_latches.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <utility>

namespace grafverif::pdr {

namespace {

constexpr std::size_t runs = 8, states_of_a_run = 64;

}  // namespace

EqualLatches::EqualLatches(const Circuit& circuit, LimitMonitor& watch)
    : circuit_(circuit), watch_(watch), class_of_(circuit.latches.size()) {}

/// Splits each class of latches by the values of its latches. Only latches with the value false stay in class 0.
template <class Value>
void EqualLatches::split(const Value& value) {
    std::map<std::pair<std::size_t, bool>, std::size_t> classes{{{0, false}, 0}};
    for (std::size_t k = 0; k < class_of_.size(); ++k)
        class_of_[k] = classes.try_emplace({class_of_[k], value(k)}, classes.size()).first->second;
}

void EqualLatches::split_by_runs() {
    std::mt19937 random(1);  // NOLINT(cert-msc51-cpp): the runs must be reproducible
    for (std::size_t run = 0; run < runs; ++run) {
        std::vector<std::vector<bool>> inputs(states_of_a_run);
        for (std::vector<bool>& each : inputs)
            for (std::size_t k = 0; k < circuit_.inputs.size(); ++k) each.push_back((random() & 1U) != 0);
        run_through(circuit_, inputs, [&](const NodeValues& values) {
            watch_.look();
            split([&](std::size_t k) { return values[circuit_.latches[k].node]; });
        });
    }
}

/// Searches for a step from a state in which the latches of each class are equal to a state in which two latches of a
/// class differ. Splits the classes by the values in the second state. Returns false if there is no such step.
bool EqualLatches::split_by_solver() {
    if (!solver_) solver_.emplace(circuit_, watch_);
    Solver& solver = *solver_;
    const int equal = solver.fresh();
    std::vector<int> differ;
    std::map<std::size_t, std::size_t> first;  // maps each class to its representative latch
    for (std::size_t k = 0; k < class_of_.size(); ++k) {
        const Circuit::Latch& latch = circuit_.latches[k];
        Circuit::Latch other;  // class 0 has the representative constant false
        if (class_of_[k] != 0) {
            const auto [place, fresh] = first.try_emplace(class_of_[k], k);
            if (fresh) continue;
            other = circuit_.latches[place->second];
        }
        const int now = solver.of(2 * latch.node), other_now = solver.of(2 * other.node);
        solver.add(std::array{-equal, -now, other_now});
        solver.add(std::array{-equal, now, -other_now});
        if (latch.next == other.next) continue;
        const int next = solver.of(latch.next), other_next = solver.of(other.next);
        const int differs = differ.emplace_back(solver.fresh());
        solver.add(std::array{-differs, next, other_next});
        solver.add(std::array{-differs, -next, -other_next});
    }
    for (const Circuit::Latch& latch : circuit_.latches) solver.of(latch.next);
    const bool found = !differ.empty() && solver.solve(std::array{equal}, differ);
    if (found) split([&](std::size_t k) { return solver.value(circuit_.latches[k].next); });
    solver.add(std::array{-equal});
    return found;
}

const std::vector<Cube>& EqualLatches::cubes() {
    if (cubes_) return *cubes_;
    if (!std::exchange(split_by_runs_, true)) split_by_runs();
    while (split_by_solver()) {
    }
    solver_.reset();
    std::vector<Cube> made;
    std::map<std::size_t, Literal> first;
    for (std::size_t k = 0; k < class_of_.size(); ++k) {
        const Literal here = 2 * circuit_.latches[k].node;
        if (class_of_[k] == 0) {
            made.push_back({here});
            continue;
        }
        const auto [place, fresh] = first.try_emplace(class_of_[k], here);
        if (fresh) continue;
        for (const Literal value : {Literal{0}, Literal{1}}) {
            Cube& cube = made.emplace_back(Cube{place->second ^ value, here ^ value ^ 1U});
            std::ranges::sort(cube);
        }
    }
    return cubes_.emplace(std::move(made));
}

}  // namespace grafverif::pdr
