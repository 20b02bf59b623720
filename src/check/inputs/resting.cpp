// SPDX-License-Identifier: MIT
#include "check/inputs/resting.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "check/timed/components.hpp"
#include "ir/junction.hpp"
#include "ir/network/variables.hpp"
#include "ir/network_clocks.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

using VariableId = Id<Network::Variable>;
using Values = std::vector<std::int64_t>;

// Maximum number of joint values (valuations) of the variables that a process reads and other processes write.
constexpr std::size_t most_valuations_alone = 4096;
constexpr std::size_t most_moves_alone = 1U << 20U;  // maximum number of moves of a process, summed over all valuations

/// The processes that write and read each variable, and the PLCs.
struct Users {
    std::vector<std::set<Id<Network::Process>>> writers, readers;
    std::set<Id<Network::Process>> plcs = {};

    explicit Users(const Network& network) : writers(network.variables.size()), readers(network.variables.size()) {
        for (const Id<Network::Process> id : network.processes.ids()) {
            const Slots slots(network, id);
            for (const VariableId variable : slots.written()) writers[variable.index].insert(id);
            for (const VariableId variable : slots.read()) readers[variable.index].insert(id);
        }
        for (const Network::Controller& controller : network.controllers) plcs.insert(controller.process);
    }
};

/// Examines one process alone, for all values of the variables of other processes.
class Alone {
public:
    Alone(const Network& network, const Users& users, const ProcessClocks& clocks, Id<Network::Process> id,
          const timed::Limits& limits)
        : limits_(limits), network_(network), users_(users), id_(id), slots_(network, id) {
        for (const VariableId variable : slots_.written())
            if (users.writers[variable.index].size() == 1) own_.push_back(variable);
        for (const VariableId variable : slots_.read())
            if (!is_own(variable)) others_.push_back(variable);
        for (const Network::Edge& edge : slots_.automaton.edges) {
            timing_.push_back(timing_of(network, clocks, slots_.automaton, edge));
            accepts_.push_back(accepts_request(edge));
            for (const bool by_plcs : {false, true})
                shows_[by_plcs].push_back(
                    std::ranges::any_of(edge.assignments, [&](const Network::Assignment& assignment) {
                        return is_seen(edge, variable_of(network_.exprs, assignment.target), by_plcs);
                    }));
        }
    }

    /// Computes all moves. Returns false if there are too many moves, if a value may be undefined or out of range, or
    /// if the process is not supported.
    bool explore() {
        if (!is_simple() || !enumerate()) return false;
        State initial{slots_.process.initial, {}};
        for (const VariableId variable : own_) initial.values.push_back(network_.variables[variable].initial);
        number_of(initial);
        for (std::uint32_t state = 0; state < states_.size(); ++state)
            for (std::uint32_t valuation = 0; valuation < valuations_.size(); ++valuation)
                if (!expand(state, valuation)) return false;
        return true;
    }

    bool leaves_bounds() const { return bounds_left_; }

    /// True if no cycle of urgent edges contains an edge that assigns a variable which another process (if `to_plcs` is
    /// true: a PLC) reads. A variable of another process is constant if `steady` is true for the variable; otherwise
    /// the variable can change at any time.
    bool shows_finitely(const std::vector<bool>& steady, bool to_plcs) const {
        std::map<Values, std::vector<const Move*>> by_steady;
        for (const Move& move : moves_) {
            if (!edge(move.edge).urgent) continue;
            Values key;
            for (std::size_t i = 0; i < others_.size(); ++i)
                if (steady[others_[i].index]) key.push_back(valuations_[move.valuation][i]);
            by_steady[std::move(key)].push_back(&move);
        }
        return std::ranges::all_of(by_steady, [&](const auto& group) {
            return !repeats(group.second, [&](const Move& move) { return shows_[to_plcs][move.edge]; });
        });
    }

    /// True if, while the variables of other processes are constant, each cycle of urgent edges contains an edge that
    /// accepts a request.
    bool moves_finitely() const {
        std::map<std::uint32_t, std::vector<const Move*>> by_valuation;
        for (const Move& move : moves_)
            if (edge(move.edge).urgent && !accepts_[move.edge]) by_valuation[move.valuation].push_back(&move);
        return std::ranges::all_of(
            by_valuation, [&](const auto& group) { return !repeats(group.second, [](const Move&) { return true; }); });
    }

