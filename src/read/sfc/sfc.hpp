// SPDX-License-Identifier: MIT
// Converts Sequential Function Charts (SFC, IEC 61131-3) to the syntax tree of a GRAFCET chart. The differences between
// SFC and GRAFCET are treated as follows:
//
// - If several transitions after one step are enabled, SFC clears only the transition with the highest priority.
//   Therefore the conditions are made mutually exclusive.
// - A Boolean variable with the qualifier N is true while its step is active; with the qualifier D, only after the
//   delay; with the qualifier L, only until the time limit. The qualifiers N, D and L become continuous actions. The
//   qualifiers S and R, which set and reset a variable when their step becomes active, become stored actions. For P,
//   SD, SL and DS, a new variable is added, from which a partial chart with one permanently active step computes the
//   output.
// - Assignments with the qualifiers P1 and P0 become stored actions on activation and deactivation. Assignments with
//   the qualifier N are executed in every scan. Constants are therefore stored once on activation, and Boolean terms on
//   activation and whenever their value changes.
// - SFC performs one evolution per scan and executes the actions of a scan sequentially. By default, GRAFCET performs
//   evolutions until the situation is stable, and computes all new values from old values.
//
// Inexact conversions are reported by warnings (`differs-from-sfc`); constructs that cannot be imported are rejected.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "read/draft.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

/// Adds a chart for each unit of `file` that contains a Sequential Function Chart.
void convert_charts(const st::File& file, Draft& draft);

// -- one unit under conversion ----------------------------------------------------------------------------------------

enum class SfcKind { Bad, Boolean, Integer, Time };

struct SfcTerm {
    Id<tree::Expr> expr = {};
    SfcKind kind = SfcKind::Bad;
};

struct SfcVariable {
    std::string name = {};  ///< name of the variable in the grafverif language
    Span where = {};
    SfcKind kind = SfcKind::Boolean;  ///< Bad if charts do not support the type
    tree::VariableKind role = tree::VariableKind::Input;
    bool constant = false;  ///< true if `initial` replaces the variable
    bool wide = false;      ///< true if the type has values that the grafverif language lacks
    bool narrow = false;    ///< true if the variable has a declared range
    std::int64_t initial = 0, low = 0, high = 1;
    std::string comment = {};
    bool used = false;
};

/// The value that a body assigns to a variable: `set || keep && variable` (Boolean) or `value` (Integer). The terms
/// refer to the values before the execution of the body.
struct SfcEffect {
    Id<tree::Expr> set = {}, keep = {}, value = {};
};
/// The effect for each variable, by the name of the variable in the grafverif language.
using SfcEffects = std::map<std::string, SfcEffect>;

struct Sfc {
    const st::File& file;
    const st::Unit& unit;
    Draft& draft;
    std::vector<SfcVariable> variables = {};
    std::unordered_map<std::string, std::size_t> by_name = {};  ///< for each path in upper case: index of the variable
    std::unordered_map<Id<st::Word>, std::string> steps = {};   ///< for each step: its name in the grafverif language
    LegalNames names;

    Diagnostics& diagnostics() { return draft.diagnostics(); }
    void differs(Span where, std::string_view what);
};

/// Returns the text of a path of names, such as `a.b`, as in the source; empty for other expressions.
std::string path_of(const st::File& file, Id<st::Expr> expr);

// -- variables.cpp
void classify_variables(Sfc& sfc);
/// Returns the variable named `path`. An undeclared variable becomes an output if `written` is true, otherwise an
/// input.
SfcVariable& variable_of(Sfc& sfc, const std::string& path, Span where, SfcKind expected, bool written);
std::vector<tree::ChartItem> declarations_of(Sfc& sfc);

// -- terms.cpp
/// Context that determines the meaning of names in an expression.
struct SfcScope {
    std::span<const st::Name> left = {};     ///< upstream steps of the transition, whose times `S.T` can be read
    const SfcEffects* assigned = nullptr;    ///< values assigned earlier in the body
    std::set<std::string>* reads = nullptr;  ///< receives the names of the variables that the expression reads
};
/// Translates an expression; the type is Bad after an error. `expected` is the assumed type of undeclared variables.
SfcTerm term_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> expr, SfcKind expected);
/// Translates an expression, and reports an error if its type is not Boolean.
Id<tree::Expr> boolean_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> expr);
/// Returns a constant duration in milliseconds.
std::optional<std::int64_t> duration_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> expr);
Id<tree::Expr> both(Draft& draft, Id<tree::Expr> left, Id<tree::Expr> right);    ///< `&&`, folds constants
Id<tree::Expr> either(Draft& draft, Id<tree::Expr> left, Id<tree::Expr> right);  ///< `||`, folds constants
Id<tree::Expr> opposite(Draft& draft, Id<tree::Expr> term);                      ///< `!term`

// -- bodies.cpp
struct SfcBody {
    SfcEffects effects = {};           ///< assignments of the statements
    std::set<std::string> reads = {};  ///< variables that the statements read
};
/// Executes statements symbolically. The result is empty after an error.
std::optional<SfcBody> body_of(Sfc& sfc, const st::Block& block);

// -- actions.cpp
/// The actions of each step (the key is the name of the step in the grafverif language), and the actions that do not
/// depend on a step.
struct SfcActions {
    std::unordered_map<std::string, std::vector<tree::Action>> of_steps = {};
    std::vector<tree::Action> always = {};
    std::vector<std::string> latches = {};  ///< names of internal Boolean variables
};
SfcActions actions_of(Sfc& sfc);

}  // namespace grafverif
