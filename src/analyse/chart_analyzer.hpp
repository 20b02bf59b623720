// SPDX-License-Identifier: MIT
// Chart analyzer: evaluates the open queries of an analysis on the points of one Machine after each instant of the
// search, so that findings are available immediately. An event is possible if the interpreter confirms a run in which
// the event occurs. An event is impossible if a complete search has not found it. A query remains open if its event
// occurs in a cone of influence but the interpreter confirms no run of the chart with this event.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analyse/analyse.hpp"
#include "analyse/evidence.hpp"
#include "analyse/machine.hpp"
#include "analyse/search.hpp"
#include "analyse/terminal_regions.hpp"

namespace grafverif::analysis {

/// Used in place of a variable if the query does not concern a single variable.
inline constexpr std::size_t no_variable = static_cast<std::size_t>(-1);

struct Query {
    std::string_view code = {};
    std::size_t index = 0;  ///< index of the subject in the table to which `code` refers
    std::string subject = {};
    bool decided = false;
    bool seen_in_part = false;    ///< true if the event occurs in a part, but no confirmed run of the chart shows it
    std::size_t instants = 0;     ///< for an open query: the number of instants searched without a result
    std::int64_t evolutions = 0;  ///< for a counter: number of evolutions in which the counter remains in its range
};

/// The queries of an analysis, together with the available results.
class Queries {
public:
    Queries(const Chart& chart, const Equations& equations, const AnalyseOptions& options);

    /// Returns the query with this code and subject if it exists and is open, otherwise nullptr.
    Query* open(std::string_view code, std::size_t index);
    bool any_open() const;
    /// True if a query about absorbing regions is open.
    bool any_trap_open() const;
    bool only_traps_open() const;
    const std::vector<Query>& all() const { return all_; }
    /// Removes all queries.
    void drop() { all_.clear(), places_.clear(); }
    /// Transfers the results of parts to the chart. Requires that no run of the chart aborts, and that every instant of
    /// every run ends.
    void trust_parts();
    void decide(std::string_view code, std::size_t index = 0);

private:
    void add(std::string_view code, std::size_t index, std::string subject);

    std::vector<Query> all_ = {};
    std::map<std::pair<std::string_view, std::size_t>, std::size_t> places_ = {};
};

class ChartAnalyzer {
public:
    /// All arguments must outlive the analyzer.
    ChartAnalyzer(const Chart& chart, const Equations& equations, const AnalyseOptions& options, Machine& machine,
                  PathSearch& search, Queries& questions, Analysis& result);

    /// Evaluates the open queries on the points that were found since the last call.
    void look();
    /// Reports impossible events. Requires that the search is complete and that look() was called after every instant.
    void conclude();
    /// Reports events that cannot occur after some of the reached points. The requirements are the same as for
    /// conclude().
    void find_traps();
    /// Reports events that are impossible even if inputs change before every evolution. Requires a search in which
    /// inputs change before every evolution, and a chart that is executed with stability search.
    /// The search over-approximates the chart, so that it can only show that events are impossible.
    void conclude_loosely();
    /// Evaluates the queries on the last instant of a search in which inputs change before every evolution.
    void search_loosely();
    /// Records in each open query how many instants were searched. Never throws BddExhausted.
    void leave() noexcept;
    /// True if the search found an instability that no run of the chart confirms.
    bool doubtful() const;

private:
    using Step = Id<Chart::Step>;
    using Transition = Id<Chart::Transition>;

    /// An event whose occurrence at some point is a finding.
    struct Event {
        Query* question = nullptr;
        Bdd goal = {};
        bool seen = false;
        /// Returns true if a confirmed run shows the event. `seen` contains the new points at which the event occurs.
        std::function<bool(const Bdd& seen)> record = {};
    };
    /// The set of points at which an event is searched: all points (Points), the stable points (Stable), or the points
    /// directly after an evolution (Landings).
    enum class PointSet { Points, Stable, Landings };
    /// An event whose absence is a finding. The event occurs at the points of `goal` in the set `among`.
    struct Sign {
        Query* question = nullptr;
        PointSet among = PointSet::Points;
        Bdd goal = {};
        bool seen = false;
    };

    // The following functions search for possible events (chart_analyzer_events.cpp).
    void expect_breaks();
    void expect_break(const Machine::FaultCondition& each);
    void expect(std::string_view code, std::size_t index, const Bdd& goal, std::function<bool(const Bdd&)> record);
    void expect_branches();
    void expect_reactivated_steps();
    void expect_forcing();
    void instability();
    void dead_values();
    void dead_value(const Equations::Stored& stored, bool value);
    bool report_fault(std::string_view code, const Machine::FaultCondition& each, const Bdd& points, const Bdd& early);
    bool report_reactivated(Step step, const Bdd& seen);

