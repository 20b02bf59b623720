// SPDX-License-Identifier: MIT
#include "pipeline/program/analyse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <utility>

#include "analyse/analyse.hpp"
#include "check/portfolio.hpp"
#include "derive/program/scan.hpp"
#include "ir/program/fault_text.hpp"
#include "ir/program/interface.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "pipeline/program/replay.hpp"
#include "syntax/print/program.hpp"

namespace grafverif {

namespace {

using StatementKind = Program::Statement::Kind;

bool is_hidden(const std::string& name) { return name.find(' ') != std::string::npos; }

/// Queries events, decides all of them together, and then reports the impossible ones. The two passes over the program
/// are the same function: the first pass only collects the events.
class ProgramAnalysis {
public:
    ProgramAnalysis(const Program& program, Scan scan)
        : program_(program),
          scan_(std::move(scan)),
          reached_(program.statements.size(), never()),
          true_(program.nodes.size(), never()),
          false_(program.nodes.size(), never()),
          cleared_(program.statements.size(), never()) {
        for (const ProgramInstance& instance : scan_.layout.instances)
            if (const auto cell = watched_cell(instance)) becomes_true_.emplace(*cell, never());
        for (const Scan::Execution& each : scan_.executions) note(each);
    }

    Analysis analyse(const std::string& name, const Limits& limits) && {
        const auto begin = std::chrono::steady_clock::now();
        analysis_.chart = name;
        analysis_.mode = ExecutionMode::EveryCycle;
        visit();
        decide(limits);
        reporting_ = true;
        visit();
        sort_findings(analysis_.findings);
        analysis_.questions = goals_.size();
        if (analysis_.open.empty()) analysis_.obstacle.clear();
        analysis_.notes.push_back(fmt::format("inputs are free; {}; findings are proved for any number of scans",
                                              program_.interval_ms
                                                  ? fmt::format("a scan starts every {} ms", *program_.interval_ms)
                                                  : "any time passes between two scans"));
        analysis_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return std::move(analysis_);
    }

private:
    enum class Answer { Possible, Impossible, Open };
    /// An impossible event and its description.
    struct Event {
        std::string_view code = {};
        std::string subject = {};
        std::string message = {};
        Span origin = {};
    };

    Exprs& exprs() { return scan_.equations.exprs; }
    Id<Expr> never() { return exprs().constant(false); }

    void note(const Scan::Execution& each) {
        const auto add = [&](Id<Expr>& any, Id<Expr> term) { any = exprs().disjunction(any, term); };
        if (each.node.valid()) {
            add(true_[each.node.index], exprs().conjunction(each.reached, each.value));
            add(false_[each.node.index], exprs().conjunction(each.reached, exprs().negation(each.value)));
            return;
        }
        const Program::Statement& statement = program_.statements[each.statement];
        add(reached_[each.statement.index], each.reached);
        if (statement.kind == StatementKind::Invoke) {
            const Program::Unit& unit = program_.units[statement.unit];
            const Id<Program::Unit> block = unit.owner.valid() ? unit.owner : statement.unit;
            add(called_.try_emplace({block.index, each.cell}, never()).first->second, each.reached);
        }
        if (statement.kind != StatementKind::Assign) return;
        if (const auto watched = becomes_true_.find(each.cell); watched != becomes_true_.end())
            add(watched->second, exprs().conjunction(each.reached, each.value));
        if (each.value.valid() && statement.generated)
            add(cleared_[each.statement.index], exprs().conjunction(each.reached, each.value));
        if (each.cell < scan_.layout.cells.size() && scan_.layout.cells[each.cell].output && !statement.generated)
            writes_[each.cell].push_back(&each);
    }

    bool is_step(const ProgramInstance& instance) const {
        return program_.units[instance.unit].elapsed && scan_.layout.cells[instance.frame].step;
    }

    /// Returns the cell of the output of a timer, or of the activity of a step. It is false at power-on, except for the
    /// activity of an initial step.
    std::optional<std::uint32_t> watched_cell(const ProgramInstance& instance) const {
        const Program::Unit& unit = program_.units[instance.unit];
        if (!unit.elapsed) return {};
        if (is_step(instance)) return instance.frame;
        for (const Program::Variable& variable : unit.variables)
            if (variable.name == "Q" || variable.name == "q") return instance.frame + variable.offset;
        return {};
    }

