// SPDX-License-Identifier: MIT
// Document: the text of one file that is being edited. Drawings, diagnostics and the positions of elements are computed
// from the text after each change. An operation on a drawing is a change of the text; it is rejected if the resulting
// text has errors.
//
// The document reads included files, but neither reads nor writes the file itself.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/history.hpp"
#include "edit/operations.hpp"
#include "lsp/completion.hpp"
#include "lsp/diagnostic_store.hpp"
#include "lsp/workspace.hpp"

namespace grafverif::edit {

/// The result of a change: a reason why the change was rejected, or the position of the changed element.
struct Change {
    std::string obstacle = {};     ///< if not empty, the text is unchanged
    std::string diagnostics = {};  ///< errors that the text would have after the change
    std::optional<std::uint32_t> selected = {};
};

/// An element of a drawing, and the text that declares it.
struct DrawnElement {
    std::string id = {};         ///< id of the element in the drawing; empty for a part that is not drawn separately
    std::string condition = {};  ///< id of the condition of a transition
    std::string kind = {};       ///< `step`, `transition` or `action`
    std::string name = {};       ///< name of a step or transition
    std::string text = {};       ///< condition of a transition, or text of an action
    Span where = {};             ///< position of the declaration
    Span part = {};              ///< position of `text`, or of the name of a step
};

class Document {
public:
    /// `path` is the path of the file. Its folder is searched for included files first.
    Document(std::string path, std::vector<std::string> include_folders, std::string text);

    const std::string& text() const { return history_.text(); }
    const std::string& path() const { return path_; }
    bool can_undo() const { return history_.can_undo(); }
    bool can_redo() const { return history_.can_redo(); }

    /// Executes an operation, or rejects it with a reason, for example if the text has errors. If `trial` is true, only
    /// determines the result and does not change the text.
    Change perform(const Operation& operation, bool trial = false);
    /// Returns a copy of the steps at the positions `at`, as text for OperationKind::Paste.
    Copy copied(const std::vector<std::uint32_t>& at);
    /// Returns the completion proposals at the offset `cursor` of `text`, which is the text of the document with an
    /// incomplete change.
    std::vector<lsp::Proposal> proposals(const std::string& text, std::size_t cursor) const;
    /// Replaces the text by `text`, which the user has typed. The new text may have errors.
    void type(std::string_view text);
    /// Replaces the text as one editing step, which can be undone.
    void replace(std::string_view text);
    /// `undo` undoes one editing step, and `redo` repeats it. Both return the offset of the change, or nothing if there
    /// is no step to undo or repeat.
    std::optional<std::uint32_t> undo();
    std::optional<std::uint32_t> redo();
    /// Parses the text again, because an included file has changed.
    void refresh() { current_ = nullptr; }

    /// Returns the parsed text.
    const lsp::Root& reading();
    /// Returns the last parsed text without errors, or null.
    std::shared_ptr<const lsp::Root> drawn();
    /// Returns the drawing of a chart of `drawn()`, which must not be null.
    Drawing drawing(Id<Chart> chart, const std::string& prefix);
    /// Returns the elements of the drawing of a chart that the file itself declares, and not an included file.
    std::vector<DrawnElement> elements(Id<Chart> chart, const std::string& prefix);

private:
    lsp::Workspace workspace_for(const std::string& text) const;
    Change rename(const Element& element, const std::string& name, bool trial);
    std::string remaining_use(const std::vector<TextEdit>& edits) const;
    Change accept(Plan plan, bool trial);

    std::string path_, uri_;
    std::vector<std::string> include_folders_;
    History history_;
    std::shared_ptr<const lsp::Root> current_ = nullptr, drawn_ = nullptr;
    std::shared_ptr<const lsp::Parsed> parsed_ = nullptr, drawn_parsed_ = nullptr;
};

}  // namespace grafverif::edit
