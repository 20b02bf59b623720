// SPDX-License-Identifier: MIT
// ProgramRun: executes a Program literally, scan by scan, on its memory cells. It is an implementation of the semantics
// that does not depend on the equations. It replays every run before the run is displayed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ir/program/program.hpp"

namespace grafverif {

class ProgramRun {
public:
    /// `program` must outlive the object. Its loops must terminate (see derive/program: scan_of).
    explicit ProgramRun(const Program& program);

    /// Executes one scan. `inputs` contains a value for each cell that is an input, in order. `elapsed_ms` is the time
    /// since the previous scan.
    void scan(std::span<const std::int64_t> inputs, std::int64_t elapsed_ms);

    const ProgramLayout& layout() const { return layout_; }
    /// Returns the values of the cells of the layout.
    std::span<const std::int64_t> cells() const { return {memory_.data(), layout_.cells.size()}; }
    /// Returns the position of the division by zero that ended the run. Its last scan is incomplete.
    const std::optional<Span>& fault() const { return fault_; }
    /// True if a result left the range of its type in the last scan and was wrapped around.
    bool overflowed() const { return overflowed_; }
    /// Returns the value of an expression over the variables of `main`.
    std::int64_t value(Id<Program::Node> node) { return evaluate(node, layout_.main); }

private:
    enum class Flow { Next, Exit, Return };

    std::int64_t evaluate(Id<Program::Node> id, std::size_t frame);
    std::int64_t calculated(const Program::Node& node, std::int64_t left, std::int64_t right);
    std::int64_t in_range(const Program::Node& node, std::int64_t value);
    std::int64_t call(const Program::Node& node, std::size_t frame);
    Flow execute(const Program::Body& body, std::size_t frame);
    Flow execute(const Program::Statement& statement, std::size_t frame);
    Flow loop(const Program::Statement& statement, std::size_t frame);
    const Program::Arm* chosen(const Program::Statement& statement, std::size_t frame);
    void invoke(Id<Program::Unit> unit, std::size_t frame);
    std::int64_t& cell(Program::Place place, std::size_t frame) {
        return memory_[place.global ? place.offset : frame + place.offset];
    }

    const Program* program_;
    ProgramLayout layout_;
    std::vector<std::int64_t> memory_ = {};  ///< the cells, followed by the frames of active functions
    std::optional<Span> fault_ = {};
    bool overflowed_ = false;
};

}  // namespace grafverif
