// SPDX-License-Identifier: MIT
// Guided search: a run of the complete network along a run of its input abstraction (ir/network_inputs.hpp).
//
// The abstract run is divided into stages, one per valuation of the steps and internal variables of the controllers.
// The search is best-first: by the last stage that a run has shown, then by the number of variables that differ from
// the next stage, then breadth-first. An autonomous Chosen instance moves only if its outputs are not among those that
// the abstract run samples before the next stage. So a run that is found is a real run, and it is found quickly if the
// abstract run can be stretched in time. If none is found, nothing is proved.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "check/shares.hpp"
#include "check/timed/timed.hpp"
#include "ir/network_inputs.hpp"

namespace grafverif {

/// The abstract run, and the networks that it belongs to.
struct AbstractRun {
    const Network& network;  ///< expanded, in which it was found
    const std::vector<AbstractableProcess>& instances;
    const std::vector<InputLevel>& levels;
    const std::vector<InputChoice>& choices;
    const std::vector<AbstractState>& path;
};

struct FollowLimits {
    std::size_t states = 200'000;
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();  ///< memory of a NoveltySearch
    Deadline deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

/// The steps and internal variables of all controllers.
std::vector<Id<Network::Variable>> signature_variables(const Network& network);

struct ConcreteRun {
    std::optional<Run> run = {};           ///< of the complete network, to a state that decides the property
    std::vector<std::size_t> blamed = {};  ///< without a run: the instances that the last stage waits for
};

/// A place in a run where a single process, given the values of the others, cannot do what the run requires of it.
struct SpuriousMove {
    std::size_t at = 0;     ///< in the path
    InputLevel level = {};  ///< an abstraction with this level excludes this run
};

/// The first such place, if there is one. `waits`: initially, and whenever all PLCs are stable, any time may pass
/// before the run continues. Values that the run does not have (Chosen instances, flags) are any that the process
/// needs. `complete`: the expanded network, whose time unit divides that of the abstract run.
std::optional<SpuriousMove> impossible(const Network& complete, const AbstractRun& abstract, std::size_t instance,
                                       bool waits);

/// `network`: complete, expanded, with the same observer; `property`: one of its properties about single states, or one
/// step of `reachable all steps`.
ConcreteRun follow(const Network& network, const Property& property, const AbstractRun& abstract,
                   const FollowLimits& limits);

}  // namespace grafverif
