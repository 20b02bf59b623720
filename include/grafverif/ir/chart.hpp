// SPDX-License-Identifier: MIT
// Chart: a GRAFCET (IEC 60848) as written, after names are resolved and before any evolution rule is applied.
//
// A Chart can represent every construct of the standard. `derive`, which translates a Chart to Equations, rejects the
// constructs that it cannot translate exactly. Expressions are stored in `exprs`; apart from
// constants, their leaves are Variable (index in `variables`), Step (step variable; index in
// `steps`) and Timed (index in `time_conditions`).
//
// Invariants (see verify): every id is in its table; every condition is Boolean; every stored value has the type of its
// target. Names are unique in their scope (variables in the chart, steps in their partial chart, transitions in the
// chart). A partial chart that is an expansion has one entry step and one exit step; every initial value is in the
// range of its variable.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/step_name.hpp"
#include "grafverif/ir/type.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct Program;

/// A reference to a PLC program (ir/program/program.hpp); it may be empty. Copies of a reference share one program; two
/// references are equal if their programs are equal.
struct ProgramReference {
    std::shared_ptr<const Program> shared = {};

    explicit operator bool() const { return shared != nullptr; }
    const Program& operator*() const { return *shared; }
    bool operator==(const ProgramReference& other) const;
};

struct Chart {
    enum class VariableKind { Input, Output, Internal };
    struct Variable {
        std::string name = {};
        VariableKind kind = VariableKind::Input;
        Type type = {};
        std::int64_t initial = 0;
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };

    enum class StepKind { Ordinary, Macro, Enclosing };
    struct PartialChart;
    struct Step {
        std::string name = {};  ///< name of the step, such as `2`; the step variable of step `2` is `X2`
        StepKind kind = StepKind::Ordinary;
        bool initial = false;              ///< true for an initial step (IEC 60848)
        bool activation_link = false;      ///< true if the activation of the enclosing step activates this step
        bool entry = false, exit = false;  ///< true for the entry or exit step of an expansion (clause 7)
        Id<PartialChart> chart = {};
        Span origin = {};
        bool operator==(const Step&) const = default;
    };

    enum class PartialKind { Plain, Expansion, Enclosed };
    /// A partial chart. The steps and transitions that are written directly in the grafcet belong to a partial chart
    /// whose `name` is empty.
    struct PartialChart {
        std::string name = {};
        PartialKind kind = PartialKind::Plain;
        Id<Step> owner = {};  ///< the macro-step or enclosing step to which the partial chart belongs, if any
        Span origin = {};
        bool operator==(const PartialChart&) const = default;
    };

    struct Transition {
        std::string name = {};
        std::vector<Id<Step>> from = {};  ///< steps upstream; empty for a source transition
        std::vector<Id<Step>> to = {};    ///< steps downstream; empty for a sink transition
        Id<Expr> condition = {};
        Id<PartialChart> chart = {};
        Span origin = {};
        bool operator==(const Transition&) const = default;
    };

    /// `t1/v/t2` (IEC 60848, time-dependent conditions): the condition becomes true `rise_ms` milliseconds after v
    /// (`watched`) becomes true, and false `fall_ms` milliseconds after v becomes false.
    struct TimeCondition {
        std::int64_t rise_ms = 0;
        Id<Expr> watched = {};  ///< the observed Boolean term v
        std::int64_t fall_ms = 0;
        Span origin = {};
        bool operator==(const TimeCondition&) const = default;
    };

    /// Continuous action: `output` is true while `step` is active and `condition` holds.
    struct ContinuousAction {
        Id<Step> step = {};
        Id<Variable> output = {};
        Id<Expr> condition = {};    ///< assignation condition of the action; default: the constant true
        std::int64_t delay_ms = 0;  ///< delay of a delayed action (`after`); 0 for an action without delay
        std::int64_t limit_ms = 0;  ///< time limit of a time-limited action (`for`); 0 for an action without time limit
        Span origin = {};
        bool operator==(const ContinuousAction&) const = default;
    };

