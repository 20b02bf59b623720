// SPDX-License-Identifier: MIT
#include "compose/procedures.hpp"

#include <algorithm>

#include "compose/simultaneous.hpp"
#include "ir/literal.hpp"
#include "ir/reads.hpp"

namespace grafverif {

namespace {

using Assignments = std::vector<Network::Assignment>;
using VariableId = Id<Equations::Variable>;

/// An assignment of a new value to `target`. All terms refer to the values before the procedure.
struct Update {
    VariableId target = {};
    std::vector<Id<Expr>> terms = {};
};

class Builder {
public:
    Builder(Composition& composition, const ControllerParts& parts)
        : composition_(composition),
          network_(composition.network),
          equations_(*parts.equations),
          parts_(parts),
          phased_(network_.grain == Grain::Phased),
          every_cycle_(parts.mode == ExecutionMode::EveryCycle),
          kept_(kept(equations_)),
          stored_(equations_.variables.size()),
          old_(equations_.variables.size()) {}

    Procedures build() {
        for (const VariableId variable : equations_.variables.ids())
            stored_[variable.index] = leaf_of(storage(variable));
        Procedures result;
        result.fire = fire();
        result.evolve = evolve();
        result.write = write();
        for (const VariableId input : parts_.sampled)
            if (is_written_late(input)) result.forget.push_back(forgotten(input));
        result.sample = sample();
        if (parts_.starts) result.start = start();
        return result;
    }

private:
    Exprs& exprs() { return network_.exprs; }
    Id<Expr> leaf_of(Id<Network::Variable> variable) { return leaf(network_, variable); }

    /// True for an input that is not held for all evolutions of a scan and whose sample write() reads.
    bool is_written_late(VariableId input) const {
        return parts_.sample_written[input.index] && !parts_.is_held(input);
    }

    /// Returns the network variable that stores the value of `variable` within the controller: the image of an output
    /// with stored actions, the sample of a held input, otherwise the variable itself.
    Id<Network::Variable> storage(VariableId variable) const {
        if (parts_.is_held(variable)) return parts_.sample[variable.index];
        const Id<Network::Variable> image = parts_.image[variable.index];
        return image.valid() ? image : parts_.variable[variable.index];
    }

    /// Returns a copier of terms that translates the equations to the network. Inputs are read directly or from their
    /// samples; for variables in `olds`, the old value is read.
    TermCopier reading(bool sampled, const std::vector<VariableId>& olds = {}) {
        std::vector<Id<Expr>> leaves = stored_;
        if (sampled)
            for (const VariableId input : parts_.sampled) leaves[input.index] = leaf_of(parts_.sample[input.index]);
        for (const VariableId variable : olds) leaves[variable.index] = leaf_of(old_[variable.index]);
        return {equations_.exprs, exprs(), [leaves = std::move(leaves)](const Expr& node) {
                    return leaves[static_cast<std::size_t>(node.value)];
                }};
    }

    Network::Assignment forgotten(VariableId input) {
        const Network::Variable sample = network_.variables[parts_.sample[input.index]];
        return {leaf_of(parts_.sample[input.index]), literal(exprs(), sample.type, sample.initial)};
    }

    Network::Assignment sampled(VariableId input) {
        return {leaf_of(parts_.sample[input.index]), leaf_of(parts_.variable[input.index])};
    }

    /// Returns the assignments that sample the inputs that are held for all evolutions of a scan.
    Assignments sample() {
        Assignments list;
        for (const VariableId input : parts_.sampled)
            if (parts_.is_held(input)) list.push_back(sampled(input));
        return list;
    }

    Assignments fire() {
        Assignments list;
        TermCopier now = reading(false);
        list.reserve(equations_.firings.size() + parts_.sampled.size());
        for (const Equations::Firing& firing : equations_.firings)
            list.push_back({stored_[firing.variable.index], now(firing.condition)});
        for (const VariableId input : parts_.sampled)
            if (!parts_.is_held(input)) list.push_back(sampled(input));
        return list;
    }

    /// Returns the assignments that update step activities, stored variables, `stable` and timer requests. All new
    /// values are computed from the values before the cycle.
    Assignments evolve() {
        if (equations_.is_program) return scan(false);
        TermCopier before = reading(true);
        Assignments list = pending(before);
        list.push_back({leaf_of(parts_.stable), before(equations_.stable)});
        note_race(&Fault::condition, before, list);

        std::vector<Update> updates;
        for (const Equations::Stored& stored : equations_.stored)
            for (const Equations::Write& write : stored.writes)
                updates.push_back({stored.variable, {write.trigger, write.value}});
        for (std::size_t k = equations_.stored.size(); k < kept_.size(); ++k)
            if (!kept_[k].after) updates.push_back({kept_[k].variable, {kept_[k].next}});
        const std::vector<VariableId> olds = keep_old(updates, list);
        TermCopier kept = reading(true, olds);
        TermCopier& old = olds.empty() ? before : kept;
        for (const Update& update : updates) {
            const Id<Expr> target = stored_[update.target.index];
            const bool is_write = update.terms.size() == 2;
            list.push_back(
                {target, is_write ? stored(target, old(update.terms[0]), old(update.terms[1])) : old(update.terms[0])});
        }
        watch(true, list);
        if (!phased_) return list;
        for (const Equations::Firing& firing : equations_.firings)
            list.push_back({stored_[firing.variable.index], exprs().constant(false)});
        forget_samples(list);
        return list;
    }

