// SPDX-License-Identifier: MIT
// Elements: finds the steps, transitions and actions that a text declares by the positions of their declarations. An
// operation on a drawing refers to an element by the position of its declaration.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif::edit {

/// A declared step, transition or action. Exactly one of the pointers `step`, `transition`, `action` and `assignment`
/// denotes the element; for an action, `step` is also set, and for an assignment of a transition, `transition` is also
/// set.
struct Element {
    Span where = {};
    const tree::Chart* chart = nullptr;
    /// The list of declarations that contains the step or transition.
    const std::vector<tree::ChartItem>* items = nullptr;
    const tree::Step* step = nullptr;
    const tree::Transition* transition = nullptr;
    const tree::Action* action = nullptr;
    const tree::Assignment* assignment = nullptr;
    bool repeated = false;  ///< true if the element is declared in a replication (`for`)

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

    std::vector<Element> elements_ = {};                             ///< elements, sorted by position
    std::vector<std::pair<std::uint32_t, std::size_t>> names_ = {};  ///< offset of the name of each step, and its index
};

/// Returns the position of an action without its `;`.
Span where(const tree::Action& action);

}  // namespace grafverif::edit
