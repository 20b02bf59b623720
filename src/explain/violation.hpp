// SPDX-License-Identifier: MIT
// Explains how a counterexample violates a sentence that an observer checks: `REQ` at 35 s; deadline 66 s; `P_GREEN`
// not true by then.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/property.hpp"

namespace grafverif {

struct SentenceViolation {
    struct Step {
        std::optional<std::size_t> moment = {};  ///< of the run: the state after this event; none: not a single state
        std::string words = {};

        bool operator==(const Step&) const = default;
    };
    std::size_t moment = 0;  ///< of the run: the event from which on the sentence fails
    std::vector<Step> steps = {};

    /// The steps, separated by `; `.
    std::string words() const;
    bool operator==(const SentenceViolation&) const = default;
};

/// Reads the moves of the observer from a run that violates the sentence. `terms`: its operands as conditions write
/// them. Nothing if the run has no observer (for example an untimed run), or none that fails.
std::optional<SentenceViolation> violation_of(const Sentence& sentence, const std::vector<std::string>& terms,
                                              const ChartRun& run);

}  // namespace grafverif
