// SPDX-License-Identifier: MIT
#include "pipeline/remedies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <set>
#include <tuple>
#include <utility>

#include "ir/patterns.hpp"
#include "report/settings_text.hpp"

namespace grafverif {

namespace {

using Clock = std::chrono::steady_clock;

/// Maximum number of properties that have a separate trial.
constexpr std::size_t most_single = 3;
/// Value of `--max-states` in the trial with more states. The trial with more states is made only if the limit of the
/// original check was lower.
constexpr std::uint64_t more_states = std::uint64_t{1} << 20U;

/// The options of a trial.
struct Remedy {
    std::string options = {};
    ModelOptions how = {};
    bool timed = true;
    std::vector<std::string> properties = {};
    std::optional<std::uint64_t> states = {};
};

bool is_left_open(const PropertyResult& answer) {
    const Verdict& verdict = answer.verdict;
    const UnknownReason obstacle = verdict.obstacle;
    return verdict.declared && verdict.outcome == Outcome::Unknown &&
           (obstacle == UnknownReason::Bound || obstacle == UnknownReason::Memory ||
            obstacle == UnknownReason::Stopped);
}

/// Returns the value of `--property` that selects the property to which `answer` belongs.
std::string selection(const PropertyResult& answer) {
    const std::string family = family_of(answer);
    return family.empty() ? answer.verdict.property : family;
}

class Trials {
public:
    Trials(const LimitedCheck& check, const Report& report) : check_(check), report_(report) {
        std::set<std::string> others;
        for (const PropertyResult& answer : report.answers) {
            const std::string name = selection(answer);
            if (!is_left_open(answer)) others.insert(name);
            else if (std::ranges::find(open_, name) == open_.end()) open_.push_back(name);
            if (is_left_open(answer)) results_.insert(answer.verdict.property);
        }
        std::erase_if(others, [&](const std::string& name) { return std::ranges::find(open_, name) != open_.end(); });
        is_part_ = !others.empty();
    }

    std::vector<Trial> until(const Deadline& end) {
        const std::vector<Remedy> all = remedies();
        std::vector<Trial> trials;
        for (std::size_t i = 0; i < all.size() && !is_over(end, check_.options.limits.stop); ++i)
            if (auto trial = tried(all[i], share_of(end, all.size() - i))) trials.push_back(std::move(*trial));
        std::ranges::stable_sort(trials, {}, [](const Trial& trial) {
            return std::tuple(-static_cast<std::ptrdiff_t>(trial.decided.size()),
                              trial.decided.empty() ? 0 : trial.seconds);
        });
        return trials;
    }

private:
    const ClosedLoop& loop() const { return check_.model.loops[check_.loop]; }

    /// Returns `options`, extended by `--property` for each of `properties`. No option is added if `properties`
    /// contains all properties of the original check.
    std::string with_properties(std::string options, const std::vector<std::string>& properties) const {
        if (!is_part_ && properties.size() == open_.size()) return options;
        for (const std::string& name : properties) options += (options.empty() ? "--property " : " --property ") + name;
        return options;
    }

    std::vector<Remedy> remedies() const {
        std::vector<Remedy> all;
        const auto add = [&](std::string options, const auto& change) {
            Remedy remedy{{}, check_.how, check_.timed, open_, check_.options.limits.states};
            change(remedy);
            remedy.options = with_properties(std::move(options), remedy.properties);
            if (!remedy.options.empty()) all.push_back(std::move(remedy));
        };
        const Schedule schedule = check_.how.untimed.schedule.value_or(loop().schedule.value_or(Schedule::Interleaved));
        const bool automata = check_.how.untimed.plant == PlantApproach::Automata;
        const bool has_grain = check_.timed || (automata && schedule == Schedule::Interleaved);
        const bool phased = check_.how.grain.value_or(loop().grain) == Grain::Phased;
        const bool few_states = check_.timed && check_.options.limits.states.value_or(more_states) < more_states;
        if (few_states)
            add(fmt::format("--max-states {}", more_states), [](Remedy& remedy) { remedy.states = more_states; });
        if (!check_.by_default_engine) add(check_.timed ? "--engine timed" : "--engine auto", [](Remedy&) {});
        if (check_.timed)
            add(schedule == Schedule::Interleaved ? "--untimed --plant automata" : "--untimed --schedule interleaved",
                [](Remedy& remedy) {
                    remedy.timed = false;
                    remedy.how.untimed.plant = PlantApproach::Automata;
                    remedy.how.untimed.schedule = Schedule::Interleaved;
                });
        if (has_grain && phased) add("--grain atomic", [](Remedy& remedy) { remedy.how.grain = Grain::Atomic; });
        for (std::size_t i = 0;
             i < std::min(open_.size(), most_single) && !few_states && (is_part_ || open_.size() > 1); ++i) {
            const auto alone = [&](Remedy& remedy) { remedy.properties = {open_[i]}; };
            add("", alone);
            if (has_grain && phased)
                add("--grain atomic", [&](Remedy& remedy) {
                    alone(remedy);
                    remedy.how.grain = Grain::Atomic;
                });
        }
        return all;
    }

