// SPDX-License-Identifier: MIT
#include "explain/causes.hpp"

#include <algorithm>
#include <map>

namespace grafverif {

namespace {

using Terms = std::vector<Id<Expr>>;

/// What must hold in one state of a run, as a term; what does not is explained.
class Demand {
public:
    Demand(const Exprs& exprs, Id<Expr> formula) : exprs_(exprs), formula_(formula) { collect(formula, true); }

    /// The terms that cause it to fail in `state`; false: some value is missing, or it does not fail.
    bool explain(const NetworkState& state, std::size_t most, Terms& found, bool& exact) {
        values_.clear();
        for (const Id<Expr> term : terms_) {
            const auto now = value_of(state, term);
            if (!now) return false;
            values_.push_back(*now != 0);
        }
        if (holds(formula_)) return false;
        std::vector<std::size_t> bottom;
        for (std::size_t k = 0; k < terms_.size(); ++k)
            if (values_[k] ? negative_[k] : positive_[k]) bottom.push_back(k);
        const bool once = std::ranges::none_of(twice_, [](bool each) { return each; });
        if (!once && bottom.size() > most) exact = false;
        std::vector<bool> causes(terms_.size(), false);
        if (once || bottom.size() > most) by_rule(formula_, true, causes);
        else by_definition(bottom, causes);
        for (std::size_t k = 0; k < terms_.size(); ++k)
            if (causes[k]) found.push_back(terms_[k]);
        return true;
    }

private:
    std::optional<std::int64_t> value_of(const NetworkState& state, Id<Expr> term) const {
        return evaluate(exprs_, term, [&](const Expr& leaf) -> std::int64_t {
            if (leaf.op == Op::At) return state.locations[at_process(leaf)].index == at_location(leaf) ? 1 : 0;
            return state.variables[static_cast<std::size_t>(leaf.value)];
        });
    }

    void collect(Id<Expr> term, bool wanted) {
        const Op op = exprs_[term].op;
        if (op == Op::Not) return collect(exprs_.operands(term)[0], !wanted);
        if (op == Op::And || op == Op::Or) {
            for (const Id<Expr> operand : exprs_.operands(term)) collect(operand, wanted);
            return;
        }
        if (is_constant(op)) return;
        const auto [place, is_new] = places_.emplace(term.index, terms_.size());
        if (is_new) {
            terms_.push_back(term);
            positive_.push_back(false);
            negative_.push_back(false);
            twice_.push_back(false);
        } else {
            twice_[place->second] = true;
        }
        (wanted ? positive_ : negative_)[place->second] = true;
    }

    bool holds(Id<Expr> term) const {
        const Op op = exprs_[term].op;
        const auto operands = exprs_.operands(term);
        const auto so = [this](Id<Expr> each) { return holds(each); };
        if (op == Op::Not) return !holds(operands[0]);
        if (op == Op::And) return std::ranges::all_of(operands, so);
        if (op == Op::Or) return std::ranges::any_of(operands, so);
        if (is_constant(op)) return op == Op::True;
        return values_[places_.at(term.index)];
    }

    /// The rule of the paper: `term` has not the value wanted; of a conjunction wanted true those that are false, of a
    /// disjunction all.
    void by_rule(Id<Expr> term, bool wanted, std::vector<bool>& causes) const {
        const Op op = exprs_[term].op;
        if (op == Op::Not) return by_rule(exprs_.operands(term)[0], !wanted, causes);
        if (op == Op::And || op == Op::Or) {
            for (const Id<Expr> operand : exprs_.operands(term))
                if (holds(operand) != wanted) by_rule(operand, wanted, causes);
            return;
        }
        if (!is_constant(op)) causes[places_.at(term.index)] = true;
    }

