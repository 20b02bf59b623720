// SPDX-License-Identifier: MIT
// Prints properties as specifications. Operands are always in parentheses, because `AG x -> y` would be parsed as `(AG
// x) -> y`.
//
// A specification of SMV is true if every initial state satisfies it; under fairness, only initial states of fair runs
// are considered. All patterns except `reachable` are requirements on every initial state. The specification `EF p`
// would be false if p were reachable from one initial state but not from another. `EF p` would be vacuously true if no
// run were fair. Therefore `reachable p` is written as `never p`.
#include <ostream>

#include "emit/nusmv/text.hpp"
#include "ir/patterns.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"

namespace grafverif::nusmv {

namespace {

using System = TransitionSystem;

struct Printer {
    std::ostream& out;
    const System& system;
    NamedValues& values;
    LeafPrinter leaf = {};

    std::string text(Id<Expr> term) const {
        const Id<Expr> written = values.named(system.main, term);
        return expr_text(values.exprs(), written, nusmv_spelling, leaf);
    }

    std::string bracketed(Id<Expr> term) const {
        const Op op = system.exprs[term].op;
        if (is_leaf(op) || is_constant(op)) return text(term);
        return '(' + text(term) + ')';
    }

    /// Returns `term` in parentheses, restricted to quiescent states if the property is `at stable`.
    std::string restricted(const Property& property, Id<Expr> term) const {
        if (!property.at_stable) return bracketed(term);
        return '(' + bracketed(system.settled) + " & " + bracketed(term) + ')';
    }

    /// An operand that contains an operator is in parentheses, as the grammar of NuSMV 2.5 requires.
    std::string exactly_one(const Property& property) const {
        if (property.operands.size() == 1) return text(property.operands[0]);
        std::string list;
        for (const Id<Expr> operand : property.operands) list += (list.empty() ? "" : ", ") + bracketed(operand);
        return "count(" + list + ") = 1";
    }

    /// Returns `settled -> (invariant)` if the property is `at stable`, otherwise the invariant.
    std::string invariant(const Property& property, const std::string& condition) const {
        return property.at_stable ? bracketed(system.settled) + " -> (" + condition + ')' : condition;
    }

    std::string negated(Id<Expr> term) const { return '!' + bracketed(term); }
};

struct Specification {
    std::string_view keyword = {};
    std::string formula = {};
};

Specification specification(const Printer& printer, const Property& property) {
    const auto operand = [&](std::size_t k) { return printer.restricted(property, property.operands[k]); };
    switch (property.pattern) {
    case Pattern::Always: return {"INVARSPEC", printer.invariant(property, printer.text(property.operands[0]))};
    case Pattern::Never:
    case Pattern::Reachable: return {"INVARSPEC", printer.invariant(property, printer.negated(property.operands[0]))};
    case Pattern::ExactlyOneOf: return {"INVARSPEC", printer.invariant(property, printer.exactly_one(property))};
    case Pattern::Inevitable: return {"SPEC", "AF " + operand(0)};
    case Pattern::LeadsTo: return {"SPEC", "AG (" + operand(0) + " -> AF " + operand(1) + ')'};
    case Pattern::AlwaysPossible: return {"SPEC", "AG EF " + operand(0)};
    case Pattern::RawCtl: return {"SPEC", property.raw};
    case Pattern::RawLtl: return {"LTLSPEC", property.raw};
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
    case Pattern::Watched:
    case Pattern::ReachableAllSteps:
    case Pattern::RawUppaal: break;  // `verify` excludes the pattern RawUppaal
    }
    unreachable();
}

void print_omitted(std::ostream& out, const System::Omitted& omitted) {
    const Property& property = omitted.property;
    out << "\n-- " << property.name;
    if (!property.text.empty()) out << ": " << printable(property.text);
    out << "\n"
           "-- omitted: "
        << omitted.reason << '\n';
}

void print_heading(std::ostream& out, const Property& property, const std::string& legal) {
    const bool renamed = property.name != legal;
    if (!property.text.empty() || property.expected_violated || renamed) {
        out << "-- " << property.name;
        if (!property.text.empty()) out << ": " << printable(property.text);
        if (property.expected_violated) out << " (expected: violated)";
        if (property.pattern == Pattern::Reachable) out << "; holds if " << legal << " is false";
        out << '\n';
    }
}

}  // namespace

void print_properties(std::ostream& out, const System& system, const Names& names, NamedValues& values) {
    const Printer printer{out, system, values, leaf_printer(names, system.main)};
    auto omitted = system.omitted.begin();
    for (const Id<Property> id : system.properties.ids()) {
        for (; omitted != system.omitted.end() && omitted->before <= id.index; ++omitted) print_omitted(out, *omitted);
        const Property& property = system.properties[id];
        const Specification made = specification(printer, property);
        out << '\n';
        print_heading(out, property, names.properties[id.index]);
        if (is_liveness(property.pattern) && system.components.empty())
            out << "-- this model has no plant; a response that depends on the plant requires `--plant automata`\n";
        out << made.keyword << " NAME " << names.properties[id.index] << " := " << made.formula << ";\n";
    }
    for (; omitted != system.omitted.end(); ++omitted) print_omitted(out, *omitted);
}

}  // namespace grafverif::nusmv
