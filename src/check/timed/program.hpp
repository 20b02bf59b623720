// SPDX-License-Identifier: MIT
// Program: guards, assignments and properties compiled once to a flat branching program over packed states.
//
// Every instruction names its successors, so code has no order and is generated from its end backwards: compiling a
// Boolean term takes the instructions for true and for false, and returns its first instruction. A conjunction of
// Booleans of one word is one Test; a comparison of a variable with a constant is one Within. Other arithmetic uses
// registers. A term whose tree is far larger than its shared form is evaluated in that form, each subterm once, in
// registers (`eager`); both forms have the same value, including undefined ones.
#pragma once

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "check/timed/layout.hpp"
#include "grafverif/ir/expr.hpp"
#include "ir/network_inputs.hpp"

namespace grafverif::timed {

enum class Opcode : std::uint8_t {
    Yes,
    No,      // the end
    Test,    // (word & mask) == value ?
    Within,  // low <= raw field <= low + span ?
    Load,
    Constant,  // register `to` := field, constant
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Negate,  // register `to` := a op b; `undefined` if it has no value
    Equal,
    Less,
    LessEqual,  // registers a, b ?
    Truth,      // register a not 0 ?
    EagerNot,
    EagerAnd,
    EagerOr,
    EagerEqual,
    EagerUnequal,
    EagerLess,
    EagerLessEqual,
    EagerChoice,  // into register `to`
    Patch,        // word := (word & mask) | value
    Store,        // field := register a if in range; otherwise a fault
    Cap,          // raw field := the minimum of it and `value`
    Choose,       // tests if the chosen valuation is one of those in `value`; see Choices
};

struct Instruction {
    Word mask = 0;          ///< Load, Within, Store, Cap: of the field, at its position
    Word value = 0;         ///< Test, Patch: bits; Load, Constant, Store: the least value; Within: low; Cap: the cap
    Word span = 0;          ///< Within, Store: values above the least
    std::uint32_t yes = 0;  ///< the next instruction
    std::uint32_t no = 0;
    std::uint32_t to = 0, a = 0, b = 0, c = 0;  ///< registers; Store: `to` is the variable
    std::uint16_t word = 0;
    std::uint8_t shift = 0;
    Opcode op = Opcode::Yes;
};

/// The test that the bits of `field` are a number in low..high.
Instruction field_within(const Field& field, std::int64_t low, std::int64_t high, std::uint32_t yes, std::uint32_t no);

/// The content of a register for an undefined term. It is not a value of any term of bounded variables.
inline constexpr std::int64_t undefined = std::numeric_limits<std::int64_t>::min();

/// Registers below the first one, for code that chooses input valuations as it reads them (ir/network_inputs.hpp). The
/// set of valuations that are possible for a choice is a bit mask; `Choose` splits a set for which its condition is
/// neither constantly true nor false. `path` has one bit per split, `depth` counts the splits of a run.
struct Choices {
    static constexpr std::uint32_t depth = 1, path = 2, path_text = 4, most_splits = 64 * path_text;
    static constexpr std::uint32_t set(std::size_t choice) {
        return path + path_text + static_cast<std::uint32_t>(choice);
    }
};

struct Program {
    static constexpr std::uint32_t yes = 0, no = 1;  ///< the two final instructions come first
    std::vector<Instruction> code = {Instruction{}, Instruction{.op = Opcode::No}};
    std::size_t registers = 1;
    std::size_t below = 0;  ///< registers below the first one
};

enum class End { Yes, No, OutOfRange, NoValue };

/// Runs from `start`; `place` is the final instruction, or the one that caused a fault.
struct ExecutionResult {
    End end = End::No;
    std::uint32_t place = 0;
};
ExecutionResult run(const Program& program, std::uint32_t start, Word* words, std::int64_t* registers);
/// Runs a condition, which writes no word.
inline ExecutionResult test(const Program& program, std::uint32_t start, const Word* words, std::int64_t* registers) {
    return run(program, start, const_cast<Word*>(words), registers);
}

/// Writes code for terms of `network` into `program`.
class Compiler {
public:
    Compiler(const Network& network, const Layout& layout, Program& program);

    /// A Boolean term: continues at `yes` or `no`.
    std::uint32_t condition(Id<Expr> term, std::uint32_t yes, std::uint32_t no);
    /// `target := value`, then continues at `next`.
    std::uint32_t assignment(Id<Network::Variable> target, Id<Expr> value, std::uint32_t next);
    std::uint32_t emit(const Instruction& instruction);

    /// A test of bits that is a complete term, or part of a conjunction: (word & mask) == value.
    struct Literal {
        std::uint16_t word = 0;
        Word mask = 0, value = 0;
    };
    /// The term as one such test, if it is one.
    std::optional<Literal> literal(Id<Expr> term) const;
    /// From here on, code that reads the variables of `choice` chooses their valuation; `number`: see Choices::set.
    void choose(const InputChoice& choice, std::size_t number);
    /// From here on, no variable is chosen.
    void choose_nothing() { chosen_.clear(); }
    bool fallible(Id<Expr> term) const { return facts_[term.index].fallible; }

private:
    /// Properties of a term that are independent of its context.
    struct Facts {
        std::uint32_t tree = 1;    // number of nodes of its tree without sharing; saturates
        bool fallible = false;     // may be undefined
        double low = 0, high = 1;  // bounds of the value
    };
    Facts facts_of(Id<Expr> term) const;
    std::uint32_t boolean(Id<Expr> term, std::uint32_t yes, std::uint32_t no, std::uint32_t base);
    std::uint32_t junction(Id<Expr> term, std::uint32_t yes, std::uint32_t no, std::uint32_t base);
    std::uint32_t comparison(Id<Expr> term, std::uint32_t yes, std::uint32_t no, std::uint32_t base);
    std::uint32_t integer(Id<Expr> term, std::uint32_t to, std::uint32_t next);
    std::uint32_t eager(Id<Expr> term, std::uint32_t next, std::uint32_t& result);
    std::uint32_t test(const Literal& literal, std::uint32_t yes, std::uint32_t no);
    std::uint32_t load(Id<Network::Variable> variable, std::uint32_t to, std::uint32_t next);
    bool is_chosen(Id<Network::Variable> variable) const { return chosen_.contains(variable.index); }
    std::uint32_t chosen_within(Id<Network::Variable> variable, std::int64_t low, std::int64_t high, std::uint32_t yes,
                                std::uint32_t no);
    void reserve(std::uint32_t reg);

    const Network& network_;
    const Layout& layout_;
    Program& program_;
    std::vector<Facts> facts_ = {};
    struct Chosen {
        std::uint32_t set = 0;             // its register
        std::vector<std::int64_t> values;  // per valuation
    };
    std::unordered_map<std::uint32_t, Chosen> chosen_ = {};  // by variable
};

}  // namespace grafverif::timed
