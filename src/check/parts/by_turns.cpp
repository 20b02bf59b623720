// SPDX-License-Identifier: MIT
#include "check/parts/by_turns.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "check/parts/turn_runs.hpp"
#include "check/parts/turn_searches.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;

class ByTurns {
public:
    ByTurns(const System& system, const SymbolicOptions& options)
        : system_(system), options_(options), parts_(system, options) {}

    SymbolicResult result();

private:
    void answer(Id<Property> id);
    void answer_each(Id<Property> id);
    bool answer_starved(Id<Property> id, Searched& search, Verdict& verdict, const std::vector<const Neighbour*>& rest);
    void give(Id<Property> id, const Verdict& found, Scope scope, std::optional<FlatRun> run);
    void need_whole(Id<Property> id, std::string why) { whole_[id.index] = std::move(why); }
    void search_whole();
    Scope scope(const PartList& chosen, std::string because) const;

    TurnRun turn_run(const Searched& search, const FlatRun& run) const;
    std::optional<FlatRun> whole_run(const Searched& search, const FlatRun& run, bool at_stable, Verdict& verdict);
    TurnRun led_on(TurnRun made, const TurnStep& last, const PartList& rest);
    std::vector<std::int64_t> here(Searched& search, const std::vector<std::int64_t>& whole);
    TurnRun settled(const PartList& parts);

    const System& system_;
    const SymbolicOptions& options_;
    TurnSearches parts_;
    std::vector<std::optional<std::pair<Verdict, std::optional<SystemRun>>>> given_ = {};  ///< per property
    std::map<std::uint32_t, std::string> whole_ = {};  ///< the properties that need the complete system, and the reason
    SymbolicResult result_ = {};
};

SymbolicResult ByTurns::result() {
    given_.resize(system_.properties.size());
    for (std::uint32_t part = 0; part < system_.parts.each.size(); ++part)
        if (parts_.search({part}).result.fault) return check_symbolic(system_, options_);
    for (const Id<Property> id : system_.properties.ids()) {
        if (!parts_.asked(system_.properties[id])) continue;
        try {
            parts_.about_each(system_.properties[id]) ? answer_each(id) : answer(id);
        } catch (const BddExhausted&) {
            need_whole(id, "the interaction of the sub-loops could not be determined");
        }
    }
    parts_.forget();
    result_.bytes = parts_.bytes();
    result_.seconds = parts_.seconds();
    search_whole();
    for (auto& given : given_) {
        if (!given) continue;
        given->first.seconds = result_.seconds;
        result_.verdicts.push_back(std::move(given->first));
        result_.runs.push_back(std::move(given->second));
    }
    return std::move(result_);
}

// -- verdicts ---------------------------------------------------------------------------------------------------------

Scope ByTurns::scope(const PartList& chosen, std::string because) const {
    Scope made{{}, {}, std::move(because)};
    for (const std::uint32_t part : chosen) made.searched.push_back(system_.parts.each[part].name);
    for (const std::uint32_t part : parts_.others(chosen)) made.left_out.push_back(system_.parts.each[part].name);
    return made;
}

void ByTurns::give(Id<Property> id, const Verdict& found, Scope scope, std::optional<FlatRun> run) {
    Verdict verdict = found;
    const Verdict named = verdict_on(id, system_.properties[id]);
    verdict.about = id;
    verdict.property = named.property;
    verdict.pattern = named.pattern;
    verdict.scope = std::move(scope);
    given_[id.index] = {std::move(verdict), run ? std::optional(system_run(parts_.flat(), *run)) : std::nullopt};
}

void ByTurns::answer(Id<Property> id) {
    const Property& property = system_.properties[id];
    const PartList chosen = parts_.reads(property.operands);
    const bool about_states = settled_apart(property.pattern);
    if (chosen == parts_.all()) return need_whole(id, "");
    if (!about_states && !parts_.flat().justice.empty())
        return need_whole(id, "fairness of a run depends on all sub-loops");
    if (property.at_stable && !about_states)
        return need_whole(id, "quiescence at the end of a run depends on all sub-loops");
    if (property.at_stable && system_.settled.valid() &&
        std::ranges::any_of(system_.parts.each, [](const System::Part& part) { return !part.settled.valid(); }))
        return need_whole(id, "quiescence cannot be decomposed into sub-loops");
    Searched& found = parts_.search(chosen);
    if (found.result.fault) return need_whole(id, "they have a model error");
    const auto place = static_cast<std::size_t>(std::ranges::find(found.asked, id) - found.asked.begin());
    Verdict verdict = found.result.verdicts[place];
    if (verdict.outcome == Outcome::Unknown) return give(id, verdict, scope(chosen, ""), {});
    std::vector<const Neighbour*> rest;
    for (const std::uint32_t part : parts_.others(chosen))
        rest.push_back(&parts_.neighbour(part, verdict, property.at_stable));
    if (!parts_.timed() && answer_starved(id, found, verdict, rest)) return;
    const std::string why = parts_.timed() ? objection(verdict, property.at_stable, rest)
                                           : untimed_objection(verdict, property.at_stable, rest);
    if (!why.empty()) return need_whole(id, why);
    std::optional<FlatRun> run;
    if (found.check->runs()[place]) run = whole_run(found, *found.check->runs()[place], property.at_stable, verdict);
    give(id, verdict,
         scope(chosen,
               parts_.timed() ? because(verdict, property.at_stable) : untimed_because(verdict, property.at_stable)),
         std::move(run));
}

