// SPDX-License-Identifier: MIT
#include "emit/btor2/btor2.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "ir/flat_system.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/constants.hpp"

namespace grafverif::btor2 {

namespace {

using Line = std::uint32_t;  ///< number of a line in the output; 0 means no line
using Variable = FlatSystem::Variable;

/// A bit vector with the condition under which its value is undefined.
struct Word {
    bool boolean = true;
    std::uint32_t width = 1;
    /// `line`: the value. `undefined`: condition under which the value is undefined; 0 if it is always defined.
    Line line = 0, undefined = 0;
};

std::uint32_t width_of(std::int64_t value) {
    std::uint32_t width = 1;
    for (; value != 0 && value != -1; value >>= 1) ++width;
    return width;
}
std::uint32_t width_of(Type type) { return type.boolean ? 1 : std::max(width_of(type.low), width_of(type.high)); }

std::string one_word(std::string name) {
    for (char& c : name)
        if (static_cast<unsigned char>(c) <= ' ' || c == ';') c = '_';
    return name;
}

/// The lines of the output. Equal lines are written only once (hash consing).
class Lines {
public:
    Line sort(std::uint32_t width) { return line_of("sort bitvec " + std::to_string(width)); }
    Line constant(std::uint32_t width, std::int64_t value) {
        return line_of("constd " + std::to_string(sort(width)) + " " + std::to_string(value));
    }
    Line apply(std::string_view op, std::uint32_t width, std::initializer_list<Line> operands,
               const std::string& rest = "") {
        std::string line = std::string(op) + " " + std::to_string(sort(width));
        for (const Line operand : operands) line += " " + std::to_string(operand);
        return line_of(line + rest);
    }
    /// Adds a line without searching for an equal line. Used for lines that are not values, and for lines that several
    /// values must not share.
    Line fresh(const std::string& line) {
        text_ += std::to_string(++last_) + " " + line + "\n";
        return last_;
    }
    std::string text() && { return std::move(text_); }

private:
    Line line_of(const std::string& line) {
        const auto [place, first] = known_.try_emplace(line, 0);
        if (first) place->second = fresh(line);
        return place->second;
    }

    std::string text_ = {};
    Line last_ = 0;
    std::unordered_map<std::string, Line> known_ = {};
};

/// Translates terms to lines, with the semantics of `evaluate`.
class Terms {
public:
    Terms(const Exprs& exprs, Lines& lines, std::function<Word(const Expr&)> leaf)
        : exprs_(exprs), lines_(lines), leaf_(std::move(leaf)) {}

    Word operator()(Id<Expr> root) {
        std::vector<Id<Expr>> open{root};
        while (!open.empty()) {
            const Id<Expr> term = open.back();
            const std::size_t before = open.size();
            if (!known_.contains(term.index))
                for (const Id<Expr> operand : exprs_.operands(term))
                    if (!known_.contains(operand.index)) open.push_back(operand);
            if (open.size() != before) continue;
            open.pop_back();
            if (!known_.contains(term.index)) known_.emplace(term.index, built(term));
        }
        return known_.at(root.index);
    }

    // -- Booleans: `undefined` 0 means that the value is always defined
    // --------------------------------------------------------------

    Line truth(bool value) { return lines_.constant(1, value ? 1 : 0); }
    Line negation(Line a) { return lines_.apply("not", 1, {a}); }
    Line both(Line a, Line b) { return a == b ? a : lines_.apply("and", 1, {a, b}); }
    Line either(Line a, Line b) { return a == 0 || a == b ? b : b == 0 ? a : lines_.apply("or", 1, {a, b}); }
    Line chosen(Line condition, Line a, Line b) {
        if (a == b) return a;
        return lines_.apply("ite", 1, {condition, a == 0 ? truth(false) : a, b == 0 ? truth(false) : b});
    }
    /// Returns a line that is true if the word is true and defined.
    Line holds(const Word& word) { return word.undefined == 0 ? word.line : both(word.line, negation(word.undefined)); }

