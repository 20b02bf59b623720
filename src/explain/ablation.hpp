// SPDX-License-Identifier: MIT
// Ablation: removes one element from a model, to test if a proof needs it.
//
//   transition: The transition is never cleared.
//   step: The step has no effect: its continuous and stored actions and its forcing orders are removed.
//   term: One operand of an `and` or `or` is removed. A condition that is neither an `and` nor an `or` is removed
//     completely.
//   statement: An assignment, a call, EXIT or RETURN of a PLC program is not executed.
//   edge: An edge of one instance is never taken; the instance may stay in its source location forever.
//   guard: The guard of one edge of an instance is ignored: within its clock constraint, the edge may or may not be
//     taken.
//   timing: The clocks of an instance or timer are ignored: each of its delays is arbitrary, possibly infinite.
//   instance: The instance may be in any location and write any output value at any time.
//
// Removing a guard, a timing or an instance over-approximates the loop: all reachable states remain reachable, apart
// from the locations and clocks of a removed instance. Therefore, if a property of all states still holds after the
// removal, the proof of the property does not need the removed element. Removing any other element gives a model whose
// behaviour is not comparable with the behaviour of the loop.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// Disables a transition by making its condition false.
void drop_transition(Chart& chart, Id<Chart::Transition> transition);

/// Removes the continuous actions and forcing orders of a step, and disables its stored actions. Actions on the
/// clearing of a transition do not belong to a step. If the step has neither actions nor forcing orders, returns false
/// and changes nothing.
bool drop_actions(Chart& chart, Id<Chart::Step> step);

/// The position of a term in a chart.
struct TermPlace {
    /// Transition: condition of a transition. Action: condition of a continuous action. Event: event of a stored
    /// action.
    enum class Of { Transition, Action, Event };
    Of of = Of::Transition;
    std::uint32_t index = 0;               ///< index in Chart::transitions, continuous or stored
    std::vector<std::uint32_t> path = {};  ///< operand indices, from the complete condition down to the term
    bool operator==(const TermPlace&) const = default;
};
/// Returns the terms of a chart in the order of transitions, continuous actions and events. Outer terms precede inner
/// terms. A term of this list is an operand of an `and` or `or`, at any depth below `and`, `or` and `not`. A complete
/// condition is also a term, unless it is an `and`, an `or` or a constant. In events, only operands without an edge are
/// included, because an event must keep an edge.
std::vector<TermPlace> terms_of(const Chart& chart);
Id<Expr> term_at(const Chart& chart, const TermPlace& place);
/// Returns the name of the element whose condition contains the term, such as `t3` or `OUT in step 5`.
std::string owner_text(const Chart& chart, const TermPlace& place);
void remove_term(Chart& chart, const TermPlace& place);

/// A statement of a program, or a transition of a Sequential Function Chart.
struct ProgramElement {
    bool transition = false;
    std::string name = {};  ///< the text of the statement, or the name of the transition, such as `Idle -> Run`
    Span origin = {};
    /// Contains more than one statement only if the assignment copies an array or a structure.
    std::vector<Id<Program::Statement>> statements = {};
};
/// Returns the statements and transitions that the source of the program contains, in the order of the units. Branches
/// and loops are not elements, but the statements in them are. Standard function blocks have no elements.
std::vector<ProgramElement> elements_of(const Program& program);
/// Removes a statement, or makes the condition of a transition false.
void drop_element(Program& program, const ProgramElement& element);

/// True if removing the edge may add behaviour, because the edge is urgent or its source location has an invariant.
bool is_forced(const Component& component, Id<Component::Edge> edge);

/// Removes an edge of an instance: gives the instance a separate component in the model, without this edge and without
/// the invariant of its source location.
void drop_edge(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge);

/// True if the edge has a guard that can be removed: the guard is not constantly true, or the edge is urgent.
bool is_guarded(const Component& component, Id<Component::Edge> edge);

/// Removes the guard of an edge of an instance: gives the instance a separate component in the model, in which the edge
/// has no guard and is not urgent.
void drop_guard(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge);

/// Returns `changed` in expanded form, with the value ranges of `network`. `changed` is the network of the loop without
/// an edge or a guard; `network` is the original. The ranges of `network` are necessary because all instances of a
/// component have the same ranges, and a separate component can have other ranges.
Network with_ranges_of(const Network& network, const Network& changed);

/// Removes the clocks of a process. Returns true if the process had clocks. This function and drop_instance require
/// that `network` is expanded.
bool drop_timing(Network& network, Id<Network::Process> process);

/// Removes an instance: its outputs may have any value at any time. If `roams` is true, the instance can be in any
/// location; otherwise, the instance remains in its first location. `roams` must be true if a property or the condition
/// `settled` reads the location. If the instance has too many output values, or calls procedures, returns false and
/// changes nothing.
bool drop_instance(Network& network, Id<Network::Process> process, bool roams = true);

}  // namespace grafverif
