// SPDX-License-Identifier: MIT
#include "syntax/print/equations.hpp"

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <string_view>

#include "support/json_text.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

std::string plain(const Equations& equations, Id<Expr> term) {
    return expr_text(equations.exprs, term, plain_spelling, [&](std::ostream& out, const Expr& leaf) {
        out << equations.variables[Id<Equations::Variable>{static_cast<std::uint32_t>(leaf.value)}].name;
    });
}

const std::string& name(const Equations& equations, Id<Equations::Variable> variable) {
    return equations.variables[variable].name;
}

/// True if actions may assign a value to the stored variable in the first evolution.
bool starts_with_actions(const Equations& equations, const Equations::Stored& stored) {
    const Expr& first = equations.exprs[stored.first];
    return first.op != Op::Variable || first.value != static_cast<std::int64_t>(stored.variable.index);
}

/// Writes the sections of the equations with `writer`, which produces plain text or LaTeX. `title(text)` of the writer
/// opens a section, and `close()` ends it. `line(name, term)` writes one equation, and `timer(timer)` writes the
/// equation that starts a timer.
template <class Writer>
void write_sections(const Equations& equations, Writer& writer) {
    if (!equations.firings.empty()) {
        writer.title("(a) Firing conditions");
        for (const Equations::Firing& firing : equations.firings) writer.line(firing.variable, firing.condition);
        writer.close();
    }
    writer.title("(b) Step activities");
    for (const Equations::StepActivity& step : equations.steps) writer.line(step.variable, step.next);
    writer.close();
    if (!equations.stored.empty()) {
        writer.title("(s) Stored actions");
        for (const Equations::Stored& stored : equations.stored) writer.line(stored.variable, stored.next);
        writer.close();
    }
    const auto section = [&](std::string_view title, auto wanted, auto term) {
        bool open = false;
        for (const Equations::Stored& stored : equations.stored) {
            if (!wanted(stored)) continue;
            if (!open) writer.title(title);
            open = true;
            writer.line(stored.variable, term(stored));
        }
        if (open) writer.close();
    };
    section(
        "(s) Stored actions, first evolution",
        [&](const Equations::Stored& stored) { return starts_with_actions(equations, stored); },
        [](const Equations::Stored& stored) { return stored.first; });
    section(
        "(s) Stored actions, races: two actions would store different values",
        [&](const Equations::Stored& stored) { return !is_false(equations.exprs, stored.race); },
        [](const Equations::Stored& stored) { return stored.race; });
    if (!equations.conflicts.empty()) {
        writer.title("(f) Conflicts of forcing orders");
        for (const Equations::Conflict& conflict : equations.conflicts) writer.condition(conflict.condition);
        writer.close();
    }
    if (!equations.previous.empty()) {
        writer.title("(e) Previous values");
        for (const Equations::Previous& previous : equations.previous) writer.line(previous.variable, previous.value);
        writer.close();
    }
    if (equations.timers.empty() && equations.outputs.empty()) return;
    writer.title("(c) Output values");
    for (const Equations::ObservedTerm& watch : equations.watches) writer.line(watch.variable, watch.value);
    for (const Equations::Timer& timer : equations.timers) writer.timer(timer);
    for (const Equations::Output& output : equations.outputs) writer.line(output.variable, output.value);
    writer.close();
}

struct PlainWriter {
    std::ostream& out;
    const Equations& equations;

    void title(std::string_view text) { out << '\n' << text << '\n'; }
    void line(Id<Equations::Variable> variable, Id<Expr> term) {
        out << name(equations, variable) << " = " << plain(equations, term) << '\n';
    }
    void condition(Id<Expr> term) { out << plain(equations, term) << '\n'; }
    void timer(const Equations::Timer& timer) { out << timer.name << " = " << name(equations, timer.watched) << '\n'; }
    void close() {}
};

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '_') result += '\\';
        result += c;
    }
    return result;
}

/// Returns LaTeX code that prints the text in italics, with the letter spacing of a word.
std::string italic(std::string_view text) { return "\\mathit{" + escaped(text) + "}"; }

/// Returns the name of a variable in LaTeX, such as `X_{10}` or `\mathit{CF}_{\mathit{T0}}` (paper CEP13, Fig. 19).
std::string latex_name(const Equations::Variable& variable) {
    using Role = Equations::Role;
    const std::string_view text = variable.name;
    if (variable.role == Role::FiringCondition) return "\\mathit{CF}_{" + italic(text.substr(3)) + "}";
    if (variable.role == Role::Previous || variable.role == Role::Watched)
        return std::string(text.substr(0, 1)) + "_{" + italic(text.substr(2)) + "}";
    if (variable.role != Role::Step) return italic(text);
    const std::string_view step = text.substr(2);
    const bool number = step.find_first_not_of("0123456789") == std::string_view::npos;
    return "X_{" + (number ? std::string(step) : italic(step)) + "}";
}

