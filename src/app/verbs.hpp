// SPDX-License-Identifier: MIT
// The commands of the command line. Each reads job.options, adds its diagnostics to job.diagnostics, which the caller
// renders, and writes its result to streams.out or to files.
#pragma once

#include "app/job.hpp"
#include "app/program.hpp"

namespace grafverif::app {

ExitCode init(Job& job, const Streams& streams);
ExitCode build(Job& job, const Streams& streams);
ExitCode uppaal(Job& job, const Streams& streams);
ExitCode nusmv(Job& job, const Streams& streams);
ExitCode aiger(Job& job, const Streams& streams);
ExitCode pins(Job& job, const Streams& streams);
ExitCode btor2(Job& job, const Streams& streams);
ExitCode draw(Job& job, const Streams& streams);
ExitCode equations(Job& job, const Streams& streams);
ExitCode components(Job& job, const Streams& streams);
ExitCode fmt(Job& job, const Streams& streams);
ExitCode import_chart(Job& job, const Streams& streams);
ExitCode check(Job& job, const Streams& streams);
ExitCode report(Job& job, const Streams& streams);
ExitCode simulate(Job& job, const Streams& streams);
ExitCode serve(Job& job, const Streams& streams);
ExitCode watch(Job& job, const Streams& streams);
ExitCode lsp(Job& job, const Streams& streams);
ExitCode analyse(Job& job, const Streams& streams);
ExitCode compare(Job& job, const Streams& streams);
ExitCode mutate(Job& job, const Streams& streams);
ExitCode supervise(Job& job, const Streams& streams);
ExitCode automaton(Job& job, const Streams& streams);
ExitCode mealy(Job& job, const Streams& streams);
ExitCode testgen(Job& job, const Streams& streams);
ExitCode plc(Job& job, const Streams& streams);
ExitCode st(Job& job, const Streams& streams);
ExitCode test(Job& job, const Streams& streams);
ExitCode manual(Job& job, const Streams& streams);
ExitCode completion(Job& job, const Streams& streams);

Verb init_usage();
Verb build_usage();
Verb uppaal_usage();
Verb nusmv_usage();
Verb aiger_usage();
Verb pins_usage();
Verb btor2_usage();
Verb draw_usage();
Verb equations_usage();
Verb components_usage();
Verb fmt_usage();
Verb import_usage();
Verb check_usage();
Verb report_usage();
Verb simulate_usage();
Verb serve_usage();
Verb watch_usage();
Verb lsp_usage();
Verb analyse_usage();
Verb compare_usage();
Verb mutate_usage();
Verb supervise_usage();
Verb automaton_usage();
Verb mealy_usage();
Verb testgen_usage();
Verb plc_usage();
Verb st_usage();
Verb test_usage();
Verb manual_usage();
Verb completion_usage();

/// For `build`, after its results are written: appends their list to the closing text.
void list_products(Job& job);

/// Writes `content` to the file of `-o`, or to standard output by default.
void deliver(const std::string& content, Job& job, const Streams& streams);

}  // namespace grafverif::app
