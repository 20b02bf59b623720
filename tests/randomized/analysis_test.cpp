// SPDX-License-Identifier: MIT
// Compares the analysis with an explicit search that uses neither equations nor decision diagrams: the interpreter
// visits all points of a random chart. An instant is a time at which inputs or timers change and the chart evolves. A
// point is a state of the chart during an instant; a rest is a state in which an instant ends. The
// analysis and the search model time in the same way: between two instants, the timers that watch
// the same step may expire, in the order of their durations.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <map>
#include <optional>
#include <set>

#include "analyse/analyse.hpp"
#include "analyse/cones.hpp"
#include "analyse/order.hpp"
#include "derive/derive.hpp"
#include "run/interpreter.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

constexpr std::size_t most_points = 4000;

/// Maps every possible statement of an analysis, written as `code subject`, to the first instant in which its event
/// occurs. An event that never occurs has no entry.
using Facts = std::map<std::string, std::size_t>;
using Rest = std::pair<State, std::vector<bool>>;  ///< end state of an instant, and outputs of its time conditions

struct RestOrder {
    static auto key(const Rest& rest) {
        std::vector<bool> levels;
        for (const Timing& timing : rest.first.timing) levels.push_back(timing.risen >= 0);
        return std::tuple(rest.first.situation, rest.first.values, rest.first.previous, levels, rest.second);
    }
    bool operator()(const Rest& left, const Rest& right) const { return key(left) < key(right); }
};

/// The graph of the points of a chart and of the rests between its instants, with the events at each node and its
/// successors.
struct PointGraph {
    struct Node {
        std::set<std::string> comes = {};
        std::vector<std::size_t> next = {};
        bool unknown = false;                  ///< the run aborts at this node, or its instant does not end
        std::optional<std::size_t> ends = {};  ///< at a rest, the first instant that ends in it
    };
    std::vector<Node> nodes = {};

    template <class Is>
    std::vector<bool> leading_to(const Is& is) const {
        std::vector<std::vector<std::size_t>> before(nodes.size());
        std::vector<bool> found(nodes.size());
        std::vector<std::size_t> open;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            for (const std::size_t next : nodes[k].next) before[next].push_back(k);
            if (is(k)) found[k] = true, open.push_back(k);
        }
        while (!open.empty()) {
            const std::size_t k = open.back();
            open.pop_back();
            for (const std::size_t each : before[k])
                if (!found[each]) found[each] = true, open.push_back(each);
        }
        return found;
    }
    std::vector<bool> leading_to(const std::string& what) const {
        return leading_to([&](std::size_t k) { return nodes[k].comes.contains(what); });
    }
    /// Returns, for each rest, true if the event never occurs again after it. If `broken`, the event may occur again
    /// after unexplored points.
    std::vector<bool> dead_points(const std::string& what, bool broken) const {
        std::vector<bool> found =
            leading_to([&](std::size_t k) { return nodes[k].comes.contains(what) || (broken && nodes[k].unknown); });
        for (std::size_t k = 0; k < nodes.size(); ++k) found[k] = nodes[k].ends && !found[k];
        return found;
    }
    bool comes_again(const std::string& what, bool step) const {
        const std::vector<bool> back = leading_to(what);
        for (const Node& node : nodes)
            for (const std::size_t next : node.next)
                if (node.comes.contains(what) && back[next] && !(step && nodes[next].comes.contains(what))) return true;
        return false;
    }
    /// Returns the terminal sets of nodes, which no run leaves. A node from which a run can abort belongs to no set.
    std::vector<std::vector<bool>> regions() const {
        std::vector<bool> done = leading_to([&](std::size_t k) { return nodes[k].unknown; });
        std::vector<std::vector<bool>> found;
        for (std::size_t start = 0; start < nodes.size(); ++start) {
            if (done[start] || !nodes[start].ends) continue;
            std::vector<bool> onward(nodes.size());
            std::vector<std::size_t> open{start};
            onward[start] = true;
            while (!open.empty()) {
                const std::size_t k = open.back();
                open.pop_back();
                for (const std::size_t next : nodes[k].next)
                    if (!onward[next]) onward[next] = true, open.push_back(next);
            }
            const std::vector<bool> back = leading_to([&](std::size_t k) { return k == start; });
            bool closed = true;
            for (std::size_t k = 0; k < nodes.size(); ++k) closed = closed && (!onward[k] || back[k]);
            if (closed) found.push_back(onward);
            for (std::size_t k = 0; k < nodes.size(); ++k) done[k] = done[k] || (closed ? back[k] : k == start);
        }
        return found;
    }
};

