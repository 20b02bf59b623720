// SPDX-License-Identifier: MIT
// ProgramRun: executes a Program directly on its memory cells, one scan at a time. This implementation of the semantics
// of programs does not use the equations (derive/program). Before a run of a program is displayed, ProgramRun replays
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ir/program/program.hpp"

namespace grafverif {

/// The statements of one scan, in the order of their execution, with the values that they computed.
struct ScanLog {
    template <class T>
    struct Evaluation {
        Id<T> id = {};
        /// First cell of the executing instance; for a function, a cell after the cells of the layout.
        std::size_t frame = 0;
        std::int64_t value = 0;
    };
    /// Assignments have the assigned value; FOR has the value of its variable at the beginning of each iteration;
    /// calls, EXIT and RETURN have the value 1.
    std::vector<Evaluation<Program::Statement>> statements = {};
    /// The variables that were read, the conditions of branches and loops, and the selectors of CASE.
    std::vector<Evaluation<Program::Node>> nodes = {};
};

class ProgramRun {
public:
    /// `program` must outlive the object. Requires that all loops of the program terminate (see derive/program:
    /// scan_of).
    explicit ProgramRun(const Program& program);

    /// Executes one scan. `inputs` contains a value for each cell that is an input, in order. `elapsed_ms` is the time
    /// since the previous scan. If `log` is not null, the executed statements are added to `log`.
    void scan(std::span<const std::int64_t> inputs, std::int64_t elapsed_ms, ScanLog* log = nullptr);

    const ProgramLayout& layout() const { return layout_; }
    /// Returns the values of the cells of the layout.
    std::span<const std::int64_t> cells() const { return {memory_.data(), layout_.cells.size()}; }
    struct Fault {
        Span where = {};
        ProgramFault kind = ProgramFault::DivisionByZero;
    };
    /// Returns the fault that ended the run, or nothing if no fault has occurred. After a fault, the last scan is
    /// incomplete.
    const std::optional<Fault>& fault() const { return fault_; }
    /// True if a result in the last scan was outside the range of its type and was wrapped around.
    bool overflowed() const { return overflowed_; }
    /// Returns the value of an expression over the variables of `main`.
    std::int64_t value(Id<Program::Node> node) { return evaluate(node, layout_.main); }

private:
    enum class Flow { Next, Exit, Return };

    std::int64_t evaluate(Id<Program::Node> id, std::size_t frame);
    std::int64_t decision(Id<Program::Node> id, std::size_t frame);
    void note(Id<Program::Statement> statement, std::size_t frame, std::int64_t value);
    std::int64_t calculated(const Program::Node& node, std::int64_t left, std::int64_t right);
    std::int64_t in_range(const Program::Node& node, std::int64_t value);
    std::int64_t call(const Program::Node& node, std::size_t frame);
    Flow execute(const Program::Body& body, std::size_t frame);
    Flow execute(Id<Program::Statement> id, std::size_t frame);
    Flow loop(Id<Program::Statement> id, std::size_t frame);
    const Program::Arm* chosen(const Program::Statement& statement, std::size_t frame);
    void invoke(Id<Program::Unit> unit, std::size_t frame);
    std::size_t address(const Program::Place& place, std::size_t frame, Span origin);
    std::int64_t& cell(const Program::Place& place, std::size_t frame, Span origin) {
        return memory_[address(place, frame, origin)];
    }
    std::int64_t bitwise(const Program::Node& node, const std::vector<std::int64_t>& values) const;
    void fail(Span where, ProgramFault kind) {
        if (!fault_) fault_ = {where, kind};
    }

    const Program* program_;
    ProgramLayout layout_;
    std::vector<std::int64_t> memory_ = {};  ///< the cells, followed by the frames of active functions
    std::optional<Fault> fault_ = {};
    bool overflowed_ = false;
    ScanLog* log_ = nullptr;  ///< set during a scan
};

}  // namespace grafverif
