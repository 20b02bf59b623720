// SPDX-License-Identifier: MIT
#include "schedule/program/program.hpp"

#include <algorithm>
#include <utility>

#include "ir/literal.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;

class Translation {
public:
    Translation(const Scan& scan, const std::vector<ScanProperty>& properties) : scan_(scan), properties_(properties) {
        made_.symbols.resize(scan.equations.variables.size());
        made_.system.name = scan.equations.name;
        made_.system.main = made_.system.modules.add({"main", {}, {}, {}, {}});
    }

    ProgramSystem translate() {
        std::vector<Id<Expr>> faults;
        for (const Scan::Event& event : scan_.faults) faults.push_back(event.condition);
        std::vector<Id<Expr>> roots = faults;
        for (const ScanProperty& property : properties_) roots.push_back(property.condition);
        add_variables(roots);
        TermCopier copy(scan_.equations.exprs, exprs(), [this](const Expr& leaf) {
            return exprs().leaf(Op::Variable, made_.symbols[static_cast<std::size_t>(leaf.value)].index);
        });
        for (const Equations::Stored& stored : scan_.equations.stored) {
            const Id<System::Symbol> symbol = made_.symbols[stored.variable.index];
            if (!symbol.valid()) continue;
            const Equations::Variable& variable = scan_.equations.variables[stored.variable];
            main().symbols[symbol].kind =
                System::StateSymbol{literal(exprs(), variable.type, variable.initial), copy(stored.next)};
        }
        Id<Expr> valid = exprs().constant(true);     // condition that no fault has occurred up to the end of this scan
        Id<Expr> complete = exprs().constant(true);  // condition that no fault has occurred in earlier scans
        if (!faults.empty()) {
            for (Id<Expr>& fault : faults) fault = copy(fault);
            const Id<Expr> fault = exprs().disjunction(faults);
            const Id<System::Symbol> before =
                main().symbols.add({"run-time fault", Type{}, System::StateSymbol{}, "", {}, {}});
            const Id<Expr> faulted = exprs().leaf(Op::Variable, before.index);
            main().symbols[before].kind =
                System::StateSymbol{exprs().constant(false), exprs().disjunction(faulted, fault)};
            valid = exprs().negation(exprs().disjunction(faulted, fault));
            complete = exprs().negation(faulted);
            made_.no_fault = made_.system.properties.add(
                property("no_fault", Pattern::Never, exprs().conjunction(exprs().negation(faulted), fault), {}));
        }
        for (const ScanProperty& one : properties_) {
            Id<Expr> condition = copy(one.condition);
            if (one.pattern == Pattern::Always) condition = exprs().disjunction(exprs().negation(valid), condition);
            else condition = exprs().conjunction(one.about_fault ? complete : valid, condition);
            made_.system.properties.add(property(one.name, one.pattern, condition, one.origin));
        }
        made_.system.settled = exprs().constant(true);
        return std::move(made_);
    }

private:
    Exprs& exprs() { return made_.system.exprs; }
    System::Module& main() { return made_.system.modules[made_.system.main]; }

    static Property property(std::string name, Pattern pattern, Id<Expr> condition, Span origin) {
        Property made;
        made.name = std::move(name);
        made.pattern = pattern;
        made.operands = {condition};
        made.origin = origin;
        return made;
    }

    /// Adds the variables on which `roots` depend, directly or through next values of other variables.
    void add_variables(std::vector<Id<Expr>> roots) {
        const std::vector<bool> read = variables_read(scan_, std::move(roots));
        for (const Id<Equations::Variable> id : scan_.equations.variables.ids()) {
            if (!read[id.index]) continue;
            const Equations::Variable& variable = scan_.equations.variables[id];
            made_.symbols[id.index] =
                main().symbols.add({variable.name, variable.type, System::StateSymbol{}, "", variable.origin, {}});
        }
    }

    const Scan& scan_;
    const std::vector<ScanProperty>& properties_;
    ProgramSystem made_ = {};
};

}  // namespace

ProgramSystem schedule_program(const Scan& scan, const std::vector<ScanProperty>& properties) {
    return Translation(scan, properties).translate();
}

}  // namespace grafverif