    /// Adds assignments that reset the samples that only evolve() reads, because equal states must not differ in unused
    /// samples.
    void forget_samples(Assignments& list) {
        for (const VariableId input : parts_.sampled)
            if (!parts_.sample_written[input.index] && !parts_.is_held(input)) list.push_back(forgotten(input));
    }

    /// Returns the assignments of one scan of a program: the scan at power-on if `first` is true, otherwise a later
    /// scan in evolve(). A scan with a run-time fault changes no variable of the program, because its results are
    /// unspecified and no property must read them.
    Assignments scan(bool first) {
        TermCopier before = reading(!first);
        Assignments updates;
        if (!first) updates.push_back({leaf_of(parts_.stable), before(equations_.stable)});
        Id<Expr> Fault::*const condition = first ? &Fault::first : &Fault::condition;
        note_race(condition, before, updates);
        std::vector<Id<Expr>> conditions;
        for (const Fault& fault : faults(equations_))
            if ((fault.*condition).valid()) conditions.push_back(before(fault.*condition));
        const Id<Expr> faulty = exprs().disjunction(conditions);
        for (const Kept& each : kept_) {
            const Id<Expr> next = first ? each.first : each.next, target = stored_[each.variable.index];
            if (next.valid()) updates.push_back({target, exprs().conditional(faulty, target, before(next))});
        }
        Assignments list = simultaneous(composition_, updates, parts_.prefix);
        if (phased_ && !first) forget_samples(list);
        return list;
    }

    /// Returns a term for the value of `target`: `value` if `trigger` holds, otherwise the current value.
    Id<Expr> stored(Id<Expr> target, Id<Expr> trigger, Id<Expr> value) {
        if (is_true(exprs(), value)) return exprs().disjunction(target, trigger);
        if (is_false(exprs(), value)) return exprs().conjunction(target, exprs().negation(trigger));
        return exprs().conditional(trigger, value, target);
    }

    /// Adds assignments that update the observed levels after the current procedure, and that send requests to the
    /// timers whose levels have changed.
    void watch(bool sampled, Assignments& list) {
        if (equations_.watches.empty()) return;
        TermCopier after = reading(sampled);
        for (const Equations::ObservedTerm& watch : equations_.watches) {
            const Id<Expr> level = stored_[watch.variable.index];
            const Id<Expr> now = after(watch.value);
            for (std::size_t i = 0; i < parts_.pending.size(); ++i)
                if (equations_.timers[i].watched == watch.variable)
                    list.push_back({leaf_of(parts_.pending[i]), exprs().apply(Op::NotEqual, now, level)});
            list.push_back({level, now});
        }
    }

    /// Returns the assignments that send requests to the timers of steps whose activity changes.
    Assignments pending(TermCopier& before) {
        Assignments list;
        if (parts_.pending.empty()) return list;
        std::vector<const Equations::StepActivity*> activity(equations_.variables.size(), nullptr);
        for (const Equations::StepActivity& step : equations_.steps) activity[step.variable.index] = &step;
        for (std::size_t i = 0; i < equations_.timers.size(); ++i) {
            const Equations::StepActivity* const step = activity[equations_.timers[i].watched.index];
            if (step == nullptr) continue;
            const Id<Expr> changed = exprs().disjunction(before(step->activated), before(step->deactivated));
            list.push_back({leaf_of(parts_.pending[i]), changed});
        }
        return list;
    }

    void note_race(Id<Expr> Fault::*condition, TermCopier& copy, Assignments& list) {
        std::vector<Id<Expr>> races;
        for (const Fault& fault : faults(equations_))
            if ((fault.*condition).valid()) races.push_back(copy(fault.*condition));
        if (!composition_.race.valid() || exprs().disjunction(races) == exprs().constant(false)) return;
        races.insert(races.begin(), leaf_of(composition_.race));
        list.push_back({races.front(), exprs().disjunction(races)});
    }

