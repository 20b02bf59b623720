// SPDX-License-Identifier: MIT
#include "grafverif/ir/finding.hpp"

#include <algorithm>
#include <array>

#include "grafverif/ir/comparison.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

using Level = Finding::Level;

constexpr std::array kinds = {
    FindingKind{"total-instability", Level::Error, "With some constant inputs, the situation never becomes stable."},
    FindingKind{"contradictory-constraints", Level::Error, "No combination of inputs satisfies all constraints."},
    FindingKind{"action-race", Level::Error,
                "Two stored actions write different values to one variable in one evolution."},
    FindingKind{"out-of-range", Level::Error, "A stored action writes a value outside the range of its variable."},
    FindingKind{"no-value", Level::Error,
                "A condition or a stored value divides by zero, or a PLC program has a run-time fault."},
    FindingKind{"forcing-cycle", Level::Error, "Forcing orders form a cycle."},
    FindingKind{"forced-twice", Level::Error,
                "Two forcing orders force one partial chart to different situations at the same time."},
    FindingKind{"forced-and-enclosed", Level::Error,
                "A partial chart is forced while it is also controlled by its enclosing step, which is active."},
    FindingKind{"action-conflict", Level::Warning,
                "A stored action sets an output to a value that is replaced in the same instant, so the plant never "
                "receives this value."},
    FindingKind{"branches-together", Level::Warning, "Two transitions of one divergence are cleared simultaneously."},
    FindingKind{"step-reactivated", Level::Warning, "A step is activated while it is active, and stays active."},
    FindingKind{"step-never-active", Level::Warning, "A step is not active in any reachable situation."},
    FindingKind{"transition-never-fired", Level::Warning, "A transition is never cleared."},
    FindingKind{"output-never-set", Level::Warning, "An output always has its initial value."},
    FindingKind{"statement-never-executed", Level::Warning, "A statement of a PLC program is never executed."},
    FindingKind{"condition-never-true", Level::Warning,
                "A condition of a branch or loop of a PLC program is never true."},
    FindingKind{"condition-always-true", Level::Warning,
                "A condition of a branch or loop of a PLC program is true in each evaluation."},
    FindingKind{"assignment-overwritten", Level::Warning,
                "An assignment to an output in a PLC program has no effect, because the program always assigns the "
                "output again in the same scan before reading it."},
    FindingKind{
        "block-never-called", Level::Warning,
        "In a PLC program, a function block instance, a function, an action or a second program is never called."},
    FindingKind{"variable-never-assigned", Level::Warning,
                "A PLC program reads or outputs a variable that no statement assigns."},
    FindingKind{
        "read-before-assignment", Level::Warning,
        "A PLC program reads a temporary variable, or a variable of a function, before it assigns the variable in "
        "the same call."},
    FindingKind{"timer-never-true", Level::Warning, "The output of a timer of a PLC program is never true."},
    FindingKind{"step-never-again", Level::Warning,
                "A step can be activated repeatedly, but from some situation on it can never be activated again."},
    FindingKind{"transition-never-again", Level::Warning,
                "A transition can be cleared repeatedly, but from some situation on it can never be cleared again."},
    FindingKind{"value-sticks", Level::Warning,
                "A stored value can change repeatedly, but from some situation on it can never change again."},
    FindingKind{"region-never-left", Level::Warning,
                "The chart can reach a set of situations that it can never leave."},
    FindingKind{
        "comes-once", Level::Note,
        "A step is active or a transition is cleared at most once in a run, or a value changes at most once after "
        "the first evolution: the element belongs to a start-up or final phase."},
    FindingKind{"step-never-stable", Level::Note,
                "A step is active only in transient situations, so its continuous actions never set an output."},
    FindingKind{"transition-always-fired", Level::Note,
                "A transition is always cleared in the evolution after it becomes enabled, for all inputs."},
    FindingKind{"input-never-read", Level::Note, "An input is not read by the chart."},
};

}  // namespace

std::span<const FindingKind> finding_kinds() { return kinds; }

bool is_trap(std::string_view code) {
    return code == "step-never-again" || code == "transition-never-again" || code == "value-sticks" ||
           code == "region-never-left";
}

std::string_view word(Finding::Level level) {
    switch (level) {
    case Level::Error: return "error";
    case Level::Warning: return "warning";
    case Level::Note: return "note";
    }
    unreachable();
}

bool is_open(const Finding& finding) { return finding.level != Level::Note && !finding.accepted; }

std::vector<std::string> verify(const Analysis& analysis) {
    std::vector<std::string> faults;
    for (const Finding& finding : analysis.findings) {
        if (std::ranges::find(kinds, finding.code, &FindingKind::code) == kinds.end())
            faults.push_back("there is no code `" + finding.code + "`");
        if (finding.accepted && finding.accepted->empty())
            faults.push_back("`" + finding.code + "` is accepted, but the reason is missing");
        if (!finding.evidence) continue;
        for (const std::string& fault : verify(*finding.evidence))
            faults.push_back("evidence of `" + finding.code + "`: " + fault);
    }
    for (const OpenQuestion& question : analysis.open)
        if (std::ranges::find(kinds, question.code, &FindingKind::code) == kinds.end())
            faults.push_back("an open question has the unknown code `" + question.code + "`");
    if (analysis.open.empty() != analysis.obstacle.empty())
        faults.push_back(analysis.open.empty() ? "there is a reason for open questions, but no open question"
                                               : "there are open questions, but no reason for them");
    return faults;
}

std::string_view word(Comparison::Outcome outcome) {
    switch (outcome) {
    case Comparison::Outcome::Equal: return "equal";
    case Comparison::Outcome::Different: return "different";
    case Comparison::Outcome::Unknown: return "unknown";
    }
    unreachable();
}

std::string_view word(ChartChange::Kind kind) {
    switch (kind) {
    case ChartChange::Kind::Added: return "added";
    case ChartChange::Kind::Removed: return "removed";
    case ChartChange::Kind::Changed: return "changed";
    case ChartChange::Kind::Renamed: return "renamed";
    }
    unreachable();
}

}  // namespace grafverif
