// SPDX-License-Identifier: MIT
// Executes statements symbolically. The flags for RETURN and EXIT (`returned_`, `exited_`) are memory cells, so that
// their values are merged after branches in the same way as other values. After a statement that may have set one of
// these cells, the remaining statements of the block are executed as a branch.
#include "derive/program/execution.hpp"

#include <algorithm>

#include "ir/literal.hpp"
#include "support/messages_program.hpp"

namespace grafverif {

namespace {

using Kind = Program::Statement::Kind;

constexpr std::uint64_t most_statements = 2'000'000;  ///< maximum number of statements executed in one scan
constexpr std::size_t most_branches = 1000;  ///< maximum number of nested branches; each branch is a recursive call
constexpr std::uint64_t most_iterations = 100'000;  ///< maximum number of iterations of a loop with constant bounds
constexpr std::size_t most_terms = 20'000'000;

}  // namespace

SymbolicExecution::SymbolicExecution(const Program& program, const ProgramLayout& layout, Exprs& exprs,
                                     Diagnostics& diagnostics)
    : program_(program), layout_(layout), exprs_(exprs), diagnostics_(diagnostics), main_(layout.main) {
    memory_.resize(layout.cells.size());
    returned_ = static_cast<std::uint32_t>(memory_.size());
    memory_.push_back(exprs.constant(false));
    exited_ = static_cast<std::uint32_t>(memory_.size());
    memory_.push_back(exprs.constant(false));
    value_ = static_cast<std::uint32_t>(memory_.size());
    memory_.push_back(exprs.constant(false));
}

void SymbolicExecution::run_main() { invoke(program_.main, main_); }

void SymbolicExecution::fail(const Diagnostic& diagnostic) {
    if (!failed_) diagnostics_.add(diagnostic);
    failed_ = true;
}

/// Counts an executed statement. Returns false if the execution must end.
bool SymbolicExecution::counts(const Program::Statement& statement) {
    if (failed_) return false;
    if (++executed_ > most_statements)
        fail(messages::program_too_large(statement.origin, "statements per scan", most_statements));
    if (exprs_.size() > most_terms)
        fail(messages::program_too_large(statement.origin, "operations per scan", most_terms));
    if (path_.size() > most_branches && loop_ != nullptr) fail(messages::unbounded_loop(loop_->origin, most_branches));
    if (path_.size() > most_branches)
        fail(messages::program_too_large(statement.origin, "nested conditions", most_branches));
    return !failed_;
}

// -- branches ---------------------------------------------------------------------------------------------------------

void SymbolicExecution::write(std::uint32_t cell, Id<Expr> value) {
    if (memory_[cell] == value) return;
    journal_.push_back({cell, memory_[cell]});
    memory_[cell] = value;
}

/// Restores the values that cells had at position `mark` of the journal, and returns the discarded values. Skips the
/// cells of functions that have returned, because these cells no longer exist.
std::vector<SymbolicExecution::Changed> SymbolicExecution::undo(std::size_t mark) {
    std::vector<Changed> changed;
    for (std::size_t i = mark; i < journal_.size(); ++i)
        if (journal_[i].cell < memory_.size()) changed.push_back({journal_[i].cell, memory_[journal_[i].cell]});
    while (journal_.size() > mark) {
        if (journal_.back().cell < memory_.size()) memory_[journal_.back().cell] = journal_.back().before;
        journal_.pop_back();
    }
    std::ranges::sort(changed, {}, &Changed::cell);
    const auto rest = std::ranges::unique(changed, {}, &Changed::cell);
    changed.erase(rest.begin(), rest.end());
    return changed;
}

void SymbolicExecution::branch(Id<Expr> condition, const Step& then, const Step& otherwise) {
    if (is_true(exprs_, condition)) return then();
    if (is_false(exprs_, condition)) return otherwise();
    const std::size_t mark = journal_.size();
    path_.push_back(condition);
    then();
    const std::vector<Changed> yes = undo(mark);
    path_.back() = exprs_.negation(condition);
    otherwise();
    const std::vector<Changed> no = undo(mark);
    path_.pop_back();
    auto a = yes.begin();
    auto b = no.begin();
    while (a != yes.end() || b != no.end()) {
        const std::uint32_t cell = a == yes.end() ? b->cell : b == no.end() ? a->cell : std::min(a->cell, b->cell);
        const Id<Expr> before = memory_[cell];
        const Id<Expr> if_true = a != yes.end() && a->cell == cell ? (a++)->value : before;
        const Id<Expr> if_false = b != no.end() && b->cell == cell ? (b++)->value : before;
        write(cell, if_true == if_false ? if_true : exprs_.conditional(condition, if_true, if_false));
    }
}

/// Returns the condition that neither RETURN nor EXIT was executed, so that the next statement is reached.
Id<Expr> SymbolicExecution::alive() {
    return exprs_.negation(exprs_.disjunction(memory_[returned_], memory_[exited_]));
}

void SymbolicExecution::event(std::vector<Scan::Event>& events, Id<Expr> condition, Span origin, ProgramFault fault) {
    if (is_false(exprs_, condition)) return;
    std::vector<Id<Expr>> all = path_;
    all.push_back(condition);
    const Id<Expr> reached = exprs_.conjunction(all);
    if (!is_false(exprs_, reached)) events.push_back({reached, origin, fault});
}

/// Records the execution of a statement, which occurs if the current path is taken and `condition` is true.
void SymbolicExecution::note(Scan::Execution execution, Id<Expr> condition) {
    if (executions_ == nullptr) return;
    std::vector<Id<Expr>> all = path_;
    all.push_back(condition);
    execution.reached = exprs_.conjunction(all);
    if (!is_false(exprs_, execution.reached)) executions_->push_back(execution);
}

/// Records that an output is read on the current path.
void SymbolicExecution::note_read(std::uint32_t cell) {
    if (cell < layout_.cells.size() && layout_.cells[cell].output) note({.cell = cell}, exprs_.constant(true));
}

/// Returns the value of the condition of a branch or loop, and records its evaluation.
Id<Expr> SymbolicExecution::decision(Id<Program::Node> node, std::uint32_t frame) {
    const Id<Expr> term = value(node, frame);
    note({.node = node, .value = term}, exprs_.constant(true));
    return term;
}

// -- statements -------------------------------------------------------------------------------------------------------

void SymbolicExecution::execute(const Program::Body& body, std::size_t from, std::uint32_t frame) {
    for (std::size_t i = from; i < body.size() && !failed_; ++i) {
        execute(body[i], frame);
        const Id<Expr> continues = alive();
        if (is_true(exprs_, continues) || i + 1 == body.size()) continue;
        branch(
            continues,
            [&] {
                write(returned_, exprs_.constant(false));
                write(exited_, exprs_.constant(false));
                execute(body, i + 1, frame);
            },
            [] {});
        return;
    }
}

void SymbolicExecution::execute(Id<Program::Statement> id, std::uint32_t frame) {
    const Program::Statement& statement = program_.statements[id];
    if (!counts(statement)) return;
    const bool has_cell = statement.kind == Kind::Assign || statement.kind == Kind::Invoke;
    if (!has_cell) note({.statement = id}, exprs_.constant(true));
    switch (statement.kind) {
    case Kind::Assign: {
        const Id<Expr> term = value(statement.value, frame);
        for (const Element& one : elements(statement.place, frame, statement.origin)) {
            note({.statement = id, .cell = one.cell, .value = term}, one.condition);
            write(one.cell, exprs_.conditional(one.condition, term, memory_[one.cell]));
        }
        return;
    }
    case Kind::Invoke:
        for (const Element& one : elements(statement.place, frame, statement.origin)) {
            note({.statement = id, .cell = one.cell}, one.condition);
            branch(
                one.condition, [&] { invoke(statement.unit, one.cell); }, [] {});
        }
        return;
    case Kind::If: return arms(statement, 0, {}, frame);
    case Kind::Case: return arms(statement, 0, value(statement.value, frame), frame);
    case Kind::For: return for_loop(statement, frame);
    case Kind::While:
    case Kind::Repeat: return loop(statement, {}, frame);
    case Kind::Check: return event(faults, value(statement.value, frame), statement.origin, ProgramFault::Chart);
    case Kind::Exit: return write(exited_, exprs_.constant(true));
    case Kind::Return: return write(returned_, exprs_.constant(true));
    }
}

void SymbolicExecution::arms(const Program::Statement& statement, std::size_t from, Id<Expr> selector,
                             std::uint32_t frame) {
    if (from == statement.arms.size() || !counts(statement)) return;
    const Program::Arm& arm = statement.arms[from];
    if (!arm.condition.valid() && arm.labels.empty()) return execute(arm.body, 0, frame);
    Id<Expr> condition;
    if (statement.kind == Kind::If) {
        condition = decision(arm.condition, frame);
    } else {
        std::vector<Id<Expr>> matches;
        for (const auto& [low, high] : arm.labels) {
            const Id<Expr> first = exprs_.integer(low);
            matches.push_back(low == high
                                  ? exprs_.apply(Op::Equal, selector, first)
                                  : exprs_.conjunction(exprs_.apply(Op::GreaterEqual, selector, first),
                                                       exprs_.apply(Op::LessEqual, selector, exprs_.integer(high))));
        }
        condition = exprs_.disjunction(matches);
    }
    branch(
        condition, [&] { execute(arm.body, 0, frame); }, [&] { arms(statement, from + 1, selector, frame); });
}

void SymbolicExecution::for_loop(const Program::Statement& statement, std::uint32_t frame) {
    const Id<Expr> first = value(statement.value, frame);
    const Id<Expr> last = value(statement.last, frame);
    write(address(statement.place, frame), first);
    loop(statement, last, frame);
}

void SymbolicExecution::loop(const Program::Statement& statement, Id<Expr> last, std::uint32_t frame) {
    const Program::Statement* const outer = loop_;
    if (outer == nullptr) loop_ = &statement;
    iterate(statement, last, frame);
    loop_ = outer;
    write(exited_, exprs_.constant(false));
}

/// Executes the remaining iterations of a loop. While the loop condition is constant, the iterations are executed
/// directly. If the condition is not constant, all further iterations are executed in a branch.
void SymbolicExecution::iterate(const Program::Statement& statement, Id<Expr> last, std::uint32_t frame) {
    const Program::Body& body = statement.arms.front().body;
    const std::uint32_t variable = statement.kind == Kind::For ? address(statement.place, frame) : 0;
    const auto rest = [&] {  // executes the further iterations if the body has executed neither EXIT nor RETURN
        write(exited_, exprs_.constant(false));
        write(returned_, exprs_.constant(false));
        if (statement.kind == Kind::For)
            write(variable,
                  wrapped_term(program_.types[statement.type],
                               exprs_.apply(Op::Plus, memory_[variable], exprs_.integer(statement.step)), false));
    };
    for (std::uint64_t count = 0; !failed_; ++count) {
        if (count > most_iterations || path_.size() > most_branches)
            return fail(
                messages::unbounded_loop(statement.origin, count > most_iterations ? count - 1 : most_branches));
        ++executed_;
        Id<Expr> condition = exprs_.constant(true);
        if (statement.kind == Kind::While) condition = decision(statement.value, frame);
        if (statement.kind == Kind::For) note_read(variable);
        if (statement.kind == Kind::For)
            condition = exprs_.apply(statement.step > 0 ? Op::LessEqual : Op::GreaterEqual, memory_[variable], last);
        if (is_false(exprs_, condition)) return;
        bool ends = false;
        const auto once = [&] {  // executes one iteration; returns true if the next iteration follows unconditionally
            execute(body, 0, frame);
            if (failed_) return false;
            Id<Expr> continues = alive();
            if (statement.kind == Kind::Repeat && !is_false(exprs_, continues)) {
                if (!is_true(exprs_, continues)) {
                    branch(
                        continues,
                        [&] {
                            rest();
                            if (is_true(exprs_, value(statement.value, frame))) return;
                            branch(
                                exprs_.negation(value(statement.value, frame)),
                                [&] { iterate(statement, last, frame); }, [] {});
                        },
                        [] {});
                    return false;
                }
                continues = exprs_.negation(value(statement.value, frame));
            }
            if (is_false(exprs_, continues)) return false;
            if (is_true(exprs_, continues)) {
                rest();
                return true;
            }
            branch(
                continues,
                [&] {
                    rest();
                    iterate(statement, last, frame);
                },
                [] {});
            return false;
        };
        if (is_true(exprs_, condition)) {
            ends = !once();
        } else {
            branch(
                condition,
                [&] {
                    if (once()) iterate(statement, last, frame);
                },
                [] {});
            ends = true;
        }
        if (ends) return;
    }
}

void SymbolicExecution::invoke(Id<Program::Unit> id, std::uint32_t frame) {
    const Program::Unit& unit = program_.units[id];
    for (const Program::Variable& one : unit.variables)
        if (one.section == Program::Variable::Section::Temporary) {
            std::uint32_t cell = frame + one.offset;
            std::vector<Id<Expr>> terms;
            initial_terms(one.type, one.initial, terms);
            for (const Id<Expr> term : terms) write(cell++, term);
        }
    execute(unit.body, 0, frame);
    write(returned_, exprs_.constant(false));
    write(exited_, exprs_.constant(false));
}

}  // namespace grafverif
