// SPDX-License-Identifier: MIT
// Drop: a model without one of its elements, to see whether a proof needs it.
//
//   a transition          it is never cleared
//   a step                it does nothing: what it orders while it is active, stores and forces is not done
//   a term                an operand of an `and` or `or` of a condition is missing, or all of a condition that is neither
//   an edge               of one instance: it is never taken, and where it starts the instance may stay for ever
//   a guard               of one such edge: it may be taken, or not, whatever its guard says; clocks limit it as before
//   a timing              clocks have no say in one instance or timer: what takes time there may take any time, or for ever
//   an instance           it is anywhere at any moment, and gives its outputs any value at any moment
//
// Without a guard, a timing or an instance a loop does all that it did, and more: every state that could be reached can be, that
// of an instance left out apart from its own locations and clocks. So what holds in all states without it holds with it, and
// needs it not. A loop without one of the others is another loop.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Its condition is false.
void drop_transition(Chart& chart, Id<Chart::Transition> transition);

/// Its continuous actions and forcing orders are not there, its stored actions never run; those on the clearing of a transition
/// are none of a step. False, and nothing done: it has none.
bool drop_actions(Chart& chart, Id<Chart::Step> step);

/// Where a term stands in a chart.
struct TermPlace {
    enum class Of {
        Transition,
        Action,
        Event
    };  ///< a condition; of a continuous action; what a stored action waits for
    Of of = Of::Transition;
    std::uint32_t index = 0;               ///< in Chart::transitions, continuous, stored
    std::vector<std::uint32_t> path = {};  ///< operands, from the whole condition down to it
    bool operator==(const TermPlace&) const = default;
};
/// In the order of transitions, continuous actions, events; outer ones first. An operand of an `and` or `or` is one, at any
/// depth below these and `not`; so is a condition that is none of both, nor a constant. Of events those without an edge only: an
/// event without one would be none.
std::vector<TermPlace> terms_of(const Chart& chart);
Id<Expr> term_at(const Chart& chart, const TermPlace& place);
void drop_term(Chart& chart, const TermPlace& place);

/// Whether a loop without the edge may do something new: it has to be taken, or something has to be where it starts.
bool is_forced(const Component& component, Id<Component::Edge> edge);

/// In the model the instance gets a component of its own, the same without the edge, and without the invariant of the location
/// where it starts.
void drop_edge(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge);

/// Whether there is a guard to leave out: it is not always true, or makes the edge urgent.
bool is_guarded(const Component& component, Id<Component::Edge> edge);

/// Likewise; without its guard the edge need not be taken.
void drop_guard(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge);

/// Instances of one component share ranges that are wide enough for all; one with a component of its own would have others. So
/// `changed`, the network of a loop without an edge or a guard, is expanded and given the ranges of `network`, its original.
Network with_ranges_of(const Network& network, const Network& changed);

/// `network` is expanded, as below. Whether clocks had a say.
bool drop_timing(Network& network, Id<Network::Process> process);

/// Of an instance. `roams`: somebody asks where it is (a property, or `settled`); else it stays at its first location. False, and
/// nothing done: it has too many values to give, or calls procedures.
bool drop_instance(Network& network, Id<Network::Process> process, bool roams = true);

}  // namespace grafverif