struct LatexWriter {
    std::ostream& out;
    const Equations& equations;
    bool first = true;

    void title(std::string_view text) {
        out << "\n\\noindent " << text << "\n\\begin{align*}\n";
        first = true;
    }
    void left(std::string_view text) {
        if (!first) out << " \\\\\n";
        first = false;
        out << "  " << text << " &= ";
    }
    void line(Id<Equations::Variable> variable, Id<Expr> term) {
        left(latex_name(equations.variables[variable]));
        print(term);
    }
    void condition(Id<Expr> term) {
        left("");
        print(term);
    }
    void print(Id<Expr> term) {
        print_expr(out, equations.exprs, term, latex_spelling, [&](std::ostream& stream, const Expr& leaf) {
            stream << latex_name(equations.variables[Id<Equations::Variable>{static_cast<std::uint32_t>(leaf.value)}]);
        });
    }
    void timer(const Equations::Timer& timer) {
        left(italic(timer.name));
        out << latex_name(equations.variables[timer.watched]);
    }
    void close() { out << "\n\\end{align*}\n"; }
};

}  // namespace

std::string equation_text(const Equations& equations, Id<Equations::Variable> variable, Id<Expr> term) {
    return name(equations, variable) + " = " + plain(equations, term);
}

void print_equations(std::ostream& out, const Equations& equations) {
    out << "Equations of " << equations.name << '\n';
    PlainWriter writer{out, equations};
    write_sections(equations, writer);
}

void print_equations_latex(std::ostream& out, const Equations& equations) {
    out << "% Equations of " << equations.name << "; needs \\usepackage{amsmath}\n";
    LatexWriter writer{out, equations};
    write_sections(equations, writer);
}

void print_equations_json(std::ostream& out, const Equations& equations) {
    Json firings = Json::array();
    for (const Equations::Firing& firing : equations.firings)
        firings.push_back({{"variable", name(equations, firing.variable)},
                           {"transition", firing.transition},
                           {"equation", plain(equations, firing.condition)}});
    Json steps = Json::array();
    for (const Equations::StepActivity& step : equations.steps)
        steps.push_back({{"variable", name(equations, step.variable)},
                         {"step", step.step.text()},
                         {"initial", equations.variables[step.variable].initial != 0},
                         {"equation", plain(equations, step.next)}});
    Json stored = Json::array();
    for (const Equations::Stored& one : equations.stored)
        stored.push_back({{"variable", name(equations, one.variable)},
                          {"equation", plain(equations, one.next)},
                          {"first", plain(equations, one.first)},
                          {"race", plain(equations, one.race)},
                          {"first_race", plain(equations, one.first_race)}});
    Json conflicts = Json::array();
    for (const Equations::Conflict& one : equations.conflicts) conflicts.push_back(plain(equations, one.condition));
    Json previous = Json::array(), watches = Json::array();
    for (const Equations::Previous& one : equations.previous)
        previous.push_back({{"variable", name(equations, one.variable)}, {"equation", plain(equations, one.value)}});
    for (const Equations::ObservedTerm& one : equations.watches)
        watches.push_back({{"variable", name(equations, one.variable)}, {"equation", plain(equations, one.value)}});
    Json timers = Json::array();
    for (const Equations::Timer& timer : equations.timers)
        timers.push_back({{"name", timer.name},
                          {"watched", name(equations, timer.watched)},
                          {"rise_ms", timer.rise_ms},
                          {"fall_ms", timer.fall_ms},
                          {"end", name(equations, timer.end)},
                          {"equation", name(equations, timer.watched)}});
    Json outputs = Json::array();
    for (const Equations::Output& output : equations.outputs)
        outputs.push_back(
            {{"variable", name(equations, output.variable)}, {"equation", plain(equations, output.value)}});
    const Json object = {{"name", equations.name}, {"firing_conditions", firings},
                         {"steps", steps},         {"stored", stored},
                         {"conflicts", conflicts}, {"previous", previous},
                         {"watches", watches},     {"timers", timers},
                         {"outputs", outputs},     {"stable", plain(equations, equations.stable)}};
    out << json_text(object) << '\n';
}

}  // namespace grafverif
