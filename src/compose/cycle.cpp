// SPDX-License-Identifier: MIT
// Builds the template of the PLC cycle (CEP13 Fig. 33a) and its process.
#include "compose/controller.hpp"
#include "compose/procedures.hpp"
#include "ir/words_of.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

using Location = Id<Network::Location>;
using Procedure = Id<Network::Procedure>;

/// Returns the conjunction of `condition` and the condition that no request to a timer is pending.
Id<Expr> if_none_pending(Network& network, const ControllerParts& parts, Id<Expr> condition) {
    std::vector<Id<Expr>> guard{condition};
    for (const Id<Network::Variable> pending : parts.pending)
        guard.push_back(network.exprs.negation(leaf(network, pending)));
    return network.exprs.conjunction(guard);
}

/// Returns the guard of the urgent edge `W -> P0`: `!stable || EVOL_PL || EVOL_TI`, and no request to a timer is
/// pending. Flags that the controller does not have are omitted, and ComposeOptions::ablations can change the guard.
/// With a task cycle, this edge only continues a scan.
Id<Expr> cycle_guard(Composition& composition, const ControllerParts& parts) {
    Network& network = composition.network;
    std::vector<Id<Expr>> reasons;
    if (!composition.ablations.cycle_unless_stable)
        reasons.push_back(network.exprs.negation(leaf(network, parts.stable)));
    if (parts.evol_pl.valid()) reasons.push_back(leaf(network, parts.evol_pl));
    if (parts.evol_ti.valid()) reasons.push_back(leaf(network, parts.evol_ti));
    const bool always = composition.ablations.cycle_always && !parts.cycle;
    return if_none_pending(network, parts, always ? network.exprs.constant(true) : network.exprs.disjunction(reasons));
}

std::vector<Network::Assignment> flags_reset(Network& network, const ControllerParts& parts) {
    const Id<Expr> reset = network.exprs.constant(false);
    std::vector<Network::Assignment> list;
    if (parts.evol_pl.valid()) list.push_back({leaf(network, parts.evol_pl), reset});
    if (parts.evol_ti.valid()) list.push_back({leaf(network, parts.evol_ti), reset});
    return list;
}

class CycleBuilder {
public:
    CycleBuilder(Composition& composition, const ControllerParts& parts) : composition_(composition), parts_(parts) {}

    Network::Template build() {
        Procedures code = procedures(composition_, parts_);
        const Location init = parts_.starts ? location("init") : Location{};
        waiting_ = location("W");
        sample_ = std::move(code.sample);
        if (parts_.cycle) add_clock();
        fire_ = procedure("fire", std::move(code.fire));
        evolve_ = procedure("evolve", std::move(code.evolve));
        write_ = procedure("write", std::move(code.write));
        if (parts_.starts) {
            start_ = procedure("start", std::move(code.start));
            edge(init, waiting_, always(), {}, every_cycle() ? std::vector{start_, write_} : std::vector{start_});
        }
        if (network().grain == Grain::Phased) phases(std::move(code.forget));
        else begin_cycle(waiting_, {fire_, evolve_, write_});
        automaton_.name = composition_.names.fresh(parts_.prefix + "plc_cycle");
        automaton_.initial = parts_.starts ? init : waiting_;
        automaton_.origin = parts_.origin;
        return std::move(automaton_);
    }

    /// Returns the locations and variables of the cycle, without its process and timers.
    Network::Controller controller() const {
        const Equations& equations = *parts_.equations;
        const auto place = [&](Id<Equations::Variable> id) { return parts_.variable[id.index]; };
        Network::Controller made{.words = words_of<Network::Variable>(equations, parts_.mode, place),
                                 .waiting = waiting_,
                                 .stable = parts_.stable,
                                 .variables = parts_.variable,
                                 .start = start_,
                                 .fire = fire_,
                                 .evolve = evolve_,
                                 .write = write_};
        made.words.cycle = parts_.cycle;
        for (const Id<Equations::Variable> id : equations.variables.ids()) {
            if (equations.variables[id].role == Equations::Role::Output) made.images.push_back(parts_.image[id.index]);
            if (parts_.is_held(id)) made.words.held.push_back(parts_.sample[id.index]);
        }
        return made;
    }

private:
    Network& network() { return composition_.network; }
    Id<Expr> always() { return network().exprs.constant(true); }
    bool every_cycle() const { return parts_.mode == ExecutionMode::EveryCycle; }

