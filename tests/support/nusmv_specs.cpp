// SPDX-License-Identifier: MIT
#include "support/nusmv_specs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <functional>

namespace grafverif {

namespace {

// -- reading ----------------------------------------------------------------------------------------------------------

class SpecReader {
public:
    explicit SpecReader(std::string_view text) : rest_(text) { advance(); }

    std::optional<SpecTerm> formula() {
        SpecTerm term = implication();
        return fine_ && token_.empty() ? std::optional(term) : std::nullopt;
    }

private:
    static bool in_name(char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
    }

    void advance() {
        while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) rest_.remove_prefix(1);
        std::size_t length = rest_.empty() ? 0 : 1;
        if (!rest_.empty() && (std::isalnum(static_cast<unsigned char>(rest_[0])) != 0 || rest_[0] == '_'))
            while (length < rest_.size() && in_name(rest_[length])) ++length;
        for (const std::string_view symbol : {"<->", "->", "!=", "<=", ">="})
            if (rest_.starts_with(symbol)) {
                length = symbol.size();
                break;
            }
        token_ = rest_.substr(0, length);
        rest_.remove_prefix(length);
    }
    bool accept(std::string_view token) {
        if (token_ != token || token.empty()) return false;
        advance();
        return true;
    }
    void expect(std::string_view token) { fine_ = accept(token) && fine_; }
    std::string_view accept_one(std::initializer_list<std::string_view> tokens) {
        for (const std::string_view token : tokens)
            if (accept(token)) return token;
        return {};
    }

    template <class Operand>
    SpecTerm chain(std::initializer_list<std::string_view> operators, const Operand& operand) {
        SpecTerm left = operand();
        for (std::string_view op = accept_one(operators); !op.empty() && fine_; op = accept_one(operators))
            left = SpecTerm{std::string(op), {left, operand()}};
        return left;
    }

    SpecTerm implication() {
        SpecTerm left = chain({"<->"}, [this] { return choice(); });
        if (accept("->")) return {"->", {left, implication()}};
        return left;
    }
    SpecTerm choice() {
        SpecTerm condition = chain({"|", "xor", "xnor"}, [this] { return chain({"&"}, [this] { return unary(); }); });
        if (!accept("?")) return condition;
        SpecTerm then = implication();
        expect(":");
        return {"?", {condition, then, choice()}};
    }
    SpecTerm unary() {
        if (const std::string_view op = accept_one({"AG", "AF", "AX", "EG", "EF", "EX"}); !op.empty())
            return {std::string(op), {unary()}};
        return chain({"=", "!=", "<", "<=", ">", ">="}, [this] {
            return chain({"+", "-"}, [this] { return chain({"*", "/", "mod"}, [this] { return primary(); }); });
        });
    }
    SpecTerm primary() {
        if (accept("!")) {
            const bool temporal = token_.size() == 2 && (token_[0] == 'A' || token_[0] == 'E');
            return {"!", {temporal ? unary() : primary()}};
        }
        if (accept("-")) {  // NuSMV prints the number -1 and the negation of 1 identically
            SpecTerm operand = primary();
            if (operand.operands.empty() && std::isdigit(static_cast<unsigned char>(operand.op[0])) != 0)
                return {"-" + operand.op, {}};
            return {"neg", {operand}};
        }
        if (accept("(")) {
            SpecTerm inner = implication();
            expect(")");
            return inner;
        }
        if (accept("count")) {
            expect("(");
            SpecTerm term{"count", {implication()}};
            while (accept(",")) term.operands.push_back(implication());
            expect(")");
            return term;
        }
        fine_ = fine_ && !token_.empty() && in_name(token_[0]) && !accept("AG");
        SpecTerm leaf{std::string(token_), {}};
        advance();
        return leaf;
    }

    std::string_view rest_ = {}, token_ = {};
    bool fine_ = true;
};

// -- deciding ---------------------------------------------------------------------------------------------------------

/// The value of a term in each state of the graph.
using Values = std::vector<std::int64_t>;

class Decision {
public:
    Decision(const TransitionSystem& system, const SystemGraph& graph)
        : system_(system), graph_(graph), justice_(justice_sets(system, graph)), fair_(always_fair(all())) {}

    const StateSet& fair() const { return fair_; }

