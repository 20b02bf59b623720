// SPDX-License-Identifier: MIT
#include "grafverif/ir/location_automaton.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace grafverif {

using Location = LocationAutomaton::Location;

namespace {

/// Returns the entries of `all` that leave `location`. Requires that `all` is sorted by `from`.
template <class T>
std::span<const T> leaving(const std::vector<T>& all, Id<Location> location) {
    const auto found = std::ranges::equal_range(all, location, {}, &T::from);
    return {found.begin(), found.end()};
}

struct LocationAutomatonCheck {
    const LocationAutomaton& automaton;
    std::vector<std::string> faults = {};

    void fault(std::string text) { faults.push_back(std::move(text)); }

    void inputs() {
        for (const LocationAutomaton::Input& input : automaton.inputs) {
            if (!is_timer(input)) continue;
            const bool known = input.timed.valid() ? automaton.steps.contains(input.timed) && !input.watched.valid()
                                                   : automaton.stored.contains(input.watched);
            const bool waits = input.rise_ms >= 0 && input.fall_ms >= 0 && input.rise_ms + input.fall_ms > 0;
            if (!known || !waits) fault("timer `" + input.name + "` has no watched element or no duration");
        }
        if (!automaton.exprs.contains(automaton.assumed)) return;
        for (const Id<Expr> leaf : leaves(automaton.exprs, automaton.assumed)) {
            const Id<LocationAutomaton::Input> input{static_cast<std::uint32_t>(automaton.exprs[leaf].value)};
            if (automaton.inputs.contains(input) && is_timer(automaton.inputs[input]))
                fault("the assumption reads a timer");
        }
    }

    void term(Id<Expr> term, std::string_view what) {
        if (!automaton.exprs.contains(term)) return fault(std::string(what) + " is not a term of the automaton");
        for (const Id<Expr> leaf : leaves(automaton.exprs, term)) {
            const Expr& node = automaton.exprs[leaf];
            const auto index = static_cast<std::size_t>(node.value);
            if (node.op != Op::Variable || index >= automaton.inputs.size())
                fault(std::string(what) + " reads something other than an input");
        }
    }

    void condition(Id<Expr> condition, std::string_view what) {
        term(condition, what);
        if (automaton.exprs.contains(condition) && is_false(automaton.exprs, condition))
            fault(std::string(what) + " is never true");
    }

    bool situation(const std::vector<Id<LocationAutomaton::Step>>& situation) {
        const bool known = std::ranges::all_of(
            situation, [&](Id<LocationAutomaton::Step> step) { return automaton.steps.contains(step); });
        if (!known) fault("a situation refers to a step that does not exist");
        if (std::ranges::adjacent_find(situation, std::greater_equal{}) != situation.end())
            fault("the steps of a situation are not in increasing order");
        return known;
    }

    void locations() {
        std::set<std::pair<std::vector<Id<LocationAutomaton::Step>>, std::vector<std::int64_t>>> known;
        if (!automaton.locations.contains(automaton.init)) fault("the location INIT does not exist");
        for (const Id<Location> id : automaton.locations.ids()) {
            const Location& location = automaton.locations[id];
            situation(location.situation);
            if (location.values.size() != automaton.stored.size())
                fault("a location does not have exactly one value per stored variable");
            if (id != automaton.init && !known.emplace(location.situation, location.values).second)
                fault("two locations are identical");
            for (const LocationAutomaton::Emission& emission : location.emissions) {
                if (!automaton.outputs.contains(emission.output))
                    fault("an emission refers to an output that does not exist");
                term(emission.value, "an emission");
                if (automaton.exprs.contains(emission.value) && is_false(automaton.exprs, emission.value))
                    fault("the condition of an emission is never true");
            }
        }
    }

    void evolutions() {
        if (!std::ranges::is_sorted(automaton.evolutions, {}, &LocationAutomaton::Evolution::from))
            fault("the evolutions are not ordered by `from`");
        for (const LocationAutomaton::Evolution& evolution : automaton.evolutions) {
            if (!automaton.locations.contains(evolution.from) || !automaton.locations.contains(evolution.to))
                fault("an evolution refers to a location that does not exist");
            if (evolution.to == automaton.init) fault("an evolution leads to INIT");
            condition(evolution.condition, "the condition of an evolution");
            for (const Id<LocationAutomaton::Input> timer : evolution.restarted)
                if (!automaton.inputs.contains(timer) || !is_timer(automaton.inputs[timer]))
                    fault("an evolution restarts something other than a timer");
            for (const Id<LocationAutomaton::Input> timer : evolution.falling)
                if (!automaton.inputs.contains(timer) || automaton.inputs[timer].fall_ms <= 0)
                    fault("an evolution starts the fall time of an input that is not a timer with a fall time");
        }
    }

    void instabilities() {
        if (!std::ranges::is_sorted(automaton.instabilities, {}, &LocationAutomaton::Instability::from))
            fault("the instabilities are not ordered by `from`");
        for (const LocationAutomaton::Instability& instability : automaton.instabilities) {
            if (!automaton.locations.contains(instability.from))
                fault("an instability refers to a location that does not exist");
            condition(instability.condition, "the condition of an instability");
            if (instability.witness.size() != automaton.inputs.size())
                fault("a witness of instability does not have exactly one value per input");
            if (instability.cycle.empty()) fault("a cycle of instability is empty");
            for (const auto& step : instability.cycle) situation(step);
        }
    }
};

}  // namespace

std::span<const LocationAutomaton::Evolution> evolutions_from(const LocationAutomaton& automaton,
                                                              Id<Location> location) {
    return leaving(automaton.evolutions, location);
}

std::span<const LocationAutomaton::Instability> instabilities_of(const LocationAutomaton& automaton,
                                                                 Id<Location> location) {
    return leaving(automaton.instabilities, location);
}

bool level(const Location& location, const LocationAutomaton::Input& timer) {
    if (timer.timed.valid()) return std::ranges::binary_search(location.situation, timer.timed);
    return location.values[timer.watched.index] != 0;
}

std::string watched_text(const LocationAutomaton& automaton, const LocationAutomaton::Input& timer) {
    return timer.timed.valid() ? "step " + automaton.steps[timer.timed].name : automaton.stored[timer.watched].name;
}

std::string situation_text(const LocationAutomaton& automaton,
                           const std::vector<Id<LocationAutomaton::Step>>& situation) {
    std::string text = "{";
    for (const Id<LocationAutomaton::Step> step : situation) {
        if (text.size() > 1) text += ',';
        text += automaton.steps[step].name;
    }
    return text + '}';
}

std::vector<std::string> verify(const LocationAutomaton& automaton) {
    LocationAutomatonCheck check{automaton};
    check.inputs();
    check.term(automaton.assumed, "the assumption");
    check.locations();
    check.evolutions();
    check.instabilities();
    return std::move(check.faults);
}

}  // namespace grafverif
