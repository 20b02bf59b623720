// SPDX-License-Identifier: MIT
#include "emit/c/c.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "emit/controller/indented_text.hpp"
#include "emit/wrapped_text.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::c {

namespace {

using controller::Cell;
using controller::Code;
using controller::Section;
using controller::Statement;
using controller::Timer;
using controller::Word;

const char* type_word(Word word) {
    switch (word) {
    case Word::Bool: return "bool";
    case Word::Int16: return "int16_t";
    case Word::Int32: return "int32_t";
    case Word::Unsigned32: return "uint32_t";
    }
    unreachable();
}

std::string literal(Word word, std::int64_t value) {
    if (word == Word::Bool) return value != 0 ? "true" : "false";
    return std::to_string(value) + (word == Word::Unsigned32 ? "U" : "");
}

/// Returns `text` for use inside a comment: a blank is inserted between the characters of `/*` and `*/`.
std::string comment_text(std::string text) {
    for (const std::string_view mark : {"/*", "*/"})
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
            text.insert(at + 1, " ");
    return text;
}

bool has_timer(const Code& code, bool off_delay) {
    return std::ranges::any_of(code.timers, [&](const Timer& timer) { return timer.off_delay == off_delay; });
}

/// Prints the files. No name conflicts with a member of the structs. The only macro has a name that ends with `_`;
/// legal names do not end with `_`. The type of the timers is a struct tag, and C keeps tags in a separate name space.
class Writer : controller::IndentedText {
public:
    explicit Writer(const Code& code) : code_(code) {
        leaf_ = [this](std::ostream& out, const Expr& leaf) {
            out << name(Id<Cell>{static_cast<std::uint32_t>(leaf.value)});
        };
    }

    std::string header() {
        std::istringstream lines(code_.comment);
        for (std::string one; std::getline(lines, one);) line("/* {} */", comment_text(one));
        line("#ifndef {0}_H_\n#define {0}_H_\n\n#include <stdbool.h>\n#include <stdint.h>\n", code_.name);
        line("#ifdef __cplusplus\nextern \"C\" {{\n#endif\n");
        for (const Cell& cell : code_.cells)
            if (cell.section == Section::Constant)
                line("/* {} */\nstatic const {} {}_{} = {};\n", comment_text(cell.comment), type_word(cell.word),
                     code_.name, cell.name, literal(cell.word, cell.initial));
        write_inputs();
        if (code_.timers.size() > 0)
            line("struct {}_timer {{\n    bool running;\n    bool q;\n    uint32_t elapsed_ms;\n}};\n", code_.name);
        write_state();
        line("/* Sets the state at power-on. */\nvoid {0}_init({0}_state *self);\n", code_.name);
        line(
            "/* Executes one PLC cycle, elapsed_ms milliseconds after the previous one. */\n"
            "void {0}_scan({0}_state *self, const {0}_inputs *in, uint32_t elapsed_ms);\n",
            code_.name);
        line("#ifdef __cplusplus\n}}\n#endif\n\n#endif");
        return std::move(text_);
    }

    std::string source(std::string_view header) {
        if (!header.empty()) line("#include \"{}\"\n", header);
        write_timers();
        write_init();
        line("void {0}_scan({0}_state *self, const {0}_inputs *in, uint32_t elapsed_ms)\n{{", code_.name);
        const std::string before = std::exchange(text_, {});
        ++depth_;
        for (const Timer& timer : code_.timers) line("{}_advance(&self->{}, elapsed_ms);", code_.name, timer.name);
        for (const Statement& statement : code_.body) write(statement);
        const std::string body = std::exchange(text_, before);
        if (body.find("in->") == std::string::npos) line("(void)in;");
        if (code_.timers.size() == 0) line("(void)elapsed_ms;");
        text_ += body;
        --depth_;
        line("}}");
        std::ostringstream out;
        print_wrapped(out, text_, "/*");
        return std::move(out).str();
    }

private:
    std::string text(Id<Expr> term) const { return expr_text(code_.exprs, term, c_language_spelling, leaf_); }

    std::string name(Id<Cell> cell) const {
        const Cell& found = code_.cells[cell];
        if (found.timer.valid()) return fmt::format("self->{}.q", code_.timers[found.timer].name);
        if (found.section == Section::Constant) return fmt::format("{}_{}", code_.name, found.name);
        return (found.section == Section::Input ? "in->" : "self->") + found.name;
    }

    bool has_inputs() const {
        return std::ranges::any_of(code_.cells, [](const Cell& cell) { return cell.section == Section::Input; });
    }

    // -- header --

    void member(const Cell& cell) {
        const std::string comment = cell.comment.empty() ? "" : fmt::format("  /* {} */", comment_text(cell.comment));
        line("    {} {};{}", type_word(cell.word), cell.name, comment);
    }

    void members(Section section) {
        for (const auto& declaration : code_.declarations) {
            if (const auto* id = std::get_if<Id<Cell>>(&declaration)) {
                if (code_.cells[*id].section == section) member(code_.cells[*id]);
            } else if (section == Section::Local)
                line("    struct {}_timer {};", code_.name, code_.timers[std::get<Id<Timer>>(declaration)].name);
        }
    }

