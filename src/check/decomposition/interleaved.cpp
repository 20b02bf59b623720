// SPDX-License-Identifier: MIT
#include "check/decomposition/interleaved.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "check/decomposition/subsystem_runs.hpp"
#include "check/decomposition/subsystem_searches.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;

class InterleavedCheck {
public:
    InterleavedCheck(const System& system, const SymbolicOptions& options)
        : system_(system), options_(options), parts_(system, options) {}

    SymbolicResult result();

private:
    void answer(Id<Property> id);
    void result_of_each(Id<Property> id);
    bool decide_starved(Id<Property> id, SubsystemResult& search, Verdict& verdict,
                        const std::vector<const OmittedSubsystem*>& rest);
    void give(Id<Property> id, const Verdict& found, SearchScope scope, std::optional<FlatRun> run);
    void needs_complete(Id<Property> id, std::string why) { whole_[id.index] = std::move(why); }
    void search_complete();
    SearchScope scope(const PartList& chosen, std::string because) const;

    SubsystemRun subsystem_run(const SubsystemResult& search, const FlatRun& run) const;
    std::optional<FlatRun> complete_run(const SubsystemResult& search, const FlatRun& run, bool at_stable,
                                        Verdict& verdict);
    SubsystemRun extended(SubsystemRun made, const SubsystemStep& last, const PartList& rest);
    std::vector<std::int64_t> here(SubsystemResult& search, const std::vector<std::int64_t>& whole);
    SubsystemRun settled(const PartList& parts);

    const System& system_;
    const SymbolicOptions& options_;
    SubsystemSearches parts_;
    /// Verdict and run of each property; empty until they are known.
    std::vector<std::optional<std::pair<Verdict, std::optional<SystemRun>>>> given_ = {};
    /// Properties that require the complete system, with their reasons.
    std::map<std::uint32_t, std::string> whole_ = {};
    SymbolicResult result_ = {};
};

SymbolicResult InterleavedCheck::result() {
    given_.resize(system_.properties.size());
    for (std::uint32_t part = 0; part < system_.parts.each.size(); ++part)
        if (parts_.search({part}).result.fault) return check_symbolic(system_, options_);
    for (const Id<Property> id : system_.properties.ids()) {
        if (!parts_.requested(system_.properties[id])) continue;
        try {
            parts_.about_each(system_.properties[id]) ? result_of_each(id) : answer(id);
        } catch (const BddExhausted&) {
            needs_complete(id, "a limit was reached before the interaction of the sub-loops was determined");
        }
    }
    parts_.forget();
    result_.bytes = parts_.bytes();
    result_.seconds = parts_.seconds();
    search_complete();
    for (auto& given : given_) {
        if (!given) continue;
        given->first.seconds = result_.seconds;
        result_.verdicts.push_back(std::move(given->first));
        result_.runs.push_back(std::move(given->second));
    }
    return std::move(result_);
}

// -- verdicts ---------------------------------------------------------------------------------------------------------

SearchScope InterleavedCheck::scope(const PartList& chosen, std::string because) const {
    SearchScope made{{}, {}, std::move(because)};
    for (const std::uint32_t part : chosen) made.searched.push_back(system_.parts.each[part].name);
    for (const std::uint32_t part : parts_.others(chosen)) made.left_out.push_back(system_.parts.each[part].name);
    return made;
}

void InterleavedCheck::give(Id<Property> id, const Verdict& found, SearchScope scope, std::optional<FlatRun> run) {
    Verdict verdict = found;
    const Verdict named = verdict_on(id, system_.properties[id]);
    verdict.about = id;
    verdict.property = named.property;
    verdict.pattern = named.pattern;
    verdict.scope = std::move(scope);
    given_[id.index] = {std::move(verdict), run ? std::optional(system_run(parts_.flat(), *run)) : std::nullopt};
}

