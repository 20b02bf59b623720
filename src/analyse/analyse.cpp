// SPDX-License-Identifier: MIT
#include "analyse/analyse.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "analyse/chart_analyzer.hpp"
#include "analyse/cones.hpp"
#include "analyse/counters.hpp"
#include "analyse/structure.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

namespace {

using namespace analysis;

std::size_t place(const Finding& finding) {
    return static_cast<std::size_t>(std::ranges::find(finding_kinds(), finding.code, &FindingKind::code) -
                                    finding_kinds().begin());
}

void add_structural(const Chart& chart, const Equations& equations, Analysis& result) {
    const std::vector<bool> read = analysis::variables_read(equations);
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        const Chart::Variable& variable = chart.variables[id];
        if (variable.kind != Chart::VariableKind::Input || read[id.index]) continue;
        result.findings.push_back({"input-never-read", Finding::Level::Note, variable.name,
                                   "the chart does not depend on the input `" + variable.name + "`", variable.origin});
    }
    for (const std::vector<Id<Chart::ForcingOrder>>& cycle : analysis::forcing_cycles(chart)) {
        const auto partial = [&](Id<Chart::ForcingOrder> order) {
            return chart.partial_charts[chart.forcing[order].forced].name;
        };
        std::string path = "`" + partial(cycle.back()) + "`";
        for (const Id<Chart::ForcingOrder> order : cycle) path += " forces `" + partial(order) + "`";
        Finding made{"forcing-cycle", Finding::Level::Error, partial(cycle.front()),
                     path + ": forcing orders must not form a cycle", chart.forcing[cycle.front()].origin};
        for (std::size_t k = 1; k < cycle.size(); ++k)
            made.related.push_back({chart.forcing[cycle[k]].origin, "the next forcing order of the cycle is here"});
        result.findings.push_back(std::move(made));
    }
}

/// True if findings with this code describe a model error, which aborts the run: a race, conflicting forcing orders, or
/// a value that is undefined or out of range.
bool is_break(std::string_view code) {
    return code == "action-race" || code == "out-of-range" || code == "no-value" || code == "forced-twice";
}

std::string obstacle_text(const BddExhausted& exhausted, const AnalyseOptions& options) {
    if (exhausted.cause() == BddExhausted::Cause::Stopped) return "stopped before completion";
    return memory_limit_reached(options.max_memory);
}

/// The maximum work on one cone while only queries about absorbing regions are open, as a multiple of
/// AnalyseOptions::first_slice.
constexpr std::uint64_t most_for_paths = 16;

/// Schedules the searches of the cones of influence ("parts") of a chart. The searches are continued in turn, each with
/// a limited amount of work, until no query is open or no search can continue.
class ConeSchedule {
public:
    ConeSchedule(const Chart& chart, const Equations& equations, const AnalyseOptions& options, Analysis& result)
        : chart_(chart),
          equations_(equations),
          options_(options),
          result_(result),
          questions_(chart, equations, options) {
        for (Cone& cone : cones(equations)) parts_.push_back({std::move(cone), options});
        if (has_long_counters()) {
            parts_.push_back({parts_.back().cone, options});
            parts_.back().options.longest_count = std::numeric_limits<std::int64_t>::max();
        }
    }

    void run() {
        for (auto slice = options_.first_slice; questions_.any_open() && continue_searches(slice); slice *= 4)
            if (slice >= most_for_paths * options_.first_slice && questions_.only_traps_open()) {
                obstacle_ = "the search for traps exceeded its work limit";
                break;
            }
        result_.questions = questions_.all().size();
        for (const Query& question : questions_.all())
            if (!question.decided)
                result_.open.push_back(
                    {std::string(question.code), question.subject, question.instants, question.evolutions});
        if (result_.open.empty()) obstacle_.clear();
        else if (obstacle_.empty())
            obstacle_ = "counters are explored up to their thresholds, not over their complete ranges";
        result_.obstacle = obstacle_;
    }

private:
    struct ConeSearch {
        Cone cone = {};
        AnalyseOptions options = {};
        bool loosely = false;  ///< true if the over-approximating search of the part is complete
        bool complete = false, given_up = false, doubtful = false;
        bool paths_known = false;  ///< true if the absorbing regions of the part were determined
    };

    bool has_long_counters() const {
        return std::ranges::any_of(counters(equations_), [&](const std::optional<Counter>& counter) {
            return counter && counter->safe >= options_.longest_count && counter->most > 0;
        });
    }

    bool is_last(const ConeSearch& part) const { return part.options.longest_count != options_.longest_count; }

