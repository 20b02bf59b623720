// SPDX-License-Identifier: MIT
#include "simulate/loop_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ir/program/fault_text.hpp"
#include "report/report.hpp"
#include "run/interpreter.hpp"
#include "run/manual_situation.hpp"
#include "run/network_walk.hpp"
#include "run/replay.hpp"
#include "run/scanner.hpp"
#include "simulate/called.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

bool of_plant(const Network& network, const Fire& fire) {
    const Network::ProcessKind kind = network.processes[fire.process].kind;
    return kind == Network::ProcessKind::Plant || kind == Network::ProcessKind::Environment;
}

/// Returns the first of the `moves` that assigns `value` to the variable `variable`.
std::optional<Fire> move_to(const Network& network, const NetworkState& state, const std::vector<Fire>& moves,
                            std::size_t variable, std::int64_t value) {
    for (const Fire& fire : moves) {
        NetworkState after = state;
        if (perform(network, after, fire).result == Step::Result::Done && after.variables[variable] == value)
            return fire;
    }
    return {};
}

/// Records the situations of controllers within an instant.
class Course {
public:
    Course(const Network& network, const std::vector<const Chart*>& charts) : network_(network), charts_(charts) {}

    void begin(const NetworkState& state) {
        others_moved_ = false;
        situations_.assign(charts_.size(), {});
        note(state);
    }
    void add(const Fire& fire, const NetworkState& state) {
        others_moved_ = others_moved_ || of_plant(network_, fire);
        note(state);
    }
    /// Returns the error message for a sequence of moves within an instant that has returned to its first state.
    std::string endless_text() const {
        const auto moved = std::ranges::find_if(situations_, [](const auto& each) { return each.size() > 1; });
        if (others_moved_ || moved == situations_.end()) return "the moves repeat forever within one instant";
        const std::vector<std::vector<bool>> course(moved->begin() + 1, moved->end());
        return instability_text(*charts_[static_cast<std::size_t>(moved - situations_.begin())], course);
    }

private:
    void note(const NetworkState& state) {
        for (std::uint32_t k = 0; k < charts_.size(); ++k) {
            std::vector<bool> now = situation_of(network_, state, {k});
            if (situations_[k].empty() || situations_[k].back() != now) situations_[k].push_back(std::move(now));
        }
    }

    const Network& network_;
    const std::vector<const Chart*>& charts_;
    std::vector<std::vector<std::vector<bool>>> situations_ = {};  ///< situations of each controller
    bool others_moved_ = false;
};

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += fmt::format("{}`{}`", text.empty() ? "" : ", ", word);
    return text;
}

}  // namespace

LoopSimulation::LoopSimulation(const Network& network, std::vector<const Chart*> charts, Detail detail)
    : network_(network), charts_(std::move(charts)), detail_(detail) {
    power_on();
}

void LoopSimulation::power_on() {
    state_ = initial_state(network_);
    run_ = {};
    what_if_runs_ = {};
    what_if_row_ = {};
    recorded_run_ = {};
    projection_.emplace(network_, state_, recorded_run_);
    teller_.emplace(recorded_run_, detail_);
}

std::vector<Fire> LoopSimulation::fires() const {
    if (network_.race.valid() && state_.variables[network_.race.index] != 0) return {};
    std::vector<Fire> moves = enabled(network_, state_);
    if (detail_ == Detail::Chart && !broken_)
        std::erase_if(moves, [&](const Fire& fire) { return !of_plant(network_, fire); });
    return moves;
}

std::vector<Choice> LoopSimulation::choices() const {
    std::vector<Choice> list;
    const std::vector<Fire> moves = fires();
    for (std::size_t k = 0; k < moves.size(); ++k)
        list.push_back({choice_text(network_, state_, moves[k]), command_of(moves, k)});
    return list;
}

/// Returns the command for a choice: `do INSTANCE LOCATION` if this command is unambiguous, otherwise the number of the
/// choice.
std::string LoopSimulation::command_of(const std::vector<Fire>& moves, std::size_t choice) const {
    const auto target = [&](const Fire& fire) { return taken_edge(network_, fire).to; };
    const auto same = [&](const Fire& other) {
        return other.process == moves[choice].process && target(other) == target(moves[choice]);
    };
    if (std::ranges::find_if(moves, same) - moves.begin() != static_cast<std::ptrdiff_t>(choice))
        return std::to_string(choice + 1);
    const Network::Process& process = network_.processes[moves[choice].process];
    return "do " + process.name + " " + network_.templates[process.automaton].locations[target(moves[choice])].name;
}

