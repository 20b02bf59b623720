// SPDX-License-Identifier: MIT
// Program: a PLC program of IEC 61131-3 with resolved names and checked types, as statements over memory cells.
//
// `run/program` interprets the statements, and `derive/program` translates them to equations. Both implement the
// following semantics of a scan:
//   - At the beginning, the inputs get new values, and the elapsed times of running timers increase. Then the body of
//     `main` is executed once.
//   - Statements execute in order; function blocks and functions execute at each call. A function block keeps its cells
//     between calls. The cells of a function and of the section VAR_TEMP have their initial values at the beginning of
//     each call.
//   - Integers wrap around within the range of their type. Comparisons, quotients and remainders are computed on the
//     operands as mathematical integers.
//   - After a run-time fault, the behaviour of the program is unspecified. Run-time faults are a division by zero, an
//     index outside of its array, a duration or a value of a subrange outside of its type, the activation of an active
//     step of a Sequential Function Chart, and the execution of an action with two durations.
//   - AND and OR evaluate all operands; AND_THEN and OR_ELSE evaluate the second operand only if the first operand does
//     not determine the value.
//
// Every unit has a frame of memory cells; an action uses the frame of its owner. The frame of an instance of a function
// block is part of the frame of its owner. Therefore, the cells of the program are the cells of `globals` followed by
// the cells of `main`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/type.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct Program {
    struct Unit;
    struct Node;
    struct Statement;

    struct Type {
        enum class Kind : std::uint8_t { Boolean, Integer, Bits, Time, Enumeration, Block, Array, Unsupported };
        Kind kind = Kind::Boolean;
        std::string name = {};
        std::int64_t low = 0, high = 1;        ///< range of values; for an array: first and last index
        std::vector<std::string> values = {};  ///< for an enumeration: the names of the values 0, 1, ...
        Id<Unit> unit = {};                    ///< unit of a block or structure
        Id<Type> element = {};  ///< for an array: type of its elements; for a subrange: type of which it is a subrange
        bool operator==(const Type&) const = default;
    };

    /// The index of an array element. The cells of the element begin `stride * (value - low)` cells after the cells of
    /// the first element.
    struct Index {
        Id<Node> value = {};
        std::int64_t low = 0, high = 0;  ///< a value outside of these bounds is a run-time fault
        std::uint32_t stride = 1;
        bool operator==(const Index&) const = default;
    };
    /// The address of a cell: an offset in the frame of the unit that contains the access or, if `global`, in the frame
    /// of the globals. The frame of `main` follows the frame of the globals in memory. Therefore other units access the
    /// cells of `main` as global cells.
    struct Place {
        bool global = false;
        std::uint32_t offset = 0;
        std::vector<Index> indices = {};  ///< the indices of array elements that are not constant
        bool operator==(const Place&) const = default;
    };

    enum class Op : std::uint8_t {
        Constant,
        Read,
        Not,
        And,
        Or,
        Xor,  // Not, And, Or, Xor: Boolean or bit-string operators; And, Or and Xor have any number of operands
        AndThen,
        OrElse,  // AndThen, OrElse: two Boolean operands; the second is evaluated only if necessary
        ShiftLeft,
        ShiftRight,
        RotateLeft,
        RotateRight,  // shifts and rotations: a bit string, a constant number of places from 0 to its width
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
        Modulo,  // Negate to Modulo: arithmetic; quotients are truncated towards zero
        Absolute,
        Minimum,
        Maximum,  // Minimum, Maximum: any number of operands
        Limit,    // Limit: operands are least value, value, greatest value
        Select,   // Select: operands are condition, value if false, value if true
        Convert,  // wraps a number to the range of `type`; a Boolean operand is 0 or 1
        Narrow,   // converts a number to a subrange; a number outside of the subrange is a run-time fault
        IsNonzero,
        Call,  // call of a function, with one operand for each input
    };
    struct Node {
        Op op = Op::Constant;
        Id<Type> type = {};
        std::int64_t value = 0;  ///< for Constant: the value
        Place place = {};        ///< for Read: the cell that is read
        Id<Unit> unit = {};      ///< for Call: the called function
        std::vector<Id<Node>> operands = {};
        Span origin = {};
        bool operator==(const Node&) const = default;
    };

    using Body = std::vector<Id<Statement>>;
    /// One branch of IF or CASE. A branch without condition and labels is an ELSE branch.
    struct Arm {
        Id<Node> condition = {};
        std::vector<std::pair<std::int64_t, std::int64_t>> labels = {};
        Body body = {};
        bool operator==(const Arm&) const = default;
    };
    struct Statement {
        enum class Kind : std::uint8_t {
            Assign,
            Invoke,  // calls the function block or action `unit`, whose frame is at `place`
            If,
            Case,
            For,
            While,
            Repeat,
            Exit,
            Return,
            Check,  // causes the run-time fault ProgramFault::Chart if `value` is true
        };
        Kind kind = Kind::Return;
        Place place = {};
        Id<Type> type = {};     ///< type of the cell at `place`
        Id<Node> value = {};    ///< assigned value, selector, condition of a loop or fault, or first value of FOR
        Id<Node> last = {};     ///< last value of a FOR loop, evaluated once
        std::int64_t step = 1;  ///< step of a FOR loop
        Id<Unit> unit = {};
        std::vector<Arm> arms = {};  ///< branches of IF and CASE; for a loop, the only branch is its body
        bool generated = false;  ///< true for a rule of a Sequential Function Chart, which the source does not contain
        Span origin = {};
        bool operator==(const Statement&) const = default;
    };

    struct Variable {
        enum class Section : std::uint8_t { Local, Input, Output, InOut, Temporary };
        std::string name = {};
        Section section = Section::Local;
        Id<Type> type = {};
        std::uint32_t offset = 0;
        /// Initial value; for an array: initial value of each element; unused for a function block or a structure.
        std::int64_t initial = 0;
        bool constant = false;
        bool input = false;        ///< true for a free input of the program: VAR_INPUT of the program, or `AT %I`
        bool output = false;       ///< true for VAR_OUTPUT of the program, or `AT %Q`
        std::int64_t longest = 0;  ///< for a timer: the maximum preset time in milliseconds
        Span origin = {};
        bool initialized = false;  ///< true if the declaration states the initial value
        bool operator==(const Variable&) const = default;
    };
    /// The structure of a Sequential Function Chart, for reports, drawings and analyses. The body of a unit contains
    /// the statements of the chart. A step is denoted by the cell of its activity, relative to the frame of the unit.
    struct Sequence {
        struct Transition {
            std::string name = {};  ///< name of the transition; may be empty
            std::vector<std::uint32_t> from = {}, to = {};
            Id<Statement> test = {};  ///< executed if enabled; assigns true if the transition is cleared
            bool operator==(const Transition&) const = default;
        };
        struct Action {
            std::uint32_t step = 0;
            std::string label = {};  ///< text of the action block, such as `N Lamp` or `D T#2s Lamp`
            bool operator==(const Action&) const = default;
        };
        std::vector<std::uint32_t> initial = {};  ///< the initial steps of the chart
        std::vector<Transition> transitions = {};
        std::vector<Action> actions = {};
        bool operator==(const Sequence&) const = default;
    };
    struct Unit {
        /// The body of an action uses the frame of its owner. A structure has no body.
        enum class Kind : std::uint8_t { Program, FunctionBlock, Function, Globals, Action, Structure };
        Kind kind = Kind::Program;
        std::string name = {};
        std::vector<Variable> variables = {};
        std::uint32_t size = 0;  ///< size of the frame, including its instances
        Body body = {};
        std::optional<std::uint32_t> result = {};  ///< for a function: offset of the cell of the return value
        std::vector<std::uint32_t> inputs = {};    ///< offsets of the cells of VAR_INPUT, in order of declaration

        /// For a timer: offsets of the cell that is true while the timer is running, and of the cell that stores the
        /// elapsed time.
        std::optional<std::uint32_t> running = {}, elapsed = {};
        Id<Unit> owner = {};                   ///< for an action: the unit that owns its frame
        std::vector<Sequence> sequences = {};  ///< the charts in the bodies of the unit and of its actions
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
    /// True if a variable keeps its value when the PLC is switched off (RETAIN). Runs begin with a cold start, at which
    /// all variables have their initial values.
    bool retains = false;

    bool operator==(const Program&) const = default;
};

