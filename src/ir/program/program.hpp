// SPDX-License-Identifier: MIT
// Program: a PLC program of IEC 61131-3 with resolved names and checked types, as statements over memory cells.
//
// Semantics of one scan, which `run/program` executes literally and `derive/program` as equations:
//   - the inputs take new values, the elapsed times of timers advance, and the body of `main` is executed once;
//   - statements execute in order; function blocks and functions execute at each call; a function block keeps its cells
//     between calls; the cells of a function and of the section VAR_TEMP have their initial values at the beginning of
//     each call;
//   - integers wrap around within the range of their type; comparisons, quotients and remainders use the operands as
//     mathematical integers; a division by zero is a run-time fault, after which the behaviour of the program is
//     undefined;
//   - AND and OR evaluate all operands.
//
// Every unit has a frame of cells. The frame of an instance of a function block is part of the frame of its owner.
// Therefore the cells of the program are those of `globals` followed by those of `main`.
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
        std::vector<std::string> values = {};  ///< names of the values of an enumeration, starting at 0
        Id<Unit> unit = {};                    ///< unit of a function block type
        bool operator==(const Type&) const = default;
    };

    /// A cell, addressed relative to the frame of the unit or of the globals.
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
        Xor,  // Boolean operators with any number of operands
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
        Modulo,  // arithmetic; quotients are truncated towards zero
        Absolute,
        Minimum,
        Maximum,  // operators with any number of operands
        Limit,    // operands: minimum, value, maximum
        Select,   // operands: condition, value if false, value if true
        Convert,  // wraps a number to the range of `type`; a Boolean is 0 or 1
        IsNonzero,
        Call,  // call of a function, with one operand for each input
    };
    struct Node {
        Op op = Op::Constant;
        Id<Type> type = {};
        std::int64_t value = 0;  ///< value of a constant
        Place place = {};        ///< cell that is read
        Id<Unit> unit = {};      ///< called unit
        std::vector<Id<Node>> operands = {};
        Span origin = {};
        bool operator==(const Node&) const = default;
    };

    using Body = std::vector<Id<Statement>>;
    /// One branch of IF or CASE. A branch without condition and labels is ELSE.
    struct Arm {
        Id<Node> condition = {};
        std::vector<std::pair<std::int64_t, std::int64_t>> labels = {};
        Body body = {};
        bool operator==(const Arm&) const = default;
    };
    struct Statement {
        enum class Kind : std::uint8_t {
            Assign,
            Invoke,  // calls the function block `unit` at `place`
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
        Id<Type> type = {};     ///< type of the cell
        Id<Node> value = {};    ///< assigned value; selector; condition of a loop; first value of FOR
        Id<Node> last = {};     ///< last value of FOR, evaluated once
        std::int64_t step = 1;  ///< increment of FOR
        Id<Unit> unit = {};
        std::vector<Arm> arms = {};  ///< branches; the body of a loop is the only one
        Span origin = {};
        bool operator==(const Statement&) const = default;
    };

    struct Variable {
        enum class Section : std::uint8_t { Local, Input, Output, Temporary };
        std::string name = {};
        Section section = Section::Local;
        Id<Type> type = {};
        std::uint32_t offset = 0;
        std::int64_t initial = 0;  ///< initial value of the cell; unused for a function block
        bool constant = false;
        bool input = false;        ///< true for a free input of the program: VAR_INPUT of the program, or `AT %I`
        bool output = false;       ///< true for VAR_OUTPUT of the program, or `AT %Q`
        std::int64_t longest = 0;  ///< for a timer: the maximum preset time in milliseconds
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };
    struct Unit {
        enum class Kind : std::uint8_t { Program, FunctionBlock, Function, Globals };
        Kind kind = Kind::Program;
        std::string name = {};
        std::vector<Variable> variables = {};
        std::uint32_t size = 0;  ///< size of the frame, including its instances
        Body body = {};
        std::optional<std::uint32_t> result = {};  ///< cell of the return value of a function
        std::vector<std::uint32_t> inputs = {};    ///< cells of VAR_INPUT, in order of declaration
        /// For a timer: the cell that is true while the timer is running, and the cell of the elapsed time.
        std::optional<std::uint32_t> running = {}, elapsed = {};
        Span origin = {};
        bool operator==(const Unit&) const = default;
    };

    Table<Type> types = {};
    Table<Unit> units = {};
    Table<Node> nodes = {};
    Table<Statement> statements = {};
    Id<Unit> globals = {}, main = {};
    /// Interval of the task; if empty, any time may pass between two scans.
    std::optional<std::int64_t> interval_ms = {};

    bool operator==(const Program&) const = default;
};

/// A cell of the program. Its address is the index in the cells of `globals` followed by those of `main`.
struct ProgramCell {
    std::string name = {};  ///< name such as `Motor` or `T1.Q`
    Id<Program::Type> type = {};
    std::int64_t initial = 0;
    bool input = false, output = false, temporary = false, constant = false;
    Span origin = {};
};
struct ProgramTimer {
    std::uint32_t running = 0, elapsed = 0;  ///< addresses of the two cells
    std::int64_t longest = 0;                ///< value at which the elapsed time stops
};
struct ProgramLayout {
    std::vector<ProgramCell> cells = {};
    std::vector<ProgramTimer> timers = {};
    std::uint32_t main = 0;    ///< address of the first cell of `main`
    std::int64_t longest = 0;  ///< maximum over all timers; a longer time between two scans has the same effect
};
ProgramLayout layout_of(const Program& program);

/// Returns the initial values of the cells of a frame of `unit`.
std::vector<std::int64_t> initial_frame(const Program& program, Id<Program::Unit> unit);

/// Returns `value` wrapped to the range of the type: modulo the number of values of the type.
std::int64_t wrapped(const Program::Type& type, std::int64_t value);

/// Returns a value as written in the source: `TRUE`, `-3`, `T#250ms`, `Heating`.
std::string value_text(const Program::Type& type, std::int64_t value);

}  // namespace grafverif