DelayBounds LoopSimulation::delay_bounds() const {
    const Leeway delay = leeway(network_, state_);
    return {network_.time_unit_ms, delay.may_pass, delay.limit, delay.change};
}

std::string LoopSimulation::choose(std::size_t choice) { return choose(fires()[choice]); }

std::string LoopSimulation::problem_of(const Step& step, const Move& move) const {
    if (step.result == Step::Result::Blocked) return "this move is not possible now";
    const Fire& fire = std::get<Fire>(move);
    const auto kind =
        step.result == Step::Result::OutOfRange ? ModelError::Kind::OutOfRange : ModelError::Kind::NoValue;
    return error_trace_of(network_, {kind, step.variable, fire.process, fire.edge, {}}, Detail::Chart).message;
}

bool LoopSimulation::move(const Move& move, std::string& problem) {
    if (run_.moves.size() >= evolution_limit) {
        problem = fmt::format("the limit of {} moves since power-on is reached; undo the last command with `back`",
                              evolution_limit);
        return false;
    }
    const NetworkState before = state_;
    const Step step = perform(network_, state_, move);
    if (step.result != Step::Result::Done) {
        broken_ = broken_ || step.result != Step::Result::Blocked;
        problem = problem_of(step, move);
        return false;
    }
    run_.moves.push_back(move);
    projection_->append(move, before, state_);
    teller_->catch_up();
    if (!network_.race.valid() || state_.variables[network_.race.index] == 0) return true;
    broken_ = true;
    const std::optional<ContradictoryActions> found = clash(recorded_run_, charts_);
    problem = found && found->fault ? text_of(*found->fault) : race_text(found ? found->variable : "");
    return false;
}

std::optional<Fire> LoopSimulation::next_by_itself() const {
    const std::vector<Fire> moves = enabled(network_, state_);
    std::vector<std::size_t> options(network_.processes.size(), 0), urgent_options = options;
    for (const Fire& fire : moves) {
        ++options[fire.process.index];
        if (taken_edge(network_, fire).urgent) ++urgent_options[fire.process.index];
    }
    const std::vector<Id<Network::Process>> hurried = impatient(network_, state_);
    const auto first = [&](const auto& wanted) -> std::optional<Fire> {
        const auto found = std::ranges::find_if(moves, wanted);
        return found == moves.end() ? std::nullopt : std::optional(*found);
    };
    // If an instance has only one enabled urgent edge, this edge is taken automatically. Timed edges of the instance
    // are ignored here, because nothing requires that they are taken now.
    const auto alone = [&](const Fire& fire) {
        const auto& count = taken_edge(network_, fire).urgent ? urgent_options : options;
        return of_plant(network_, fire) && count[fire.process.index] == 1;
    };
    const auto of_kind = [&](Network::ProcessKind kind) {
        return first([&](const Fire& fire) { return network_.processes[fire.process].kind == kind; });
    };
    if (const auto urgent = first([&](const Fire& fire) { return alone(fire) && taken_edge(network_, fire).urgent; }))
        return urgent;
    if (const auto timer = of_kind(Network::ProcessKind::Timer)) return timer;
    if (const auto cycle = of_kind(Network::ProcessKind::Controller)) return cycle;
    return first(
        [&](const Fire& fire) { return alone(fire) && std::ranges::find(hurried, fire.process) != hurried.end(); });
}

/// Executes the spontaneous moves of the current instant. Brent's cycle detection finds infinite sequences.
std::string LoopSimulation::follow() {
    if (detail_ == Detail::Everything) return {};
    NetworkState kept = state_;
    std::size_t since_kept = 0, power = 1;
    Course course(network_, charts_);
    course.begin(state_);
    std::string problem;
    while (!broken_) {
        const std::optional<Fire> next = next_by_itself();
        if (!next) return {};
        if (!move(*next, problem)) return problem;
        course.add(*next, state_);
        broken_ = state_ == kept;
        if (broken_) return course.endless_text();
        if (++since_kept < power) continue;
        kept = state_;
        course.begin(state_);
        since_kept = 0;
        power *= 2;
    }
    return {};
}

std::string LoopSimulation::settle() {
    std::string problem = follow();
    teller_->flush();
    return problem;
}

std::string LoopSimulation::choose(const Fire& fire) {
    begin_command();
    std::string problem;
    if (!move(fire, problem)) return problem;
    return settle();
}

