// SPDX-License-Identifier: MIT
#include "check/inputs/inputs.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "check/cells/cells.hpp"
#include "check/inputs/follow.hpp"
#include "check/timed/questions.hpp"
#include "ir/patterns.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

using Levels = std::vector<InputLevel>;

/// Properties to decide on one abstraction: indices of verdicts.
struct Task {
    Levels levels = {};
    std::vector<std::size_t> verdicts = {};
    std::size_t rounds = 0;
};

class ByInputs {
public:
    ByInputs(const Network& loop, const Observe& observe, const TimedOptions& options, TimedResult& result,
             const InputLimits& limits, const InputAblations& ablations)
        : loop_(loop),
          observe_(observe),
          options_(options),
          result_(result),
          limits_(limits),
          ablations_(ablations),
          instances_(autonomous_instances(loop)),
          observed_(expand(observe(loop))),
          complete_(in_longest_unit(observed_)),
          writers_(observed_.variables.size()) {}

    void run() {
        // Otherwise a property that holds in an abstraction may be vacuous in the loop.
        if (instances_.empty() || !result_.errors.empty() || !result_.time_passes) return;
        collect();
        while (!tasks_.empty() && !stopped()) {
            const Task task = std::move(tasks_.front());
            tasks_.pop_front();
            search(task);
        }
    }

private:
    bool stopped() const {
        if (options_.stop && options_.stop->load(std::memory_order_relaxed)) return true;
        return options_.deadline && std::chrono::steady_clock::now() >= *options_.deadline;
    }

    void collect();
    Levels first_levels(const Property& property) const;
    void search(const Task& task);
    void conclude(std::size_t verdict, const Verdict& found, const Task& task);
    std::optional<Run> real_run(std::size_t verdict, const AbstractRun& abstract, Levels& raised);
    InputsAbstracted abstracted(const Levels& levels) const;
    Property single(std::size_t verdict) const;

    const Network& loop_;
    const Observe& observe_;
    const TimedOptions& options_;
    TimedResult& result_;
    const InputLimits& limits_;
    const InputAblations& ablations_;
    const std::vector<AutonomousInstance> instances_;
    const Network observed_;
    const Network complete_;                        // in its longest time unit
    std::vector<std::set<std::uint32_t>> writers_;  // processes, per variable of observed_
    std::deque<Task> tasks_ = {};
};

void ByInputs::collect() {
    for (const Id<Network::Process> id : observed_.processes.ids())
        for (const Id<Network::Variable> variable : Slots(observed_, id).written())
            writers_[variable.index].insert(id.index);
    std::map<Levels, std::vector<std::size_t>> groups;
    const auto probe = std::ranges::find(result_.verdicts, settled_probe, &Verdict::property);
    const bool ever_settled = probe == result_.verdicts.end() || probe->outcome == Outcome::Holds;
    for (std::size_t k = 0; k < result_.verdicts.size(); ++k) {
        const Verdict& verdict = result_.verdicts[k];
        if (verdict.obstacle != Obstacle::Bound || !verdict.about.valid()) continue;
        const Property& property = observed_.properties[verdict.about];
        if (!is_about_single_states(property.pattern) && property.pattern != Pattern::ReachableAllSteps) continue;
        if (property.at_stable && !ever_settled) continue;
        groups[first_levels(property)].push_back(k);
    }
    for (auto& [levels, verdicts] : groups) tasks_.push_back({levels, std::move(verdicts)});
}

/// `property` is one of observe(loop): it also reads the variables and processes that its observer reads.
Levels ByInputs::first_levels(const Property& property) const {
    std::set<std::uint32_t> variables, processes;
    const auto read = [&](Id<Expr> term) {
        for (const Id<Expr> leaf : leaves(observed_.exprs, term)) {
            const Expr& node = observed_.exprs[leaf];
            if (node.op == Op::Variable) variables.insert(static_cast<std::uint32_t>(node.value));
            if (node.op == Op::At) processes.insert(at_process(node));
        }
    };
    for (const Id<Expr> operand : property.operands) read(operand);
    for (const Network::Process& process : observed_.processes) {
        if (process.kind != Network::ProcessKind::Observer) continue;
        const Network::Template& automaton = observed_.templates[process.automaton];
        for (const Network::Edge& edge : automaton.edges) {
            read(edge.guard);
            for (const Network::Assignment& assignment : edge.assignments) read(assignment.value);
        }
    }
    // Observers read the location of a process in a variable that only this process writes; all processes write that an
    // event has occurred.
    for (const std::uint32_t variable : variables) {
        if (variable < loop_.variables.size()) continue;
        const std::set<std::uint32_t>& writers = writers_[variable];
        if (writers.size() == 1) processes.insert(*writers.begin());
    }
    Levels levels;
    std::size_t splits = 0;
    for (const AutonomousInstance& instance : instances_) {
        bool is_read = (instance.is_read && !ablations_.ignore_readers) || processes.contains(instance.process.index);
        for (const Id<Network::Variable> output : instance.outputs)
            is_read = is_read || variables.contains(output.index);
        const std::size_t more = (instance.valuations.size() - 1) * std::max<std::size_t>(loop_.controllers.size(), 1);
        if (!is_read && splits + more <= timed::Choices::most_splits) {
            splits += more;
            levels.push_back(InputLevel::Chosen);
        } else {
            levels.push_back(InputLevel::Untimed);
        }
    }
    return levels;
}

