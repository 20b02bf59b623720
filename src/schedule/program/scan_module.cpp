// SPDX-License-Identifier: MIT
#include "schedule/program/scan_module.hpp"

#include <utility>
#include <vector>

#include "ir/literal.hpp"
#include "schedule/program/program.hpp"

namespace grafverif::schedule {

namespace {

class ScanModule {
public:
    ScanModule(const Scan& scan, Id<Expr> stop, Exprs& exprs) : scan_(scan), stop_(stop), draft_{exprs} {
        draft_.module.name = "program_" + scan.equations.name;
        made_.symbols.resize(variables().size());
        for (const Equations::Variable& variable : variables()) draft_.names.take(variable.name);
    }

    ControllerModule build(bool settles) && {
        declare();
        std::vector<Id<Expr>> unchanged;
        for (const Equations::Stored& stored : scan_.equations.stored) {
            const Id<Symbol> symbol = made_.symbols[stored.variable.index];
            if (!symbol.valid()) continue;
            const Equations::Variable& variable = variables()[stored.variable];
            const Id<Expr> next = copy_(stored.next);
            set(symbol, literal(exprs(), variable.type, variable.initial), next);
            if (settles) unchanged.push_back(exprs().apply(Op::Equal, next, draft_.leaf(symbol)));
        }
        std::vector<Id<Expr>> faults;
        for (const Scan::Event& event : scan_.faults) faults.push_back(copy_(event.condition));
        const Id<Expr> fault = exprs().disjunction(faults);
        const Id<Expr> stops = stop_.valid() ? copy_(stop_) : exprs().constant(false);
        made_.out_of_range = add_flag("stopped", stops);
        const Id<Expr> runs =
            made_.out_of_range.valid() ? exprs().negation(draft_.leaf(made_.out_of_range)) : exprs().constant(true);
        made_.race = add_flag("run_time_fault", exprs().conjunction(runs, fault));
        if (settles) {
            made_.settled = draft_.define("settled", exprs().conjunction(unchanged),
                                          "another scan with the same inputs would change nothing");
            const Id<Expr> any = exprs().disjunction(fault, stops);
            if (!is_false(exprs(), any)) made_.faulting = draft_.define("faulting", any, "causes of faults");
        }
        made_.module = std::move(draft_.module);
        return std::move(made_);
    }

private:
    Exprs& exprs() { return draft_.exprs; }
    const Table<Equations::Variable>& variables() const { return scan_.equations.variables; }

    /// Declares the inputs and `turn`, in the order of the parameters, and the other variables. Only variables on which
    /// outputs and faults depend are declared.
    void declare() {
        const std::vector<bool> read = variables_observed(scan_, stop_);
        for (const bool inputs : {true, false}) {
            for (const Id<Equations::Variable> id : variables().ids()) {
                const Equations::Variable& variable = variables()[id];
                if (!read[id.index] || (variable.role == Equations::Role::Input) != inputs) continue;
                made_.symbols[id.index] = draft_.module.symbols.add(
                    {variable.name, variable.type, TransitionSystem::ParameterSymbol{}, "", variable.origin, {}});
                if (inputs) made_.parameters.push_back(id);
            }
            if (inputs) turn_ = draft_.add("turn", Type{}, TransitionSystem::ParameterSymbol{});
        }
    }

    void set(Id<Symbol> symbol, Id<Expr> initial, Id<Expr> next) {
        const Id<Expr> kept = draft_.leaf(symbol);
        draft_.set(symbol, TransitionSystem::StateSymbol{initial, exprs().conditional(draft_.leaf(turn_), next, kept)});
    }

    /// Adds a flag that remains set after `cause` has been true. The result is invalid if `cause` is never true.
    Id<Symbol> add_flag(const char* preferred, Id<Expr> cause) {
        if (is_false(exprs(), cause)) return {};
        const Id<Symbol> flag = draft_.add(preferred, Type{}, TransitionSystem::ParameterSymbol{},
                                           "faults; a fault remains true after it occurs");
        set(flag, exprs().constant(false), exprs().disjunction(draft_.leaf(flag), cause));
        return flag;
    }

    const Scan& scan_;
    const Id<Expr> stop_;
    Draft draft_;
    ControllerModule made_ = {};
    Id<Symbol> turn_ = {};
    TermCopier copy_{scan_.equations.exprs, draft_.exprs, [this](const Expr& leaf) {
                         return draft_.leaf(made_.symbols[static_cast<std::size_t>(leaf.value)]);
                     }};
};

}  // namespace

std::vector<bool> variables_observed(const Scan& scan, Id<Expr> stop) {
    std::vector<Id<Expr>> roots;
    for (const Scan::Event& event : scan.faults) roots.push_back(event.condition);
    if (stop.valid()) roots.push_back(stop);
    for (const Equations::Stored& stored : scan.equations.stored)
        if (scan.equations.variables[stored.variable].role == Equations::Role::Output) roots.push_back(stored.first);
    return variables_read(scan, std::move(roots));
}

ControllerModule scan_module(const Scan& scan, Id<Expr> stop, bool settles, Exprs& exprs) {
    return ScanModule(scan, stop, exprs).build(settles);
}

}  // namespace grafverif::schedule
