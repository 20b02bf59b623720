// SPDX-License-Identifier: MIT
// Code of a controller: statements that compute one PLC cycle of a chart, from which Structured Text and C are printed.
//
// In every-cycle mode, a cycle samples the timers, executes one evolution, writes the outputs and updates the timers.
// With stability search, a cycle samples the timers, repeats an evolution and an update of the timers until the
// situation is stable, writes the outputs and updates the timers.
//
// Time is constant within a cycle, as in the equations: the output of a timer is sampled once, at the start of the
// cycle, and later changes only as a consequence of evolutions. A TON whose input becomes FALSE and TRUE again within
// one cycle restarts.
//
// New values are computed from old values. If an assignment would change an operand of a later assignment, the new
// value is stored in a temporary cell (N_...).
//
// The printer of a target language translates the statements one by one. A target language must provide Booleans,
// integers of 16 and 32 bits, and two timers:
//   `TON`: The output is true once the input has been true for the preset time.
//   `TOF`: The output is true while the input is true, and for the preset time after the input has become false.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif::controller {

enum class Section { Input, Output, Local, Constant };
enum class Word { Bool, Int16, Int32, Unsigned32 };

struct Timer;

struct Cell {
    Section section = Section::Local;
    std::string name = {};
    Word word = Word::Bool;
    std::int64_t initial = 0;
    bool initialized = true;  ///< false for a temporary cell, which is assigned before it is read
    std::string comment = {};
    Id<Timer> timer = {};  ///< if valid, the cell is the output of this timer, and has no declaration
};

struct Timer {
    std::string name = {};
    bool off_delay = false;  ///< true for a TOF, false for a TON
    Id<Cell> input = {};
    std::int64_t preset_ms = 0;
    Id<Cell> output = {};
};

struct Statement {
    enum class Kind {
        Comment,  ///< prints the text in the member `comment`
        Assign,   ///< assigns `value` to `target`
        Cases,    ///< target := value, where the value is a Conditional; one branch for each case of the Conditional
        Guard,    ///< assigns `value` to `target` if `condition` is true
        Stop,     ///< ends the call if `condition` is true
        Call,     ///< executes the timer `timer`
        If,       ///< begins a block, which Else or EndIf ends
        While,    ///< begins a block, which EndWhile ends
        Else,     ///< ends the block of an If, and begins the block that is executed if the condition is false
        EndIf,
        EndWhile
    };
    Kind kind = Kind::Comment;
    Id<Cell> target = {};
    Id<Expr> value = {}, condition = {};
    Id<Timer> timer = {};
    std::string comment = {};
};

struct Code {
    std::string name = {};     ///< name of the block
    std::string comment = {};  ///< comment for the user of the block; may have several lines
    Exprs exprs = {};          ///< terms whose leaves are cells
    Table<Cell> cells = {};
    Table<Timer> timers = {};
    /// Declared cells and timers, in the order of the text.
    std::vector<std::variant<Id<Cell>, Id<Timer>>> declarations = {};
    std::vector<Statement> body = {};
};

struct Options {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::uint32_t max_evolutions = 1000;  ///< maximum number of evolutions in one cycle under stability search
};

/// Returns the code, with names that are legal in `target` and differ from the names in `reserved`. Requires
/// verify(equations).empty(), and that `expressible` returns true.
Code code_of(const Equations& equations, const Options& options, Target target,
             std::span<const std::string_view> reserved = {});

/// True if code with 32-bit integers and timers can compute `equations` exactly. Otherwise, reports each division by a
/// divisor that is not constant, and each remainder of a division by -1. Also reports each value beyond 32 bits, and
/// each duration beyond 31 bits of milliseconds. A division is reported even if a previous operand excludes a zero
/// divisor, because `and` and `or` in Structured Text may evaluate all operands. `message` returns the error for a
/// construct.
bool expressible(const Equations& equations, Diagnostic (*message)(Span where, std::string_view what),
                 Diagnostics& diagnostics);

}  // namespace grafverif::controller
