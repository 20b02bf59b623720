// SPDX-License-Identifier: MIT
// What the parts of derive share: the chart, the equations so far, where each entity of the chart went, and the limits
// that keep substitution from blowing up.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

inline constexpr std::size_t term_size_limit = 1'000'000;    ///< nodes of one equation, as printed
inline constexpr std::size_t total_size_limit = 10'000'000;  ///< nodes of all terms that substitution and races add
inline constexpr std::size_t term_depth_limit = 2'000;
inline constexpr std::size_t stored_value_limit = 1'000;     ///< different values stored in one variable

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

struct Derivation {
    const Chart& chart;
    Diagnostics& diagnostics;
    Equations equations = {};
    std::vector<Id<Equations::Variable>> steps = {};     ///< X_s, per step
    std::vector<Id<Equations::Variable>> firings = {};   ///< CF_t, per transition
    std::vector<Id<Equations::Variable>> ends = {};      ///< T_Q, per time condition; not valid: nobody waits for it
    std::vector<Id<Expr>> step_leaves = {};              ///< X_s as a term: looking leaves up anew is what costs most
    std::vector<Id<Expr>> firing_leaves = {};            ///< CF_t as a term
    std::vector<std::vector<Id<Chart::ContinuousAction>>> continuous = {};   ///< per variable
    std::vector<std::vector<Id<Chart::StoredAction>>> stored = {};           ///< per variable
    std::vector<bool> reads_output = {};                 ///< per term of the chart: a continuous output occurs in it
    std::vector<Id<Expr>> values = {};                   ///< per variable: equation (13) of a continuous output
    Measures measures = {};
    std::uint64_t added = 0;                             ///< towards total_size_limit
    bool exhausted = false;                              ///< the total was exceeded, and said so
    std::size_t errors_before = 0;                       ///< of the inputs handled earlier
};

/// Whether an error was found in this chart.
inline bool failed(const Derivation& derivation) {
    return derivation.diagnostics.errors() != derivation.errors_before;
}

/// Whether `variable` is an output without stored actions, which has an equation (13).
bool is_continuous(const Derivation& derivation, Id<Chart::Variable> variable);

/// A Variable leaf of the equations.
Id<Expr> variable_leaf(Derivation& derivation, Id<Equations::Variable> variable);

/// `term`, or false where it is a conjunction of some operand and its negation among others.
Id<Expr> consistent(Exprs& exprs, Id<Expr> term);

/// The term `root` of the chart over the variables of the equations, outputs replaced by their equations. Not valid
/// after an error was added: the term, named `what`, would be too large.
Id<Expr> over_equations(Derivation& derivation, Id<Expr> root, Span where, const std::string& what);

/// Counts `size` nodes towards the total; false once it is exceeded (an error is added the first time).
bool afford(Derivation& derivation, std::uint64_t size);

/// The equations (13), each output after those it reads.
void derive_outputs(Derivation& derivation);

/// Next values, race conditions and first values of the variables with stored actions.
void derive_stored(Derivation& derivation);

}  // namespace grafverif
