// SPDX-License-Identifier: MIT
// Compares the closed loop, which samples the inputs before each evolution, with a loop whose controllers sample them
// once per stability search: the verdicts that docs/explanation/input-sampling.md lists must be preserved.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "check/timed/timed.hpp"
#include "compose/observe.hpp"
#include "support/random_loop.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using Role = Network::Role;

Network::Assignment assigned(Network& network, Id<Network::Variable> target, Id<Expr> value) {
    return {network.exprs.leaf(Op::Variable, target.index), value};
}

/// Replaces the inputs that `fire` reads by copies. Returns the assignments of the copies.
std::vector<Network::Assignment> copy_inputs(Network& network, const Network::Controller& controller) {
    std::map<std::uint32_t, Id<Network::Variable>> copies;
    std::vector<Network::Assignment> sampling;
    for (const auto& input : controller.words.inputs) {
        Network::Variable variable = network.variables[input.variable];
        variable.name = controller.words.name + "_once_" + variable.name;
        variable.role = Role::Sample;
        variable.shown_name.clear();
        const Id<Network::Variable> copy = network.variables.add(std::move(variable));
        copies.emplace(input.variable.index, copy);
        sampling.push_back(assigned(network, copy, network.exprs.leaf(Op::Variable, input.variable.index)));
    }
    const Exprs before = network.exprs;
    TermCopier copied(before, network.exprs, [&](const Expr& leaf) {
        const auto index = static_cast<std::uint32_t>(leaf.value);
        const auto copy = leaf.op == Op::Variable ? copies.find(index) : copies.end();
        return network.exprs.leaf(leaf.op, copy == copies.end() ? index : copy->second.index);
    });
    Network::Template& automaton = network.templates[network.processes[controller.process].automaton];
    for (Network::Assignment& assignment : automaton.procedures[controller.fire].assignments)
        assignment.value = copied(assignment.value);
    return sampling;
}

/// Returns the phased network in which the controllers with stability search sample their inputs only at the beginning
/// of a search.
Network sampling_once(Network network) {
    for (const Network::Controller& controller : network.controllers) {
        if (controller.words.mode != ExecutionMode::StabilitySearch) continue;
        const std::vector<Network::Assignment> sampling = copy_inputs(network, controller);
        const Id<Network::Variable> searching =
            network.variables.add({.name = controller.words.name + "_searching", .role = Role::Flag});
        const Id<Expr> is_searching = network.exprs.leaf(Op::Variable, searching.index);
        Network::Template& automaton = network.templates[network.processes[controller.process].automaton];
        const auto calls = [](const Network::Edge& edge, Id<Network::Procedure> procedure) {
            return std::ranges::find(edge.calls, procedure) != edge.calls.end();
        };
        Network::Edge later;
        for (Network::Edge& edge : automaton.edges) {
            if (calls(edge, controller.fire)) {
                later = edge;
                later.guard = network.exprs.conjunction(later.guard, is_searching);
                edge.guard = network.exprs.conjunction(edge.guard, network.exprs.negation(is_searching));
                edge.assignments.insert(edge.assignments.end(), sampling.begin(), sampling.end());
            } else if (edge.to == controller.waiting && !calls(edge, controller.start)) {
                const bool ends = calls(edge, controller.write);
                edge.assignments.push_back(assigned(network, searching, network.exprs.constant(!ends)));
            }
        }
        automaton.edges.add(std::move(later));
    }
    EXPECT_EQ(verify(network), std::vector<std::string>{});
    return network;
}

std::map<std::string, Outcome> outcomes(const Network& network) {
    const TimedResult result = check_timed(observed(network, watched(network)), {.max_states = 20000});
    std::map<std::string, Outcome> found;
    for (const Verdict& verdict : result.verdicts)
        if (result.errors.empty()) found[verdict.property] = verdict.outcome;
    return found;
}

/// The types of elements that a property reads.
struct Reads {
    bool timers = false;
    bool inner = false;  ///< steps or internal variables
};

Reads reads_of(const Network& network, const Property& property) {
    Reads reads;
    for (const Id<Expr> operand : property.operands)
        for (const Id<Expr> leaf : leaves(network.exprs, operand)) {
            if (network.exprs[leaf].op != Op::Variable) continue;
            const Role role = network.variables[{static_cast<std::uint32_t>(network.exprs[leaf].value)}].role;
            reads.timers = reads.timers || role == Role::TimerEnd;
            reads.inner = reads.inner || (role != Role::Input && role != Role::Output && role != Role::Plant);
        }
    return reads;
}

/// Returns the outcome that is preserved: if the property has this outcome in the closed loop, it has the same outcome
/// if inputs are sampled once per search. Returns `Unknown` if no outcome is preserved.
Outcome preserved(const Network& network, const Property& property) {
    const Reads reads = reads_of(network, property);
    switch (property.pattern) {
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::ExactlyOneOf: return reads.timers ? Outcome::Unknown : Outcome::Holds;
    case Pattern::Reachable: return reads.timers ? Outcome::Unknown : Outcome::Violated;
    case Pattern::Inevitable:
    case Pattern::LeadsTo:
    case Pattern::Watched: return reads.timers || reads.inner ? Outcome::Unknown : Outcome::Holds;
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
    case Pattern::ReachableAllSteps:
    case Pattern::AlwaysPossible:
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::RawLtl: return Outcome::Unknown;
    }
    return Outcome::Unknown;
}

