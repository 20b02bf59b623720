// SPDX-License-Identifier: MIT
// What the parts of derive share: the chart, the equations so far, where each entity of the chart went, and the limits
// that keep substitution from blowing up.
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

// Hierarchy of a chart: what macro-steps, enclosing steps and forcing orders mean for its plain steps.
//
// An expansion belongs to the chart of its macro-step: entering the macro-step enters the entry step, its exit step
// stands for it upstream of transitions (IEC 60848, 4.5.3). The region of a partial chart are its steps and those of the
// expansions in it; a region is enclosed or forced as a whole.
//
// No chart encloses or forces itself, over however many levels: that gives the charts an order.

struct Hierarchy {
    /// Per step: what is activated in its place, and what is active in its place when it can be left: itself, or of a
    /// macro-step the entry and the exit step of its expansion.
    std::vector<Id<Chart::Step>> entered = {}, left = {};
    /// Per partial chart: the chart it is part of, as an expansion or an expansion in one; else itself.
    std::vector<Id<Chart::PartialChart>> home = {};
    /// Homes, each after those that enclose it or force something in it.
    std::vector<Id<Chart::PartialChart>> order = {};
    std::vector<std::vector<Id<Chart::Step>>> region = {};  ///< per partial chart
    std::vector<std::vector<Id<Chart::ForcingOrder>>> orders =
        {};                                                 ///< per partial chart: those that its region is under
    std::vector<std::vector<Id<Chart::Step>>> forced = {};  ///< per order: the steps it makes active, sorted
    std::vector<bool> initial = {};                         ///< per step: active at power-on
};

/// Nothing after adding an error: a cycle, or a chart that one step forces twice.
std::optional<Hierarchy> hierarchy(const Chart& chart, Diagnostics& diagnostics);

/// Whether the two orders cannot be obeyed together.
bool conflict(const Chart& chart, const Hierarchy& hierarchy, Id<Chart::ForcingOrder> one,
              Id<Chart::ForcingOrder> other);

inline constexpr std::size_t term_size_limit = 1'000'000;    ///< nodes of one equation, as printed
inline constexpr std::size_t total_size_limit = 10'000'000;  ///< nodes of all terms that substitution and races add
inline constexpr std::size_t term_depth_limit = 2'000;
inline constexpr std::size_t stored_value_limit = 1'000;  ///< different values stored in one variable

/// Size and depth of terms as trees, which is how they are printed. Sizes saturate well above every limit.
class Measures {
public:
    std::uint64_t size(const Exprs& exprs, Id<Expr> term);
    std::uint32_t depth(const Exprs& exprs, Id<Expr> term);

private:
    void extend(const Exprs& exprs);

    std::vector<std::uint64_t> sizes_ = {};
    std::vector<std::uint32_t> depths_ = {};
};

/// Where a term is read, which decides what a leaf of the chart stands for.
enum class Reading {
    Before,  ///< in a cycle, over the values before it: conditions, events, values to store
    After,   ///< at its end, over the values after it: outputs, what timers watch
    First,   ///< in the first evolution, where there are no edges: values to store
};

struct Derivation {
    const Chart& chart;
    Diagnostics& diagnostics;
    Equations equations = {};
    Hierarchy hierarchy = {};
    UniqueNames names = {};                             ///< of the variables of the equations, and of timers
    std::vector<Id<Equations::Variable>> steps = {};    ///< X_s, per step
    std::vector<Id<Equations::Variable>> firings = {};  ///< CF_t, per transition
    std::vector<Id<Expr>> step_leaves = {};             ///< X_s as a term: looking leaves up anew is what costs most
    std::vector<Id<Expr>> firing_leaves = {};           ///< CF_t as a term
    std::vector<std::vector<Id<Chart::ContinuousAction>>> continuous = {};  ///< per variable
    std::vector<std::vector<Id<Chart::StoredAction>>> stored = {};          ///< per variable
    std::vector<bool> reads_output = {};  ///< per term of the chart: a continuous output occurs in it
    std::vector<Id<Expr>> values = {};    ///< per variable: equation (13) of a continuous output
    std::unordered_map<std::uint32_t, Id<Equations::Variable>> previous = {};  ///< P_e, per term e of the equations
    std::unordered_map<std::uint32_t, Id<Equations::Variable>> watched = {};   ///< V_e, likewise
    /// Timers by watched variable, t1 and t2.
    std::map<std::tuple<Id<Equations::Variable>, std::int64_t, std::int64_t>, Id<Equations::Timer>> timers = {};
    Measures measures = {};
    std::uint64_t added = 0;        ///< towards total_size_limit
    bool exhausted = false;         ///< the total was exceeded, and said so
    std::size_t errors_before = 0;  ///< of the inputs handled earlier
};

/// Whether an error was found in this chart.
inline bool failed(const Derivation& derivation) { return derivation.diagnostics.errors() != derivation.errors_before; }

/// Whether `variable` is an output without stored actions, which has an equation (13).
bool is_continuous(const Derivation& derivation, Id<Chart::Variable> variable);

/// Whether `step` is active at power-on.
inline bool is_initial(const Derivation& derivation, Id<Chart::Step> step) {
    return derivation.equations.variables[derivation.steps[step.index]].initial != 0;
}

/// A Variable leaf of the equations.
Id<Expr> variable_leaf(Derivation& derivation, Id<Equations::Variable> variable);

/// `term`, or false where it is a conjunction of some operand and its negation among others.
Id<Expr> consistent(Exprs& exprs, Id<Expr> term);

/// The term `root` of the chart over the variables of the equations, outputs replaced by their equations. Not valid
/// after an error was added: the term, named `what`, would be too large.
Id<Expr> over_equations(Derivation& derivation, Id<Expr> root, Reading reading, Span where, const std::string& what);

/// P_e as a term: the value of `term`, over the equations, in the last cycle.
Id<Expr> previous_value(Derivation& derivation, Id<Expr> term, Span where);

/// V_e: the level of `term`, over the equations, after the last cycle; of a step its activity.
Id<Equations::Variable> level(Derivation& derivation, Id<Expr> term, Span where);

/// The timer t1/v/t2 over the variable `watched`.
Id<Equations::Timer> timer(Derivation& derivation, Id<Equations::Variable> watched, std::int64_t rise_ms,
                           std::int64_t fall_ms, Span where);

/// The end of `timer` as a term.
Id<Expr> end_leaf(Derivation& derivation, Id<Equations::Timer> timer);

/// What the names of variables say of a step of the named partial chart G2, `G2_`; else nothing.
std::string qualifier(const StepName& step);

/// Counts `size` nodes towards the total; false once it is exceeded (an error is added the first time).
bool afford(Derivation& derivation, std::uint64_t size);

/// The equations (11) and (12), and the conflicts between forcing orders.
void derive_firings(Derivation& derivation);
void derive_steps(Derivation& derivation);

/// The equations (13), each output after those it reads.
void derive_outputs(Derivation& derivation);

/// Next values, race conditions and first values of the variables with stored actions.
void derive_stored(Derivation& derivation);

}  // namespace grafverif