class ExplicitSearch {
public:
    ExplicitSearch(const Chart& chart, ExecutionMode mode) : chart_(chart), mode_(mode) {
        for (const Id<Chart::Variable> id : chart.variables.ids())
            if (chart.variables[id].kind == Chart::VariableKind::Input) inputs_.push_back(id);
        for (const Id<Chart::Transition> id : chart.transitions.ids()) always_.insert(name(id));
    }

    const PointGraph& graph() const { return graph_; }

    /// Returns the first instant of each statement, or nothing if there are too many points, or if a condition is
    /// undefined at one of them.
    std::optional<Facts> facts() {
        for_each_input([&](const std::vector<std::int64_t>& inputs) {
            begin({power_on(chart_), std::vector<bool>(elements_.size())}, inputs, add_node());
        });
        while (!open_.empty() && points_ < most_points && !undefined_) {
            const Rest rest = std::move(open_.front().first);
            instant_ = open_.front().second + 1;
            open_.pop_front();
            const std::size_t node = known_.at(rest);
            for_each_end(rest, 0, [&](const Rest& later) {
                for_each_input([&](const std::vector<std::int64_t>& inputs) {
                    const std::size_t next = add_node();
                    graph_.nodes[node].next.push_back(next);
                    begin(later, inputs, next);
                });
            });
        }
        if (!open_.empty() || undefined_) return {};
        for (const Id<Chart::Step> id : chart_.steps.ids())
            if (!active_.contains(id.index)) note("step-never-active " + step_variable(chart_, id));
        for (const Id<Chart::Transition> id : chart_.transitions.ids()) {
            if (!fired_.contains(name(id))) note("transition-never-fired " + name(id));
            else if (always_.contains(name(id))) note("transition-always-fired " + name(id));
        }
        return facts_;
    }

private:
    void note(const std::string& fact) { facts_.try_emplace(fact, instant_); }
    const std::string& name(Id<Chart::Transition> id) const { return chart_.transitions[id].name; }

    template <class Visit>
    void for_each_input(const Visit& visit) {
        std::vector<std::int64_t> values(chart_.variables.size());
        for (const auto id : inputs_) values[id.index] = chart_.variables[id].type.low;
        for (bool more = true; more;) {
            visit(values);
            more = false;
            for (const auto id : inputs_) {
                more = ++values[id.index] <= chart_.variables[id].type.high;
                if (more) break;
                values[id.index] = chart_.variables[id].type.low;
            }
        }
    }

    /// Returns the term that element k watches: a step, or another term.
    std::pair<bool, std::size_t> watched(std::size_t k) const {
        const TimedElement& element = elements_[k];
        if (element.step.valid()) return {true, element.step.index};
        const Expr& node = chart_.exprs[element.watched];
        if (node.op == Op::Step) return {true, static_cast<std::size_t>(node.value)};
        return {false, element.watched.index};
    }

    static bool level(const State& state, std::size_t k) { return state.timing[k].risen >= 0; }

    /// True if the timers of one watched term expire in the order of their durations, and timers with equal durations
    /// expire together.
    bool in_order(const Rest& rest) const {
        for (std::size_t i = 0; i < elements_.size(); ++i)
            for (std::size_t j = 0; j < elements_.size(); ++j) {
                const TimedElement &one = elements_[i], &other = elements_[j];
                if (watched(i) != watched(j) || one.fall_ms != other.fall_ms) continue;
                const bool implied = one.rise_ms == other.rise_ms || (one.fall_ms == 0 && one.rise_ms < other.rise_ms);
                if (implied && rest.second[j] && !rest.second[i]) return false;
            }
        return true;
    }

