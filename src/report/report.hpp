// SPDX-License-Identifier: MIT
// Builds the parts of a Report from results of engines. The writers in this folder convert a Report to text, JSON and
// JUnit XML, and a single trace to a waveform and a timing diagram.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/report.hpp"
#include "ir/certificate_summary.hpp"
#include "ir/flat_system.hpp"
#include "report/trace_rows.hpp"

namespace grafverif {

/// Returns the assumptions for the controllers and the granularity of `network`.
CheckSettings settings_of(const Network& network, std::string engine);
/// Returns the assumptions of an untimed check. The granularity (grain) in the result is empty; the caller can set it.
CheckSettings settings_of(const TransitionSystem& system, std::string engine, std::string untimed);

/// Returns `verdict` with the text of its property. The run of the verdict is converted to a trace and removed from the
/// verdict.
PropertyResult result_of(const Network& network, Verdict verdict, Detail detail);
/// Returns the result of an untimed check; `run` is the counterexample or witness.
PropertyResult result_of(const TransitionSystem& system, Verdict verdict, const std::optional<SystemRun>& run,
                         Detail detail);
ModelErrorTrace error_trace_of(const TransitionSystem& system, const SystemFault& fault, Detail detail);
ModelErrorTrace error_trace_of(const Network& network, const ModelError& error, Detail detail);

/// Sets the source positions of the properties and of the profile.
void name_places(Report& report, const Sources& sources);

/// Number of verdicts of each type. An unknown verdict on an undeclared property is only a note.
struct Tally {
    std::size_t holds = 0, violated = 0, unknown = 0, undeclared_unknown = 0;
    std::size_t unexpected = 0;  ///< number of decided verdicts that differ from the expected verdicts
    bool operator==(const Tally&) const = default;
};
Tally tally(const Report& report);

/// Returns what proves a verdict: `set of states`, `run`, `witness circuit` or `none`.
std::string_view certificate_word(const CertificateSummary& certificate, const std::string& property);
/// Returns text about the certificate of a verdict: `set of states in station`, or `none: the verdict is unknown`.
std::string certificate_text(const CertificateSummary& certificate, const std::string& property);

/// True if the report has a verdict on the property, or on one of the steps for which the property is checked (`S.X7`).
/// The result is false if the model of the report omits the property.
bool has_result(const Report& report, const Property& property);

}  // namespace grafverif
