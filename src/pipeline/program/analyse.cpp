// SPDX-License-Identifier: MIT
#include "pipeline/program/analyse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "analyse/analyse.hpp"
#include "check/portfolio.hpp"
#include "derive/program/scan.hpp"
#include "ir/program/fault_text.hpp"
#include "ir/program/interface.hpp"
#include "pipeline/models.hpp"
#include "pipeline/program/initial_values.hpp"
#include "pipeline/program/replay.hpp"
#include "syntax/print/program.hpp"

namespace grafverif {

namespace {

using StatementKind = Program::Statement::Kind;

/// Maximum number of reads and assignments of an output in a scan. Assignments to an output with more accesses are not
/// analysed, because the terms that describe them would be too deep.
constexpr std::size_t most_accesses = 1000;

/// Analyses a program in two passes of `visit`: the first pass collects events, the second reports impossible events.
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
        for (const auto& [event, terms] : terms_) *event = exprs().disjunction(terms);
        std::vector<Id<Expr>> faults;
        for (const Scan::Event& fault : scan_.faults) faults.push_back(fault.condition);
        fault_ = exprs().disjunction(faults);
    }

    Analysis analyse(const std::string& name, const Limits& limits) && {
        const auto begin = std::chrono::steady_clock::now();
        analysis_.chart = name;
        analysis_.findings = findings_about_initial_values(program_, scan_.layout);
        analysis_.mode = ExecutionMode::EveryCycle;
        visit();
        decide(limits);
        reporting_ = true;
        visit();
        if (fault_is_open_) analysis_.open.push_back({"no-value", ""});
        sort_findings(analysis_.findings);
        analysis_.questions = goals_.size();
        if (analysis_.open.empty()) analysis_.obstacle.clear();
        analysis_.notes.push_back(fmt::format("inputs are free; {}; findings are proved for any number of scans",
                                              program_.interval_ms
                                                  ? fmt::format("a scan starts every {} ms", *program_.interval_ms)
                                                  : "any time can pass between two scans"));
        analysis_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return std::move(analysis_);
    }

private:
    enum class Answer { Possible, Impossible, Open };
    /// The finding that is reported if an event is impossible.
    struct Event {
        std::string_view code = {};
        std::string subject = {};
        std::string message = {};
        Span origin = {};
    };

    /// The position of a statement in the source. One statement of the source can become several statements of the
    /// program: for example, an assignment to a structure becomes one assignment for each member.
    using Position = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

    Position position_of(Id<Program::Statement> id) const {
        const Span where = program_.statements[id].origin;
        return {where.source.index, where.begin, where.end};
    }

    Exprs& exprs() { return scan_.equations.exprs; }
    Id<Expr> never() { return exprs().constant(false); }

    /// Adds a term to the disjunction of terms that defines `event`.
    void add(Id<Expr>& event, Id<Expr> term) {
        const auto [known, fresh] = index_of_terms_.try_emplace(&event, terms_.size());
        if (fresh) terms_.emplace_back(&event, std::vector<Id<Expr>>());
        terms_[known->second].second.push_back(term);
    }

    void note(const Scan::Execution& each) {
        if (!each.node.valid() && !each.statement.valid()) {
            accesses_[each.cell].push_back(&each);
            return;
        }
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
        if (statement.generated) return;
        if (each.cell < scan_.layout.cells.size() && scan_.layout.cells[each.cell].output)
            accesses_[each.cell].push_back(&each);
        else not_only_outputs_.insert(position_of(each.statement));
    }

    bool is_step(const ProgramInstance& instance) const {
        return program_.units[instance.unit].elapsed && scan_.layout.cells[instance.frame].step;
    }

    /// Returns the memory cell with the output of a timer or with the activity of a step; empty for other instances. At
    /// power-on, the value of the cell is false, except for an initial step.
    std::optional<std::uint32_t> watched_cell(const ProgramInstance& instance) const {
        const Program::Unit& unit = program_.units[instance.unit];
        if (!unit.elapsed) return {};
        if (is_step(instance)) return instance.frame;
        for (const Program::Variable& variable : unit.variables)
            if (variable.name == "Q" || variable.name == "q") return instance.frame + variable.offset;
        return {};
    }

