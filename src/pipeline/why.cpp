// SPDX-License-Identifier: MIT
#include "pipeline/why.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "check/localization/localization.hpp"
#include "check/timed/timed.hpp"
#include "compose/observe.hpp"
#include "explain/ablation.hpp"
#include "ir/patterns.hpp"
#include "pipeline/models.hpp"
#include "support/element_of.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/component.hpp"

namespace grafverif {

namespace {

using ProofCore = ProofExplanation::ProofCore;
using ModelElement = ProofExplanation::ModelElement;
using Names = std::vector<std::string>;

/// True if `verdict` concerns the property called `name` or a step of it.
bool is_of(const Verdict& verdict, const std::string& name) {
    return verdict.property == name || verdict.property.starts_with(name + '.');
}

/// Returns the outcome of a property: violated if one of its verdicts is, or if a model error occurs before it is
/// decided; holds if all verdicts hold.
Outcome outcome_of(const std::vector<Verdict>& verdicts, const std::string& name) {
    bool any = false, all = true;
    for (const Verdict& verdict : verdicts) {
        if (!is_of(verdict, name)) continue;
        if (verdict.outcome == Outcome::Violated || verdict.obstacle == UnknownReason::Faulty) return Outcome::Violated;
        any = true;
        all = all && verdict.outcome == Outcome::Holds;
    }
    return any && all ? Outcome::Holds : Outcome::Unknown;
}

/// Returns the premise p of `always !p or q`; invalid for any other property.
Id<Expr> left_side(const Property& property, Exprs& exprs) {
    if (property.pattern != Pattern::Always || exprs[property.operands[0]].op != Op::Or) return {};
    std::vector<Id<Expr>> requested;
    bool answered = false;
    for (const Id<Expr> operand : std::vector<Id<Expr>>(exprs.operands(property.operands[0]).begin(),
                                                        exprs.operands(property.operands[0]).end())) {
        if (exprs[operand].op == Op::Not) requested.push_back(exprs.negation(operand));
        else answered = true;
    }
    return requested.empty() || !answered ? Id<Expr>{} : exprs.conjunction(requested);
}

/// Returns the element that has the term in its condition: `t3`, `OUT in step 5`.
std::string owner_of(const Chart& chart, const TermPlace& place) {
    const auto action = [&](const auto& of, Id<Chart::Variable> variable) {
        return chart.variables[variable].name + " in step " + name_of(chart, of.step).text();
    };
    switch (place.of) {
    case TermPlace::Of::Transition: return chart.transitions[{place.index}].name;
    case TermPlace::Of::Action: {
        const Chart::ContinuousAction& of = chart.continuous[{place.index}];
        return action(of, of.output);
    }
    case TermPlace::Of::Event: {
        const Chart::StoredAction& of = chart.stored[{place.index}];
        return action(of, of.target);
    }
    }
    unreachable();
}

/// Returns `shut -> opening`, with its guard if there are several edges between these locations.
std::string edge_name(const Component& component, Id<Component::Edge> id) {
    const Component::Edge& edge = component.edges[id];
    const std::string ways = component.locations[edge.from].name + " -> " + component.locations[edge.to].name;
    const auto beside = std::ranges::count_if(
        component.edges, [&](const Component::Edge& other) { return other.from == edge.from && other.to == edge.to; });
    const std::string guard = beside > 1 ? guard_text(component, edge) : "";
    return ways + (guard.empty() ? "" : " when " + guard);
}

/// Returns `network` with the observer of `property`, which is then its only property.
Network with_observer(const Network& network, Id<Property> property) {
    Network made = observed(network, {property});
    const Property decided = element_of(made.properties, network.properties[property].name, &Property::name);
    made.properties = {};
    made.properties.add(decided);
    return made;
}

class ProofCoreSearch {
public:
    ProofCoreSearch(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how, const CheckOptions& options,
                    const Report& report)
        : model_(model), loop_(loop), how_(how), options_(options) {
        std::uint64_t states = 0;
        for (const PropertyResult& answer : report.answers) {
            states = std::max<std::uint64_t>(states, std::stoull("0" + answer.verdict.states));
            // In most cases localization decides these properties again. Therefore the preceding search of the complete
            // network is short.
            if (answer.verdict.scope.cells) cells_.whole = std::uint64_t{1} << 12U;
        }
        most_states_ = std::max<std::uint64_t>(8 * states, 100'000);
    }

    ProofExplanation why(const Report& report) {
        Diagnostics diagnostics;
        auto network = network_of(model_, loop_, how_, diagnostics);
        if (!network) return {};
        std::vector<Verdict> found;
        for (const PropertyResult& answer : report.answers) found.push_back(answer.verdict);
        for (const Property& property : network->properties)
            if (outcome_of(found, property.name) == Outcome::Holds)
                why_.grounds.push_back(
                    {.property = property.name, .about_states = is_about_all_states(property.pattern)});
        if (why_.grounds.empty()) return std::move(why_);
        query_premises(*network);
        leave_out_transitions();
        leave_out_parts(expand(*network));
        leave_out_actions();
        leave_out_terms();
        leave_out_guards(*network);
        leave_out_edges(*network);
        number_namesakes();
        return std::move(why_);
    }

private:
    std::vector<Verdict> search(const Network& network, const std::vector<std::string>& names) {
        TimedOptions timed;
        timed.properties = names;
        timed.max_states = options_.limits.states.value_or(most_states_);
        set_limits(timed, options_.limits);
        timed.jobs = options_.jobs;
        timed.timelock = false;
        std::vector<Id<Property>> by_observers = watched(network);
        std::erase_if(by_observers,
                      [&](Id<Property> id) { return std::erase(timed.properties, network.properties[id].name) == 0; });
        std::vector<Verdict> found;
        const auto add = [&](TimedResult result) { std::ranges::move(result.verdicts, std::back_inserter(found)); };
        if (!timed.properties.empty() && !stopped()) {
            ++why_.searches;
            add(options_.whole ? check_timed(network, timed) : check_timed_by_cells(network, timed, cells_));
        }
        for (const Id<Property> id : by_observers) {
            if (stopped()) break;
            ++why_.searches;
            timed.properties = {network.properties[id].name};
            add(check_timed(with_observer(network, id), timed));
        }
        return found;
    }

    bool stopped() {
        const bool over = options_.limits.deadline && std::chrono::steady_clock::now() >= *options_.limits.deadline;
        const bool requested = options_.limits.stop != nullptr && *options_.limits.stop;
        if (over || requested) why_.ended = over ? "time limit reached" : "stopped";
        return over || requested;
    }

    void query_premises(Network network) {
        std::vector<std::string> names;
        std::vector<Property> questions;
        for (const ProofCore& ground : why_.grounds) {
            const Property& property = element_of(network.properties, ground.property, &Property::name);
            const Id<Expr> requested = left_side(property, network.exprs);
            if (!requested.valid()) continue;
            questions.push_back({.name = ground.property + " premise",
                                 .pattern = Pattern::Reachable,
                                 .operands = {requested},
                                 .at_stable = property.at_stable});
            names.push_back(questions.back().name);
        }
        for (Property& question : questions) network.properties.add(std::move(question));
        const std::vector<Verdict> found = names.empty() ? std::vector<Verdict>{} : search(network, names);
        for (ProofCore& ground : why_.grounds)
            ground.vacuous = outcome_of(found, ground.property + " premise") == Outcome::Violated;
    }

    // -- removal of single elements ----------------------------------------------------------------------------------

    Names names_of(const std::function<bool(const ProofCore&)>& requested) const {
        Names names;
        for (const ProofCore& ground : why_.grounds)
            if (requested(ground)) names.push_back(ground.property);
        return names;
    }
    Names all() const {
        return names_of([](const ProofCore&) { return true; });
    }

    /// Checks the properties called `names` of the model after `change`. For a change to the plant, `original` is the
    /// network of the unchanged model.
    void leave_out(ModelElement thing, const Names& names, const std::function<void(Model&)>& change,
                   const Network* original = nullptr) {
        std::optional<Network> network;
        std::vector<Verdict> found;
        Names timeless;  // properties that read a timer that is also removed
        if (!names.empty() && !stopped()) {
            Model without = model_;
            change(without);
            Table<Property> kept;
            for (const Property& property : without.loops[loop_].properties) {
                if (has_its_timers(without.loops[loop_], property, without)) kept.add(property);
                else timeless.push_back(property.name);
            }
            without.loops[loop_].properties = std::move(kept);
            Diagnostics diagnostics;
            network = network_of(without, loop_, how_, diagnostics);
            if (network && original != nullptr) network = with_ranges_of(*original, *network);
            if (network) found = search(*network, names);
        }
        for (const std::string& name : names) {
            // The change may remove an implicit property of the model: if stored actions can no longer race, there is
            // no property that they do not.
            const auto asks = [&](const Property& property) { return property.name == name; };
            const bool gone = network && std::ranges::none_of(network->properties, asks) &&
                              std::ranges::find(timeless, name) == timeless.end();
            const Outcome outcome = gone ? Outcome::Holds : outcome_of(found, name);
            if (outcome == Outcome::Violated) thing.needed_by.push_back(name);
            if (outcome == Outcome::Unknown) thing.open.push_back(name);
        }
        why_.things.push_back(std::move(thing));
    }

    /// Visits each chart once, with the prefix of its names.
    void for_each_chart(const std::function<void(Id<Chart>, const std::string&)>& visit) const {
        std::set<std::uint32_t> seen;
        const ClosedLoop& loop = model_.loops[loop_];
        for (const ClosedLoop::Controller& controller : loop.controllers)
            if (seen.insert(controller.chart.index).second)
                visit(controller.chart,
                      loop.controllers.size() > 1 ? model_.charts[controller.chart].name + "." : std::string());
    }

    void leave_out_transitions() {
        for_each_chart([&](Id<Chart> id, const std::string& prefix) {
            const Chart& chart = model_.charts[id];
            for (const Id<Chart::Transition> transition : chart.transitions.ids())
                leave_out(
                    {.kind = ProofExplanation::Kind::Transition, .name = prefix + chart.transitions[transition].name},
                    all(), [&](Model& without) { drop_transition(without.charts[id], transition); });
        });
    }

    void leave_out_actions() {
        for_each_chart([&](Id<Chart> id, const std::string& prefix) {
            const Chart& chart = model_.charts[id];
            for (const Id<Chart::Step> step : chart.steps.ids()) {
                Chart idle = chart;
                if (drop_actions(idle, step))
                    leave_out({.kind = ProofExplanation::Kind::Step, .name = prefix + name_of(chart, step).text()},
                              all(), [&](Model& without) { without.charts[id] = idle; });
            }
        });
    }

    void leave_out_terms() {
        for_each_chart([&](Id<Chart> id, const std::string& prefix) {
            const Chart& chart = model_.charts[id];
            for (const TermPlace& place : terms_of(chart))
                leave_out({.kind = ProofExplanation::Kind::Term,
                           .name = term_text(chart, term_at(chart, place)),
                           .of = prefix + owner_of(chart, place)},
                          all(), [&](Model& without) { remove_term(without.charts[id], place); });
        });
    }

    void for_each_edge(
        const std::function<void(Id<ClosedLoop::Instance>, Id<Component::Edge>, ModelElement)>& visit) const {
        const ClosedLoop& loop = model_.loops[loop_];
        for (const Id<ClosedLoop::Instance> id : loop.instances.ids()) {
            const Component& component = model_.components[loop.instances[id].component];
            for (const Id<Component::Edge> edge : component.edges.ids())
                visit(id, edge, {.name = edge_name(component, edge), .of = loop.instances[id].name});
        }
    }

    /// A property that holds for any behaviour of an instance also holds for any value of its guards, so that no search
    /// is necessary. However, if the edge has assignments, a model error may be possible without the guard.
    void leave_out_guards(const Network& original) {
        for_each_edge([&](Id<ClosedLoop::Instance> id, Id<Component::Edge> edge, ModelElement thing) {
            const Component& component = model_.components[model_.loops[loop_].instances[id].component];
            if (!is_guarded(component, edge) || std::ranges::none_of(why_.grounds, &ProofCore::about_states)) return;
            const bool assigns = !component.edges[edge].assignments.empty();
            const auto requested = [&](const ProofCore& ground) {
                const auto names = [&](const Names& list) { return std::ranges::find(list, thing.of) != list.end(); };
                return ground.about_states &&
                       (assigns || names(ground.parts) || names(ground.open) || !why_.ended.empty());
            };
            thing.kind = ProofExplanation::Kind::Guard;
            leave_out(
                thing, names_of(requested), [&](Model& without) { drop_guard(without, loop_, id, edge); }, &original);
        });
    }

    /// If an edge is not urgent and no invariant forces it, the loop without it has no new behaviour. Therefore a
    /// property of all states still holds.
    void leave_out_edges(const Network& original) {
        for_each_edge([&](Id<ClosedLoop::Instance> id, Id<Component::Edge> edge, ModelElement thing) {
            const bool forced = is_forced(model_.components[model_.loops[loop_].instances[id].component], edge);
            thing.kind = ProofExplanation::Kind::Edge;
            leave_out(
                thing, names_of([&](const ProofCore& ground) { return forced || !ground.about_states; }),
                [&](Model& without) { drop_edge(without, loop_, id, edge); }, &original);
        });
    }

    void number_namesakes() {
        std::map<std::tuple<ProofExplanation::Kind, std::string, std::string>, std::size_t> seen;
        for (ModelElement& thing : why_.things) thing.nth = ++seen[{thing.kind, thing.of, thing.name}];
    }

    // -- the plant and the timers ------------------------------------------------------------------------------------

    void leave_out_parts(const Network& network) {
        told_ = display_names(network);
        const std::vector<Id<Network::Process>> order = in_order(network);
        std::set<std::string> needed;
        bool requested = false;
        for (ProofCore& ground : why_.grounds) {
            if (!ground.about_states) continue;
            requested = true;
            leave_out_parts(network, order, ground);
            for (const auto* names : {&ground.parts, &ground.open}) needed.insert(names->begin(), names->end());
        }
        for (const Id<Network::Process> id : order)
            if (requested && why_.ended.empty() && !needed.contains(told_[id.index]))
                why_.unneeded_parts.push_back(told_[id.index]);
    }

    /// Returns the processes in the order of removal. Processes that write inputs of controllers come first: after they
    /// are removed, others may have no further effect.
    static std::vector<Id<Network::Process>> in_order(const Network& network) {
        std::vector<Id<Network::Process>> order, behind;
        for (const Id<Network::Process> id : network.processes.ids()) {
            const Network::Process& process = network.processes[id];
            if (process.kind == Network::ProcessKind::Controller) continue;
            const bool drives =
                std::ranges::any_of(network.templates[process.automaton].edges, [&](const Network::Edge& edge) {
                    return std::ranges::any_of(edge.assignments, [&](const Network::Assignment& assignment) {
                        const Expr& target = network.exprs[assignment.target];
                        return network.variables[{static_cast<std::uint32_t>(target.value)}].role ==
                               Network::Role::Input;
                    });
                });
            (drives ? order : behind).push_back(id);
        }
        order.insert(order.end(), behind.begin(), behind.end());
        return order;
    }

    /// Removes parts. Parts for which no result was found are tried again with the others removed, first all together
    /// and then one by one.
    void leave_out_parts(const Network& network, std::vector<Id<Network::Process>> order, ProofCore& ground) {
        Network open = network;
        for (const bool again : {false, true}) {
            std::vector<Id<Network::Process>> undecided;
            for (const Id<Network::Process> id : order) {
                if (stopped()) break;
                if (leave_out(id, open, ground) != Outcome::Unknown) continue;
                undecided.push_back(id);
                if (again) ground.open.push_back(told_[id.index]);
            }
            order = std::move(undecided);
            if (!again && order.size() > 1 && leave_out_all(order, open, ground)) break;
        }
        if (!why_.ended.empty()) ground.open.emplace_back("all other parts");
    }

    bool leave_out_all(const std::vector<Id<Network::Process>>& processes, Network& open, const ProofCore& ground) {
        const Property& property = element_of(open.properties, ground.property, &Property::name);
        Network less = open;
        for (const Id<Network::Process> id : processes)
            if (open.processes[id].kind == Network::ProcessKind::Timer) drop_timing(less, id);
            else if (!drop_instance(less, id, roams(open, property))) return false;
        if (outcome_of(search(less, {ground.property}), ground.property) != Outcome::Holds) return false;
        open = std::move(less);
        return true;
    }

    /// Removes as much as possible of a process from `open`. Returns Holds if everything was removed, and Unknown if
    /// there was no result.
    Outcome leave_out(Id<Network::Process> id, Network& open, ProofCore& ground) {
        const std::string& name = told_[id.index];
        const Property& property = element_of(open.properties, ground.property, &Property::name);
        const bool timer = open.processes[id].kind == Network::ProcessKind::Timer;
        const auto without = [&](Network less) {
            const Outcome outcome = outcome_of(search(less, {ground.property}), ground.property);
            if (outcome == Outcome::Holds) open = std::move(less);
            return outcome;
        };
        Network less = open;
        Outcome whole = Outcome::Unknown;
        if (!timer && drop_instance(less, id, roams(open, property))) whole = without(std::move(less));
        if (whole == Outcome::Holds) return whole;
        less = open;
        const bool clocks = drop_timing(less, id);
        const Outcome untimed = clocks ? without(std::move(less)) : Outcome::Holds;
        if (timer) whole = untimed;
        if (whole != Outcome::Violated || untimed == Outcome::Unknown)
            return whole == Outcome::Holds ? whole : Outcome::Unknown;
        ground.parts.push_back(name);
        if (!timer && untimed == Outcome::Violated) ground.timings.push_back(name);
        return whole;
    }

    /// True if the property reads locations of instances.
    static bool roams(const Network& network, const Property& property) {
        const auto is_place = [&](Id<Expr> leaf) { return network.exprs[leaf].op == Op::At; };
        return property.at_stable || std::ranges::any_of(property.operands, [&](Id<Expr> operand) {
                   return std::ranges::any_of(leaves(network.exprs, operand), is_place);
               });
    }

    const Model& model_;
    Id<ClosedLoop> loop_;
    const ModelOptions& how_;
    const CheckOptions& options_;
    std::uint64_t most_states_ = 0;
    LocalizationLimits cells_ = {};
    std::vector<std::string> told_ = {};  // displayed name of each process
    ProofExplanation why_ = {};
};

}  // namespace

ProofExplanation why_it_holds(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                              const CheckOptions& options, const Report& report) {
    return ProofCoreSearch(model, loop, how, options, report).why(report);
}

}  // namespace grafverif
