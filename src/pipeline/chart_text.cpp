// SPDX-License-Identifier: MIT
#include "pipeline/chart_text.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include "draw/chart.hpp"
#include "ir/program/interface.hpp"
#include "read/formats.hpp"
#include "support/overloaded.hpp"
#include "syntax/language/format.hpp"
#include "syntax/print/program.hpp"

namespace grafverif {

namespace {

struct WrittenStep {
    Span where = {};
    std::uint32_t name = 0;  ///< offset of the name of the step, as in Chart::Step::origin
};

/// The source texts of the expressions of a chart. The key of a text is the offset in the source at which the
/// transition or action with the expression starts.
struct SourceTexts {
    std::map<std::uint32_t, std::string> conditions = {}, values = {}, events = {};
    std::vector<WrittenStep> steps = {};
};

class Collector {
public:
    Collector(const tree::File& file, SourceTexts& written) : file_(file), written_(written) {}

    void add(const std::vector<tree::ChartItem>& items) {
        for (const tree::ChartItem& item : items)
            std::visit(overloaded{
                           [&](const tree::Step& step) {
                               written_.steps.push_back({step.where, step.name.where.begin});
                               for (const tree::Action& action : step.actions) add(action);
                           },
                           [&](const tree::Transition& transition) {
                               note(written_.conditions, transition.where, transition.condition);
                               for (const tree::Assignment& each : transition.assignments) add(each);
                           },
                           [&](const tree::Partial& partial) { add(partial.items); },
                           [](const auto&) {},
                       },
                       item);
    }

private:
    void add(const tree::Action& action) {
        if (const auto* continuous = std::get_if<tree::ContinuousAction>(&action))
            note(written_.conditions, continuous->where, continuous->condition);
        if (const auto* stored = std::get_if<tree::StoredAction>(&action)) {
            add(stored->assignment);
            note(written_.events, stored->assignment.where, stored->event);
        }
    }
    void add(const tree::Assignment& assignment) { note(written_.values, assignment.where, assignment.value); }

    void note(std::map<std::uint32_t, std::string>& texts, Span where, Id<tree::Expr> term) {
        if (term.valid()) texts[where.begin] = formatted(file_, term);
    }

    const tree::File& file_;
    SourceTexts& written_;
};

/// Returns the text of a comment without the markers `//`, `/* */` or `(* *)`.
std::string words_of(std::string_view comment) {
    for (const std::string_view begin : {"//", "/*", "(*"})
        if (comment.starts_with(begin)) comment.remove_prefix(2);
    for (const std::string_view end : {"*/", "*)"})
        if (comment.ends_with(end)) comment.remove_suffix(2);
    while (!comment.empty() && (comment.front() == ' ' || comment.front() == '*')) comment.remove_prefix(1);
    while (!comment.empty() && comment.back() == ' ') comment.remove_suffix(1);
    return std::string(comment);
}

/// Returns, for each step, the comment at the end of the first or last line of the step. The key is the offset of the
/// step's name in the source.
std::map<std::uint32_t, std::string> comments_of(const tree::File& file, std::string_view text,
                                                 std::vector<WrittenStep> steps) {
    const auto begin = [](const WrittenStep& step) { return step.where.begin; };
    std::ranges::sort(steps, {}, begin);
    const auto one_line = [&](std::uint32_t from, std::uint32_t to) {
        return from <= to && text.substr(from, to - from).find('\n') == std::string_view::npos;
    };
    std::map<std::uint32_t, std::string> found;
    for (const tree::Comment& comment : file.comments) {
        if (comment.own_line) continue;
        const auto next_step = std::ranges::upper_bound(steps, comment.where.begin, {}, begin);
        if (next_step == steps.begin()) continue;
        const WrittenStep& step = *std::prev(next_step);
        if (one_line(step.where.begin, comment.where.begin) || one_line(step.where.end, comment.where.begin))
            found.try_emplace(step.name, words_of(comment.text));
    }
    return found;
}

template <class Elements>
std::vector<std::string> texts_of(const Elements& elements, const std::map<std::uint32_t, std::string>& written,
                                  Id<Source> source) {
    std::vector<std::string> texts;
    for (const auto& element : elements) {
        const auto known = written.find(element.origin.begin);
        const bool elsewhere = element.origin.source != source;  // true for an element from a chart of another file
        texts.push_back(elsewhere || known == written.end() ? std::string() : known->second);
    }
    return texts;
}

/// Returns the transition conditions of the Sequential Function Charts of a program.
ChartText text_of_program(const Chart& drawn) {
    const Program& program = *drawn.program;
    const ProgramLayout layout = layout_of(program);
    ChartText text;
    for (const SequenceTest& test : sequence_tests(program, layout))
        text.transitions.push_back(term_text(program, test.unit, program.statements[test.statement].value));
    return text;
}

/// Returns the texts of a chart. `file` is the syntax tree of its source, and `text` is the text of this source.
ChartText text_in(const Chart& chart, const tree::File& file, std::string_view text) {
    SourceTexts written;
    for (const tree::Declaration& declaration : file.declarations)
        if (const auto* found = std::get_if<tree::Chart>(&declaration);
            found != nullptr && found->name.where.begin == chart.origin.begin)
            Collector(file, written).add(found->items);
    return {.comments = texts_of(chart.steps, comments_of(file, text, written.steps), chart.origin.source),
            .transitions = texts_of(chart.transitions, written.conditions, chart.origin.source),
            .continuous = texts_of(chart.continuous, written.conditions, chart.origin.source),
            .events = texts_of(chart.stored, written.events, chart.origin.source),
            .values = texts_of(chart.stored, written.values, chart.origin.source)};
}

}  // namespace

ChartText text_of(const Model& model, Id<Chart> id, const Sources& sources) {
    const Chart& chart = model.charts[id];
    if (!chart.instance_of.empty()) return {};  // the names in a chart instance differ from the names in its source
    if (!sources.contains(chart.origin.source)) return {};
    Sources copy;  // `read_any` may modify a source, so it receives a copy
    Diagnostics known;
    const Id<Source> source = copy.add(sources[chart.origin.source]);
    const tree::File file = read_any(source, copy, {true}, known);
    return text_in(chart, file, copy[source].text);
}

Drawing drawing_of(const Model& model, Id<Chart> id, const DrawOptions& options, const Sources& sources,
                   const tree::File& file, Id<Source> source) {
    const Chart& chart = model.charts[id];
    const bool is_here = chart.instance_of.empty() && !chart.program && chart.origin.source == source;
    if (!is_here) return drawing_of(model, id, options, sources);
    return draw::drawing_of(chart, options, text_in(chart, file, sources[source].text));
}

Drawing drawing_of(const Model& model, Id<Chart> chart, const DrawOptions& options, const Sources& sources) {
    if (model.charts[chart].program) {
        DrawOptions of_program = options;
        of_program.notation = Notation::Text;
        const Chart drawn = drawn_chart(model.charts[chart]);
        return draw::drawing_of(drawn, of_program, text_of_program(drawn));
    }
    return draw::drawing_of(model.charts[chart], options, text_of(model, chart, sources));
}

}  // namespace grafverif
