// SPDX-License-Identifier: MIT
// The parts of a Report, made of what engines find. The writers of this room turn it into text, JSON and JUnit XML; a
// single trace also into a waveform and a drawing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/report.hpp"
#include "ir/flat_system.hpp"
#include "report/tell.hpp"

namespace grafverif {

/// Of the controllers and the grain of `network`.
Basis basis_of(const Network& network, std::string engine);
/// Of an untimed check; it has no grain of its own unless the caller says so.
Basis basis_of(const TransitionSystem& system, std::string engine, std::string untimed);

/// `verdict` with the text of its property; its run is told, and dropped.
Answer answer_of(const Network& network, Verdict verdict, Detail detail);
/// The same of an untimed check; `run` shows the verdict.
Answer answer_of(const TransitionSystem& system, Verdict verdict, const std::optional<SystemRun>& run, Detail detail);
Breakdown breakdown_of(const TransitionSystem& system, const SystemFault& fault, Detail detail);
Breakdown breakdown_of(const Network& network, const ModelError& error, Detail detail);

/// Where the properties stand, and what is in the profile.
void name_places(Report& report, const Sources& sources);

/// How many verdicts there are of each kind. An unknown verdict that the model does not ask for is only a note.
struct Tally {
    std::size_t holds = 0, violated = 0, unknown = 0, undeclared_unknown = 0;
    std::size_t unexpected = 0;  ///< decided, and not as the model expects
    bool operator==(const Tally&) const = default;
};
Tally tally(const Report& report);

/// Whether the report has a verdict of the property, or of a part of it (`S.X7`); false: its model leaves it out.
bool has_answer(const Report& report, const Property& property);

}  // namespace grafverif
