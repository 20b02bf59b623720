// SPDX-License-Identifier: MIT
// Explains how a counterexample violates a sentence that an observer checks. Example: `REQ` at 35 s; deadline 66 s;
// `P_GREEN` not true by then.
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
        /// Index of an event of the run. The step concerns the state after this event. Empty if the step is not about a
        /// single state.
        std::optional<std::size_t> moment = {};
        std::string words = {};

        bool operator==(const Step&) const = default;
    };
    std::size_t moment = 0;  ///< event of the run after which the sentence fails
    std::vector<Step> steps = {};

    /// Returns the steps, separated by `; `.
    std::string words() const;
    bool operator==(const SentenceViolation&) const = default;
};

/// Returns the explanation for a run that violates `sentence`, derived from the moves of the observer. `terms` are the
/// operands of the sentence in the notation of conditions. The result is empty if the run has no observer (for example
/// an untimed run), or if no observer fails.
std::optional<SentenceViolation> violation_of(const Sentence& sentence, const std::vector<std::string>& terms,
                                              const ChartRun& run);

}  // namespace grafverif
