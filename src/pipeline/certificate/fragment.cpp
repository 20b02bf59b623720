// SPDX-License-Identifier: MIT
#include "pipeline/certificate/fragment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <span>

#include "emit/certificate/certificate.hpp"
#include "ir/integer_operators.hpp"
#include "ir/junction.hpp"
#include "ir/network_clocks.hpp"
#include "ir/slots.hpp"
#include "ir/variable_users.hpp"

namespace grafverif {

namespace {

constexpr std::int64_t unknown = certificate::unknown_value;

/// Thrown if a term has no value, or an assignment leaves the range of its variable.
struct NoValue {};
/// Thrown if the fragment is not suitable, or a limit is reached.
struct NoFragment {};

class FragmentSearch {
public:
    FragmentSearch(const Network& flat, const FragmentContent& content, const std::vector<FragmentStates>& bounds,
                   const FragmentLimits& limits)
        : network_(flat), content_(content), choice_bounds_(bounds), limits_(limits), clocks_(analyse_clocks(flat)) {
        find_places();
        find_bounds();
        for (const Id<Network::Process> id : flat.processes.ids()) add_edges(id);
        free_.assign(first_.size(), unknown);
        memory_.resize(flat.exprs.size());
    }

    FragmentStates result(const Property* property) {
        std::set<Values> seen{first_};
        std::vector<Values> open{first_};
        while (!open.empty()) {
            const Values now = std::move(open.back());
            open.pop_back();
            if (property != nullptr && decides(*property, now)) throw NoFragment();
            const auto visit = [&](Values next) {
                const auto [found, is_new] = seen.insert(std::move(next));
                if (is_new) open.push_back(*found);
            };
            for (const Edge* const edge : acting_)
                any_choice([&] {
                    if (std::optional<Values> next = taken(*edge, now)) visit(std::move(*next));
                    return false;
                });
            if (std::optional<Values> next = after_delay(now)) visit(std::move(*next));
            if (seen.size() > limits_.states || seen.size() * first_.size() > limits_.values) throw NoFragment();
        }
        FragmentStates made{{}, std::move(errors_)};
        made.states.assign(seen.begin(), seen.end());
        return made;
    }

    /// True if a state that `state` represents decides the property.
    bool decides(const Property& property, const std::vector<std::int64_t>& state) {
        return any_choice([&] { return is_decided(property, state) && is_possible(); });
    }

private:
    using Values = std::vector<std::int64_t>;
    struct Bound {
        std::size_t clock = 0;  ///< place
        Op relation = Op::LessEqual;
        std::int64_t value = 0;
    };
    struct Edge {
        Id<Network::Process> process = {};
        std::uint32_t number = 0;
        std::int64_t from = 0, to = 0;
        Id<Expr> guard = {};
        std::vector<Bound> constraint = {};
        std::vector<std::size_t> resets = {};
        std::vector<std::pair<std::size_t, Id<Expr>>> assignments = {};
    };

    /// Finds the place of each value in a state, its range, and its first value.
    void find_places() {
        for (const Id<Network::Variable> id : network_.variables.ids()) {
            const Network::Variable& variable = network_.variables[id];
            const bool is_race = id == network_.race;
            ranges_.emplace_back(variable.type.low, is_race ? variable.initial : variable.type.high);
            first_.push_back(content_.variables[id.index] ? variable.initial : unknown);
        }
        for (const Id<Network::Process> id : network_.processes.ids()) {
            const Network::Template& automaton = network_.templates[network_.processes[id].automaton];
            location_.push_back(first_.size());
            ranges_.emplace_back(0, static_cast<std::int64_t>(automaton.locations.size()) - 1);
            first_.push_back(content_.locations[id.index] ? network_.processes[id].initial.index : unknown);
            for (std::size_t clock = 0; clock < automaton.clocks.size(); ++clock) {
                ranges_.emplace_back(0, std::numeric_limits<std::int64_t>::max());
                first_.push_back(content_.clocks[id.index] ? 0 : unknown);
            }
            std::vector<std::vector<Bound>>& invariants = invariants_.emplace_back();
            for (const Network::Location& at : automaton.locations) invariants.push_back(bounds(id, at.invariant));
        }
    }

