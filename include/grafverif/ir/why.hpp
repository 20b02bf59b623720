// SPDX-License-Identifier: MIT
// ProofExplanation: the model elements that are necessary for the proofs of properties. An element
// is necessary if a property fails when this element alone is removed (docs/explanation/why.md).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/source.hpp"

namespace grafverif {

struct ProofExplanation {
    /// The elements that the proof of one property needs.
    struct ProofCore {
        std::string property = {};
        /// For a state property: the instances and timers that the proof needs if all other instances and timers behave
        /// arbitrarily. `timings` contains the instances of `parts` whose clocks the proof also needs.
        std::vector<std::string> parts = {}, timings = {};
        /// True if the property concerns all states; only then `parts` and `timings` are computed.
        bool about_states = false;
        std::vector<std::string> open = {};  ///< instances and timers for which the result is unknown
        bool vacuous = false;                ///< true if the premise of the property is never true
        bool operator==(const ProofCore&) const = default;
    };

    enum class Kind { Transition, Step, Term, Statement, Guard, Edge };
    /// A model element, and the result of removing only this element (explain/ablation.hpp).
    struct ModelElement {
        Kind kind = Kind::Transition;
        std::string name = {};  ///< text of the element, such as `t3`, `5`, `!a`, `A := B` or `shut -> opening`
        std::string of = {};    ///< owner of a term, instance of an edge, or line of a statement (see name_places)
        std::size_t nth = 1;    ///< number of this element among the elements with the same name, counted from 1
        std::vector<std::string> needed_by = {};  ///< properties that fail if the element is removed
        std::vector<std::string> open = {};       ///< properties whose result is unknown if the element is removed
        Span origin = {};                         ///< position of the element, if it is a statement
        bool operator==(const ModelElement&) const = default;
    };

    std::vector<ProofCore> grounds = {};
    std::vector<ModelElement> things = {};  ///< examined elements, ordered by `kind` and then in the order of the model

    /// Instances and timers that are not necessary for any property in `grounds`. Instances and timers with an unknown
    /// result are not included.
    std::vector<std::string> unneeded_parts = {};
    std::size_t searches = 0;
    std::string ended = {};  ///< reason why some elements were not examined; empty if all elements were examined
    bool operator==(const ProofExplanation&) const = default;
};

/// Returns `transition`, `step`, `term`, `statement`, `guard` or `edge`.
constexpr std::string_view word(ProofExplanation::Kind kind) {
    switch (kind) {
    case ProofExplanation::Kind::Transition: return "transition";
    case ProofExplanation::Kind::Step: return "step";
    case ProofExplanation::Kind::Term: return "term";
    case ProofExplanation::Kind::Statement: return "statement";
    case ProofExplanation::Kind::Guard: return "guard";
    case ProofExplanation::Kind::Edge: return "edge";
    }
    return {};
}

}  // namespace grafverif
