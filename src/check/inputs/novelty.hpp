// SPDX-License-Identifier: MIT
// NoveltySearch: searches a complete closed loop for runs, and prefers states whose signature has occurred rarely.
//
// In a loop with an operator panel, a breadth-first search mainly finds states that differ in the positions of buttons.
// NoveltySearch orders states by the number of earlier states with the same signature. A signature consists of the
// steps and internal variables of the PLCs and the locations and variables of the plant. Among states with the same
// signature, states with fewer previous moves of autonomous instances come first. The order determines only which runs
// are found early; each run that the search finds is a run of the loop.
//
// For `p leads to q` and `inevitable q`, the search finds violations that end in a state of rest: q is awaited, no urgent
// edge is enabled, and no process is in a location with an invariant, so that time can pass forever without a move. For
// example, the chart waits for an operator who never presses the button.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "check/inputs/follow.hpp"
#include "check/timed/layout.hpp"

namespace grafverif {

/// Returns the fields of a signature: the steps and internal variables of PLCs, and the locations and variables of the
/// instances of the plant. `omitted` has one entry per process: true if the signature does not include the fields of
/// this process.
std::vector<timed::Field> signature_fields(const Network& network, const timed::Layout& layout,
                                           const std::vector<bool>& omitted);
std::uint64_t signature_of(const std::vector<timed::Field>& fields, const timed::Word* words);

class NoveltySearch {
public:
    /// `network` must be expanded, must not be an abstraction, must not have observers, and must outlive the search.
    /// Each property in `properties` concerns single states, is `reachable all steps` for one step, or is `leads to` or
    /// `inevitable` without `at stable`.
    NoveltySearch(const Network& network, std::vector<Property> properties,
                  const std::vector<AbstractableProcess>& instances);
    ~NoveltySearch();

    /// Continues the search up to `limits.states` states in total. Returns false if all states were explored, if a
    /// state that decides each property was found, or if the memory limit is reached.
    bool run(const FollowLimits& limits);
    std::size_t states() const;
    /// Returns the run to a state that decides the property, or nullopt if no such state was found. For `leads to` and
    /// `inevitable`, the run ends with a delay that repeats forever.
    std::optional<Run> run_of(std::size_t property) const;

private:
    class States;
    std::unique_ptr<States> states_;
};

}  // namespace grafverif
