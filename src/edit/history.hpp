// SPDX-License-Identifier: MIT
// History: stores the edits of a text, for unlimited undo and redo. A new edit discards the edits that were undone.
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

    /// Applies edits, which must be sorted, as one editing step. If `typed` is true, and the text continues text of the
    /// previous step that was also typed, both steps become one step.
    void apply(const std::vector<TextEdit>& edits, bool typed = false);
    /// `undo` undoes one editing step, and `redo` repeats it. They return the offset of the change in the new text.
    /// `undo` requires `can_undo()`, and `redo` requires `can_redo()`.
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
    std::size_t done_ = 0;  ///< number of editing steps that are applied; the remaining steps were undone
};

}  // namespace grafverif::edit
