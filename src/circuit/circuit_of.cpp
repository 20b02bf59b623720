// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <utility>

#include "circuit/circuit.hpp"
#include "ir/bit_terms.hpp"

namespace grafverif {

namespace {

using Term = BitTerm<Gate>;
using Variable = FlatSystem::Variable;

/// Returns the number of bits of a value in two's complement, including the sign.
std::size_t signed_width(std::int64_t value) { return bits::constant<Gate>(value).size(); }

/// Returns a word that describes the coding of values of `type`, without bits.
Circuit::Word coding(Type type) {
    if (type.boolean || bit_count(type) == 0) return {type, type.boolean ? 0 : type.low, false, {}};
    const std::size_t least = bit_count(type);
    if (type.low < 0 && std::max(signed_width(type.low), signed_width(type.high)) == least) return {type, 0, true, {}};
    if (type.low >= 0 && signed_width(type.high) - 1 == least) return {type, 0, false, {}};
    return {type, type.low, false, {}};
}

class Builder {
public:
    Builder(const TransitionSystem& system, FlatSystem& flat)
        : system_(system),
          flat_(flat),
          now_(flat.exprs, [this](const Expr& leaf) { return term_of(words_[static_cast<std::size_t>(leaf.value)]); }),
          first_(flat.exprs, [this](const Expr& leaf) { return first_value(variable_of(leaf)); }) {}

    CircuitOf result() {
        add_words();
        add_constraints();
        add_next_values();
        add_queries();
        for (const Id<Expr> term : flat_.symbols) result_.circuit.symbols.push_back(word_of(now_(term)));
        for (const GateWord& word : words_) result_.circuit.words.push_back(plain(word));
        return std::move(result_);
    }

private:
    using Literal = Gates::Literal;
    struct GateWord {
        Circuit::Word coding = {};
        std::vector<Gate> bits = {};
    };

    Circuit& circuit() { return result_.circuit; }
    static Id<Variable> variable_of(const Expr& leaf) { return {static_cast<std::uint32_t>(leaf.value)}; }
    static bool has_latches(const Variable& variable) { return !variable.choice && variable.next.has_value(); }

    static std::string bit_name(const Variable& variable, std::size_t place) {
        return variable.type.boolean ? variable.name : variable.name + "[" + std::to_string(place) + "]";
    }

    Gate add_input(std::string name) {
        const Literal literal = circuit().gates.source();
        circuit().inputs.push_back({node_of(literal), std::move(name)});
        return {&circuit().gates, literal};
    }
    /// Adds a latch. The caller later sets the next value of the latch.
    Gate add_latch(std::string name) {
        const Literal literal = circuit().gates.source();
        circuit().latches.push_back({node_of(literal), Gates::no, std::move(name)});
        return {&circuit().gates, literal};
    }

    static Circuit::Word plain(const GateWord& word) {
        Circuit::Word result = word.coding;
        for (const Gate& bit : word.bits) result.bits.push_back(bit.literal);
        return result;
    }
    static Circuit::Word word_of(const Term& term) {
        Circuit::Word word{{}, 0, !term.boolean, {}};
        if (!term.boolean) word.type = integer_type(least_integer, greatest_integer);
        for (const Gate& bit : term.bits) word.bits.push_back(bit.literal);
        return word;
    }

    static Term term_of(const GateWord& word) {
        if (word.coding.type.boolean) return boolean_term(word.bits.front());
        bits::Integer<Gate> number(word.bits.begin(), word.bits.end());
        if (!word.coding.with_sign) number.emplace_back();
        return {false, bits::sum(number, bits::constant<Gate>(word.coding.base)), {}};
    }
    /// Returns the bits that represent the value of the term in the given coding. Requires that the value is in the
    /// range of the coding's type.
    static std::vector<Gate> bits_of(const Term& term, const Circuit::Word& coding) {
        if (coding.type.boolean) return term.bits;
        bits::Integer<Gate> number = bits::difference(term.bits, bits::constant<Gate>(coding.base));
        number.resize(bit_count(coding.type), number.back());
        return number;
    }
    static Gate is_of_type(const Term& term, Type type) { return within(term, type.low, type.high); }
    static Gate truth(const Term& term) { return term.bits.front() & ~term.undefined; }

    // -- current values ----------------------------------------------------------------------------------------------

