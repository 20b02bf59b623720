// SPDX-License-Identifier: MIT
#include "report/remedies/trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

/// Returns the verdict on a property as text, such as `opposite holds (43470 states; valid for the timed loop)`.
std::string decided_text(const PropertyResult& answer) {
    const Verdict& verdict = answer.verdict;
    const char* const outcome = verdict.outcome == Outcome::Holds ? "holds" : "is violated";
    std::string more = verdict.states.empty() ? "" : verdict.states + " states";
    if (!answer.preservation.empty()) more += (more.empty() ? "" : "; ") + answer.preservation;
    return fmt::format("{} {}{}{}", verdict.property, outcome, verdict.vacuous ? " vacuously" : "",
                       more.empty() ? "" : " (" + more + ")");
}

}  // namespace

std::vector<std::string> remedies_text(const std::vector<Trial>& trials, bool durations) {
    if (trials.empty()) return {};
    constexpr std::size_t most = 6;  // maximum number of verdicts in one line of text
    const auto duration = [&](std::string_view before, double seconds, std::string_view after) {
        return durations ? fmt::format("{}{:.1f} s{}", before, seconds, after) : "";
    };
    double seconds = 0;
    for (const Trial& trial : trials) seconds += trial.seconds;
    if (trials.front().decided.empty())
        return {
            fmt::format("no remedy was found: {} trial{} with other options{} decided no property; see "
                        "docs/how-to/large-models.md",
                        trials.size(), trials.size() == 1 ? "" : "s", duration(" for ", seconds, ""))};
    std::vector<std::string> lines = {fmt::format("remedies, tried on this model{}:", duration(" for ", seconds, ""))};
    std::string without;
    for (const Trial& trial : trials) {
        std::string verdicts;
        for (std::size_t i = 0; i < std::min(trial.decided.size(), most); ++i)
            verdicts += (i == 0 ? "" : ", ") + decided_text(trial.decided[i]);
        if (trial.decided.size() > most) verdicts += fmt::format(" and {} more verdicts", trial.decided.size() - most);
        if (trial.decided.empty())
            without +=
                fmt::format("{}`{}`{}", without.empty() ? "" : ", ", trial.options, duration(" (", trial.seconds, ")"));
        else lines.push_back(fmt::format("`{}`: {}{}", trial.options, verdicts, duration(", in ", trial.seconds, "")));
    }
    if (!without.empty()) lines.push_back("no verdict with " + without);
    return lines;
}

void print_remedies(const std::vector<Trial>& trials, std::ostream& out) {
    std::string indentation;
    for (const std::string& line : remedies_text(trials)) {
        if (indentation.empty()) out << '\n';
        std::string before = indentation;
        for (const std::string& part : wrapped(line, widest_line - before.size(), widest_line - 8)) {
            out << before << printable(part) << '\n';
            before = "        ";
        }
        indentation = "    ";
    }
}

}  // namespace grafverif
