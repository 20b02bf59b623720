// SPDX-License-Identifier: MIT
// SymbolicExecution: executes statements on memory cells that contain terms. A journal records all writes. After the
// first branch of a statement has been executed, its writes are undone, and the second branch is executed. After both
// branches, the value of each cell that a branch has written is a conditional term.
#pragma once

#include <functional>
#include <vector>

#include "derive/program/scan.hpp"

namespace grafverif {

class SymbolicExecution {
public:
    SymbolicExecution(const Program& program, const ProgramLayout& layout, Exprs& exprs, Diagnostics& diagnostics);

    /// Returns the terms of the memory cells. The last cells do not belong to variables of the program, but are used
    /// internally by the symbolic execution.
    std::vector<Id<Expr>>& memory() { return memory_; }
    void run_main();
    Id<Expr> value(Id<Program::Node> node, std::uint32_t frame);
    bool failed() const { return failed_; }
    /// From now on, adds the executions of statements to `executions`, which must outlive the object.
    void record(std::vector<Scan::Execution>& executions) { executions_ = &executions; }

    std::vector<Scan::Event> faults = {}, overflows = {};

private:
    using Step = std::function<void()>;
    struct Write {
        std::uint32_t cell = 0;
        Id<Expr> before = {};
    };
    struct Changed {
        std::uint32_t cell = 0;
        Id<Expr> value = {};
        bool operator<(const Changed& other) const { return cell < other.cell; }
    };

    void execute(const Program::Body& body, std::size_t from, std::uint32_t frame);
    void execute(Id<Program::Statement> id, std::uint32_t frame);
    void arms(const Program::Statement& statement, std::size_t from, Id<Expr> selector, std::uint32_t frame);
    void for_loop(const Program::Statement& statement, std::uint32_t frame);
    void loop(const Program::Statement& statement, Id<Expr> last, std::uint32_t frame);
    void iterate(const Program::Statement& statement, Id<Expr> last, std::uint32_t frame);
    void invoke(Id<Program::Unit> unit, std::uint32_t frame);
    Id<Expr> call(const Program::Node& node, std::uint32_t frame);
    Id<Expr> calculated(const Program::Node& node, const std::vector<Id<Expr>>& values);
    Id<Expr> quotient(const Program::Node& node, Id<Expr> left, Id<Expr> right);
    Id<Expr> in_range(const Program::Node& node, Id<Expr> value);
    Id<Expr> wrapped_term(const Program::Type& type, Id<Expr> value, bool once);

    void branch(Id<Expr> condition, const Step& then, const Step& otherwise);
    std::vector<Changed> undo(std::size_t mark);
    void write(std::uint32_t cell, Id<Expr> value);
    Id<Expr> alive();
    void fail(const Diagnostic& diagnostic);
    bool counts(const Program::Statement& statement);
    Id<Expr> decision(Id<Program::Node> node, std::uint32_t frame);
    void note(Scan::Execution execution, Id<Expr> condition);
    void note_read(std::uint32_t cell);
    void event(std::vector<Scan::Event>& events, Id<Expr> condition, Span origin,
               ProgramFault fault = ProgramFault::DivisionByZero);
    std::uint32_t address(const Program::Place& place, std::uint32_t frame) const {
        return place.global ? place.offset : frame + place.offset;
    }
    /// The cell of an array element, and the condition that the indices select this element.
    struct Element {
        std::uint32_t cell = 0;
        Id<Expr> condition = {};
    };
    void initial_terms(Id<Program::Type> type, std::int64_t initial, std::vector<Id<Expr>>& terms);
    std::vector<Element> elements(const Program::Place& place, std::uint32_t frame, Span origin);
    Id<Expr> read(const Program::Node& node, std::uint32_t frame);
    Id<Expr> lazy(const Program::Node& node, std::uint32_t frame);
    Id<Expr> bitwise(const Program::Node& node, const std::vector<Id<Expr>>& values);
    Id<Expr> bit(Id<Expr> value, std::int64_t place);

    const Program& program_;
    const ProgramLayout& layout_;
    Exprs& exprs_;
    Diagnostics& diagnostics_;
    std::vector<Id<Expr>> memory_ = {};
    std::vector<Write> journal_ = {};
    std::vector<Id<Expr>> path_ = {};  ///< conditions of the branches that are being executed
    std::uint32_t main_ = 0, returned_ = 0, exited_ = 0, value_ = 0;
    std::uint64_t executed_ = 0;
    const Program::Statement* loop_ = nullptr;  ///< the outermost loop that is being executed
    bool failed_ = false;
    std::vector<Scan::Execution>* executions_ = nullptr;
    std::size_t calls_ = 0;  ///< number of functions that are being executed
};

}  // namespace grafverif
