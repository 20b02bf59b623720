// SPDX-License-Identifier: MIT
// Derivation: data shared by all functions of derive. A Derivation contains the chart, the equations that have already
// been derived, the map from elements of the chart to the equations, and the size limits of substitution.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

// The hierarchy of a chart, which the derivation uses to reduce macro-steps, enclosing steps and forcing orders to
// plain steps.
//
// An expansion belongs to the chart of its macro-step. The activation of the macro-step activates the entry step, and
// the exit step replaces the macro-step upstream of transitions (IEC 60848). The region of a partial chart consists of
// its steps and the steps of its expansions; an enclosing step or a forcing order applies to the complete region.
//
// The relation "encloses or forces" between charts is acyclic, which defines an order of the charts.

struct Hierarchy {
    /// For each step: the step that is activated in its place (`entered`), and the step that must be active for its
    /// downstream transitions to be enabled (`left`). For a macro-step, these are the entry step and the exit step of
    /// its expansion; for any other step, both are the step itself.
    std::vector<Id<Chart::Step>> entered = {}, left = {};
    /// For each partial chart: the root chart that contains it as a (nested) expansion, or the partial chart itself if
    /// it is not an expansion.
    std::vector<Id<Chart::PartialChart>> root_chart = {};
    /// Root charts in topological order: each chart follows the charts that enclose or force it.
    std::vector<Id<Chart::PartialChart>> order = {};
    std::vector<std::vector<Id<Chart::Step>>> region = {};  ///< for each partial chart: the steps of its region
    std::vector<std::vector<Id<Chart::ForcingOrder>>> orders =
        {};  ///< for each partial chart: the forcing orders that apply to its region

    /// For each forcing order: the steps that it activates, sorted.
    std::vector<std::vector<Id<Chart::Step>>> forced = {};
    std::vector<bool> initial = {};  ///< for each step: true if it is active at power-on
};

/// Computes the hierarchy. The result is empty after an error: a cycle of charts, or contradictory forcing orders.
std::optional<Hierarchy> hierarchy(const Chart& chart, Diagnostics& diagnostics);

/// True if the forcing orders `one` and `other` are contradictory. Requires that both orders force a common partial
/// chart.
bool conflict(const Chart& chart, const Hierarchy& hierarchy, Id<Chart::ForcingOrder> one,
              Id<Chart::ForcingOrder> other);

/// Maximum number of nodes of one equation as a tree.
inline constexpr std::size_t term_size_limit = 1'000'000;
/// Maximum total number of nodes of all terms that substitution and race conditions add.
inline constexpr std::size_t total_size_limit = 10'000'000;
inline constexpr std::size_t term_depth_limit = 2'000;
inline constexpr std::size_t stored_value_limit = 1'000;  ///< maximum number of distinct values stored in one variable

/// Computes the size and depth of terms as trees, in which a shared subterm counts several times, because terms are
/// printed as trees. Sizes saturate far above every limit.
class Measures {
public:
    std::uint64_t size(const Exprs& exprs, Id<Expr> term);
    std::uint32_t depth(const Exprs& exprs, Id<Expr> term);

private:
    void extend(const Exprs& exprs);

    std::vector<std::uint64_t> sizes_ = {};
    std::vector<std::uint32_t> depths_ = {};
};

/// The time at which a term is evaluated in a cycle, which determines the meaning of its leaves.
enum class TermPosition {
    Before,  ///< in a cycle, over the values before the cycle: conditions, events, stored values
    After,   ///< at the end of a cycle, over the values after the cycle: outputs, terms observed by timers
    First,   ///< as Before, for an evolution in which no signal has an edge, such as the first evolution
};

struct Derivation {
    const Chart& chart;
    Diagnostics& diagnostics;
    Equations equations = {};
    Hierarchy hierarchy = {};
    UniqueNames names = {};                             ///< names of timers and of variables of the equations
    std::vector<Id<Equations::Variable>> steps = {};    ///< the variable X_s of each step
    std::vector<Id<Equations::Variable>> firings = {};  ///< the variable CF_t of each transition

    /// The variable X_s of each step as a term. The terms are stored, because repeated searches for these leaves would
    /// dominate the run time.
    std::vector<Id<Expr>> step_leaves = {};
    /// The variable CF_t of each transition as a term.
    std::vector<Id<Expr>> firing_leaves = {};
    std::vector<std::vector<Id<Chart::ContinuousAction>>> continuous = {};  ///< continuous actions of each variable
    std::vector<std::vector<Id<Chart::StoredAction>>> stored = {};          ///< stored actions of each variable
    std::vector<bool> reads_output = {};  ///< for each term of the chart: true if it contains a continuous output