const std::string buttons =
    "environment Start = push_button(OUT = START); environment Stop = push_button(OUT = STOP);\n";

/// Returns a loop whose chart has many transient situations, because its conditions are over two buttons only.
std::string random_text(Random& random) {
    const auto one_of = [&](const std::vector<std::string>& words) {
        return words[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(words.size()) - 1))];
    };
    const std::vector<std::string> steps = {"0", "1", "2", "3", "4"};
    const std::vector<std::string> conditions = {"START",         "!START",         "STOP",           "!STOP",
                                                 "START && STOP", "START && !STOP", "!START && STOP", "true"};
    std::string text = "grafcet chart { input START, STOP; output P, Q; initial step 0;\n";
    for (std::size_t k = 1; k < steps.size(); ++k)
        text += "step " + steps[k] + one_of({";", " { P; }", " { Q; }"}) + '\n';
    for (int k = 0; k < 7; ++k) {
        const std::string from = k < 5 ? steps[static_cast<std::size_t>(k)] : one_of(steps);
        text += "transition t" + std::to_string(k) + ": " + from + " -> " + one_of(steps) + " when " +
                one_of(conditions) + ";\n";
    }
    text += "}\nclosed_loop loop { controller chart; " + buttons;
    const std::vector<std::string> visible = {"P", "Q", "!P", "START", "STOP", "!STOP"},
                                   inner = {"X1", "X2", "X3", "X4"};
    const auto term = [&] { return one_of(random_number(random, 0, 2) == 0 ? inner : visible); };
    for (const char* pattern : {"never A && B", "A leads to B", "A precedes B", "reachable A && B", "never A at stable",
                                "A at most 1 time between B and P", "A leads to B at stable"}) {
        std::string sentence;
        for (const char letter : std::string(pattern))
            sentence += letter == 'A' || letter == 'B' ? term() : std::string(1, letter);
        text += "property p" + std::to_string(text.size()) + ": " + sentence + ";\n";
    }
    return text + "}\n";
}

LoopUnderTest random_loop_of(Random& random, int seed) {
    const ComposeOptions options = {.grain = Grain::Phased};
    return seed % 3 == 0 ? composed_loop(random_loop_asked(random, 8), options)
                         : read_loop(random_text(random), options);
}

TEST(RandomizedInputSampling, ProgramsThatSampleOncePerSearchHaveThePreservedVerdicts) {
    int compared = 0, different = 0;
    for (int seed = 1; seed <= test_size(150); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        LoopUnderTest loop;
        try {
            loop = random_loop_of(random, seed);
        } catch (const std::invalid_argument&) {
            continue;
        }
        const std::map<std::string, Outcome> model = outcomes(loop.network),
                                             program = outcomes(sampling_once(loop.network));
        const auto time = program.find("no_timelock");
        if (time == program.end() || time->second != Outcome::Holds) continue;  // the stability search must terminate
        for (const Property& property : loop.network.properties) {
            const auto given = model.find(property.name), found = program.find(property.name);
            if (given == model.end() || found == program.end()) continue;
            const bool known = given->second != Outcome::Unknown && found->second != Outcome::Unknown;
            if (!known) continue;
            different += given->second != found->second ? 1 : 0;
            if (given->second != preserved(loop.network, property)) continue;
            ++compared;
            EXPECT_EQ(found->second, given->second) << property.name;
        }
    }
    EXPECT_GT(compared, test_size(150) / 5);
    EXPECT_GT(different, 0) << "the two loops always have the same verdicts";
}

TEST(RandomizedInputSampling, ASearchOfTheModelCanReadOldAndNewInputs) {
    const Network network = read_loop(
                                "grafcet vessel { input START, STOP; output FILL, DRAIN;\n"
                                "    initial step 0; step 1 { FILL; } step 2 { DRAIN; }\n"
                                "    transition t0: 0 -> 1 when START && !STOP; transition t1: 1 -> 2 when STOP;\n"
                                "    transition t2: 2 -> 0 when !START && !STOP; }\n"
                                "closed_loop vessel_loop { controller vessel; " +
                                buttons + "property fills: FILL precedes DRAIN; }\n")
                                .network;
    EXPECT_EQ(outcomes(network).at("fills"), Outcome::Violated);
    EXPECT_EQ(outcomes(sampling_once(network)).at("fills"), Outcome::Holds);
}

TEST(RandomizedInputSampling, AProgramCanUseAnInputThatHasChanged) {
    const Network network =
        read_loop(
            "grafcet branch { input START, STOP; output LEFT, RIGHT;\n"
            "    initial step 0; step 1; step 2; step 3 { LEFT; } step 4 { RIGHT; }\n"
            "    transition t0: 0 -> 1 when START && !STOP; transition t1: 1 -> 2 when true;\n"
            "    transition t2: 2 -> 3 when !STOP; transition t3: 2 -> 4 when STOP;\n"
            "    transition t4: 3 -> 0 when !START && !STOP; transition t5: 4 -> 0 when !START && !STOP; }\n"
            "closed_loop branch_loop { controller branch; " +
            buttons + "property right: X1 && STOP leads to X4; }\n")
            .network;
    EXPECT_EQ(outcomes(network).at("right"), Outcome::Holds);
    EXPECT_EQ(outcomes(sampling_once(network)).at("right"), Outcome::Violated);
}

}  // namespace
}  // namespace grafverif
