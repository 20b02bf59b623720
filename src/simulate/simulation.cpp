// SPDX-License-Identifier: MIT
#include "simulate/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulate/called.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

std::string Simulation::begin() {
    return std::visit([](auto& of) { return of.settle(); }, of_);
}

/// Executes a command. A command may consist of several moves, because the simulation advances time stepwise until an
/// expectation holds. Only commands with moves can be undone.
std::string Simulation::execute(const Command& command) {
    unmet_ = false;
    if (std::holds_alternative<BackCommand>(command)) return undo();
    const std::size_t before = moves(), moments = recorded_run().moments.size(), examined = examined_;
    std::string problem = made(command);
    if (moves() > before) commands_.push_back({before, examined});
    const bool examines = std::holds_alternative<ExpectCommand>(command) && problem.empty();
    if (!examines) examined_ = moves() > before ? moments - 1 : examined;
    if (!problem.empty() && moves() > before && recorded_run().moments.size() == moments) undo();
    return problem;
}

std::size_t Simulation::moves() const {
    return std::visit([](const auto& of) { return of.commands(); }, of_);
}

std::string Simulation::undo() {
    if (commands_.empty()) return "there is no command to undo";
    while (moves() > commands_.back().moves && std::visit([](auto& of) { return of.back(); }, of_)) {
    }
    examined_ = commands_.back().examined;
    commands_.pop_back();
    return {};
}

std::string Simulation::made(const Command& command) {
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
                                  [&](const ExpectCommand& wanted) { return expect(wanted); },
                                  [](const BadCommand& bad) { return bad.error_text; },
                                  [](const auto&) { return std::string(); },
                              },
                              command);
        },
        of_);
}

std::optional<std::string> Simulation::unmet_at(const Expectation& claim, std::size_t moment,
                                                std::string& problem) const {
    const auto location_of = [&](std::string_view instance) {
        const auto* const loop = std::get_if<LoopSimulation>(&of_);
        return loop == nullptr ? std::nullopt : loop->location_of(instance, moment);
    };
    return unmet_part(claim, recorded_run(), moment, location_of, problem);
}

/// True if the expectation became true during the instant. An instant can contain several evolutions. Therefore the
/// situation after the instant does not show a step that was activated and deactivated during the instant. The
/// expectation must become true at an event; an expectation that was already true before the first examined event does
/// not count.
bool Simulation::met_in_passing(const Expectation& claim) {
    const ChartRun& run = recorded_run();
    const std::int64_t now = run.moments.back().after.time_ms;
    std::vector<bool> examines(run.moments.size(), names_only_steps(claim, run));
    for (auto row = run.rows.rbegin(); row != run.rows.rend() && row->moment > examined_; ++row)
        examines[row->moment] = true;
    std::string ignored;
    const auto is_met = [&](std::size_t moment) {
        const auto unmet = unmet_at(claim, moment, ignored);
        return unmet && unmet->empty();
    };
    bool was_met = is_met(examined_);
    for (std::size_t moment = examined_ + 1; moment < run.moments.size(); ++moment) {
        if (!examines[moment]) continue;
        const bool becomes_met = !was_met && is_met(moment) && run.moments[moment].after.time_ms == now;
        if (becomes_met) return examined_ = moment, true;
        was_met = is_met(moment);
    }
    examined_ = run.moments.size() - 1;
    return false;
}

/// Checks an expectation. Time advances from one spontaneous event to the next, because values do not change between
/// these events.
std::string Simulation::expect(const ExpectCommand& wanted) {
    Expectation claim = wanted.claim;
    for (Expectation::Condition& part :
         claim.parts) {  // replaces a port by its variable, unless a signal or location has this name
        const auto* const loop = std::get_if<LoopSimulation>(&of_);
        const bool known = !signals_called(recorded_run(), part.name).empty() ||
                           location_called(recorded_run(), part.name).instance.valid();
        const std::string variable = loop == nullptr || known ? std::string() : loop->port_variable(part.name);
        if (!variable.empty()) part.name = variable;
    }
    const std::int64_t begin = recorded_run().moments.back().after.time_ms;
    for (;;) {
        std::string problem;
        const auto unmet = unmet_at(claim, recorded_run().moments.size() - 1, problem);
        if (!unmet) return problem;
        if (unmet->empty() && wanted.response_timeout_ms != 0) examined_ = recorded_run().moments.size() - 1;
        if (unmet->empty() || (wanted.response_timeout_ms != 0 && met_in_passing(claim))) return {};
        const auto failed = [&](std::string_view why) {
            unmet_ = true;
            return fmt::format("expected `{}`, but {}{}", wanted.claim.text, *unmet, why);
        };
        const std::int64_t passed = recorded_run().moments.back().after.time_ms - begin;
        if (wanted.response_timeout_ms && passed >= *wanted.response_timeout_ms)
            return failed(passed == 0 ? "" : fmt::format(" after {}", seconds_text(passed)));
        if (!delay_bounds().may_pass) return failed(", and time cannot pass before a choice");
        const auto soonest = std::visit([](const auto& of) { return of.soonest_ms(); }, of_);
        if (!wanted.response_timeout_ms && !soonest) return failed(", and nothing changes as time passes");
        const std::int64_t left = wanted.response_timeout_ms ? *wanted.response_timeout_ms - passed : *soonest;
        problem = std::visit([&](auto& of) { return of.wait(std::min(left, soonest.value_or(left))); }, of_);
        if (!problem.empty()) return problem;
    }
}

std::string Simulation::choose(std::size_t number) {
    const std::size_t count = choice_count();
    if (count == 0) return "no choice is available; let time pass with `wait`";
    if (number > count) return fmt::format("no choice has this number; enter a number from 1 to {}", count);
    return std::visit([&](auto& of) { return of.choose(number - 1); }, of_);
}

const ChartRun& Simulation::recorded_run() const {
    return std::visit([](const auto& of) -> const ChartRun& { return of.recorded_run(); }, of_);
}

std::optional<std::size_t> Simulation::what_if_row() const {
    return std::visit([](const auto& of) { return of.what_if_row(); }, of_);
}

std::vector<Choice> Simulation::choices() const {
    return std::visit([](const auto& of) { return of.choices(); }, of_);
}

std::size_t Simulation::choice_count() const {
    return std::visit([](const auto& of) { return of.choice_count(); }, of_);
}

DelayBounds Simulation::delay_bounds() const {
    return std::visit([](const auto& of) { return of.delay_bounds(); }, of_);
}

std::vector<std::string> Simulation::violated_constraints() const {
    const auto* const chart = std::get_if<ChartSimulation>(&of_);
    return chart == nullptr ? std::vector<std::string>{} : chart->violated_constraints();
}

ChartRun Simulation::with_trace_rows(Detail detail) const {
    return std::visit([&](const auto& of) { return of.with_trace_rows(detail); }, of_);
}

std::optional<Command> RandomWalk::draw(const Simulation& simulation) {
    const std::size_t choices = simulation.choice_count();
    const DelayBounds delay_bounds = simulation.delay_bounds();
    const std::uint64_t count = choices + (delay_bounds.may_pass ? 1 : 0);
    if (count == 0) return {};
    const std::uint64_t drawn = random_() % count;
    if (drawn < choices) return ChooseCommand{drawn + 1};
    constexpr std::int64_t longest = 20;
    const std::int64_t most = std::min(delay_bounds.limit.value_or(longest), delay_bounds.change.value_or(longest));
    const std::int64_t units =
        1 + static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(std::max<std::int64_t>(most, 1)));
    return WaitCommand{units * delay_bounds.unit_ms};
}

}  // namespace grafverif