    /// True if each cycle of edges with at least one non-urgent edge takes at least one unit of time.
    bool repeats_slowly() const {
        std::vector<const Move*> fast;
        std::map<std::size_t, bool> is_slow;  // result of takes_time for each edge
        for (const Move& move : moves_) {
            const auto [known, is_new] = is_slow.emplace(move.edge, false);
            if (is_new) known->second = takes_time(move.edge);
            if (!known->second) fast.push_back(&move);
        }
        return !repeats(fast, [&](const Move& move) { return !edge(move.edge).urgent; });
    }

    const std::vector<VariableId>& own() const { return own_; }

    std::vector<TimerRequest> requests() const {
        std::map<VariableId, std::vector<Values>> after;  // per request: the values of own_ after each edge that
                                                          // accepts the request
        for (const Move& move : moves_)
            if (const auto request = accepted(edge(move.edge))) after[*request].push_back(states_[move.to].values);
        std::vector<TimerRequest> requests;
        for (const auto& [request, all] : after) {
            TimerRequest& found = requests.emplace_back(TimerRequest{request});
            for (std::size_t i = 0; i < own_.size(); ++i) {
                const auto is_same = [&](const Values& values) { return values[i] == all.front()[i]; };
                if (network_.variables[own_[i]].type.boolean && std::ranges::all_of(all, is_same))
                    found.results.emplace_back(own_[i], all.front()[i] != 0);
            }
        }
        return requests;
    }

private:
    struct State {
        Id<Network::Location> location = {};
        Values values = {};
        auto operator<=>(const State&) const = default;
    };
    struct Move {
        std::uint32_t from = 0, to = 0, edge = 0, valuation = 0;
    };

    const Network::Edge& edge(std::uint32_t id) const { return slots_.automaton.edges[{id}]; }

    /// True if the edge requires that a clock is at least 1, and each cycle that contains the edge resets this clock.
    bool takes_time(std::uint32_t id) const {
        const std::vector<ClockInterval> wanted =
            admitted(network_, edge(id).constraint, slots_.automaton.clocks.size());
        for (std::uint32_t clock = 0; clock < wanted.size(); ++clock) {
            if (wanted[clock].low < 1) continue;
            std::vector<const Move*> without_reset;
            for (const Move& move : moves_)
                if (!resets(edge(move.edge), {clock})) without_reset.push_back(&move);
            if (!repeats(without_reset, [&](const Move& move) { return move.edge == id; })) return true;
        }
        return false;
    }

    bool is_own(VariableId variable) const { return std::ranges::find(own_, variable) != own_.end(); }

    bool is_timer() const { return slots_.process.kind == Network::ProcessKind::Timer; }
    /// True if no process other than the PLCs and this process writes the variable.
    bool is_written_by_plcs(VariableId variable) const {
        return std::ranges::all_of(users_.writers[variable.index], [&](Id<Network::Process> writer) {
            return writer == id_ || users_.plcs.contains(writer);
        });
    }

    /// Returns the request that the edge of a timer accepts: a variable v such that `v` is a conjunct of the guard, the
    /// edge assigns false to v, and only PLCs set v to true.
    std::optional<VariableId> accepted(const Network::Edge& edge) const {
        if (!is_timer()) return {};
        for (const Id<Expr> conjunct : operands_of(network_.exprs, edge.guard, Op::And)) {
            if (network_.exprs[conjunct].op != Op::Variable) continue;
            const VariableId request = variable_of(network_.exprs, conjunct);
            const bool ends = std::ranges::any_of(edge.assignments, [&](const Network::Assignment& assignment) {
                return variable_of(network_.exprs, assignment.target) == request;
            });
            if (ends && only_ends(request) && is_written_by_plcs(request)) return request;
        }
        return {};
    }
    bool only_ends(VariableId request) const {
        return std::ranges::all_of(slots_.automaton.edges, [&](const Network::Edge& edge) {
            return std::ranges::all_of(edge.assignments, [&](const Network::Assignment& assignment) {
                return variable_of(network_.exprs, assignment.target) != request ||
                       is_false(network_.exprs, assignment.value);
            });
        });
    }
    /// True if each edge that assigns `variable` accepts `variable` as a request.
    bool accepts_only(VariableId variable) const {
        return std::ranges::all_of(slots_.automaton.edges, [&](const Network::Edge& edge) {
            return accepted(edge) == variable ||
                   std::ranges::none_of(edge.assignments, [&](const Network::Assignment& assignment) {
                       return variable_of(network_.exprs, assignment.target) == variable;
                   });
        });
    }
    bool accepts_request(const Network::Edge& edge) const { return accepted(edge).has_value(); }