    enum class StoredOn { Activation, Deactivation, Event, Clearing };
    /// Stored action: executes `target := value`. According to `on`, the action is executed when `step` is activated or
    /// deactivated, when `event` occurs while `step` is active, or when `transition` is cleared.
    struct StoredAction {
        StoredOn on = StoredOn::Activation;
        Id<Step> step = {};              ///< step of the action; invalid for Clearing
        Id<Transition> transition = {};  ///< transition that triggers the action; valid only for Clearing
        Id<Variable> target = {};
        Id<Expr> value = {};
        Id<Expr> event = {};  ///< event that triggers the action; valid only for Event
        Span origin = {};
        bool operator==(const StoredAction&) const = default;
    };

    enum class ForcedTo { Empty, Current, Initial, Steps };  ///< forced situation: {}, {*}, {INIT}, {steps} (clause 7)
    struct ForcingOrder {
        Id<Step> step = {};
        Id<PartialChart> forced = {};
        ForcedTo to = ForcedTo::Empty;
        std::vector<Id<Step>> situation = {};  ///< the forced situation, only for ForcedTo::Steps
        Span origin = {};
        bool operator==(const ForcingOrder&) const = default;
    };

    /// An assumption on the inputs (`constraint`): input combinations that violate it never occur. A constraint
    /// restricts only free inputs. In a closed loop with a plant, a constraint is a property to prove.
    struct Constraint {
        Id<Expr> condition = {};  ///< Boolean condition over inputs only
        Span origin = {};
        bool operator==(const Constraint&) const = default;
    };

    /// `accept CODE SUBJECT "reason"` accepts a finding about the chart.
    struct Acceptance {
        std::string code = {};  ///< finding code (see ir/finding.hpp)

        /// Subject of the finding, such as `X4`, `t3` or `LOCK`; if empty, findings about any subject are accepted.
        /// With the subject `H.`, findings about the elements of the partial chart `H` are accepted.
        std::string subject = {};
        std::string reason = {};
        Span origin = {};
        bool operator==(const Acceptance&) const = default;
    };

    std::string name = {};
    Exprs exprs = {};
    Table<Variable> variables = {};
    Table<PartialChart> partial_charts = {};
    Table<Step> steps = {};
    Table<Transition> transitions = {};
    Table<TimeCondition> time_conditions = {};  ///< all distinct time conditions, in the order of their first use
    Table<ContinuousAction> continuous = {};
    Table<StoredAction> stored = {};
    Table<ForcingOrder> forcing = {};
    std::vector<Constraint> constraints = {};
    std::vector<Acceptance> accepted = {};
    /// The PLC program that a controller executes instead of the rules of IEC 60848. A chart with a program declares
    /// only the variables and steps of this program (ir/program/interface.hpp). Only controllers of closed loops can
    /// execute such a chart.
    ProgramReference program = {};
    std::string instance_of = {};  ///< name of the chart of which this chart is an instance; empty if there is none
    bool has_parameters = false;   ///< true if the chart is declared with parameters
    bool has_defaults = true;      ///< true if the constants of an instance have their declared values
    Span origin = {};              ///< position of the name of the chart or of the instance

    bool operator==(const Chart&) const = default;
};

/// True for an instance that differs from its chart only in the names of inputs and outputs.
inline bool is_repeated(const Chart& chart) { return !chart.instance_of.empty() && chart.has_defaults; }

StepName name_of(const Chart& chart, Id<Chart::Step> step);

/// Returns the step variable of `step`: `X2`, or `G2.X2` for a step of the named partial chart G2.
std::string step_variable(const Chart& chart, Id<Chart::Step> step);

/// Terms that are read by a transition, by an action, or by a time condition that a transition or an action reads.
struct ReadTerms {
    std::vector<bool> terms = {};            ///< for each term of Chart::exprs: true if the term is read
    std::vector<bool> time_conditions = {};  ///< for each time condition: true if the condition is read
};
ReadTerms read_terms(const Chart& chart);

/// Returns the violated invariants, one sentence each; empty for a well-formed chart.
std::vector<std::string> verify(const Chart& chart);

}  // namespace grafverif
