// SPDX-License-Identifier: MIT
// Chart analyzer: evaluates the open queries of an analysis on the points of one machine after each instant of the
// search, so that findings are available immediately. An event is possible if the interpreter confirms a run that shows
// it. It is impossible if the complete search has not found it. A query remains open if the event occurs in a cone but
// the chart does not confirm it.
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

// The queries of an analysis, with the results so far.

/// Used in place of a variable if the query does not concern a single variable.
inline constexpr std::size_t no_variable = static_cast<std::size_t>(-1);

struct Query {
    std::string_view code = {};
    std::size_t index = 0;  ///< index of its subject, in the table to which its code refers
    std::string subject = {};
    bool decided = false;
    bool seen_in_part = false;    ///< the event occurs in a part, but the chart has not confirmed it
    std::size_t instants = 0;     ///< for an open query: the number of instants searched without a result
    std::int64_t evolutions = 0;  ///< for a counter: the number of evolutions in which it remains in its range
};

class Queries {
public:
    Queries(const Chart& chart, const Equations& equations, const AnalyseOptions& options);

    /// Returns the query with this subject if it exists and is open, otherwise null.
    Query* open(std::string_view code, std::size_t index);
    bool any_open() const;
    /// True if a query about absorbing regions is open.
    bool any_trap_open() const;
    bool only_traps_open() const;
    const std::vector<Query>& all() const { return all_; }
    /// Removes all queries.
    void drop() { all_.clear(), places_.clear(); }
    /// Transfers the results of parts to the chart. Requires that no run of the chart aborts or is infinite within an
    /// instant.
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

    /// Examines the points that were found since the last call.
    void look();
    /// Reports impossible events. Requires that the search is complete and every instant was examined.
    void conclude();
    /// Reports events that are impossible after some points. The requirements are those of conclude().
    void find_traps();
    /// Reports events that are impossible even if inputs change before every evolution. Requires a search of that type,
    /// although the chart is executed with stability search. No other conclusion may be drawn from its points.
    void conclude_loosely();
    /// Examines the last instant of such a search.
    void search_loosely();
    /// Records in each open query how far it was searched. Never throws BddExhausted.
    void leave() noexcept;
    /// True if the chart did not confirm an instability of a part.
    bool doubtful() const;

private:
    using Step = Id<Chart::Step>;
    using Transition = Id<Chart::Transition>;

    /// An event that is a finding if it occurs at some points.
    struct Event {
        Query* question = nullptr;
        Bdd goal = {};
        bool seen = false;
        /// Returns true if a run shows the event; `seen` contains the new points of the goal.
        std::function<bool(const Bdd& seen)> record = {};
    };
    /// An event whose absence is a finding. `goal` is a set of points, of stable points, or of points directly after an
    /// evolution.
    enum class PointSet { Points, Stable, Landings };
    struct Sign {
        Query* question = nullptr;
        PointSet among = PointSet::Points;
        Bdd goal = {};
        bool seen = false;
    };

    // Events that are possible (chart_analyzer_events.cpp).
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

    // Events that are impossible (chart_analyzer_never.cpp).
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

    // Events that are impossible after some points (chart_analyzer_traps.cpp).

    /// A recurring event: a step is active, a transition is cleared, or a stored value changes.
    struct Passing {
        enum class Kind { Step, Transition, Value } kind = Kind::Step;
        Query* question = nullptr;
        Span origin = {};
        Bdd comes = {};                  ///< the points at which it occurs
        Bdd gone = {};                   ///< the points after which it is impossible for all inputs
        bool again = false;              ///< true if it can occur, cease and occur again
        std::vector<bool> dead_in = {};  ///< for each region: true if it never occurs in the region
    };
    std::vector<Passing> passing();
    bool find_gone(Passing& each, const TerminalRegions& ways, const Bdd& sound, const std::vector<Bdd>& regions) const;
    void not_dead(Query& question) const;
    void report_never_again(const std::vector<Passing>& lost, const TerminalRegions& ways,
                            const std::vector<Bdd>& regions);
    void report_trap(const std::vector<const Passing*>& lost, const Bdd& within, const TerminalRegions& ways,
                     std::set<const Passing*>& told);
    void report_group(const std::vector<const Passing*>& group, const TerminalRegions& ways, const Bdd& goal);
    void report_once(const std::vector<const Passing*>& once, const TerminalRegions& ways);
    void report_regions(const std::vector<Passing>& lost, const TerminalRegions& ways, const Bdd& sound,
                        const Bdd& known, std::size_t regions);
    /// Reports the finding with a shortest path to `goal`. If that fails, the queries remain open.
    void keep_trap(Finding made, const std::vector<const Passing*>& of, const TerminalRegions& ways, const Bdd& goal);
    std::string stays_active(const std::vector<const Passing*>& lost, const Bdd& goal);

    bool searching() const { return options_.mode == ExecutionMode::StabilitySearch; }
    bool seen(const Bdd& points) const { return !(search_.reached() & points).is_false(); }
    /// True if all runs found so far are runs of the complete chart.
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
    /// Shows the finding by a path. Returns false if the interpreter does not confirm it, which is an internal error if
    /// `certain`.
    bool show(Finding& finding, const std::optional<Path>& path, const EvolutionRequirement& demand, std::string shows,
              bool certain);
    bool show(Finding& finding, const Bdd& goal, const EvolutionRequirement& demand, std::string shows) {
        return show(finding, search_.path_to(goal), demand, std::move(shows), certain());
    }
    /// Returns those of `points` whose evolution does not abort; `points` itself if there are none.
    Bdd rather_unbroken(const Bdd& points) const;
    bool keep(Finding finding);

    /// Returns the path to the first of `points`, continued along them.
    std::optional<Path> path_along(const std::vector<Point>& points) const;

    const Chart& chart_;
    const Equations& equations_;
    const AnalyseOptions& options_;
    Machine& machine_;
    PathSearch& search_;
    Queries& questions_;
    Analysis& result_;
    WitnessTrace last_ = {};  ///< the run that showed the last finding
    std::vector<Event> events_ = {};
    std::vector<Sign> signs_ = {};
    std::vector<Query*> uncertain_ = {};  ///< queries whose events occurred but could not be shown
    Bdd stable_ = {}, landings_seen_ = {};
    std::size_t looked_ = 0;
    std::set<const Query*> unseen_ = {};  ///< when the search is complete: the queries whose event did not occur
};

}  // namespace grafverif::analysis
