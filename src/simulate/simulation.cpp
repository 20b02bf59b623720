// SPDX-License-Identifier: MIT
#include "simulate/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/overloaded.hpp"

namespace grafverif {

std::string Simulation::begin() {
    return std::visit([](auto& of) { return of.settle(); }, of_);
}

std::string Simulation::obey(const Command& command) {
    return std::visit(
        [&](auto& of) {
            return std::visit(overloaded{
                                  [&](const SetCommand& set) { return of.set(set.settings); },
                                  [&](const WaitCommand& wait) {
                                      return wait.milliseconds ? of.wait(*wait.milliseconds) : of.wait();
                                  },
                                  [&](const DoCommand& act) { return of.act(act.instance, act.location); },
                                  [&](const ForceCommand& force) { return of.force(force.step, force.active); },
                                  [&](const ChooseCommand& choice) { return choose(choice.number); },
                                  [&](BackCommand) { return std::string(of.back() ? "" : "there is nothing to undo"); },
                                  [](const BadCommand& bad) { return bad.complaint; },
                                  [](const auto&) { return std::string(); },
                              },
                              command);
        },
        of_);
}

std::string Simulation::choose(std::size_t number) {
    const std::size_t count = choice_count();
    if (count == 0) return "there is no choice now; let time pass with `wait`";
    if (number > count) return fmt::format("there are {} choices", count);
    return std::visit([&](auto& of) { return of.choose(number - 1); }, of_);
}

const ChartRun& Simulation::told() const {
    return std::visit([](const auto& of) -> const ChartRun& { return of.told(); }, of_);
}

std::optional<std::size_t> Simulation::trial_row() const {
    return std::visit([](const auto& of) { return of.trial_row(); }, of_);
}

std::vector<Choice> Simulation::choices() const {
    return std::visit([](const auto& of) { return of.choices(); }, of_);
}

std::size_t Simulation::choice_count() const {
    return std::visit([](const auto& of) { return of.choice_count(); }, of_);
}

Patience Simulation::patience() const {
    return std::visit([](const auto& of) { return of.patience(); }, of_);
}

std::vector<std::string> Simulation::broken_constraints() const {
    const auto* const chart = std::get_if<ChartSimulation>(&of_);
    return chart == nullptr ? std::vector<std::string>{} : chart->broken_constraints();
}

ChartRun Simulation::retold(Detail detail) const {
    return std::visit([&](const auto& of) { return of.retold(detail); }, of_);
}

std::optional<Command> RandomWalk::draw(const Simulation& simulation) {
    const std::size_t choices = simulation.choice_count();
    const Patience patience = simulation.patience();
    const std::uint64_t count = choices + (patience.may_pass ? 1 : 0);
    if (count == 0) return {};
    const std::uint64_t drawn = random_() % count;
    if (drawn < choices) return ChooseCommand{drawn + 1};
    constexpr std::int64_t longest = 20;
    const std::int64_t most = std::min(patience.limit.value_or(longest), patience.change.value_or(longest));
    const std::int64_t units =
        1 + static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(std::max<std::int64_t>(most, 1)));
    return WaitCommand{units * patience.unit_ms};
}

}  // namespace grafverif
