// SPDX-License-Identifier: MIT
// Searches a complete closed loop for runs, continuing in situations that it has seen rarely.
//
// A breadth-first search of a loop with an operator panel spends its states on combinations of buttons. This search
// orders states by the number of earlier states with the same signature: steps and internal variables of the PLCs,
// locations and variables of the plants. Within a signature, states with fewer moves of autonomous instances come
// first. The order decides only what is found early: each run is one of the loop.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "check/inputs/follow.hpp"

namespace grafverif {

class NoveltySearch {
public:
    /// `network`: complete, expanded, without observers, and must outlive the search. `properties`: about single
    /// states, or one step of `reachable all steps` each.
    NoveltySearch(const Network& network, std::vector<Property> properties,
                  const std::vector<AbstractableProcess>& instances);
    ~NoveltySearch();

    /// Continues up to `limits.states` states in total. False if all states or all required states are found, or the
    /// memory is used.
    bool run(const FollowLimits& limits);
    std::size_t states() const;
    /// The run to a state that decides the property.
    std::optional<Run> run_of(std::size_t property) const;

private:
    class States;
    std::unique_ptr<States> states_;
};

}  // namespace grafverif