std::string LoopSimulation::waiting_for() const {
    const std::vector<Id<Network::Process>> hurried = impatient(network_, state_);
    std::vector<std::string> words;
    for (const Fire& fire : fires())
        if (std::ranges::find(hurried, fire.process) != hurried.end())
            words.push_back(choice_text(network_, state_, fire));
    if (words.empty()) return "timelock: time cannot pass, and no required move is possible";
    return "time cannot pass before one of these moves: " + listed(words);
}

std::string LoopSimulation::pass(std::int64_t units) {
    while (units > 0) {
        if (std::string problem = follow(); !problem.empty()) return problem;
        const Leeway delay = leeway(network_, state_);
        if (!delay.may_pass) return waiting_for();
        const std::int64_t step = std::min(units, delay.limit.value_or(units));
        std::string problem;
        if (!move(Delay{step}, problem)) return problem;
        units -= step;
    }
    return follow();
}

std::string LoopSimulation::wait(std::int64_t milliseconds) {
    const std::int64_t unit = network_.time_unit_ms;
    if (milliseconds % unit != 0)
        return fmt::format("the duration is not a multiple of the time unit {}; wait for a multiple of it",
                           seconds_text(unit));
    begin_command();
    std::string problem = pass(milliseconds / unit);
    teller_->flush();
    return problem;
}

std::string LoopSimulation::wait() {
    const Leeway delay = leeway(network_, state_);
    if (!delay.may_pass) return waiting_for();
    const std::int64_t units = std::min(delay.limit.value_or(0), delay.change.value_or(0));
    const std::int64_t soonest = units > 0 ? units : std::max(delay.limit.value_or(0), delay.change.value_or(0));
    if (soonest == 0) return "nothing changes as time passes; write `wait` with a duration";
    return wait(soonest * network_.time_unit_ms);
}

std::string LoopSimulation::set(const std::vector<Setting>& settings) {
    if (settings.size() > 1) return "several inputs cannot be set together in a closed loop; set one input at a time";
    const auto& [written, value] = settings.front();
    const std::string mapped = port_variable(written), name = mapped.empty() ? written : mapped;
    const auto settable = [](const Network::Variable& variable) {
        return (variable.role == Network::Role::Input || variable.role == Network::Role::Plant) && !variable.scratch;
    };
    const auto found = std::ranges::find_if(network_.variables, [&, wanted = name](const Network::Variable& variable) {
        return settable(variable) && (variable.name == wanted || variable.display_name() == wanted);
    });
    if (found == network_.variables.end()) {
        std::vector<std::string> known;
        for (const Network::Variable& variable : network_.variables)
            if (settable(variable)) known.push_back(variable.display_name());
        return unknown_name_text("input", name, known);
    }
    if (std::string problem = range_text(name, found->type, value); !problem.empty()) return problem;
    const auto index = static_cast<std::size_t>(found - network_.variables.begin());
    const std::string value_text = !found->type.boolean ? std::to_string(value) : value != 0 ? "true" : "false";
    if (state_.variables[index] == value) return fmt::format("`{}` is already {}", name, value_text);
    if (const auto fire = move_to(network_, state_, fires(), index, value)) return choose(*fire);
    const std::string problem = fmt::format("no move can set `{}` to {} now", name, value_text);
    const Leeway delay = leeway(network_, state_);
    NetworkState later = state_;
    const bool changes = delay.change && perform(network_, later, Delay{*delay.change}).result == Step::Result::Done;
    if (!changes || !move_to(network_, later, enabled(network_, later), index, value)) return problem;
    return fmt::format("{}; let {} pass", problem, seconds_text(*delay.change * network_.time_unit_ms));
}

std::string LoopSimulation::act(std::string_view instance, std::string_view location) {
    for (const Fire& fire : fires()) {
        const Network::Process& process = network_.processes[fire.process];
        const Network::Location& target =
            network_.templates[process.automaton].locations[taken_edge(network_, fire).to];
        if (process.name == instance && (location.empty() || target.name == location)) return choose(fire);
    }
    const auto named = std::ranges::find(recorded_run_.instances, instance, &ChartRun::Instance::name);
    const std::vector<std::string> known = instances_of(recorded_run_);
    if (named == recorded_run_.instances.end() && detail_ == Detail::Chart)
        return unknown_name_text("instance", instance, known);
    if (named != recorded_run_.instances.end() && !location.empty() &&
        std::ranges::find(named->locations, location) == named->locations.end())
        return unknown_name_text(fmt::format("`{}` location", instance), location, named->locations);
    return fmt::format("`{}` cannot move{} now", instance, location.empty() ? "" : fmt::format(" to `{}`", location));
}

