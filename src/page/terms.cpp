// SPDX-License-Identifier: MIT
#include "page/terms.hpp"

#include <algorithm>
#include <ostream>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "ir/display_name.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/sentence.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_text = 160;

const char* name_of(Op op) {
    switch (op) {
    case Op::False:
    case Op::True:
    case Op::Integer:
    case Op::Duration: return "constant";
    case Op::Variable:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At: return "unknown";
    case Op::Not: return "not";
    case Op::And: return "and";
    case Op::Or: return "or";
    case Op::Rise: return "rise";
    case Op::Fall: return "fall";
    case Op::Equal: return "equal";
    case Op::NotEqual: return "not-equal";
    case Op::Less: return "less";
    case Op::LessEqual: return "less-equal";
    case Op::Greater: return "greater";
    case Op::GreaterEqual: return "greater-equal";
    case Op::Negate: return "negate";
    case Op::Plus: return "plus";
    case Op::Minus: return "minus";
    case Op::Times: return "times";
    case Op::Divide: return "divide";
    case Op::Modulo: return "modulo";
    case Op::Conditional: return "if";
    }
    unreachable();
}

bool is_number(Op op) { return op == Op::Integer || op == Op::Duration || is_arithmetic(op); }

/// Returns the index of a variable among the variables of the same kind (input, output, internal). The lists of signals
/// of a controller have the same order.
std::size_t place_of(const Chart& chart, Id<Chart::Variable> wanted) {
    std::size_t place = 0;
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        if (id == wanted) break;
        place += chart.variables[id].kind == chart.variables[wanted].kind ? 1U : 0U;
    }
    return place;
}

const char* kind_of(const Chart& chart, Id<Chart::Variable> id) {
    switch (chart.variables[id].kind) {
    case Chart::VariableKind::Input: return "input";
    case Chart::VariableKind::Output: return "output";
    case Chart::VariableKind::Internal: return "internal";
    }
    unreachable();
}

Json variable_json(const Chart& chart, Id<Chart::Variable> id) {
    return {{"op", kind_of(chart, id)}, {"boolean", chart.variables[id].type.boolean}, {"place", place_of(chart, id)}};
}

// -- charts -----------------------------------------------------------------------------------------------------------

class ChartTerms {
public:
    explicit ChartTerms(const Chart& chart)
        : chart_(chart), terms_(chart.exprs, leaf_printer(chart), [this](const Expr& leaf) { return json(leaf); }) {}

    Json json() {
        Json steps = Json::array(), transitions = Json::array(), timed = Json::array();
        for (const Id<Chart::Step> id : chart_.steps.ids()) steps.push_back(step_variable(chart_, id));
        for (const Chart::Transition& each : chart_.transitions) {
            Json from = Json::array();
            for (const Id<Chart::Step> step : enabling(each)) from.push_back(step.index);
            transitions.push_back(
                {{"name", each.name}, {"from", std::move(from)}, {"condition", terms_.add(each.condition)}});
        }
        for (const Chart::TimeCondition& each : chart_.time_conditions)
            timed.push_back({{"rise", each.rise_ms}, {"fall", each.fall_ms}, {"watched", terms_.add(each.watched)}});
        Json actions = Json::array(), orders = Json::array();
        for (const Chart::ContinuousAction& action : chart_.continuous) actions.push_back(action.step.index);
        for (const Chart::ForcingOrder& order : chart_.forcing) orders.push_back(order.step.index);
        return {{"name", chart_.name},
                {"steps", std::move(steps)},
                {"transitions", std::move(transitions)},
                {"timed", std::move(timed)},
                {"terms", terms_.nodes()},
                {"ownerOfAction", std::move(actions)},
                {"ownerOfForcing", std::move(orders)}};
    }

private:
    /// Returns the steps that must be active to enable the transition. For a transition after a macro-step, the result
    /// includes the exit step. For a source transition, the result is the owner of its partial chart.
    std::vector<Id<Chart::Step>> enabling(const Chart::Transition& transition) const {
        std::vector<Id<Chart::Step>> steps = transition.from;
        const Id<Chart::Step> owner = chart_.partial_charts[transition.chart].owner;
        if (steps.empty() && owner.valid()) steps.push_back(owner);
        for (const Id<Chart::Step> from : transition.from) {
            if (chart_.steps[from].kind != Chart::StepKind::Macro) continue;
            for (const Id<Chart::Step> step : chart_.steps.ids())
                if (chart_.steps[step].exit && chart_.partial_charts[chart_.steps[step].chart].owner == from)
                    steps.push_back(step);
        }
        return steps;
    }

