// SPDX-License-Identifier: MIT
// Functions that derive models and texts, for callers in grafverif itself. The functions are not part of the public
// API.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/external/verifyta.hpp"
#include "compose/compose.hpp"
#include "emit/aiger/aiger.hpp"
#include "emit/structured_text/structured_text.hpp"
#include "grafverif/grafverif.hpp"
#include "pipeline/files.hpp"
#include "pipeline/untimed.hpp"
#include "read/text.hpp"

namespace grafverif {

/// Returns the context for reading files that `reach` permits. The components of the library are available in the
/// context. `reach` and `folders` must outlive the context.
ReadContext context_of(const Reach& reach, const std::vector<std::string>& folders, bool lossy);

/// Returns the same network as the public network_of, but without those corrections of the published method that
/// `options` disable.
std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, const ComposeOptions& options,
                                  Diagnostics& diagnostics);

/// Translates Equations to the TransitionSystem of a chart without a loop.
TransitionSystem transition_system_of(const Model& model, Id<Chart> chart, const Equations& equations,
                                      std::optional<ExecutionMode> mode);

/// Returns the same system as the public transition_system_of for a closed loop, but with probes (additional properties
/// that detect vacuous verdicts). Use the system only for checking, not for output.
std::optional<TransitionSystem> system_with_probes(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                                   Diagnostics& diagnostics);
/// A function that translates an abstraction of the network of a closed loop to a TransitionSystem (see
/// schedule_abstraction). The result is nullopt if a variable has too many values for a symbolic model.
using AbstractionTranslator = std::function<std::optional<TransitionSystem>(const Network& abstraction)>;
/// Returns a translator of abstractions, which computes the equations of the controllers only once. `model` must
/// outlive the translator.
AbstractionTranslator translator_of_abstractions(const Model& model, Id<ClosedLoop> loop);

/// Returns `network` with the observers of all its properties and with all probes (additional properties that detect
/// vacuous verdicts), for external model checkers.
Network network_with_probes(const Network& network);

/// Returns the charts of the loop's controllers, in order.
std::vector<const Chart*> charts_of(const Model& model, const ClosedLoop& loop);

/// Returns the system to check. `system` is the result of transition_system_of for the loop. All arguments must outlive
/// the result.
SystemToCheck system_to_check(const TransitionSystem& system, const Model& model, Id<ClosedLoop> loop,
                              const ModelOptions& how);

/// The UPPAAL project of a Network, and its queries. Each query is the formula for one verdict.
struct UppaalQueries {
    std::string project = {};
    std::vector<ExternalQuery> questions = {};
};
UppaalQueries uppaal_queries(const Network& network, Diagnostics& diagnostics);

/// Returns the network as a C file for LTSmin.
std::string pins_model(const Network& network);

/// The AIGER file of a TransitionSystem, and a JSON map from the names in the file to the elements of the charts.
/// aiger_model warns about properties that AIGER cannot express.
struct AigerModel {
    std::string text = {}, map = {};
};
AigerModel aiger_model(const TransitionSystem& system, aiger::Form form, Diagnostics& diagnostics);

/// Returns a TransitionSystem as BTOR2. Warns about properties that BTOR2 cannot express.
std::string btor2_model(const TransitionSystem& system, Diagnostics& diagnostics);

/// Returns the same text as the public structured_text_of, in the dialect that `options` selects.
std::optional<std::string> structured_text_of(const Equations& equations, const structured_text::Options& options,
                                              Diagnostics& diagnostics);

/// A controller in C99 (emit/c).
struct CCode {
    std::string header = {}, source = {};
};
/// Returns C code for the controller that a chart describes, or nullopt after an error. The source includes the header
/// by the name `header_name`. If this name is empty, the source has no include directive for the header, and must
/// follow the header text in one file.
std::optional<CCode> c_code_of(const Equations& equations, ExecutionMode mode, std::uint32_t max_evolutions,
                               std::string_view header_name, Diagnostics& diagnostics);

/// Returns a TestSequence as Structured Text.
std::string structured_text_test(const TestSequence& test, structured_text::Form form);

/// Sets the limits common to all engines.
template <class EngineOptions>
void set_limits(EngineOptions& options, const Limits& limits) {
    options.max_memory = limits.memory.value_or(options.max_memory);
    options.deadline = limits.deadline;
    options.stop = limits.stop;
}

}  // namespace grafverif