    /// Returns the variables that an update reads after an earlier update has overwritten them. Adds assignments that
    /// first store the old values of these variables.
    std::vector<VariableId> keep_old(const std::vector<Update>& updates, Assignments& list) {
        std::vector<bool> overwritten(equations_.variables.size()), kept(equations_.variables.size());
        std::vector<VariableId> olds;
        Reads reads(equations_.exprs);
        for (const Update& update : updates) {
            reads.start();
            for (const Id<Expr> term : update.terms) {
                reads.each(term, [&](std::uint32_t variable) {
                    if (!overwritten[variable] || kept[variable]) return;
                    kept[variable] = true;
                    olds.push_back({variable});
                });
            }
            overwritten[update.target.index] = true;
        }
        std::ranges::sort(olds);
        for (const VariableId variable : olds) list.push_back({leaf_of(old(variable)), leaf_of(storage(variable))});
        return olds;
    }

    Id<Network::Variable> old(VariableId variable) {
        Id<Network::Variable>& scratch = old_[variable.index];
        if (scratch.valid()) return scratch;
        const Network::Variable now = network_.variables[storage(variable)];
        const std::string name = parts_.prefix + equations_.variables[variable].name + "_old";
        scratch =
            network_.variables.add({composition_.names.fresh(name), now.role, now.type, now.initial, true, now.origin});
        return scratch;
    }

    Assignments write() {
        Assignments list;
        TermCopier after = reading(true);
        for (const Equations::Output& output : equations_.outputs)
            put(parts_.variable[output.variable.index], after(output.value), list);
        for (const Equations::Stored& stored : equations_.stored)
            if (const auto image = parts_.image[stored.variable.index]; image.valid())
                put(parts_.variable[stored.variable.index], leaf_of(image), list);
        for (const VariableId input : parts_.sampled)
            if (is_written_late(input)) list.push_back(forgotten(input));
            else if (parts_.is_held(input)) list.push_back(released(input));
        return list;
    }

    /// Returns the assignment that resets the sample of a held input at the end of the scan. In the atomic grain,
    /// write() is executed in every evolution, so that the reset is conditional.
    Network::Assignment released(VariableId input) {
        Network::Assignment reset = forgotten(input);
        if (!phased_) reset.value = exprs().conditional(leaf_of(parts_.stable), reset.value, reset.target);
        return reset;
    }

    /// Adds the assignment `output := value`. If the value changes, the flags of the controllers that read the output
    /// are also set.
    void put(Id<Network::Variable> output, Id<Expr> value, Assignments& list) {
        const Id<Expr> target = leaf_of(output);
        if (!phased_ && !every_cycle_) value = exprs().conditional(leaf_of(parts_.stable), value, target);
        for (const std::uint32_t reader : composition_.readers[output.index]) {
            const Id<Expr> flag = leaf_of(composition_.controllers[reader].evol_pl);
            list.push_back({flag, exprs().disjunction(flag, exprs().apply(Op::NotEqual, value, target))});
        }
        list.push_back({target, value});
    }

    /// Returns the updates of the first evolution: actions on activation of the initial steps (Stored::first), previous
    /// values and observed levels. Also requests the start of the timers of the initial steps.
    Assignments start() {
        if (equations_.is_program) return scan(true);
        Assignments list = sample();
        TermCopier now = reading(false);
        note_race(&Fault::first, now, list);
        std::vector<Update> updates;
        for (const Kept& each : kept_)
            if (each.first.valid() && !each.after) updates.push_back({each.variable, {each.first}});
        // Updates of previous values precede all other updates.
        std::ranges::stable_partition(updates, [&](const Update& update) {
            return equations_.variables[update.target].role == Equations::Role::Previous;
        });
        const std::vector<VariableId> olds = keep_old(updates, list);
        TermCopier old = reading(false, olds);
        for (const Update& update : updates) list.push_back({stored_[update.target.index], old(update.terms[0])});
        watch(false, list);
        for (std::size_t i = 0; i < parts_.pending.size(); ++i)
            if (equations_.variables[equations_.timers[i].watched].initial != 0)
                list.push_back({leaf_of(parts_.pending[i]), exprs().constant(true)});
        if (!every_cycle_) return list;
        // Samples the inputs that write() reads, because write() follows immediately.
        for (const VariableId input : parts_.sampled)
            if (is_written_late(input)) list.push_back(sampled(input));
        return list;
    }

    Composition& composition_;
    Network& network_;
    const Equations& equations_;
    const ControllerParts& parts_;
    bool phased_;
    bool every_cycle_;
    std::vector<Kept> kept_;
    /// For each variable of the equations: the leaf of its network variable.
    std::vector<Id<Expr>> stored_;
    /// For each variable of the equations: the scratch variable that stores its old value.
    std::vector<Id<Network::Variable>> old_;
};

}  // namespace

bool starts(const Equations& equations, ExecutionMode mode) {
    return mode == ExecutionMode::EveryCycle || !remembered(equations).empty() || acts_at_first(equations);
}

Procedures procedures(Composition& composition, const ControllerParts& parts) {
    return Builder(composition, parts).build();
}

}  // namespace grafverif