    Line widened(const Word& word, std::uint32_t width) {
        if (word.width == width) return word.line;
        return lines_.apply("sext", width, {word.line}, " " + std::to_string(width - word.width));
    }
    Word integer(std::int64_t value) { return {false, width_of(value), lines_.constant(width_of(value), value), 0}; }
    Word choice(Line condition, const Word& then, const Word& otherwise) {
        const std::uint32_t width = std::max(then.width, otherwise.width);
        return {then.boolean, width,
                lines_.apply("ite", width, {condition, widened(then, width), widened(otherwise, width)}),
                chosen(condition, then.undefined, otherwise.undefined)};
    }
    Line compared(std::string_view op, const Word& left, const Word& right) {
        const std::uint32_t width = std::max(left.width, right.width);
        return lines_.apply(op, 1, {widened(left, width), widened(right, width)});
    }
    /// Returns a line that is true if the word is defined and in the range of `type`.
    Line within(const Word& word, Type type) {
        const Line fits =
            type.boolean ? truth(true)
                         : both(compared("sgte", word, integer(type.low)), compared("slte", word, integer(type.high)));
        return word.undefined == 0 ? fits : both(fits, negation(word.undefined));
    }
    /// Returns the word with the width of `type`. Requires that all values of the word are in the range of `type`.
    Line fitted(const Word& word, Type type) {
        const std::uint32_t width = width_of(type);
        if (word.width <= width) return widened(word, width);
        return lines_.apply("slice", width, {word.line}, " " + std::to_string(width - 1) + " 0");
    }

private:
    Word built(Id<Expr> term) {
        const Expr& node = exprs_[term];
        std::vector<Word> operands;
        for (const Id<Expr> operand : exprs_.operands(term)) operands.push_back(known_.at(operand.index));
        switch (node.op) {
        case Op::False:
        case Op::True: return {true, 1, truth(node.op == Op::True), 0};
        case Op::Integer:
        case Op::Duration: return integer(node.value);
        case Op::Not: return {true, 1, negation(operands[0].line), operands[0].undefined};
        case Op::And:
        case Op::Or: return joined(node.op == Op::Or, operands);
        case Op::Conditional: {
            Word word = choice(operands[0].line, operands[1], operands[2]);
            word.undefined = either(operands[0].undefined, word.undefined);
            return word;
        }
        case Op::Equal: return relation("eq", operands);
        case Op::NotEqual: return relation("neq", operands);
        case Op::Less: return relation("slt", operands);
        case Op::LessEqual: return relation("slte", operands);
        case Op::Greater: return relation("sgt", operands);
        case Op::GreaterEqual: return relation("sgte", operands);
        case Op::Negate: return cut(calculated("sub", integer(0), operands[0], 1));
        case Op::Plus: return cut(calculated("add", operands[0], operands[1], 1));
        case Op::Minus: return cut(calculated("sub", operands[0], operands[1], 1));
        case Op::Times:
            return cut(calculated("mul", operands[0], operands[1], std::min(operands[0].width, operands[1].width)));
        case Op::Divide: return divided("sdiv", operands);
        case Op::Modulo: return divided("srem", operands);
        case Op::Variable:
        case Op::Step:
        case Op::Timed:
        case Op::Parameter:
        case Op::At: return leaf_(node);
        case Op::Rise:
        case Op::Fall: unreachable();  // `derive` has already replaced all edge operators
        }
        unreachable();
    }

    Word joined(bool disjunction, const std::vector<Word>& operands) {
        Word word{true, 1, truth(!disjunction), 0};
        for (const Word& operand : operands) {
            if (operand.undefined != 0) {
                const Line evaluates_next = disjunction ? negation(word.line) : word.line;
                word.undefined = either(word.undefined, both(evaluates_next, operand.undefined));
            }
            word.line = disjunction ? either(word.line, operand.line) : both(word.line, operand.line);
        }
        return word;
    }

    Word relation(std::string_view op, const std::vector<Word>& operands) {
        return {true, 1, compared(op, operands[0], operands[1]), either(operands[0].undefined, operands[1].undefined)};
    }

