// SPDX-License-Identifier: MIT
// Computes the state profile by hashing. A hash function maps each field and its value to a pseudorandom number. The
// hash of a state is the sum of the numbers of all fields; the hash of a component (a part or a clock) is the sum of
// the numbers of its fields. The difference of these two hashes is the hash of the *rest*: the state without the
// component. Therefore, one pass over the states computes the hash of the rest of each state, for every component. To
// bound the memory, the hashes are divided into 2^k classes, and only rests of one class are counted. All states with
// the same rest belong to the same class.
#include "check/timed/profile.hpp"

#include <algorithm>
#include <bit>
#include <ranges>
#include <unordered_set>
#include <utility>

#include "syntax/print/chart.hpp"

namespace grafverif::timed {

namespace {

// Approximate maximum number of stored hashes of rests.
constexpr std::size_t most_rests = std::size_t{1} << 21U;
// Maximum number of different component values that are stored, for all components together. Each component may store
// at least 256 values.
constexpr std::size_t most_seen = std::size_t{1} << 20U;

/// Mixing function of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
std::uint64_t mixed(std::uint64_t value) {
    value += 0x9E3779B97F4A7C15U;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31U);
}

struct ProfiledElement {
    std::uint64_t now = 0;  // hash of the component in the current state
    std::uint64_t met = 0;  // number of states whose rest is counted
    std::vector<std::uint64_t> rests = {};
    std::unordered_set<std::uint64_t> values = {};

    void look(std::uint64_t whole, std::uint64_t classes, std::size_t most) {
        if (values.size() < most) values.insert(now);
        const std::uint64_t rest = whole - now;
        if ((rest & (classes - 1)) == 0) rests.push_back(rest);
    }

    StateProfile::Factor factor() {
        const std::uint64_t states = std::max<std::uint64_t>(rests.size(), 1);
        std::ranges::sort(rests);
        const auto repeated = std::ranges::unique(rests);
        rests.erase(repeated.begin(), repeated.end());
        return {states, std::max<std::uint64_t>(rests.size(), 1)};
    }
};

/// A field of a state, with the part and the clock to which the field belongs.
struct ProfiledField {
    static constexpr std::size_t none = ~std::size_t{0};
    Field field = {};
    std::size_t part = none;
    std::size_t clock = none;
};

/// The location field of a controller, and the two locations of the controller in which no cycle is in progress.
struct Waiting {
    Field location = {};
    std::uint32_t waiting = 0, initial = 0;
};

class Profiler {
public:
    Profiler(Graph& graph, std::optional<StateProfile::Finest> finest)
        : graph_(graph), network_(graph.machine.network()) {
        profile_.finest = std::move(finest);
        name_parts();
        for (const Id<Network::Process> process : network_.processes.ids()) add_process(process);
        add_variables();
        elements_.resize(profile_.parts.size() + profile_.clocks.size());
    }

    StateProfile profile(Effort effort) {
        profile_.states = graph_.states();
        const std::uint64_t most = std::uint64_t{1} << (effort == Effort::Brief ? 19U : 25U);
        const std::uint64_t each = columns_.size() + 4 * elements_.size() + 1;
        profile_.sampled = std::min<std::uint64_t>(graph_.states(), most / each);
        const std::uint64_t expected = profile_.sampled * (elements_.size() + 1) / most_rests;
        classes_ = std::bit_ceil(expected + 1);
        profile_.most_combinations = std::max<std::uint64_t>(most_seen / elements_.size(), 256);
        for (std::uint32_t state = 0; state < profile_.sampled; ++state) look(graph_.load(state));
        for (std::size_t i = 0; i < profile_.parts.size(); ++i) {
            profile_.parts[i].combinations = elements_[i].values.size();
            profile_.parts[i].factor = elements_[i].factor();
        }
        for (std::size_t i = 0; i < profile_.clocks.size(); ++i) {
            ProfiledElement& element = elements_[profile_.parts.size() + i];
            profile_.clocks[i].values = element.values.size();
            profile_.clocks[i].factor = element.factor();
        }
        if (profile_.finest) profile_.finest->factor = finer_.factor();
        const auto by_factor = [](const auto& element) { return -element.factor.value(); };
        std::ranges::stable_sort(profile_.parts, {}, by_factor);
        std::ranges::stable_sort(profile_.clocks, {}, by_factor);
        return std::move(profile_);
    }

private:
    using Kind = StateProfile::Kind;

    /// Creates the parts of the profile: one part for each controller with its timers, and one part for each other
    /// process.
    void name_parts() {
        part_of_.assign(network_.processes.size(), ProfiledField::none);
        display_names_ = display_names(network_);
        for (const Network::Controller& controller : network_.controllers) {
            part_of_[controller.process.index] = profile_.parts.size();
            for (const Network::Timer& timer : controller.timers)
                if (timer.process.valid()) part_of_[timer.process.index] = profile_.parts.size();
            add_part(controller.process, Kind::Controller);
            profile_.parts.back().name = controller.words.name;
            waiting_.push_back({graph_.machine.layout().locations[controller.process.index], controller.waiting.index,
                                network_.processes[controller.process].initial.index});
        }
        for (const Id<Network::Process> id : network_.processes.ids()) {
            if (part_of_[id.index] != ProfiledField::none) continue;
            part_of_[id.index] = profile_.parts.size();
            const bool environment = network_.processes[id].kind == Network::ProcessKind::Environment;
            add_part(id, environment ? Kind::Environment : Kind::Instance);
        }
    }

