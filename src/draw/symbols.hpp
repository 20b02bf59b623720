// SPDX-License-Identifier: MIT
// Symbols: draws the steps, transitions, actions and forcing orders of a chart in the notation of IEC 60848 (clause 5;
// clause 7 for macro-steps, enclosing steps and forcing orders). The coordinates of each symbol are relative to its
// centre.
#pragma once

#include <string>
#include <vector>

#include "draw/chart_text.hpp"
#include "draw/flow.hpp"
#include "draw/writing.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

/// The symbol of one node (a step or transition), with its actions and texts; its centre is at (0, 0).
struct Symbol {
    ReservedSpace space = {};
    int port = 0;  ///< distance from the centre to the upper and lower ends of links
    std::vector<Drawing::Element> elements = {};
};

class Symbols {
public:
    /// `chart` and `text` must outlive the symbols.
    Symbols(const Chart& chart, const DrawOptions& options, const ChartText& text);

    const ElementIds& ids() const { return ids_; }
    Symbol step(Id<Chart::Step> step) const;
    Symbol transition(Id<Chart::Transition> transition) const;
    /// Returns a title such as `T4: from 2 to 3, 4`.
    std::string title(Id<Chart::Transition> transition) const;

private:
    struct Action;

    Action continuous(Id<Chart::ContinuousAction> action) const;
    Action stored(Id<Chart::StoredAction> action) const;
    Action forcing(Id<Chart::ForcingOrder> order) const;
    /// Returns the text of `term`. If Notation::Text is selected and `written` contains the text of the term in the
    /// source file, returns this text; otherwise, returns the term in the notation of the drawing.
    Runs runs(const std::vector<std::string>& written, std::uint32_t index, Id<Expr> term) const;
    void add_comment(const std::string& comment, Symbol& symbol) const;
    std::string names_of(const std::vector<Id<Chart::Step>>& steps) const;
    void add_step_marks(Id<Chart::Step> step, int half, Drawing::Element& element) const;
    void add_actions(std::vector<Action> actions, int left, Symbol& symbol) const;

    const Chart& chart_;
    const ChartText& text_;
    Writing writing_;
    ElementIds ids_;
    std::vector<bool> active_ = {};  ///< for each step: true if it is marked as active
    std::vector<std::vector<Id<Chart::ContinuousAction>>> continuous_ = {};  ///< continuous actions of each step
    std::vector<std::vector<Id<Chart::StoredAction>>> stored_ = {};          ///< stored actions of each step
    std::vector<std::vector<Id<Chart::ForcingOrder>>> forcing_ = {};         ///< forcing orders of each step
    std::vector<std::vector<Id<Chart::StoredAction>>> on_clearing_ = {};     ///< stored actions of each transition
};

}  // namespace grafverif::draw
