// SPDX-License-Identifier: MIT
// Translates properties to formulas of UPPAAL, pattern by pattern, or states the reason why UPPAAL has no formula for a
// property.
#include "emit/uppaal/queries.hpp"

#include <algorithm>
#include <ostream>
#include <unordered_set>

#include "emit/uppaal/text.hpp"
#include "emit/uppaal/uppaal.hpp"
#include "emit/wide.hpp"
#include "ir/step_names.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"
#include "syntax/print/formula.hpp"

namespace grafverif::uppaal {
namespace {

/// Returns the reason why UPPAAL has no formula for the pattern, or an empty string if UPPAAL has a formula.
std::string_view reason(Pattern pattern) {
    switch (pattern) {
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::Reachable:
    case Pattern::Inevitable:
    case Pattern::LeadsTo:
    case Pattern::NoDeadlock:
    case Pattern::ReachableAllSteps:
    case Pattern::ExactlyOneOf:
    case Pattern::RawUppaal: return {};
    case Pattern::Watched: return "the observer of this property is not part of this model";
    case Pattern::NoTimelock: return "UPPAAL has no query for `no timelock`";
    case Pattern::AlwaysPossible: return "UPPAAL has no query for `always possible` (AG EF)";
    case Pattern::RawCtl: return "UPPAAL queries cannot express arbitrary CTL formulas";
    case Pattern::RawLtl: return "UPPAAL does not support LTL";
    }
    unreachable();
}

/// Returns a remark for the second line of the comment of a query, or an empty text if the formula needs no remark.
std::string_view remark(const Property& property) {
    if (property.pattern == Pattern::RawUppaal) return "as written; ";
    if (property.at_stable) return "in quiescent states; ";
    return "";
}

class Writer {
public:
    Writer(const Network& network, const Names& names)
        : network_(network), terms_(network, names), names_(names), wide_(wide_terms(network)) {}

    std::vector<Query> all() {
        std::vector<Query> list;
        for (const Id<Property> property : network_.properties.ids()) add(list, property);
        return list;
    }

private:
    void add(std::vector<Query>& list, Id<Property> id) {
        const Property& property = network_.properties[id];
        std::string why(reason(property.pattern));
        if (property.pattern == Pattern::RawUppaal) why = what_it_lacks(property.raw);
        if (std::ranges::any_of(property.operands, [&](Id<Expr> operand) { return wide_[operand.index]; }))
            why = too_wide;
        if (!why.empty()) {
            list.push_back({id, property.name, {}, headline(property, property.name) + ": omitted; " + why, {}, why});
            return;
        }
        if (property.pattern == Pattern::ReachableAllSteps) return add_steps(list, id);
        const bool satisfied = !property.expected_violated;
        const std::string outcome = satisfied ? "expected: satisfied" : "expected: not satisfied";
        const std::string comment = headline(property, property.name) + '\n' + std::string(remark(property)) + outcome;
        list.push_back({id, property.name, formula(property), comment, satisfied});
    }

    /// Returns a description of the error in a formula for UPPAAL, such as an unknown name, or an empty string if the
    /// formula is valid.
    std::string what_it_lacks(const std::string& formula) {
        if (known_.empty()) {
            known_.insert(names_.variables.begin(), names_.variables.end());
            for (const Id<Network::Process> id : network_.processes.ids()) {
                const LocalNames& locals = names_.locals[network_.processes[id].automaton.index];
                for (const auto* list : {&locals.parameters, &locals.clocks, &locals.locations})
                    for (const std::string& name : *list) known_.insert(names_.processes[id.index] + '.' + name);
            }
        }
        const auto known = [this](std::string_view name) {
            return known_.contains(std::string(name)) ? std::optional(FormulaName{}) : std::nullopt;
        };
        const auto fault = formula_fault(FormulaLanguage::Uppaal, formula, known);
        return fault ? fault->what : std::string();
    }

    /// Adds one query per step. If the expected verdict is `violated`, some step is unreachable, but no single query
    /// has an expected result.
    void add_steps(std::vector<Query>& list, Id<Property> id) {
        const Property& property = network_.properties[id];
        const bool satisfied = !property.expected_violated;
        const std::string outcome = satisfied ? "expected: satisfied" : "expected for at least one step: not satisfied";
        for (const Id<Network::Variable> step : steps(property)) {
            const std::string name = property.name + '.' + step_variable_name(network_, step);
            list.push_back(
                {id, name, "E<> " + (property.at_stable ? settled() + " && " : "") + names_.variables[step.index],
                 headline(property, name) + "\nthis step can become active; " + std::string(remark(property)) + outcome,
                 satisfied ? std::optional(true) : std::nullopt});
        }
    }