    /// Applies `op` to two words. The result has the width of the wider operand plus `more`.
    Word calculated(std::string_view op, const Word& left, const Word& right, std::uint32_t more) {
        const std::uint32_t width = std::max(left.width, right.width) + more;
        return {false, width, lines_.apply(op, width, {widened(left, width), widened(right, width)}),
                either(left.undefined, right.undefined)};
    }

    /// Reduces the word to 64 bits. The result is undefined if the value of the word does not fit in 64 bits.
    Word cut(Word word) {
        constexpr std::uint32_t most = 64;
        if (word.width <= most) return word;
        const Word low{false, most, lines_.apply("slice", most, {word.line}, " 63 0"), 0};
        word.undefined = either(word.undefined, lines_.apply("neq", 1, {word.line, widened(low, word.width)}));
        return {false, most, low.line, word.undefined};
    }

    Word divided(std::string_view op, const std::vector<Word>& operands) {
        Word word = calculated(op, operands[0], operands[1], 1);
        word.undefined = either(word.undefined, compared("eq", operands[1], integer(0)));
        const Word least = integer(std::numeric_limits<std::int64_t>::min());
        if (operands[0].width >= least.width)
            word.undefined = either(word.undefined,
                                    both(compared("eq", operands[0], least), compared("eq", operands[1], integer(-1))));
        return cut(word);
    }

    const Exprs& exprs_;
    Lines& lines_;
    std::function<Word(const Expr&)> leaf_ = {};
    std::unordered_map<std::uint32_t, Word> known_ = {};
};

class Writer {
public:
    explicit Writer(const TransitionSystem& system)
        : system_(system),
          flat_(flattened(system)),
          now_(flat_.exprs, lines_, [this](const Expr& leaf) { return words_[index(leaf)]; }),
          first_(flat_.exprs, lines_, [this](const Expr& leaf) { return first_value({index(leaf)}); }) {}

    Btor2Text result() {
        add_words();
        add_constraints();
        add_next_values();
        for (const Id<Property> id : system_.properties.ids()) add_query(id);
        for (const auto& [name, condition] : leaks_) bad(condition, name);
        if (!system_.constants.empty()) result_.text = "; constants: " + constants_text(system_.constants) + "\n";
        for (const NotInCircuit& each : result_.omitted) add_omitted(system_.properties[each.about], each.reason);
        for (const TransitionSystem::Omitted& each : system_.omitted) add_omitted(each.property, each.reason);
        result_.text += std::move(lines_).text();
        return std::move(result_);
    }

private:
    static std::uint32_t index(const Expr& leaf) { return static_cast<std::uint32_t>(leaf.value); }
    static bool has_state(const Variable& variable) { return !variable.choice && variable.next.has_value(); }

    Word named(const char* kind, Type type, const std::string& name) {
        const std::uint32_t width = width_of(type);
        const std::string line = std::string(kind) + " " + std::to_string(lines_.sort(width)) + " " + one_word(name);
        return {type.boolean, width, lines_.fresh(line), 0};
    }
    void define(const char* kind, const Word& state, Line value) {
        lines_.fresh(std::string(kind) + " " + std::to_string(lines_.sort(state.width)) + " " +
                     std::to_string(state.line) + " " + std::to_string(value));
    }

    const Word& first_value(Id<Variable> id) {
        if (const auto known = firsts_.find(id.index); known != firsts_.end()) return known->second;
        const Variable& variable = flat_.variables[id];
        const bool always = !has_state(variable) && !variable.initial;
        Word word = variable.initial ? first_(*variable.initial)
                                     : named("input", variable.type, variable.name + (always ? "" : ".first"));
        first_kept_ = now_.both(first_kept_ == 0 ? now_.truth(true) : first_kept_, now_.within(word, variable.type));
        word = {word.boolean, width_of(variable.type), now_.fitted(word, variable.type), 0};
        return firsts_.emplace(id.index, word).first->second;
    }