    template <class Visit>
    void for_each_end(Rest rest, std::size_t k, const Visit& visit) {
        if (k == rest.second.size()) {
            if (in_order(rest)) visit(rest);
            return;
        }
        for_each_end(rest, k + 1, visit);
        const TimedElement& element = elements_[k];
        const bool high = level(rest.first, k);
        const bool may_end = element.fall_ms > 0 && (element.rise_ms > 0 || !high);
        if (rest.second[k] ? !may_end : !high) return;
        rest.second[k] = !rest.second[k];
        for_each_end(rest, k + 1, visit);
    }

    std::size_t add_node() {
        graph_.nodes.emplace_back();
        return graph_.nodes.size() - 1;
    }

    void note_graph(std::size_t node, const State& before, const Evolution* made) {
        std::set<std::string>& comes = graph_.nodes[node].comes;
        for (const Id<Chart::Step> id : chart_.steps.ids())
            if (before.situation[id.index]) comes.insert(step_variable(chart_, id));
        if (made == nullptr) return;
        for (const auto fired : made->fired) comes.insert(name(fired));
        for (const Id<Chart::Variable> id : chart_.variables.ids())
            if (chart_.variables[id].kind != Chart::VariableKind::Input &&
                made->state.values[id.index] != before.values[id.index])
                comes.insert(chart_.variables[id].name);
    }

    /// Explores one instant, which begins at a node.
    void begin(Rest at, const std::vector<std::int64_t>& inputs, std::size_t node) {
        std::set<Rest, RestOrder> seen;
        for (std::size_t next = node; !undefined_; node = next) {
            ++points_;
            note_situation(at.first);
            const bool first = !at.first.started;
            const Evolution made = evolve(chart_, at.first, inputs, at.second);
            if (!first) note_evolution(at.first, made);
            const bool breaks = made.race || made.fault;
            note_graph(node, at.first, first || breaks ? nullptr : &made);
            graph_.nodes[node].unknown = breaks;
            if (made.race) note("action-race " + chart_.variables[made.race->variable].name);
            if (made.fault) return note_fault(*made.fault);
            if (made.race) return;
            const bool ends = !first && made.stable && mode_ == ExecutionMode::StabilitySearch;
            if (!ends && !first && !seen.insert(at).second) {
                note("total-instability");
                graph_.nodes[node].unknown = true;
                return;
            }
            at.first = made.state;
            for (std::size_t k = 0; k < at.second.size(); ++k) {
                if (elements_[k].fall_ms == 0) at.second[k] = at.second[k] && level(at.first, k);
                if (elements_[k].rise_ms == 0) at.second[k] = at.second[k] || level(at.first, k);
            }
            // A stable evolution may change levels that timers watch.
            if (ends || mode_ == ExecutionMode::EveryCycle) return rest(at, node);
            next = add_node();
            graph_.nodes[node].next.push_back(next);
        }
    }

    void rest(const Rest& at, std::size_t node) {
        const auto [place, fresh] = known_.try_emplace(at, graph_.nodes.size());
        if (fresh) {
            open_.emplace_back(at, instant_);
            note_graph(add_node(), at.first, nullptr);
            graph_.nodes.back().ends = instant_;
        }
        graph_.nodes[node].next.push_back(place->second);
    }

    void note_fault(const RunFault& fault) {
        if (fault.kind == RunFault::Kind::OutOfRange) note("out-of-range " + chart_.variables[fault.variable].name);
        undefined_ = undefined_ || fault.kind == RunFault::Kind::NoValue;
    }

    void note_situation(const State& state) {
        for (const Id<Chart::Step> id : chart_.steps.ids())
            if (state.situation[id.index]) active_.insert(id.index);
    }