    StateSet holding(const SpecTerm& term) {
        const auto operand = [&](std::size_t k) { return holding(term.operands[k]); };
        const std::string& op = term.op;
        if (op == "&") return both(operand(0), operand(1));
        if (op == "|") return either(operand(0), operand(1));
        if (op == "->") return either(negated(operand(0)), operand(1));
        if (op == "xor") return both(either(operand(0), operand(1)), negated(both(operand(0), operand(1))));
        if (op == "!") return negated(operand(0));
        if (op == "EX") return before(both(operand(0), fair_));
        if (op == "AX") return negated(before(both(negated(operand(0)), fair_)));
        if (op == "EF") return reaching(all(), both(operand(0), fair_));
        if (op == "AG") return negated(reaching(all(), both(negated(operand(0)), fair_)));
        if (op == "EG") return always_fair(operand(0));
        if (op == "AF") return negated(always_fair(negated(operand(0))));
        StateSet result;
        for (const std::int64_t value : values(term)) result.push_back(value != 0);
        return result;
    }

private:
    StateSet all() const { return StateSet(graph_.states.size(), true); }
    static StateSet negated(StateSet set) {
        set.flip();
        return set;
    }
    static StateSet both(StateSet left, const StateSet& right) {
        for (std::size_t i = 0; i < left.size(); ++i) left[i] = left[i] && right[i];
        return left;
    }
    static StateSet either(StateSet left, const StateSet& right) {
        for (std::size_t i = 0; i < left.size(); ++i) left[i] = left[i] || right[i];
        return left;
    }
    StateSet before(const StateSet& set) const {
        StateSet result(set.size());
        for (std::size_t from = 0; from < set.size(); ++from)
            for (const std::size_t to : graph_.successors[from]) result[from] = result[from] || set[to];
        return result;
    }
    /// Computes E [within U goal] as the least fixpoint.
    StateSet reaching(const StateSet& within, const StateSet& goal) const {
        StateSet found = goal;
        for (StateSet last; last != found;) {
            last = found;
            found = either(found, both(within, before(found)));
        }
        return found;
    }
    /// Computes EG within along fair paths, by the greatest fixpoint of Emerson and Lei.
    StateSet always_fair(const StateSet& within) const {
        StateSet found = within;
        for (StateSet last; last != found;) {
            last = found;
            if (justice_.empty()) found = both(found, before(found));
            for (const StateSet& each : justice_) found = both(found, before(reaching(within, both(found, each))));
        }
        return found;
    }

    Values values(const SpecTerm& term) {
        if (term.operands.empty()) return leaf(term.op, {});
        if (term.op == "count") return counted(term);
        if (term.op == "neg") return apply(Values(graph_.states.size()), values(term.operands[0]), std::minus<>());
        if (term.op == "?") return chosen(term);
        if (term.op == "=" || term.op == "!=") return compared(term);
        return arithmetic(term);
    }

    Values chosen(const SpecTerm& term) {
        const StateSet condition = holding(term.operands[0]);
        const Values then = value_of_either(term.operands[1]), otherwise = value_of_either(term.operands[2]);
        Values result;
        for (std::size_t i = 0; i < condition.size(); ++i) result.push_back(condition[i] ? then[i] : otherwise[i]);
        return result;
    }
    /// Returns the values of a term, which is a condition or a number.
    Values value_of_either(const SpecTerm& term) {
        static const std::array<std::string_view, 5> logical{"&", "|", "->", "!", "xor"};
        if (std::ranges::find(logical, term.op) == logical.end()) return values(term);
        const StateSet set = holding(term);
        return {set.begin(), set.end()};
    }

    Values counted(const SpecTerm& term) {
        Values result(graph_.states.size());
        for (const SpecTerm& operand : term.operands) {
            const StateSet set = holding(operand);
            for (std::size_t i = 0; i < result.size(); ++i) result[i] += set[i] ? 1 : 0;
        }
        return result;
    }

    template <class Op>
    static Values apply(const Values& left, const Values& right, const Op& op) {
        Values result;
        for (std::size_t i = 0; i < left.size(); ++i)
            result.push_back(static_cast<std::int64_t>(op(left[i], right[i])));
        return result;
    }

