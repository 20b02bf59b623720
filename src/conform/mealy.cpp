// SPDX-License-Identifier: MIT
#include "conform/mealy.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "conform/input_space.hpp"
#include "support/messages.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

using namespace conform;
using Automaton = LocationAutomaton;
using Location = Automaton::Location;
using State = MealyMachine::State;

/// A place: a location with the elapsed times of its timers. For each level that timers observe, `ages` contains the
/// time since the level became true, capped at the longest rise time, or -1 if the level is false. For each timer with
/// a fall time, `falls` contains the time since the fall, or -1 if the timer is not running.
struct Place {
    Id<Location> location = {};
    std::vector<std::int64_t> ages = {}, falls = {};
    auto operator<=>(const Place&) const = default;
};

/// The successors of a place: the inputs that lead to each next place, and the inputs without a successor.
struct Departures {
    std::map<Place, Bdd> to = {};
    Bdd staying = {};  ///< inputs for which the place is stable; `to` also contains these inputs
    Bdd unstable = {};
    bool operator==(const Departures& other) const { return to == other.to && unstable == other.unstable; }
};

/// A level (Boolean term) that timers observe, represented by the output of one of these timers and the longest of
/// their rise times.
struct Level {
    Automaton::Input watched = {};
    std::int64_t longest = 0;
};
struct Timer {
    Id<Automaton::Input> input = {};
    std::size_t level = 0;
    std::size_t fall = 0;  ///< index in Place::falls, for a timer with a fall time
    std::int64_t rise_ms = 0, fall_ms = 0;
};

class Builder {
public:
    Builder(const Automaton& automaton, const MealyOptions& options, Diagnostics& diagnostics)
        : automaton_(automaton),
          options_(options),
          diagnostics_(diagnostics),
          space_(named(automaton.inputs), {options.max_memory, options.deadline, options.stop}),
          sets_(automaton.exprs, space_),
          conditions_(space_, machine_.exprs) {
        space_.assume(sets_(automaton.assumed));
        for (const Id<Automaton::Input> id : automaton.inputs.ids()) {
            const Automaton::Input& input = automaton.inputs[id];
            if (is_timer(input)) {
                add_timer(id);
                continue;
            }
            machine_.inputs.push_back({input.name, input.type});
            for (const std::uint32_t bit : space_.word(id.index).bits) bits_.push_back(bit);
        }
        std::ranges::sort(bits_);
    }

    std::optional<MealyMachine> machine() {
        machine_.name = automaton_.name;
        machine_.mode = automaton_.mode;
        for (const Automaton::Output& output : automaton_.outputs)
            machine_.outputs.push_back({output.name, output.type});
        machine_.assumed = translate(automaton_.exprs, automaton_.assumed, machine_.exprs, [&](const Expr& leaf) {
            return machine_.exprs.leaf(Op::Variable, static_cast<std::uint32_t>(leaf.value));
        });
        machine_.combinations = small_count(space_.assumed(), bits_);
        begin();
        for (std::size_t next = 0; next < places_.size(); ++next) {
            if (places_.size() > options_.max_states) {
                diagnostics_.add(messages::too_many_states(automaton_.origin, options_.max_states));
                return {};
            }
            if (next % 4096 == 0) stop_if_requested(options_);
            add_transitions(next);
        }
        return std::move(machine_);
    }

private:
    void add_timer(Id<Automaton::Input> id) {
        const Automaton::Input& input = automaton_.inputs[id];
        const auto known = std::ranges::find_if(levels_, [&](const Level& level) {
            return level.watched.timed == input.timed && level.watched.watched == input.watched;
        });
        timers_.push_back(
            {id, static_cast<std::size_t>(known - levels_.begin()), falls_, input.rise_ms, input.fall_ms});
        if (input.fall_ms > 0) ++falls_;
        if (known == levels_.end()) levels_.push_back({input, input.rise_ms});
        else known->longest = std::max(known->longest, input.rise_ms);
    }

    bool active(Id<Location> location, const Level& level) const {
        return grafverif::level(automaton_.locations[location], level.watched);
    }

    /// Returns the place after `evolution`. Elapsed times are taken from `before`, unless the evolution restarts them.
    Place arrival(const Place& before, const Automaton::Evolution& evolution) const {
        Place place{evolution.to, {}, before.falls};
        for (std::size_t k = 0; k < levels_.size(); ++k)
            place.ages.push_back(active(evolution.to, levels_[k]) ? std::max<std::int64_t>(before.ages[k], 0) : -1);
        for (const Timer& timer : timers_) {
            if (std::ranges::find(evolution.restarted, timer.input) != evolution.restarted.end())
                place.ages[timer.level] = 0;
            const bool fell = std::ranges::find(evolution.falling, timer.input) != evolution.falling.end();
            if (fell && (timer.rise_ms == 0 || before.ages[timer.level] >= timer.rise_ms)) place.falls[timer.fall] = 0;
        }
        return place;
    }

    Place place_of_init() const {
        Place place{automaton_.init, {}, std::vector<std::int64_t>(falls_, -1)};
        for (const Level& level : levels_) place.ages.push_back(active(automaton_.init, level) ? 0 : -1);
        return place;
    }

