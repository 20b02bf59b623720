// SPDX-License-Identifier: MIT
// Connections: determines the links between the steps and transitions of one list of declarations, and edits that
// change them.
#pragma once

#include <string>
#include <vector>

#include "edit/elements.hpp"
#include "edit/layout.hpp"
#include "edit/text_edit.hpp"

namespace grafverif::edit {

/// An end of a transition: the steps before it, or the steps after it.
enum class End : std::uint8_t { From, To };

using Transitions = std::vector<const tree::Transition*>;

class Connections {
public:
    Connections(const tree::File& file, const Layout& layout, const Element& element);

    const Transitions& transitions() const { return transitions_; }
    /// `incoming` returns the transitions that lead to the step `name`; `outgoing` returns the transitions that begin
    /// at it.
    Transitions incoming(const tree::Name& name) const { return with(name, End::To); }
    Transitions outgoing(const tree::Name& name) const { return with(name, End::From); }
    /// Returns the declared step with this name in the list, or null.
    const tree::Step* step(const tree::Name& name) const;
    /// Returns the reason why links of `name` cannot be edited (a declaration in a replication uses `name`), or an
    /// empty string if they can be edited.
    std::string obstacle(const tree::Name& name) const;

    /// Returns the edits that replace `name` at an end of a transition by `names`, without duplicates. An empty list
    /// removes `name`.
    std::vector<TextEdit> replaced(const tree::Transition& transition, End end, const tree::Name& name,
                                   const std::vector<std::string>& names) const;
    /// Returns the edit that replaces all steps at an end of a transition by `names`.
    TextEdit replaced_all(const tree::Transition& transition, End end, const std::string& names) const;
    /// Returns the edit that adds `name` at an end of a transition.
    TextEdit added(const tree::Transition& transition, End end, const std::string& name) const;

    /// Returns the edits that delete a step and reconnect its links. If this is not possible, sets `obstacle` to the
    /// reason.
    std::vector<TextEdit> without_step(const tree::Step& step, std::string& obstacle) const;
    /// Returns the edits that delete a transition. If this is not possible, sets `obstacle` to the reason.
    std::vector<TextEdit> without_transition(const tree::Transition& transition, std::string& obstacle) const;

    std::vector<std::string> names(const tree::Transition& transition, End end) const;
    /// Returns the text of the steps at an end of a transition, including the comments in this text.
    std::string written(const tree::Transition& transition, End end) const;
    /// Returns the name of a transition for messages.
    std::string title(const tree::Transition& transition) const;

private:
    Transitions with(const tree::Name& name, End end) const;

    const tree::File& file_;
    const Layout& layout_;
    const std::vector<tree::ChartItem>& items_;
    Transitions transitions_ = {};
};

/// Returns names separated by commas.
std::string list_of(const std::vector<std::string>& names);

}  // namespace grafverif::edit
