// SPDX-License-Identifier: MIT
// Analyst: asks the open questions of an analysis about the points of one machine, instant by instant as the search goes
// on, so that what is found is there at once. What comes about is decided by a run that the rules confirm; that something
// never does is decided when the search is done. What a cone shows and the chart does not confirm stays open.
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
#include "analyse/ways.hpp"

namespace grafverif::analysis {

// Questions: everything an analysis asks of a chart, one by one, and what is known of each.

/// In the place of a variable: what is about no single one.
inline constexpr std::size_t no_variable = static_cast<std::size_t>(-1);

struct Question {
    std::string_view code = {};
    std::size_t index = 0;  ///< of what it is about, in the table that its code speaks of
    std::string subject = {};
    bool decided = false;
    bool seen_in_part = false;    ///< a part has what would answer it; the chart did not confirm that it has
    std::size_t instants = 0;     ///< while it is open: in the first so many the answer did not come
    std::int64_t evolutions = 0;  ///< of a counter: in so many evolutions it stays in its range
};

class Questions {
public:
    Questions(const Chart& chart, const Equations& equations, const AnalyseOptions& options);

    /// The question where it is asked and still open, else nothing.
    Question* open(std::string_view code, std::size_t index);
    bool any_open() const;
    /// Whether one of them is open that is about ways back.
    bool any_trap_open() const;
    bool only_traps_open() const;
    const std::vector<Question>& all() const { return all_; }
    /// Nothing is asked any more.
    void drop() { all_.clear(), places_.clear(); }
    /// What a part has, the chart has: no run of it breaks off or goes on for ever.
    void trust_parts();
    void decide(std::string_view code, std::size_t index = 0);

private:
    void add(std::string_view code, std::size_t index, std::string subject);

    std::vector<Question> all_ = {};
    std::map<std::pair<std::string_view, std::size_t>, std::size_t> places_ = {};
};

class Analyst {
public:
    /// Everything outlives the analyst.
    Analyst(const Chart& chart, const Equations& equations, const AnalyseOptions& options, Machine& machine,
            Search& search, Questions& questions, Analysis& result);

    /// Looks at the points that were found since it looked last.
    void look();
    /// Tells what never happens. Requires that the search is done and every instant was looked at.
    void conclude();
    /// Tells what never comes again from some points on. Requires what conclude() does.
    void look_for_traps();
    /// Tells what never happens even where inputs change before every evolution. Requires that the search was of that kind, though
    /// the chart is executed with stability search: what was seen in it means nothing.
    void conclude_loosely();
    /// Looks at the last instant of such a search.
    void look_loosely();
    /// Notes on the questions that are still open how far they were looked into; never ends with BddExhausted.
    void leave() noexcept;
    /// Whether something went on for ever and the chart did not confirm it.
    bool doubtful() const;

private:
    using Step = Id<Chart::Step>;
    using Transition = Id<Chart::Transition>;

    /// Something that comes about in some points: a finding.
    struct Event {
        Question* question = nullptr;
        Bdd goal = {};
        bool seen = false;
        std::function<bool(const Bdd& seen)> tell = {};  ///< whether it is shown; `seen`: the fresh points of the goal
    };
    /// Something whose absence is a finding. `goal` is over points, stable points, or points right after an evolution.
    enum class Among { Points, Stable, Landings };
    struct Sign {
        Question* question = nullptr;
        Among among = Among::Points;
        Bdd goal = {};
        bool seen = false;
    };

    // What can happen (analyst_events.cpp).
    void expect_breaks();
    void expect_break(const Machine::Break& each);
    void expect(std::string_view code, std::size_t index, const Bdd& goal, std::function<bool(const Bdd&)> tell);
    void expect_branches();
    void expect_reactivated_steps();
    void expect_forcing();
    void instability();
    void lost_values();
    void lost_value(const Equations::Stored& stored, bool value);
    bool tell_break(std::string_view code, const Machine::Break& each, const Bdd& points, const Bdd& early);
    bool tell_reactivated(Step step, const Bdd& seen);

