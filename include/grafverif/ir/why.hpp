// SPDX-License-Identifier: MIT
// Why: dependencies of the proofs of a loop's properties, found by removing single elements (docs/explanation/why.md).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

struct ProofExplanation {
    /// A property that holds.
    struct ProofCore {
        std::string property = {};
        /// For a state property: instances and timers without which it fails, while all other behaviour of plant and
        /// timers is arbitrary. Their clocks are also necessary if they are in `timings`.
        std::vector<std::string> parts = {}, timings = {};
        bool about_states = false;           ///< false: parts were not examined
        std::vector<std::string> open = {};  ///< parts without a result
        bool vacuous = false;                ///< its premise is never true
        bool operator==(const ProofCore&) const = default;
    };

    enum class Kind { Transition, Step, Term, Guard, Edge };
    /// A removed element; all others are unchanged (explain/ablation.hpp).
    struct ModelElement {
        Kind kind = Kind::Transition;
        std::string name = {};                    ///< `t3`, `5`, `!a`, `shut -> opening`
        std::string of = {};                      ///< the owner of a term; the instance of an edge
        std::size_t nth = 1;                      ///< index among elements with the same name
        std::vector<std::string> needed_by = {};  ///< properties that fail without it
        std::vector<std::string> open = {};       ///< properties without a result
        bool operator==(const ModelElement&) const = default;
    };

    std::vector<ProofCore> grounds = {};
    std::vector<ModelElement> things = {};         ///< by kind, each in the order of the model
    std::vector<std::string> unneeded_parts = {};  ///< not needed by any of these properties, with all results known
    std::size_t searches = 0;
    std::string ended = {};  ///< reason why not all elements were tried; empty if all were
    bool operator==(const ProofExplanation&) const = default;
};

/// `transition`, `step`, `term`, `guard`, `edge`.
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
