// SPDX-License-Identifier: MIT
#include "support/random_subsystems.hpp"

#include <string>
#include <vector>

#include "ir/network_subsystems.hpp"

namespace grafverif {

namespace {

struct PartsGenerator {
    Random& random;
    Network network = {};
    std::vector<Id<Network::Variable>> flags = {};    // Boolean variables of the current part
    std::vector<Id<Network::Variable>> counts = {};   // integer variables of the current part
    std::vector<Id<Network::Variable>> foreign = {};  // Boolean variables that any part may read
    std::vector<Id<Network::Variable>> wakes = {};    // Boolean variables that any part may set
    bool closed = true;

    std::int64_t number(std::int64_t low, std::int64_t high) { return random_number(random, low, high); }
    bool often(int percent) { return chance(random, percent); }
    template <class T>
    const T& pick(const std::vector<T>& from) {
        return from[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(from.size()) - 1))];
    }
    Id<Expr> leaf(Id<Network::Variable> variable) { return network.exprs.leaf(Op::Variable, variable.index); }

    Id<Expr> condition() {
        Exprs& exprs = network.exprs;
        if (!counts.empty() && often(25))
            return exprs.apply(often(50) ? Op::Less : Op::Equal, leaf(pick(counts)), exprs.integer(number(0, 3)));
        const Id<Expr> one = leaf(pick(!foreign.empty() && often(45) ? foreign : flags));
        if (!foreign.empty() && often(25))
            return often(50) ? exprs.conjunction(one, condition()) : exprs.disjunction(one, condition());
        return often(40) ? exprs.negation(one) : one;
    }

    std::vector<Network::Assignment> assignments() {
        Exprs& exprs = network.exprs;
        std::vector<Network::Assignment> list;
        if (often(60)) {
            const Id<Expr> flag = leaf(pick(flags));
            list.push_back({flag, often(50) ? exprs.negation(flag) : exprs.constant(often(50))});
        }
        if (!foreign.empty() && often(30)) list.push_back({leaf(pick(flags)), condition()});
        if (!wakes.empty() && often(35)) list.push_back({leaf(pick(wakes)), exprs.constant(often(70))});
        if (!counts.empty() && often(40)) {
            const Id<Expr> count = leaf(pick(counts));
            const Id<Expr> more = exprs.apply(Op::Plus, count, exprs.integer(1));
            list.push_back({count, often(80) ? exprs.apply(Op::Modulo, more, exprs.integer(3)) : more});
        }
        if (network.race.valid() && often(8)) {
            const Id<Expr> race = leaf(network.race);
            list.push_back({race, exprs.disjunction(race, condition())});
        }
        return list;
    }

    void add_process(const std::string& name) {
        Network::Template automaton{.name = name};
        const std::int64_t clocks = number(0, 1), locations = number(1, 3);
        for (std::int64_t c = 0; c < clocks; ++c) automaton.clocks.add({"c"});
        for (std::int64_t l = 0; l < locations; ++l) {
            Network::Location location{.name = "l" + std::to_string(l)};
            if (clocks > 0 && often(45))
                location.invariant.push_back(
                    {{0}, closed || often(50) ? Op::LessEqual : Op::Less, network.exprs.integer(number(1, 3))});
            automaton.locations.add(std::move(location));
        }
        automaton.initial = {0};
        for (std::int64_t e = number(1, 4); e > 0; --e) {
            Network::Edge edge{.from = {static_cast<std::uint32_t>(number(0, locations - 1))},
                               .to = {static_cast<std::uint32_t>(number(0, locations - 1))},
                               .urgent = often(35),
                               .guard = often(30) ? network.exprs.constant(true) : condition(),
                               .assignments = assignments()};
            if (clocks > 0 && !edge.urgent && often(75))
                edge.constraint.push_back({{0},
                                           pick(closed ? std::vector{Op::LessEqual, Op::Equal, Op::GreaterEqual}
                                                       : std::vector{Op::Less, Op::GreaterEqual, Op::Greater}),
                                           network.exprs.integer(number(1, 3))});
            const bool bounded = !automaton.locations[edge.to].invariant.empty();
            if (clocks > 0 && (often(60) || (edge.urgent && bounded))) edge.resets.push_back({0});
            automaton.edges.add(std::move(edge));
        }
        const Id<Network::Template> id = network.templates.add(std::move(automaton));
        network.processes.add({.name = name, .automaton = id, .initial = {0}});
    }