    void add_words() {
        const Line no = now_.truth(false);  // this constant must precede the states that are initialized with it
        started_ = named("state", Type{}, "started");
        define("init", started_, no);
        define("next", started_, now_.truth(true));
        words_.resize(flat_.variables.size());
        for (const Id<Variable> id : flat_.variables.ids()) {
            const Variable& variable = flat_.variables[id];
            const Word first = first_value(id);
            if (!has_state(variable) && !variable.initial) {
                words_[id.index] = first;
                continue;
            }
            const Word later = named(has_state(variable) ? "state" : "input", variable.type, variable.name);
            words_[id.index] = now_.choice(started_.line, later, first);
            if (has_state(variable)) states_.emplace_back(id, later);
        }
    }

    void add_constraints() {
        Line kept = now_.chosen(started_.line, now_.truth(true), first_kept_ == 0 ? now_.truth(true) : first_kept_);
        for (const Id<Expr> term : flat_.invariants) kept = now_.both(kept, now_.holds(now_(term)));
        for (const Id<Variable> id : flat_.variables.ids())
            if (!has_state(flat_.variables[id]))
                kept = now_.both(kept, now_.within(words_[id.index], flat_.variables[id].type));
        Line offered = kept;
        for (const Id<Expr> term : flat_.transitions) offered = now_.both(offered, now_.holds(now_(term)));
        const Word broken = named("state", Type{}, "broken");
        define("init", broken, now_.truth(false));
        define("next", broken, now_.either(broken.line, now_.negation(offered)));
        possible_ = now_.both(kept, now_.negation(broken.line));
        stepping_ = now_.both(offered, now_.negation(broken.line));
    }

    void add_next_values() {
        for (const auto& [id, state] : states_) {
            const Variable& variable = flat_.variables[id];
            const Word next = now_(*variable.next);
            define("next", state, now_.fitted(next, variable.type));
            leaks_.emplace_back(variable.name + ".leaves_its_range",
                                now_.both(stepping_, now_.negation(now_.within(next, variable.type))));
        }
    }

    void bad(Line condition, const std::string& name) {
        lines_.fresh("bad " + std::to_string(condition) + " " + one_word(name));
    }

    void add_query(Id<Property> id) {
        const Property& property = system_.properties[id];
        std::vector<Word> operands;
        for (const Id<Expr> operand : property.operands) operands.push_back(now_(flattened(system_, flat_, operand)));
        Line here = possible_;
        if (property.at_stable) here = now_.both(here, now_.holds(now_(flattened(system_, flat_, system_.settled))));
        switch (property.pattern) {
        case Pattern::Always: bad(now_.both(here, now_.negation(operands[0].line)), property.name); break;
        case Pattern::Never:
        case Pattern::Reachable: bad(now_.both(here, operands[0].line), property.name); break;
        case Pattern::ExactlyOneOf: bad(now_.both(here, now_.negation(exactly_one(operands))), property.name); break;
        default:
            result_.omitted.push_back({id,
                                       "this format supports only properties of states; `grafverif aiger` also "
                                       "supports properties of runs"});
            return;
        }
        for (const Word& operand : operands)
            if (operand.undefined != 0) bad(now_.both(here, operand.undefined), property.name + ".has_no_value");
    }

    void add_omitted(const Property& property, const std::string& reason) {
        result_.text += "; property " + property.name + " is omitted: " + reason + "\n";
    }

    Line exactly_one(const std::vector<Word>& operands) {
        Line none = now_.truth(true), one = now_.truth(false);
        for (const Word& operand : operands) {
            one = now_.either(now_.both(one, now_.negation(operand.line)), now_.both(none, operand.line));
            none = now_.both(none, now_.negation(operand.line));
        }
        return one;
    }

    const TransitionSystem& system_;
    FlatSystem flat_;
    Btor2Text result_ = {};
    Lines lines_ = {};
    Terms now_, first_;
    std::vector<Word> words_ = {};
    std::unordered_map<std::uint32_t, Word> firsts_ = {};
    std::vector<std::pair<Id<Variable>, Word>> states_ = {};
    std::vector<std::pair<std::string, Line>> leaks_ = {};
    Word started_ = {};
    Line first_kept_ = 0, possible_ = 0, stepping_ = 0;
};

}  // namespace

Btor2Text written(const TransitionSystem& system) { return Writer(system).result(); }

}  // namespace grafverif::btor2
