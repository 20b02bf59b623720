// SPDX-License-Identifier: MIT
#include "syntax/language/format_items.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "support/overloaded.hpp"
#include "syntax/language/format.hpp"
#include "syntax/print/sentence.hpp"

namespace grafverif {

namespace {

constexpr std::size_t widest = 120;       ///< maximum length of a line that can be broken
constexpr std::size_t comfortable = 100;  ///< maximum length of a step that is printed on one line

std::string joined(const std::vector<std::string>& parts) {
    std::string line;
    for (const std::string& part : parts) line += (line.empty() ? "" : ", ") + part;
    return line;
}

std::string names(const tree::File& file, const std::vector<tree::Name>& written) {
    std::vector<std::string> parts;
    for (const tree::Name name : written) parts.push_back(formatted(file, name));
    return joined(parts);
}

/// Returns `head`, the comma-separated `parts` and `tail` on as many lines as necessary. Continuation lines are aligned
/// with the first part.
Lines filled(const std::string& head, const std::vector<std::string>& parts, const std::string& tail,
             std::size_t column) {
    Lines lines = {head};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string part = parts[i] + (i + 1 < parts.size() ? "," : tail);
        std::string& line = lines.back();
        const bool first = line.size() == head.size();
        if (first) line += part;
        else if (column + line.size() + 1 + part.size() <= widest) line += ' ' + part;
        else lines.push_back(std::string(head.size(), ' ') + part);
    }
    if (parts.empty()) lines.back() += tail;
    return lines;
}

std::string variable(const tree::File& file, const tree::Variable& written) {
    std::string line = formatted(file, written.name);
    switch (written.type) {
    case tree::TypeWord::None: break;
    case tree::TypeWord::Bool: line += ": bool"; break;
    case tree::TypeWord::Int: line += ": int"; break;
    case tree::TypeWord::Duration: line += ": duration"; break;
    }
    if (written.range) line += ' ' + formatted(file, written.range->low) + ".." + formatted(file, written.range->high);
    if (written.value.valid()) line += " = " + formatted(file, written.value);
    return line;
}

std::vector<std::string> variables(const tree::File& file, const tree::Variables& written) {
    std::vector<std::string> parts;
    for (const tree::Variable& one : written.variables) parts.push_back(variable(file, one));
    return parts;
}

std::string assignment(const tree::File& file, const tree::Assignment& written) {
    return formatted(file, written.target) + " := " + formatted(file, written.value);
}

std::string assignments(const tree::File& file, const std::vector<tree::Assignment>& written) {
    std::vector<std::string> parts;
    for (const tree::Assignment& one : written) parts.push_back(assignment(file, one));
    return joined(parts);
}

/// Returns the text of an edge or transition, `HEAD when CONDITION do ASSIGNMENTS;`. A long line is broken before
/// `when` and, if necessary, before `do`.
Lines guarded(const tree::File& file, const std::string& head, Id<tree::Expr> condition,
              const std::vector<tree::Assignment>& actions, std::size_t column) {
    std::vector<std::string> clauses;
    if (condition.valid()) clauses.push_back("when " + formatted(file, condition));
    if (!actions.empty()) clauses.push_back("do " + assignments(file, actions));
    std::string all;
    for (const std::string& clause : clauses) all += ' ' + clause;
    if (column + head.size() + all.size() < widest || clauses.empty()) return {head + all + ';'};
    if (column + 3 + all.size() < widest) return {head, "   " + all + ';'};
    Lines lines = {head};
    for (const std::string& clause : clauses) lines.push_back("    " + clause);
    lines.back() += ';';
    return lines;
}

}  // namespace

// -- charts ----------------------------------------------------------------------------------------------------------

Lines item_lines(const tree::File& file, const tree::Variables& written, std::size_t column) {
    std::string word;
    switch (written.kind) {
    case tree::VariableKind::Input: word = "input "; break;
    case tree::VariableKind::Output: word = "output "; break;
    case tree::VariableKind::Internal: word = "internal "; break;
    case tree::VariableKind::Own: word = "variable "; break;
    // The keyword `constant` is used only in closed loops; component heads have no keyword for constants.
    case tree::VariableKind::Constant: word = "constant "; break;
    }
    return filled(word, variables(file, written), ";", column);
}

Lines item_lines(const tree::File& file, const tree::Constraint& written, std::size_t) {
    return {"constraint " + formatted(file, written.condition) + ';'};
}

Lines item_lines(const tree::File& file, const tree::Transition& written, std::size_t column) {
    std::string head = "transition ";
    if (written.name.valid()) head += formatted(file, written.name) + ": ";
    if (!written.from.empty()) head += names(file, written.from) + ' ';
    head += "->";
    if (!written.to.empty()) head += ' ' + names(file, written.to);
    return guarded(file, head, written.condition, written.assignments, column);
}