    // -- events -------------------------------------------------------------------------------------------------------

    /// True if the event is impossible. Adds a finding in the second pass.
    bool impossible(Id<Expr> event, const Event& about) {
        const Answer answer = answer_to(event);
        if (answer == Answer::Open) analysis_.open.push_back({std::string(about.code), about.subject});
        if (answer != Answer::Impossible) return false;
        if (reporting_) report(about);
        return true;
    }

    Answer answer_to(Id<Expr> event) {
        if (is_false(exprs(), event)) return Answer::Impossible;
        if (is_true(exprs(), event)) return Answer::Possible;
        const auto [known, fresh] = goals_.try_emplace(event, goals_.size());
        if (!reporting_) return Answer::Possible;
        return fresh ? Answer::Open : answers_[known->second];
    }

    void report(const Event& about) {
        const auto kind = std::ranges::find(finding_kinds(), about.code, &FindingKind::code);
        Finding made;
        made.code = about.code;
        made.level = kind->level;
        made.subject = about.subject;
        made.message = about.message;
        made.origin = about.origin;
        analysis_.findings.push_back(std::move(made));
    }

    void decide(const Limits& limits) {
        std::vector<ScanProperty> properties(goals_.size());
        for (const auto& [event, index] : goals_)
            properties[index] = {fmt::format("q{}", index), "", Pattern::Reachable, event, scan_.equations.origin};
        const ProgramSystem system = schedule_program(scan_, properties);
        PortfolioOptions options;
        options.witnesses = false;
        options.alone = 50'000'000;
        set_limits(options, limits);
        const PortfolioResult result = check_together(system.system, options);
        analysis_.failures = result.failures;
        if (result.fault)
            analysis_.failures.push_back(fmt::format("the system of the program is ill-defined: {} {}",
                                                     word(result.fault->kind), result.fault->variable));
        const std::size_t first = system.no_fault.valid() ? 1 : 0;
        for (std::size_t k = first; k < result.verdicts.size(); ++k) {
            const Outcome outcome = result.verdicts[k].outcome;
            answers_.push_back(outcome == Outcome::Holds      ? Answer::Possible
                               : outcome == Outcome::Violated ? Answer::Impossible
                                                              : Answer::Open);
            if (outcome != Outcome::Unknown) continue;
            const std::string& reason = result.verdicts[k].reason;
            analysis_.obstacle = reason.empty() ? "the engines gave no reason" : reason;
        }
        if (first == 1) add_fault(system, result);
    }

    /// Adds a run-time fault, with a run that the interpreter has replayed. Other findings concern the scans before it.
    void add_fault(const ProgramSystem& system, const PortfolioResult& result) {
        if (result.verdicts.front().outcome == Outcome::Holds) return;
        analysis_.notes.emplace_back("scans with a run-time fault, and the scans after it, are not considered");
        if (result.verdicts.front().outcome != Outcome::Violated || !result.runs.front()) return;
        ProgramReplay replay = replay_program(program_, scan_, system, *result.runs.front(), nullptr);
        if (!replay.disagreement.empty()) {
            analysis_.failures.push_back("a run-time fault is not confirmed: " + replay.disagreement);
            return;
        }
        report({"no-value", "", text_of(*replay.fault), program_.units[program_.main].origin});
        analysis_.findings.back().evidence = std::move(replay.trace);
        analysis_.findings.back().evidence_shows = "the fault occurs in the last scan";
    }

    // -- the program --------------------------------------------------------------------------------------------------

    void visit() {
        analysis_.open.clear();
        idle_.clear();
        visit_instances();
        for (const Id<Program::Unit> id : program_.units.ids()) visit_unit(id);
        visit_transitions();
        visit_outputs();
    }

    /// Queries calls of instances, timers and steps. The elements of an instance that is never called are not reported.
    void visit_instances() {
        for (const ProgramInstance& instance : scan_.layout.instances) {
            if (instance.name.empty() || is_hidden(instance.name) || is_idle(instance.name)) continue;
            if (is_step(instance)) {
                visit_step(instance);
                continue;
            }
            const auto called = called_.find({instance.unit.index, instance.frame});
            if (impossible(called == called_.end() ? never() : called->second,
                           {"block-never-called", instance.name,
                            fmt::format("the instance `{}` is never called", instance.name), origin_of(instance)})) {
                idle_.insert(instance.name + ".");
                continue;
            }
            if (const auto output = watched_cell(instance))
                impossible(
                    becomes_true_.at(*output),
                    {"timer-never-true", instance.name,
                     fmt::format("the output of the timer `{}` is never true", instance.name), origin_of(instance)});
        }
    }

