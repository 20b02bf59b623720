// SPDX-License-Identifier: MIT
// Formulas that properties pass through to a tool (`ctl "..."`, `ltl "..."`, `uppaal "..."`): each is written into a model
// as it stands, so it must be exactly one formula of that tool's language. A reader of those languages says where a
// text is none.
//
// ctl, ltl: what NuSMV 2.6 reads as a formula over conditions, numbers and named values; not its words of bits, arrays
// and `case` (which has a condition: `c ? a : b`). Its types are checked as it checks them, since NuSMV refuses a whole
// model for one ill-typed formula. uppaal: `A[] p`, `A<> p`, `E<> p`, `E[] p`, `p --> q` over expressions without side
// effects.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/property.hpp"

namespace grafverif {

enum class FormulaLanguage { Ctl, Ltl, Uppaal };
/// `CTL`, `LTL`, `UPPAAL`.
std::string_view word(FormulaLanguage language);
/// Of the properties of a pattern; nothing: they have operands of our own language.
std::optional<FormulaLanguage> formula_language(Pattern pattern);

/// What a name stands for in a model.
struct FormulaName {
    enum class Type { Any, Boolean, Number, Value } type = Type::Any;
    bool of_steps = false;  ///< chosen anew in each step: CTL, which speaks of states, cannot read it
};
/// Nothing: the model has no such name. Names of parts come whole: `press.X_2`.
using FormulaNames = std::function<std::optional<FormulaName>(std::string_view)>;

struct FormulaFault {
    std::size_t begin = 0, end = 0;  ///< bytes of the text
    std::string what = {};           ///< `expected `)`, got `&``
};

/// Why `text` is no formula; nothing: it is one. Without `names` every name is taken for one of the right kind.
std::optional<FormulaFault> formula_fault(FormulaLanguage language, std::string_view text,
                                          const FormulaNames& names = {});

}  // namespace grafverif
