// SPDX-License-Identifier: MIT
// ProofExplanation: model elements that the proofs of properties need, found by removing each
// (docs/explanation/why.md).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

struct ProofExplanation {
    /// Dependencies of the proof of one property that holds.
    struct ProofCore {
        std::string property = {};
        /// For a state property: instances and timers without which it fails, if all other behaviour of plant and
        /// timers is arbitrary. The clocks of those in `timings` are also necessary.
        std::vector<std::string> parts = {}, timings = {};
        bool about_states = false;           ///< false if parts were not examined
        std::vector<std::string> open = {};  ///< parts for which the result is unknown
        bool vacuous = false;                ///< true if its premise is never true
        bool operator==(const ProofCore&) const = default;
    };

    enum class Kind { Transition, Step, Term, Guard, Edge };
    /// A model element that is removed while all others are unchanged (explain/ablation.hpp).
    struct ModelElement {
        Kind kind = Kind::Transition;
        std::string name = {};                    ///< `t3`, `5`, `!a`, `shut -> opening`
        std::string of = {};                      ///< the owner of a term, or the instance of an edge
        std::size_t nth = 1;                      ///< index among elements with the same name
        std::vector<std::string> needed_by = {};  ///< properties that fail without it
        std::vector<std::string> open = {};       ///< properties for which the result is unknown
        bool operator==(const ModelElement&) const = default;
    };

    std::vector<ProofCore> grounds = {};
    std::vector<ModelElement> things = {};         ///< elements by kind, each kind in the order of the model
    std::vector<std::string> unneeded_parts = {};  ///< parts that none of these properties needs; all results are known
    std::size_t searches = 0;
    std::string ended = {};  ///< reason why some elements were not examined; empty if all were
    bool operator==(const ProofExplanation&) const = default;
};

/// Returns `transition`, `step`, `term`, `guard` or `edge`.
constexpr std::string_view word(ProofExplanation::Kind kind) {
    switch (kind) {
    case ProofExplanation::Kind::Transition: return "transition";
    case ProofExplanation::Kind::Step: return "step";
    case ProofExplanation::Kind::Term: return "term";
    case ProofExplanation::Kind::Guard: return "guard";
    case ProofExplanation::Kind::Edge: return "edge";
    }
    return {};
}

}  // namespace grafverif