    void visit_step(const ProgramInstance& instance) {
        if (scan_.layout.cells[instance.frame].initial != 0) return;
        impossible(becomes_true_.at(instance.frame),
                   {"step-never-active", instance.name,
                    fmt::format("the step `{}` is never active: no sequence of inputs activates it", instance.name),
                    scan_.layout.cells[instance.frame].origin});
    }

    /// Returns the declaration of an instance.
    Span origin_of(const ProgramInstance& instance) const {
        const std::size_t dot = instance.name.rfind('.');
        const std::string owner = dot == std::string::npos ? "" : instance.name.substr(0, dot);
        const std::string own = instance.name.substr(dot + 1);  // npos + 1 is 0
        const std::string_view name = std::string_view(own).substr(0, own.find('['));
        std::vector<Id<Program::Unit>> units = {program_.globals};
        for (const ProgramInstance& each : scan_.layout.instances)
            if (each.name == owner) units.push_back(each.unit);
        for (const Id<Program::Unit> unit : units)
            for (const Program::Variable& variable : program_.units[unit].variables)
                if (variable.name == name) return variable.origin;
        return program_.units[program_.main].origin;
    }
    bool is_idle(const std::string& name) const {
        return std::ranges::any_of(idle_, [&](const std::string& prefix) { return name.starts_with(prefix); });
    }

    void visit_unit(Id<Program::Unit> id) {
        const Program::Unit& unit = program_.units[id];
        if (unit.origin.source != program_.units[program_.main].origin.source || unit.body.empty()) return;
        unit_ = unit.owner.valid() ? unit.owner : id;
        Id<Expr> executed = never();
        for (const Id<Program::Statement> statement : unit.body)
            executed = exprs().disjunction(executed, reached_[statement.index]);
        const bool block = unit.kind == Program::Unit::Kind::FunctionBlock;
        const char* const word = unit.kind == Program::Unit::Kind::Action     ? "action"
                                 : unit.kind == Program::Unit::Kind::Function ? "function"
                                                                              : "function block";
        const std::string name = (unit.owner.valid() ? program_.units[unit.owner].name + "." : "") + unit.name;
        const bool has_instances = std::ranges::any_of(
            scan_.layout.instances, [&](const ProgramInstance& instance) { return instance.unit == id; });
        if (block && has_instances) {  // its instances are reported
            if (answer_to(executed) == Answer::Impossible) return;
        } else if (impossible(executed,
                              {"block-never-called", name,
                               fmt::format("the {} `{}` is never {}", word, name, block ? "instantiated" : "executed"),
                               unit.origin}))
            return;
        visit(unit.body);
    }

    void visit(const Program::Body& body) {
        bool reported = false;  // only the first of several statements is reported
        for (const Id<Program::Statement> id : body) {
            const Program::Statement& statement = program_.statements[id];
            if (statement.generated) {
                for (const Program::Arm& arm : statement.arms) visit(arm.body);
                continue;
            }
            if (reported && answer_to(reached_[id.index]) == Answer::Impossible) continue;
            reported = impossible(reached_[id.index], {"statement-never-executed", "",
                                                       "this statement is never executed", statement.origin});
            if (!reported) visit(statement);
        }
    }

    void visit(const Program::Statement& statement) {
        if (statement.kind == StatementKind::While && !visit_condition(statement.value).first) return;
        if (statement.kind != StatementKind::If) {
            for (const Program::Arm& arm : statement.arms) visit(arm.body);
            return;
        }
        for (const Program::Arm& arm : statement.arms) {
            const auto [can_hold, can_fail] =
                arm.condition.valid() ? visit_condition(arm.condition) : std::pair(true, true);
            if (can_hold) visit(arm.body);
            if (!can_fail) return;  // the following branches are not executed
        }
    }