    void add_part(Id<Network::Process> id, Kind kind) {
        const Network::Process& process = network_.processes[id];
        profile_.parts.push_back({.name = process.name, .kind = kind, .origin = process.origin});
    }

    void add_process(Id<Network::Process> id) {
        const Layout& layout = graph_.machine.layout();
        const Network::Template& automaton = network_.templates[network_.processes[id].automaton];
        columns_.push_back({layout.locations[id.index], part_of_[id.index]});
        for (const Id<Network::Clock> clock : automaton.clocks.ids()) {
            const Field& field = layout.clocks[id.index][clock.index];
            if (field.width == 0) continue;
            columns_.push_back({field, part_of_[id.index], profile_.clocks.size()});
            profile_.clocks.push_back({.process = display_names_[id.index], .name = automaton.clocks[clock].name});
            profile_.clocks.back().origin = network_.processes[id].origin;
            find_greatest(network_.processes[id], clock, profile_.clocks.back());
        }
    }

    void find_greatest(const Network::Process& process, Id<Network::Clock> clock, StateProfile::Clock& found) const {
        const auto take = [&](const std::vector<Network::ClockConstraint>& constraints, Span origin) {
            for (const Network::ClockConstraint& constraint : constraints) {
                if (constraint.clock != clock) continue;
                const std::int64_t bound = bound_value(network_, process, constraint.bound);
                if (bound <= found.greatest) continue;
                found.greatest = bound;
                if (origin.source.valid()) found.origin = origin;
            }
        };
        const Network::Template& automaton = network_.templates[process.automaton];
        for (const Network::Location& location : automaton.locations) take(location.invariant, location.origin);
        for (const Network::Edge& edge : automaton.edges) take(edge.constraint, edge.origin);
    }

    /// Assigns a variable to a part if only edges of this part write the variable.
    void add_variables() {
        constexpr std::size_t several = ProfiledField::none - 1;
        std::vector<std::size_t> writer(network_.variables.size(), ProfiledField::none);
        for (const Id<Network::Process> id : network_.processes.ids()) {
            const auto take = [&](const std::vector<Network::Assignment>& assignments) {
                for (const Network::Assignment& assignment : assignments) {
                    std::size_t& part = writer[static_cast<std::size_t>(network_.exprs[assignment.target].value)];
                    if (part == ProfiledField::none) part = part_of_[id.index];
                    else if (part != part_of_[id.index]) part = several;
                }
            };
            const Network::Template& automaton = network_.templates[network_.processes[id].automaton];
            for (const Network::Edge& edge : automaton.edges) take(edge.assignments);
            for (const Network::Procedure& procedure : automaton.procedures) take(procedure.assignments);
        }
        for (const Id<Network::Variable> id : network_.variables.ids()) {
            const Field& field = graph_.machine.layout().variables[id.index];
            if (network_.variables[id].scratch || field.width == 0) continue;
            columns_.push_back({field, writer[id.index] == several ? ProfiledField::none : writer[id.index]});
        }
    }

    /// Converts the value of a clock to the coarser time unit, rounded down.
    Word coarser(Word units) const {
        const StateProfile::Finest& finest = *profile_.finest;
        return units * static_cast<Word>(finest.unit_ms) / static_cast<Word>(finest.coarser_ms);
    }

    void look(const Word* words) {
        for (ProfiledElement& element : elements_) element.now = 0;
        finer_.now = 0;
        std::uint64_t whole = 0;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const ProfiledField& column = columns_[i];
            const std::uint64_t value = mixed(mixed(i) ^ column.field.raw(words));
            whole += value;
            if (column.part != ProfiledField::none) elements_[column.part].now += value;
            if (column.clock == ProfiledField::none) continue;
            elements_[profile_.parts.size() + column.clock].now += value;
            if (profile_.finest) finer_.now += value - mixed(mixed(i) ^ coarser(column.field.raw(words)));
        }
        if (profile_.finest) finer_.look(whole, classes_, 0);
        for (ProfiledElement& element : elements_) element.look(whole, classes_, profile_.most_combinations);
        const bool inside = std::ranges::any_of(waiting_, [&](const Waiting& at) {
            const Word now = at.location.raw(words);
            return now != at.waiting && now != at.initial;
        });
        profile_.inside_cycles += inside ? 1 : 0;
    }

    Graph& graph_;
    const Network& network_;
    StateProfile profile_ = {};
    std::vector<std::size_t> part_of_ = {};        // part of each process
    std::vector<std::string> display_names_ = {};  // name of each process: `3s/X2` for a timer, otherwise its name
    std::vector<Waiting> waiting_ = {};
    std::vector<ProfiledField> columns_ = {};
    std::vector<ProfiledElement> elements_ = {};  // first the parts, then the clocks
    ProfiledElement finer_ = {};  // pseudo-component: its rest is the state with all clocks in the coarser time unit
    std::uint64_t classes_ = 1;
};

}  // namespace

StateProfile profile_of(Graph& graph, std::optional<StateProfile::Finest> finest, Effort effort) {
    return Profiler(graph, std::move(finest)).profile(effort);
}

}  // namespace grafverif::timed