Lines item_lines(const tree::File& file, const tree::ContinuousAction& written, std::size_t) {
    std::string line = formatted(file, written.output);
    if (written.condition.valid()) line += " if " + formatted(file, written.condition);
    if (written.delay.valid()) line += " after " + formatted(file, written.delay);
    if (written.limit.valid()) line += " for " + formatted(file, written.limit);
    return {line + ';'};
}

Lines item_lines(const tree::File& file, const tree::StoredAction& written, std::size_t) {
    std::string line = assignment(file, written.assignment);
    switch (written.when) {
    case tree::StoredWhen::Missing: break;
    case tree::StoredWhen::Activation: line += " on activation"; break;
    case tree::StoredWhen::Deactivation: line += " on deactivation"; break;
    case tree::StoredWhen::Event: line += " on event " + formatted(file, written.event); break;
    }
    return {line + ';'};
}

Lines item_lines(const tree::File& file, const tree::ForcingOrder& written, std::size_t) {
    std::string situation;
    switch (written.to) {
    case tree::ForcedTo::Empty: break;
    case tree::ForcedTo::Current: situation = "*"; break;
    case tree::ForcedTo::Initial: situation = "INIT"; break;
    case tree::ForcedTo::Steps: situation = names(file, written.steps); break;
    }
    return {"force " + formatted(file, written.chart) + " := {" + situation + "};"};
}

std::string step_head(const tree::File& file, const tree::Step& step) {
    std::string head;
    if (step.initial) head += "initial ";
    if (step.linked) head += "linked ";
    if (step.entry) head += "entry ";
    if (step.exit) head += "exit ";
    if (step.kind == tree::StepKind::Macro) head += "macro ";
    if (step.kind == tree::StepKind::Enclosing) head += "enclosing ";
    head += "step " + formatted(file, step.name);
    if (step.kind == tree::StepKind::Macro) head += " expands " + names(file, step.contents);
    if (step.kind == tree::StepKind::Enclosing) head += " encloses " + names(file, step.contents);
    return head;
}

std::optional<std::string> step_in_one_line(const tree::File& file, const tree::Step& step, std::size_t column) {
    std::string line = step_head(file, step) + " {";
    bool plain = true;
    for (const tree::Action& action : step.actions) {
        const auto* continuous = std::get_if<tree::ContinuousAction>(&action);
        plain = plain && continuous != nullptr && !continuous->condition.valid() && !continuous->delay.valid() &&
                !continuous->limit.valid();
        line +=
            ' ' + std::visit([&](const auto& written) { return item_lines(file, written, column).front(); }, action);
    }
    line += " }";
    if (column + line.size() > comfortable || (!plain && step.actions.size() > 2)) return {};
    return line;
}

// -- components -------------------------------------------------------------------------------------------------------

Lines item_lines(const tree::File& file, const tree::Clocks& written, std::size_t) {
    return {"clock " + names(file, written.names) + ';'};
}

Lines item_lines(const tree::File& file, const tree::Location& written, std::size_t) {
    std::string line = written.initial ? "initial location " : "location ";
    line += formatted(file, written.name);
    if (written.invariant.valid()) line += " invariant " + formatted(file, written.invariant);
    if (!written.values.empty()) line += " with " + assignments(file, written.values);
    return {line + ';'};
}

Lines item_lines(const tree::File& file, const tree::Edge& written, std::size_t column) {
    const std::string head =
        (written.urgent ? "urgent " : "timed ") + formatted(file, written.from) + " -> " + formatted(file, written.to);
    return guarded(file, head, written.condition, written.assignments, column);
}

std::string head_with_parameters(const tree::File& file, std::string_view keyword, tree::Name name,
                                 const std::vector<tree::Variables>& parameters) {
    const std::string head = std::string(keyword) + ' ' + formatted(file, name) + '(';
    std::vector<std::string> parts;  // each a group, or one variable of a group that is too long
    for (const tree::Variables& group : parameters) {
        const std::string word = group.kind == tree::VariableKind::Input    ? "input "
                                 : group.kind == tree::VariableKind::Output ? "output "
                                                                            : "";
        std::vector<std::string> declared = variables(file, group);
        declared.front() = word + declared.front();
        const std::string whole = joined(declared);
        if (head.size() + whole.size() + 3 <= widest) declared = {whole};
        for (std::size_t i = 0; i + 1 < declared.size(); ++i) declared[i] += ',';
        declared.back() += &group == &parameters.back() ? "" : ";";
        parts.insert(parts.end(), declared.begin(), declared.end());
    }
    std::string lines = head;
    std::size_t width = head.size();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t end = i + 1 < parts.size() ? 0 : 3;  // length of `) {`
        if (i > 0 && width + 1 + parts[i].size() + end > widest) {
            lines += '\n' + std::string(head.size(), ' ');
            width = head.size();
        } else if (i > 0) {
            lines += ' ';
            ++width;
        }
        lines += parts[i];
        width += parts[i].size();
    }
    return lines + ')';
}