    Json json(const Expr& leaf) {
        const auto index = static_cast<std::uint32_t>(leaf.value);
        if (leaf.op == Op::Step) return {{"op", "step"}, {"boolean", true}, {"place", index}};
        if (leaf.op == Op::Timed) return {{"op", "timed"}, {"boolean", true}, {"place", index}};
        if (leaf.op != Op::Variable) return {{"op", "unknown"}, {"boolean", true}};
        Json node = variable_json(chart_, {index});
        if (chart_.variables[{index}].kind == Chart::VariableKind::Output) add_output({index}, node);
        return node;
    }
    /// Adds to the node of a continuous output the actions that determine its value (CEP13 (13)).
    void add_output(Id<Chart::Variable> output, Json& node) {
        Json actions = Json::array();
        for (const Chart::ContinuousAction& action : chart_.continuous)
            if (action.output == output)
                actions.push_back({{"step", action.step.index},
                                   {"timed", action.delay_ms > 0 || action.limit_ms > 0},
                                   {"condition", terms_.add(action.condition)}});
        node["stored"] = actions.empty();
        node["actions"] = std::move(actions);
    }

    const Chart& chart_;
    TermList terms_;
};

// -- loops ------------------------------------------------------------------------------------------------------------

/// An element to which a property refers: its node in the term, and its name in the closed loop.
struct Named {
    Json node = {};
    std::string text = {};
};

Named named(const Model& model, const ClosedLoop& loop, const ClosedLoop::Symbol& symbol) {
    const bool single = loop.controllers.size() == 1;
    const auto of_chart = [&](Id<ClosedLoop::Controller> controller, Json node) {
        node["controller"] = controller.index;
        return node;
    };
    const auto chart_of = [&](Id<ClosedLoop::Controller> id) -> const Chart& {
        return model.charts[loop.controllers[id].chart];
    };
    const auto before = [&](Id<ClosedLoop::Controller> id) {
        return single ? std::string() : loop.controllers[id].name + ".";
    };
    return std::visit(
        overloaded{
            [&](const ClosedLoop::SharedSymbol& shared) -> Named {
                const ClosedLoop::Shared& variable = loop.shared[shared.shared];
                const auto controller = variable.writer.valid() ? variable.writer : variable.reader;
                if (!controller.valid()) return {{{"op", "signal"}, {"boolean", variable.type.boolean}}, variable.name};
                return {of_chart(controller, variable_json(chart_of(controller), variable.variable)), variable.name};
            },
            [&](const ClosedLoop::InternalSymbol& internal) -> Named {
                const Chart& chart = chart_of(internal.controller);
                // For a program, the node contains the name of the variable instead of its index, because a run of a
                // program does not contain all internal variables.
                if (chart.program)
                    return {{{"op", "signal"}, {"boolean", chart.variables[internal.variable].type.boolean}},
                            before(internal.controller) + chart.variables[internal.variable].name};
                return {of_chart(internal.controller, variable_json(chart, internal.variable)),
                        before(internal.controller) + chart.variables[internal.variable].name};
            },
            [&](const ClosedLoop::StepSymbol& step) -> Named {
                return {of_chart(step.controller, {{"op", "step"}, {"boolean", true}, {"place", step.step.index}}),
                        before(step.controller) + step_variable(chart_of(step.controller), step.step)};
            },
            [&](const ClosedLoop::LocationSymbol& at) -> Named {
                const ClosedLoop::Instance& instance = loop.instances[at.instance];
                const std::string& location = model.components[instance.component].locations[at.location].name;
                return {{{"op", "location"}, {"boolean", true}, {"instance", instance.name}, {"location", location}},
                        instance.name + "." + location};
            },
            [&](const ClosedLoop::OwnSymbol& of) -> Named {
                const ClosedLoop::Instance& instance = loop.instances[of.instance];
                const Component::Variable& variable = model.components[instance.component].variables[of.variable];
                return {{{"op", "signal"}, {"boolean", variable.value == Component::ValueKind::Boolean}},
                        display_name(instance.name, model.components[instance.component], variable.name)};
            },
            [&](const ClosedLoop::TimeSymbol& of) -> Named {
                const Chart& chart = chart_of(of.controller);
                Json node = {{"op", of.condition.valid() ? "timed" : "unknown"}, {"boolean", true}};
                if (of.condition.valid()) node["place"] = of.condition.index;
                return {of_chart(of.controller, std::move(node)), time_text(chart, of)};
            },
            [&](const ClosedLoop::ObserverSymbol& at) -> Named {
                const ClosedLoop::Observer& observer = loop.observers[at.observer];
                return {{{"op", "unknown"}, {"boolean", true}},
                        observer.name + "." + observer.locations[at.location].name};
            },
        },
        symbol);
}