/// If time is abstract, a process that moves forever prevents the progress of all others.
bool ByTurns::answer_starved(Id<Property> id, Searched& search, Verdict& verdict,
                             const std::vector<const Neighbour*>& rest) {
    if (claim_of(verdict) != Claim::Unavoidable) return false;
    const auto mover =
        std::ranges::find_if(rest, [](const Neighbour* other) { return other->searched && !other->rests; });
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
        give(id, verdict, scope(search.chosen, "shares nothing with it; the verdict is reached without it"), {});
        return true;
    }
    const FlatRun way =
        symbolic::run_of(model, {symbolic::shortest_way(model, search.check->search_made(), waiting), {}, {}});
    Searched& moving = parts_.search({who});
    const TurnRun made = behind(turn_run(search, way), turn_run(moving, parts_.turns(moving).endless_run()));
    verdict.outcome = Outcome::Violated;
    verdict.vacuous = false;
    verdict.notes = {"`" + (*mover)->name + "` can move forever while the others wait"};
    give(id, verdict, scope(search.chosen, "shares nothing with it and can move forever while it waits"),
         replayed(parts_.flat(), made));
    return true;
}

/// It holds if it holds in each part.
void ByTurns::answer_each(Id<Property> id) {
    std::optional<Verdict> open;
    Verdict holds = verdict_on(id, system_.properties[id]);
    holds.outcome = Outcome::Holds;
    for (const std::uint32_t part : parts_.all()) {
        Searched& found = parts_.search({part});
        const auto place = static_cast<std::size_t>(std::ranges::find(found.asked, id) - found.asked.begin());
        Verdict verdict = found.result.verdicts[place];
        if (verdict.outcome == Outcome::Holds) continue;
        if (verdict.outcome == Outcome::Unknown) {
            open = verdict;
            continue;
        }
        std::vector<const Neighbour*> rest;
        for (const std::uint32_t other : parts_.others({part}))
            rest.push_back(&parts_.neighbour(other, verdict, false));
        if (const std::string why = parts_.timed() ? objection(verdict, false, rest) : ""; !why.empty())
            return need_whole(id, why);
        std::optional<FlatRun> run;
        if (found.check->runs()[place]) run = whole_run(found, *found.check->runs()[place], false, verdict);
        const std::string why = parts_.timed() ? because(verdict, false) : untimed_because(verdict, false);
        return give(id, verdict, scope({part}, why), std::move(run));
    }
    give(id, open.value_or(holds), scope(parts_.all(), ""), {});
}

void ByTurns::search_whole() {
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
        const auto asked = whole_.find(verdict.about.index);
        if (asked == whole_.end()) continue;
        if (const std::string& why = asked->second; !why.empty())
            verdict.notes.push_back("the complete loop was explored: " + why);
        given_[verdict.about.index] = {verdict, std::move(whole.runs[i])};
    }
}

// -- runs -------------------------------------------------------------------------------------------------------------

/// Converts a run of the search to steps of the complete system.
TurnRun ByTurns::turn_run(const Searched& search, const FlatRun& run) const {
    const System& system = search.system;
    const FlatSystem& part = search.check->flat();
    const std::vector<Id<FlatSystem::Variable>> in_whole = variables_in_whole(part, parts_.flat());
    TurnRun made{{}, run.loop};
    const std::size_t steps = run.loop ? run.states.size() : run.states.size() - 1;
    for (std::size_t i = 0; i < steps; ++i) {
        const std::vector<std::int64_t> values = symbol_values(part, run.states[i]);
        TurnStep step{.kind = TurnStep::Kind::Ends};
        if (value_in(system, values, system_.parts.waits) != 0) step.kind = TurnStep::Kind::Waits;
        for (const System::Part& each : system_.parts.each)
            if (value_in(system, values, each.moves) != 0) step.kind = TurnStep::Kind::Moves;
        for (const Id<FlatSystem::Variable> id : part.variables.ids())
            if (part.variables[id].choice) step.choices.emplace_back(in_whole[id.index].index, run.states[i][id.index]);
        made.steps.push_back(std::move(step));
    }
    return made;
}