    void by_definition(const std::vector<std::size_t>& bottom, std::vector<bool>& causes) {
        const std::vector<bool> before = values_;
        std::vector<bool> mended(std::size_t{1} << bottom.size());
        for (std::size_t set = 0; set < mended.size(); ++set) {
            values_ = before;
            for (std::size_t k = 0; k < bottom.size(); ++k)
                if ((set >> k & 1U) != 0) values_[bottom[k]] = !before[bottom[k]];
            mended[set] = holds(formula_);
        }
        values_ = before;
        for (std::size_t set = 0; set < mended.size(); ++set)
            for (std::size_t k = 0; k < bottom.size() && !mended[set]; ++k)
                if ((set >> k & 1U) == 0 && mended[set | std::size_t{1} << k]) causes[bottom[k]] = true;
    }

    const Exprs& exprs_;
    Id<Expr> formula_;
    Terms terms_ = {};
    std::map<std::uint32_t, std::size_t> places_ = {};
    std::vector<bool> positive_ = {}, negative_ = {}, twice_ = {}, values_ = {};
};

/// What every state must be, of a property about single states.
Id<Expr> safe(const Property& property, Exprs& exprs) {
    const Terms& p = property.operands;
    if (property.pattern == Pattern::Always) return p[0];
    if (property.pattern == Pattern::Never) return exprs.negation(p[0]);
    Terms all = {exprs.disjunction(p)};
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t k = i + 1; k < p.size(); ++k) {
            const Terms both = {p[i], p[k]};
            all.push_back(exprs.negation(exprs.conjunction(both)));
        }
    return exprs.conjunction(all);
}

/// The states from `state` on that the run comes to, `state` included.
std::vector<std::size_t> states_from(std::size_t state, std::size_t count, std::optional<std::size_t> loop) {
    std::vector<std::size_t> list;
    for (std::size_t k = loop ? std::min(state, *loop) : state; k < count; ++k) list.push_back(k);
    return list;
}

class Search {
public:
    Search(const Network& network, const Property& property, const std::vector<NetworkState>& states,
           std::optional<std::size_t> loop, std::size_t most)
        : network_(network), property_(property), states_(states), loop_(loop), most_(most), exprs_(network.exprs) {
        count_ = loop ? states.size() - 1 : states.size();  // the last one is the first of the loop again
    }

    std::optional<Causes> safety() {
        Demand demand(exprs_, safe(property_, exprs_));
        for (std::size_t state = 0; state < states_.size(); ++state)
            if (judged(state) && explain(demand, state)) return std::move(causes_);
        return {};
    }

    std::optional<Causes> response() {
        const Id<Expr> p = property_.operands[0], q = property_.operands[1];
        std::size_t asks = count_;
        for (std::size_t state = 0; state < count_ && asks == count_; ++state) {
            const auto later = states_from(state, count_, loop_);
            const auto is = [&](Id<Expr> term, std::size_t at) {
                return judged(at) && value(network_, states_[at], term).value_or(0) != 0;
            };
            if (is(p, state) && std::ranges::none_of(later, [&](std::size_t at) { return is(q, at); })) asks = state;
        }
        if (asks == count_) return {};
        const Id<Expr> answered = exprs_.disjunction(exprs_.negation(p), q);
        Demand here(exprs_, answered), there(exprs_, q);
        for (const std::size_t state : states_from(asks, count_, loop_))
            if (judged(state) && !explain(state == asks ? here : there, state)) return {};
        return std::move(causes_);
    }

private:
    bool judged(std::size_t state) const {
        return !property_.at_stable || value(network_, states_[state], network_.settled) == 1;
    }

    bool explain(Demand& demand, std::size_t state) {
        Terms found;
        if (!demand.explain(states_[state], most_, found, causes_.exact)) return false;
        for (const Id<Expr> term : found) causes_.pairs.push_back({term, state});
        return true;
    }

    const Network& network_;
    const Property& property_;
    const std::vector<NetworkState>& states_;
    std::optional<std::size_t> loop_;
    std::size_t most_;
    Exprs exprs_;
    std::size_t count_ = 0;
    Causes causes_ = {};
};

}  // namespace

std::optional<Causes> causes_of(const Network& network, const Property& property,
                                const std::vector<NetworkState>& states, std::optional<std::size_t> loop,
                                std::size_t most) {
    Search search(network, property, states, loop, most);
    switch (property.pattern) {
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::ExactlyOneOf: return search.safety();
    case Pattern::LeadsTo: return search.response();
    default: return {};
    }
}

