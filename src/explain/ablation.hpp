// SPDX-License-Identifier: MIT
// Ablation: removes one element from a model, to test whether a proof needs it.
//
//   a transition          is never cleared
//   a step                has no effect: its continuous and stored actions and its forcing orders are removed
//   a term                one operand of an `and` or `or` is removed; a condition that is neither is removed completely
//   an edge               of one instance is never taken; the instance may stay in its source location forever
//   a guard               of one such edge is ignored: the edge may or may not be taken, within its clock constraint
//   a timing              the clocks of an instance or timer are ignored: each delay is arbitrary, possibly infinite
//   an instance           may be in any location and write any output value at any time
//
// Removing a guard, a timing or an instance over-approximates the loop: all reachable states stay reachable, up to the
// locations and clocks of a removed instance. So if a property of all states still holds, it does not need the element.
// Removing any other element gives a model that is not comparable.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Makes its condition false.
void drop_transition(Chart& chart, Id<Chart::Transition> transition);

/// Removes its continuous actions and forcing orders, and disables its stored actions; actions on the clearing of a
/// transition do not belong to a step. False, without a change, if it has none.
bool drop_actions(Chart& chart, Id<Chart::Step> step);

/// The location of a term in a chart.
struct TermPlace {
    enum class Of { Transition, Action, Event };  ///< a condition; of a continuous action; the event of a stored action
    Of of = Of::Transition;
    std::uint32_t index = 0;               ///< in Chart::transitions, continuous, stored
    std::vector<std::uint32_t> path = {};  ///< operands, from the complete condition down to the term
    bool operator==(const TermPlace&) const = default;
};
/// In the order of transitions, continuous actions, events; outer terms first. A term is an operand of an `and` or
/// `or`, at any depth below these and `not`, or a condition that is neither of them nor a constant. Of events only
/// operands without an edge: an event must keep one.
std::vector<TermPlace> terms_of(const Chart& chart);
Id<Expr> term_at(const Chart& chart, const TermPlace& place);
void remove_term(Chart& chart, const TermPlace& place);

/// True if removing the edge may add behaviour: the edge is forced, or its source location is.
bool is_forced(const Component& component, Id<Component::Edge> edge);

/// Gives the instance a separate component in the model, without the edge and without the invariant of its source
/// location.
void drop_edge(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge);

/// True if there is a guard to remove: it is not constantly true, or it makes the edge urgent.
bool is_guarded(const Component& component, Id<Component::Edge> edge);

/// Gives the instance a separate component without the guard; the edge need not be taken then.
void drop_guard(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge);

/// Instances of one component share value ranges that are wide enough for all; a separate component would have others.
/// So `changed`, the network of a loop without an edge or a guard, is expanded and given the ranges of `network`, its
/// original.
Network with_ranges_of(const Network& network, const Network& changed);

/// Requires that `network` is expanded, as below. True if the process used clocks.
bool drop_timing(Network& network, Id<Network::Process> process);

/// Removes an instance. `roams`: its location is read (by a property, or by `settled`); otherwise it stays at its first
/// location. False, without a change, if it has too many output values, or calls procedures.
bool drop_instance(Network& network, Id<Network::Process> process, bool roams = true);

}  // namespace grafverif