const ClosedLoop::Symbol& symbol_of(const ClosedLoop& loop, const Expr& leaf) {
    return loop.symbols[{static_cast<std::uint32_t>(leaf.value)}];
}

LeafPrinter printer(const Model& model, const ClosedLoop& loop) {
    return [&](std::ostream& out, const Expr& leaf) { out << named(model, loop, symbol_of(loop, leaf)).text; };
}

const char* pattern_of(Pattern pattern) {
    switch (pattern) {
    case Pattern::Always: return "always";
    case Pattern::Never: return "never";
    case Pattern::Reachable: return "reachable";
    case Pattern::Inevitable: return "inevitable";
    case Pattern::LeadsTo: return "leads-to";
    case Pattern::ExactlyOneOf: return "exactly-one";
    case Pattern::AlwaysPossible: return "always-possible";
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
    case Pattern::ReachableAllSteps:
    case Pattern::Watched:
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::RawLtl: return "other";
    }
    unreachable();
}

/// Returns, for each operand of a property with an observer, a heading that states the role of the operand.
std::vector<std::string> headings_of(const Sentence& sentence) {
    const std::string bound = bound_text(sentence);
    const auto own = [&]() -> std::vector<std::string> {
        switch (sentence.kind) {
        case Sentence::Kind::Absence: return {"forbidden"};
        case Sentence::Kind::Universality: return {"must be true"};
        case Sentence::Kind::Existence: return {"must become true"};
        case Sentence::Kind::Response:
            return {"premise", "required response" + (bound.empty() ? "" : " within " + bound)};
        case Sentence::Kind::Precedence: return {"must be true first", "must not become true earlier"};
        case Sentence::Kind::HoldsFor: return {"once true, must stay true for " + bound};
        case Sentence::Kind::HoldsAtMost: return {"must not stay true for longer than " + bound};
        case Sentence::Kind::Since: return {"may be true only until " + bound + " after", "this was true"};
        case Sentence::Kind::Recurrence: return {"must be true at least every " + bound};
        case Sentence::Kind::Occurrences:
            return {"must not become true more than " + bound + (bound == "1" ? " time" : " times")};
        }
        unreachable();
    };
    std::vector<std::string> headings = own();
    if (sentence.scope == Sentence::Scope::After) headings.emplace_back("once this is true");
    if (sentence.scope == Sentence::Scope::Between || sentence.scope == Sentence::Scope::AfterUntil)
        headings.emplace_back("once this is true");
    if (sentence.scope != Sentence::Scope::Globally && sentence.scope != Sentence::Scope::After)
        headings.emplace_back("until this is true");
    return headings;
}

}  // namespace

