// SPDX-License-Identifier: MIT
#include "pipeline/why.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "explain/ablation.hpp"
#include "ir/patterns.hpp"
#include "pipeline/models.hpp"
#include "support/element_of.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/component.hpp"

namespace grafverif {

namespace {

using ProofCore = ProofExplanation::ProofCore;
using ModelElement = ProofExplanation::ModelElement;
using Names = std::vector<std::string>;

/// True if `verdict` is a verdict on the property called `name`. A property `all` of the form `reachable all steps` has
/// one verdict per step, such as `all.X1`.
bool is_of(const Verdict& verdict, const std::string& name) {
    return verdict.property == name || verdict.property.starts_with(name + '.');
}

/// Returns the outcome of the property `name`: Violated if one of its verdicts is violated or if a model error prevents
/// a verdict; Holds if all its verdicts hold; otherwise Unknown.
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

/// Returns the name of an edge, such as `shut -> opening`. If there are several edges between the same locations, the
/// name includes the guard.
std::string edge_name(const Component& component, Id<Component::Edge> id) {
    const Component::Edge& edge = component.edges[id];
    const std::string endpoints = component.locations[edge.from].name + " -> " + component.locations[edge.to].name;
    const auto parallel_edges = std::ranges::count_if(
        component.edges, [&](const Component::Edge& other) { return other.from == edge.from && other.to == edge.to; });
    const std::string guard = parallel_edges > 1 ? guard_text(component, edge) : "";
    return endpoints + (guard.empty() ? "" : " when " + guard);
}

}  // namespace

ProofExplanation::ModelElement model_element(const ProgramElement& element) {
    const auto kind = element.transition ? ProofExplanation::Kind::Transition : ProofExplanation::Kind::Statement;
    return {.kind = kind, .name = element.name, .origin = element.origin};
}

void order_elements(ProofExplanation& why) {
    std::ranges::stable_sort(why.things, {}, &ProofExplanation::ModelElement::kind);
    std::map<std::tuple<ProofExplanation::Kind, std::string, std::string, std::uint32_t>, std::size_t> seen;
    for (ProofExplanation::ModelElement& element : why.things) {
        const bool statement = element.kind == ProofExplanation::Kind::Statement;
        element.nth = ++seen[{element.kind, element.of, element.name, statement ? element.origin.begin : 0}];
    }
}

namespace {

class ProofCoreSearch {
public:
    ProofCoreSearch(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how, const CheckOptions& options,
                    const Report& report, const VariantBounds& bounds)
        : model_(model), loop_(loop), how_(how), options_(options), search_(options, report, bounds) {}

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
        collect_transitions();
        collect_parts(expand(*network));
        collect_actions();
        collect_terms();
        collect_statements();
        const std::size_t of_charts = trials_.size();
        const std::size_t passes = search_.efforts().size();
        for (std::size_t pass = 0; pass < passes; ++pass) {
            effort_ = search_.efforts()[pass];
            is_last_ = pass + 1 == passes;
            pass_end_ = share_of(options_.limits.deadline, passes - pass);
            units_ = open_units() + (pass == 0 ? count_edges() : 0);
            for (std::size_t k = 0; k < of_charts; ++k) leave_out(trials_[k]);
            for (PartsOf& parts : parts_) leave_out_parts(parts);
            if (pass == 0) {
                collect_guards(*network);
                collect_edges(*network);
            }
            for (std::size_t k = of_charts; k < trials_.size(); ++k) leave_out(trials_[k]);
        }
        conclude();
        return std::move(why_);
    }

private:
    /// A trial with a changed model. `names` are the properties to decide for the changed model; `open` are the
    /// properties among `names` that are still undecided.
    struct Trial {
        ModelElement element = {};
        Names names = {}, open = {};
        std::function<void(Model&)> change = {};
        const Network* original = nullptr;  ///< if the plant is changed: the network of the unchanged model
    };
    /// State of the search for the instances and timers on which one property about all states depends.
    struct PartsOf {
        std::size_t ground = 0;
        /// The network after the removal of the processes that the property does not need.
        Network open = {};
        std::vector<Id<Network::Process>> order = {};  ///< undecided processes
    };

