// SPDX-License-Identifier: MIT
#include "pipeline/certificate/fragment_proofs.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "check/localization/faults.hpp"
#include "check/shares.hpp"
#include "check/timed/property_queries.hpp"
#include "ir/network_subsystems.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

constexpr int most_extensions = 4;          // maximum number of times that fragments are added for one property
constexpr std::uint64_t most_alone = 4096;  // maximum number of states of a process alone

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

FragmentProofs::FragmentProofs(const Network& flat, const FragmentLimits& limits)
    : flat_(flat), limits_(limits), cells_(cells_of(flat)) {}

bool FragmentProofs::add(FragmentContent content, const Property* property) {
    content.step = greatest_step(flat_, content);
    FragmentLimits limits = limits_;
    limits.deadline = share_of(limits_.deadline, 4);
    std::optional<FragmentStates> found = fragment_states(flat_, content, bounds_, property, limits);
    if (!found) return false;
    proofs_.push_back({std::move(content), std::move(*found), {}});
    if (property != nullptr) proofs_.back().properties.push_back(*property);
    return true;
}

/// Returns the content of the fragment that corresponds to a localization abstraction. A process reacts if it keeps an
/// omitted variable at a fixed value while time passes, and an urgent edge of the fragment reads this variable.
FragmentContent FragmentProofs::content_of(const LocalNetwork& local) const {
    FragmentContent content = empty_content(flat_);
    std::set<std::string> variables, processes;
    for (const Network::Variable& variable : local.network.variables) variables.insert(variable.name);
    for (const Network::Process& process : local.network.processes) processes.insert(process.name);
    for (const Id<Network::Variable> id : flat_.variables.ids())
        content.variables[id.index] = id != flat_.race && variables.contains(flat_.variables[id].name);
    for (const Id<Network::Process> id : flat_.processes.ids())
        content.locations[id.index] = content.clocks[id.index] = processes.contains(flat_.processes[id].name);
    for (const Id<Network::Process> id : flat_.processes.ids()) {
        if (!content.locations[id.index]) continue;
        for (const Network::Edge& edge : flat_.templates[flat_.processes[id].automaton].edges) {
            if (!edge.urgent) continue;
            for (const Id<Expr> leaf : leaves(flat_.exprs, edge.guard)) {
                const auto variable = static_cast<std::size_t>(flat_.exprs[leaf].value);
                if (flat_.exprs[leaf].op != Op::Variable || content.variables[variable]) continue;
                const std::uint32_t process = cells_.resting[variable].process;
                if (process != NetworkFragments::none && !content.locations[process])
                    content.reacting.insert({process});
            }
        }
    }
    return content;
}

bool FragmentProofs::prove_by_cells(std::vector<std::uint32_t> chosen, const Property* property) {
    for (int extensions = 0; extensions <= most_extensions; ++extensions) {
        std::ranges::sort(chosen);
        std::vector<Property> properties;
        if (property != nullptr) properties.push_back(*property);
        const LocalNetwork local = localized(flat_, cells_, chosen, properties);
        if (add(content_of(local), property)) return true;
        std::vector<std::uint32_t> more;
        const auto add_all = [&](const std::vector<std::uint32_t>& cells) {
            for (const std::uint32_t cell : cells)
                if (std::ranges::find(chosen, cell) == chosen.end()) more.push_back(cell);
        };
        add_all(local.borders);
        if (more.empty()) add_all(local.tied);
        if (more.empty()) return false;
        chosen.insert(chosen.end(), more.begin(), more.end());
    }
    return false;
}

/// Adds the states of a process alone to the bounds, if a state has several values that may exclude each other.
void FragmentProofs::add_bounds(Id<Network::Process> process) {
    if (!bounded_.insert(process).second) return;
    const FragmentContent alone = content_alone(flat_, process);
    if (std::ranges::count(alone.variables, true) < 2) return;
    FragmentLimits limits = limits_;
    limits.states = most_alone;
    limits.attempts = most_alone * 64;
    if (auto found = fragment_states(flat_, alone, {}, nullptr, limits)) bounds_.push_back(std::move(*found));
}

/// Makes all variables unknown that neither the property nor a guard or a known variable of a known process needs.
void FragmentProofs::omit_unread(FragmentContent& content, const Property& property) const {
    std::vector<bool> needed(flat_.variables.size(), false);
    bool grows = true;
    const auto need = [&](Id<Expr> term) {
        for (const Id<Expr> leaf : leaves(flat_.exprs, term)) {
            if (flat_.exprs[leaf].op != Op::Variable) continue;
            const auto variable = static_cast<std::size_t>(flat_.exprs[leaf].value);
            grows = grows || !needed[variable];
            needed[variable] = true;
        }
    };
    std::ranges::for_each(property.operands, need);
    if (property.at_stable) need(flat_.settled);
    while (std::exchange(grows, false))
        for (const Id<Network::Process> id : flat_.processes.ids()) {
            if (!content.locations[id.index]) continue;
            const Slots slots(flat_, id);
            for (const Network::Edge& edge : slots.automaton.edges) {
                need(edge.guard);
                for (const Network::Assignment& assignment : slots.assignments(edge))
                    if (needed[static_cast<std::size_t>(flat_.exprs[assignment.target].value)]) need(assignment.value);
            }
        }
    for (std::size_t variable = 0; variable < needed.size(); ++variable)
        content.variables[variable] = content.variables[variable] && needed[variable];
}

