// SPDX-License-Identifier: MIT
// Runs NuSMV or nuXmv from the PATH for `check`.
#include <chrono>
#include <sstream>

#include "app/engines.hpp"
#include "app/system/process.hpp"
#include "check/external/nusmv.hpp"
#include "check/vacuity.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "emit/wide.hpp"
#include "support/messages.hpp"

namespace grafverif::app {

std::optional<Report> check_by_nusmv(const SystemToCheck& whole, const std::string& program,
                                     const CheckOptions& options, Diagnostics& diagnostics) {
    const auto path = find_program(program);
    if (!path) {
        diagnostics.add(messages::missing_program(program, "--engine symbolic"));
        return {};
    }
    if (!fits(whole.system, program, diagnostics)) return {};
    TransitionSystem narrow = nusmv::narrow(whole.system);
    add_external_probes(narrow.exprs, narrow.properties, narrow.settled.valid());
    const SystemToCheck check{narrow, whole.charts, whole.abstraction, whole.network};
    const SystemSpelling spelling = nusmv::spelling(check.system);
    const std::vector<std::size_t> properties = selected_properties(check.system, options.properties);
    std::ostringstream model;
    nusmv::emit(check.system, model);
    const TemporaryFolder folder;
    folder.write("model.smv", std::move(model).str());
    folder.write("commands", nusmv_commands("model.smv", spelling, properties));

    const auto start = std::chrono::steady_clock::now();
    const ProgramLimits limits{
        .deadline = options.limits.deadline, .stop = options.limits.stop, .folder = folder.path()};
    const ProgramResult program_result = run_program({path->string(), "-source", "commands"}, "", limits);
    NusmvResult result = read_nusmv(check.system, spelling, properties, program_result);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    SystemReporter reporter(check, SystemReporter::Of::Program, program, options, result.verdicts);
    apply_probes(narrow.properties, result.verdicts);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
        result.verdicts[i].seconds = seconds;
        reporter.add(std::move(result.verdicts[i]), std::move(result.runs[i]));
    }
    reporter.add_omitted();
    return std::move(reporter).report();
}

}  // namespace grafverif::app
