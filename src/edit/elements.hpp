// SPDX-License-Identifier: MIT
// Elements: the steps, transitions and actions that a text declares, by the position of their declaration. An operation
// on a drawing refers to an element by this position.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif::edit {

/// A declared step, transition or action. Exactly one of the pointers `step`, `transition`, `action` and `assignment`
/// denotes the element; an action also has its step, and an assignment of a transition its transition.
struct Element {
    Span where = {};
    const tree::Chart* chart = nullptr;
    const std::vector<tree::ChartItem>* items = nullptr;  ///< the list with the step or transition
    const tree::Step* step = nullptr;
    const tree::Transition* transition = nullptr;
    const tree::Action* action = nullptr;
    const tree::Assignment* assignment = nullptr;
    bool repeated = false;  ///< true if the element is declared inside `for`

    bool is_step() const { return step != nullptr && action == nullptr; }
    bool is_transition() const { return transition != nullptr && assignment == nullptr; }
};

class Elements {
public:
    /// `file` must outlive the elements.
    explicit Elements(const tree::File& file);

    /// Returns the element whose declaration, or whose name, begins at `offset`, or null.
    const Element* at(std::uint32_t offset) const;
    const std::vector<Element>& all() const { return elements_; }

private:
    void add(const tree::Chart& chart, const std::vector<tree::ChartItem>& items, bool repeated);

    std::vector<Element> elements_ = {};                             ///< sorted by position
    std::vector<std::pair<std::uint32_t, std::size_t>> names_ = {};  ///< offset of the name of each step, and its index
};

/// Returns the position of an action without its `;`.
Span where(const tree::Action& action);

}  // namespace grafverif::edit
