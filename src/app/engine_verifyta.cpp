// SPDX-License-Identifier: MIT
// `check --engine verifyta`: writes the UPPAAL project to a temporary folder and runs verifyta on it once per query.
// The implementation relies only on documented behaviour of verifyta. The licence of verifyta forbids its use in
// automated tests; therefore the tests use a replacement program.
#include "app/engines.hpp"
#include "app/system/process.hpp"
#include "check/external/verifyta.hpp"
#include "pipeline/models.hpp"
#include "report/report.hpp"
#include "support/messages.hpp"

namespace grafverif::app {

std::optional<Report> check_by_verifyta(const LoopToCheck& loop, const CheckOptions& check, Diagnostics& diagnostics) {
    const auto program = find_program("verifyta");
    if (!program) {
        diagnostics.add(messages::missing_program("verifyta", "--engine timed"));
        return {};
    }
    const Network network = network_with_probes(loop.network);
    const UppaalQueries uppaal = uppaal_queries(network, diagnostics);
    if (diagnostics.has_errors()) return {};
    const TemporaryFolder folder;
    folder.write("model.xml", uppaal.project);
    const ProgramLimits limits{.deadline = check.limits.deadline, .stop = check.limits.stop, .folder = folder.path()};

    ExternalOptions options{.properties = check.properties};
    options.run = [&](const std::string& formula) {
        folder.write("query.q", formula + '\n');
        return run_program({program->string(), "model.xml", "query.q"}, "", limits);
    };
    Report report{network.name, settings_of(network, "verifyta")};
    for (Verdict& verdict : check_verifyta(network, uppaal.questions, options))
        report.answers.push_back(result_of(network, std::move(verdict), Detail::Chart));
    return report;
}

}  // namespace grafverif::app