    bool is_subsystem() const { return content_.kind == FragmentKind::Subsystem; }

    std::size_t place(Id<Network::Process> process, Id<Network::Clock> clock) const {
        return location_[process.index] + 1 + clock.index;
    }

    std::vector<Bound> bounds(Id<Network::Process> process, const std::vector<Network::ClockConstraint>& list) const {
        std::vector<Bound> made;
        for (const Network::ClockConstraint& one : list)
            made.push_back({place(process, one.clock), one.relation, bound_value(network_, {}, one.bound)});
        return made;
    }

    /// Finds bounds of the value of each term. The lower bound is `unknown` if the term may have no value.
    void find_bounds() {
        for (std::uint32_t index = 0; index < network_.exprs.size(); ++index) {
            const Expr& node = network_.exprs[Id<Expr>{index}];
            const auto operands = network_.exprs.operands(Id<Expr>{index});
            std::pair<std::int64_t, std::int64_t> made{0, 1};
            if (node.op == Op::Integer) made = {node.value, node.value};
            if (node.op == Op::True) made = {1, 1};
            if (node.op == Op::False) made = {0, 0};
            if (node.op == Op::Variable) made = ranges_[static_cast<std::size_t>(node.value)];
            for (std::size_t i = 0; i < operands.size() && node.op == Op::Conditional; ++i) {
                made.first = std::min(made.first, bounds_[operands[i].index].first);
                made.second = std::max(made.second, bounds_[operands[i].index].second);
            }
            bool certain = !is_arithmetic(node.op);
            for (const Id<Expr> operand : operands) certain = certain && bounds_[operand.index].first != unknown;
            if (!certain) made.first = unknown;
            bounds_.push_back(made);
        }
    }

    bool fits(std::size_t place, Id<Expr> term) const {
        return ranges_[place].first <= bounds_[term.index].first && bounds_[term.index].second <= ranges_[place].second;
    }

    void add_assignments(const std::vector<Network::Assignment>& assignments, Edge& made,
                         std::set<std::size_t>& scratch) const {
        for (const Network::Assignment& one : assignments) {
            const auto target = static_cast<std::uint32_t>(network_.exprs[one.target].value);
            if (network_.race == Id<Network::Variable>{target}) {
                for (const Id<Expr> reason : operands_of(network_.exprs, one.value, Op::Or))
                    if (reason != one.target) made.assignments.emplace_back(target, reason);
                continue;
            }
            made.assignments.emplace_back(target, one.value);
            if (network_.variables[{target}].scratch) scratch.insert(target);
        }
    }

    void add_edges(Id<Network::Process> id) {
        const Network::Template& automaton = network_.templates[network_.processes[id].automaton];
        for (const Id<Network::Edge> number : automaton.edges.ids()) {
            const Network::Edge& edge = automaton.edges[number];
            Edge made{id, number.index, edge.from.index, edge.to.index, edge.guard, bounds(id, edge.constraint)};
            for (const Id<Network::Clock> clock : edge.resets) made.resets.push_back(place(id, clock));
            std::set<std::size_t> scratch;
            add_assignments(edge.assignments, made, scratch);
            for (const Id<Network::Procedure> call : edge.calls)
                add_assignments(automaton.procedures[call].assignments, made, scratch);
            for (const std::size_t variable : scratch) made.assignments.emplace_back(variable, Id<Expr>{});
            const bool own = content_.locations[id.index];
            const auto is_known = [&](std::size_t at) { return first_[at] != unknown; };
            bool acts = std::ranges::any_of(made.resets, is_known);
            bool errs = bounds_[edge.guard.index].first == unknown;
            for (const auto& [target, value] : made.assignments) {
                acts = acts || is_known(target);
                errs = errs || (value.valid() && !fits(target, value));
            }
            if (is_subsystem() && !own && acts) throw NoFragment();
            edges_.push_back(std::make_unique<Edge>(std::move(made)));
            if (own || acts || (errs && content_.kind == FragmentKind::States)) acting_.push_back(edges_.back().get());
            const auto is_reset = [&](const Network::ClockConstraint& one) {
                return std::ranges::find(edge.resets, one.clock) != edge.resets.end();
            };
            const bool timed =
                !edge.constraint.empty() || !std::ranges::all_of(automaton.locations[edge.to].invariant, is_reset);
            if (edge.urgent && (own || content_.reacting.contains(id)) && (content_.step == 1 || !timed))
                urgent_.push_back(edges_.back().get());
        }
    }

