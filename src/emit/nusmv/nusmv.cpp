// SPDX-License-Identifier: MIT
// Writes the modules of a NuSMV model: header, declarations, assignments, definitions.
#include "emit/nusmv/nusmv.hpp"

#include <algorithm>
#include <ostream>
#include <sstream>
#include <string_view>
#include <variant>
#include <vector>

#include "emit/nusmv/text.hpp"
#include "emit/wrapped_text.hpp"
#include "syntax/print/constants.hpp"

namespace grafverif::nusmv {

namespace {

using System = TransitionSystem;

struct ModulePrinter {
    std::ostream& out;
    const System& system;
    const Names& names;
    NamedValues& values;
    Id<System::Module> id = {};
    LeafPrinter leaf = leaf_printer(names, id);

    const System::Module& module() const { return system.modules[id]; }
    const std::string& name(Id<System::Symbol> symbol) const { return names.symbols[id.index][symbol.index]; }
    const Exprs& exprs() const { return values.exprs(); }
    /// Returns `value` in the notation of the model, in which names of values replace their numbers. If `symbol` is
    /// valid, it determines the type of the value.
    Id<Expr> written(Id<Expr> value, Id<System::Symbol> symbol = {}) const { return values.named(id, value, symbol); }
    void print(Id<Expr> value) const { print_expr(out, exprs(), value, nusmv_spelling, leaf); }
};

/// Prints the keyword of a declaration block before its first entry, and a comment before each section of entries.
struct SectionPrinter {
    std::ostream& out;
    const char* keyword = "";
    bool open = false;
    std::string_view section = {};