namespace {

/// Where the run has what the leaves of terms read.
class Marker {
public:
    Marker(const Network& network, ChartRun& run) : network_(network), run_(run) {
        std::uint32_t instances = 0;
        for (const Network::Process& process : network.processes)
            instances_.push_back(process.kind == Network::ProcessKind::Controller
                                     ? Id<ChartRun::Instance>{}
                                     : Id<ChartRun::Instance>{instances++});
        for (const Id<Network::Variable> id : network.variables.ids()) {
            const auto signal = std::ranges::find_if(run.signals, [&](const ChartRun::Signal& each) {
                return each.role != ChartRun::Role::Image && each.name == network.variables[id].told_name();
            });
            if (signal != run.signals.end())
                signals_[id.index] = {static_cast<std::uint32_t>(signal - run.signals.begin())};
        }
        for (const Id<Network::Controller> id : network.controllers.ids()) {
            const auto& words = network.controllers[id].words;
            const ChartRun::Controller& controller = run.controllers[{id.index}];
            for (std::size_t k = 0; k < words.steps.size(); ++k)
                steps_[words.steps[k].variable.index] = controller.steps[k];
            for (std::size_t k = 0; k < words.internals.size(); ++k)
                signals_[words.internals[k].variable.index] = controller.internals[k];
        }
    }

    void mark(const Causes::Pair& pair) {
        for (const Id<Expr> leaf : leaves(network_.exprs, pair.term)) add(network_.exprs[leaf], pair.state);
    }

private:
    void add(const Expr& leaf, std::size_t state) {
        const std::size_t moment = std::min(state, run_.moments.size() - 1);
        const ChartRun::State& after = run_.moments[moment].after;
        ChartRun::Cause cause{.first = moment, .last = moment};
        const auto index = static_cast<std::uint32_t>(leaf.value);
        if (leaf.op == Op::At) {
            cause.instance = instances_[at_process(leaf)];
            cause.location = at_location(leaf);
            cause.value = location_of(cause.instance, moment) == cause.location ? 1 : 0;
            if (!cause.instance.valid()) return;
        } else if (const auto step = steps_.find(index); step != steps_.end()) {
            cause.step = step->second;
            cause.value = std::ranges::find(after.situation, cause.step) != after.situation.end() ? 1 : 0;
        } else if (const auto signal = signals_.find(index); signal != signals_.end()) {
            cause.signal = signal->second;
            cause.value = after.values[cause.signal.index];
        } else {
            return;
        }
        for (ChartRun::Cause& before : run_.causes) {
            ChartRun::Cause same = before;
            same.first = cause.first;
            same.last = cause.last;
            if (same != cause || before.last + 1 < moment) continue;
            before.last = moment;
            return;
        }
        run_.causes.push_back(cause);
    }

    std::size_t location_of(Id<ChartRun::Instance> instance, std::size_t moment) const {
        for (std::size_t k = moment; k > 0; --k)
            if (run_.moments[k].instance == instance && run_.moments[k].location) return *run_.moments[k].location;
        for (const Id<Network::Process> id : network_.processes.ids())
            if (instances_[id.index] == instance) return network_.processes[id].initial.index;
        return 0;
    }

    const Network& network_;
    ChartRun& run_;
    std::vector<Id<ChartRun::Instance>> instances_ = {};          // per process
    std::map<std::uint32_t, Id<ChartRun::Step>> steps_ = {};      // per variable
    std::map<std::uint32_t, Id<ChartRun::Signal>> signals_ = {};  // per variable
};

}  // namespace

void mark(const Network& network, const Causes& causes, ChartRun& run) {
    Marker marker(network, run);
    run.causes_exact = causes.exact;
    for (const Causes::Pair& pair : causes.pairs) marker.mark(pair);
    // The last moment is that before the loop again.
    for (const Causes::Pair& pair : causes.pairs)
        if (run.loop && pair.state + 1 == *run.loop) marker.mark({pair.term, run.moments.size() - 1});
    std::ranges::stable_sort(run.causes, {}, &ChartRun::Cause::first);
}

}  // namespace grafverif