    /// Continues the search of each part with at most `slice` units of work. Returns false if no search can continue.
    bool continue_searches(std::uint64_t slice) {
        bool any = false;
        for (std::size_t k = 0; k < parts_.size() && questions_.any_open(); ++k) {
            ConeSearch& part = parts_[k];
            if (part.given_up || (part.complete && (part.paths_known || !questions_.any_trap_open()))) continue;
            if (is_last(part) && !parts_[k - 1].complete && !parts_[k - 1].given_up) continue;
            if (stopped_) return false;
            any = true;
            continue_search(k, slice);
            if (contradictory_) return false;
            add_up();
        }
        return any && !stopped_;
    }

    /// Decides further queries if the searches of all cones except the complete chart are complete, and these cones
    /// together contain the complete chart. If such cones contain the complete chart and an instant
    /// of the chart never ends, an instant of at least one cone never ends either.
    void add_up() {
        for (const ConeSearch& part : parts_)
            if (!whole(part) && (!part.complete || part.doubtful)) return;
        if (!all_in_parts()) return;
        questions_.decide("total-instability");
        if (std::ranges::none_of(result_.findings, ends_runs) && !any_break_open()) questions_.trust_parts();
    }

    bool is_over() const {
        return (options_.stop != nullptr && options_.stop->load()) ||
               (options_.deadline && std::chrono::steady_clock::now() >= *options_.deadline);
    }

    bool all_in_parts() const {
        const auto in_parts = [this](Id<Equations::Variable> variable) {
            return std::ranges::any_of(
                parts_, [&](const ConeSearch& part) -> bool { return !whole(part) && part.cone[variable.index]; });
        };
        return std::ranges::all_of(equations_.firings, in_parts, &Equations::Firing::variable) &&
               std::ranges::all_of(equations_.stored, in_parts, &Equations::Stored::variable) &&
               std::ranges::all_of(equations_.previous, in_parts, &Equations::Previous::variable);
    }

    static bool whole(const ConeSearch& part) { return std::ranges::find(part.cone, false) == part.cone.end(); }

    static bool ends_runs(const Finding& finding) {
        return finding.code == "total-instability" || is_break(finding.code);
    }

    bool any_break_open() const {
        return std::ranges::any_of(questions_.all(),
                                   [](const Query& question) { return !question.decided && is_break(question.code); });
    }

    /// Continues the search of part `k`. Under stability search, an over-approximation in which inputs may change
    /// before every evolution is searched first, because its search is less expensive. An event that does not occur in
    /// the over-approximation never occurs in the chart.
    void continue_search(std::size_t k, std::uint64_t slice) {
        ConeSearch& part = parts_[k];
        if (options_.mode == ExecutionMode::StabilitySearch && !part.loosely && !is_last(part)) {
            part.loosely = spend(part, slice, [&](BddSpace& space) { search_loosely(k, space); });
            if (stopped_ || contradictory_ || !questions_.any_open()) return;
            part.given_up = false;
        }
        spend(part, slice, [&](BddSpace& space) { look_at(k, space); });
    }

    /// Executes the function `look` with at most `slice` units of work. Returns true if `look` was completed.
    template <class Look>
    bool spend(ConeSearch& part, std::uint64_t slice, const Look& look) {
        if (is_over()) {
            stopped_ = true;
            obstacle_ = obstacle_text(BddExhausted(BddExhausted::Cause::Stopped), options_);
            return false;
        }
        BddSpace space({options_.max_memory, options_.deadline, options_.stop, slice});
        try {
            look(space);
            result_.bytes = std::max(result_.bytes, space.bytes());
            return true;
        } catch (const BddExhausted& exhausted) {
            const bool in_time =
                exhausted.cause() == BddExhausted::Cause::Stopped && space.work() >= slice && !is_over();
            part.given_up = !in_time || (is_last(part) && !options_.deadline);
            stopped_ = !in_time && exhausted.cause() == BddExhausted::Cause::Stopped;
            if (!in_time) obstacle_ = obstacle_text(exhausted, options_);
        }
        result_.bytes = std::max(result_.bytes, space.bytes());
        return false;
    }

    void search_loosely(std::size_t k, BddSpace& space) {
        Machine machine(equations_, parts_[k].options, parts_[k].cone, space);
        if (is_contradictory(machine)) return;
        PathSearch search(machine, ExecutionMode::EveryCycle, false);
        ChartAnalyzer analyzer(chart_, equations_, options_, machine, search, questions_, result_);
        while (!search.done()) {
            search.next();
            analyzer.search_loosely();
            show_progress(k, search.instants().size());
        }
        analyzer.conclude_loosely();
    }

    bool is_contradictory(const Machine& machine) {
        if (!machine.possible().is_false()) return false;
        result_.findings.push_back({"contradictory-constraints", Finding::Level::Error, "",
                                    "no combination of inputs satisfies all constraints and exclusions",
                                    chart_.origin});
        contradictory_ = true;
        questions_.drop();
        return true;
    }