void ByInputs::search(const Task& task) {
    InputAbstraction abstraction = abstract_inputs(loop_, instances_, task.levels, ablations_);
    const Network network = in_longest_unit(expand(observe_(abstraction.network)), abstraction.paced);
    TimedOptions options = options_;
    options.properties.clear();
    for (const std::size_t k : task.verdicts) {
        const std::string& name = observed_.properties[result_.verdicts[k].about].name;
        if (std::ranges::find(options.properties, name) == options.properties.end()) options.properties.push_back(name);
    }
    options.timelock = false;
    options.profile = false;
    options.many = {};
    options.choices = abstraction.choices;
    options.paths = true;
    options.until_decided = true;
    options.max_states = std::min(options_.max_states, limits_.states);
    const TimedResult found = check_timed(network, options);
    result_.states += found.states;
    result_.transitions += found.transitions;
    result_.bytes = std::max(result_.bytes, found.bytes);
    result_.seconds += found.seconds;
    std::map<Levels, std::vector<std::size_t>> raised;
    for (const std::size_t k : task.verdicts) {
        const auto at = std::ranges::find(found.verdicts, result_.verdicts[k].property, &Verdict::property);
        if (at == found.verdicts.end()) continue;
        const std::vector<AbstractState>& path = found.paths[static_cast<std::size_t>(at - found.verdicts.begin())];
        if (!path.empty()) {
            Levels levels = task.levels;
            const AbstractRun abstract{network, instances_, task.levels, abstraction.choices, path};
            if (std::optional<Run> run = real_run(k, abstract, levels)) {
                Verdict verdict = *at;
                verdict.run = std::move(run);
                conclude(k, verdict, task);
            } else if (levels != task.levels && task.rounds + 1 < limits_.rounds) {
                raised[levels].push_back(k);
            }
        } else if (found.complete && at->outcome != Outcome::Unknown) {
            Verdict verdict = *at;
            verdict.run.reset();
            conclude(k, verdict, task);
        }
    }
    for (auto& [levels, verdicts] : raised) tasks_.push_back({levels, std::move(verdicts), task.rounds + 1});
}

void ByInputs::conclude(std::size_t k, const Verdict& found, const Task& task) {
    Verdict& verdict = result_.verdicts[k];
    verdict.outcome = found.outcome;
    verdict.obstacle = Obstacle::None;
    verdict.reason.clear();
    verdict.vacuous = found.vacuous;
    verdict.notes.insert(verdict.notes.end(), found.notes.begin(), found.notes.end());
    verdict.run = found.run;
    verdict.states = found.states;
    verdict.transitions = found.transitions;
    verdict.abstraction = abstracted(task.levels);
}

/// The property of one verdict; for `reachable all steps` the step.
Property ByInputs::single(std::size_t k) const {
    Property property = complete_.properties[result_.verdicts[k].about];
    if (property.pattern != Pattern::ReachableAllSteps) return property;
    std::size_t first = k;
    while (first > 0 && result_.verdicts[first - 1].about == result_.verdicts[k].about) --first;
    property.operands = {property.operands[k - first]};
    return property;
}

/// If there is no real run, `raised` are the levels to try next.
std::optional<Run> ByInputs::real_run(std::size_t k, const AbstractRun& abstract, Levels& raised) {
    FollowLimits limits{.states = limits_.followed, .deadline = options_.deadline, .stop = options_.stop};
    Followed followed = follow(complete_, single(k), abstract, limits);
    if (followed.run) {
        for (Move& move : followed.run->moves)
            if (Delay* const delay = std::get_if<Delay>(&move))
                delay->units *= complete_.time_unit_ms / observed_.time_unit_ms;
        return std::move(followed.run);
    }
    // One instance at a time, since few are usually needed: one that the property reads, or the first in the run.
    for (const bool waits : {true, false}) {
        std::optional<Impossible> best;
        std::size_t instance = 0;
        const auto rank = [&](std::size_t i, const Impossible& found) {
            return std::pair(abstract.levels[i] == InputLevel::Chosen, found.at);
        };
        for (std::size_t i = 0; i < instances_.size(); ++i) {
            const std::optional<Impossible> found = impossible(complete_, abstract, i, waits);
            if (!found || (best && rank(i, *found) >= rank(instance, *best))) continue;
            best = found;
            instance = i;
        }
        if (!best) continue;
        raised[instance] = best->level;
        return {};
    }
    for (const std::size_t i : followed.blamed)
        if (raised[i] != InputLevel::Complete) raised[i] = static_cast<InputLevel>(static_cast<int>(raised[i]) + 1);
    return {};
}

InputsAbstracted ByInputs::abstracted(const Levels& levels) const {
    InputsAbstracted made;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::string& name = loop_.processes[instances_[i].process].name;
        if (levels[i] == InputLevel::Chosen) made.chosen.push_back(name);
        if (levels[i] == InputLevel::Untimed) made.untimed.push_back(name);
        if (levels[i] == InputLevel::Paced) made.paced.push_back(name);
    }
    return made;
}

}  // namespace

void decide_by_inputs(const Network& loop, const Observe& observe, const TimedOptions& options, TimedResult& result,
                      const InputLimits& limits, const InputAblations& ablations) {
    const auto is_open = [](const Verdict& verdict) { return verdict.obstacle == Obstacle::Bound; };
    if (std::ranges::none_of(result.verdicts, is_open)) return;
    ByInputs(loop, observe, options, result, limits, ablations).run();
}

}  // namespace grafverif