    void entry(std::string_view of_section) {
        if (!open) out << keyword << '\n';
        if (!of_section.empty() && (!open || of_section != section)) out << "  -- " << of_section << '\n';
        open = true;
        section = of_section;
    }
};

/// Prints a value of `symbol`. A value with more than two cases is printed as a `case` expression.
void print_value(const ModulePrinter& printer, Id<System::Symbol> symbol, Id<Expr> value) {
    const Exprs& exprs = printer.exprs();
    value = printer.written(value, symbol);
    const auto is_conditional = [&](Id<Expr> term) { return exprs[term].op == Op::Conditional; };
    if (!is_conditional(value) || !is_conditional(exprs.operands(value)[2])) {
        printer.print(value);
        return;
    }
    printer.out << "case\n";
    for (; is_conditional(value); value = exprs.operands(value)[2]) {
        printer.out << "    ";
        printer.print(exprs.operands(value)[0]);
        printer.out << " : ";
        printer.print(exprs.operands(value)[1]);
        printer.out << ";\n";
    }
    printer.out << "    TRUE : ";
    printer.print(value);
    printer.out << ";\n  esac";
}

void print_signature(const ModulePrinter& printer) {
    printer.out << "\nMODULE " << printer.names.modules[printer.id.index];
    const char* separator = "(";
    for (const Id<System::Symbol> id : printer.module().symbols.ids()) {
        if (!std::holds_alternative<System::ParameterSymbol>(printer.module().symbols[id].kind)) continue;
        printer.out << separator << printer.name(id);
        separator = ", ";
    }
    printer.out << (*separator == ',' ? ")\n" : "\n");
}

void print_instance(const ModulePrinter& printer, Id<System::Instance> id) {
    const System::Instance& instance = printer.system.instances[id];
    printer.out << "  " << printer.names.instances[id.index] << " : " << printer.names.modules[instance.module.index];
    const char* separator = "(";
    for (const Id<System::Symbol> argument : instance.arguments) {
        printer.out << separator << printer.name(argument);
        separator = ", ";
    }
    printer.out << (*separator == ',' ? ");\n" : ";\n");
}

void print_declaration(const ModulePrinter& printer, Id<System::Symbol> id) {
    const System::Symbol& symbol = printer.module().symbols[id];
    printer.out << "  " << printer.name(id) << " : ";
    if (symbol.type.boolean) {
        printer.out << "boolean;\n";
    } else if (symbol.values.empty()) {
        printer.out << symbol.type.low << ".." << symbol.type.high << ";\n";
    } else {
        const char* separator = "{";
        for (const std::string& name : symbol.values) {
            printer.out << separator << printer.names.values[printer.names.value_places.at(name)];
            separator = ", ";
        }
        printer.out << "};\n";
    }
}

void print_choices(const ModulePrinter& printer) {
    SectionPrinter part{printer.out, "IVAR"};
    for (const Id<System::Symbol> id : printer.module().symbols.ids()) {
        const System::Symbol& symbol = printer.module().symbols[id];
        if (!std::holds_alternative<System::ChoiceSymbol>(symbol.kind)) continue;
        part.entry(symbol.comment);
        print_declaration(printer, id);
    }
}

/// Returns the heading of each instance in main.
std::vector<std::string_view> headings(const System& system) {
    const char* of_charts = system.controllers.size() > 1 ? "the controllers" : "the controller";
    std::vector<std::string_view> found(system.instances.size(),
                                        system.controllers.empty() ? of_charts : "the observers");
    const auto& symbols = system.modules[system.main].symbols;
    const auto note = [&](Id<System::Symbol> symbol, std::string_view heading) {
        if (!symbol.valid()) return;
        if (const auto* member = std::get_if<System::MemberSymbol>(&symbols[symbol].kind))
            found[member->instance.index] = heading;
    };
    for (const System::Component& component : system.components) {
        const bool timer = component.kind == System::Component::Kind::Timer;
        const std::string_view heading = timer ? "the timers" : "the plant and its environment";
        note(component.location, heading);
        for (const auto* named : {&component.variables, &component.inputs})
            for (const System::Named& variable : *named) note(variable.variable, heading);
    }
    for (const System::Controller& controller : system.controllers)
        for (const auto& step : controller.words.steps) note(step.variable, of_charts);
    return found;
}

void print_variables(const ModulePrinter& printer) {
    SectionPrinter part{printer.out, "VAR"};
    for (const Id<System::Symbol> id : printer.module().symbols.ids()) {
        const System::Symbol& symbol = printer.module().symbols[id];
        if (!std::holds_alternative<System::StateSymbol>(symbol.kind)) continue;
        part.entry(symbol.comment);
        print_declaration(printer, id);
    }
    if (printer.id != printer.system.main) return;
    const std::vector<std::string_view> sections = headings(printer.system);
    for (const Id<System::Instance> id : printer.system.instances.ids()) {
        part.entry(sections[id.index]);
        print_instance(printer, id);
    }
}

void print_assignments(const ModulePrinter& printer) {
    SectionPrinter part{printer.out, "ASSIGN"};
    for (const Id<System::Symbol> id : printer.module().symbols.ids()) {
        const System::Symbol& symbol = printer.module().symbols[id];
        const auto* state = std::get_if<System::StateSymbol>(&symbol.kind);
        const auto assignment = [&](const char* of, Id<Expr> value) {
            part.entry(symbol.comment);
            printer.out << "  " << of << '(' << printer.name(id) << ") := ";
            print_value(printer, id, value);
            printer.out << ";\n";
        };
        // NuSMV treats a variable with a single value as a constant, and rejects assignments to it.
        if (state == nullptr || symbol.type.low == symbol.type.high) continue;
        if (state->initial) assignment("init", *state->initial);
        if (state->next) assignment("next", *state->next);
    }
}

void print_definitions(const ModulePrinter& printer) {
    SectionPrinter part{printer.out, "DEFINE"};
    for (const Id<System::Symbol> id : printer.module().symbols.ids()) {
        const System::Symbol& symbol = printer.module().symbols[id];
        const auto* define = std::get_if<System::DefineSymbol>(&symbol.kind);
        if (define == nullptr) continue;
        part.entry(symbol.comment);
        printer.out << "  " << printer.name(id) << " := ";
        print_value(printer, id, define->value);
        printer.out << ";\n";
    }
}

void print_constraints(const ModulePrinter& printer) {
    const auto each = [&](const char* keyword, const std::vector<Id<Expr>>& terms) {
        for (const Id<Expr> term : terms) {
            printer.out << keyword << ' ';
            printer.print(printer.written(term));
            printer.out << ";\n";
        }
    };
    each("INVAR", printer.module().invariants);
    each("TRANS", printer.module().transitions);
    each("JUSTICE", printer.module().justice);
}

void print_module(const ModulePrinter& printer) {
    print_signature(printer);
    print_choices(printer);
    print_variables(printer);
    print_assignments(printer);
    print_definitions(printer);
    print_constraints(printer);
    if (printer.id == printer.system.main) print_properties(printer.out, printer.system, printer.names, printer.values);
}

void print_header(std::ostream& out, const System& system, const Names& names) {
    out << "-- " << system.name << ": NuSMV model written by grafverif\n"
        << "-- to check it: NuSMV -dynamic FILE (dynamic variable reordering: much faster on large models)\n";
    if (!system.constants.empty()) print_comment(out, "constants: " + constants_text(system.constants));
    if (!system.scope.empty()) {
        out << "--\n";
        print_comment(out, system.scope);
    }
    if (std::ranges::find(system.properties, Pattern::Reachable, &Property::pattern) != system.properties.end()) {
        out << "--\n";
        print_comment(out,
                      "A property P with the pattern reachable is written as its negation: P holds if never_P is "
                      "false, and is violated if never_P is true. (EF would require a run to a satisfying state from "
                      "every initial state, and a fair run if there are JUSTICE conditions.)");
    }
    if (names.changed.empty()) return;
    out << "--\n"
           "-- names that are not valid in NuSMV\n";
    std::vector<Names::Changed> scopes;  // one list of changed names for each scope
    for (const Names::Changed& scope : names.changed) {
        const auto same = std::ranges::find(scopes, scope.renamings, &Names::Changed::renamings);
        if (same == scopes.end()) scopes.push_back(scope);
        else same->scope += ", " + scope.scope;
    }
    for (const Names::Changed& scope : scopes) {
        print_comment(out, "  " + scope.scope + ":");
        for (const Renaming& renaming : scope.renamings)
            out << "--     " << renaming.name << " is " << renaming.legal << '\n';
    }
}

}  // namespace

void emit(const System& system, std::ostream& out) {
    const Names names = names_of(system);
    std::ostringstream model;
    print_header(model, system, names);
    NamedValues values(system, names);
    print_module({model, system, names, values, system.main});
    for (const Id<System::Module> id : system.modules.ids())
        if (id != system.main) print_module({model, system, names, values, id});
    print_wrapped(out, model.view(), "--");
}

}  // namespace grafverif::nusmv