/// Converts a state of the complete system to one of the search. A variable that belongs to no part (an action race)
/// has a copy in each part: if the error did not occur in the part, the copy has its initial value.
std::vector<std::int64_t> ByTurns::here(Searched& search, const std::vector<std::int64_t>& whole) {
    const std::vector<Id<FlatSystem::Variable>> in_whole = variables_in_whole(search.check->flat(), parts_.flat());
    std::vector<std::int64_t> made;
    for (const Id<FlatSystem::Variable> id : in_whole) made.push_back(whole[id.index]);
    if (parts_.turns(search).reaches(made)) return made;
    const std::vector<std::int64_t> first = replayed(parts_.flat(), {}).states.back();
    const std::vector<std::uint32_t> part_of = parts_of_symbols(system_);
    for (std::size_t symbol = 0; symbol < part_of.size(); ++symbol) {
        const Expr& value = search.check->flat().exprs[search.check->flat().symbols[symbol]];
        if (part_of[symbol] != no_part || value.op != Op::Variable) continue;
        const auto variable = static_cast<std::size_t>(value.value);
        made[variable] = first[in_whole[variable].index];
    }
    return made;
}

/// Continues the run from where the searched subsystems stop: the others move until they have to wait too, or forever.
TurnRun ByTurns::led_on(TurnRun made, const TurnStep& last, const PartList& rest) {
    const std::vector<std::int64_t> so_far = replayed(parts_.flat(), made).states.back();
    for (const std::uint32_t part : rest) {
        Searched& other = parts_.search({part});
        const Bdd goal = parts_.timed() ? parts_.turns(other).still() : parts_.turns(other).ready();
        const FlatRun more = parts_.turns(other).moves_on(here(other, so_far), goal);
        made = behind(std::move(made), turn_run(other, more));
        if (made.loop) return made;
    }
    made.loop = made.steps.size();
    made.steps.push_back(last);
    return made;
}

/// Sequential moves of these parts to quiescent states.
TurnRun ByTurns::settled(const PartList& parts) {
    TurnRun made;
    const std::vector<std::int64_t> first = replayed(parts_.flat(), {}).states.back();
    for (const std::uint32_t part : parts) {
        Searched& other = parts_.search({part});
        const Bdd goal = other.check->meaning(other.system, other.system.settled) & parts_.turns(other).reached();
        made = behind(std::move(made), turn_run(other, parts_.turns(other).moves_on(here(other, first), goal)));
    }
    return made;
}

/// The run combined with runs of the other parts; empty if it would be too long.
std::optional<FlatRun> ByTurns::whole_run(const Searched& search, const FlatRun& run, bool at_stable,
                                          Verdict& verdict) {
    TurnRun shown = turn_run(search, run);
    const PartList rest = parts_.others(search.chosen);
    const bool stands = shown.loop && std::all_of(shown.steps.begin() + static_cast<std::ptrdiff_t>(*shown.loop),
                                                  shown.steps.end(), [&](const TurnStep& step) {
                                                      return step.kind == (parts_.timed() ? TurnStep::Kind::Ends
                                                                                          : TurnStep::Kind::Waits);
                                                  });
    const TurnStep last = stands ? shown.steps.back() : TurnStep{};
    if (stands) {
        shown.steps.resize(*shown.loop);
        shown.loop.reset();
    }
    std::optional<TurnRun> made;
    if (parts_.timed()) {
        std::vector<TurnRun> beside;
        for (const std::uint32_t part : rest)
            if (const auto other = parts_.turns(parts_.search({part})).waiting_run())
                beside.push_back(turn_run(parts_.search({part}), *other));
        if (beside.size() == rest.size()) made = side_by_side(shown, beside, at_stable);
    } else {
        made = behind(at_stable ? settled(rest) : TurnRun{}, without_waits(shown));
    }
    if (made && stands) made = led_on(std::move(*made), last, rest);
    if (made) return replayed(parts_.flat(), *made);
    verdict.notes.emplace_back("no trace is given: with the other sub-loops, it repeats only after very many steps");
    return {};
}

}  // namespace

SymbolicResult check_symbolic_by_parts(const System& system, const SymbolicOptions& options) {
    if (system.parts.each.size() < 2) return check_symbolic(system, options);
    return ByTurns(system, options).result();
}

}  // namespace grafverif