/// Proves the property with the states of an earlier proof.
bool FragmentProofs::prove_again(const Property& property) {
    const auto found = std::ranges::find_if(proofs_, [&](const Proof& proof) {
        return satisfies(flat_, proof.content, bounds_, proof.found, property, limits_);
    });
    if (found != proofs_.end()) found->properties.push_back(property);
    return found != proofs_.end();
}

/// A chosen instance is unknown, with all variables that it writes. In the first attempt, the flags by which it
/// requests a cycle of a PLC are also unknown. An untimed instance has unknown clocks.
bool FragmentProofs::prove_by_inputs(const InputsAbstracted& reduced, const Property& property) {
    if (prove_again(property)) return true;
    for (const bool keeps_flags : {false, true}) {
        FragmentContent content = complete_content(flat_);
        if (flat_.race.valid()) content.variables[flat_.race.index] = false;
        for (const Id<Network::Process> id : flat_.processes.ids()) {
            const std::string& name = flat_.processes[id].name;
            const bool is_chosen = contains(reduced.chosen, name);
            if (!is_chosen && !contains(reduced.untimed, name)) continue;
            content.clocks[id.index] = false;
            if (!is_chosen) continue;
            add_bounds(id);
            content.locations[id.index] = false;
            for (const Id<Network::Variable> variable : Slots(flat_, id).written())
                if (!keeps_flags || flat_.variables[variable].role != Network::Role::Flag)
                    content.variables[variable.index] = false;
        }
        omit_unread(content, property);
        if (add(std::move(content), &property)) return true;
    }
    return false;
}

bool FragmentProofs::prove(const Verdict& reported, const Property& property) {
    if (reported.outcome != (property.pattern == Pattern::Reachable ? Outcome::Violated : Outcome::Holds)) return false;
    const bool about_states = property.pattern == Pattern::Always || property.pattern == Pattern::Never ||
                              property.pattern == Pattern::Reachable || property.pattern == Pattern::ExactlyOneOf;
    if (!about_states || (property.at_stable && !flat_.settled.valid())) return false;
    if (reported.abstraction) return prove_by_inputs(*reported.abstraction, property);
    if (timed::about_race(flat_, property)) {  // no state of a fragment has a race, because a race is a model error
        if (proofs_.empty()) return prove_by_cells({0}, &property);
        proofs_.back().properties.push_back(property);
        return true;
    }
    if (reported.scope.cells) {
        std::vector<std::uint32_t> chosen = cells_read(flat_, cells_, property);
        if (!chosen.empty() && prove_by_cells(chosen, &property)) return true;
        chosen.clear();
        for (std::uint32_t cell = 0; cell < cells_.count; ++cell)
            if (contains(reported.scope.searched, cells_.names[cell])) chosen.push_back(cell);
        return prove_by_cells(chosen, &property);
    }
    if (reported.scope.searched.empty()) return false;
    return add(content_of_parts(parts_read(flat_, parts_of(flat_), property.operands)), &property);
}

bool FragmentProofs::exclude_errors() {
    if (proofs_.empty()) return true;
    const auto open = [&] {
        std::set<std::string> errors = proofs_.front().found.errors;
        for (const Proof& proof : proofs_)
            std::erase_if(errors, [&](const std::string& one) { return !proof.found.errors.contains(one); });
        return errors;
    };
    if (open().empty()) return true;
    for (std::uint32_t cell = 0; cell < cells_.count && !open().empty(); ++cell) {
        const std::size_t before = open().size();
        if (!prove_by_cells({cell}, nullptr)) continue;
        if (open().size() == before) proofs_.pop_back();
    }
    return open().empty();
}

/// Returns the content of some independent subsystems. Temporary variables of other subsystems are unknown.
FragmentContent FragmentProofs::content_of_parts(const std::vector<std::uint32_t>& chosen) const {
    const NetworkSubsystems parts = parts_of(flat_);
    FragmentContent content = empty_content(flat_);
    std::vector<bool> written(flat_.variables.size()), own(flat_.variables.size());
    for (const Id<Network::Process> id : flat_.processes.ids()) {
        const bool kept = std::ranges::find(chosen, parts.of_process[id.index]) != chosen.end();
        content.locations[id.index] = content.clocks[id.index] = kept;
        for (const Id<Network::Variable> variable : Slots(flat_, id).written()) {
            written[variable.index] = true;
            own[variable.index] = own[variable.index] || kept;
        }
    }
    for (const Id<Network::Variable> id : flat_.variables.ids())
        content.variables[id.index] = id != flat_.race && (!written[id.index] || own[id.index]);
    return content;
}

std::optional<std::vector<FragmentStates>> FragmentProofs::subsystems() const {
    std::vector<FragmentStates> all;
    for (std::uint32_t part = 0; part < parts_of(flat_).count; ++part) {
        FragmentContent content = content_of_parts({part});
        content.kind = FragmentKind::Subsystem;
        std::optional<FragmentStates> found = fragment_states(flat_, content, {}, nullptr, limits_);
        if (!found || !found->errors.empty()) return {};
        all.push_back(std::move(*found));
    }
    return all;
}

}  // namespace grafverif