    /// Returns the steps that the property names. If the property names no step, returns the steps of all controllers.
    std::vector<Id<Network::Variable>> steps(const Property& property) const {
        std::vector<Id<Network::Variable>> found;
        for (const Id<Expr> operand : property.operands)
            found.push_back({static_cast<std::uint32_t>(network_.exprs[operand].value)});
        if (!found.empty()) return found;
        for (const Id<Network::Variable> id : network_.variables.ids())
            if (network_.variables[id].role == Network::Role::Step) found.push_back(id);
        return found;
    }

    std::string formula(const Property& property) {
        const auto& operands = property.operands;
        switch (property.pattern) {
        case Pattern::Always: return "A[] " + whenever(property, operands[0]);
        case Pattern::Never: return "A[] " + guarded(property, "not " + terms_.bracketed(operands[0]));
        case Pattern::Reachable: return "E<> " + also(property, operands[0]);
        case Pattern::Inevitable: return "A<> " + also(property, operands[0]);
        case Pattern::LeadsTo: return also(property, operands[0]) + " --> " + also(property, operands[1]);
        case Pattern::NoDeadlock: return "A[] " + guarded(property, "not deadlock");
        case Pattern::ExactlyOneOf: return "A[] " + guarded(property, sum(operands) + " == 1");
        case Pattern::RawUppaal: return property.raw;
        case Pattern::ReachableAllSteps:
        case Pattern::NoTimelock:
        case Pattern::AlwaysPossible:
        case Pattern::RawCtl:
        case Pattern::Watched:
        case Pattern::RawLtl: break;
        }
        unreachable();
    }

    std::string settled() { return '(' + terms_.text(network_.settled) + ')'; }

    /// Returns `text`, restricted to the states in which the property is evaluated.
    std::string guarded(const Property& property, const std::string& text) {
        return property.at_stable ? settled() + " imply " + text : text;
    }
    std::string whenever(const Property& property, Id<Expr> operand) {
        return property.at_stable ? settled() + " imply " + terms_.bracketed(operand) : plain(operand);
    }
    /// Returns the conjunction of the operand and the condition for states in which the property is evaluated.
    std::string also(const Property& property, Id<Expr> operand) {
        return property.at_stable ? settled() + " && " + terms_.bracketed(operand) : plain(operand);
    }
    std::string plain(Id<Expr> operand) {
        return network_.exprs[operand].op == Op::Conditional ? terms_.bracketed(operand) : terms_.text(operand);
    }

    std::string sum(const std::vector<Id<Expr>>& operands) {
        std::string text;
        for (const Id<Expr> operand : operands) text += (text.empty() ? "" : " + ") + terms_.bracketed(operand);
        return text;
    }

    static std::string headline(const Property& property, const std::string& name) {
        return property.text.empty() ? name : name + ": " + printable(property.text);
    }

    const Network& network_;
    Terms terms_;
    const Names& names_;
    std::vector<bool> wide_;
    std::unordered_set<std::string> known_ = {};  ///< names that formulas may use; computed on first use
};

}  // namespace

std::vector<Query> queries(const Network& network, const Names& names) { return Writer(network, names).all(); }

std::vector<Formula> formulas(const Network& network) {
    std::vector<Formula> list;
    for (Query& query : queries(network, names(network)))
        list.push_back({query.property, std::move(query.name), std::move(query.formula)});
    return list;
}

std::vector<Inexpressible> inexpressible(const Network& network) {
    std::vector<Inexpressible> list;
    for (const Query& query : queries(network, names(network)))
        if (!query.reason.empty()) list.push_back({query.property, query.reason});
    return list;
}

void emit_queries(const Network& network, std::ostream& out) {
    std::string text;
    for (const Query& query : queries(network, names(network))) {
        std::string quoted = query.comment;
        for (std::size_t at = quoted.find("*/"); at != std::string::npos; at = quoted.find("*/", at))
            quoted.insert(at + 1, " ");
        text += (text.empty() ? "/*\n" : "\n/*\n") + quoted + "\n*/\n";
        if (!query.formula.empty()) text += query.formula + '\n';
    }
    out << text;
}

}  // namespace grafverif::uppaal
