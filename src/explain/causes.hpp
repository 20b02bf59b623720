// SPDX-License-Identifier: MIT
// Causes: the values, with their times, that cause a run to violate a property. Source: Beer, Ben-David, Chockler, Orni
// and Trefler (Explaining counterexamples using causality, CAV 2009), after Halpern and Pearl.
// docs/reference/trace-format.md explains the details.
//
// A pair consists of a state of the run and a term of the property that is not a conjunction, disjunction or negation.
// A pair is bottom-valued if, in the negation normal form of the property, at least one occurrence of the term is false
// in the state. A pair is a cause if there is a set of other bottom-valued pairs with the following effect. If only the
// values of the pairs in the set are changed, the property still fails on the run. If the value of the pair itself is
// also changed, the property does not fail. The changes do not affect which states are quiescent.
//
// For `always`, `never` and `exactly one of`, the causes are values of the first state that violates the property. For
// `leads to`, the causes are values of the first state that satisfies the premise without a response, and of all later
// states. A change of a value in the loop of the run applies to every iteration of the loop.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "ir/flat_system.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

struct Causes {
    /// A cause: the value of `term` in state `state`.
    struct Pair {
        Id<Expr> term = {};  ///< term over the variables of the network or system
        std::size_t state = 0;
        bool operator==(const Pair&) const = default;
    };
    std::vector<Pair> pairs = {};  ///< ordered by state, then as in the property

    /// False if a state has more terms than the maximum `most`, and some of these terms are repeated. For a state with
    /// repeated terms, the causes were computed by the rule of the paper, which is not exact if terms are repeated.
    bool exact = true;

    bool operator==(const Causes&) const = default;
};

/// Maximum number of terms of a state. For a state with more terms, the rule of the paper is used, which is exact if no
/// term is repeated.
inline constexpr std::size_t most_terms = 10;

/// Returns the causes. `states` are the states of a run (see replay) that violates `property`; `loop` is the index of
/// the state that equals the last state. The result is empty if the run does not violate the property, if some term is
/// undefined, or if no causes are defined above for the pattern.
std::optional<Causes> causes_of(const Network& network, const Property& property,
                                const std::vector<NetworkState>& states, std::optional<std::size_t> loop,
                                std::size_t most = most_terms);

/// Returns the causes in a run of an untimed model. In contrast to the states of a network run, a SystemRun does not
/// contain the first state of its loop a second time.
std::optional<Causes> causes_of(const TransitionSystem& system, const Property& property, const SystemRun& run,
                                std::size_t most = most_terms);

/// Marks in `run` the values that the terms of the causes read. `run` is the projection of the same run (`states`,
/// `shown`). A value without a name in the loop, such as the choice of the scheduler or the time of a longer term, is
/// not marked. If a value without a name is a cause, the causes in `run` are recorded as not exact.
void mark(const Network& network, const std::vector<NetworkState>& states, const Causes& causes, ChartRun& run);
void mark(const TransitionSystem& system, const SystemRun& shown, const Causes& causes, ChartRun& run);

/// Returns, for each state of a run of an untimed model, the event of `run` that leads to the state. `run` is the
/// projection of the run of the model.
std::vector<std::size_t> events_of_states(const ChartRun& run);

}  // namespace grafverif
