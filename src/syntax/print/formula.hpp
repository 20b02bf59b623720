// SPDX-License-Identifier: MIT
// Syntax check of formulas that properties pass to an external tool (`ctl "..."`, `ltl "..."`, `uppaal "..."`). The
// formula is copied unchanged into a model and must therefore be exactly one formula in the language of the tool. The
// check reports the first error in an invalid text.
//
// ctl, ltl: formulas of NuSMV 2.6 over conditions, numbers and named values, without its bit vectors, arrays and
// `case`; conditions may contain `c ? a : b`. The check uses the typing rules of NuSMV, because NuSMV rejects a
// complete model if one formula is ill-typed. uppaal: `A[] p`, `A<> p`, `E<> p`, `E[] p`, `p --> q` over expressions
// without side effects.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/property.hpp"

namespace grafverif {

enum class FormulaLanguage { Ctl, Ltl, Uppaal };
/// Returns `CTL`, `LTL` or `UPPAAL`.
std::string_view word(FormulaLanguage language);
/// Returns the formula language of a pattern, or nothing if its operands are in the input language of grafverif.
std::optional<FormulaLanguage> formula_language(Pattern pattern);

/// Meaning of a name in a model.
struct FormulaName {
    enum class Type { Any, Boolean, Number, Value } type = Type::Any;
    /// True if the value is chosen in each step. The name is then not allowed in CTL, because CTL formulas describe
    /// states.
    bool of_steps = false;
};
/// Returns the meaning of a name, or nothing if the model has no such name. A qualified name is passed as one name:
/// `press.X_2`.
using FormulaNames = std::function<std::optional<FormulaName>(std::string_view)>;

struct FormulaFault {
    std::size_t begin = 0, end = 0;  ///< byte range in the text
    std::string what = {};           ///< description such as `expected `)`, got `&``
};

/// Returns the first error in `text`, or nothing if `text` is a formula. Without `names`, each name is assumed to have
/// a suitable type.
std::optional<FormulaFault> formula_fault(FormulaLanguage language, std::string_view text,
                                          const FormulaNames& names = {});

}  // namespace grafverif