    /// Returns the condition of quiescence: all urgent edges of the processes from `first_process` on are disabled.
    /// Sometimes the result contains an additional condition.
    Id<Expr> settled_of(std::size_t first_process) {
        std::vector<Id<Expr>> conjuncts;
        for (auto process = static_cast<std::uint32_t>(first_process); process < network.processes.size(); ++process)
            for (const Network::Edge& edge : network.templates[network.processes[{process}].automaton].edges)
                if (edge.urgent)
                    conjuncts.push_back(network.exprs.negation(
                        network.exprs.conjunction(network.exprs.at(process, edge.from.index), edge.guard)));
        if (often(20)) conjuncts.push_back(condition());
        return network.exprs.conjunction(conjuncts);
    }

    void add_part(int part) {
        add_variables(part);
        add_processes(part);
    }

    void add_variables(int part) {
        const std::string name = "p" + std::to_string(part);
        flags.clear();
        counts.clear();
        for (std::int64_t k = number(1, 2); k > 0; --k)
            flags.push_back(
                network.variables.add({.name = name + "_f" + std::to_string(k), .initial = often(30) ? 1 : 0}));
        if (often(40))
            counts.push_back(network.variables.add({.name = name + "_n", .type = integer_type(0, 3), .initial = 0}));
    }

    void add_processes(int part) {
        const std::string name = "p" + std::to_string(part);
        const std::size_t first = network.processes.size();
        for (std::int64_t k = number(1, 2); k > 0; --k) add_process(name + "_a" + std::to_string(k));
        network.settled = network.exprs.conjunction(network.settled, settled_of(first));
    }
};

}  // namespace

Network random_parts(Random& random, int parts) {
    PartsGenerator generator{random};
    Network& network = generator.network;
    network.name = "parts";
    network.settled = network.exprs.constant(true);
    generator.closed = chance(random, 85);
    if (chance(random, 25)) network.race = network.variables.add({.name = "race", .role = Network::Role::Flag});
    for (int part = 0; part < parts; ++part) generator.add_part(part);
    return std::move(network);
}

Network random_cells(Random& random, int cells) {
    PartsGenerator generator{random};
    Network& network = generator.network;
    network.name = "cells";
    network.settled = network.exprs.constant(true);
    generator.closed = chance(random, 85);
    if (chance(random, 15)) network.race = network.variables.add({.name = "race", .role = Network::Role::Flag});
    std::vector<std::vector<Id<Network::Variable>>> flags, counts;
    std::vector<Id<Network::Variable>> all;
    for (int cell = 0; cell < cells; ++cell) {
        generator.add_variables(cell);
        flags.push_back(generator.flags);
        counts.push_back(generator.counts);
        all.insert(all.end(), generator.flags.begin(), generator.flags.end());
    }
    if (chance(random, 50)) generator.wakes.push_back(network.variables.add({.name = "wake"}));
    all.insert(all.end(), generator.wakes.begin(), generator.wakes.end());
    generator.foreign = all;
    for (int cell = 0; cell < cells; ++cell) {
        generator.flags = flags[static_cast<std::size_t>(cell)];
        generator.counts = counts[static_cast<std::size_t>(cell)];
        generator.add_processes(cell);
    }
    return std::move(network);
}

