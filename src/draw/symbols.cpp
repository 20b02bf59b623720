// SPDX-License-Identifier: MIT
#include "draw/symbols.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "syntax/print/dialect.hpp"

namespace grafverif::draw {

namespace {

using Anchor = Drawing::Anchor;

constexpr int half_step = 20;  ///< half the height of a step, and half the width of a step with a short name
constexpr int half_bar = 15;
constexpr int box_height = 24;  ///< height of the box of an action
constexpr int line_height = 15;
constexpr int text_size = 12, small_size = 11;
constexpr int widest_text = 260;  ///< maximum width of a condition; longer conditions are broken into lines
constexpr int widest_row = 280;   ///< maximum width of a row of actions; if the row is wider, the actions are stacked
constexpr int widest_comment = 170;
constexpr std::size_t longest_comment = 120;  ///< maximum length of a comment in characters

Drawing::Text text_at(int x, int y, Runs runs, int size, Anchor anchor, const char* kind) {
    const int width = width_of(runs, size);
    return {{x, y}, std::move(runs), anchor, size, width, kind};
}

Drawing::Text text_at(int x, int y, const std::string& text, int size, Anchor anchor, const char* kind) {
    return text_at(x, y, Runs{{text, false}}, size, anchor, kind);
}

Runs joined(std::vector<Runs> terms, const char* between) {
    Runs all;
    for (Runs& term : terms) {
        if (!all.empty()) all.push_back({between, false});
        std::ranges::move(term, std::back_inserter(all));
    }
    return all;
}

int widest_of(const std::vector<Runs>& lines, int size) {
    int widest = 0;
    for (const Runs& line : lines) widest = std::max(widest, width_of(line, size));
    return widest;
}

}  // namespace

/// The box of an action or forcing order of a step, or of an action of a transition.
struct Symbols::Action {
    enum class Sign { None, Up, Down, Event };
    Drawing::Element element = {};
    std::string label = {};
    std::vector<Runs> above = {};  ///< lines of the condition of the action, drawn above the box
    Sign sign = Sign::None;
    bool twofold = false;  ///< true for a forcing order, which has a double frame

    int width() const {
        return std::max({half_step, width_of(label, text_size) + 16, widest_of(above, small_size) + 14});
    }
    int head() const {
        const int lines = static_cast<int>(above.size()) * (line_height - 1);
        return lines + (lines > 0 || sign == Sign::Up ? 10 : 0);
    }
    int foot() const { return sign == Sign::Down ? 10 : 0; }