void InterleavedCheck::answer(Id<Property> id) {
    const Property& property = system_.properties[id];
    const PartList chosen = parts_.reads(property.operands);
    const bool about_states = is_about_states(property.pattern);
    if (chosen == parts_.all()) return needs_complete(id, "");
    if (!about_states && !parts_.flat().justice.empty())
        return needs_complete(id, "fairness of a run depends on all sub-loops");
    if (property.at_stable && !about_states)
        return needs_complete(id, "whether a run ends in a quiescent state (`at stable`) depends on all sub-loops");
    if (property.at_stable && system_.settled.valid() &&
        std::ranges::any_of(system_.parts.each, [](const System::Subsystem& part) { return !part.settled.valid(); }))
        return needs_complete(id, "quiescence cannot be decomposed into sub-loops");
    SubsystemResult& found = parts_.search(chosen);
    if (found.result.fault) return needs_complete(id, "the sub-loops on which the property depends have a model error");
    const auto place = static_cast<std::size_t>(std::ranges::find(found.requested, id) - found.requested.begin());
    Verdict verdict = found.result.verdicts[place];
    if (verdict.outcome == Outcome::Unknown) return give(id, verdict, scope(chosen, ""), {});
    std::vector<const OmittedSubsystem*> rest;
    for (const std::uint32_t part : parts_.others(chosen))
        rest.push_back(&parts_.omitted(part, verdict, property.at_stable));
    if (!parts_.timed() && decide_starved(id, found, verdict, rest)) return;
    const std::string why = parts_.timed() ? preservation_obstacle(verdict, property.at_stable, rest)
                                           : untimed_preservation_obstacle(verdict, property.at_stable, rest);
    if (!why.empty()) return needs_complete(id, why);
    std::optional<FlatRun> run;
    if (found.check->runs()[place]) run = complete_run(found, *found.check->runs()[place], property.at_stable, verdict);
    give(id, verdict,
         scope(chosen,
               parts_.timed() ? because(verdict, property.at_stable) : untimed_because(verdict, property.at_stable)),
         std::move(run));
}

/// Decides `inevitable` or `leads to` in a system without clocks, if the property holds on the searched parts and
/// another part can move forever. Without clocks, a part that moves forever can prevent the progress of all other
/// parts. Returns true if this function has decided the verdict.
bool InterleavedCheck::decide_starved(Id<Property> id, SubsystemResult& search, Verdict& verdict,
                                      const std::vector<const OmittedSubsystem*>& rest) {
    if (preservation_class_of(verdict) != PreservationClass::Unavoidable) return false;
    const auto mover =
        std::ranges::find_if(rest, [](const OmittedSubsystem* other) { return other->searched && !other->rests; });
    if (mover == rest.end()) return false;
    const Property& property = system_.properties[id];
    const auto value = [&](std::size_t operand) {
        return search.check->meaning(search.system, property.operands[operand]);
    };
    const symbolic::StateSpace& model = search.check->model();
    const bool leads = property.pattern == Pattern::LeadsTo;
    const Bdd waiting = search.check->reached() & (leads ? value(0) & ~value(1) : model.initial() & ~value(0));
    const PartList all_others = parts_.others(search.chosen);
    const std::uint32_t who = all_others[static_cast<std::size_t>(mover - rest.begin())];
    if (waiting.is_false()) {
        give(id, verdict,
             scope(search.chosen, "shares nothing with the checked sub-loops and does not affect the verdict"), {});
        return true;
    }
    const FlatRun path =
        symbolic::run_of(model, {symbolic::shortest_trace(model, search.check->search_made(), waiting), {}, {}});
    SubsystemResult& moving = parts_.search({who});
    const SubsystemRun made =
        concatenated(subsystem_run(search, path), subsystem_run(moving, parts_.interleaving(moving).endless_run()));
    verdict.outcome = Outcome::Violated;
    verdict.vacuous = false;
    verdict.notes = {"`" + (*mover)->name + "` can move forever while all other sub-loops wait"};
    give(id, verdict,
         scope(search.chosen, "shares nothing with the checked sub-loops and can move forever while they wait"),
         replayed(parts_.flat(), made));
    return true;
}