    void write_inputs() {
        line("typedef struct {{");
        members(Section::Input);
        if (!has_inputs()) line("    bool unused;  /* the chart has no inputs */");
        line("}} {}_inputs;\n", code_.name);
    }

    void write_state() {
        line("typedef struct {{\n    /* outputs */");
        members(Section::Output);
        line("    /* internal */");
        members(Section::Local);
        line("}} {}_state;\n", code_.name);
    }

    // -- source --

    void write_timers() {
        if (code_.timers.size() == 0) return;
        line(
            "static void {0}_advance(struct {0}_timer *timer, uint32_t elapsed_ms)\n{{\n"
            "    if (timer->running) {{\n"
            "        if (elapsed_ms < (UINT32_MAX - timer->elapsed_ms)) {{\n"
            "            timer->elapsed_ms += elapsed_ms;\n"
            "        }} else {{\n"
            "            timer->elapsed_ms = UINT32_MAX;\n"
            "        }}\n"
            "    }}\n}}\n",
            code_.name);
        if (has_timer(code_, false))
            line(
                "/* on-delay timer TON of IEC 61131-3 */\n"
                "static void {0}_ton(struct {0}_timer *timer, bool input, uint32_t preset_ms)\n{{\n"
                "    if (!input) {{\n"
                "        timer->elapsed_ms = 0U;\n"
                "    }}\n"
                "    timer->running = input;\n"
                "    timer->q = input && (timer->elapsed_ms >= preset_ms);\n}}\n",
                code_.name);
        if (has_timer(code_, true))
            line(
                "/* off-delay timer TOF of IEC 61131-3 */\n"
                "static void {0}_tof(struct {0}_timer *timer, bool input, uint32_t preset_ms)\n{{\n"
                "    if (input) {{\n"
                "        timer->elapsed_ms = 0U;\n"
                "    }}\n"
                "    timer->q = input || (timer->q && (timer->elapsed_ms < preset_ms));\n"
                "    timer->running = timer->q && !input;\n}}\n",
                code_.name);
    }

    void write_init() {
        line("void {0}_init({0}_state *self)\n{{", code_.name);
        ++depth_;
        for (const auto& declaration : code_.declarations) {
            if (const auto* id = std::get_if<Id<Timer>>(&declaration)) {
                const std::string& timer = code_.timers[*id].name;
                line("self->{}.running = false;", timer);
                line("self->{}.q = false;", timer);
                line("self->{}.elapsed_ms = 0U;", timer);
                continue;
            }
            const Cell& cell = code_.cells[std::get<Id<Cell>>(declaration)];
            if (cell.section == Section::Output || cell.section == Section::Local)
                line("self->{} = {};", cell.name, literal(cell.word, cell.initial));
        }
        --depth_;
        line("}}\n");
    }

    void assign(Id<Cell> target, Id<Expr> value) { line("{} = {};", name(target), text(value)); }

    void write(const Statement& statement) {
        switch (statement.kind) {
        case Statement::Kind::Comment: return line("/* {} */", statement.comment);
        case Statement::Kind::Assign: return assign(statement.target, statement.value);
        case Statement::Kind::Cases: return cases(statement.target, statement.value);
        case Statement::Kind::Guard:
            begin(fmt::format("if ({}) {{", text(statement.condition)));
            assign(statement.target, statement.value);
            return end("}");
        case Statement::Kind::Stop:
            begin(fmt::format("if ({}) {{", text(statement.condition)));
            line("return;");
            return end("}");
        case Statement::Kind::Call: {
            const Timer& timer = code_.timers[statement.timer];
            return line("{}_{}(&self->{}, {}, {}U);", code_.name, timer.off_delay ? "tof" : "ton", timer.name,
                        name(timer.input), timer.preset_ms);
        }
        case Statement::Kind::If: return begin(fmt::format("if ({}) {{", text(statement.condition)));
        case Statement::Kind::While: return begin(fmt::format("while ({}) {{", text(statement.condition)));
        case Statement::Kind::Else: return end("} else {"), void(++depth_);
        case Statement::Kind::EndIf:
        case Statement::Kind::EndWhile: return end("}");
        }
    }

    void cases(Id<Cell> target, Id<Expr> value) {
        const Exprs& exprs = code_.exprs;
        begin(fmt::format("if ({}) {{", text(exprs.operands(value)[0])));
        for (;;) {
            assign(target, exprs.operands(value)[1]);
            value = exprs.operands(value)[2];
            if (exprs[value].op != Op::Conditional) break;
            --depth_;
            begin(fmt::format("}} else if ({}) {{", text(exprs.operands(value)[0])));
        }
        end("} else {");
        ++depth_;
        assign(target, value);
        end("}");
    }

    const Code& code_;
    LeafPrinter leaf_ = {};
};

}  // namespace

std::string header_of(const Code& code) { return Writer(code).header(); }

std::string source_of(const Code& code, std::string_view header) { return Writer(code).source(header); }

}  // namespace grafverif::c