    /// Returns whether the condition can be true, and whether it can be false.
    std::pair<bool, bool> visit_condition(Id<Program::Node> id) {
        const Program::Node& node = program_.nodes[id];
        const std::string text = term_text(program_, unit_, id);
        if (node.op == Program::Op::Constant) return {node.value != 0, node.value == 0};
        if (impossible(true_[id.index], {"condition-never-true", "",
                                         fmt::format("the condition `{}` is never true", text), node.origin}))
            return {false, true};
        return {true, !impossible(false_[id.index],
                                  {"condition-always-true", "",
                                   fmt::format("the condition `{}` is true in each execution", text), node.origin})};
    }

    /// Queries transitions. A transition that is never enabled follows a step that is reported.
    void visit_transitions() {
        for (const Id<Program::Unit> id : program_.units.ids())
            for (const Program::Sequence& sequence : program_.units[id].sequences)
                for (const Program::Sequence::Transition& transition : sequence.transitions) {
                    if (answer_to(reached_[transition.test.index]) == Answer::Impossible) continue;
                    const Id<Program::Node> condition = program_.statements[transition.test].value;
                    impossible(cleared_[transition.test.index],
                               {"transition-never-fired", transition.name,
                                fmt::format("this transition is never cleared: `{}` is never true while it is enabled",
                                            term_text(program_, id, condition)),
                                program_.nodes[condition].origin});
                }
    }

    /// Queries assignments to outputs that another statement always replaces in the same scan.
    void visit_outputs() {
        for (const auto& [cell, writes] : writes_) {
            std::map<std::uint32_t, Id<Expr>> kept;  // per statement
            std::map<std::uint32_t, Id<Expr>> later_of;
            for (auto each = writes.rbegin(); each != writes.rend(); ++each) {
                const std::uint32_t statement = (*each)->statement.index;
                Id<Expr> others = never();
                for (const auto& [other, reached] : later_of)
                    if (other != statement) others = exprs().disjunction(others, reached);
                Id<Expr>& any = kept.try_emplace(statement, never()).first->second;
                any = exprs().disjunction(any, exprs().conjunction((*each)->reached, exprs().negation(others)));
                Id<Expr>& own = later_of.try_emplace(statement, never()).first->second;
                own = exprs().disjunction(own, (*each)->reached);
            }
            if (kept.size() < 2) continue;
            for (const auto& [statement, event] : kept) {
                if (answer_to(reached_[statement]) == Answer::Impossible) continue;
                const std::string& name = scan_.layout.cells[cell].name;
                const bool found = impossible(
                    event, {"assignment-overwritten", name,
                            fmt::format("another assignment to `{}` in the same scan always replaces this value", name),
                            program_.statements[Id<Program::Statement>{statement}].origin});
                if (!found || !reporting_) continue;
                for (const auto& [other, unused] : kept)
                    if (other != statement)
                        analysis_.findings.back().related.push_back(
                            {program_.statements[Id<Program::Statement>{other}].origin, "another assignment is here"});
            }
        }
    }

    const Program& program_;
    Scan scan_;
    std::vector<Id<Expr>> reached_;                        ///< per statement: it is executed in the scan
    std::vector<Id<Expr>> true_, false_;                   ///< per condition: it is evaluated to this value in the scan
    std::map<std::uint32_t, Id<Expr>> becomes_true_ = {};  ///< per watched cell: an assignment of true to it
    std::vector<Id<Expr>> cleared_;                        ///< per generated assignment: it assigns true in the scan
    std::map<std::pair<std::uint32_t, std::uint32_t>, Id<Expr>> called_ = {};   ///< by block and frame
    std::map<std::uint32_t, std::vector<const Scan::Execution*>> writes_ = {};  ///< assignments of each output
    std::map<Id<Expr>, std::size_t> goals_ = {};
    std::vector<Answer> answers_ = {};  ///< of each goal
    std::set<std::string> idle_ = {};   ///< prefixes of the names in instances that are never called
    Id<Program::Unit> unit_ = {};
    bool reporting_ = false;
    Analysis analysis_ = {};
};

}  // namespace

std::optional<Analysis> analyse_program(const Program& program, const std::string& name, const Limits& limits,
                                        Diagnostics& diagnostics) {
    auto scan = scan_of(program, diagnostics, true);
    if (!scan) return {};
    return ProgramAnalysis(program, std::move(*scan)).analyse(name, limits);
}

}  // namespace grafverif
