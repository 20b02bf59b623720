// SPDX-License-Identifier: MIT
// Program: a PLC program of IEC 61131-3, its names resolved and its types checked, as statements over memory cells.
//
// Semantics of one scan, which `run/program` executes literally and `derive/program` as equations:
//   - the inputs take new values, the elapsed times of timers advance, and the body of `main` is executed once;
//   - statements execute in order; function blocks and functions execute at each call; a function block keeps
//     its cells between calls, a function and the section VAR_TEMP begin each call with their initial values;
//   - integers wrap around within the range of their type; a comparison, a quotient or a remainder has the value of the
//     operands as numbers; a division by zero is a run-time fault, after which nothing is stated about the program;
//   - AND and OR evaluate all operands.
//
// Every unit has a frame of cells. Instances of function blocks lie within the frame of their owner: the cells of the
// program are those of `globals` followed by those of `main`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct Program {
    struct Unit;
    struct Node;
    struct Statement;

    struct Type {
        enum class Kind : std::uint8_t { Boolean, Integer, Bits, Time, Enumeration, Block };
        Kind kind = Kind::Boolean;
        std::string name = {};
        std::int64_t low = 0, high = 1;
        std::vector<std::string> values = {};  ///< of an enumeration, from 0
        Id<Unit> unit = {};                    ///< of a block
        bool operator==(const Type&) const = default;
    };

    /// A cell, relative to the frame of the unit, or of the globals.
    struct Place {
        bool global = false;
        std::uint32_t offset = 0;
        bool operator==(const Place&) const = default;
    };

    enum class Op : std::uint8_t {
        Constant,
        Read,
        Not,
        And,
        Or,
        Xor,  // Boolean, any number of operands
        Equal,
        NotEqual,
        Less,
        LessEqual,
        Greater,
        GreaterEqual,
        Negate,
        Plus,
        Minus,
        Times,
        Divide,
        Modulo,  // truncated towards zero
        Absolute,
        Minimum,
        Maximum,  // any number of operands
        Limit,    // least value, value, greatest value
        Select,   // condition, value if false, value if true
        Convert,  // wraps a number to `type`; a Boolean is 0 or 1
        IsNonzero,
        Call,  // a function, with one operand for each input
    };
    struct Node {
        Op op = Op::Constant;
        Id<Type> type = {};
        std::int64_t value = 0;  ///< of a constant
        Place place = {};        ///< of a read
        Id<Unit> unit = {};      ///< of a call
        std::vector<Id<Node>> operands = {};
        Span origin = {};
        bool operator==(const Node&) const = default;
    };

    using Body = std::vector<Id<Statement>>;
    /// One branch of IF or CASE; without condition and labels: ELSE.
    struct Arm {
        Id<Node> condition = {};
        std::vector<std::pair<std::int64_t, std::int64_t>> labels = {};
        Body body = {};
        bool operator==(const Arm&) const = default;
    };
    struct Statement {
        enum class Kind : std::uint8_t {
            Assign,
            Invoke,  // the function block `unit` at `place`
            If,
            Case,
            For,
            While,
            Repeat,
            Exit,
            Return,
        };
        Kind kind = Kind::Return;
        Place place = {};
        Id<Type> type = {};     ///< of the cell
        Id<Node> value = {};    ///< assigned; selector; condition of a loop; first value of FOR
        Id<Node> last = {};     ///< of FOR, evaluated once
        std::int64_t step = 1;  ///< of FOR
        Id<Unit> unit = {};
        std::vector<Arm> arms = {};  ///< body of a loop: one arm
        Span origin = {};
        bool operator==(const Statement&) const = default;
    };

    struct Variable {
        enum class Section : std::uint8_t { Local, Input, Output, Temporary };
        std::string name = {};
        Section section = Section::Local;
        Id<Type> type = {};
        std::uint32_t offset = 0;
        std::int64_t initial = 0;  ///< not of a block
        bool constant = false;
        bool input = false;        ///< a free input of the program: VAR_INPUT of the program, or `AT %I`
        bool output = false;       ///< VAR_OUTPUT of the program, or `AT %Q`
        std::int64_t longest = 0;  ///< of a timer: the greatest preset time in milliseconds
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };
    struct Unit {
        enum class Kind : std::uint8_t { Program, FunctionBlock, Function, Globals };
        Kind kind = Kind::Program;
        std::string name = {};
        std::vector<Variable> variables = {};
        std::uint32_t size = 0;  ///< of the frame, with its instances
        Body body = {};
        std::optional<std::uint32_t> result = {};  ///< of a function: the cell of its value
        std::vector<std::uint32_t> inputs = {};    ///< cells of VAR_INPUT, in order
        /// In a timer: a cell that is true while time counts, and the cell of the elapsed time.
        std::optional<std::uint32_t> running = {}, elapsed = {};
        Span origin = {};
        bool operator==(const Unit&) const = default;
    };

    Table<Type> types = {};
    Table<Unit> units = {};
    Table<Node> nodes = {};
    Table<Statement> statements = {};
    Id<Unit> globals = {}, main = {};
    std::optional<std::int64_t> interval_ms = {};  ///< of the task; empty: any time may pass between two scans

    bool operator==(const Program&) const = default;
};

/// A cell of the program, by its address: those of `globals`, then those of `main`.
struct ProgramCell {
    std::string name = {};  ///< `Motor`, `T1.Q`
    Id<Program::Type> type = {};
    std::int64_t initial = 0;
    bool input = false, output = false, temporary = false, constant = false;
    Span origin = {};
};
struct ProgramTimer {
    std::uint32_t running = 0, elapsed = 0;  ///< addresses
    std::int64_t longest = 0;                ///< the elapsed time stops there
};
struct ProgramLayout {
    std::vector<ProgramCell> cells = {};
    std::vector<ProgramTimer> timers = {};
    std::uint32_t main = 0;    ///< address of the frame of `main`
    std::int64_t longest = 0;  ///< of all timers; a longer time between two scans has the same effect
};
ProgramLayout layout_of(const Program& program);

/// The value of the cells of a new frame of `unit`.
std::vector<std::int64_t> initial_frame(const Program& program, Id<Program::Unit> unit);

/// `value` within the range of the type, modulo the number of its values.
std::int64_t wrapped(const Program::Type& type, std::int64_t value);

/// A value as the source spells it: `TRUE`, `-3`, `T#250ms`, `Heating`.
std::string value_text(const Program::Type& type, std::int64_t value);

}  // namespace grafverif