    /// True if another process (if `by_plcs` is true: a PLC) reads `variable`, which the edge assigns. False if
    /// `variable` is the request that the edge accepts.
    bool is_seen(const Network::Edge& edge, VariableId variable, bool by_plcs) const {
        if (accepted(edge) == variable) return false;
        return std::ranges::any_of(users_.readers[variable.index], [&](Id<Network::Process> reader) {
            return reader != id_ && (!by_plcs || users_.plcs.contains(reader));
        });
    }

    bool is_simple() const {
        const auto is_bound = [&](const Network::ClockConstraint& bound) { return bound.relation == Op::LessEqual; };
        return std::ranges::all_of(slots_.automaton.edges,
                                   [](const Network::Edge& edge) { return edge.calls.empty(); }) &&
               std::ranges::all_of(
                   others_,
                   [&](VariableId id) { return accepts_only(id) && (!is_timer() || is_written_by_plcs(id)); }) &&
               std::ranges::none_of(slots_.used(), [&](VariableId id) { return network_.variables[id].scratch; }) &&
               std::ranges::all_of(slots_.automaton.locations, [&](const Network::Location& location) {
                   return location.invariant.size() < 63 && std::ranges::all_of(location.invariant, is_bound);
               });
    }

    bool enumerate() {
        valuations_ = {{}};
        for (const VariableId variable : others_) {
            const Type& type = network_.variables[variable].type;
            const auto size = static_cast<std::uint64_t>(type.high - type.low) + 1;
            if (size > most_valuations_alone || size * valuations_.size() > most_valuations_alone) return false;
            std::vector<Values> more;
            for (const Values& values : valuations_)
                for (std::int64_t value = type.low; value <= type.high; ++value) {
                    more.push_back(values);
                    more.back().push_back(value);
                }
            valuations_ = std::move(more);
        }
        return true;
    }

    std::uint32_t number_of(const State& state) {
        const auto [found, is_new] = numbers_.emplace(state, static_cast<std::uint32_t>(states_.size()));
        if (is_new) states_.push_back(state);
        return found->second;
    }

    std::optional<std::int64_t> value(Id<Expr> term, const Values& own, const Values& others) const {
        return evaluate(network_.exprs, term, [&](const Expr& leaf) {
            const VariableId variable{static_cast<std::uint32_t>(leaf.value)};
            const auto at = std::ranges::find(own_, variable);
            if (at != own_.end()) return own[static_cast<std::size_t>(at - own_.begin())];
            const auto other = std::ranges::find(others_, variable);
            return others[static_cast<std::size_t>(other - others_.begin())];
        });
    }

    bool expand(std::uint32_t from, std::uint32_t valuation) {
        const State now = states_[from];
        std::uint64_t left = 0;
        bool urgent = false;
        for (const Id<Network::Edge> id : slots_.automaton.edges.ids()) {
            const Network::Edge& edge = slots_.automaton.edges[id];
            if (edge.from != now.location) continue;
            const auto holds = value(edge.guard, now.values, valuations_[valuation]);
            if (!holds) return false;
            if (*holds == 0) continue;
            State next{edge.to, now.values};
            for (const Network::Assignment& assignment : edge.assignments) {
                const VariableId target = variable_of(network_.exprs, assignment.target);
                const auto result = value(assignment.value, next.values, valuations_[valuation]);
                const Type& type = network_.variables[target].type;
                if (!result || *result < type.low || *result > type.high) return false;
                const auto at = std::ranges::find(own_, target);
                if (at != own_.end()) next.values[static_cast<std::size_t>(at - own_.begin())] = *result;
            }
            const std::uint32_t to = number_of(next);
            left |= timing_[id.index].frees;
            urgent = urgent || edge.urgent;
            moves_.push_back({from, to, id.index, valuation});
            if (moves_.size() > most_moves_alone || states_.size() * valuations_.size() > most_moves_alone)
                return false;
        }
        const auto& invariant = slots_.automaton.locations[now.location].invariant;
        for (std::size_t bound = 0; bound < invariant.size() && !urgent; ++bound)
            if ((left >> bound & 1) == 0 || admitted(network_, invariant[bound]).high < 1) bounds_left_ = false;
        return true;
    }