    void look_at(std::size_t k, BddSpace& space) {
        ConeSearch& part = parts_[k];
        Machine machine(equations_, part.options, part.cone, space);
        if (is_contradictory(machine)) return;
        PathSearch search(machine, options_.mode);
        ChartAnalyzer analyzer(chart_, equations_, options_, machine, search, questions_, result_);
        // The work for finding points (`searching`) and for evaluating the queries on them (`looking`). If the
        // evaluation took more work than the search, the queries are evaluated on the new points later, together with
        // the points of the next instants.
        std::uint64_t searching = 0, looking = 0;
        try {
            while (!search.done()) {
                const std::uint64_t start = space.work();
                search.next();
                result_.instants = std::max(result_.instants, search.instants().size());
                const std::uint64_t found = space.work();
                searching += found - start;
                if (looking <= searching || search.done()) analyzer.look();
                looking += space.work() - found;
                show_progress(k, search.instants().size());
            }
            analyzer.conclude();
        } catch (const BddExhausted&) {
            analyzer.leave();
            throw;
        }
        part.complete = true;
        part.doubtful = analyzer.doubtful();
        if (whole(part) && !part.doubtful) questions_.decide("total-instability");
        analyzer.leave();
        analyzer.find_traps();
        part.paths_known = true;
    }

    void show_progress(std::size_t part, std::size_t instant) const {
        if (!options_.progress) return;
        const auto open =
            std::ranges::count_if(questions_.all(), [](const Query& question) { return !question.decided; });
        options_.progress({questions_.all().size(), static_cast<std::size_t>(open), result_.findings.size(), part + 1,
                           parts_.size(), instant});
    }

    const Chart& chart_;
    const Equations& equations_;
    const AnalyseOptions& options_;
    Analysis& result_;
    Queries questions_;
    std::vector<ConeSearch> parts_ = {};
    std::string obstacle_ = {};
    bool stopped_ = false, contradictory_ = false;
};

/// True if a declaration in the chart that accepts findings about `subject` also accepts a finding about `found`. The
/// subject `H.` belongs to a declaration without subject in the partial chart `H`, which is an
/// instance of a chart; this declaration accepts findings about all elements of `H`.
bool accepts(const Chart& chart, std::string_view subject, std::string_view found) {
    if (subject.empty() || subject == found) return true;
    if (!subject.ends_with('.')) return false;
    return found.starts_with(subject) || std::ranges::any_of(chart.transitions, [&](const Chart::Transition& each) {
               return each.name == found && chart.partial_charts[each.chart].name + '.' == subject;
           });
}

std::string text_of(const Chart::Acceptance& acceptance) {
    const std::string& subject = acceptance.subject;
    if (subject.ends_with('.'))
        return "`accept " + acceptance.code + "` in `" + subject.substr(0, subject.size() - 1) + '`';
    return "`accept " + acceptance.code + (subject.empty() ? "" : " " + subject) + '`';
}

void accept(const Chart& chart, Analysis& result) {
    for (const Chart::Acceptance& acceptance : chart.accepted) {
        bool any = false;
        for (Finding& finding : result.findings) {
            if (finding.code != acceptance.code) continue;
            if (!accepts(chart, acceptance.subject, finding.subject)) continue;
            finding.accepted = acceptance.reason;
            any = true;
        }
        if (!any && result.obstacle.empty()) result.notes.push_back("no finding matches " + text_of(acceptance));
    }
}

void add_notes(const Equations& equations, const AnalyseOptions& options, Analysis& result) {
    result.notes.emplace_back(options.mode == ExecutionMode::StabilitySearch
                                  ? "inputs change only in stable situations (IEC 60848); the cycle time is taken "
                                    "as zero"
                                  : "each cycle samples the inputs and executes one evolution");
    if (!equations.timers.empty() && !options.instability_only)
        result.notes.emplace_back(
            "a path to an earlier situation may require an order of timer "
            "expiries that the durations exclude; traps caused only by "
            "durations are not detected");
    if (std::ranges::any_of(result.findings, is_break, &Finding::code))
        result.notes.emplace_back(
            "the exploration stops at races, contradictory forcing orders, and undefined or out-of-range values; "
            "elements reported as dead are dead in all runs without these errors");
    if (!equations.assumptions.empty() || !options.exclusions.empty())
        result.notes.push_back("inputs are restricted by " + std::to_string(equations.assumptions.size()) +
                               " constraints and " + std::to_string(options.exclusions.size()) + " exclusions");
}

}  // namespace

void sort_findings(std::vector<Finding>& findings) {
    std::ranges::stable_sort(findings, {}, [](const Finding& finding) {
        return std::tuple(finding.level, place(finding), finding.origin.begin, finding.subject);
    });
}

Analysis analyse(const Chart& chart, const Equations& equations, const AnalyseOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    Analysis result;
    result.chart = chart.name;
    result.mode = options.mode;
    add_structural(chart, equations, result);
    ConeSchedule(chart, equations, options, result).run();
    sort_findings(result.findings);
    add_notes(equations, options, result);
    accept(chart, result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace grafverif