    /// Returns the initial value of a variable as a term. If the variable has no initial value, the bits of the term
    /// are inputs.
    const Term& first_value(Id<Variable> id) {
        if (const auto known = firsts_.find(id.index); known != firsts_.end()) return known->second;
        const Variable& variable = flat_.variables[id];
        Term term;
        if (variable.initial) {
            term = first_(*variable.initial);
            first_kept_ = first_kept_ & is_of_type(term, variable.type);
        } else {
            term = term_of({codings_[id.index], free_bits(variable, codings_[id.index], " at first")});
            if (has_latches(variable)) first_kept_ = first_kept_ & is_of_type(term, variable.type);
        }
        if (!has_latches(variable) && !variable.initial) {
            words_[id.index] = {codings_[id.index], bits_of(term, codings_[id.index])};
        }
        return firsts_.emplace(id.index, std::move(term)).first->second;
    }

    std::vector<Gate> free_bits(const Variable& variable, const Circuit::Word& coding, const std::string& when) {
        std::vector<Gate> bits;
        const bool always = !has_latches(variable) && !variable.initial;
        for (std::size_t place = 0; place < bit_count(coding.type); ++place)
            bits.push_back(add_input(bit_name(variable, place) + (always ? "" : when)));
        return bits;
    }

    /// Returns a literal that is equal to `first` in the first state, and to `later` (latch or input) in all later
    /// states.
    Gate after_first(const Gate& later, const Gate& first) {
        if (started_.is_false()) started_ = add_latch("started");
        return ite(started_, later, first);
    }

    void add_words() {
        for (const Variable& variable : flat_.variables) codings_.push_back(coding(variable.type));
        words_.resize(flat_.variables.size());
        for (const Id<Variable> id : flat_.variables.ids()) {
            const Variable& variable = flat_.variables[id];
            const Term first = first_value(id);
            if (!has_latches(variable) && !variable.initial) continue;
            GateWord word{codings_[id.index], {}};
            const std::vector<Gate> firsts = bits_of(first, word.coding);
            for (std::size_t place = 0; place < firsts.size(); ++place) {
                const std::string name = bit_name(variable, place);
                if (!has_latches(variable)) {
                    word.bits.push_back(after_first(add_input(name), firsts[place]));
                    continue;
                }
                const bool constant = firsts[place].is_constant(), starts = !firsts[place].is_false();
                const Gate latch = add_latch((constant && starts ? "!" : "") + name);
                latches_of_.push_back({id, circuit().latches.size() - 1, constant && starts});
                word.bits.push_back(!constant ? after_first(latch, firsts[place]) : starts ? ~latch : latch);
            }
            words_[id.index] = std::move(word);
        }
    }

    // -- steps -------------------------------------------------------------------------------------------------------

    void add_constraints() {
        Gate kept =
            first_kept_.is_constant() && !first_kept_.is_false() ? first_kept_ : after_first(yes(), first_kept_);
        Gate ranges = yes();
        for (const Id<Expr> term : flat_.invariants) kept = kept & truth(now_(term));
        for (const Id<Variable> id : flat_.variables.ids()) {
            const Gate fits = is_of_type(term_of(words_[id.index]), flat_.variables[id].type);
            if (!has_latches(flat_.variables[id])) kept = kept & fits;
            ranges = ranges & fits;
        }
        Gate offered = kept;
        for (const Id<Expr> term : flat_.transitions) offered = offered & truth(now_(term));
        broken_ = add_latch("broken");
        circuit().broken = broken_.literal;
        circuit().latches.back().next = (broken_ | ~offered).literal;
        possible_ = kept & ~broken_;
        stepping_ = offered & ~broken_;
        circuit().possible = possible_.literal;
        circuit().in_range = ranges.literal;
    }

    void add_next_values() {
        for (const Id<Variable> id : flat_.variables.ids()) {
            const Variable& variable = flat_.variables[id];
            if (!has_latches(variable)) continue;
            const Term& next = now_(*variable.next);
            const Gate leak = stepping_ & ~is_of_type(next, variable.type);
            if (!leak.is_false()) circuit().leaks.push_back({id, leak.literal});
            nexts_.push_back(bits_of(next, codings_[id.index]));
            std::size_t place = 0;
            for (const LatchOf& latch : latches_of_)
                if (latch.variable == id) {
                    const Gate& bit = nexts_.back()[place++];
                    circuit().latches[latch.latch].next = (latch.inverted ? ~bit : bit).literal;
                }
        }
        for (Circuit::Latch& latch : circuit().latches)
            if (latch.node == node_of(started_.literal)) latch.next = Gates::yes;
    }

    // -- properties --------------------------------------------------------------------------------------------------

    static Gate yes() { return Gate::constant(true); }

    void add_queries() {
        if (system_.settled.valid()) {
            settled_ = now_(flattened(system_, flat_, system_.settled));
            circuit().settled = (possible_ & truth(settled_)).literal;
        }
        for (const Id<Property> id : system_.properties.ids()) add_query(id);
    }