    /// True if a move that satisfies `counts` is on a cycle of `moves`.
    template <class Counts>
    bool repeats(const std::vector<const Move*>& moves, const Counts& counts) const {
        std::vector<std::vector<std::uint32_t>> next(states_.size());
        for (const Move* const move : moves) next[move->from].push_back(move->to);
        timed::Components components(states_.size(), limits_, [&](std::uint32_t state, const auto& take) {
            std::ranges::for_each(next[state], take);
        });
        for (const Move* const move : moves) components.visit(move->from);
        return std::ranges::any_of(moves, [&](const Move* move) {
            return counts(*move) && components.of(move->from) == components.of(move->to);
        });
    }

    const timed::Limits& limits_;
    const Network& network_;
    const Users& users_;
    const Id<Network::Process> id_;
    const Slots slots_;
    std::vector<VariableId> own_ = {}, others_ = {};
    std::vector<EdgeTiming> timing_ = {};  // timing of each edge
    std::vector<bool> accepts_ = {};       // per edge: true if it accepts a request
    std::vector<bool> shows_[2] = {};      // per edge: true if it assigns a variable that another process (index 0) or
                                           // a PLC (index 1) reads
    std::vector<Values> valuations_ = {};  // all joint values of the variables in others_
    std::vector<State> states_ = {};
    std::map<State, std::uint32_t> numbers_ = {};
    std::vector<Move> moves_ = {};
    bool bounds_left_ = true;
};

/// True if the PLCs have no clocks, and each of their edges is urgent.
bool plcs_are_instant(const Network& network) {
    return std::ranges::all_of(network.controllers, [&](const Network::Controller& controller) {
        const Network::Template& plc = network.templates[network.processes[controller.process].automaton];
        return plc.clocks.empty() && std::ranges::all_of(plc.edges, &Network::Edge::urgent);
    });
}

/// Explores each process except PLCs separately. The result is empty if a process is not supported, or if an edge of a
/// PLC is not urgent.
std::deque<Alone> explored(const Network& network, const Users& users, const timed::Limits& limits) {
    const std::vector<ProcessClocks> clocks = analyse_clocks(network);
    std::deque<Alone> processes;
    if (!plcs_are_instant(network)) return {};
    for (const Id<Network::Process> id : network.processes.ids())
        if (!users.plcs.contains(id) && !processes.emplace_back(network, users, clocks[id.index], id, limits).explore())
            return {};
    return processes;
}

}  // namespace

std::vector<TimerRequest> requests_of(const Network& network) {
    const TimedOptions options;
    const timed::Limits limits(options);  // default options, without limits
    const Users users(network);
    const std::vector<ProcessClocks> clocks = analyse_clocks(network);
    std::vector<TimerRequest> requests;
    for (const Id<Network::Process> id : network.processes.ids()) {
        if (network.processes[id].kind != Network::ProcessKind::Timer) continue;
        Alone timer(network, users, clocks[id.index], id, limits);
        if (timer.explore()) std::ranges::move(timer.requests(), std::back_inserter(requests));
    }
    return requests;
}

bool takes_time(const Network& network) {
    const TimedOptions options;
    const timed::Limits limits(options);  // default options, without limits
    const Users users(network);
    const std::deque<Alone> processes = explored(network, users, limits);
    return !processes.empty() && std::ranges::all_of(processes, &Alone::repeats_slowly);
}

bool lets_time_pass(const Network& network, const InputAblations& ablations) {
    const TimedOptions options;
    const timed::Limits limits(options);  // default options, without limits
    const Users users(network);
    const std::deque<Alone> processes = explored(network, users, limits);
    if (processes.empty()) return false;
    for (const Alone& process : processes)
        if ((!ablations.ignore_bounds && !process.leaves_bounds()) ||
            (!ablations.ignore_moves && !process.moves_finitely()))
            return false;
    if (ablations.ignore_outputs) return true;
    std::vector<bool> steady(network.variables.size(), false);  // true if the variable is constant from some time on
    std::vector<bool> shown(processes.size(), false);
    const auto grow = [&] {
        for (bool grows = true; grows;) {
            grows = false;
            for (std::size_t i = 0; i < processes.size(); ++i) {
                if (shown[i] || !processes[i].shows_finitely(steady, false)) continue;
                for (const VariableId variable : processes[i].own()) steady[variable.index] = true;
                shown[i] = grows = true;
            }
        }
    };
    grow();
    for (const Alone& process : processes)
        if (!process.shows_finitely(steady, true)) return false;
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const std::set<Id<Network::Process>>& writers = users.writers[id.index];
        steady[id.index] = steady[id.index] || std::ranges::includes(users.plcs, writers);
    }
    grow();
    return std::ranges::find(shown, false) == shown.end();
}

}  // namespace grafverif