/// Decides a property that holds for the complete system if it holds for each part.
void InterleavedCheck::result_of_each(Id<Property> id) {
    std::optional<Verdict> open;
    Verdict holds = verdict_on(id, system_.properties[id]);
    holds.outcome = Outcome::Holds;
    for (const std::uint32_t part : parts_.all()) {
        SubsystemResult& found = parts_.search({part});
        const auto place = static_cast<std::size_t>(std::ranges::find(found.requested, id) - found.requested.begin());
        Verdict verdict = found.result.verdicts[place];
        if (verdict.outcome == Outcome::Holds) continue;
        if (verdict.outcome == Outcome::Unknown) {
            open = verdict;
            continue;
        }
        std::vector<const OmittedSubsystem*> rest;
        for (const std::uint32_t other : parts_.others({part})) rest.push_back(&parts_.omitted(other, verdict, false));
        if (const std::string why = parts_.timed() ? preservation_obstacle(verdict, false, rest) : ""; !why.empty())
            return needs_complete(id, why);
        std::optional<FlatRun> run;
        if (found.check->runs()[place]) run = complete_run(found, *found.check->runs()[place], false, verdict);
        const std::string why = parts_.timed() ? because(verdict, false) : untimed_because(verdict, false);
        return give(id, verdict, scope({part}, why), std::move(run));
    }
    give(id, open.value_or(holds), scope(parts_.all(), ""), {});
}

void InterleavedCheck::search_complete() {
    if (whole_.empty()) return;
    SymbolicOptions options = options_;
    options.properties = {};
    for (const auto& [index, why] : whole_) options.properties.push_back(system_.properties[{index}].name);
    SymbolicResult whole = check_symbolic(system_, options);
    result_.states = whole.states;
    result_.depth = whole.depth;
    result_.bytes = std::max(result_.bytes, whole.bytes);
    result_.seconds += whole.seconds;
    result_.fault = whole.fault;
    for (std::size_t i = 0; i < whole.verdicts.size(); ++i) {
        Verdict& verdict = whole.verdicts[i];
        const auto requested = whole_.find(verdict.about.index);
        if (requested == whole_.end()) continue;
        if (const std::string& why = requested->second; !why.empty())
            verdict.notes.push_back("the complete loop was explored: " + why);
        given_[verdict.about.index] = {verdict, std::move(whole.runs[i])};
    }
}

// -- runs -------------------------------------------------------------------------------------------------------------

/// Converts a run of the searched parts to steps of the complete system.
SubsystemRun InterleavedCheck::subsystem_run(const SubsystemResult& search, const FlatRun& run) const {
    const System& system = search.system;
    const FlatSystem& part = search.check->flat();
    const std::vector<Id<FlatSystem::Variable>> in_complete = variables_in_complete(part, parts_.flat());
    SubsystemRun made{{}, run.loop};
    const std::size_t steps = run.loop ? run.states.size() : run.states.size() - 1;
    for (std::size_t i = 0; i < steps; ++i) {
        const std::vector<std::int64_t> values = symbol_values(part, run.states[i]);
        SubsystemStep step{.kind = SubsystemStep::Kind::Ends};
        if (value_in(system, values, system_.parts.waits) != 0) step.kind = SubsystemStep::Kind::Waits;
        for (const System::Subsystem& each : system_.parts.each)
            if (value_in(system, values, each.moves) != 0) step.kind = SubsystemStep::Kind::Moves;
        for (const Id<FlatSystem::Variable> id : part.variables.ids())
            if (part.variables[id].choice)
                step.choices.emplace_back(in_complete[id.index].index, run.states[i][id.index]);
        made.steps.push_back(std::move(step));
    }
    return made;
}

/// Converts a state of the complete system to a state of the searched parts. A variable that does not belong to a part
/// (a flag of action races) has a copy in each part. If no race has occurred in the searched parts, the copy has the
/// initial value, although the flag may be set in `whole`.
std::vector<std::int64_t> InterleavedCheck::here(SubsystemResult& search, const std::vector<std::int64_t>& whole) {
    const std::vector<Id<FlatSystem::Variable>> in_complete =
        variables_in_complete(search.check->flat(), parts_.flat());
    std::vector<std::int64_t> made;
    for (const Id<FlatSystem::Variable> id : in_complete) made.push_back(whole[id.index]);
    if (parts_.interleaving(search).reaches(made)) return made;
    const std::vector<std::int64_t> first = replayed(parts_.flat(), {}).states.back();
    const std::vector<std::uint32_t> part_of = parts_of_symbols(system_);
    for (std::size_t symbol = 0; symbol < part_of.size(); ++symbol) {
        const Expr& value = search.check->flat().exprs[search.check->flat().symbols[symbol]];
        if (part_of[symbol] != no_part || value.op != Op::Variable) continue;
        const auto variable = static_cast<std::size_t>(value.value);
        made[variable] = first[in_complete[variable].index];
    }
    return made;
}