    Values arithmetic(const SpecTerm& term) {
        const Values left = value_of_either(term.operands[0]), right = value_of_either(term.operands[1]);
        if (term.op == "+") return apply(left, right, std::plus<>());
        if (term.op == "-") return apply(left, right, std::minus<>());
        if (term.op == "*") return apply(left, right, std::multiplies<>());
        if (term.op == "<") return apply(left, right, std::less<>());
        if (term.op == "<=") return apply(left, right, std::less_equal<>());
        if (term.op == ">") return apply(left, right, std::greater<>());
        if (term.op == ">=") return apply(left, right, std::greater_equal<>());
        ADD_FAILURE() << "not an operator on states: " << term.op;
        return left;
    }

    /// Evaluates a comparison. A name that is not the name of a variable is a value of the other operand's type.
    Values compared(const SpecTerm& term) {
        const auto side = [&](std::size_t k) {
            const SpecTerm& here = term.operands[k];
            return here.operands.empty() ? leaf(here.op, term.operands[1 - k].op) : value_of_either(here);
        };
        const Values left = side(0), right = side(1);
        return term.op == "=" ? apply(left, right, std::equal_to<>()) : apply(left, right, std::not_equal_to<>());
    }

    Values leaf(const std::string& name, const std::string& value_of_variable) {
        const auto constant = [&](std::int64_t value) { return Values(graph_.states.size(), value); };
        if (name == "TRUE" || name == "FALSE") return constant(name == "TRUE" ? 1 : 0);
        if (std::isdigit(static_cast<unsigned char>(name.back())) != 0 &&
            (name[0] == '-' || std::isdigit(static_cast<unsigned char>(name[0])) != 0))
            return constant(std::strtoll(name.c_str(), nullptr, 10));
        if (!has_symbol(system_, name)) {
            const TransitionSystem::Symbol* symbol = symbol_called(value_of_variable);
            if (symbol != nullptr) {
                const auto at = std::ranges::find(symbol->values, name);
                if (at != symbol->values.end()) return constant(symbol->type.low + (at - symbol->values.begin()));
            }
        }
        Values result;
        for (const SystemState& state : graph_.states) result.push_back(value_of(system_, state, name));
        return result;
    }

    const TransitionSystem::Symbol* symbol_called(std::string_view path) const {
        const std::size_t dot = path.find('.');
        const auto in = [](const TransitionSystem::Module& module, std::string_view name) {
            const auto found = std::ranges::find(module.symbols, name, &TransitionSystem::Symbol::name);
            return found == module.symbols.end() ? nullptr : &*found;
        };
        if (dot == std::string_view::npos) return in(system_.modules[system_.main], path);
        const auto instance =
            std::ranges::find(system_.instances, path.substr(0, dot), &TransitionSystem::Instance::name);
        return instance == system_.instances.end() ? nullptr
                                                   : in(system_.modules[instance->module], path.substr(dot + 1));
    }

    const TransitionSystem& system_;
    const SystemGraph& graph_;
    std::vector<StateSet> justice_ = {};
    StateSet fair_ = {};
};

}  // namespace

std::optional<SpecTerm> read_spec(std::string_view text) {
    std::string whole(text);  // nusmv_reader separates all words by a blank
    for (std::size_t at = whole.find(" . "); at != std::string::npos; at = whole.find(" . ", at))
        whole.replace(at, 3, ".");
    return SpecReader(whole).formula();
}

bool spec_is_true(const TransitionSystem& system, const SystemGraph& graph, const NusmvModel::Specification& spec) {
    const auto term = read_spec(spec.formula);
    if (!term) {
        ADD_FAILURE() << "not a formula: " << spec.formula;
        return false;
    }
    Decision decision(system, graph);
    const StateSet holds = decision.holding(*term);
    if (spec.keyword == "INVARSPEC") return std::ranges::find(holds, false) == holds.end();
    bool everywhere = true, where_fair = true;
    for (std::size_t state = 0; state < graph.initial; ++state) {
        everywhere = everywhere && holds[state];
        where_fair = where_fair && (holds[state] || !decision.fair()[state]);
    }
    EXPECT_EQ(everywhere, where_fair) << spec.name << " depends on initial states without a fair run: " << spec.formula;
    return everywhere;
}

bool verdict_of_spec(const NusmvModel::Specification& spec, const Property& property, bool is_true) {
    const bool opposite = spec.name.starts_with("never_") && !property.name.starts_with("never_");
    return opposite != is_true;
}

}  // namespace grafverif