    void note_evolution(const State& before, const Evolution& made) {
        std::vector<bool> on(chart_.steps.size()), off(chart_.steps.size());
        for (const auto first : made.fired) {
            fired_.insert(name(first));
            for (const auto step : chart_.transitions[first].to) on[step.index] = true;
            for (const auto step : chart_.transitions[first].from) off[step.index] = true;
            for (const auto second : made.fired)
                for (const auto step : chart_.transitions[first].from)
                    if (first.index < second.index && std::ranges::count(chart_.transitions[second].from, step) > 0)
                        note("branches-together " + name(first));
        }
        for (const Id<Chart::Step> id : chart_.steps.ids())
            if (before.situation[id.index] && on[id.index] && !off[id.index])
                note("step-reactivated " + step_variable(chart_, id));
        for (const Id<Chart::Transition> id : chart_.transitions.ids()) {
            const bool enabled = std::ranges::all_of(chart_.transitions[id].from, [&](Id<Chart::Step> step) -> bool {
                return before.situation[step.index];
            });
            if (enabled && std::ranges::find(made.fired, id) == made.fired.end()) always_.erase(name(id));
        }
    }

    const Chart& chart_;
    ExecutionMode mode_;
    std::vector<TimedElement> elements_ = timed_elements(chart_);
    std::vector<Id<Chart::Variable>> inputs_ = {};
    std::set<std::uint32_t> active_ = {};
    std::set<std::string> fired_ = {}, always_ = {};
    std::map<Rest, std::size_t, RestOrder> known_ = {};  ///< maps each rest to its node
    PointGraph graph_ = {};
    std::deque<std::pair<Rest, std::size_t>> open_ = {};  ///< pairs of a rest and its instant, by increasing instant
    std::size_t instant_ = 1;
    std::size_t points_ = 0;
    bool undefined_ = false;
    Facts facts_ = {};
};

bool is_compared(const std::string& code) {
    return code != "input-never-read" && code != "output-never-set" && code != "step-never-stable" &&
           code != "action-conflict" && code != "comes-once" && !is_trap(code) && !code.starts_with("forc");
}

/// True if another expected fact may mask `fact`, because the interpreter reports only one fault if an evolution has
/// several races or values out of range.
bool masked(const std::string& fact, const Facts& expected) {
    const std::string code = fact.substr(0, fact.find(' ') + 1);
    return (code == "action-race " || code == "out-of-range ") &&
           std::ranges::any_of(expected, [&](const auto& other) { return other.first.starts_with(code); });
}

/// Limits of the analysis of a chart.
struct Bounds {
    int looks = -1;  ///< number of instants after which the analysis of a part of the chart stops; negative: no limit
    std::int64_t longest_count = 256;
};

std::string fact_of(const std::string& code, const std::string& subject) {
    return code + (subject.empty() ? "" : " " + subject);
}

/// Returns the errors in the open queries, which the analysis did not decide: the analysis must
/// find each event that occurs in the instants that it searched. An open query is not wrong if a
/// finding with the same code and subject exists, because several queries can have the same
/// subject.
std::string wrongly_open(const Analysis& analysis, const Facts& expected, const std::set<std::string>& found) {
    std::string text;
    for (const OpenQuestion& question : analysis.open) {
        const bool never =
            question.code.find("-never-") != std::string::npos || question.code.find("-always-") != std::string::npos;
        const auto fact = expected.find(fact_of(question.code, question.subject));
        if (never || fact == expected.end() || found.contains(fact->first) || fact->second > question.instants)
            continue;
        text += "reported as impossible in the first " + std::to_string(question.instants) +
                " instants: " + fact->first + '\n';
    }
    return text;
}

/// Returns the least instant of a rest after which none of the events `elements` ever occurs again.
/// The result also contains, for each terminal set of nodes, the least instant of such a rest from
/// which this set is reachable.
std::set<std::size_t> first_without(const PointGraph& graph, const std::vector<std::string>& elements, bool broken) {
    std::vector<bool> all(graph.nodes.size(), true);
    for (const std::string& each : elements) {
        const std::vector<bool> dead_points = graph.dead_points(each, broken);
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = all[k] && dead_points[k];
    }
    std::set<std::size_t> result;
    const auto add = [&](const auto& of) {
        std::optional<std::size_t> first;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (all[k] && of(k)) first = std::min(first.value_or(*graph.nodes[k].ends), *graph.nodes[k].ends);
        if (first) result.insert(*first);
    };
    add([](std::size_t) { return true; });
    for (const std::vector<bool>& region : graph.regions()) {
        const std::vector<bool> to = graph.leading_to([&](std::size_t k) -> bool { return region[k]; });
        add([&](std::size_t k) -> bool { return to[k]; });
    }
    return result;
}

