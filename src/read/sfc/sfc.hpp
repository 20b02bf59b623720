// SPDX-License-Identifier: MIT
// Sequential Function Charts (IEC 61131-3) -> tree of a GRAFCET. SFC is not GRAFCET; what is made of the differences:
//
// - Behind a step SFC takes one branch, by priority: the conditions are made to exclude each other.
// - A Boolean variable under N, D, L is true while its step is active: a continuous action. S and R set and reset it when
//   their step becomes active: stored actions. P, SD, SL and DS get a variable of their own, and a partial chart of one
//   step that is always active turns it into the output.
// - Assignments under P1 and P0 are stored actions on activation and deactivation. Under N they are made in every scan:
//   constants once on activation, Boolean terms on activation and whenever their value changes.
// - SFC makes one evolution a scan and runs the actions of a scan one after the other; GRAFCET makes evolutions until the
//   situation is stable, unless told otherwise, and computes all new values from old ones.
//
// What is not exact is warned of (`differs-from-sfc`); what cannot be taken over is refused.
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

/// Declares a chart for each unit of `file` that has one.
void convert_charts(const st::File& file, Draft& draft);

// -- one unit under conversion ------------------------------------------------------------------------------------------

enum class SfcKind { Bad, Boolean, Integer, Time };

struct SfcTerm {
    Id<tree::Expr> expr = {};
    SfcKind kind = SfcKind::Bad;
};

struct SfcVariable {
    std::string name = {};  ///< in our language
    Span where = {};
    SfcKind kind = SfcKind::Boolean;  ///< Bad: of a type that no chart has
    tree::VariableKind role = tree::VariableKind::Input;
    bool constant = false;  ///< `initial` stands for it
    bool wide = false;      ///< its type holds more than the language has
    bool narrow = false;    ///< its range was declared
    std::int64_t initial = 0, low = 0, high = 1;
    std::string comment = {};
    bool used = false;
};

/// What a body assigns to a variable: `set || keep && variable` (Boolean) or `value` (Integer), over the values before it.
struct SfcEffect {
    Id<tree::Expr> set = {}, keep = {}, value = {};
};
using SfcEffects = std::map<std::string, SfcEffect>;  ///< by our name of the variable

struct Sfc {
    const st::File& file;
    const st::Unit& unit;
    Draft& draft;
    std::vector<SfcVariable> variables = {};
    std::unordered_map<std::string, std::size_t> by_name = {};  ///< capitals of the path as written -> variable
    std::unordered_map<Id<st::Word>, std::string> steps = {};   ///< their names in our language
    LegalNames names;

    Diagnostics& diagnostics() { return draft.diagnostics(); }
    void differs(Span where, std::string_view what);
};

/// `a.b` as written; empty for anything but a path of names.
std::string path_of(const st::File& file, Id<st::Expr> expr);

// -- sfc_variables.cpp
void classify_variables(Sfc& sfc);
/// The variable called `path`; one that is not declared becomes an input, or an output where it is written.
SfcVariable& variable_of(Sfc& sfc, const std::string& path, Span where, SfcKind expected, bool written);
std::vector<tree::ChartItem> declarations_of(Sfc& sfc);

// -- sfc_terms.cpp
/// What the names in an expression mean where it stands.
struct SfcScope {
    std::span<const st::Name> left = {};     ///< steps that the transition leaves: `S.T` is known of them
    const SfcEffects* assigned = nullptr;    ///< values that the body has assigned before
    std::set<std::string>* reads = nullptr;  ///< gains the variables that are read
};
/// Bad after a refusal. `expected` tells the type of what is declared nowhere.
SfcTerm term_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> expr, SfcKind expected);
/// A term that must be Boolean.
Id<tree::Expr> boolean_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> expr);
/// A constant duration in milliseconds.
std::optional<std::int64_t> duration_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> expr);
Id<tree::Expr> both(Draft& draft, Id<tree::Expr> left, Id<tree::Expr> right);    ///< `&&`, constants folded
Id<tree::Expr> either(Draft& draft, Id<tree::Expr> left, Id<tree::Expr> right);  ///< `||`
Id<tree::Expr> opposite(Draft& draft, Id<tree::Expr> term);                      ///< `!`

// -- sfc_bodies.cpp
struct SfcBody {
    SfcEffects effects = {};           ///< what the statements assign
    std::set<std::string> reads = {};  ///< variables they read
};
/// Empty after a refusal.
std::optional<SfcBody> body_of(Sfc& sfc, const st::Block& block);

// -- sfc_actions.cpp
/// The actions of every step, by its name in our language, and what has to go on beside the chart.
struct SfcActions {
    std::unordered_map<std::string, std::vector<tree::Action>> of_steps = {};
    std::vector<tree::Action> always = {};
    std::vector<std::string> latches = {};  ///< internal Boolean variables
};
SfcActions actions_of(Sfc& sfc);

}  // namespace grafverif
