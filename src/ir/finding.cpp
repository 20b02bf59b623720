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
    FindingKind{"total-instability", Level::Error,
                "With some inputs that do not change the situation never becomes stable."},
    FindingKind{"contradictory-constraints", Level::Error, "No combination of inputs meets all constraints."},
    FindingKind{"action-race", Level::Error,
                "Two stored actions write different values to one variable in one evolution."},
    FindingKind{"out-of-range", Level::Error, "A stored action writes a value outside the range of its variable."},
    FindingKind{"no-value", Level::Error, "A condition or a stored value divides by zero."},
    FindingKind{"forcing-cycle", Level::Error, "Forcing orders force each other in a circle."},
    FindingKind{"forced-twice", Level::Error,
                "Two forcing orders hold one partial chart in different situations at once."},
    FindingKind{"forced-and-enclosed", Level::Error,
                "A partial chart is forced while the step that encloses it is active, which governs it too."},
    FindingKind{"action-conflict", Level::Warning,
                "A value stored in an output is overwritten in the same instant, so that it never gets out."},
    FindingKind{"branches-together", Level::Warning, "Two transitions of one divergence are cleared at once."},
    FindingKind{"step-reactivated", Level::Warning, "A step is activated while it is active, and stays so."},
    FindingKind{"step-never-active", Level::Warning, "A step is active in no situation that can be reached."},
    FindingKind{"transition-never-fired", Level::Warning, "A transition is never cleared."},
    FindingKind{"output-never-set", Level::Warning, "An output always has its initial value."},
    FindingKind{"step-never-again", Level::Warning,
                "A step that can be active again and again is never active again from some situation on."},
    FindingKind{"transition-never-again", Level::Warning,
                "A transition that can be cleared again and again is never cleared again from some situation on."},
    FindingKind{"value-sticks", Level::Warning,
                "A stored value that can change again and again never changes again from some situation on."},
    FindingKind{"region-never-left", Level::Warning,
                "Some situations are never left for the others, though every step can become active in them."},
    FindingKind{"comes-once", Level::Note,
                "A step is active, or a transition cleared, once in a run and never again: a start-up or an end."},
    FindingKind{"step-never-stable", Level::Note,
                "A step is active in transient situations only, so that its continuous actions give no output."},
    FindingKind{"transition-always-fired", Level::Note,
                "A transition is cleared in the very evolution after it becomes enabled."},
    FindingKind{"input-never-read", Level::Note, "Nothing in the chart depends on an input."},
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
            faults.push_back("`" + finding.code + "` is accepted without a reason");
        if (!finding.evidence) continue;
        for (const std::string& fault : verify(*finding.evidence))
            faults.push_back("evidence of `" + finding.code + "`: " + fault);
    }
    for (const OpenQuestion& question : analysis.open)
        if (std::ranges::find(kinds, question.code, &FindingKind::code) == kinds.end())
            faults.push_back("nothing asks for `" + question.code + "`");
    if (analysis.open.empty() != analysis.obstacle.empty())
        faults.push_back("questions are open without a reason, or the other way round");
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
