// SPDX-License-Identifier: MIT
// Prints the code of a controller in Structured Text. REPEAT is not used, because a published version of MATIEC
// compiles `UNTIL c` as `while (c)`, without the negation.
#include "emit/structured_text/body.hpp"

#include <fmt/format.h>

#include <utility>

#include "emit/controller/indented_text.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::structured_text {

namespace {

using controller::Cell;
using controller::Code;
using controller::Statement;
using controller::Timer;

class Writer : controller::IndentedText {
public:
    Writer(const Code& code, const DialectRow& dialect) : code_(code), dialect_(dialect) {
        leaf_ = [this](std::ostream& out, const Expr& leaf) {
            out << name(Id<Cell>{static_cast<std::uint32_t>(leaf.value)});
        };
    }

    std::string write() {
        for (const Statement& statement : code_.body) write(statement);
        return std::move(text_);
    }

private:
    std::string text(Id<Expr> term) const { return expr_text(code_.exprs, term, dialect_.spelling, leaf_); }

    std::string name(Id<Cell> cell) const {
        const Cell& found = code_.cells[cell];
        return fmt::format("{}{}{}", dialect_.prefix,
                           found.timer.valid() ? code_.timers[found.timer].name + "." : std::string(), found.name);
    }

    void write(const Statement& statement) {
        switch (statement.kind) {
        case Statement::Kind::Comment: return line("(* {} *)", statement.comment);
        case Statement::Kind::Assign: return line("{} := {};", name(statement.target), text(statement.value));
        case Statement::Kind::Cases: return cases(name(statement.target), statement.value);
        case Statement::Kind::Guard:
            return line("IF {} THEN {} := {}; END_IF;", text(statement.condition), name(statement.target),
                        text(statement.value));
        case Statement::Kind::Stop: return line("IF {} THEN RETURN; END_IF;", text(statement.condition));
        case Statement::Kind::Call: {
            const Timer& timer = code_.timers[statement.timer];
            return line("{}{}(IN := {}, PT := {});", dialect_.prefix, timer.name, name(timer.input),
                        time_literal(timer.preset_ms));
        }
        case Statement::Kind::If: return begin(fmt::format("IF {} THEN", text(statement.condition)));
        case Statement::Kind::While: return begin(fmt::format("WHILE {} DO", text(statement.condition)));
        case Statement::Kind::Else: return end("ELSE"), void(++depth_);
        case Statement::Kind::EndIf: return end("END_IF;");
        case Statement::Kind::EndWhile: return end("END_WHILE;");
        }
    }

    void cases(const std::string& target, Id<Expr> value) {
        const Exprs& exprs = code_.exprs;
        const char* keyword = "IF";
        for (; exprs[value].op == Op::Conditional; value = exprs.operands(value)[2]) {
            line("{} {} THEN {} := {};", keyword, text(exprs.operands(value)[0]), target,
                 text(exprs.operands(value)[1]));
            keyword = "ELSIF";
        }
        line("ELSE {} := {};", target, text(value));
        line("END_IF;");
    }

    const Code& code_;
    const DialectRow& dialect_;
    LeafPrinter leaf_ = {};
};

}  // namespace

std::string time_literal(std::int64_t milliseconds) { return "T#" + duration_text(milliseconds); }

std::string body_of(const Code& code, const DialectRow& dialect) { return Writer(code, dialect).write(); }

}  // namespace grafverif::structured_text