    /// Returns the outputs of the timers in `place` as a cube. All outputs of timers are false before the first cycle.
    Bdd timer_ends(const Place& place) const {
        std::vector<BddLiteral> literals;
        for (const Timer& timer : timers_) {
            const std::int64_t age = place.ages[timer.level];
            const bool risen = age >= timer.rise_ms && age >= 0 && place.location != automaton_.init;
            const bool falling = timer.fall_ms > 0 && place.falls[timer.fall] >= 0;
            literals.push_back({space_.word(timer.input.index).bits.front(), risen || falling});
        }
        return cube(space_.space(), literals);
    }

    Departures departures(const Place& place) {
        Departures result;
        const Bdd ends = timer_ends(place);
        const auto now = [&](const Bdd& set) { return timers_.empty() ? set : cofactor(set, ends); };
        const Bdd assumed = now(space_.assumed());
        Bdd rest = assumed;
        for (const Automaton::Evolution& evolution : evolutions_from(automaton_, place.location)) {
            const Bdd set = now(sets_(evolution.condition)) & assumed;
            if (set.is_false()) continue;
            result.to[arrival(place, evolution)] |= set;
            rest &= ~set;
        }
        for (const Automaton::Instability& instability : instabilities_of(automaton_, place.location))
            result.unstable |= now(sets_(instability.condition)) & assumed;
        rest &= ~result.unstable;
        if (!rest.is_false()) result.to[staying_place(place)] |= rest;
        result.staying = rest;
        return result;
    }

    /// Returns the place in which the controller stays if no event occurs. The location INIT is replaced by the
    /// location with the same situation and values, if such a location exists.
    Place staying_place(const Place& place) const {
        if (place.location != automaton_.init) return place;
        Place same = place;
        for (const Id<Location> id : automaton_.locations.ids())
            if (id != automaton_.init &&
                automaton_.locations[id].situation == automaton_.locations[place.location].situation &&
                automaton_.locations[id].values == automaton_.locations[place.location].values)
                same.location = id;
        return same;
    }

    /// Merges INIT with the location of the initial situation if both are equivalent (JESA13 section 6).
    void begin() {
        const Place init = place_of_init();
        const Departures first = departures(init);
        if (automaton_.mode == ExecutionMode::EveryCycle) {
            if (first.to.size() != 1) {
                machine_.initial = state(init);
                return;
            }
            const Place& place = first.to.begin()->first;
            machine_.initial = state(place);
            for (const auto& [answer, set] : answers(place, space_.assumed()))
                machine_.activation.push_back({conditions_.term(set), answer});
            return;
        }
        for (const auto& [place, set] : first.to) {
            const bool same_situation =
                automaton_.locations[place.location].situation == automaton_.locations[automaton_.init].situation;
            if (!same_situation || place.ages != init.ages || place.falls != init.falls ||
                !(departures(place) == first))
                continue;
            machine_.initial = state(place);
            return;
        }
        machine_.initial = state(init);
    }

    Id<State> state(const Place& place) {
        const auto [known, added] = known_.emplace(place, Id<State>{});
        if (!added) return known->second;
        places_.push_back(place);
        return known->second = machine_.states.add(
                   {situation_text(automaton_, automaton_.locations[place.location].situation), detail(place)});
    }

    std::string detail(const Place& place) const {
        std::string text;
        const auto add = [&text](const std::string& one) { text += (text.empty() ? "" : ", ") + one; };
        if (place.location == automaton_.init) add("INIT");
        const std::vector<std::int64_t>& values = automaton_.locations[place.location].values;
        for (std::size_t k = 0; k < values.size(); ++k)
            add(automaton_.stored[Id<Automaton::Stored>{static_cast<std::uint32_t>(k)}].name + " = " +
                std::to_string(values[k]));
        for (std::size_t k = 0; k < levels_.size(); ++k)
            if (place.ages[k] >= 0 && levels_[k].longest > 0)
                add(level_name(levels_[k]) + " for " + duration_text(place.ages[k]));
        for (const Timer& timer : timers_)
            if (timer.fall_ms > 0 && place.falls[timer.fall] >= 0)
                add(automaton_.inputs[timer.input].name + " for " +
                    duration_text(timer.fall_ms - place.falls[timer.fall]) + " more");
        return text;
    }

    std::string level_name(const Level& level) const {
        if (level.watched.watched.valid()) return automaton_.stored[level.watched.watched].name;
        return "X" + automaton_.steps[level.watched.timed].name;
    }

    void add_transitions(std::size_t index) {
        const Place place = places_[index];
        const Id<State> from{static_cast<std::uint32_t>(index)};
        const Departures now = departures(place);
        for (const auto& [to, set] : now.to) add_transition(from, to, set, 0);
        if (!now.unstable.is_false()) {
            machine_.unstable.push_back({from, conditions_.term(now.unstable)});
            const auto pairs = small_count(now.unstable, bits_);
            machine_.unstable_pairs =
                machine_.unstable_pairs && pairs ? std::optional(*machine_.unstable_pairs + *pairs) : std::nullopt;
        }
        if (place.location != automaton_.init) add_waits(from, place, now.staying);
    }