    bool satisfied(const std::vector<Bound>& list, const Values& state, bool if_unknown) const {
        return std::ranges::all_of(list, [&](const Bound& one) {
            if (state[one.clock] != unknown) return admitted(one.relation, one.value).contains(state[one.clock]);
            if (is_subsystem()) throw NoFragment();
            return if_unknown;
        });
    }

    bool is_enabled(const Edge& edge, const Values& now, Values& next, bool if_unknown) {
        if (read(location_[edge.process.index], now) != edge.from) return false;
        if (!satisfied(edge.constraint, now, if_unknown) || value(edge.guard, now) == 0) return false;
        next = now;
        for (const std::size_t clock : edge.resets) next[clock] = 0;
        return satisfied(invariants_[edge.process.index][static_cast<std::size_t>(edge.to)], next, if_unknown);
    }

    /// Returns the successor by an edge; empty if the edge cannot be taken or has a model error.
    std::optional<Values> taken(const Edge& edge, const Values& now) {
        std::size_t k = 0;
        try {
            Values next;
            if (!is_enabled(edge, now, next, true)) return {};
            for (; k < edge.assignments.size(); ++k) {
                const auto& [target, term] = edge.assignments[k];
                const bool known = first_[target] != unknown;
                std::int64_t& variable = (known ? next : free_)[target];
                if (!term.valid()) {
                    variable = known ? network_.variables[{static_cast<std::uint32_t>(target)}].initial : unknown;
                    continue;
                }
                if (fits(target, term) && (!known || is_open(term, next))) {
                    free_[target] = variable = unknown;
                    continue;
                }
                const std::int64_t result = value(term, next);
                if (result < ranges_[target].first || result > ranges_[target].second) throw NoValue();
                variable = result;
            }
            if (now[location_[edge.process.index]] != unknown) next[location_[edge.process.index]] = edge.to;
            for (const std::size_t clock : edge.resets)
                if (now[clock] == unknown) next[clock] = unknown;
            for (std::size_t i = 0; i < next_choice_; ++i)  // open variables keep the choices
                if (const std::size_t at = choices_[i].first; first_[at] != unknown && next[at] == unknown)
                    next[at] = free_[at];
            reduce(edge.process, next);
            return is_possible(&edge) ? std::optional(std::move(next)) : std::nullopt;
        } catch (const NoValue&) {
            if (is_possible(&edge)) errors_.insert(fmt::format("{} {} {}", edge.process.index, edge.number, k));
            return {};
        }
    }

    /// True if the term is a variable without known or chosen value.
    bool is_open(Id<Expr> term, const Values& state) const {
        const Expr& node = network_.exprs[term];
        const auto at = static_cast<std::size_t>(node.value);
        return !is_subsystem() && node.op == Op::Variable && state[at] == unknown && free_[at] == unknown;
    }

    /// True if the choices agree with a state of each of the bounds. Choices of variables that `edge` assigns are
    /// ignored, because they may be later values. `edge` may be null.
    bool is_possible(const Edge* edge = nullptr) const {
        const auto is_assigned = [&](std::size_t place) {
            return edge != nullptr && std::ranges::any_of(edge->assignments, [&](const auto& assignment) {
                       return assignment.first == place;
                   });
        };
        const auto agrees = [&](const Values& state) {
            return std::ranges::all_of(std::span(choices_).first(next_choice_), [&](const auto& choice) {
                const auto& [place, value] = choice;
                return state[place] == unknown || state[place] == value || is_assigned(place);
            });
        };
        return std::ranges::all_of(
            choice_bounds_, [&](const FragmentStates& bound) { return std::ranges::any_of(bound.states, agrees); });
    }