std::size_t TermList::add(Id<Expr> term) {
    if (const auto known = places_.find(term); known != places_.end()) return known->second;
    const Expr& node = (*exprs_)[term];
    Json made = {{"op", name_of(node.op)}, {"boolean", !is_number(node.op)}};
    if (is_leaf(node.op)) made = leaf_(node);
    else if (is_constant(node.op)) made["value"] = node.op == Op::True ? 1 : node.value;
    else {
        Json args = Json::array();
        for (const Id<Expr> operand : exprs_->operands(term)) args.push_back(add(operand));
        if (node.op == Op::Conditional) made["boolean"] = nodes_[args[1].get<std::size_t>()]["boolean"];
        made["args"] = std::move(args);
    }
    std::string text = expr_text(*exprs_, term, chart_spelling, print_);
    if (text.size() > longest_text) text = text.substr(0, longest_text) + " ...";
    made["text"] = std::move(text);
    nodes_.push_back(std::move(made));
    return places_[term] = nodes_.size() - 1;
}

Json chart_json(const Chart& chart) { return ChartTerms(chart).json(); }

Json property_json(const Model& model, const ClosedLoop& loop, const Property& property) {
    TermList terms(loop.exprs, printer(model, loop),
                   [&](const Expr& leaf) { return named(model, loop, symbol_of(loop, leaf)).node; });
    Json operands = Json::array();
    for (const Id<Expr> operand : property.operands) operands.push_back(terms.add(operand));
    Json made = {{"name", property.name},
                 {"pattern", pattern_of(property.pattern)},
                 {"at_stable", property.at_stable},
                 {"operands", std::move(operands)},
                 {"terms", terms.nodes()}};
    if (property.pattern == Pattern::Watched) made["headings"] = headings_of(property.watch);
    return made;
}

std::string term_text(const Model& model, const ClosedLoop& loop, Id<Expr> term) {
    return expr_text(loop.exprs, term, chart_spelling, printer(model, loop));
}

std::string expectation_text(const Model& model, const ClosedLoop& loop, const Property& property) {
    std::vector<std::string> operands;
    for (const Id<Expr> operand : property.operands) operands.push_back(term_text(model, loop, operand));
    const std::string claimed = property.pattern == Pattern::Watched
                                    ? claim(property.watch, operands, bound_text(property.watch))
                                    : claim(property.pattern, operands, property.raw);
    return claimed + (property.at_stable ? " at stable" : "");
}

namespace {

/// Returns the text of a property in its file, as one line without comments; empty if the property was not read from a
/// `.grafcet` file.
std::string written_expectation(const Property& property, const Sources& sources) {
    const Span name = property.origin;
    if (!sources.contains(name.source)) return {};
    const std::string_view text = sources[name.source].text;
    if (name.end > text.size() || text.substr(name.begin, name.end - name.begin) != property.name) return {};
    std::string claimed;
    bool begun = false;
    for (std::size_t at = name.end; at < text.size(); ++at) {
        if (text[at] == ';') return begun ? claimed : "";
        const std::size_t begin = at;
        if (text.substr(at).starts_with("//")) at = std::min(text.find('\n', at), text.size() - 1);
        else if (text.substr(at).starts_with("/*")) at = std::min(text.find("*/", at + 2), text.size() - 2) + 1;
        const std::size_t quoted = text[at] == '"' ? text.find('"', at + 1) : at;
        if (quoted == std::string_view::npos) return {};
        const std::string_view part = text.substr(at, quoted + 1 - at);
        const bool blank = at > begin || part == " " || part == "\t" || part == "\r" || part == "\n";
        if (!begun) begun = part == ":";
        else if (!blank) claimed += part;
        else if (!claimed.empty() && claimed.back() != ' ') claimed += ' ';
        at = quoted;
    }
    return {};
}

}  // namespace

std::string expectation_text(const Model& model, Id<ClosedLoop> loop, const std::string& name, const Sources& sources) {
    if (!loop.valid()) return {};
    for (const std::string& wanted : {name, name.substr(0, name.find('.'))})
        for (const Property& property : model.loops[loop].properties) {
            if (property.name != wanted) continue;
            const std::string written = written_expectation(property, sources);
            return written.empty() ? expectation_text(model, model.loops[loop], property) : written;
        }
    return {};
}

}  // namespace grafverif