void query_subsystems(Network& network, Random& random) {
    const NetworkSubsystems parts = parts_of(network);
    std::vector<std::vector<Id<Expr>>> terms(parts.count);
    for (const Id<Network::Variable> id : network.variables.ids())
        if (parts.of_variable[id.index] != NetworkSubsystems::none && network.variables[id].type.boolean)
            terms[parts.of_variable[id.index]].push_back(network.exprs.leaf(Op::Variable, id.index));
    for (const Id<Network::Process> id : network.processes.ids())
        terms[parts.of_process[id.index]].push_back(network.exprs.at(id.index, 0));
    const auto term = [&](std::uint32_t part) {
        const auto last = static_cast<std::int64_t>(terms[part].size()) - 1;
        const Id<Expr> one = terms[part][static_cast<std::size_t>(random_number(random, 0, last))];
        return chance(random, 40) ? network.exprs.negation(one) : one;
    };
    int count = 0;
    const auto add = [&](Pattern pattern, std::vector<Id<Expr>> operands, int stable) {
        network.properties.add({.name = "q" + std::to_string(count++),
                                .pattern = pattern,
                                .operands = std::move(operands),
                                .at_stable = chance(random, stable)});
    };
    const auto any = [&] {
        return static_cast<std::uint32_t>(random_number(random, 0, static_cast<std::int64_t>(parts.count) - 1));
    };
    for (const Pattern pattern :
         {Pattern::Always, Pattern::Never, Pattern::Reachable, Pattern::Inevitable, Pattern::AlwaysPossible})
        for (int k = 0; k < 2; ++k) add(pattern, {term(any())}, 20);
    for (int k = 0; k < 3; ++k)
        if (const std::uint32_t part = any(); true) add(Pattern::LeadsTo, {term(part), term(part)}, 15);
    const std::uint32_t part = any();
    add(Pattern::ExactlyOneOf, {term(part), term(part)}, 20);
    add(Pattern::LeadsTo, {term(any()), term(any())}, 10);
    add(Pattern::Never, {network.exprs.conjunction(term(any()), term(any()))}, 20);
    add(Pattern::NoDeadlock, {}, 0);
    add(Pattern::NoTimelock, {}, chance(random, 20) ? 100 : 0);
    if (network.race.valid()) add(Pattern::Never, {network.exprs.leaf(Op::Variable, network.race.index)}, 0);
}

std::string loop_of_plcs(Random& random, int plcs) {
    const auto pick = [&](const std::vector<std::string>& from) {
        return from[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(from.size()) - 1))];
    };
    std::string charts, loop = "closed_loop plcs {\n";
    for (int k = 1; k <= plcs; ++k) {
        const std::string n = std::to_string(k), delay = std::to_string(random_number(random, 1, 3)) + "s/X1";
        const std::string counts =
            pick({"", "", "N := N + 1 on activation;", "N := 0 on activation; N := 2 on activation;"});
        charts += "grafcet g" + n + " { input A" + n + "; output L" + n + "; internal N: int 0..2 = 0;\n" +
                  "initial step 0 { " + pick({"", "N := 0 on activation;"}) + " } step 1 { L" + n + "; " + counts +
                  " } step 2;\n" + "transition a: 0 -> 1 when " + pick({"A", "!A", "rise(A"}) + n;
        if (charts.ends_with("rise(A" + n)) charts += ")";
        charts += "; transition b: 1 -> 2 when " + pick({delay, "!A" + n, delay + " && A" + n}) +
                  "; transition c: 2 -> 0 when " + pick({"true", "A" + n, "1s/X2"}) + "; }\n";
        loop += "controller g" + n + pick({" with stability_search", " with every_cycle"}) + ";\n";
        loop += "environment B" + n + " = " + pick({"push_button", "push_button", "free"}) + "(OUT = A" + n + ");\n";
        const std::string x = "g" + n + ".X";
        loop += "property lit" + n + ": never L" + n + ";\nproperty off" + n + ": " + x + "1 leads to " + x + "2;\n" +
                "property seen" + n + ": reachable " + x + "2 at stable;\nproperty one" + n + ": exactly one of {" + x +
                "0, " + x + "1, " + x + "2};\nproperty some" + n + ": inevitable " + x + "1;\n";
    }
    return charts + loop +
           "property steps: reachable all steps;\nproperty D: no deadlock;\nproperty both: never L1 && L2;\n}\n";
}

}  // namespace grafverif
