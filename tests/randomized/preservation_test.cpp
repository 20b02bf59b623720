// SPDX-License-Identifier: MIT
// Compares statements of verdicts about other models (`valid for every plant`, `valid for the timed loop`) with the
// verdicts of those models, on random loops in each approach, schedule, grain and mode. The test also compares the
// reasons for vacuous verdicts, and the interpreter replays every run of a verdict.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "check/symbolic/symbolic.hpp"
#include "check/timed/timed.hpp"
#include "ir/network_run.hpp"
#include "pipeline/untimed.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "support/random_loop.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif::app {
namespace {

using Verdicts = std::map<std::string, Verdict>;

/// A model and the verdicts of its engine.
struct Untimed {
    std::string name = {};
    ScheduleOptions options = {};
    Grain grain = Grain::Phased;
    std::optional<TransitionSystem> system = {};
    Verdicts verdicts = {};
};

struct Timed {
    std::optional<LoopUnderTest> loop = {};
    Verdicts verdicts = {};
};

std::vector<Untimed> kinds() {
    using enum PlantApproach;
    using enum Schedule;
    std::vector<Untimed> all{{"none", {.plant = None}}, {"constraints", {.plant = Constraints}}};
    for (const bool fairness : {false, true}) {
        const std::string fair = fairness ? ", fair" : "";
        all.push_back({"synchronous" + fair, {.plant = Automata, .schedule = Synchronous, .fairness = fairness}});
        all.push_back({"sequenced" + fair, {.plant = Automata, .schedule = Sequenced, .fairness = fairness}});
        for (const Grain grain : {Grain::Atomic, Grain::Phased})
            for (const TimeModel time : {TimeModel::Abstract, TimeModel::Discrete})
                all.push_back({std::string(time == TimeModel::Discrete ? "discrete " : "interleaved ") +
                                   (grain == Grain::Atomic ? "atomic" : "phased") + fair,
                               {.plant = Automata, .schedule = Interleaved, .time = time, .fairness = fairness},
                               grain});
    }
    return all;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

bool is_liveness(const Verdict& verdict) {
    return verdict.pattern == Pattern::Inevitable || verdict.pattern == Pattern::LeadsTo;
}

/// True if some controller can always take an edge in the repeated part of the run, but never takes
/// one.
bool starves_a_controller(const Network& network, const Run& run) {
    const auto states = replay(network, run);
    if (!run.loop || !states) return false;
    return std::ranges::any_of(network.controllers, [&](const Network::Controller& controller) {
        for (std::size_t i = *run.loop; i < run.moves.size(); ++i) {
            const auto* fire = std::get_if<Fire>(&run.moves[i]);
            if (fire != nullptr && fire->process == controller.process) return false;
            const auto can = [&](const Fire& edge) { return edge.process == controller.process; };
            if (std::ranges::none_of(enabled(network, (*states)[i]), can)) return false;
        }
        return true;
    });
}

/// Limits for one loop, because some models would take too long. The test does not compare properties that are
/// undecided within these limits.
constexpr std::size_t most_bits = 70;
constexpr std::uint64_t most_memory = std::uint64_t{16} << 20U;
constexpr std::chrono::milliseconds time_limit{100};

/// Returns the number of bits in a state of the network.
std::size_t bits(const Network& network) {
    std::size_t count = 0;
    for (const Network::Variable& variable : network.variables)
        if (!variable.scratch)
            count += std::bit_width(static_cast<std::uint64_t>(variable.type.high - variable.type.low));
    for (const Network::Process& process : network.processes)
        count += std::bit_width(network.templates[process.automaton].locations.size() - 1);
    return count;
}

/// Checks the statements about one loop in all models of the loop.
class Trial {
public:
    Trial(Model model, std::optional<ExecutionMode> mode) : model_(std::move(model)), mode_(mode) { add_companions(); }

    /// Returns false if the loop has no models.
    bool run() {
        for (const Grain grain : {Grain::Atomic, Grain::Phased})
            if (!check_timed_loop(grain)) return false;
        untimed_ = kinds();
        for (Untimed& kind : untimed_) check_untimed(kind);
        for (const Untimed& kind : untimed_)
            if (kind.system) try_claims(kind);
        try_grains();
        return true;
    }

    /// Counts, for each statement, how often the other model had the same verdict, and how often it had the opposite
    /// verdict.
    using Tally = std::map<std::string, std::pair<int, int>>;
    static Tally tally;
    static int replayed;

private:
    ClosedLoop& loop() { return model_.loops[{0}]; }

    void add_property(std::string name, Pattern pattern, std::vector<Id<Expr>> operands, bool at_stable) {
        loop().properties.add(
            {.name = std::move(name), .pattern = pattern, .operands = std::move(operands), .at_stable = at_stable});
    }

    /// Adds the properties that determine whether a verdict is vacuous and whether the constraints hold.
    void add_companions() {
        const Table<Property> properties = loop().properties;
        for (const Property& property : properties)
            if (property.pattern == Pattern::LeadsTo)
                add_property(property.name + "_left", Pattern::Reachable, {property.operands[0]}, property.at_stable);
        add_property("settles", Pattern::Reachable, {loop().exprs.constant(true)}, true);
        add_property("no_fair_run", Pattern::Inevitable, {loop().exprs.constant(false)}, false);
        add_property("time_goes_on", Pattern::NoTimelock, {}, false);
        for (const ClosedLoop::Constraint& constraint : loop().constraints)
            add_property("kept_" + constraint.name, Pattern::Always, {constraint.condition}, false);
    }

    std::vector<const Chart*> charts() {
        std::vector<const Chart*> found;
        for (const ClosedLoop::Controller& controller : loop().controllers)
            found.push_back(&model_.charts[controller.chart]);
        return found;
    }

    bool check_timed_loop(Grain grain) {
        Timed& timed = grain == Grain::Atomic ? atomic_ : phased_;
        try {
            timed.loop = composed_loop(model_, {.grain = grain, .mode = mode_});
        } catch (const std::invalid_argument&) {
            return false;
        }
        const Network& network = timed.loop->network;
        if (bits(network) > most_bits) return false;
        const TimedResult result = check_timed(network, {.max_states = 4000});
        for (const Verdict& verdict : result.verdicts) {
            timed.verdicts[verdict.property] = verdict;
            if (verdict.run) expect_replay(disagreement(project(network, *verdict.run), charts()), verdict);
        }
        for (const ModelError& error : result.errors)
            expect_replay(disagreement(project(network, error.run), charts()), {.property = "a fault"});
        Verdict& ranges = timed.verdicts["no_out_of_range"];
        ranges.pattern = Pattern::Never;
        if (result.complete && result.errors.empty()) ranges.outcome = Outcome::Holds;
        if (std::ranges::any_of(result.errors, [&](const ModelError& error) { return is_range(network, error); }))
            ranges.outcome = Outcome::Violated;
        SCOPED_TRACE("the timed loop");
        for (const auto& [name, verdict] : timed.verdicts) try_notes(verdict, timed.verdicts);
        return true;
    }

    /// True if a controller leaves the range of a variable, or divides by zero.
    static bool is_range(const Network& network, const ModelError& error) {
        return error.kind != ModelError::Kind::ActionRace &&
               std::ranges::any_of(network.controllers, [&](const Network::Controller& controller) {
                   return controller.process == error.process;
               });
    }

    void check_untimed(Untimed& kind) {
        SCOPED_TRACE(kind.name);
        const bool interleaved = kind.options.schedule == Schedule::Interleaved;
        for (const ClosedLoop::Controller& controller : loop().controllers)
            if (controller.cycle && !interleaved) return;  // grafverif rejects this combination as `cycle-without-time`
        kind.options.mode = mode_;
        try {
            kind.system = untimed_loop(model_, kind.options, kind.grain);
        } catch (const std::invalid_argument&) {
            return;
        }
        using std::chrono::steady_clock;
        const SymbolicResult result =
            check_symbolic(*kind.system, {.max_memory = most_memory, .deadline = steady_clock::now() + time_limit});
        EXPECT_FALSE(result.fault && result.fault->kind == SystemFault::Kind::DeadEnd);
        for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
            kind.verdicts[result.verdicts[i].property] = result.verdicts[i];
            if (result.runs[i])
                expect_replay(disagreement(project(*kind.system, *result.runs[i]), charts()), result.verdicts[i]);
        }
        for (const auto& [name, verdict] : kind.verdicts) try_notes(verdict, kind.verdicts);
    }

    static void expect_replay(const std::optional<Disagreement>& found, const Verdict& verdict) {
        ++replayed;
        EXPECT_FALSE(found.has_value()) << verdict.property << ": step " << found->move << ": " << found->what;
    }

    static Outcome outcome(const Verdicts& verdicts, const std::string& name) {
        const auto found = verdicts.find(name);
        return found == verdicts.end() ? Outcome::Unknown : found->second.outcome;
    }

    /// Checks the reported reasons why a verdict is vacuous.
    static void try_notes(const Verdict& verdict, const Verdicts& all) {
        for (const std::string& note : verdict.notes) {
            const bool left = has(note, "the premise is never true"), settled = has(note, "no state is quiescent");
            const bool still = has(note, "time does not pass"), unfair = has(note, "no run is fair");
            if (!left && !settled && !still && !unfair) continue;
            const std::string companion = left      ? verdict.property + "_left"
                                          : settled ? "settles"
                                          : still   ? "time_goes_on"
                                                    : "no_fair_run";
            const Outcome needed = unfair ? Outcome::Holds : Outcome::Violated;
            const Outcome found = outcome(all, companion);
            EXPECT_TRUE(found == needed || found == Outcome::Unknown) << verdict.property << ": " << note;
            ++tally[note].first;
        }
    }

    /// Checks the statement `words` of `verdict`: the other model must have the same verdict, or an unknown one.
    static void agree(const std::string& words, const Verdict& verdict, const Verdicts& there,
                      const Network* network = nullptr) {
        const auto found = there.find(verdict.property);
        if (found == there.end() || found->second.outcome == Outcome::Unknown) return;
        const bool same = found->second.outcome == verdict.outcome;
        if (!same && has(words, "run, in") && network != nullptr && found->second.run &&
            starves_a_controller(*network, *found->second.run))
            return;
        ++(same ? tally[words].first : tally[words].second);
        EXPECT_TRUE(same) << verdict.property << " " << word(verdict.outcome) << ": " << words;
    }

    /// Counts a statement that may be true or false, without checking it.
    static void count(const std::string& words, const Verdict& verdict, const Verdicts& there) {
        const Outcome found = outcome(there, verdict.property);
        if (found == Outcome::Unknown) return;
        ++(found == verdict.outcome ? tally[words].first : tally[words].second);
    }

    void try_claims(const Untimed& kind) {
        SCOPED_TRACE(kind.name);
        const ModelOptions options{.grain = kind.grain, .untimed = kind.options};
        const SystemToCheck check{*kind.system, charts(), abstraction_of(options, &loop())};
        std::vector<Verdict> all;
        for (const auto& [name, verdict] : kind.verdicts) all.push_back(verdict);
        const std::vector<std::string> unproven = unproven_faults(*kind.system, all);
        for (const Property& property : kind.system->properties) {
            const auto verdict = kind.verdicts.find(property.name);
            if (verdict == kind.verdicts.end()) continue;
            const std::string words = preservation_text(check, property, verdict->second, unproven);
            if (words.empty()) continue;
            try_claim(kind, words, verdict->second);
        }
    }

    void try_claim(const Untimed& kind, const std::string& words, const Verdict& verdict) {
        const Timed& timed = kind.grain == Grain::Atomic ? atomic_ : phased_;
        const Network& network = timed.loop->network;
        if (words.starts_with("valid for every plant")) {
            const auto kept = [&](const Verdicts& there) {
                return !has(words, "satisfies the constraints") ||
                       outcome(there, "kept_constraint_1") == Outcome::Holds;
            };
            if (kept(atomic_.verdicts)) agree(words, verdict, atomic_.verdicts, &atomic_.loop->network);
            // In a model without time the controllers may be delayed forever.
            for (const Untimed& other : untimed_)
                if (other.grain == Grain::Atomic && other.options.schedule == Schedule::Interleaved &&
                    kept(other.verdicts) &&
                    (other.options.time == TimeModel::Discrete ? !other.options.fairness : !is_liveness(verdict)) &&
                    !(is_liveness(verdict) && loop().controllers.size() > 1))
                    agree(words, verdict, other.verdicts);
        } else if (words.starts_with("valid for the timed loop")) {
            agree(words, verdict, timed.verdicts, &network);
            const std::string grain = kind.grain == Grain::Atomic ? "discrete atomic" : "discrete phased";
            for (const Untimed& other : untimed_)
                if (other.name == grain) agree(words, verdict, other.verdicts);
        } else if (has(words, "only to integer time")) {
            agree(words, verdict, timed.verdicts, &network);
        } else {
            count(words, verdict, words.ends_with("plant") ? atomic_.verdicts : timed.verdicts);
        }
    }

    /// Checks a statement of docs/explanation/semantics.md: a property (always, never, exactly one of) that is
    /// violated in atomic grain, or a state that is reachable, has the same verdict in phased grain.
    void try_grains() {
        for (const auto& [name, verdict] : atomic_.verdicts) {
            const bool of_states = verdict.pattern == Pattern::Always || verdict.pattern == Pattern::Never ||
                                   verdict.pattern == Pattern::ExactlyOneOf;
            const bool carries = (of_states && verdict.outcome == Outcome::Violated) ||
                                 (verdict.pattern == Pattern::Reachable && verdict.outcome == Outcome::Holds);
            if (carries) agree("every atomic run is a phased run", verdict, phased_.verdicts);
        }
    }

    Model model_;
    std::optional<ExecutionMode> mode_;
    Timed atomic_ = {}, phased_ = {};
    std::vector<Untimed> untimed_ = {};
};

Trial::Tally Trial::tally = {};
int Trial::replayed = 0;

TEST(RandomizedPreservation, StatementsAboutOtherModelsHoldThereAndRunsReplay) {
    const int cases = test_size(12);
    int loops = 0;
    for (int seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model = random_loop_asked(random, 14);
        if (seed % 4 == 0) add_task_cycles(model, random);
        std::optional<ExecutionMode> mode;
        if (seed % 3 == 1) mode = ExecutionMode::EveryCycle;
        if (seed % 3 == 2) mode = ExecutionMode::StabilitySearch;
        loops += Trial(std::move(model), mode).run() ? 1 : 0;
        if (testing::Test::HasFailure()) break;
    }
    std::cout << loops << " loops of seeds 1 to " << cases << ", " << Trial::replayed << " runs replayed\n";
    for (const auto& [words, count] : Trial::tally)
        std::cout << "  " << words << ": true " << count.first << " times, false " << count.second << '\n';
    EXPECT_GT(loops, cases / 4);
}

}  // namespace
}  // namespace grafverif::app