    // The following functions search for impossible events (chart_analyzer_never.cpp).
    void watch_signs();
    void watch(std::string_view code, std::size_t index, PointSet among, const Bdd& goal);
    void watch_outputs();
    void find_signs();
    bool sign_seen(const Sign& sign);
    bool confirmed(const Bdd& points);
    void confirm_others(const Path& path);
    void gather_unseen();
    bool unseen(std::string_view code, std::size_t index);
    void dead_steps();
    void dead_transitions();
    void dead_transition(Transition id);
    void immediate_transitions();
    void transient_steps();
    void silent_outputs();

    // The following functions search for events that are impossible after some points (chart_analyzer_traps.cpp).

    /// An event that may recur: a step is active, a transition is cleared, or a stored value changes.
    struct Passing {
        enum class Kind { Step, Transition, Value } kind = Kind::Step;
        Query* question = nullptr;
        Span origin = {};
        Bdd comes = {};                  ///< set of points at which the event occurs
        Bdd dead_points = {};            ///< set of points after which the event is impossible for all inputs
        bool again = false;              ///< true if the event can occur, cease and occur again
        std::vector<bool> dead_in = {};  ///< for each absorbing region: true if the event never occurs in the region
    };
    std::vector<Passing> passing();
    bool has_dead_points(Passing& each, const TerminalRegions& terminal, const Bdd& sound,
                         const std::vector<Bdd>& regions) const;
    void mark_live(Query& question) const;
    void report_never_again(const std::vector<Passing>& dead, const TerminalRegions& terminal,
                            const std::vector<Bdd>& regions);
    void report_trap(const std::vector<const Passing*>& dead, const Bdd& within, const TerminalRegions& terminal,
                     std::set<const Passing*>& reported);
    void report_group(const std::vector<const Passing*>& group, const TerminalRegions& terminal, const Bdd& goal);
    void report_once(const std::vector<const Passing*>& once, const TerminalRegions& terminal);
    void report_regions(const std::vector<Passing>& dead, const TerminalRegions& terminal, const Bdd& sound,
                        const Bdd& known, std::size_t regions);
    /// Reports the finding with a shortest path to `goal`. If the interpreter does not confirm the path, the queries
    /// remain open.
    void keep_trap(Finding made, const std::vector<const Passing*>& of, const TerminalRegions& terminal,
                   const Bdd& goal);
    std::string stays_active(const std::vector<const Passing*>& dead, const Bdd& goal);

    bool searching() const { return options_.mode == ExecutionMode::StabilitySearch; }
    bool seen(const Bdd& points) const { return !(search_.reached() & points).is_false(); }
    /// True if every path of this search is a run of the complete chart.
    bool certain() const { return machine_.whole() && search_.evolutions() <= machine_.exact_evolutions(); }
    bool is_uncertain(const Query* question) const;
    bool ever_active(Step step) const;
    Bdd enabled(Transition transition) const;
    Bdd all_active(const std::vector<Step>& steps) const;
    bool covers(const std::vector<Step>& steps) const;
    std::string step_name(Step step) const { return step_variable(chart_, step); }
    std::string false_part(Transition id);
    std::string steps_text(const std::vector<Step>& steps) const;
    const std::string& name(Transition transition) const { return chart_.transitions[transition].name; }

    Finding finding(std::string_view code, std::string subject, std::string message, Span origin) const;
    /// Adds to the finding the run along a path. Returns false if the interpreter does not confirm the run; a run that
    /// is not confirmed is an internal error if `certain` is true.
    bool show(Finding& finding, const std::optional<Path>& path, const EvolutionRequirement& demand, std::string shows,
              bool certain);
    bool show(Finding& finding, const Bdd& goal, const EvolutionRequirement& demand, std::string shows) {
        return show(finding, search_.path_to(goal), demand, std::move(shows), certain());
    }
    /// Returns the points in `points` whose evolution does not abort, or `points` if the evolutions of all points
    /// abort.
    Bdd prefer_unbroken(const Bdd& points) const;
    bool keep(Finding finding);

    /// Returns a path to the first element of `points`, extended by the remaining elements.
    std::optional<Path> path_along(const std::vector<Point>& points) const;

    const Chart& chart_;
    const Equations& equations_;
    const AnalyseOptions& options_;
    Machine& machine_;
    PathSearch& search_;
    Queries& questions_;
    Analysis& result_;
    WitnessTrace last_ = {};  ///< the run that shows the last finding
    std::vector<Event> events_ = {};
    std::vector<Sign> signs_ = {};
    std::vector<Query*> uncertain_ = {};  ///< queries whose events occurred in the search, but without a confirmed run
    Bdd stable_ = {}, landings_seen_ = {};
    std::size_t explored_instants_ = 0;
    std::set<const Query*> unseen_ = {};  ///< after a complete search: the queries whose event did not occur
};

}  // namespace grafverif::analysis