    void add_query(Id<Property> id) {
        const Property& property = system_.properties[id];
        std::vector<Term> operands;
        for (const Id<Expr> operand : property.operands) operands.push_back(now_(flattened(system_, flat_, operand)));
        Gate settled = yes(), undefined;
        if (property.at_stable) {
            settled = settled_.bits.front();
            undefined = settled_.undefined;
        }
        for (const Term& operand : operands) undefined = undefined | (settled & operand.undefined);
        Circuit::Target target{id, Gates::no, {}, (possible_ & undefined).literal};
        switch (property.pattern) {
        case Pattern::Always: target.bad = (possible_ & settled & ~operands[0].bits[0]).literal; break;
        case Pattern::Never:
        case Pattern::Reachable: target.bad = (possible_ & settled & operands[0].bits[0]).literal; break;
        case Pattern::ExactlyOneOf: target.bad = (possible_ & settled & ~exactly_one(operands)).literal; break;
        case Pattern::Inevitable: target.justice = never_again(operands[0].bits[0] & settled, {}); break;
        case Pattern::LeadsTo:
            target.justice = never_again(operands[1].bits[0] & settled, operands[0].bits[0] & settled);
            break;
        case Pattern::AlwaysPossible:
            return omit(id, "`always possible` is CTL (AG EF), which this format does not support");
        case Pattern::RawCtl: return omit(id, "CTL formulas are not supported by this format");
        case Pattern::RawLtl: return omit(id, "LTL formulas of NuSMV are not translated");
        case Pattern::Watched: return omit(id, "the observer of this property is not part of this model");
        case Pattern::RawUppaal: return omit(id, "UPPAAL formulas require UPPAAL");
        case Pattern::NoDeadlock:
        case Pattern::NoTimelock: return omit(id, "not applicable to an untimed model");
        case Pattern::ReachableAllSteps: return omit(id, "each step is checked separately");
        }
        circuit().targets.push_back(std::move(target));
    }

    void omit(Id<Property> id, std::string reason) { result_.omitted.push_back({id, std::move(reason)}); }

    static Gate exactly_one(const std::vector<Term>& operands) {
        Gate none = yes(), one;
        for (const Term& operand : operands) {
            const Gate& here = operand.bits[0];
            one = (one & ~here) | (none & here);
            none = none & ~here;
        }
        return one;
    }

    /// Returns justice conditions for runs that contain a state with `from` (default: the first state), but no state
    /// with `goal` from then on. Such a run exists if and only if the returned conditions, which include the justice
    /// conditions of the system, can all hold infinitely often. A free input selects the state with `from`.
    std::vector<Literal> never_again(const Gate& goal, const std::optional<Gate>& from) {
        const std::string number = std::to_string(circuit().targets.size());
        Gate waits = yes();
        if (from) {
            const Gate begun = add_latch("premise observed in query " + number);
            waits = begun | (add_input("start in query " + number) & *from);
            set_next(begun, waits);
        }
        const Gate met = add_latch("goal reached in query " + number);
        const Gate met_now = met | (waits & goal);
        set_next(met, met_now);
        std::vector<Literal> justice{(waits & ~met_now & stepping_).literal};
        for (const Id<Expr> term : flat_.justice) justice.push_back(truth(now_(term)).literal);
        return justice;
    }

    void set_next(const Gate& latch, const Gate& next) {
        for (Circuit::Latch& each : circuit().latches)
            if (each.node == node_of(latch.literal)) each.next = next.literal;
    }

    struct LatchOf {
        Id<Variable> variable = {};
        std::size_t latch = 0;
        bool inverted = false;
    };

    const TransitionSystem& system_;
    FlatSystem& flat_;
    CircuitOf result_ = {};
    std::vector<Circuit::Word> codings_ = {};
    std::vector<GateWord> words_ = {};  ///< bits of each variable
    BitTerms<Gate> now_, first_;
    std::unordered_map<std::uint32_t, Term> firsts_ = {};
    Gate first_kept_ = Gate::constant(true);  ///< true if all initial values are in their ranges
    std::vector<std::vector<Gate>> nexts_ = {};
    std::vector<LatchOf> latches_of_ = {};
    Term settled_ = {};
    Gate started_ = {}, broken_ = {}, possible_ = {}, stepping_ = {};
};

}  // namespace

CircuitOf circuit_of(const TransitionSystem& system, FlatSystem& flat) { return Builder(system, flat).result(); }

}  // namespace grafverif
