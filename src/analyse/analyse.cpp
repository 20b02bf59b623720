// SPDX-License-Identifier: MIT
#include "grafverif/analyse/analyse.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "analyse/analyst.hpp"
#include "analyse/structure.hpp"

namespace grafverif {

namespace {

using analysis::Analyst;
using analysis::Machine;
using analysis::Search;

std::size_t place(const Finding& finding) {
    return static_cast<std::size_t>(std::ranges::find(finding_kinds(), finding.code, &FindingKind::code) -
                                    finding_kinds().begin());
}

void sort(std::vector<Finding>& findings) {
    std::ranges::stable_sort(findings, {}, [](const Finding& finding) {
        return std::tuple(finding.level, place(finding), finding.origin.begin, finding.subject);
    });
}

void add_structural(const Chart& chart, const Equations& equations, Analysis& result) {
    const std::vector<bool> read = analysis::variables_read(equations);
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        const Chart::Variable& variable = chart.variables[id];
        if (variable.kind != Chart::VariableKind::Input || read[id.index]) continue;
        result.findings.push_back({"input-never-read", Finding::Level::Note, variable.name,
                                   "nothing depends on the input `" + variable.name + "`", variable.origin});
    }
    for (const std::vector<Id<Chart::ForcingOrder>>& cycle : analysis::forcing_cycles(chart)) {
        const auto partial = [&](Id<Chart::ForcingOrder> order) { return chart.partial_charts[chart.forcing[order].forced].name; };
        std::string path = "`" + partial(cycle.back()) + "`";
        for (const Id<Chart::ForcingOrder> order : cycle) path += " forces `" + partial(order) + "`";
        Finding made{"forcing-cycle", Finding::Level::Error, partial(cycle.front()), path + ": orders form no circle",
                     chart.forcing[cycle.front()].origin};
        for (std::size_t k = 1; k < cycle.size(); ++k)
            made.related.push_back({chart.forcing[cycle[k]].origin, "the next order is here"});
        result.findings.push_back(std::move(made));
    }
}

std::string obstacle_text(const BddExhausted& exhausted, const AnalyseOptions& options) {
    if (exhausted.cause() == BddExhausted::Cause::Stopped) return "stopped before the end";
    return "the memory allowed, " + std::to_string(options.max_memory >> 20U) + " MiB, is used up";
}

void search(const Chart& chart, const Equations& equations, const AnalyseOptions& options, Analysis& result) {
    BddSpace space({options.max_memory, options.deadline, options.stop});
    try {
        Machine machine(equations, options, space);
        if (machine.possible().is_false()) {
            result.findings.push_back({"contradictory-constraints", Finding::Level::Error, "",
                                       "no combination of inputs meets all constraints and exclusions", chart.origin});
            return;
        }
        Search found(machine, options.mode);
        try {
            found.run();
        } catch (const BddExhausted& exhausted) {
            result.obstacle = obstacle_text(exhausted, options);
        }
        result.instants = found.instants().size();
        Analyst(chart, equations, options, machine, found, result.obstacle.empty(), result).ask();
        result.bytes = space.bytes();
    } catch (const BddExhausted& exhausted) {
        result.obstacle = obstacle_text(exhausted, options);
    }
}

void accept(const Chart& chart, Analysis& result) {
    for (const Chart::Acceptance& acceptance : chart.accepted) {
        bool any = false;
        for (Finding& finding : result.findings) {
            if (finding.code != acceptance.code) continue;
            if (!acceptance.subject.empty() && acceptance.subject != finding.subject) continue;
            finding.accepted = acceptance.reason;
            any = true;
        }
        if (!any && result.obstacle.empty())
            result.notes.push_back("there is nothing that `accept " + acceptance.code +
                                   (acceptance.subject.empty() ? "" : " " + acceptance.subject) + "` accepts");
    }
}

void add_notes(const Equations& equations, const AnalyseOptions& options, Analysis& result) {
    result.notes.emplace_back(options.mode == ExecutionMode::StabilitySearch
                                  ? "inputs change between stable situations only (IEC 60848); cycle time is zero"
                                  : "one evolution per cycle, inputs sampled in each");
    const auto is_break = [](const Finding& finding) {
        return finding.code == "action-race" || finding.code == "out-of-range" || finding.code == "no-value" ||
               finding.code == "forced-twice";
    };
    if (std::ranges::any_of(result.findings, is_break))
        result.notes.emplace_back("nothing is looked at beyond a race, orders that exclude each other or a value that does not fit; what is said never to "
                                  "happen does not happen without them");
    if (!equations.assumptions.empty() || !options.exclusions.empty())
        result.notes.push_back("inputs are limited by " + std::to_string(equations.assumptions.size()) +
                               " constraints and " + std::to_string(options.exclusions.size()) + " exclusions");
}

}  // namespace

Analysis analyse(const Chart& chart, const Equations& equations, const AnalyseOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    Analysis result;
    result.chart = chart.name;
    result.mode = options.mode;
    add_structural(chart, equations, result);
    search(chart, equations, options, result);
    sort(result.findings);
    add_notes(equations, options, result);
    accept(chart, result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace grafverif
