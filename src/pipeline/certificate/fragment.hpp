// SPDX-License-Identifier: MIT
// Sets of states of fragments and subsystems of a network, as `grafverif-certify` checks them
// (src/certify/semantics.hpp). The search in this file has the semantics of `grafverif-certify`, but the two programs
// share no code, so that an error in the search does not affect `grafverif-certify`.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

enum class FragmentKind {
    States,    ///< the states prove a property or exclude model errors
    Bounds,    ///< the states restrict the choices of other fragments
    Subsystem  ///< no other process moves, and no unknown value is read
};

/// The variables, locations and clocks that the states of a fragment contain. All others are unknown. In some states,
/// the value of a variable is unknown although its flag is true: the variable is *open*.
struct FragmentContent {
    std::vector<bool> variables = {};              ///< per variable: true if its value is known
    std::vector<bool> locations = {};              ///< per process: true if its location is known
    std::vector<bool> clocks = {};                 ///< per process: true if its clocks are known
    std::set<Id<Network::Process>> reacting = {};  ///< omitted processes whose urgent edges also stop time
    FragmentKind kind = FragmentKind::States;
    std::int64_t step = 1;  ///< duration of a delay, in time units
};

/// Returns the content with all values of a network.
FragmentContent complete_content(const Network& flat);

/// Returns the content without any value of a network.
FragmentContent empty_content(const Network& flat);

/// Returns the content with the location of a process and the variables that only this process writes, as bounds.
FragmentContent content_alone(const Network& flat, Id<Network::Process> process);

/// Returns the greatest step that divides all bounds of known clocks; 1 if a bound is strict.
std::int64_t greatest_step(const Network& flat, const FragmentContent& content);

struct FragmentLimits {
    std::uint64_t states = std::uint64_t{1} << 20U;
    std::uint64_t values = std::uint64_t{1} << 25U;    ///< number of values of all states
    std::uint64_t attempts = std::uint64_t{1} << 27U;  ///< number of attempted moves
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

struct FragmentStates {
    std::vector<std::vector<std::int64_t>> states = {};  ///< each in the form of certificate::state_values
    std::set<std::string> errors = {};                   ///< the model errors that are possible in the fragment
};

/// Returns the states of a fragment that runs reach. The result is empty if a limit is reached, if a subsystem depends
/// on another one, or if some state decides `property` (violates it; for `reachable`: satisfies it). `property` may be
/// null. Choices of unknown values agree with `bounds`, the states of fragments of the kind `Bounds`. Requires that
/// `flat` is expanded.
std::optional<FragmentStates> fragment_states(const Network& flat, const FragmentContent& content,
                                              const std::vector<FragmentStates>& bounds, const Property* property,
                                              const FragmentLimits& limits);

/// True if no state of a fragment decides `property`. The other arguments are those of the call of fragment_states that
/// returned `found`.
bool satisfies(const Network& flat, const FragmentContent& content, const std::vector<FragmentStates>& bounds,
               const FragmentStates& found, const Property& property, const FragmentLimits& limits);

}  // namespace grafverif