    Location location(const char* name) { return automaton_.locations.add({name, {}, parts_.origin}); }
    Procedure procedure(const char* name, std::vector<Network::Assignment> body) {
        return automaton_.procedures.add({name, std::move(body)});
    }
    Network::Edge& edge(Location from, Location to, Id<Expr> guard, std::vector<Network::Assignment> assignments,
                        std::vector<Procedure> calls) {
        Network::Edge made{.from = from,
                           .to = to,
                           .urgent = true,
                           .guard = guard,
                           .assignments = std::move(assignments),
                           .calls = std::move(calls),
                           .origin = parts_.origin};
        if (to == waiting_ && clock_.valid()) made.resets.push_back(clock_);
        return automaton_.edges[automaton_.edges.add(std::move(made))];
    }

    /// Adds the clock that measures the time since the last scan, with the invariant of W. The clock is reset at the
    /// end of a scan, because a scan takes no time.
    void add_clock() {
        clock_ = automaton_.clocks.add({"clk"});
        automaton_.locations[waiting_].invariant.push_back({clock_, Op::LessEqual, units(parts_.cycle->most_ms)});
    }
    Id<Expr> units(std::int64_t milliseconds) { return network().exprs.integer(milliseconds / network().time_unit_ms); }

    /// Adds the edges by which a cycle begins in W. With a task cycle, an edge with a clock constraint begins a scan,
    /// and an urgent edge continues a scan that holds its inputs. The guard of the edge with the clock constraint is
    /// true whenever time can pass; this guard is necessary only for models without clocks.
    void begin_cycle(Location to, const std::vector<Procedure>& calls) {
        if (parts_.cycle) {
            std::vector<Network::Assignment> begin = sample_;
            if (parts_.holds_inputs() && to != waiting_)
                begin.push_back({leaf(network(), parts_.stable), network().exprs.constant(false)});
            const Id<Expr> ended = parts_.holds_inputs() ? leaf(network(), parts_.stable) : always();
            Network::Edge& scan =
                edge(waiting_, to, if_none_pending(network(), parts_, ended), std::move(begin), calls);
            scan.urgent = false;
            scan.constraint.push_back({clock_, Op::GreaterEqual, units(parts_.cycle->least_ms)});
        }
        if (!parts_.cycle || parts_.holds_inputs())
            edge(waiting_, to, cycle_guard(composition_, parts_), flags_reset(network(), parts_), calls);
    }

    void phases(std::vector<Network::Assignment> forget) {
        const Location read = location("P0"), fired = location("P1"), evolved = location("P2");
        begin_cycle(read, {});
        edge(read, fired, always(), {}, {fire_});
        edge(fired, evolved, always(), {}, {evolve_});
        if (every_cycle()) {
            edge(evolved, waiting_, always(), {}, {write_});
            return;
        }
        const Id<Expr> stable = leaf(network(), parts_.stable);
        edge(evolved, waiting_, stable, {}, {write_});
        edge(evolved, waiting_, network().exprs.negation(stable), std::move(forget), {});
    }

    Composition& composition_;
    const ControllerParts& parts_;
    Network::Template automaton_ = {};
    Location waiting_ = {};
    Id<Network::Clock> clock_ = {};  ///< valid only with a task cycle
    std::vector<Network::Assignment> sample_ = {};
    Procedure start_ = {}, fire_ = {}, evolve_ = {}, write_ = {};
};

}  // namespace

Id<Network::Controller> add_cycle(Composition& composition, const ControllerParts& parts) {
    CycleBuilder builder(composition, parts);
    Network::Template automaton = builder.build();
    Network& network = composition.network;
    Network::Process process{.name = composition.names.fresh(parts.prefix + "PLC"),
                             .initial = automaton.initial,
                             .kind = Network::ProcessKind::Controller,
                             .origin = parts.origin};
    process.automaton = network.templates.add(std::move(automaton));
    Network::Controller controller = builder.controller();
    controller.process = network.processes.add(std::move(process));
    return network.controllers.add(std::move(controller));
}

}  // namespace grafverif
