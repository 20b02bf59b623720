// SPDX-License-Identifier: MIT
#include "check/evidence.hpp"

#include <algorithm>
#include <utility>

#include "ir/patterns.hpp"

namespace grafverif {

namespace {

/// Checks whether the states of an external trace form a run of the system, and determines in which states each of the
/// given terms holds.
class ExternalTraceImport {
public:
    ExternalTraceImport(const FlatSystem& flat, const ExternalTrace& external_trace, std::vector<Id<Expr>> terms)
        : flat_(flat), external_trace_(external_trace), terms_(std::move(terms)), truths_(terms_.size()) {
        for (std::size_t state = 0; state < size() && broken_.empty(); ++state) look_at(state);
    }

    std::size_t size() const { return external_trace_.states.size(); }
    /// Returns the reason why the trace is not a run of the system; empty if it is a run.
    const std::string& broken() const { return broken_; }

    bool holds(std::size_t state, Id<Expr> term) const {
        return truths_[static_cast<std::size_t>(std::ranges::find(terms_, term) - terms_.begin())][state];
    }

    /// True if the trace has a loop and each justice condition holds in some state of the loop.
    bool fair() const {
        return external_trace_.loop && std::ranges::all_of(flat_.justice, [this](Id<Expr> term) {
                   for (std::size_t state = *external_trace_.loop; state < size(); ++state)
                       if (holds(state, term)) return true;
                   return false;
               });
    }

private:
    using Values = std::vector<std::optional<std::int64_t>>;  ///< values of all terms in one state

    void look_at(std::size_t state) {
        const std::vector<std::int64_t>& variables = external_trace_.states[state];
        const Values values = evaluate_all(
            flat_.exprs, [&](const Expr& leaf) { return variables[static_cast<std::size_t>(leaf.value)]; });
        const auto all_hold = [&](const std::vector<Id<Expr>>& terms) {
            return std::ranges::all_of(terms, [&](Id<Expr> term) { return values[term.index].value_or(0) != 0; });
        };
        for (std::size_t i = 0; i < terms_.size(); ++i) truths_[i].push_back(values[terms_[i].index].value_or(0) != 0);
        const std::optional<std::size_t> next = state + 1 < size() ? state + 1 : external_trace_.loop;
        std::string why;
        if (const std::string name = out_of_range(state); !name.empty())
            why = "gives `" + name + "` a value outside its range";
        else if (!all_hold(flat_.invariants)) why = "violates an invariant of the model";
        else if (const std::string first = state == 0 ? differs(values, &FlatSystem::Variable::initial, 0) : "";
                 !first.empty())
            why = "is not an initial state: the value of `" + first + "` differs";
        else if (next && !all_hold(flat_.transitions))
            why = "is followed by a step that violates the transition relation";
        else if (const std::string then = next ? differs(values, &FlatSystem::Variable::next, *next) : "";
                 !then.empty())
            why = "is followed by a state that is not a successor: the value of `" + then + "` differs";
        if (!why.empty()) broken_ = "state " + std::to_string(state + 1) + " of the trace " + why;
    }

    std::string out_of_range(std::size_t state) const {
        for (const Id<FlatSystem::Variable> id : flat_.variables.ids()) {
            const Type& type = flat_.variables[id].type;
            const std::int64_t value = external_trace_.states[state][id.index];
            if (value < (type.boolean ? 0 : type.low) || value > (type.boolean ? 1 : type.high))
                return flat_.variables[id].name;
        }
        return {};
    }

    /// Returns the name of the first variable whose value in the state `to` differs from the value of its term `term`
    /// in `values`. The result is empty if no value differs.
    std::string differs(const Values& values, std::optional<Id<Expr>> FlatSystem::Variable::*term,
                        std::size_t to) const {
        for (const Id<FlatSystem::Variable> id : flat_.variables.ids()) {
            const std::optional<Id<Expr>>& wanted = flat_.variables[id].*term;
            if (wanted && values[wanted->index] != external_trace_.states[to][id.index])
                return flat_.variables[id].name;
        }
        return {};
    }

    const FlatSystem& flat_;
    const ExternalTrace& external_trace_;
    std::vector<Id<Expr>> terms_ = {};
    std::vector<std::vector<bool>> truths_ = {};  ///< truth value of each term in each state
    std::string broken_ = {};
};

/// True if `from` holds in some state, and `never` holds neither in this state nor in any later state, also when the
/// loop is repeated.
bool avoids(const ExternalTraceImport& evidence, std::size_t loop, Id<Expr> from, Id<Expr> never) {
    std::size_t without = evidence.size();  // first state such that `never` is false from this state to the end
    while (without > 0 && !evidence.holds(without - 1, never)) --without;
    if (without > loop) return false;
    for (std::size_t state = without; state < evidence.size(); ++state)
        if (evidence.holds(state, from)) return true;
    return false;
}

bool shows(const ExternalTraceImport& evidence, const Property& property, const std::vector<Id<Expr>>& operands,
           Id<Expr> settled, std::size_t loop) {
    const auto some = [&](const auto& broken) {
        for (std::size_t state = 0; state < evidence.size(); ++state)
            if ((!property.at_stable || evidence.holds(state, settled)) && broken(state)) return true;
        return false;
    };
    switch (property.pattern) {
    case Pattern::Always: return some([&](std::size_t state) { return !evidence.holds(state, operands[0]); });
    case Pattern::Never:
    case Pattern::Reachable: return some([&](std::size_t state) { return evidence.holds(state, operands[0]); });
    case Pattern::ExactlyOneOf:
        return some([&](std::size_t state) {
            return std::ranges::count_if(operands, [&](Id<Expr> term) { return evidence.holds(state, term); }) != 1;
        });
    case Pattern::Inevitable:
        if (!evidence.fair()) return false;
        for (std::size_t state = 0; state < evidence.size(); ++state)
            if (evidence.holds(state, operands[0])) return false;
        return true;
    case Pattern::LeadsTo: return evidence.fair() && avoids(evidence, loop, operands[0], operands[1]);
    case Pattern::AlwaysPossible:
    case Pattern::RawCtl:
    case Pattern::Watched:
    case Pattern::RawLtl:
    case Pattern::RawUppaal:
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
    case Pattern::ReachableAllSteps: break;
    }
    return true;
}

}  // namespace

std::string doubt(const TransitionSystem& system, FlatSystem& flat, const Property& property,
                  const ExternalTrace& trace) {
    const Id<Expr> settled = property.at_stable ? flattened(system, flat, system.settled) : flat.exprs.constant(true);
    const bool about_paths = is_liveness(property.pattern);
    std::vector<Id<Expr>> operands;
    for (const Id<Expr> operand : property.operands) {
        operands.push_back(flattened(system, flat, operand));
        if (about_paths) operands.back() = flat.exprs.conjunction(settled, operands.back());
    }
    std::vector<Id<Expr>> terms = flat.justice;
    terms.insert(terms.end(), operands.begin(), operands.end());
    terms.push_back(settled);
    const ExternalTraceImport evidence(flat, trace, std::move(terms));
    if (!evidence.broken().empty()) return evidence.broken();
    return shows(evidence, property, operands, settled, trace.loop.value_or(0))
               ? ""
               : "the trace does not establish the verdict";
}

}  // namespace grafverif
