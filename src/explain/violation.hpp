// SPDX-License-Identifier: MIT
// How a counterexample violates a sentence that an observer checks: `REQ` at 35 s; deadline 66 s; `P_GREEN` not true by then.
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
        std::optional<std::size_t> moment = {};  ///< of the run, the state behind it; none: no single one
        std::string words = {};

        bool operator==(const Step&) const = default;
    };
    std::size_t moment = 0;  ///< of the run: from here on the sentence fails
    std::vector<Step> steps = {};

    /// The steps, with `; ` between them.
    std::string words() const;
    bool operator==(const SentenceViolation&) const = default;
};

/// Reads the moves of the observer from a run that violates the sentence. `terms`: its operands as conditions write them.
/// Nothing where the run shows no observer, as an untimed one, or none that fails.
std::optional<SentenceViolation> violation_of(const Sentence& sentence, const std::vector<std::string>& terms,
                                              const ChartRun& run);

}  // namespace grafverif
