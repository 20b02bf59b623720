// SPDX-License-Identifier: MIT
// Causes: which values at which moments make a property fail on a run, in the sense of Beer, Ben-David, Chockler, Orni and
// Trefler (Explaining counterexamples using causality, CAV 2009), after Halpern and Pearl. docs/trace.md tells it at length.
//
// A pair is a term of the property that is no conjunction, disjunction or negation, and a state of the run. It is
// bottom-valued where some occurrence of the term, the property in negation normal form, is false there. It is a cause where
// there are bottom-valued pairs, it not among them, such that with their values changed the property still fails on the run,
// and with its value changed as well it does not. Which states are settled is taken as it is.
//
// Of `always`, `never`, `exactly one of` the first state that fails is explained, by its own values; of `leads to` the first
// state that asks and is never answered, by its values and those of all later states: one in a loop is changed in every round.
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
    /// The value of `term` in state `state`.
    struct Pair {
        Id<Expr> term = {};  ///< of the network or the system
        std::size_t state = 0;
        bool operator==(const Pair&) const = default;
    };
    std::vector<Pair> pairs = {};  ///< by state, then in the order of the property
    bool exact = true;  ///< false: a state has too many terms, some of them twice, and the rule of the paper decides

    bool operator==(const Causes&) const = default;
};

/// Of a state with more terms than this the rule of the paper is taken, which is exact where no term comes twice.
inline constexpr std::size_t most_terms = 10;

/// `states`: those of a run (see replay) on which `property` is violated, `loop` the state to which the last one is equal.
/// Nothing for other properties, where some term has no value, or where the run does not show it.
std::optional<Causes> causes_of(const Network& network, const Property& property,
                                const std::vector<NetworkState>& states, std::optional<std::size_t> loop,
                                std::size_t most = most_terms);

/// The same of a run of an untimed model. `loop` is that of the run: no state of it comes twice.
std::optional<Causes> causes_of(const TransitionSystem& system, const Property& property, const SystemRun& run,
                                std::size_t most = most_terms);

/// Marks the values that the terms read in `run`, which is the projection of the same run (`states`, `shown`). What nobody knows by
/// a name of the loop (whose turn it is, the time of a longer term) is not marked, and the causes are not exact.
void mark(const Network& network, const std::vector<NetworkState>& states, const Causes& causes, ChartRun& run);
void mark(const TransitionSystem& system, const SystemRun& shown, const Causes& causes, ChartRun& run);

/// Per state of the run of an untimed model that `run` is the projection of, the moment behind which it stands.
std::vector<std::size_t> moments_of_states(const ChartRun& run);

}  // namespace grafverif
