// SPDX-License-Identifier: MIT
// History: the edits of a text, with unlimited undo and redo. A new edit discards the edits that were undone.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "edit/text_edit.hpp"

namespace grafverif::edit {

class History {
public:
    explicit History(std::string text) : text_(std::move(text)) {}

    const std::string& text() const { return text_; }
    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < steps_.size(); }

    /// Applies edits, which must be sorted, as one step. If `typed` is true and the previous step was also typed
    /// directly before this text in the same line, both are one step.
    void apply(const std::vector<TextEdit>& edits, bool typed = false);
    /// Undoes or repeats one step. Returns the offset of the change in the new text. Requires `can_undo()` or
    /// `can_redo()`.
    std::uint32_t undo();
    std::uint32_t redo();

private:
    struct Step {
        std::vector<TextEdit> forward = {}, backward = {};
        bool typed = false;
    };

    bool continues(const std::vector<TextEdit>& edits) const;

    std::string text_;
    std::vector<Step> steps_ = {};
    std::size_t done_ = 0;  ///< number of steps that are applied
};

}  // namespace grafverif::edit