    std::optional<Values> after_delay(const Values& now) {
        Values next;
        const auto is_urgent = [&](const Edge* edge) {
            try {
                return is_enabled(*edge, now, next, false);
            } catch (const NoValue&) {
                return false;
            }
        };
        if (!any_choice([&] { return std::ranges::none_of(urgent_, is_urgent) && is_possible(); })) return {};
        next = now;
        for (const Id<Network::Process> id : network_.processes.ids()) {
            const std::size_t at = location_[id.index];
            const std::size_t count = network_.templates[network_.processes[id].automaton].clocks.size();
            for (std::size_t clock = at + 1; clock <= at + count; ++clock)
                if (now[clock] != unknown) next[clock] += content_.step;
            if (now[at] == unknown) continue;
            if (!satisfied(invariants_[id.index][static_cast<std::size_t>(now[at])], next, true)) return {};
            reduce(id, next);
        }
        return next;
    }

    void reduce(Id<Network::Process> id, Values& state) const {
        const std::size_t at = location_[id.index];
        if (state[at] == unknown) return;
        const std::vector<std::int64_t>& caps = clocks_[id.index].cap[static_cast<std::size_t>(state[at])];
        for (std::size_t clock = 0; clock < caps.size(); ++clock) {
            std::int64_t& value = state[at + 1 + clock];
            value = std::min(value, std::max<std::int64_t>(caps[clock], 0));
        }
    }

    bool is_decided(const Property& property, const Values& state) {
        if (property.at_stable && value(network_.settled, state) == 0) return false;
        // Two true operands decide `exactly one of`, even if a later operand has no value.
        const auto is_true = [&, found = 0](Id<Expr> operand) mutable {
            return found < 2 && value(operand, state) != 0 && ++found != 0;
        };
        const auto count = std::ranges::count_if(property.operands, is_true);
        if (property.pattern == Pattern::ExactlyOneOf) return count != 1;
        return (count != 0) != (property.pattern == Pattern::Always);
    }

    /// Calls `run` for each combination of the unknown values that `run` reads, until `run` returns true.
    template <class Run>
    bool any_choice(const Run& run) {
        choices_.clear();
        for (std::uint64_t attempts = 0; attempts < 500'000; ++attempts) {
            if (++attempts_ > limits_.attempts || is_over()) throw NoFragment();
            std::ranges::fill(free_, unknown);
            next_choice_ = 0;
            if (run()) return true;
            while (!choices_.empty() && choices_.back().second == ranges_[choices_.back().first].second)
                choices_.pop_back();
            if (choices_.empty()) return false;
            ++choices_.back().second;
        }
        throw NoFragment();
    }

    bool is_over() const {
        if (attempts_ % 4096 != 0) return false;
        return (limits_.stop != nullptr && *limits_.stop) ||
               (limits_.deadline && std::chrono::steady_clock::now() > *limits_.deadline);
    }

    std::int64_t read(std::size_t place, const Values& state) {
        if (state[place] != unknown) return state[place];
        if (is_subsystem()) throw NoFragment();
        if (free_[place] != unknown) return free_[place];
        if (next_choice_ == choices_.size()) choices_.emplace_back(place, ranges_[place].first);
        return free_[place] = choices_[next_choice_++].second;
    }

    std::int64_t value(Id<Expr> term, const Values& state) {
        ++round_;
        return evaluated(term, state);
    }

    std::int64_t evaluated(Id<Expr> term, const Values& state) {
        const Expr& node = network_.exprs[term];
        if (node.op == Op::Variable) return read(static_cast<std::size_t>(node.value), state);
        if (node.op == Op::At)
            return read(location_[at_process(node)], state) == static_cast<std::int64_t>(at_location(node)) ? 1 : 0;
        auto& [round, known] = memory_[term.index];
        if (round == round_) return known;
        const std::int64_t result = computed(term, state);
        memory_[term.index] = {round_, result};
        return result;
    }

    std::int64_t computed(Id<Expr> term, const Values& state) {
        const Expr& node = network_.exprs[term];
        const auto operands = network_.exprs.operands(term);
        if (node.op == Op::And || node.op == Op::Or) {
            const bool decides = node.op == Op::Or;
            for (const Id<Expr> operand : operands)
                if ((evaluated(operand, state) != 0) == decides) return decides ? 1 : 0;
            return decides ? 0 : 1;
        }
        if (node.op == Op::Conditional) return evaluated(operands[evaluated(operands[0], state) != 0 ? 1 : 2], state);
        if (operands.empty()) return node.op == Op::True ? 1 : node.op == Op::False ? 0 : node.value;
        const std::int64_t left = evaluated(operands[0], state);
        if (node.op == Op::Not) return left == 0 ? 1 : 0;
        if (node.op == Op::Negate) return combined(Op::Minus, 0, left);
        return combined(node.op, left, evaluated(operands[1], state));
    }

