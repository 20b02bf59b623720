// SPDX-License-Identifier: MIT
// The commands of the command line. Each command reads job.options, adds diagnostics to job.diagnostics, and writes its
// result to streams.out or to files. The caller prints the diagnostics.
#pragma once

#include "app/command_context.hpp"
#include "app/program.hpp"

namespace grafverif::app {

ExitCode init(CommandContext& job, const Streams& streams);
ExitCode build(CommandContext& job, const Streams& streams);
ExitCode uppaal(CommandContext& job, const Streams& streams);
ExitCode nusmv(CommandContext& job, const Streams& streams);
ExitCode aiger(CommandContext& job, const Streams& streams);
ExitCode pins(CommandContext& job, const Streams& streams);
ExitCode btor2(CommandContext& job, const Streams& streams);
ExitCode draw(CommandContext& job, const Streams& streams);
ExitCode equations(CommandContext& job, const Streams& streams);
ExitCode components(CommandContext& job, const Streams& streams);
ExitCode fmt(CommandContext& job, const Streams& streams);
ExitCode import_chart(CommandContext& job, const Streams& streams);
ExitCode check(CommandContext& job, const Streams& streams);
ExitCode report(CommandContext& job, const Streams& streams);
ExitCode simulate(CommandContext& job, const Streams& streams);
ExitCode serve(CommandContext& job, const Streams& streams);
ExitCode edit(CommandContext& job, const Streams& streams);
ExitCode watch(CommandContext& job, const Streams& streams);
ExitCode lsp(CommandContext& job, const Streams& streams);
ExitCode mcp(CommandContext& job, const Streams& streams);
ExitCode analyse(CommandContext& job, const Streams& streams);
ExitCode compare(CommandContext& job, const Streams& streams);
ExitCode mutate(CommandContext& job, const Streams& streams);
ExitCode supervise(CommandContext& job, const Streams& streams);
ExitCode tune(CommandContext& job, const Streams& streams);
ExitCode faults(CommandContext& job, const Streams& streams);
ExitCode automaton(CommandContext& job, const Streams& streams);
ExitCode mealy(CommandContext& job, const Streams& streams);
ExitCode testgen(CommandContext& job, const Streams& streams);
ExitCode replay(CommandContext& job, const Streams& streams);
ExitCode monitor(CommandContext& job, const Streams& streams);
ExitCode plc(CommandContext& job, const Streams& streams);
ExitCode st(CommandContext& job, const Streams& streams);
ExitCode c(CommandContext& job, const Streams& streams);
ExitCode test(CommandContext& job, const Streams& streams);
ExitCode manual(CommandContext& job, const Streams& streams);
ExitCode completion(CommandContext& job, const Streams& streams);

CliCommand init_usage();
CliCommand build_usage();
CliCommand uppaal_usage();
CliCommand nusmv_usage();
CliCommand aiger_usage();
CliCommand pins_usage();
CliCommand btor2_usage();
CliCommand draw_usage();
CliCommand equations_usage();
CliCommand components_usage();
CliCommand fmt_usage();
CliCommand import_usage();
CliCommand check_usage();
CliCommand report_usage();
CliCommand simulate_usage();
CliCommand serve_usage();
CliCommand edit_usage();
CliCommand watch_usage();
CliCommand lsp_usage();
CliCommand mcp_usage();
CliCommand analyse_usage();
CliCommand compare_usage();
CliCommand mutate_usage();
CliCommand supervise_usage();
CliCommand tune_usage();
CliCommand faults_usage();
CliCommand automaton_usage();
CliCommand mealy_usage();
CliCommand testgen_usage();
CliCommand replay_usage();
CliCommand monitor_usage();
CliCommand plc_usage();
CliCommand st_usage();
CliCommand c_usage();
CliCommand test_usage();
CliCommand manual_usage();
CliCommand completion_usage();

/// Appends a list of the written files to the closing text. `build` calls this function after it has written its
/// results.
void list_products(CommandContext& job);

/// Returns the exit code for the result of a comparison.
ExitCode exit_code(const Comparison& comparison);

/// Writes `content` to the file given by `-o`, or to standard output by default.
void deliver(const std::string& content, CommandContext& job, const Streams& streams);

}  // namespace grafverif::app