// -- closed loops -----------------------------------------------------------------------------------------------------

namespace {

/// Returns the text `HEAD CALLED(ARGUMENTS)`, followed by `tail`.
Lines call(const tree::File& file, std::string head, tree::Name called, const std::vector<tree::Argument>& arguments,
           const std::string& tail, std::size_t column) {
    head += formatted(file, called) + '(';
    std::vector<std::string> parts;
    for (const tree::Argument& argument : arguments)
        parts.push_back(formatted(file, argument.parameter) + " = " + formatted(file, argument.value));
    return filled(head, parts, ')' + tail, column);
}

}  // namespace

Lines instance_lines(const tree::File& file, const tree::Partial& written, std::size_t column) {
    return call(file, "partial " + formatted(file, written.name) + " = ", written.chart, written.arguments, ";",
                column);
}

Lines item_lines(const tree::File& file, const tree::Controller& written, std::size_t column) {
    std::string options;
    if (written.cycle.least.valid()) options += " every " + formatted(file, written.cycle.least);
    if (written.cycle.most.valid()) options += ".." + formatted(file, written.cycle.most);
    if (!written.options.empty()) options += " with " + names(file, written.options);
    const std::string head = "controller " + formatted(file, written.name());
    if (!written.instance.valid()) return {head + options + ';'};
    return call(file, head + " = ", written.chart, written.arguments, options + ';', column);
}

Lines item_lines(const tree::File& file, const tree::Grain& written, std::size_t) {
    return {"grain " + formatted(file, written.name) + ';'};
}

Lines item_lines(const tree::File& file, const tree::Schedule& written, std::size_t) {
    return {"schedule " + formatted(file, written.name) + ';'};
}

Lines item_lines(const tree::File& file, const tree::ObserverEdge& written, std::size_t column) {
    const std::string head = formatted(file, written.from) + " -> " + formatted(file, written.to);
    return guarded(file, head, written.condition, written.assignments, column);
}

Lines item_lines(const tree::File& file, const tree::TimeUnit& written, std::size_t) {
    return {"time unit " + formatted(file, written.duration) + ';'};
}

namespace {

/// Returns the lines of an instance. `head` is the text before the name of the component.
Lines instance_lines(const tree::File& file, const std::string& head, const tree::Instance& written,
                     std::size_t column) {
    const std::string tail = written.initial.valid() ? " initially " + formatted(file, written.initial) + ';' : ";";
    return call(file, head, written.component, written.arguments, tail, column);
}

}  // namespace

Lines item_lines(const tree::File& file, const tree::Instance& written, std::size_t column) {
    const std::string head = (written.environment ? "environment " : "plant ") + formatted(file, written.name) + " = ";
    return instance_lines(file, head, written, column);
}

Lines item_lines(const tree::File& file, const tree::Fault& written, std::size_t column) {
    const std::string head =
        "fault " + formatted(file, written.behaviour.name) + " of " + formatted(file, written.of) + ": ";
    return instance_lines(file, head, written.behaviour, column);
}

Lines item_lines(const tree::File& file, const tree::Property& written, std::size_t column) {
    std::string head = "property " + formatted(file, written.name);
    if (!written.text.empty()) head += " \"" + written.text + '"';
    if (written.expected_violated) head += " expected violated";
    head += ':';
    std::vector<std::string> operands;
    for (const Id<tree::Expr> operand : written.operands) operands.push_back(formatted(file, operand));
    const std::string bound = written.bound.valid() ? formatted(file, written.bound) : "";
    const std::string claimed = written.pattern == Pattern::Watched ? claim(written.watch, operands, bound)
                                                                    : claim(written.pattern, operands, written.raw);
    const std::string rest = claimed + (written.at_stable ? " at stable;" : ";");
    if (column + head.size() + 1 + rest.size() <= widest) return {head + ' ' + rest};
    return {head, "    " + rest};
}

Lines item_lines(const tree::File&, const tree::Accept& written, std::size_t) {
    const std::string subject = written.subject.empty() ? "" : ' ' + written.subject;
    return {"accept " + written.code + subject + " \"" + written.reason + "\";"};
}

}  // namespace grafverif
