// SPDX-License-Identifier: MIT
// Explains how a counterexample violates a sentence (a property pattern with a scope) that an observer checks. Example:
// `REQ` at 35 s; deadline 66 s; `P_GREEN` not true by then.
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
        /// Index of an event of the run: this explanation step concerns the state after the event. Empty if the
        /// explanation step does not concern a single state.
        std::optional<std::size_t> moment = {};
        std::string words = {};

        bool operator==(const Step&) const = default;
    };
    std::size_t moment = 0;  ///< event of the run after which the sentence fails
    std::vector<Step> steps = {};

    /// Returns the texts of all explanation steps, separated by `; `.
    std::string words() const;
    bool operator==(const SentenceViolation&) const = default;
};

/// Returns the explanation for a run that violates `sentence`, derived from the moves of the observer. `terms` are the
/// operands of the sentence in the notation of conditions. The result is empty if the run contains no moves of an
/// observer, as in an untimed run, or if no observer fails.
std::optional<SentenceViolation> violation_of(const Sentence& sentence, const std::vector<std::string>& terms,
                                              const ChartRun& run);

}  // namespace grafverif
