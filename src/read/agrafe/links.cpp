// SPDX-License-Identifier: MIT
// Reads the arcs of an AGRAFE document. A synchronization is the double line of an AND divergence or convergence: it
// links the steps on one side with the transitions on the other side.
#include <string>
#include <unordered_set>

#include "read/agrafe/reader.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

using Kind = AgrafeEntity::Kind;

bool is_node(Kind kind) { return is_step(kind) || kind == Kind::Transition || kind == Kind::Synchronization; }

std::string_view described(Kind kind) {
    return is_step(kind) ? "a step" : kind == Kind::Transition ? "a transition" : "a synchronization";
}

void misplaced(AgrafeReader& reader, pugi::xml_node arc, Kind from, Kind to) {
    std::string what = "this arc leads from ";
    what.append(described(from)).append(" to ").append(described(to));
    reader.diagnostics().add(messages::misplaced_link(
        reader.xml.where(arc), what,
        from == Kind::Transition ? "put a step between the transitions" : "put a transition between the steps"));
}

void read_arc(AgrafeReader& reader, pugi::xml_node arc) {
    const auto source = reader.reference(arc, "source", "step, transition or synchronization", is_node);
    const auto target = reader.reference(arc, "target", "step, transition or synchronization", is_node);
    if (!source || !target) return;
    AgrafeEntity& from = reader.index[*source];
    AgrafeEntity& to = reader.index[*target];
    const bool steps = is_step(from.kind) && is_step(to.kind);
    if (steps || (from.kind == Kind::Transition && to.kind == Kind::Transition))
        return misplaced(reader, arc, from.kind, to.kind);
    if (from.partial != to.partial) {
        reader.diagnostics().add(messages::misplaced_link(reader.xml.where(arc),
                                                          "this arc leads from one partial grafcet to another",
                                                          "link steps and transitions of one partial grafcet"));
        return;
    }
    from.out.push_back(*target);
    to.in.push_back(*source);
}

/// Returns the steps or transitions to which arcs lead from the node `start`, directly or through synchronizations. If
/// `backwards` is true, follows the arcs in the opposite direction.
std::vector<std::size_t> beyond(const AgrafeReader& reader, std::size_t start, bool backwards) {
    std::vector<std::size_t> found, work = {start};
    std::unordered_set<std::size_t> seen = {start};
    for (std::size_t i = 0; i < work.size(); ++i) {
        const AgrafeEntity& at = reader.index[work[i]];
        for (const std::size_t next : backwards ? at.in : at.out) {
            if (!seen.insert(next).second) continue;
            if (reader.index[next].kind == Kind::Synchronization) work.push_back(next);
            else found.push_back(next);
        }
    }
    return found;
}

/// Reports a synchronization that links steps with steps (a transition is missing) or transitions with transitions (a
/// step is missing).
void check_synchronization(AgrafeReader& reader, std::size_t entity) {
    const AgrafeEntity& synchronization = reader.index[entity];
    const auto has = [&](const std::vector<std::size_t>& all, bool steps) {
        for (const std::size_t one : all)
            if (is_step(reader.index[one].kind) == steps) return true;
        return false;
    };
    const std::vector<std::size_t> before = beyond(reader, entity, true), after = beyond(reader, entity, false);
    for (const bool steps : {true, false}) {
        if (!has(before, steps) || !has(after, steps)) continue;
        reader.diagnostics().add(
            messages::misplaced_link(reader.xml.where(synchronization.node),
                                     steps ? "this synchronization leads from steps to steps"
                                           : "this synchronization leads from transitions to transitions",
                                     steps ? "add a transition before or after it" : "add steps before or after it"));
    }
}

}  // namespace

void read_arcs(AgrafeReader& reader) {
    for (std::size_t i = 0; i < reader.index.all().size(); ++i) {
        if (!is_partial(reader.index[i].kind)) continue;
        const pugi::xml_node grafcet = reader.index[i].node;
        for (const pugi::xml_node& node : grafcet.children())
            if (is(node, "arcs")) read_arc(reader, node);
    }
    for (std::size_t i = 0; i < reader.index.all().size(); ++i)
        if (reader.index[i].kind == Kind::Synchronization) check_synchronization(reader, i);
}

std::vector<std::size_t> linked_steps(AgrafeReader& reader, std::size_t transition, bool backwards) {
    std::vector<std::size_t> steps;
    for (const std::size_t one : beyond(reader, transition, backwards))
        if (is_step(reader.index[one].kind)) steps.push_back(one);
    return steps;
}

}  // namespace grafverif
