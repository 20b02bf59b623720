// SPDX-License-Identifier: MIT
// Planner: computes one operation on an element of a drawing as edits. The files operations*.cpp contain the
// operations, and planner.cpp contains functions that several operations use.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "edit/connections.hpp"
#include "edit/layout.hpp"
#include "edit/operations.hpp"
#include "edit/written.hpp"

namespace grafverif::edit {

class Planner {
public:
    Planner(std::string_view text, const tree::File& file, const Elements& elements, const Element& element)
        : text_(text),
          file_(file),
          elements_(elements),
          element_(element),
          layout_(text, file),
          connections_(file, layout_, element) {}

    Plan plan(const Operation& operation);

private:
    void execute(const Operation& operation);

    // -- additions ----------------------------------------------------------------------------------------------------

    /// Adds a step between an element and the following elements (`side` is To) or the preceding elements (`side` is
    /// From). `words` are written before the name of the step, and `contents` after it.
    void add_neighbour(End side, const std::string& words = "step ", const std::string& contents = {});

    /// Rejects the operation if one of `links`, which will no longer begin at `step`, reads the variable of this step,
    /// because a condition such as `3s/X1` would never be true.
    void reject_readers(const Transitions& links, const tree::Name& step);
    void add_transition();
    /// Returns a transition and all transitions that begin at one of its steps. If one of these transitions is in a
    /// replication, sets the obstacle.
    Transitions alternatives_to(const tree::Transition& transition);
    void add_alternative();
    void add_parallel();
    void reject_end_of_expansion(const tree::Step& step);
    void add_jump(const Operation& operation);
    void add_action(const std::string& action);
    void paste(const std::string& copied);
    /// Rejects the operation if a step variable in a copied text can denote another step than in the original chart.
    /// This can occur if the text was copied from another chart or partial chart.
    void reject_other_steps(const std::set<std::string>& variables, std::string_view chart);

    // -- declarations -------------------------------------------------------------------------------------------------

    void declare(const std::string& declaration);
    void drive(const Declared& input);
    void add_partial(const std::string& name);
    void add_macro();
    void add_enclosing(const std::string& partial);
    /// Adds the block `head { lines }` at the end of the chart, after an empty line.
    void add_part(const std::string& head, const std::vector<std::string>& lines);
    /// Returns `name` if the file does not use it; otherwise returns `name` with an appended number.
    std::string fresh_or(const std::string& name);
    /// Returns `stem` with the smallest appended number that results in an unused name.
    std::string fresh_name(const std::string& stem);
    /// True if the file or the new text contains `name`, or the variable of a step with this name.
    bool is_used(const std::string& name) { return used().contains(name) || used().contains('X' + name); }
    /// Returns all names of the file and the new names.
    std::set<std::string, std::less<>>& used();

    // -- changes and deletions ----------------------------------------------------------------------------------------

    void replace(const std::string& written);
    void remove();
    void remove_action();
    void remove_assignment();

    // -- parts --------------------------------------------------------------------------------------------------------

    /// Returns the position of an action with its `;`.
    static Span declared(const tree::Action& action);

    /// Adds a step after the declaration of the first of `neighbours`; if the list of declarations does not contain it,
    /// after the last step.
    void add_step(const std::string& fresh, const std::vector<tree::Name>& neighbours,
                  const std::string& words = "step ", const std::string& contents = {});
    const tree::Step* last_step() const;

    /// Returns the position of the declaration after which a new transition is added: the last of `near`. If `near` is
    /// empty, this is the last of `next`, otherwise the last transition of the list, otherwise the last step of the
    /// list.
    Span place_of_link(const Transitions& near, const Transitions& next) const;
    void add_link(Span place, const std::string& from, const std::string& to, const std::string& condition);

    /// Returns the conjunction of the negated conditions of `links`.
    std::string exclusive(const Transitions& links) const;
    std::string negation(Id<tree::Expr> condition) const;

    /// Returns the name of a new step: the next unused number, or the name of the neighbour with the next unused
    /// number.
    std::string fresh_step(const std::vector<tree::Name>& neighbours);
    std::string fresh_step(std::string stem);

    /// Returns the name of a new transition; empty if a transition of the chart has no name.
    std::string fresh_transition();

    // -- the result ---------------------------------------------------------------------------------------------------

    void add(TextEdit edit) { edits_.push_back(std::move(edit)); }
    void add(std::vector<TextEdit> edits);
    /// Adds an edit, and marks the declaration that begins with `words` in its replacement as the selected element.
    void select(TextEdit edit, std::string_view words);
    /// Marks the declaration that begins with `words` in the last edit as the selected element.
    void select_last(std::string_view words);
    Plan finished();
    std::string_view text_;
    const tree::File& file_;
    const Elements& elements_;
    const Element& element_;
    Layout layout_;
    Connections connections_;
    std::vector<TextEdit> edits_ = {};
    std::string obstacle_ = {};
    std::set<std::string, std::less<>> used_ = {};  ///< see used(); empty before the first use
    std::optional<std::size_t> selected_in_ = {};   ///< index of the edit that adds the selected element
    std::size_t selected_at_ = 0;                   ///< offset of the selected element in the replacement

    /// Position, before the edits, of a selected element that exists already.
    std::optional<std::uint32_t> selected_ = {};
};

}  // namespace grafverif::edit
