// SPDX-License-Identifier: MIT
// Ablation: removes one element from a model, to test if a proof needs it.
//
//   a transition          is never cleared
//   a step                has no effect: its continuous and stored actions and its forcing orders are removed
//   a term                one operand of an `and` or `or` is removed; a condition that is neither is removed completely
//   an edge               of one instance is never taken; the instance may stay in its source location forever
//   a guard               of one such edge is ignored: the edge may or may not be taken, within its clock constraint
//   a timing              the clocks of an instance or timer are ignored: each delay is arbitrary, possibly infinite
//   an instance           may be in any location and write any output value at any time
//
// Removing a guard, a timing or an instance over-approximates the loop: all reachable states remain reachable, apart
// from the locations and clocks of a removed instance. Therefore, if a property of all states still holds, it does not
// need the element. Removing any other element gives a model that is not comparable.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Disables a transition by making its condition false.
void drop_transition(Chart& chart, Id<Chart::Transition> transition);

/// Removes the continuous actions and forcing orders of a step, and disables its stored actions. Actions on the
/// clearing of a transition do not belong to a step. If the step has none, returns false and changes nothing.
bool drop_actions(Chart& chart, Id<Chart::Step> step);

/// The position of a term in a chart.
struct TermPlace {
    /// Condition of a transition; of a continuous action; event of a stored action.
    enum class Of { Transition, Action, Event };
    Of of = Of::Transition;
    std::uint32_t index = 0;               ///< index in Chart::transitions, continuous or stored
    std::vector<std::uint32_t> path = {};  ///< operand indices, from the complete condition down to the term
    bool operator==(const TermPlace&) const = default;
};
/// Returns the terms of a chart in the order of transitions, continuous actions, events; outer terms precede inner
/// ones. A term is an operand of an `and` or `or`, at any depth below these operators and `not`, or a condition that is
/// neither of them nor a constant. In events, only operands without an edge are included, because an event must keep an
/// edge.
std::vector<TermPlace> terms_of(const Chart& chart);
Id<Expr> term_at(const Chart& chart, const TermPlace& place);
void remove_term(Chart& chart, const TermPlace& place);

/// True if removing the edge may add behaviour: the edge is forced, or its source location must be left.
bool is_forced(const Component& component, Id<Component::Edge> edge);

/// Gives the instance a separate component in the model, without the edge and without the invariant of its source
/// location.
void drop_edge(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge);

/// True if there is a guard to remove: the guard is not constantly true, or it makes the edge urgent.
bool is_guarded(const Component& component, Id<Component::Edge> edge);

/// Gives the instance a separate component without the guard. After that, the edge need not be taken.
void drop_guard(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge);

/// Returns `changed`, the network of a loop without an edge or a guard, expanded and with the value ranges of
/// `network`, the original. This is necessary because instances of one component share ranges that are wide enough for
/// all of them, and a separate component would have others.
Network with_ranges_of(const Network& network, const Network& changed);

/// Ignores the clocks of a process. Returns true if the process used clocks. This function and the next one require
/// that `network` is expanded.
bool drop_timing(Network& network, Id<Network::Process> process);

/// Removes an instance. `roams` is true if its location is read (by a property, or by `settled`); otherwise it remains
/// in its first location. If it has too many output values, or calls procedures, returns false and changes nothing.
bool drop_instance(Network& network, Id<Network::Process> process, bool roams = true);

}  // namespace grafverif
