// SPDX-License-Identifier: MIT
#include "draw/writing.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <unordered_map>

#include "support/text/encoding.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::draw {

namespace {

/// Widths of the ASCII characters from space to tilde, in thousandths of an em.
constexpr std::array<int, 95> widths = {318,  401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337,
                                        636,  636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 556,
                                        1015, 684, 686, 722, 770, 667, 611, 778, 752, 295, 500, 667, 557, 863, 748, 787,
                                        667,  787, 722, 667, 611, 732, 684, 989, 685, 667, 685, 390, 337, 390, 838, 556,
                                        500,  613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612,
                                        635,  635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838};
constexpr int width_of_others = 1100;

constexpr char over_begins = '\x0E', over_ends = '\x0F';  ///< markers around text with an overline, until it is split
                                                          ///< into runs

int thousandths(std::string_view text) {
    int sum = 0;
    for (const char c : text)
        if (c >= ' ' && c <= '~') sum += widths[static_cast<std::size_t>(c - ' ')];
        else if (!continues_character(c)) sum += width_of_others;
    return sum;
}

Spelling iec_spelling(Op op) {
    constexpr int enclosed = 0;
    Spelling spelling = plain_spelling(op);
    switch (op) {
    case Op::False: return {"0", atom_precedence};
    case Op::True: return {"1", atom_precedence};
    case Op::Not: return {"", enclosed, "\x0E", "\x0F"};
    case Op::And: spelling.token = "·"; break;
    case Op::Or: spelling.token = "+"; break;
    case Op::Rise: spelling.token = "↑"; break;
    case Op::Fall: spelling.token = "↓"; break;
    case Op::Equal: spelling.token = "="; break;
    case Op::NotEqual: spelling.token = "≠"; break;
    case Op::LessEqual: spelling.token = "≤"; break;
    case Op::GreaterEqual: spelling.token = "≥"; break;
    case Op::Times: spelling.token = "×"; break;
    default: break;
    }
    if (is_comparison(op)) spelling.open = "[", spelling.close = "]";
    return spelling;
}

/// Splits a text with markers into runs with and without an overline. Overlines are not nested: a negation inside an
/// overline is written with the sign `¬` and brackets.
Runs runs_of_marked(std::string_view marked) {
    Runs runs;
    int depth = 0;
    const auto text = [&]() -> std::string& {
        const bool over = depth > 0;
        if (runs.empty() || runs.back().over != over) runs.push_back({"", over});
        return runs.back().text;
    };
    for (const char c : marked) {
        if (c == over_begins) {
            if (depth > 0) text() += "¬(";
            ++depth;
        } else if (c == over_ends) {
            if (depth > 1) text() += ")";
            --depth;
        } else {
            text() += c;
        }
    }
    return runs;
}

}  // namespace

int width_of(std::string_view text, int size) { return (thousandths(text) * size + 999) / 1000; }

int width_of(const Runs& runs, int size) {
    int sum = 0;
    for (const Drawing::Run& run : runs) sum += thousandths(run.text);
    return (sum * size + 999) / 1000;
}

std::vector<Runs> wrapped(const Runs& runs, int size, int width) {
    std::vector<Runs> lines(1);
    int filled = 0;
    const auto add = [&](std::string_view word, bool over) {
        Runs& line = lines.back();
        if (line.empty() || line.back().over != over) line.push_back({"", over});
        line.back().text += word;
    };
    for (const Drawing::Run& run : runs) {
        std::string_view rest = run.text;
        while (!rest.empty()) {
            const std::size_t blank = std::min(rest.find(' '), rest.size() - 1);
            const std::string_view word = rest.substr(0, blank + 1);
            const int needed = thousandths(word);
            if (filled > 0 && filled + needed > width * 1000 / size && lines.back().back().text.ends_with(' ')) {
                lines.emplace_back();
                filled = 0;
            }
            add(word, run.over);
            filled += needed;
            rest.remove_prefix(word.size());
        }
    }
    for (Runs& line : lines)
        if (!line.empty() && line.back().text.ends_with(' ')) line.back().text.pop_back();
    if (lines.size() > most_lines) {
        lines.resize(most_lines);
        lines.push_back({{"…", false}});
    }
    return lines;
}

std::string plain_text(const Runs& runs) {
    std::string text;
    for (const Drawing::Run& run : runs) text += run.over ? "¬(" + run.text + ')' : run.text;
    return text;
}

std::string shortened(std::string_view text, std::size_t characters) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (continues_character(text[k])) continue;
        if (++count > characters) return std::string(text.substr(0, k)) + "…";
    }
    return std::string(text);
}

Writing::Writing(const Chart& chart, Notation notation) : chart_(chart), notation_(notation) {
    std::unordered_map<std::string_view, int> uses;
    for (const Chart::Step& step : chart.steps) ++uses[step.name];
    for (const Id<Chart::Step> step : chart.steps.ids()) {
        const std::string& name = chart.steps[step].name;
        steps_.push_back(shortened(uses[name] == 1 ? "X" + name : step_variable(chart, step), longest_name));
    }
}

Runs Writing::runs(Id<Expr> term) const { return runs_of_marked(marked(term)); }

std::string Writing::marked(Id<Expr> term) const {
    return expr_text(chart_.exprs, term, notation_ == Notation::Iec ? iec_spelling : chart_spelling,
                     [this](std::ostream& out, const Expr& node) { print_leaf(out, node); });
}

void Writing::print_leaf(std::ostream& out, const Expr& node) const {
    const auto index = static_cast<std::uint32_t>(node.value);
    if (node.op == Op::Variable) out << shortened(chart_.variables[{index}].name, longest_name);
    else if (node.op == Op::Step) out << steps_[index];
    else out << time_text(chart_, chart_.time_conditions[{index}], [this](Id<Expr> term) { return marked(term); });
}

}  // namespace grafverif::draw