    std::optional<Trial> tried(const Remedy& remedy, const Deadline& end) const {
        CheckOptions options = check_.options;
        options.properties = remedy.properties;
        options.witnesses = options.every_move = options.profile = false;
        options.many = {};
        options.limits.deadline = end;
        options.limits.states = remedy.states;
        Diagnostics ignored;
        const Clock::time_point begin = Clock::now();
        std::optional<Report> found;
        try {
            found = remedy.timed ? grafverif::check(check_.model, check_.loop, remedy.how, options, ignored)
                                 : check_untimed(check_.model, check_.loop, remedy.how, options, ignored);
        } catch (const std::bad_alloc&) {  // only the trial fails; the results of the check remain valid
            found = Report{};
        }
        if (!found || !found->failures.empty()) return {};
        Trial trial{remedy.options, {}, std::chrono::duration<double>(Clock::now() - begin).count()};
        for (PropertyResult answer : found->answers) {
            if (answer.verdict.outcome == Outcome::Unknown || !results_.contains(answer.verdict.property)) continue;
            if (check_.timed && remedy.timed && found->settings.grain != report_.settings.grain)
                answer.preservation = grain_text(answer);
            if (!remedy.timed && !answer.preservation.starts_with("valid ")) continue;
            if (!check_.timed && found->settings.grain != report_.settings.grain)
                answer.preservation = "for grain atomic: " + answer.preservation;
            answer.trace.reset();
            trial.decided.push_back(std::move(answer));
        }
        return trial;
    }

    /// Returns text that states whether a verdict for grain atomic (a PLC cycle is one move) is also valid for grain
    /// phased (reading, evolution and writing are separate moves). A verdict that a run proves is also valid for grain
    /// phased, because each run in grain atomic is also a run in grain phased. Properties with observers are excluded,
    /// because an observer reads more states in grain phased.
    std::string grain_text(const PropertyResult& answer) const {
        const auto property = std::ranges::find(loop().properties, selection(answer), &Property::name);
        if (property == loop().properties.end()) return "applies only to grain atomic";
        const bool about_state = is_about_single_states(property->pattern);
        const bool has_run = answer.verdict.outcome == Outcome::Holds
                                 ? is_about_existence(property->pattern)
                                 : about_state && property->pattern != Pattern::Reachable;
        return has_run ? "valid for grain phased" : "applies only to grain atomic";
    }

    const LimitedCheck& check_;
    const Report& report_;
    std::vector<std::string> open_ = {};  // values of `--property` that select the undecided properties
    std::set<std::string> results_ = {};  // names of the undecided verdicts
    bool is_part_ = false;                // true if the check decided some properties
};

}  // namespace

bool needs_remedies(const Report& report) {
    return report.failures.empty() && report.error_traces.empty() && std::ranges::any_of(report.answers, is_left_open);
}

std::vector<Trial> tried_remedies(const LimitedCheck& check, const Report& report, Deadline end) {
    if (is_over(end, check.options.limits.stop)) return {};
    // Each trial composes the network again, and the composition ignores the deadline. Therefore the composition is
    // measured, and three times its duration is subtracted from the time for the trials.
    const Clock::time_point begin = Clock::now();
    Diagnostics ignored;
    try {
        if (!network_of(check.model, check.loop, check.how, ignored)) return {};
    } catch (const std::bad_alloc&) {
        return {};
    }
    const Clock::duration composing = Clock::now() - begin;
    if (end) *end -= 3 * composing;
    return Trials(check, report).until(end);
}

Clock::duration trial_time(const Deadline& deadline) {
    constexpr std::chrono::seconds most(6);
    const Clock::time_point now = Clock::now();
    if (!deadline || *deadline <= now) return {};
    return std::min<Clock::duration>((*deadline - now) / 10, most);
}

Deadline end_of_trials(const Deadline& deadline, Clock::duration time, Clock::duration used) {
    constexpr std::chrono::seconds least(2), most(10);
    if (time == Clock::duration{}) time = std::clamp<Clock::duration>(used / 10, least, most);
    const Clock::time_point end = Clock::now() + time;
    return deadline ? std::min(*deadline, end) : end;
}

}  // namespace grafverif
