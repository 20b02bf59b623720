// SPDX-License-Identifier: MIT
// Prints expressions in canonical notation.
#include <string>

#include "support/overloaded.hpp"
#include "syntax/language/format.hpp"
#include "syntax/print/dialect.hpp"
#include "syntax/resolve/terms.hpp"

namespace grafverif {

namespace {

/// Returns the precedence of an operator; a higher number binds more strongly. The order is the same as in the grammar.
int precedence(tree::Op op) {
    switch (op) {
    case tree::Op::Implies: return 0;
    case tree::Op::Or: return 1;
    case tree::Op::And: return 2;
    case tree::Op::Equal:
    case tree::Op::NotEqual:
    case tree::Op::Less:
    case tree::Op::LessEqual:
    case tree::Op::Greater:
    case tree::Op::GreaterEqual: return 3;
    case tree::Op::Plus:
    case tree::Op::Minus: return 4;
    case tree::Op::Times:
    case tree::Op::Divide:
    case tree::Op::Modulo: return 5;
    case tree::Op::Not:
    case tree::Op::Negate: return 6;
    case tree::Op::False:
    case tree::Op::True:
    case tree::Op::Number:
    case tree::Op::Duration:
    case tree::Op::Name:
    case tree::Op::Member:
    case tree::Op::In:
    case tree::Op::All:
    case tree::Op::Any:
    case tree::Op::Each:
    case tree::Op::Rise:
    case tree::Op::Fall: return 7;
    }
    unreachable();
}

/// Returns a duration in the unit of the source, which has a finite decimal form: `5min`, `1.5s`.
std::string written_duration(std::int64_t milliseconds, std::int64_t unit_ms) {
    if (unit_ms == 0) return duration_text(milliseconds);
    const char* const unit = unit_ms == 60'000 ? "min" : unit_ms == 1000 ? "s" : "ms";
    std::string text = std::to_string(milliseconds / unit_ms);
    std::int64_t rest = milliseconds % unit_ms;
    if (rest != 0) text += '.';
    for (; rest != 0; rest %= unit_ms) {
        unit_ms /= 10;
        text += std::to_string(rest / unit_ms);
    }
    return text + unit;
}

class ExprPrinter {
public:
    explicit ExprPrinter(const tree::File& file) : file_(&file) {}

    void print(Id<tree::Expr> id) {
        const tree::Expr& node = file_->exprs[id];
        switch (node.op) {
        case tree::Op::False: text += "false"; return;
        case tree::Op::True: text += "true"; return;
        case tree::Op::Number: text += std::to_string(node.value); return;
        case tree::Op::Duration: text += written_duration(node.value, node.unit_ms); return;
        case tree::Op::Name: print(node.word, node.first); return;
        case tree::Op::Member:
        case tree::Op::In:
            print(node.first);
            text += node.op == tree::Op::In ? " in " : ".";
            print(node.word, file_->exprs[node.first].next);
            return;
        case tree::Op::All:
        case tree::Op::Any:
            text += node.op == tree::Op::All ? "all(" : "any(";
            print(replication(*file_, node));
            text += ": ";
            print(node.last);
            text += ')';
            return;
        case tree::Op::Each:
            print(node.last);
            text += " for ";
            print(replication(*file_, node));
            return;
        case tree::Op::Rise:
        case tree::Op::Fall:
            text += node.op == tree::Op::Rise ? "rise(" : "fall(";
            print(node.first);
            text += ')';
            return;
        case tree::Op::Not:
        case tree::Op::Negate:
            text += node.op == tree::Op::Not ? '!' : '-';
            operand(node, node.first, file_->exprs[node.first].op == tree::Op::Negate ? 7 : 6);
            return;
        default: infix(node);
        }
    }

    /// Prints a name with its indices. `index` is the first index; the other indices are its siblings.
    void print(Id<tree::Word> word, Id<tree::Expr> index) {
        text += file_->text(word);
        for (; index.valid(); index = file_->exprs[index].next) {
            text += '[';
            print(index);
            text += ']';
        }
    }

    void print(const tree::Replication& replication) {
        print(replication.index.word, {});
        text += " in ";
        print(replication.range.low);
        text += "..";
        print(replication.range.high);
    }

    std::string text = {};

private:
    bool is_duration(Id<tree::Expr> id) const { return file_->exprs[id].op == tree::Op::Duration; }
    bool is_time(const tree::Expr& node) const {
        return node.op == tree::Op::Divide && (is_duration(node.first) || is_duration(node.last));
    }

    void operand(const tree::Expr& parent, Id<tree::Expr> id, int least) {
        const tree::Expr& child = file_->exprs[id];
        const bool mixed = child.bracketed && parent.op == tree::Op::Or && child.op == tree::Op::And;
        const bool apart = child.bracketed && is_time(child) && is_time(parent);  // (3s/X2)/2s differs from 3s/X2/2s
        const bool brackets = precedence(child.op) < least || mixed || apart;
        if (brackets) text += '(';
        print(id);
        if (brackets) text += ')';
    }

    void infix(const tree::Expr& node) {
        const int own = precedence(node.op);
        const bool junction = node.op == tree::Op::And || node.op == tree::Op::Or;
        // An operand of an implication that is itself an implication is printed in brackets.
        const bool comparison = own == 3 || own == 0;
        const std::string sign(spelling(node.op));
        bool first = true;
        for (Id<tree::Expr> id = node.first; id.valid(); id = file_->exprs[id].next) {
            if (!first) text += is_time(node) ? sign : ' ' + sign + ' ';
            operand(node, id, junction ? own : (first && !comparison) ? own : own + 1);
            first = false;
        }
    }

    const tree::File* file_;
};

}  // namespace

std::string formatted(const tree::File& file, Id<tree::Expr> expression) {
    ExprPrinter printer(file);
    printer.print(expression);
    return std::move(printer.text);
}

std::string formatted(const tree::File& file, tree::Name name) {
    ExprPrinter printer(file);
    printer.print(name.word, name.index);
    return std::move(printer.text);
}

std::string formatted(const tree::File& file, const tree::Replication& replication) {
    ExprPrinter printer(file);
    printer.print(replication);
    return std::move(printer.text);
}

}  // namespace grafverif