/// Returns the differences between the analysis and the search about events that never occur again.
std::string disagreement_on_graph(const Chart& chart, const Equations& equations, const PointGraph& graph,
                                  const Analysis& analysis, const Bounds& bounds) {
    std::string text;
    // The analysis does not consider that a counter or another part of the chart may abort a run. After an abort, no
    // event occurs again.
    const bool one_part = analysis::cones(equations).size() == 1;
    const bool cut = bounds.longest_count < 256 || !one_part;
    std::map<std::string, Finding::Level> found;
    std::set<std::string> unconfirmed;
    bool region = false, sure = true;
    for (const Finding& finding : analysis.findings) {
        if (!is_trap(finding.code) && finding.code != "comes-once") continue;
        region = region || finding.code == "region-never-left";
        sure = sure && finding.timing != Finding::Timing::Unconfirmed;
        for (const std::string& each : finding.lost) {
            found[each] = finding.level;
            // The analysis found no times for the path to the region of this finding.
            if (finding.timing == Finding::Timing::Unconfirmed) unconfirmed.insert(each);
        }
        if (finding.lost.empty() || finding.timing == Finding::Timing::Unconfirmed) continue;
        // The path of the finding leads to a point after which its events never occur again (for
        // `comes-once`, its first event).
        const bool once = finding.code == "comes-once";
        const auto first = first_without(graph, once ? std::vector{finding.lost.front()} : finding.lost, !cut);
        const std::size_t last_instant = finding.evidence ? finding.evidence->rows.size() - 1 : 0;
        // In every_cycle mode, the path of a finding may be one instant longer.
        const bool cyclic = analysis.mode == ExecutionMode::EveryCycle;
        if (first.empty()) text += "the lost elements occur again: " + finding.message + '\n';
        else if (!first.contains(last_instant) && !(cyclic && first.contains(last_instant - 1)) && one_part)
            text += "not shortest: " + finding.message + ", " + std::to_string(last_instant) + " instants\n";
    }
    // If the chart has timers, a path may need timer expiries in an impossible order.
    const bool timeless = timed_elements(chart).empty();
    std::set<std::string> open, steps;
    for (const OpenQuestion& question : analysis.open)
        if (is_trap(question.code)) open.insert(question.subject);
    for (const Id<Chart::Step> id : chart.steps.ids()) steps.insert(step_variable(chart, id));
    std::set<std::string> requested = steps;
    for (const Id<Chart::Transition> id : chart.transitions.ids()) requested.insert(chart.transitions[id].name);
    const std::vector<bool> matters = analysis::variables_that_matter(equations);
    for (const Equations::Stored& stored : equations.stored)
        if (matters[stored.variable.index]) requested.insert(equations.variables[stored.variable].name);
    for (const std::string& each : requested) {
        const bool ever =
            std::ranges::any_of(graph.nodes, [&](const PointGraph::Node& one) { return one.comes.contains(each); });
        const bool is_dead = ever && !first_without(graph, {each}, true).empty();
        if (is_dead && timeless && !found.contains(each) && !open.contains(each)) text += "can be lost: " + each + '\n';
        if (unconfirmed.contains(each)) continue;
        const bool once = found.contains(each) && found[each] == Finding::Level::Note;
        if (found.contains(each) && !once && ((!ever && !cut) || first_without(graph, {each}, !cut).empty()))
            text += "always possible again: " + each + '\n';
        if (once && graph.comes_again(each, steps.contains(each))) text += "more than once: " + each + '\n';
    }
    const auto regions = graph.regions();
    if (region && one_part && sure && regions.size() < 2) {
        std::vector<bool> inside = regions.empty() ? std::vector<bool>(graph.nodes.size()) : regions.front();
        bool any = false;  // true if a transition is cleared infinitely often outside the only region
        for (const Id<Chart::Transition> id : chart.transitions.ids()) {
            const std::string& fired = chart.transitions[id].name;
            for (std::size_t k = 0; k < inside.size(); ++k) {
                if (inside[k] || !graph.nodes[k].comes.contains(fired)) continue;
                const std::vector<bool> back = graph.leading_to([k](std::size_t other) { return other == k; });
                for (const std::size_t next : graph.nodes[k].next) any = any || back[next];
            }
        }
        if (!any || regions.empty()) text += "no region that is never left\n";
    }
    for (const std::vector<bool>& each : regions)
        if (one_part && sure && regions.size() > 1 && !region && analysis.open.empty() &&
            std::ranges::none_of(found, [&](const auto& entry) {
                for (std::size_t k = 0; k < each.size(); ++k)
                    if (each[k] && graph.nodes[k].comes.contains(entry.first)) return false;
                return true;
            }))
            text += "a region is not found\n";
    return text;
}