    /// Adds the transition in which time passes until the next timer event, for the inputs `staying` under which the
    /// place is stable.
    void add_waits(Id<State> from, const Place& place, const Bdd& staying) {
        const std::int64_t wait = next_end(place);
        if (wait == 0 || staying.is_false()) return;
        Place later = place;
        for (std::size_t k = 0; k < levels_.size(); ++k)
            if (later.ages[k] >= 0) later.ages[k] = std::min(later.ages[k] + wait, levels_[k].longest);
        for (const Timer& timer : timers_)
            if (std::int64_t* const fall = timer.fall_ms > 0 ? &later.falls[timer.fall] : nullptr;
                fall != nullptr && *fall >= 0)
                *fall = *fall + wait < timer.fall_ms ? *fall + wait : -1;
        for (const auto& [to, set] : departures(later).to)
            if (const Bdd both = set & staying; !both.is_false()) add_transition(from, to, both, wait);
    }

    /// Returns the time until the next timer event, that is, until a timer output becomes true or a fall time has
    /// elapsed. Returns 0 if no timer is running.
    std::int64_t next_end(const Place& place) const {
        std::int64_t next = 0;
        const auto consider = [&next](std::int64_t wait) { next = next == 0 ? wait : std::min(next, wait); };
        for (const Timer& timer : timers_) {
            const std::int64_t age = place.ages[timer.level];
            if (age >= 0 && age < timer.rise_ms) consider(timer.rise_ms - age);
            if (timer.fall_ms > 0 && place.falls[timer.fall] >= 0) consider(timer.fall_ms - place.falls[timer.fall]);
        }
        return next;
    }

    void add_transition(Id<State> from, const Place& to, const Bdd& set, std::int64_t wait) {
        for (const auto& [answer, part] : answers(to, set))
            machine_.transitions.push_back({from, state(to), conditions_.term(part), answer, wait});
    }

    /// Returns the output words that are written on arrival in `place` under inputs in `set`, each with its inputs.
    std::vector<std::pair<Id<MealyMachine::OutputWord>, Bdd>> answers(const Place& place, const Bdd& set) {
        struct OutputClass {
            Bdd set = {};
            std::vector<std::int64_t> values = {};
        };
        std::vector<OutputClass> parts{{set, std::vector<std::int64_t>(automaton_.outputs.size())}};
        for (const Automaton::Emission& emission : automaton_.locations[place.location].emissions) {
            const Expr& value = automaton_.exprs[emission.value];
            if (is_constant(value.op)) {
                for (OutputClass& part : parts)
                    part.values[emission.output.index] = value.op == Op::Integer ? value.value
                                                         : value.op == Op::True  ? 1
                                                                                 : 0;
                continue;
            }
            Bdd holds = sets_(emission.value);
            if (!timers_.empty()) holds = cofactor(holds, timer_ends(place));
            std::vector<OutputClass> pieces;
            for (OutputClass& part : parts) {
                OutputClass on{part.set & holds, part.values};
                on.values[emission.output.index] = 1;
                part.set &= ~holds;
                if (!on.set.is_false()) pieces.push_back(std::move(on));
                if (!part.set.is_false()) pieces.push_back(std::move(part));
            }
            parts = std::move(pieces);
        }
        std::vector<std::pair<Id<MealyMachine::OutputWord>, Bdd>> result;
        for (OutputClass& part : parts) result.emplace_back(answer(std::move(part.values)), std::move(part.set));
        return result;
    }

    Id<MealyMachine::OutputWord> answer(std::vector<std::int64_t> values) {
        const auto [known, added] = answer_of_.emplace(std::move(values), Id<MealyMachine::OutputWord>{});
        if (added) known->second = machine_.answers.add({known->first});
        return known->second;
    }

    const Automaton& automaton_;
    const MealyOptions& options_;
    Diagnostics& diagnostics_;
    MealyMachine machine_ = {};
    InputSpace space_;
    InputSets sets_;
    Conditions conditions_;
    std::vector<std::uint32_t> bits_ = {};  ///< bits of the inputs of the chart, without timer outputs
    std::vector<Level> levels_ = {};
    std::vector<Timer> timers_ = {};
    std::size_t falls_ = 0;           ///< number of timers with a fall time
    std::vector<Place> places_ = {};  ///< place of each state
    std::map<Place, Id<State>> known_ = {};
    std::map<std::vector<std::int64_t>, Id<MealyMachine::OutputWord>> answer_of_ = {};
};

}  // namespace

std::optional<MealyMachine> mealy_machine(const LocationAutomaton& automaton, const MealyOptions& options,
                                          Diagnostics& diagnostics) {
    try {
        return Builder(automaton, options, diagnostics).machine();
    } catch (const BddExhausted& exhausted) {
        diagnostics.add(limit_reached(exhausted, automaton.origin, options.stop));
        return {};
    }
}

}  // namespace grafverif
