// SPDX-License-Identifier: MIT
#include "pipeline/untimed.hpp"

#include <algorithm>
#include <utility>

#include "ir/flat_system.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

namespace {

/// True if the value of `term` depends on the current value of a free variable.
bool reads_free_variable(const TransitionSystem& system, Id<Expr> term) {
    FlatSystem flat = flattened(system);
    const Id<Expr> root = flattened(system, flat, term);
    return std::ranges::any_of(leaves(flat.exprs, root), [&](Id<Expr> leaf) {
        return !flat.variables[{static_cast<std::uint32_t>(flat.exprs[leaf].value)}].next;
    });
}

/// True if the property reads an observer (an automaton that monitors a property). A verdict on the property does not
/// apply to another model, because the observer reacts to each step of this model, and another model has other steps.
bool reads_observer(const TransitionSystem& system, const Property& property) {
    const Table<TransitionSystem::Symbol>& symbols = system.modules[system.main].symbols;
    return std::ranges::any_of(property.operands, [&](Id<Expr> operand) {
        return std::ranges::any_of(leaves(system.exprs, operand), [&](Id<Expr> leaf) {
            const Id<TransitionSystem::Symbol> symbol{static_cast<std::uint32_t>(system.exprs[leaf].value)};
            const auto* member = std::get_if<TransitionSystem::MemberSymbol>(&symbols[symbol].kind);
            return member != nullptr && std::ranges::find(system.observers, member->instance) != system.observers.end();
        });
    });
}

/// True if the outcome for a model without a plant applies to every plant. The outcome of `p leads to q` does not apply
/// if p reads a free variable: with a plant, p may be true only between two PLC cycles, so that no cycle reads the
/// values that make p true.
bool holds_for_every_plant(const SystemToCheck& check, const Property& property, Outcome outcome) {
    const bool holds = outcome == Outcome::Holds;
    if (is_about_all_states(property.pattern)) return holds;
    if (property.at_stable) return false;
    if (property.pattern == Pattern::Reachable) return !holds;
    if (property.pattern == Pattern::Inevitable) return holds;
    return holds && property.pattern == Pattern::LeadsTo && !reads_free_variable(check.system, property.operands[0]);
}

}  // namespace

Abstraction abstraction_of(const ModelOptions& options, const ClosedLoop* loop) {
    using Preservation = Abstraction::Preservation;
    const ScheduleOptions& untimed = options.untimed;
    if (loop == nullptr || untimed.plant == PlantApproach::None)
        return {"no plant", {}, Preservation::ToEveryPlant, false};
    if (untimed.plant == PlantApproach::Constraints)
        return {"no plant, constrained inputs", {}, Preservation::ToEveryPlant, !loop->constraints.empty()};
    const std::string fair = untimed.fairness ? ", under fairness" : "";
    switch (untimed.schedule.value_or(loop->schedule.value_or(Schedule::Interleaved))) {
    case Schedule::Synchronous: return {"plant automata, synchronous" + fair, {}, Preservation::Nowhere, false};
    case Schedule::Sequenced: return {"plant automata, sequenced" + fair, {}, Preservation::Nowhere, false};
    case Schedule::Interleaved: break;
    }
    const std::string grain = options.grain.value_or(loop->grain) == Grain::Phased ? "phased" : "atomic";
    if (untimed.time == TimeModel::Discrete)
        return {"plant automata, integer time" + fair, grain, Preservation::ExactInIntegerTime, false,
                untimed.fairness};
    return {"plant automata, interleaved" + fair, grain, Preservation::ToTimedLoop, false, untimed.fairness};
}

namespace {

std::string carried(const SystemToCheck& check, const Property& property, const Verdict& verdict) {
    if (verdict.outcome == Outcome::Unknown) return {};
    const bool holds = verdict.outcome == Outcome::Holds;
    const bool all_runs = is_about_all_states(property.pattern) || is_liveness(property.pattern);
    const bool about_states = is_about_single_states(property.pattern);
    if (check.abstraction.fair && !about_states) return "no conclusion beyond this model";
    const bool observed = reads_observer(check.system, property);
    switch (check.abstraction.preservation) {
    case Abstraction::Preservation::ToEveryPlant: {
        if (observed || !holds_for_every_plant(check, property, verdict.outcome))
            return all_runs && !holds ? "may hold with the real plant" : "no conclusion about any plant";
        const bool constrained = check.abstraction.constrained;
        std::string words =
            constrained ? "valid for every plant that satisfies the constraints" : "valid for every plant";
        if (is_liveness(property.pattern)) {
            words += constrained ? " and lets " : " that lets ";
            words += check.system.controllers.size() > 1 ? "each controller run" : "the controller run";
        }
        return words + ", in grain atomic";
    }
    case Abstraction::Preservation::ToTimedLoop:
        if ((holds && all_runs) || (!holds && property.pattern == Pattern::Reachable))
            return "valid for the timed loop";
        return all_runs ? "may hold in the timed loop" : "no conclusion about the timed loop";
    case Abstraction::Preservation::ExactInIntegerTime:
        if (!about_states || observed) return "applies only to integer time";
        return holds == (property.pattern == Pattern::Reachable)
                   // a run proves this verdict, and each run in integer time is also a run in dense time
                   ? "valid for the timed loop"
                   : "applies to integer time, and to dense time only if no clock constraint is strict";
    case Abstraction::Preservation::Nowhere: return "no conclusion beyond this model";
    }
    return {};
}

}  // namespace

bool excludes_fault(const Property& property) {
    // The name does not suffice to identify an implicit property, because a model may declare a property with the same
    // name.
    const bool is_implicit = !property.origin.source.valid();
    return is_implicit && (property.name.starts_with("no_race") || property.name.starts_with("no_out_of_range"));
}

std::vector<std::string> unproven_faults(const TransitionSystem& system, const std::vector<Verdict>& verdicts) {
    std::vector<std::string> unproven;
    for (const Id<Property> id : system.properties.ids()) {
        const Property& property = system.properties[id];
        if (!excludes_fault(property)) continue;
        const auto verdict = std::ranges::find(verdicts, id, &Verdict::about);
        if (verdict == verdicts.end() || verdict->outcome != Outcome::Holds) unproven.push_back(property.name);
    }
    return unproven;
}

std::string preservation_text(const SystemToCheck& check, const Property& property, const Verdict& verdict,
                              const std::vector<std::string>& unproven) {
    std::string words = carried(check, property, verdict);
    if (!words.starts_with("valid ")) return words;
    bool first = true;
    for (const std::string& fault : unproven) {
        if (fault == property.name) continue;
        words += (first ? ", provided that " : " and ") + fault;
        first = false;
    }
    return first ? words : words + (words.find(" and no_") == std::string::npos ? " holds" : " hold");
}

}  // namespace grafverif