/// A run-time fault.
enum class ProgramFault : std::uint8_t { DivisionByZero, ArrayBounds, Range, Chart };

/// True if the reader of programs created the name, for example the name of a timer of an action. A created name
/// contains a space; a name in a source cannot contain a space.
inline bool is_generated_name(std::string_view name) { return name.find(' ') != std::string_view::npos; }

struct ProgramCell {
    std::string name = {};  ///< name such as `Motor` or `T1.Q`
    Id<Program::Type> type = {};
    std::int64_t initial = 0;
    bool input = false, output = false, temporary = false, constant = false;
    /// True for a cell that represents the activity of a step of a Sequential Function Chart, such as `Filling.X`.
    bool step = false;
    Span origin = {};
};
struct ProgramTimer {
    std::uint32_t running = 0, elapsed = 0;  ///< addresses of the cells Unit::running and Unit::elapsed of the timer
    std::int64_t longest = 0;  ///< maximum of the elapsed time in milliseconds; the elapsed time remains at this value
};
/// An instance of a function block, or `main`, whose name is empty.
struct ProgramInstance {
    std::string name = {};  ///< name such as `Line.Motor`
    Id<Program::Unit> unit = {};
    std::uint32_t frame = 0;  ///< address of the first cell of the instance
};
struct ProgramLayout {
    std::vector<ProgramCell> cells = {};
    std::vector<ProgramInstance> instances = {};
    std::vector<ProgramTimer> timers = {};
    std::uint32_t main = 0;  ///< address of the first cell of `main`

    /// Maximum of ProgramTimer::longest; a longer time between two scans has the same effect as this time.
    std::int64_t longest = 0;
};
ProgramLayout layout_of(const Program& program);

/// Returns a unique name for each cell. If several cells have the same name, `GLOBAL.` precedes the names of all of
/// them except the last.
std::vector<std::string> unique_names(const ProgramLayout& layout);
/// Returns the type of the values of a cell. The elapsed time of a timer is at most its maximum preset time.
Type type_of_cell(const Program& program, const ProgramLayout& layout, std::size_t cell);

/// Returns the number of cells of a variable of this type.
std::uint32_t size_of(const Program& program, Id<Program::Type> type);
/// Returns the initial values of the cells of a variable.
std::vector<std::int64_t> initial_cells(const Program& program, const Program::Variable& variable);
/// Returns the values of the cells in a new frame of `unit`.
std::vector<std::int64_t> initial_frame(const Program& program, Id<Program::Unit> unit);

/// Returns `value` wrapped to the range of the type: modulo the number of values of the type.
std::int64_t wrapped(const Program::Type& type, std::int64_t value);

}  // namespace grafverif
