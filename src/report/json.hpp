// SPDX-License-Identifier: MIT
// Writes a report as JSON and as JSON lines. Times are in milliseconds; missing values are null.
//
// In JSON, `errors` contains the model errors. The members `profile` (report/profile.hpp), `why` (report/why.hpp) and
// `certificate` exist only if the report contains these data. In a trace, `inputs` and `outputs` of every step contain
// the values of all inputs and outputs by name. `run` is the complete run (docs/reference/trace-format.md).
//
//   {"model", "properties":[PROPERTY], "errors":[{"code", "message", "trace_text", "trace"}], "remedies":[REMEDY],
//   "profile", "why", "certificate":{"folder", "certified":["P"], "omitted":[{"property", "reason"}]}}
//   PROPERTY  {"name", "text", "file", "line", "column", "verdict", "expected", "declared", "engine", "mode", "grain",
//             "states", "transitions", "seconds", "reason", "vacuous", "notes", "assumptions", "trace_text", "trace"}
//   REMEDY    {"options", "decided":[{"name", "verdict", "vacuous", "states", "preservation"}], "seconds"}
//   trace     {"loop_from", "steps":[{"time", "kind", "component", "inputs", "fired", "situation", "outputs",
//             "moment"}], "run"}
//
// PROPERTY also has `cycle` and `constants` if the loop has a task cycle or constants.
// `trace_text` is the table of a trace, line by line. `assumptions` is the model to which the verdict applies, as text.
//
// JSON lines have one object per verdict; only an unexpected verdict has `trace_text`. For a model error or an error in
// the input, `verdict` is `error`, with `code` and `message`.
//
//   {"file", "line", "column", "model", "property", "text", "verdict", "expected", "declared", "as_expected", "engine",
//   "mode", "grain", "states", "seconds", "reason", "vacuous", "notes", "trace_text"}
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/ir/why.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "ir/certificate_summary.hpp"
#include "report/remedies/trials.hpp"
#include "report/report.hpp"
#include "report/report_source.hpp"

namespace grafverif {

/// `sources` are the sources of the model. If `sources` is empty, the report has no positions.
void print_json(const Report& report, const Sources& sources, std::ostream& out, const ProofExplanation* why = nullptr,
                const std::vector<Trial>& trials = {}, const CertificateSummary* certificate = nullptr);
void print_json_lines(const Report& report, const ReportSource& written, std::ostream& out);
/// Prints the errors among `diagnostics`. `file` is the checked file.
void print_json_lines(const std::string& file, const std::vector<Diagnostic>& diagnostics, const Sources& sources,
                      std::ostream& out);

}  // namespace grafverif
