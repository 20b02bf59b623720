// SPDX-License-Identifier: MIT
// Declares the variables of a controller, role by role.
#include <algorithm>

#include "compose/controller.hpp"
#include "ir/reads.hpp"
#include "ir/shared_by_name.hpp"

namespace grafverif {

namespace {

using Variable = Network::Variable;

std::vector<Id<Equations::Variable>> stored_outputs(const Equations& equations) {
    std::vector<Id<Equations::Variable>> found;
    for (const Equations::Stored& stored : equations.stored)
        if (equations.variables[stored.variable].role == Equations::Role::Output) found.push_back(stored.variable);
    return found;
}

/// Returns the inputs and timer outputs that evolve() or write() reads. Sets `written[v]` for each variable v: true if
/// write() reads v.
std::vector<Id<Equations::Variable>> late_inputs(const Equations& equations, std::vector<bool>& written) {
    std::vector<bool> read(equations.variables.size());
    written.assign(equations.variables.size(), false);
    Reads reads(equations.exprs);
    reads.start();
    const auto evolve = [&](Id<Expr> root) {
        reads.each(root, [&](std::uint32_t variable) { read[variable] = true; });
    };
    evolve(equations.stable);
    for (const Kept& each : kept(equations)) evolve(each.next);
    for (const Fault& fault : faults(equations)) evolve(fault.condition);
    for (const Equations::Stored& stored : equations.stored)
        for (const Equations::Write& write : stored.writes) {
            evolve(write.trigger);
            evolve(write.value);
        }
    reads.start();
    for (const Equations::Output& output : equations.outputs)
        reads.each(output.value, [&](std::uint32_t variable) { written[variable] = true; });

    std::vector<Id<Equations::Variable>> found;
    for (const Id<Equations::Variable> variable : equations.variables.ids()) {
        const Equations::Role role = equations.variables[variable].role;
        const bool late = read[variable.index] || written[variable.index];
        if (late && (role == Equations::Role::Input || role == Equations::Role::TimerEnd)) found.push_back(variable);
    }
    return found;
}

/// Adds the variables of a controller. Their names begin with the prefix of the controller.
class Declarer {
public:
    Declarer(Composition& composition, ControllerParts& parts) : composition_(composition), parts_(parts) {}

    Id<Variable> flag(const char* name) { return fresh({.name = name, .role = Network::Role::Flag}); }

    Id<Variable> fresh(Variable variable) {
        variable.name = composition_.names.fresh(parts_.prefix + variable.name);
        return composition_.network.variables.add(std::move(variable));
    }

    void all_of(Equations::Role role, Network::Role as, bool scratch) {
        for (const Id<Equations::Variable> id : parts_.equations->variables.ids()) {
            const Equations::Variable& from = parts_.equations->variables[id];
            if (from.role != role) continue;
            parts_.variable[id.index] = fresh({from.name, as, from.type, from.initial, scratch, from.origin});
        }
    }

    /// Maps inputs and outputs of the controller to the variables of the plant with the same names.
    void shared(const ClosedLoop& loop) {
        const SharedByName place(loop);
        for (const Id<Equations::Variable> id : parts_.equations->variables.ids()) {
            const Equations::Variable& from = parts_.equations->variables[id];
            if (from.role != Equations::Role::Input && from.role != Equations::Role::Output) continue;
            const Id<ClosedLoop::Shared> known = place(from.name);
            const Network::Role role =
                from.role == Equations::Role::Input ? Network::Role::Input : Network::Role::Output;
            parts_.variable[id.index] = known.valid()
                                            ? Id<Variable>{known.index}
                                            : fresh({from.name, role, from.type, from.initial, false, from.origin});
        }
    }

    void images() {
        for (const Id<Equations::Variable> output : stored_outputs(*parts_.equations)) {
            const Equations::Variable& from = parts_.equations->variables[output];
            parts_.image[output.index] =
                fresh({from.name + "_image", Network::Role::Image, type_of(output), from.initial, false, from.origin});
        }
    }

    void samples() {
        parts_.sampled = late_inputs(*parts_.equations, parts_.sample_written);
        if (parts_.holds_inputs()) hold_inputs();
        for (const Id<Equations::Variable> input : parts_.sampled) {
            const Variable& from = composition_.network.variables[parts_.variable[input.index]];
            Variable sample{parts_.equations->variables[input].name + "_sample",
                            Network::Role::Sample,
                            from.type,
                            0,
                            false,
                            from.origin};
            if (sample.type.low > 0 || sample.type.high < 0) sample.initial = sample.type.low;
            parts_.sample[input.index] = fresh(std::move(sample));
        }
    }

    /// Adds every input to the sampled variables, because all evolutions of a scan read the same inputs. In the atomic
    /// grain, timer outputs need no sample.
    void hold_inputs() {
        const Equations& equations = *parts_.equations;
        const bool atomic = composition_.network.grain == Grain::Atomic;
        std::erase_if(parts_.sampled, [&](Id<Equations::Variable> id) { return atomic || parts_.is_held(id); });
        for (const Id<Equations::Variable> id : equations.variables.ids())
            if (parts_.is_held(id)) parts_.sampled.push_back(id);
        std::ranges::sort(parts_.sampled);
    }

    /// Declares the variables that request a start or stop of timers. For initial steps, the request is set at power-on
    /// or by start().
    void pending() {
        for (const Equations::Timer& timer : parts_.equations->timers) {
            const bool active = !parts_.starts && parts_.equations->variables[timer.watched].initial != 0;
            parts_.pending.push_back(fresh({.name = timer.name + "_P",
                                            .role = Network::Role::TimerPending,
                                            .initial = active,
                                            .origin = timer.origin}));
        }
    }

private:
    Type type_of(Id<Equations::Variable> id) const {
        return composition_.network.variables[parts_.variable[id.index]].type;
    }

    Composition& composition_;
    ControllerParts& parts_;
};

}  // namespace

void declare(Composition& composition, const ClosedLoop& loop, ControllerParts& parts) {
    const std::size_t count = parts.equations->variables.size();
    for (auto* list : {&parts.variable, &parts.image, &parts.sample}) list->resize(count);
    const bool phased = composition.network.grain == Grain::Phased;
    Declarer add(composition, parts);
    add.shared(loop);
    add.all_of(Equations::Role::Step, Network::Role::Step, false);
    add.all_of(Equations::Role::Internal, Network::Role::Internal, false);
    add.all_of(Equations::Role::FiringCondition, Network::Role::FiringCondition, !phased);
    add.all_of(Equations::Role::Previous, Network::Role::Previous, false);
    add.all_of(Equations::Role::Watched, Network::Role::Watched, false);
    add.all_of(Equations::Role::TimerEnd, Network::Role::TimerEnd, false);
    if (!composition.ablations.timers_as_published) add.pending();
    add.images();
    if (phased || parts.holds_inputs()) add.samples();
    if (!parts.cycle) parts.evol_pl = add.flag("EVOL_PL");
    if (!parts.cycle && !parts.equations->timers.empty()) parts.evol_ti = add.flag("EVOL_TI");
    parts.stable = add.flag("stable");
}

}  // namespace grafverif