std::optional<std::int64_t> LoopSimulation::soonest_ms() const {
    const Leeway delay = leeway(network_, state_);
    if (!delay.limit && !delay.change) return {};
    const std::int64_t soonest = delay.limit && delay.change ? std::min(*delay.limit, *delay.change)
                                                             : delay.limit.value_or(delay.change.value_or(0));
    return soonest * network_.time_unit_ms;
}

std::optional<std::string> LoopSimulation::location_of(std::string_view instance, std::size_t moment) const {
    const auto process = std::ranges::find(network_.processes, instance, &Network::Process::name);
    if (process == network_.processes.end()) return {};
    const Network::Template& automaton = network_.templates[process->automaton];
    if (moment + 1 == recorded_run_.moments.size()) {
        const auto index = static_cast<std::size_t>(process - network_.processes.begin());
        return automaton.locations[state_.locations[index]].name;
    }
    for (std::size_t k = moment + 1; k > 0; --k) {
        const ChartRun::Event& event = recorded_run_.moments[k - 1];
        if (event.location && event.instance.valid() && recorded_run_.instances[event.instance].name == instance)
            return recorded_run_.instances[event.instance].locations[*event.location];
    }
    return automaton.locations[process->initial].name;
}

std::string LoopSimulation::port_variable(std::string_view name) const {
    const std::size_t dot = std::min(name.find('.'), name.size());
    for (const Network::Process& process : network_.processes) {
        if (process.name != name.substr(0, dot) || dot == name.size()) continue;
        const Network::Template& automaton = network_.templates[process.automaton];
        for (const Id<Network::Parameter> id : automaton.parameters.ids()) {
            const auto* const bound = std::get_if<Id<Network::Variable>>(&process.arguments[id.index]);
            if (bound != nullptr && automaton.parameters[id].name == name.substr(dot + 1))
                return network_.variables[*bound].display_name();
        }
    }
    return {};
}

bool LoopSimulation::back() {
    if (commands_.empty()) return false;
    Run shorter = std::move(run_);
    std::vector<Forced> what_if_runs = std::move(what_if_runs_);
    shorter.moves.resize(commands_.back().moves);
    what_if_runs.resize(commands_.back().what_if_runs);
    commands_.pop_back();
    power_on();
    broken_ = false;
    std::string ignored;
    auto command = commands_.begin();
    auto forced = what_if_runs.begin();
    for (std::size_t i = 0; i <= shorter.moves.size(); ++i) {
        for (; command != commands_.end() && command->moves == i; ++command) teller_->flush();
        for (; forced != what_if_runs.end() && forced->at == i; ++forced) put(forced->trial);
        if (i < shorter.moves.size()) move(shorter.moves[i], ignored);
    }
    teller_->flush();
    return true;
}

std::string LoopSimulation::force(std::string_view step, bool active) {
    if (broken_) return "no further event is possible; undo the last command with `back`";
    std::string problem;
    const std::optional<WhatIfRun> trial = what_if_of(recorded_run_, step, active, problem);
    if (!trial) return problem;
    if (charts_[trial->controller.index]->program)
        return "a step of a PLC program cannot be forced; set an input, or take an edge of an instance with `do`";
    const Network::Controller& controller = network_.controllers[{trial->controller.index}];
    if (state_.locations[controller.process.index] != controller.waiting)
        return "a step cannot be forced during a PLC cycle; force it between two cycles";
    if (ManualSituation made = forced(*trial); !made.refusal.empty()) return std::move(made.refusal);
    begin_command();
    put(*trial);
    return settle();
}

ManualSituation LoopSimulation::forced(const WhatIfRun& trial) const {
    const std::uint32_t controller = trial.controller.index;
    return by_hand(*charts_[controller], situation_of(network_, state_, {controller}),
                   {static_cast<std::uint32_t>(trial.step)}, trial.active);
}

/// Executes a change of a step's activity that the user has forced. Requires that by_hand accepts the change.
void LoopSimulation::put(const WhatIfRun& trial) {
    put_situation(network_, state_, {trial.controller.index}, forced(trial).situation);
    what_if_runs_.push_back({run_.moves.size(), trial});
    projection_->append_by_hand(state_);
    const std::size_t row = report_what_if(recorded_run_, *teller_, trial);
    what_if_row_ = what_if_row_.value_or(row);
}

}  // namespace grafverif
