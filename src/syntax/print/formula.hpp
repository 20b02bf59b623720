// SPDX-License-Identifier: MIT
// Syntax check of formulas that properties pass to an external tool (`ctl "..."`, `ltl "..."`, `uppaal "..."`).
// grafverif copies the formula unchanged into a model. Therefore the text must be exactly one formula in the language
// of the tool. The check reports the first error in the text.
//
// For `ctl` and `ltl`, the check accepts formulas of NuSMV 2.6 over conditions, numbers and named values, without bit
// vectors, arrays and `case`; conditions may contain `c ? a : b`. The check uses the typing rules of NuSMV, because
// NuSMV rejects a complete model if one formula is ill-typed. For `uppaal`, the check accepts `A[] p`, `A<> p`, `E<>
// p`, `E[] p` and `p --> q` over expressions without side effects.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/property.hpp"

namespace grafverif {

enum class FormulaLanguage { Ctl, Ltl, Uppaal };
/// Returns the name of the language: `CTL`, `LTL` or `UPPAAL`.
std::string_view word(FormulaLanguage language);
/// Returns the formula language of a pattern, or nullopt if its operands are in the input language of grafverif.
std::optional<FormulaLanguage> formula_language(Pattern pattern);

/// Meaning of a name in a model.
struct FormulaName {
    enum class Type { Any, Boolean, Number, Value } type = Type::Any;
    /// True if the value depends on a choice that the model makes in each step. A name with such a
    /// value is not allowed in CTL, because CTL formulas describe states.
    bool of_steps = false;
};
/// A function that returns the meaning of a name, or nullopt if the model does not contain the name. A qualified name,
/// such as `press.X_2`, is passed as one name.
using FormulaNames = std::function<std::optional<FormulaName>(std::string_view)>;

struct FormulaFault {
    std::size_t begin = 0, end = 0;  ///< byte range in the text
    std::string what = {};           ///< description such as `expected `)`, got `&``
};

/// Returns the first error in `text`, or nullopt if `text` is a formula. If `names` is empty, the check assumes that
/// each name exists and has a suitable type.
std::optional<FormulaFault> formula_fault(FormulaLanguage language, std::string_view text,
                                          const FormulaNames& names = {});

}  // namespace grafverif