/// Returns the differences between the analysis and the search, or an empty string if they agree.
/// Returns nothing if the chart cannot be compared: it has no steps or no equations, it is too
/// large, or one of its conditions is undefined.
std::optional<std::string> disagreement(const Chart& chart, ExecutionMode mode, const Bounds& bounds = {}) {
    if (chart.steps.empty()) return {};
    ExplicitSearch search(chart, mode);
    const std::optional<Facts> expected = search.facts();
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!expected || !equations) return {};
    AnalyseOptions options;
    options.mode = mode;
    options.longest_count = bounds.longest_count;
    std::atomic<bool> stop{false};
    int looks = 0;
    options.stop = &stop;
    options.progress = [&](const AnalyseProgress&) { stop = ++looks == bounds.looks; };
    const Analysis analysis = analyse(chart, *equations, options);
    std::string text;
    for (const std::string& fault : verify(analysis)) text += "invariant: " + fault + '\n';
    for (const std::string& failure : analysis.failures) text += failure + '\n';
    std::set<std::string> found, unconfirmed, open;
    for (const Finding& finding : analysis.findings) {
        if (!is_compared(finding.code)) continue;
        (finding.timing == Finding::Timing::Unconfirmed ? unconfirmed : found)
            .insert(fact_of(finding.code, finding.subject));
    }
    for (const OpenQuestion& question : analysis.open) open.insert(fact_of(question.code, question.subject));
    // Timers may expire in an order that is impossible for every choice of times. The analysis does not report an event
    // as never occurring if it occurs only in such an order.
    for (const auto& [fact, instant] : *expected)
        if (!found.contains(fact) && !unconfirmed.contains(fact) && !open.contains(fact) && unconfirmed.empty())
            text += "not found: " + fact + '\n';
    for (const std::string& fact : found)
        if (!expected->contains(fact) && !masked(fact, *expected)) text += "not true: " + fact + '\n';
    if (unconfirmed.empty()) text += wrongly_open(analysis, *expected, found);
    text += disagreement_on_graph(chart, *equations, search.graph(), analysis, bounds);
    return text;
}

void expect_agreement(const Bounds& bounds, int seeds) {
    for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
        int compared = 0;
        for (int seed = 1; seed <= test_size(seeds); ++seed) {
            Random random(static_cast<std::uint64_t>(seed));
            const Chart chart = random_chart(random);
            const std::optional<std::string> wrong = disagreement(chart, mode, bounds);
            if (!wrong) continue;
            ++compared;
            if (wrong->empty()) continue;
            const Chart small = shrunk(
                chart, [&](const Chart& less) { return !disagreement(less, mode, bounds).value_or("").empty(); });
            FAIL() << "seed " << seed << (mode == ExecutionMode::EveryCycle ? ", every_cycle" : "") << '\n'
                   << *disagreement(small, mode, bounds) << chart_text(small);
        }
        EXPECT_GT(compared, 5);
    }
}

TEST(RandomizedAnalyse, AnalysisAgreesWithAnExplicitSearch) { expect_agreement({}, 120); }

TEST(RandomizedAnalyse, ResultsOfAStoppedAnalysisAreCorrect) {
    for (const int looks : {1, 2, 4, 7}) expect_agreement({.looks = looks}, 20);
}

TEST(RandomizedAnalyse, AbstractedCountersGiveNoFalseFindings) {
    expect_agreement({.looks = -1, .longest_count = 0}, 40);
}

}  // namespace
}  // namespace grafverif