    // What never happens (analyst_never.cpp).
    void watch_signs();
    void watch(std::string_view code, std::size_t index, Among among, const Bdd& goal);
    void watch_outputs();
    void look_for_signs();
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

    // What never comes again (analyst_traps.cpp).

    /// Something that comes about: a step is active, a transition is cleared, a stored value changes.
    struct Passing {
        enum class Kind { Step, Transition, Value } kind = Kind::Step;
        Question* question = nullptr;
        Span origin = {};
        Bdd comes = {};                  ///< the points in which it does
        Bdd gone = {};                   ///< the points from which it never does again, whatever the inputs are
        bool again = false;              ///< it can come about, cease and come about again
        std::vector<bool> lost_in = {};  ///< per region: it never comes about there
    };
    std::vector<Passing> passing();
    bool find_gone(Passing& each, const Ways& ways, const Bdd& sound, const std::vector<Bdd>& regions) const;
    void not_lost(Question& question) const;
    void tell_lost(const std::vector<Passing>& lost, const Ways& ways, const std::vector<Bdd>& regions);
    void tell_trap(const std::vector<const Passing*>& lost, const Bdd& within, const Ways& ways,
                   std::set<const Passing*>& told);
    void tell_group(const std::vector<const Passing*>& group, const Ways& ways, const Bdd& goal);
    void tell_once(const std::vector<const Passing*>& once, const Ways& ways);
    void tell_regions(const std::vector<Passing>& lost, const Ways& ways, const Bdd& sound, const Bdd& known,
                      std::size_t regions);
    /// Tells it by a shortest way to `goal`; else the questions stay open.
    void keep_trap(Finding made, const std::vector<const Passing*>& of, const Ways& ways, const Bdd& goal);
    std::string stays_active(const std::vector<const Passing*>& lost, const Bdd& goal);

    bool searching() const { return options_.mode == ExecutionMode::StabilitySearch; }
    bool seen(const Bdd& points) const { return !(search_.reached() & points).is_false(); }
    /// Whether the runs so far are runs of the chart without more ado.
    bool certain() const { return machine_.whole() && search_.evolutions() <= machine_.exact_evolutions(); }
    bool is_uncertain(const Question* question) const;
    bool ever_active(Step step) const;
    Bdd enabled(Transition transition) const;
    Bdd all_active(const std::vector<Step>& steps) const;
    bool covers(const std::vector<Step>& steps) const;
    std::string step_name(Step step) const { return step_variable(chart_, step); }
    std::string steps_text(const std::vector<Step>& steps) const;
    const std::string& name(Transition transition) const { return chart_.transitions[transition].name; }

    Finding finding(std::string_view code, std::string subject, std::string message, Span origin) const;
    /// Shows the finding by a path; false where the rules do not confirm it, which is a failure of ours if they should.
    bool show(Finding& finding, const std::optional<Path>& path, const Demand& demand, std::string shows, bool certain);
    bool show(Finding& finding, const Bdd& goal, const Demand& demand, std::string shows) {
        return show(finding, search_.path_to(goal), demand, std::move(shows), certain());
    }
    /// `points`, or those of them whose evolution does not break off, if there are any.
    Bdd rather_unbroken(const Bdd& points) const;
    bool keep(Finding finding);

    /// The path to the first of `points`, and on along them.
    std::optional<Path> path_along(const std::vector<Point>& points) const;

    const Chart& chart_;
    const Equations& equations_;
    const AnalyseOptions& options_;
    Machine& machine_;
    Search& search_;
    Questions& questions_;
    Analysis& result_;
    Evidence last_ = {};  ///< what the last finding was shown by
    std::vector<Event> events_ = {};
    std::vector<Sign> signs_ = {};
    std::vector<Question*> uncertain_ = {};  ///< events that were seen and not shown
    Bdd stable_ = {}, landings_seen_ = {};
    std::size_t looked_ = 0;
    std::set<const Question*> unseen_ = {};  ///< when the search is done: no sign of them was seen
};

}  // namespace grafverif::analysis