    /// Returns the drawn action. Its left edge is at x = `left`, and its vertical centre is at y = `middle`.
    Drawing::Element at(int left, int middle) const {
        Drawing::Element drawn = element;
        const int top = middle - box_height / 2;
        drawn.boxes.push_back({{left, top}, {width(), box_height}});
        if (twofold) drawn.boxes.push_back({{left + 3, top + 3}, {width() - 6, box_height - 6}});
        drawn.texts.push_back(text_at(left + width() / 2, middle + 4, label, text_size, Anchor::Middle, "label"));
        const int line = left + 5;
        if (sign == Sign::Up) drawn.lines.push_back({{{line, top}, {line, top - 10}}, true});
        if (sign == Sign::Down)
            drawn.lines.push_back({{{line, top + box_height}, {line, top + box_height + 10}}, true});
        if (sign == Sign::Event) drawn.lines.push_back({{{line, top - head()}, {line, top}}, true});
        else if (!above.empty()) drawn.lines.push_back({{{line, top - head()}, {line, top}}});
        for (std::size_t k = 0; k < above.size(); ++k)
            drawn.texts.push_back(text_at(left + 12, top - head() + 11 + static_cast<int>(k) * (line_height - 1),
                                          above[k], small_size, Anchor::Start, "condition"));
        return drawn;
    }
};

Symbols::Symbols(const Chart& chart, const DrawOptions& options, const ChartText& text)
    : chart_(chart),
      text_(text),
      writing_(chart, options.notation),
      ids_(element_ids(chart, options.prefix)),
      active_(chart.steps.size(), false),
      continuous_(chart.steps.size()),
      stored_(chart.steps.size()),
      forcing_(chart.steps.size()),
      on_clearing_(chart.transitions.size()) {
    for (const Id<Chart::Step> step : options.situation) active_[step.index] = true;
    for (const auto id : chart.continuous.ids()) continuous_[chart.continuous[id].step.index].push_back(id);
    for (const auto id : chart.forcing.ids()) forcing_[chart.forcing[id].step.index].push_back(id);
    for (const auto id : chart.stored.ids()) {
        const Chart::StoredAction& action = chart.stored[id];
        if (action.on == Chart::StoredOn::Clearing) on_clearing_[action.transition.index].push_back(id);
        else stored_[action.step.index].push_back(id);
    }
}

Runs Symbols::runs(const std::vector<std::string>& written, std::uint32_t index, Id<Expr> term) const {
    if (writing_.notation() == Notation::Text && index < written.size() && !written[index].empty())
        return {{written[index], false}};
    return writing_.runs(term);
}

/// Adds the comment to the right of the step and its actions, in quotation marks as in IEC 60848.
void Symbols::add_comment(const std::string& comment, Symbol& symbol) const {
    if (comment.empty()) return;
    const std::vector<Runs> lines =
        wrapped({{'"' + shortened(comment, longest_comment) + '"', false}}, small_size, widest_comment);
    Drawing::Element text{.classes = "comment", .title = comment};
    const int half_height = static_cast<int>(lines.size()) * (line_height - 1) / 2;
    for (std::size_t k = 0; k < lines.size(); ++k)
        text.texts.push_back(text_at(symbol.space.right + 12,
                                     11 - half_height + static_cast<int>(k) * (line_height - 1), lines[k], small_size,
                                     Anchor::Start, "comment"));
    symbol.space.right += 12 + widest_of(lines, small_size);
    symbol.space.up = std::max(symbol.space.up, half_height);
    symbol.space.down = std::max(symbol.space.down, half_height);
    symbol.elements.push_back(std::move(text));
}

std::string Symbols::names_of(const std::vector<Id<Chart::Step>>& steps) const {
    std::string names;
    for (const Id<Chart::Step> step : steps) names += (names.empty() ? "" : ", ") + chart_.steps[step].name;
    return names;
}

std::string Symbols::title(Id<Chart::Transition> id) const {
    const Chart::Transition& transition = chart_.transitions[id];
    std::string title = "transition " + transition.name;
    if (transition.from.empty()) title += ", a source";
    else title += ", from " + names_of(transition.from);
    title += transition.to.empty() ? ", a sink" : " to " + names_of(transition.to);
    return title;
}

// -- actions ---------------------------------------------------------------------------------------------------------

/// Returns the box of a continuous action with its condition. A delay and a time limit are written as time conditions:
/// `3s/X2` for a delay of 3 s, and the negation of `8s/X2` for an additional limit of 5 s.
Symbols::Action Symbols::continuous(Id<Chart::ContinuousAction> id) const {
    const Chart::ContinuousAction& action = chart_.continuous[id];
    const std::string step = writing_.step(action.step);
    const bool iec = writing_.notation() == Notation::Iec;
    std::vector<Runs> terms;
    if (!is_true(chart_.exprs, action.condition)) {
        Runs condition = runs(text_.continuous, id.index, action.condition);
        const bool alone = action.delay_ms == 0 && action.limit_ms == 0;
        // The text is searched for a disjunction, because the term itself may have been simplified.
        const std::string text = plain_text(condition);
        const bool disjunction =
            iec ? chart_.exprs[action.condition].op == Op::Or
                : text.find("||") != text.npos || text.find("=>") != text.npos || text.find(" or ") != text.npos;
        if (!alone && disjunction) {
            condition.insert(condition.begin(), {"(", false});
            condition.push_back({")", false});
        }
        terms.push_back(std::move(condition));
    }
    if (action.delay_ms > 0) terms.push_back({{duration_text(action.delay_ms) + '/' + step, false}});
    if (action.limit_ms > 0) {
        const std::string end = duration_text(action.delay_ms + action.limit_ms) + '/' + step;
        terms.push_back({iec ? Drawing::Run{end, true} : Drawing::Run{"!" + end, false}});
    }
    const std::string& output = chart_.variables[action.output].name;
    Action result{.element = {.id = ids_.continuous[id.index], .classes = "action continuous"},
                  .label = shortened(output, longest_name)};
    const Runs condition = joined(std::move(terms), iec ? " · " : " && ");
    if (!condition.empty()) result.above = wrapped(condition, small_size, widest_text);
    result.element.title = output + " while " + step + (condition.empty() ? "" : " and " + plain_text(condition));
    return result;
}

Symbols::Action Symbols::stored(Id<Chart::StoredAction> id) const {
    const Chart::StoredAction& action = chart_.stored[id];
    const std::string value = plain_text(runs(text_.values, id.index, action.value));
    const std::string assignment = chart_.variables[action.target].name + " := " + value;
    Action result{.element = {.id = ids_.stored[id.index], .classes = "action stored"},
                  .label = shortened(assignment, longest_name)};
    std::string when;
    switch (action.on) {
    case Chart::StoredOn::Activation:
        result.sign = Action::Sign::Up;
        when = "activation";
        break;
    case Chart::StoredOn::Deactivation:
        result.sign = Action::Sign::Down;
        when = "deactivation";
        break;
    case Chart::StoredOn::Event: {
        result.sign = Action::Sign::Event;
        const Runs event = runs(text_.events, id.index, action.event);
        result.above = wrapped(event, small_size, widest_text);
        when = "event " + plain_text(event);
        result.element.classes += " event";
        break;
    }
    case Chart::StoredOn::Clearing: when = "clearing"; break;
    }
    if (action.on != Chart::StoredOn::Event) result.element.classes += ' ' + when;
    result.element.title = assignment + " on " + when;
    return result;
}

Symbols::Action Symbols::forcing(Id<Chart::ForcingOrder> id) const {
    const Chart::ForcingOrder& order = chart_.forcing[id];
    std::string situation;
    switch (order.to) {
    case Chart::ForcedTo::Empty: break;
    case Chart::ForcedTo::Current: situation = "*"; break;
    case Chart::ForcedTo::Initial: situation = "INIT"; break;
    case Chart::ForcedTo::Steps: situation = names_of(order.situation); break;
    }
    const std::string label = chart_.partial_charts[order.forced].name + " {" + situation + '}';
    return {.element = {.id = ids_.forcing[id.index], .classes = "forcing", .title = "forces " + label},
            .label = shortened(label, longest_name),
            .twofold = true};
}

/// Draws the actions of a node in a row, and a line that connects the row with the node. If the row would be wider than
/// `widest_row`, the actions are stacked, and a line at the left connects them.
void Symbols::add_actions(std::vector<Action> actions, int left, Symbol& symbol) const {
    if (actions.empty()) return;
    int width = 0;
    for (const Action& action : actions) width += action.width();
    const bool row = actions.size() == 1 || width <= widest_row;
    constexpr int lead = 14;
    int x = left + lead, y = 0;
    for (std::size_t k = 0; k < actions.size(); ++k) {
        const Action& action = actions[k];
        if (!row && k > 0) y += box_height / 2 + action.head() + 4;
        Drawing::Element drawn = action.at(x, y);
        if (k == 0) drawn.lines.push_back({{{left, 0}, {x, 0}}});
        else if (!row) drawn.lines.push_back({{{left + lead / 2, 0}, {left + lead / 2, y}, {x, y}}});
        symbol.elements.push_back(std::move(drawn));
        symbol.space.right = std::max(symbol.space.right, x + action.width());
        symbol.space.up = std::max(symbol.space.up, box_height / 2 + action.head() - y);
        symbol.space.down = std::max(symbol.space.down, y + box_height / 2 + action.foot());
        if (row) x += action.width();
        else y += box_height / 2 + action.foot();
    }
}

// -- steps and transitions -------------------------------------------------------------------------------------------

void Symbols::add_step_marks(Id<Chart::Step> id, int half, Drawing::Element& element) const {
    const Chart::Step& step = chart_.steps[id];
    element.boxes.push_back({{-half, -half_step}, {2 * half, 2 * half_step}});
    if (step.initial) element.boxes.push_back({{4 - half, 4 - half_step}, {2 * half - 8, 2 * half_step - 8}});
    if (step.kind == Chart::StepKind::Enclosing) {  // draws a line across each corner of the innermost square
        Drawing::Box corners = element.boxes.back();
        corners.cut = 9;
        element.boxes.push_back(corners);
    }
    if (step.kind == Chart::StepKind::Macro)
        for (const int y : {7 - half_step, half_step - 7}) element.lines.push_back({{{-half, y}, {half, y}}});
    if (step.activation_link) element.texts.push_back(text_at(-half - 4, 6, "*", 16, Anchor::End, "activation-link"));
    if (active_[id.index]) element.boxes.push_back({{-4, 7}, {8, 6}, 2, true});
}

Symbol Symbols::step(Id<Chart::Step> id) const {
    const Chart::Step& step = chart_.steps[id];
    const std::string name = shortened(step.name, longest_name);
    const int half = std::max(half_step, width_of(name, 13) / 2 + 10);
    Symbol symbol{.space = {half + (step.activation_link ? 18 : 0), half, half_step, half_step}, .port = half_step};
    Drawing::Element element{.id = ids_.steps[id.index], .classes = "step", .title = "step " + step.name};
    const auto also = [&](bool is, const char* word) {
        if (is) element.classes += fmt::format(" {}", word), element.title += fmt::format(", {}", word);
    };
    also(step.initial, "initial");
    also(step.kind == Chart::StepKind::Macro, "macro");
    also(step.kind == Chart::StepKind::Enclosing, "enclosing");
    also(step.entry, "entry");
    also(step.exit, "exit");
    also(active_[id.index], "active");
    add_step_marks(id, half, element);
    element.texts.push_back(text_at(0, 5, name, 13, Anchor::Middle, "name"));
    symbol.elements.push_back(std::move(element));
    std::vector<Action> actions;
    for (const auto action : continuous_[id.index]) actions.push_back(continuous(action));
    for (const auto action : stored_[id.index]) actions.push_back(stored(action));
    for (const auto order : forcing_[id.index]) actions.push_back(forcing(order));
    add_actions(std::move(actions), half, symbol);
    if (id.index < text_.comments.size()) add_comment(text_.comments[id.index], symbol);
    return symbol;
}

Symbol Symbols::transition(Id<Chart::Transition> id) const {
    const Chart::Transition& transition = chart_.transitions[id];
    const std::string name = '(' + shortened(transition.name, longest_name) + ')';
    const Runs condition = runs(text_.transitions, id.index, transition.condition);
    const std::vector<Runs> lines = wrapped(condition, text_size, widest_text);
    const int text_x = half_bar + 7, width = widest_of(lines, text_size);
    const int half_height = static_cast<int>(lines.size()) * line_height / 2;
    Symbol symbol{.space = {half_bar + 6 + width_of(name, small_size), text_x + width, std::max(9, half_height),
                            std::max(9, half_height)},
                  .port = 2};
    Drawing::Element bar{.id = ids_.transitions[id.index], .classes = "transition", .title = title(id)};
    if (transition.from.empty()) bar.classes += " source";
    if (transition.to.empty()) bar.classes += " sink";
    bar.boxes.push_back({{-half_bar, -2}, {2 * half_bar, 4}, 0, true});
    bar.texts.push_back(text_at(-half_bar - 6, 4, name, small_size, Anchor::End, "name"));
    symbol.elements.push_back(std::move(bar));
    Drawing::Element text{.id = ids_.conditions[id.index], .classes = "condition", .title = plain_text(condition)};
    for (std::size_t k = 0; k < lines.size(); ++k)
        text.texts.push_back(text_at(text_x, 11 - half_height + static_cast<int>(k) * line_height, lines[k], text_size,
                                     Anchor::Start, "condition"));
    symbol.elements.push_back(std::move(text));
    int y = symbol.space.down;
    for (const auto stored_id : on_clearing_[id.index]) {
        const Action action = stored(stored_id);
        y += box_height / 2 + 4;
        Drawing::Element drawn = action.at(text_x + 8, y);
        drawn.lines.push_back({{{half_bar - 4, 2}, {half_bar - 4, y}, {text_x + 8, y}}, true});
        symbol.elements.push_back(std::move(drawn));
        symbol.space.right = std::max(symbol.space.right, text_x + 8 + action.width());
        y += box_height / 2;
    }
    symbol.space.down = std::max(symbol.space.down, y);
    return symbol;
}

}  // namespace grafverif::draw