/// Extends the run `made`. At the end of `made`, the searched parts stay in one state. The other parts `rest` move, one
/// part after another, until each of them can only wait, or until one of them moves forever.
SubsystemRun InterleavedCheck::extended(SubsystemRun made, const SubsystemStep& last, const PartList& rest) {
    const std::vector<std::int64_t> so_far = replayed(parts_.flat(), made).states.back();
    for (const std::uint32_t part : rest) {
        SubsystemResult& other = parts_.search({part});
        const Bdd goal = parts_.timed() ? parts_.interleaving(other).still() : parts_.interleaving(other).ready();
        const FlatRun more = parts_.interleaving(other).moves_on(here(other, so_far), goal);
        made = concatenated(std::move(made), subsystem_run(other, more));
        if (made.loop) return made;
    }
    made.loop = made.steps.size();
    made.steps.push_back(last);
    return made;
}

/// Returns a run in which the parts `parts` move to quiescent states, one part after another.
SubsystemRun InterleavedCheck::settled(const PartList& parts) {
    SubsystemRun made;
    const std::vector<std::int64_t> first = replayed(parts_.flat(), {}).states.back();
    for (const std::uint32_t part : parts) {
        SubsystemResult& other = parts_.search({part});
        const Bdd goal =
            other.check->meaning(other.system, other.system.settled) & parts_.interleaving(other).reached();
        made = concatenated(std::move(made),
                            subsystem_run(other, parts_.interleaving(other).moves_on(here(other, first), goal)));
    }
    return made;
}

/// Combines `run`, a run of the searched parts, with runs of all other parts. If the result would be too long, returns
/// nullopt and adds a note to the verdict.
std::optional<FlatRun> InterleavedCheck::complete_run(const SubsystemResult& search, const FlatRun& run, bool at_stable,
                                                      Verdict& verdict) {
    SubsystemRun shown = subsystem_run(search, run);
    const PartList rest = parts_.others(search.chosen);
    const bool stands = shown.loop && std::all_of(shown.steps.begin() + static_cast<std::ptrdiff_t>(*shown.loop),
                                                  shown.steps.end(), [&](const SubsystemStep& step) {
                                                      return step.kind == (parts_.timed() ? SubsystemStep::Kind::Ends
                                                                                          : SubsystemStep::Kind::Waits);
                                                  });
    const SubsystemStep last = stands ? shown.steps.back() : SubsystemStep{};
    if (stands) {
        shown.steps.resize(*shown.loop);
        shown.loop.reset();
    }
    std::optional<SubsystemRun> made;
    if (parts_.timed()) {
        std::vector<SubsystemRun> waiting_runs;
        for (const std::uint32_t part : rest)
            if (const auto other = parts_.interleaving(parts_.search({part})).waiting_run())
                waiting_runs.push_back(subsystem_run(parts_.search({part}), *other));
        if (waiting_runs.size() == rest.size()) made = side_by_side(shown, waiting_runs, at_stable);
    } else {
        made = concatenated(at_stable ? settled(rest) : SubsystemRun{}, without_waits(shown));
    }
    if (made && stands) made = extended(std::move(*made), last, rest);
    if (made) return replayed(parts_.flat(), *made);
    verdict.notes.emplace_back(
        "no trace is given: with the moves of the other sub-loops, the trace would repeat only after very many steps");
    return {};
}

}  // namespace

SymbolicResult check_symbolic_by_parts(const System& system, const SymbolicOptions& options) {
    if (system.parts.each.size() < 2) return check_symbolic(system, options);
    return InterleavedCheck(system, options).result();
}

}  // namespace grafverif
