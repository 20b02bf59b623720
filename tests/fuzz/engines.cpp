// SPDX-License-Identifier: MIT
// Fuzz targets that read random bytes as the output of NuSMV and verifyta, because external programs may print
// anything.
#include "check/external/nusmv.hpp"
#include "check/external/verifyta.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "fuzz/common.hpp"
#include "fuzz/targets.hpp"
#include "report/trace_rows.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "support/read_loop.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif::fuzz {

std::string nusmv_complaint(std::string_view bytes) {
    static const LoopUnderTest loop = read_loop(press_text);
    static const TransitionSystem system = untimed_text(press_text, {.plant = PlantApproach::Automata});
    static const SystemSpelling spelling = nusmv::spelling(system);
    static const FlatSystem flat = flattened(system);
    std::vector<std::size_t> properties;
    for (const Id<Property> id : system.properties.ids()) properties.push_back(id.index);
    ProgramResult program_result;
    program_result.out = bytes;
    const NusmvResult result = read_nusmv(system, spelling, properties, program_result);
    if (result.verdicts.size() != properties.size() || result.runs.size() != properties.size())
        return "the number of verdicts or runs is wrong";
    for (std::size_t i = 0; i < properties.size(); ++i) {
        if (!result.total && result.verdicts[i].outcome != Outcome::Unknown)
            return "a verdict on a model with dead ends";
        if (!result.runs[i]) continue;
        const SystemRun& run = *result.runs[i];
        if (run.states.empty() || (run.loop && *run.loop >= run.states.size()))
            return "a run without states, or with a loop to a missing state";
        ChartRun projected = project(system, run);
        if (!disagreement(projected, loop.charts())) with_rows(std::move(projected));
    }
    return {};
}

std::string verifyta_complaint(std::string_view bytes) {
    ProgramResult program_result;
    program_result.out = bytes.substr(0, bytes.find('\0'));
    program_result.err = bytes.substr(program_result.out.size());
    const ExternalResult answer = read_verifyta(program_result);
    const bool known = answer.outcome != Outcome::Unknown;
    if (known != (answer.obstacle == UnknownReason::None) || known != answer.reason.empty())
        return "the verdict and its reason contradict each other: " + answer.reason;
    const bool yes = program_result.out.find("Formula is satisfied.") != std::string::npos,
               no = program_result.out.find("Formula is NOT satisfied.") != std::string::npos;
    if ((answer.outcome == Outcome::Holds && !yes) || (answer.outcome == Outcome::Violated && !no))
        return "a verdict that verifyta did not print";
    return {};
}

}  // namespace grafverif::fuzz