    // -- events -------------------------------------------------------------------------------------------------------

    /// True if the event is proved to be impossible; in this case, the second pass also adds the finding `about`.
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
            properties[index] = {fmt::format("q{}", index), "",  Pattern::Reachable, event,
                                 scan_.equations.origin,    true};
        const ProgramSystem system = schedule_program(scan_, properties);
        PortfolioOptions options;
        options.witnesses = false;
        options.alone = 50'000'000;
        set_limits(options, limits);
        const PortfolioResult result = check_together(system.system, options);
        analysis_.failures = result.failures;
        if (result.fault)
            analysis_.failures.push_back(fmt::format("the transition system of the program is invalid: {} {}",
                                                     word(result.fault->kind), result.fault->variable));
        const std::size_t first = system.no_fault.valid() ? 1 : 0;
        for (std::size_t k = first; k < result.verdicts.size(); ++k) {
            const Outcome outcome = result.verdicts[k].outcome;
            answers_.push_back(outcome == Outcome::Holds      ? Answer::Possible
                               : outcome == Outcome::Violated ? Answer::Impossible
                                                              : Answer::Open);
            if (outcome == Outcome::Unknown) set_obstacle(result.verdicts[k]);
        }
        if (first == 1) add_fault(system, result);
    }

    void set_obstacle(const Verdict& unknown) {
        analysis_.obstacle = unknown.reason.empty() ? "the engines gave no reason" : unknown.reason;
    }

    /// Adds a finding for a possible run-time fault, with a run that the interpreter has replayed. All other findings
    /// concern only scans before a fault.
    void add_fault(const ProgramSystem& system, const PortfolioResult& result) {
        const Verdict& verdict = result.verdicts.front();
        if (verdict.outcome == Outcome::Holds) return;
        analysis_.notes.emplace_back("scans after a run-time fault are not considered");
        if (verdict.outcome == Outcome::Unknown) {
            fault_is_open_ = true;
            return set_obstacle(verdict);
        }
        const Span origin = program_.units[program_.main].origin;
        if (!result.runs.front()) return report({"no-value", "", "a run-time fault is possible", origin});
        ProgramReplay replay = replay_program(program_, scan_, system, *result.runs.front(), nullptr);
        if (!replay.disagreement.empty()) {
            analysis_.failures.push_back("a run-time fault is not confirmed: " + replay.disagreement);
            return;
        }
        report({"no-value", "", text_of(*replay.fault), origin});
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

    /// Visits instances, timers and steps. The elements of an instance that is never called are not reported.
    void visit_instances() {
        for (const ProgramInstance& instance : scan_.layout.instances) {
            if (instance.name.empty() || is_generated_name(instance.name) || is_idle(instance.name)) continue;
            if (is_step(instance)) {
                visit_step(instance);
                continue;
            }
            if (is_generated_name(program_.units[instance.unit].name)) {  // unit of a chart's action
                idle_.insert(instance.name + ".");
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

    /// Returns the position of the declaration of an instance.
    Span origin_of(const ProgramInstance& instance) const {
        const std::size_t dot = instance.name.rfind('.');
        const std::string owner = dot == std::string::npos ? "" : instance.name.substr(0, dot);
        const std::string own = instance.name.substr(dot + 1);  // without a dot, `dot + 1` is 0
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

    /// True unless it is proved that no scan calls the function block or one of its actions.
    bool is_called(Id<Program::Unit> block) {
        return block == program_.main || std::ranges::any_of(called_, [&](const auto& call) {
                   return call.first.first == block.index && answer_to(call.second) != Answer::Impossible;
               });
    }

    void visit_unit(Id<Program::Unit> id) {
        using Kind = Program::Unit::Kind;
        const Program::Unit& unit = program_.units[id];
        if (unit.origin.source != program_.units[program_.main].origin.source) return;
        const bool has_instances = std::ranges::any_of(
            scan_.layout.instances, [&](const ProgramInstance& instance) { return instance.unit == id; });
        const bool block = unit.kind == Kind::FunctionBlock;
        const bool unused = (block || unit.kind == Kind::Program) && !has_instances;
        if (unit.body.empty() && !unused) return;
        if (unit.owner.valid() && !is_called(unit.owner)) return;  // a finding about the owner is reported instead
        unit_ = unit.owner.valid() ? unit.owner : id;
        std::vector<Id<Expr>> reached;
        for (const Id<Program::Statement> statement : unit.body) reached.push_back(reached_[statement.index]);
        const Id<Expr> executed = exprs().disjunction(reached);
        if (has_instances) {  // the finding is reported for the instances of the unit
            if (answer_to(executed) == Answer::Impossible) return;
        } else {
            const char* const word = block                         ? "function block"
                                     : unit.kind == Kind::Action   ? "action"
                                     : unit.kind == Kind::Function ? "function"
                                                                   : "program";
            const std::string name = (unit.owner.valid() ? program_.units[unit.owner].name + "." : "") + unit.name;
            if (impossible(executed, {"block-never-called", name,
                                      fmt::format("the {} `{}` is never {}", word, name, block ? "called" : "executed"),
                                      unit.origin}))
                return;
        }
        visit(unit.body);
    }

    void visit(const Program::Body& body) {
        bool reported = false;  // only the first of several unreachable statements is reported
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
            const bool configured = statement.kind == StatementKind::Case && !depends_on_values(statement.value);
            for (const Program::Arm& arm : statement.arms)
                if (!configured || is_executed(arm.body)) visit(arm.body);
            return;
        }
        for (const Program::Arm& arm : statement.arms) {
            const auto [can_hold, can_fail] =
                arm.condition.valid() ? visit_condition(arm.condition) : std::pair(true, true);
            if (can_hold) visit(arm.body);
            if (!can_fail) return;  // the condition is always true, so the following branches are never executed
        }
    }

    bool is_executed(const Program::Body& body) {
        return !body.empty() && answer_to(reached_[body.front().index]) != Answer::Impossible;
    }

    /// True if the expression reads a variable or calls a function. Otherwise, its value is constant.
    bool depends_on_values(Id<Program::Node> id) const {
        const Program::Node& node = program_.nodes[id];
        return node.op == Program::Op::Read || node.op == Program::Op::Call ||
               std::ranges::any_of(node.operands,
                                   [&](Id<Program::Node> operand) { return depends_on_values(operand); });
    }

    /// Returns two values: whether the condition can be true, and whether the condition can be false.
    std::pair<bool, bool> visit_condition(Id<Program::Node> id) {
        const Program::Node& node = program_.nodes[id];
        const std::string text = term_text(program_, unit_, id);
        if (!depends_on_values(id))
            return {answer_to(true_[id.index]) != Answer::Impossible,
                    answer_to(false_[id.index]) != Answer::Impossible};
        if (impossible(true_[id.index], {"condition-never-true", "",
                                         fmt::format("the condition `{}` is never true", text), node.origin}))
            return {false, true};
        return {true, !impossible(false_[id.index],
                                  {"condition-always-true", "",
                                   fmt::format("the condition `{}` is true in each evaluation", text), node.origin})};
    }

    /// Visits transitions. A transition that is never enabled is not reported, because a preceding step is reported.
    void visit_transitions() {
        for (const Id<Program::Unit> id : program_.units.ids())
            for (const Program::Sequence& sequence : program_.units[id].sequences)
                for (const Program::Sequence::Transition& transition : sequence.transitions) {
                    if (answer_to(reached_[transition.test.index]) == Answer::Impossible) continue;
                    const Id<Program::Node> condition = program_.statements[transition.test].value;
                    impossible(cleared_[transition.test.index],
                               {"transition-never-fired", transition.name,
                                fmt::format("this transition is never cleared: `{}` is never true while the "
                                            "transition is enabled",
                                            term_text(program_, id, condition)),
                                program_.nodes[condition].origin});
                }
    }

    /// The assignments to outputs that one statement of the source makes.
    struct Assignment {
        std::vector<Id<Program::Statement>> statements = {};
        std::vector<std::uint32_t> cells = {};
        std::vector<Id<Expr>> kept = {};                         ///< conditions: a value is read or is final
        std::map<Position, Id<Program::Statement>> others = {};  ///< other assignments to the same outputs
    };

    /// Visits the assignments to outputs. An assignment is reported if, in every scan, another statement replaces the
    /// value before a statement reads it. If a run-time fault can end the scan earlier, the assignment is not reported.
    void visit_outputs() {
        for (const auto& [position, assignment] : assignments()) {
            const bool executed = std::ranges::any_of(assignment.statements, [&](Id<Program::Statement> id) {
                return answer_to(reached_[id.index]) == Answer::Possible;
            });
            if (!executed || not_only_outputs_.contains(position)) continue;
            const std::string& name = scan_.layout.cells[assignment.cells.front()].name;
            const std::string message =
                assignment.cells.size() == 1
                    ? fmt::format("another assignment to `{}` in the same scan always replaces this value", name)
                    : "other assignments in the same scan always replace these values";
            const bool found = impossible(
                exprs().disjunction(assignment.kept),
                {"assignment-overwritten", name, message, program_.statements[assignment.statements.front()].origin});
            if (!found || !reporting_) continue;
            for (const auto& [unused, other] : assignment.others)
                analysis_.findings.back().related.push_back(
                    {program_.statements[other].origin, "another assignment is here"});
        }
    }

    std::map<Position, Assignment> assignments() {
        std::map<Position, Assignment> all;
        for (const auto& [cell, accesses] : accesses_) {
            std::map<Position, Id<Program::Statement>> assigned;
            for (const Scan::Execution* access : accesses)
                if (access->statement.valid()) assigned.emplace(position_of(access->statement), access->statement);
            // For each statement that assigns the output: the condition under which another statement makes the next
            // access to the output, and this access is an assignment.
            std::map<Position, Id<Expr>> replaced;
            for (const auto& [position, statement] : assigned) {
                replaced.emplace(position, never());
                all[position].cells.push_back(cell);
                for (const auto& other : assigned)
                    if (other.first != position) all[position].others.insert(other);
            }
            const bool examined = assigned.size() > 1 && accesses.size() <= most_accesses;
            for (auto each = accesses.rbegin(); each != accesses.rend(); ++each) {
                const Scan::Execution& access = **each;
                const Id<Expr> passes = exprs().negation(access.reached);
                if (!access.statement.valid()) {
                    if (!examined) continue;
                    for (auto& [position, next] : replaced) next = exprs().conjunction(next, passes);
                    continue;
                }
                const Position own = position_of(access.statement);
                const Id<Expr> remains = exprs().disjunction(exprs().negation(replaced.at(own)), fault_);
                all[own].kept.push_back(exprs().conjunction(access.reached, remains));
                all[own].statements.push_back(access.statement);
                if (!examined) continue;
                for (auto& [position, next] : replaced)
                    if (position != own) next = exprs().disjunction(access.reached, next);
            }
        }
        return all;
    }

    const Program& program_;
    Scan scan_;
    std::vector<Id<Expr>> reached_;                        ///< for each statement: condition that the scan executes it
    std::vector<Id<Expr>> true_, false_;                   ///< for each condition: event that it is true, is false
    std::map<std::uint32_t, Id<Expr>> becomes_true_ = {};  ///< for each watched cell: true is assigned to the cell
    std::vector<Id<Expr>> cleared_;  ///< for each generated assignment: condition that true is assigned
    std::map<std::pair<std::uint32_t, std::uint32_t>, Id<Expr>> called_ = {};     ///< condition of a call, per frame
    std::map<std::uint32_t, std::vector<const Scan::Execution*>> accesses_ = {};  ///< per output: assignments, reads
    std::set<Position> not_only_outputs_ = {};                             ///< statements that also assign other cells
    std::vector<std::pair<Id<Expr>*, std::vector<Id<Expr>>>> terms_ = {};  ///< disjunctions that define events
    std::unordered_map<const Id<Expr>*, std::size_t> index_of_terms_ = {};
    Id<Expr> fault_ = {};  ///< condition: a run-time fault occurs
    bool fault_is_open_ = false;
    std::map<Id<Expr>, std::size_t> goals_ = {};
    std::vector<Answer> answers_ = {};  ///< for each goal: is the event possible?
    std::set<std::string> idle_ = {};   ///< name prefixes of instances that are never called
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