    /// For each variable of the chart that is a continuous output: the right-hand side of equation (13).
    std::vector<Id<Expr>> values = {};
    std::unordered_map<std::uint32_t, Id<Equations::Variable>> previous = {};  ///< P_e for each term e of the equations
    std::unordered_map<std::uint32_t, Id<Equations::Variable>> watched = {};   ///< V_e for each term e of the equations

    /// Timers, identified by observed variable, t1 and t2.
    std::map<std::tuple<Id<Equations::Variable>, std::int64_t, std::int64_t>, Id<Equations::Timer>> timers = {};
    Measures measures = {};
    std::uint64_t added = 0;        ///< number of added nodes; see total_size_limit
    bool exhausted = false;         ///< true if the total limit was exceeded and the error was reported
    std::size_t errors_before = 0;  ///< number of errors before this derivation
};

/// True if an error was found in the current chart.
inline bool failed(const Derivation& derivation) { return derivation.diagnostics.errors() != derivation.errors_before; }

/// True if `variable` is an output without stored actions; such an output has an equation (13).
bool is_continuous(const Derivation& derivation, Id<Chart::Variable> variable);

/// True if `step` is active at power-on.
inline bool is_initial(const Derivation& derivation, Id<Chart::Step> step) {
    return derivation.equations.variables[derivation.steps[step.index]].initial != 0;
}

/// Returns the leaf of the equations that reads `variable`.
Id<Expr> variable_leaf(Derivation& derivation, Id<Equations::Variable> variable);

/// Returns the constant false if `term` is a conjunction that contains an operand and the negation of this operand;
/// otherwise returns `term`.
Id<Expr> consistent(Exprs& exprs, Id<Expr> term);

/// Translates the term `root` of the chart to the variables of the equations, with outputs replaced by their equations.
/// The result is invalid if the term would be too large. The error message calls the term `what`.
Id<Expr> over_equations(Derivation& derivation, Id<Expr> root, TermPosition reading, Span where,
                        const std::string& what);

/// Returns the variable P_e as a term. P_e is the value in the previous cycle of the term e = `term`, which is a term
/// over the equations.
Id<Expr> previous_value(Derivation& derivation, Id<Expr> term, Span where);

/// Returns the variable V_e, which is the value after the previous cycle of the term e = `term`, a term over the
/// equations. For a step variable, returns the variable of the step activity.
Id<Equations::Variable> level(Derivation& derivation, Id<Expr> term, Span where);

/// Returns the timer t1/v/t2 for the observed variable `watched`.
Id<Equations::Timer> timer(Derivation& derivation, Id<Equations::Variable> watched, std::int64_t rise_ms,
                           std::int64_t fall_ms, Span where);

/// Returns the output of `timer` as a term.
Id<Expr> end_leaf(Derivation& derivation, Id<Equations::Timer> timer);

/// Returns the prefix of variable names for a step of a named partial chart G2: `G2_`; otherwise an empty string.
std::string qualifier(const StepName& step);

/// Adds `size` to the number of added nodes. If this number exceeds total_size_limit, returns false, and reports an
/// error once per derivation.
bool afford(Derivation& derivation, std::uint64_t size);

/// Returns the condition under which `transition` is cleared (equation (11)). With TermPosition::First, no signal has
/// an edge. After an error, the result does not contain the transition condition.
Id<Expr> clearing_condition(Derivation& derivation, const Chart::Transition& transition, TermPosition reading);

/// Returns the condition under which `action` is executed: its transition is cleared, its step changes, or an event
/// occurs while its step is active. The result is invalid after an error.
Id<Expr> trigger_of(Derivation& derivation, const Chart::StoredAction& action);

/// `derive_firings` derives equations (11). `derive_steps` derives equations (12) and the conflicts between forcing
/// orders.
void derive_firings(Derivation& derivation);
void derive_steps(Derivation& derivation);

/// Derives equations (13) of all continuous outputs. The outputs that an output reads are derived before this output.
void derive_outputs(Derivation& derivation);

/// Derives next values, race conditions and first values of the variables with stored actions.
void derive_stored(Derivation& derivation);

}  // namespace grafverif
