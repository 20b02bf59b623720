// SPDX-License-Identifier: MIT
// Computes operations on the drawing of a chart as edits of its text. If an operation is not possible, the result is a
// reason instead of edits. The edited text is syntactically correct; the caller checks it for other errors.
//
// If a new transition begins at a step with other transitions, its condition excludes the conditions of these
// transitions, so that at most one branch of the selection is taken. All other new transitions have the condition
// `true`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edit/elements.hpp"
#include "edit/text_edit.hpp"

namespace grafverif::edit {

enum class OperationKind : std::uint8_t {
    StepAfter,    ///< adds a step and a transition after a step or transition
    StepBefore,   ///< adds a step and a transition before a step or transition
    Transition,   ///< adds a transition from a step to a new step
    Alternative,  ///< adds a branch that is an alternative to a transition, or to the first transition of a step
    Parallel,     ///< adds a step in parallel with a step, or with the first target of a transition
    Jump,         ///< adds a transition from a step to the step `target`, or changes the target of a transition
    Action,       ///< adds the action `text` to a step or transition
    Replace,      ///< replaces the condition of a transition, or an action, by `text`
    Delete,       ///< deletes an action, a transition, or a step, whose links are reconnected
    Rename,       ///< renames an element to `text` at all its uses (see Document)
    Paste,        ///< adds copies of the steps in `text` (see the function `copied`) as an alternative to a transition
    Declare,      ///< declares the variable `text`, such as `input START`, in the chart of the element
    Partial,      ///< adds the partial chart `text` with one initial step to the chart of the element
    Macro,        ///< as StepAfter, with a macro-step and its expansion
    Enclosing,    ///< as StepAfter, with an enclosing step and the partial chart `text` that it encloses
};

struct Operation {
    OperationKind kind = OperationKind::StepAfter;
    std::uint32_t at = 0;                      ///< position of the declaration of the element (see Elements)
    std::optional<std::uint32_t> target = {};  ///< position of the target of a jump
    std::string text = {};
};

/// The result of an operation: edits, or an obstacle.
struct Plan {
    std::vector<TextEdit> edits = {};  ///< edits, sorted by position
    std::string obstacle = {};         ///< reason for rejection; if not empty, there are no edits

    /// Position of the new or changed element in the text after the edits; empty if the element was deleted.
    std::optional<std::uint32_t> selected = {};
};

/// Computes any operation except Rename. Requires a text without syntax errors.
Plan plan_of(std::string_view text, const tree::File& file, const Elements& elements, const Operation& operation);

/// Maximum number of steps of a copy.
inline constexpr std::size_t most_copied = 1'000;

/// A copy of steps as text for Paste: a comment with the name of the chart, the declarations of the steps, and the
/// declarations of all transitions that begin or end at these steps.
struct Copy {
    std::string obstacle = {};  ///< reason for rejection; if not empty, there is no text
    std::string text = {};
};
/// Returns the text of the steps at the positions `at`, which must be in the same chart or partial chart.
Copy copied(std::string_view text, const tree::File& file, const Elements& elements,
            const std::vector<std::uint32_t>& at);

/// Returns the new text of an unnamed transition with the name `name`.
TextEdit naming(const tree::Transition& transition, const std::string& name);

}  // namespace grafverif::edit