    static std::int64_t combined(Op op, std::int64_t left, std::int64_t right) {
        const std::optional<std::int64_t> result = combine(op, left, right);
        if (!result) throw NoValue();
        return *result;
    }

    const Network& network_;
    const FragmentContent& content_;
    const std::vector<FragmentStates>& choice_bounds_;  ///< sets of states that restrict choices
    const FragmentLimits& limits_;
    const std::vector<ProcessClocks> clocks_;
    Values first_ = {};                                               ///< the first state
    std::vector<std::pair<std::int64_t, std::int64_t>> ranges_ = {};  ///< per place
    std::vector<std::size_t> location_ = {};                          ///< per process: the place of its location
    std::vector<std::vector<std::vector<Bound>>> invariants_ = {};    ///< bounds of clocks, per process and location
    std::vector<std::pair<std::int64_t, std::int64_t>> bounds_ = {};  ///< per term
    std::vector<std::unique_ptr<Edge>> edges_ = {};
    std::vector<const Edge*> acting_ = {}, urgent_ = {};
    std::set<std::string> errors_ = {};
    std::vector<std::pair<std::size_t, std::int64_t>> choices_ = {};
    std::size_t next_choice_ = 0;
    Values free_ = {};
    std::vector<std::pair<std::uint64_t, std::int64_t>> memory_ = {};
    std::uint64_t round_ = 0, attempts_ = 0;
};

}  // namespace

FragmentContent complete_content(const Network& flat) {
    return {std::vector<bool>(flat.variables.size(), true), std::vector<bool>(flat.processes.size(), true),
            std::vector<bool>(flat.processes.size(), true)};
}

FragmentContent empty_content(const Network& flat) {
    return {std::vector<bool>(flat.variables.size()), std::vector<bool>(flat.processes.size()),
            std::vector<bool>(flat.processes.size())};
}

FragmentContent content_alone(const Network& flat, Id<Network::Process> process) {
    FragmentContent content = empty_content(flat);
    const VariableUsers users(flat);
    content.locations[process.index] = true;
    for (const Id<Network::Variable> variable : Slots(flat, process).written())
        content.variables[variable.index] = users.writers[variable.index].size() == 1;
    content.kind = FragmentKind::Bounds;
    return content;
}

std::int64_t greatest_step(const Network& flat, const FragmentContent& content) {
    std::int64_t step = 0;
    const auto add = [&](const std::vector<Network::ClockConstraint>& list) {
        for (const Network::ClockConstraint& one : list)
            step = one.relation == Op::Less || one.relation == Op::Greater
                       ? 1  // all later divisors are 1, too
                       : std::gcd(step, bound_value(flat, {}, one.bound));
    };
    for (const Id<Network::Process> id : flat.processes.ids()) {
        if (!content.clocks[id.index]) continue;
        const Network::Template& automaton = flat.templates[flat.processes[id].automaton];
        for (const Network::Location& location : automaton.locations) add(location.invariant);
        for (const Network::Edge& edge : automaton.edges) add(edge.constraint);
    }
    return std::max<std::int64_t>(step, 1);
}

std::optional<FragmentStates> fragment_states(const Network& flat, const FragmentContent& content,
                                              const std::vector<FragmentStates>& bounds, const Property* property,
                                              const FragmentLimits& limits) {
    try {
        return FragmentSearch(flat, content, bounds, limits).result(property);
    } catch (const NoFragment&) {
        return {};
    } catch (const NoValue&) {
        return {};
    }
}

bool satisfies(const Network& flat, const FragmentContent& content, const std::vector<FragmentStates>& bounds,
               const FragmentStates& found, const Property& property, const FragmentLimits& limits) {
    try {
        FragmentSearch search(flat, content, bounds, limits);
        return std::ranges::none_of(found.states, [&](const auto& state) { return search.decides(property, state); });
    } catch (const NoFragment&) {
        return false;
    } catch (const NoValue&) {
        return false;
    }
}

}  // namespace grafverif