    bool stopped() {
        const bool over = search_.stopped();
        if (over) why_.ended = search_.reason();
        return over;
    }

    /// Returns the time at which the next search must end. The remaining time of this pass is divided into equal shares
    /// for the undecided elements; a search may use at most eight of these shares.
    Deadline next_end() {
        const std::size_t left = units_;
        if (units_ > 0) --units_;
        return share_of(pass_end_, left / 8 + 1);
    }

    std::vector<Verdict> search(const Network& network, const Names& names, const Deadline& deadline) {
        return search_(network, names, effort_, deadline);
    }

    std::size_t open_units() const {
        std::size_t count = 0;
        for (const Trial& trial : trials_) count += trial.open.empty() ? 0U : 1U;
        for (const PartsOf& parts : parts_) count += parts.order.size();
        return count;
    }
    /// Returns the maximum number of trials for guards and edges.
    std::size_t count_edges() const {
        std::size_t count = 0;
        for_each_edge([&](Id<ClosedLoop::Instance>, Id<Component::Edge>, const ModelElement&) { count += 2; });
        return count;
    }

    void conclude() {
        for (Trial& trial : trials_) {
            Names needed_by;
            for (const std::string& name : trial.names)
                if (std::ranges::find(trial.element.needed_by, name) != trial.element.needed_by.end())
                    needed_by.push_back(name);
            trial.element.needed_by = std::move(needed_by);
            trial.element.open = std::move(trial.open);
            if (!trial.element.open.empty()) (void)stopped();
            why_.things.push_back(std::move(trial.element));
        }
        conclude_parts();
        order_elements(why_);
        why_.searches = search_.searches();
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
        const std::vector<Verdict> found =
            names.empty() ? std::vector<Verdict>{} : search(network, names, share_of(options_.limits.deadline, 10));
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

    void add(ModelElement element, Names names, std::function<void(Model&)> change, const Network* original = nullptr) {
        trials_.push_back({std::move(element), names, names, std::move(change), original});
    }

    /// Decides the undecided properties of a trial for the changed model.
    void leave_out(Trial& trial) {
        if (trial.open.empty() || stopped()) return;
        const Deadline end = next_end();
        Names timeless;  // properties that read a timer that the change removes
        Model without = model_;
        trial.change(without);
        Table<Property> kept;
        for (const Property& property : without.loops[loop_].properties) {
            if (has_its_timers(without.loops[loop_], property, without)) kept.add(property);
            else timeless.push_back(property.name);
        }
        without.loops[loop_].properties = std::move(kept);
        Diagnostics diagnostics;
        std::optional<Network> network = network_of(without, loop_, how_, diagnostics);
        if (network && trial.original != nullptr) network = with_ranges_of(*trial.original, *network);
        if (!network) return;
        const std::vector<Verdict> found = search(*network, trial.open, end);
        std::erase_if(trial.open, [&](const std::string& name) {
            // If the changed model does not have an implicit property, this property holds. For example, a model in
            // which no race of stored actions is possible has no property `no_race`.
            const auto has_name = [&](const Property& property) { return property.name == name; };
            const bool is_absent = std::ranges::none_of(network->properties, has_name) &&
                                   std::ranges::find(timeless, name) == timeless.end();
            const Outcome outcome = is_absent ? Outcome::Holds : outcome_of(found, name);
            if (outcome == Outcome::Violated) trial.element.needed_by.push_back(name);
            return outcome != Outcome::Unknown;
        });
    }

    /// Calls `visit` once for each chart. The second argument is the prefix of the names of the chart's elements.
    void for_each_chart(const std::function<void(Id<Chart>, const std::string&)>& visit) const {
        std::set<std::uint32_t> seen;
        const ClosedLoop& loop = model_.loops[loop_];
        for (const ClosedLoop::Controller& controller : loop.controllers)
            if (seen.insert(controller.chart.index).second)
                visit(controller.chart,
                      loop.controllers.size() > 1 ? model_.charts[controller.chart].name + "." : std::string());
    }

    void collect_transitions() {
        for_each_chart([&](Id<Chart> id, const std::string& prefix) {
            const Chart& chart = model_.charts[id];
            for (const Id<Chart::Transition> transition : chart.transitions.ids())
                add({.kind = ProofExplanation::Kind::Transition, .name = prefix + chart.transitions[transition].name},
                    all(), [id, transition](Model& without) { drop_transition(without.charts[id], transition); });
        });
    }

    void collect_actions() {
        for_each_chart([&](Id<Chart> id, const std::string& prefix) {
            const Chart& chart = model_.charts[id];
            for (const Id<Chart::Step> step : chart.steps.ids()) {
                Chart idle = chart;
                if (drop_actions(idle, step))
                    add({.kind = ProofExplanation::Kind::Step, .name = prefix + name_of(chart, step).text()}, all(),
                        [id, step](Model& without) { (void)drop_actions(without.charts[id], step); });
            }
        });
    }

    void collect_terms() {
        for_each_chart([&](Id<Chart> id, const std::string& prefix) {
            const Chart& chart = model_.charts[id];
            for (const TermPlace& place : terms_of(chart))
                add({.kind = ProofExplanation::Kind::Term,
                     .name = term_text(chart, term_at(chart, place)),
                     .of = prefix + owner_text(chart, place)},
                    all(), [id, place](Model& without) { remove_term(without.charts[id], place); });
        });
    }

    /// Adds trials for the statements of PLC programs and for the transitions of their Sequential Function Charts.
    void collect_statements() {
        for_each_chart([&](Id<Chart> id, const std::string& prefix) {
            if (!model_.charts[id].program) return;
            for (ProgramElement& element : elements_of(*model_.charts[id].program)) {
                ModelElement made = model_element(element);
                if (element.transition) made.name = prefix + made.name;
                add(std::move(made), all(), [id, element = std::move(element)](Model& without) {
                    Program changed = *without.charts[id].program;
                    drop_element(changed, element);
                    without.charts[id].program = {std::make_shared<const Program>(std::move(changed))};
                });
            }
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

    /// Adds trials for guards. If it is proved that a property does not depend on an instance, the property also holds
    /// without the guards of this instance, and no trial is necessary. A guard of an edge with assignments always needs
    /// a trial, because a model error may be possible without this guard.
    void collect_guards(const Network& original) {
        for_each_edge([&](Id<ClosedLoop::Instance> id, Id<Component::Edge> edge, ModelElement element) {
            const Component& component = model_.components[model_.loops[loop_].instances[id].component];
            if (!is_guarded(component, edge) || std::ranges::none_of(why_.grounds, &ProofCore::about_states)) return;
            const bool assigns = !component.edges[edge].assignments.empty();
            const auto requested = [&](const ProofCore& ground) {
                const auto names = [&](const Names& list) { return std::ranges::find(list, element.of) != list.end(); };
                return ground.about_states && (assigns || names(ground.parts) || is_undecided(ground, element.of));
            };
            element.kind = ProofExplanation::Kind::Guard;
            add(
                element, names_of(requested),
                [this, id, edge](Model& without) { drop_guard(without, loop_, id, edge); }, &original);
        });
    }

    /// Adds trials for edges. If an edge is not urgent and no invariant forces it, removing the edge adds no behaviour
    /// to the closed loop. A property about all states that holds with the edge then also holds without it and needs no
    /// trial.
    void collect_edges(const Network& original) {
        for_each_edge([&](Id<ClosedLoop::Instance> id, Id<Component::Edge> edge, ModelElement element) {
            const bool forced = is_forced(model_.components[model_.loops[loop_].instances[id].component], edge);
            element.kind = ProofExplanation::Kind::Edge;
            add(
                element, names_of([&](const ProofCore& ground) { return forced || !ground.about_states; }),
                [this, id, edge](Model& without) { drop_edge(without, loop_, id, edge); }, &original);
        });
    }

    // -- the plant and the timers ------------------------------------------------------------------------------------

    void collect_parts(const Network& network) {
        display_names_ = display_names(network);
        order_ = in_order(network);
        for (std::size_t k = 0; k < why_.grounds.size(); ++k)
            if (why_.grounds[k].about_states) parts_.push_back({k, network, order_});
    }

    /// True if it is still undecided whether the property depends on the instance or timer `part`.
    bool is_undecided(const ProofCore& ground, const std::string& part) const {
        return std::ranges::any_of(parts_, [&](const PartsOf& parts) {
            return why_.grounds[parts.ground].property == ground.property &&
                   std::ranges::any_of(parts.order,
                                       [&](Id<Network::Process> id) { return display_names_[id.index] == part; });
        });
    }

    void conclude_parts() {
        std::set<std::string> needed;
        for (const PartsOf& parts : parts_) {
            ProofCore& ground = why_.grounds[parts.ground];
            for (const Id<Network::Process> id : parts.order) ground.open.push_back(display_names_[id.index]);
            if (!ground.open.empty()) (void)stopped();
            for (const auto* names : {&ground.parts, &ground.open}) needed.insert(names->begin(), names->end());
        }
        for (const Id<Network::Process> id : order_)
            if (!parts_.empty() && !needed.contains(display_names_[id.index]))
                why_.unneeded_parts.push_back(display_names_[id.index]);
    }

    /// Returns the instances and timers in the order of their removal. Processes that write inputs of controllers come
    /// first: after their removal, other processes may have no effect.
    static std::vector<Id<Network::Process>> in_order(const Network& network) {
        std::vector<Id<Network::Process>> order, others;
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
            (drives ? order : others).push_back(id);
        }
        order.insert(order.end(), others.begin(), others.end());
        return order;
    }

    /// Tries to remove each undecided process; a process that the property does not need remains removed. Then tries to
    /// remove all undecided processes together. In the last pass, tries again to remove each process that is still
    /// undecided. Each pass may explore more states than the previous pass.
    void leave_out_parts(PartsOf& parts) {
        ProofCore& ground = why_.grounds[parts.ground];
        for (const bool again : {false, true}) {
            if (again && (!is_last_ || parts.order.empty())) break;
            std::erase_if(parts.order, [&](Id<Network::Process> id) {
                return !stopped() && leave_out(id, parts.open, ground, next_end()) != Outcome::Unknown;
            });
            if (!again && parts.order.size() > 1 && !stopped() && leave_out_all(parts.order, parts.open, ground))
                parts.order.clear();
        }
    }

    bool leave_out_all(const std::vector<Id<Network::Process>>& processes, Network& open, const ProofCore& ground) {
        const Property& property = element_of(open.properties, ground.property, &Property::name);
        Network less = open;
        for (const Id<Network::Process> id : processes)
            if (open.processes[id].kind == Network::ProcessKind::Timer) drop_timing(less, id);
            else if (!drop_instance(less, id, roams(open, property))) return false;
        if (outcome_of(search(less, {ground.property}, next_end()), ground.property) != Outcome::Holds) return false;
        open = std::move(less);
        return true;
    }

    /// Tries to remove a process from the network `open`. For an instance: removes the complete instance or, if the
    /// property does not hold without it, only its clocks. For a timer: removes its clocks. Returns Holds if the
    /// property does not depend on the process, Violated if the property depends on it, and Unknown otherwise.
    Outcome leave_out(Id<Network::Process> id, Network& open, ProofCore& ground, const Deadline& end) {
        const std::string& name = display_names_[id.index];
        const Property& property = element_of(open.properties, ground.property, &Property::name);
        const bool timer = open.processes[id].kind == Network::ProcessKind::Timer;
        const auto without = [&](Network less) {
            const Outcome outcome = outcome_of(search(less, {ground.property}, end), ground.property);
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

    /// True if the property may depend on locations of instances: its operands read locations, or it is checked only in
    /// quiescent states.
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
    VariantSearch search_;
    SearchEffort effort_ = {};
    bool is_last_ = false;
    Deadline pass_end_ = {};
    std::size_t units_ = 0;  // number of elements that share the rest of this pass's time
    std::vector<Trial> trials_ = {};
    std::vector<PartsOf> parts_ = {};
    std::vector<Id<Network::Process>> order_ = {};
    std::vector<std::string> display_names_ = {};  // displayed name of each process
    ProofExplanation why_ = {};
};

}  // namespace

ProofExplanation why_it_holds(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                              const CheckOptions& options, const Report& report, const VariantBounds& bounds) {
    return ProofCoreSearch(model, loop, how, options, report, bounds).why(report);
}

}  // namespace grafverif
