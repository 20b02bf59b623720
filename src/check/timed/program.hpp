// SPDX-License-Identifier: MIT
// Program: code for guards, assignments and properties. Each term is compiled once to instructions that read and write
// packed states.
//
// Every instruction contains the indices of the next instructions. Therefore, instructions can be stored in any order,
// and the compiler generates the code of a term backwards, from the last instruction to the first. For a Boolean term,
// the compiler receives the instruction that follows if the term is true and the instruction that follows if it is
// false. The compiler returns the first instruction of the term. A conjunction of Boolean variables in one word is
// compiled to one Test instruction, and a comparison of a variable with a constant to one Within instruction. All other
// arithmetic uses registers. If a term has many shared subterms, so that its tree is far larger than its graph, it is
// compiled to code without branches (`eager`). This code evaluates each shared subterm once and stores its value in a
// register. Code with and without branches computes the same values, including undefined values.
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
    No,      // Yes, No: end the execution with this result
    Test,    // tests (word & mask) == value
    Within,  // tests low <= raw field <= low + span
    Load,
    Constant,  // Load, Constant: load a field or the constant `value` into register `to`
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Negate,  // Add to Negate: register `to` := a op b (Negate: -a); `undefined` if the operation has no value
    Equal,
    Less,
    LessEqual,  // Equal to LessEqual: compare registers a and b
    Truth,      // tests if register a is not 0
    EagerNot,
    EagerAnd,
    EagerOr,
    EagerEqual,
    EagerUnequal,
    EagerLess,
    EagerLessEqual,
    EagerChoice,  // EagerNot to EagerChoice: operations with the result in register `to`
    Patch,        // word := (word & mask) | value
    Store,        // field := register a; a value outside the range of the field causes a model error
    Cap,          // raw field := minimum of the raw field and `value`
    Choose,       // tests if the chosen valuation belongs to the set `value`; may fork (see Choices)
};

struct Instruction {
    Word mask = 0;          ///< Load, Within, Store, Cap: mask of the field; Test, Patch: see Opcode
    Word value = 0;         ///< Test, Patch: bits; Load, Store: lower bound; Within: low; others: see Opcode
    Word span = 0;          ///< Within, Store: number of values above the lower bound
    std::uint32_t yes = 0;  ///< index of the next instruction; for a test: if the result is true
    std::uint32_t no = 0;   ///< for a test: index of the next instruction if the result is false
    std::uint32_t to = 0, a = 0, b = 0, c = 0;  ///< registers; `to` of Store: index of the variable
    std::uint16_t word = 0;
    std::uint8_t shift = 0;
    Opcode op = Opcode::Yes;
};

/// Returns an instruction that tests whether the value of `field` is in low..high.
Instruction field_within(const Field& field, std::int64_t low, std::int64_t high, std::uint32_t yes, std::uint32_t no);

/// Register value that represents an undefined term. No term with a defined value over variables with bounded ranges
/// has this value.
inline constexpr std::int64_t undefined = std::numeric_limits<std::int64_t>::min();

/// Special registers, which precede the general registers. Code that chooses the valuations of inputs when it reads
/// these inputs (ir/network_inputs.hpp) uses the special registers. A bit mask represents the set of valuations that
/// are possible for a choice. If the condition of `Choose` is true for some valuations of this set and false for
/// others, the set is split and the execution forks.
struct Choices {
    static constexpr std::uint32_t most_splits = 256;  ///< maximum number of times that one execution splits a set
    static constexpr std::uint32_t set(std::size_t choice) { return 1 + static_cast<std::uint32_t>(choice); }
};

/// A stack of suspended executions. Each of them has forked at a Choose instruction and continues with the valuations
/// for which the condition of this instruction is false. The execution that forked last continues first.
class Forks {
public:
    /// Removes all executions. `below` and `registers` are the numbers of special and general registers.
    void begin(std::size_t words, std::size_t below, std::size_t registers);
    bool empty() const { return places_.empty(); }
    /// Adds an execution that continues at `place`, where the special register `set` has the value `rest`.
    void push(std::uint32_t place, const Word* words, const std::int64_t* registers, std::uint32_t set, Word rest);
    /// Removes the execution that was added last. Copies its state to `words` and `registers`, and returns the index of
    /// its next instruction.
    std::uint32_t pop(Word* words, std::int64_t* registers);

private:
    std::size_t size_ = 0, below_ = 0, registers_ = 0;
    std::vector<std::uint32_t> places_ = {};
    std::vector<Word> words_ = {};
    std::vector<std::int64_t> values_ = {};
};

struct Program {
    static constexpr std::uint32_t yes = 0, no = 1;  ///< the two final instructions
    std::vector<Instruction> code = {Instruction{}, Instruction{.op = Opcode::No}};
    std::size_t registers = 1;
    std::size_t below = 0;  ///< number of special registers (see Choices), which precede the general registers
};

enum class End { Yes, No, OutOfRange, NoValue };

/// Result of an execution. `place` is the index of the last executed instruction, which ended the execution or caused a
/// model error.
struct ExecutionResult {
    End end = End::No;
    std::uint32_t place = 0;
};
/// Executes code, beginning with the instruction `start`. If the execution forks, the suspended execution is added to
/// `forks`. `forks` may be null if the code contains no Choose instruction.
ExecutionResult run(const Program& program, std::uint32_t start, Word* words, std::int64_t* registers,
                    Forks* forks = nullptr);
/// Executes the code of a condition. Requires that the code does not write any word of the state.
inline ExecutionResult test(const Program& program, std::uint32_t start, const Word* words, std::int64_t* registers) {
    return run(program, start, const_cast<Word*>(words), registers);
}

/// Generates code for terms of `network` in `program`.
class Compiler {
public:
    Compiler(const Network& network, const Layout& layout, Program& program);

    /// Compiles a Boolean term and returns the index of its first instruction. If the term is true, the execution
    /// continues at `yes`, otherwise at `no`.
    std::uint32_t condition(Id<Expr> term, std::uint32_t yes, std::uint32_t no);
    /// Compiles `target := value` and returns the index of the first instruction. After the assignment, the execution
    /// continues at `next`.
    std::uint32_t assignment(Id<Network::Variable> target, Id<Expr> value, std::uint32_t next);
    std::uint32_t emit(const Instruction& instruction);

    /// A test (word & mask) == value, to which a Boolean term can be compiled.
    struct Literal {
        std::uint16_t word = 0;
        Word mask = 0, value = 0;
    };
    /// Returns a single test of bits that represents the term, or nullopt if this is impossible.
    std::optional<Literal> literal(Id<Expr> term) const;
    /// Affects the code that is generated later: when this code reads a variable of `choice`, it chooses a valuation of
    /// all variables of `choice`. `number` is the argument of Choices::set for this choice.
    void choose(const InputChoice& choice, std::size_t number);
    /// Ends the effect of `choose`: code that is generated later does not choose valuations.
    void choose_nothing() { chosen_.clear(); }
    bool fallible(Id<Expr> term) const { return facts_[term.index].fallible; }

private:
    /// Properties of a term that do not depend on its context.
    struct Facts {
        std::uint32_t tree = 1;    // number of nodes of the term as a tree; saturates at the maximum value
        bool fallible = false;     // true if the term may be undefined
        double low = 0, high = 1;  // bounds of the value of the term
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
        std::uint32_t set = 0;             // index of the register that contains the set of possible valuations
        std::vector<std::int64_t> values;  // value of the variable in each valuation
    };
    std::unordered_map<std::uint32_t, Chosen> chosen_ = {};  // maps the index of each variable of an input choice to
                                                             // its data
};

}  // namespace grafverif::timed
