// SPDX-License-Identifier: MIT
// Randomized tests of explanations of counterexamples.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "check/lost_text.hpp"
#include "check/symbolic/symbolic.hpp"
#include "check/timed/timed.hpp"
#include "compare/mutants.hpp"
#include "explain/ablation.hpp"
#include "explain/causes.hpp"
#include "explain/counterfactual.hpp"
#include "explain/instability.hpp"
#include "explain/moves.hpp"
#include "grafverif/grafverif.hpp"
#include "pipeline/why.hpp"
#include "run/project.hpp"
#include "support/naive_tadd.hpp"
#include "support/random_chart.hpp"
#include "support/random_loop.hpp"
#include "support/test_size.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/print/chart.hpp"

namespace grafverif {
namespace {

/// Returns the network of a random loop, or nothing if equations cannot be derived from its charts.
std::optional<Network> network_for(const Model& model, const ModelOptions& how = {}) {
    Diagnostics diagnostics;
    return network_of(model, {0}, how, diagnostics);
}

TimedResult searched(const Network& network) {
    TimedOptions options;
    options.max_states = 20'000;
    return check_timed(network, options);
}

/// Searches `system` and checks only the properties with these patterns. The memory limit bounds the time of the test.
SymbolicResult searched(const TransitionSystem& system, const std::vector<Pattern>& patterns) {
    SymbolicOptions options;
    options.witnesses = false;
    options.max_memory = std::uint64_t{2} << 20U;
    for (const Property& property : system.properties)
        if (std::ranges::find(patterns, property.pattern) != patterns.end())
            options.properties.push_back(property.name);
    return options.properties.empty() ? SymbolicResult() : check_symbolic(system, options);
}

/// The explanation is compared with the search of `analyse` on the equations of the chart alone. In
/// this search, no input changes during an instant; therefore the search corresponds to the atomic
/// grain.
TEST(RandomizedExplain, ChartsReportedAsUnstableAreTotallyUnstableForAnalyse) {
    int unstable = 0;
    for (int seed = 1; seed <= test_size(120); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        const auto network = network_for(model, {ExecutionMode::StabilitySearch, Grain::Atomic});
        if (!network) continue;
        for (const Verdict& verdict : searched(*network).verdicts) {
            if (verdict.pattern != Pattern::NoTimelock || verdict.outcome != Outcome::Violated) continue;
            const std::string words = unstable_text(project(*network, verdict.run.value()));
            for (const ClosedLoop::Controller& controller : model.loops[{0}].controllers) {
                if (words.find('`' + controller.name + '`') == std::string::npos) continue;
                Diagnostics diagnostics;
                const auto analysis =
                    analysis_of(model, controller.chart, ExecutionMode::StabilitySearch, {}, diagnostics);
                ASSERT_TRUE(analysis);
                const auto says = [](const auto& each) { return each.code == "total-instability"; };
                EXPECT_TRUE(std::ranges::any_of(analysis->findings, says) || std::ranges::any_of(analysis->open, says))
                    << words;
                ++unstable;
            }
        }
    }
    EXPECT_GT(unstable, 0);
}

// -- causes -----------------------------------------------------------------------------------------------------------

std::size_t below(Random& random, std::size_t bound) { return random() % bound; }

/// Returns a term over the first `variables` variables in which some subterms occur twice.
Id<Expr> random_term(Random& random, Exprs& exprs, std::size_t variables, int depth) {
    if (depth == 0 || below(random, 4) == 0) {
        const Id<Expr> leaf = exprs.leaf(Op::Variable, static_cast<std::uint32_t>(below(random, variables)));
        return below(random, 3) == 0 ? exprs.apply(Op::Less, leaf, exprs.integer(1)) : leaf;
    }
    const Id<Expr> left = random_term(random, exprs, variables, depth - 1);
    if (below(random, 4) == 0) return exprs.negation(left);
    const Id<Expr> right = random_term(random, exprs, variables, depth - 1);
    return below(random, 2) == 0 ? exprs.conjunction(left, right) : exprs.disjunction(left, right);
}

using Pair = std::pair<std::uint32_t, std::size_t>;  // index of a term, and of a state

/// Computes causes by their literal definition, for a run of states on which a property fails.
class Enumeration {
public:
    Enumeration(const Network& network, const Property& property, std::vector<NetworkState> states, std::size_t count,
                std::optional<std::size_t> loop)
        : network_(network), property_(property), states_(std::move(states)), count_(count), loop_(loop) {}

    /// Returns nothing if the property does not fail, or if there are too many sets to enumerate.
    std::optional<std::set<Pair>> causes() {
        for (explained_ = 0; explained_ < count_; ++explained_)
            if (fails({})) break;
        if (explained_ == count_) return {};
        std::set<Pair> bottom;
        for (const std::size_t state : pairs_of())
            for (const auto& [term, wanted] : literals(state))
                if (literal(term, state, {}) != wanted) bottom.insert({term, state});
        if (bottom.size() > 10) return {};
        const std::vector<Pair> all(bottom.begin(), bottom.end());
        std::set<Pair> found;
        for (std::size_t bits = 0; bits < std::size_t{1} << all.size(); ++bits) {
            std::set<Pair> changed;
            for (std::size_t k = 0; k < all.size(); ++k)
                if ((bits >> k & 1U) != 0) changed.insert(all[k]);
            if (!fails(changed)) continue;
            for (const Pair& each : all) {
                std::set<Pair> more = changed;
                if (more.insert(each).second && !fails(more)) found.insert(each);
            }
        }
        return found;
    }

private:
    bool responds() const { return property_.pattern == Pattern::LeadsTo; }

    /// Returns the states in which values of terms may be changed: the explained state and, for `leads to`, all states
    /// that follow it.
    std::vector<std::size_t> pairs_of() const {
        std::vector<std::size_t> list = {explained_};
        for (std::size_t k = 0; k < count_ && responds(); ++k)
            if (k > explained_ || (loop_ && k >= *loop_ && k < explained_)) list.push_back(k);
        return list;
    }

    bool literal(std::uint32_t term, std::size_t state, const std::set<Pair>& changed) const {
        return (value(network_, states_[state], {term}) != 0) != changed.contains({term, state});
    }

    bool holds(Id<Expr> term, std::size_t state, const std::set<Pair>& changed) const {
        const Op op = network_.exprs[term].op;
        std::size_t holding = 0;
        for (const Id<Expr> operand : network_.exprs.operands(term))
            if ((op == Op::Not || op == Op::And || op == Op::Or) && holds(operand, state, changed)) ++holding;
        if (op == Op::Not) return holding == 0;
        if (op == Op::And) return holding == network_.exprs.operands(term).size();
        if (op == Op::Or) return holding > 0;
        if (is_constant(op)) return op == Op::True;
        return literal(term.index, state, changed);
    }

    bool fails(const std::set<Pair>& changed) const {
        const auto& p = property_.operands;
        const auto so = [&](Id<Expr> term) { return holds(term, explained_, changed); };
        switch (property_.pattern) {
        case Pattern::Always: return !so(p[0]);
        case Pattern::Never: return so(p[0]);
        case Pattern::ExactlyOneOf: return std::ranges::count_if(p, so) != 1;
        default: break;
        }
        return so(p[0]) &&
               std::ranges::none_of(pairs_of(), [&](std::size_t state) { return holds(p[1], state, changed); });
    }

    /// Returns the literals of the condition that the property imposes on `state`, in negation
    /// normal form. A literal is a term (not a constant, NOT, AND or OR) with the required value of
    /// this term.
    std::vector<std::pair<std::uint32_t, bool>> literals(std::size_t state) const {
        std::vector<std::pair<std::uint32_t, bool>> list;
        const auto walk = [&](const auto& self, Id<Expr> term, bool wanted) -> void {
            const Op op = network_.exprs[term].op;
            if (is_constant(op)) return;
            if (op != Op::Not && op != Op::And && op != Op::Or) return list.emplace_back(term.index, wanted), void();
            for (const Id<Expr> operand : network_.exprs.operands(term)) self(self, operand, wanted == (op != Op::Not));
        };
        const auto& p = property_.operands;
        for (std::size_t k = 0; k < p.size(); ++k) {
            const bool is_demand = responds() && k == 0;
            if (is_demand && state != explained_) continue;
            if (property_.pattern != Pattern::Never && !is_demand) walk(walk, p[k], true);
            const bool exclusive = property_.pattern == Pattern::ExactlyOneOf && p.size() > 1;
            if (property_.pattern == Pattern::Never || is_demand || exclusive) walk(walk, p[k], false);
        }
        return list;
    }

    const Network& network_;
    const Property& property_;
    std::vector<NetworkState> states_;
    std::size_t count_;
    std::optional<std::size_t> loop_;
    std::size_t explained_ = 0;
};

TEST(RandomizedExplain, CausesAreThoseOfTheDefinitionByEnumeration) {
    constexpr std::size_t variables = 4;
    std::map<Pattern, int> explained;
    for (int seed = 1; seed <= test_size(3000); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Network network;
        for (std::size_t k = 0; k < variables; ++k) network.variables.add({.name = std::string(1, char('a' + k))});
        constexpr std::array patterns = {Pattern::Always, Pattern::Never, Pattern::ExactlyOneOf, Pattern::LeadsTo};
        Property property{.pattern = patterns[below(random, patterns.size())]};
        const std::size_t operands = property.pattern == Pattern::ExactlyOneOf ? 1 + below(random, 3)
                                     : property.pattern == Pattern::LeadsTo    ? 2
                                                                               : 1;
        for (std::size_t k = 0; k < operands; ++k)
            property.operands.push_back(random_term(random, network.exprs, variables, 3));
        std::vector<NetworkState> states(1 + below(random, 4));
        for (NetworkState& state : states)
            for (std::size_t k = 0; k < variables; ++k) state.variables.push_back(below(random, 3) == 0 ? 1 : 0);
        const std::size_t count = states.size();
        std::optional<std::size_t> loop;
        if (below(random, 2) == 0) loop = below(random, count);
        std::vector<NetworkState> run = states;
        if (loop) run.push_back(states[*loop]);
        const auto expected = Enumeration(network, property, states, count, loop).causes();
        const auto found = causes_of(network, property, run, loop);
        if (!expected) continue;
        ASSERT_TRUE(found);
        ASSERT_TRUE(found->exact);
        std::set<Pair> pairs;
        for (const Causes::Pair& pair : found->pairs) EXPECT_TRUE(pairs.insert({pair.term.index, pair.state}).second);
        ASSERT_EQ(pairs, *expected);
        // A SystemRun does not contain the first state of its loop a second time.
        TransitionSystem system;
        system.exprs = network.exprs;
        SystemRun untimed{{}, loop};
        for (const NetworkState& state : states) untimed.states.push_back(state.variables);
        const auto of_system = causes_of(system, property, untimed);
        ASSERT_TRUE(of_system);
        ASSERT_EQ(of_system->pairs, found->pairs);
        ++explained[property.pattern];
    }
    for (const auto& [pattern, count] : explained) EXPECT_GT(count, test_size(3000) / 20);
    EXPECT_EQ(explained.size(), 4U);
}

// -- the shortest change ----------------------------------------------------------------------------------------------

const Network::Edge& edge_of(const Network& network, const Fire& fire) {
    return network.templates[network.processes[fire.process].automaton].edges[fire.edge];
}

/// Implements the definition in explain/counterfactual.hpp, in the order of its sentences.
bool nothing_forces(const Network& network, const Move& move) {
    if (std::holds_alternative<Delay>(move)) return false;
    const Fire& fire = std::get<Fire>(move);
    const Network::Process& process = network.processes[fire.process];
    const Network::Location& from = network.templates[process.automaton].locations[edge_of(network, fire).from];
    return (process.kind == Network::ProcessKind::Plant || process.kind == Network::ProcessKind::Environment) &&
           !edge_of(network, fire).urgent && from.invariant.empty();
}

/// Returns the states of the re-executed run, or nothing if the result is not a run.
std::optional<std::vector<NetworkState>> made_again(const Network& network, const Network& timed, const Run& run,
                                                    const std::set<std::size_t>& left_out) {
    std::vector<NetworkState> states = {initial_state(network)};
    const auto can = [&](const Move& move) {
        NetworkState next = states.back();
        const Step::Result result = perform(network, next, move).result;
        if (result == Step::Result::Done) states.push_back(next);
        return result == Step::Result::Done;
    };
    const auto must = [&](bool urgent) {
        for (const Fire& fire : enabled(network, states.back()))
            if (urgent ? edge_of(network, fire).urgent : !nothing_forces(timed, fire)) return can(fire);
        return false;
    };
    for (std::size_t k = 0; k < run.moves.size(); ++k) {
        if (left_out.contains(k)) continue;
        std::vector<Move> parts = {run.moves[k]};
        if (const Delay* const delay = std::get_if<Delay>(&run.moves[k]))
            parts.assign(static_cast<std::size_t>(delay->units), Delay{1});
        const bool kept = std::holds_alternative<Delay>(run.moves[k]) || nothing_forces(timed, run.moves[k]);
        for (const Move& part : parts)
            for (int tries = 0; !can(part) && kept; ++tries)
                if (tries > 500 || !must(false)) return {};
    }
    for (int tries = 0; must(true); ++tries)
        if (tries > 500) return {};
    for (const Fire& fire : enabled(network, states.back()))
        if (edge_of(network, fire).urgent) return {};  // the edge causes a model error
    return states;
}

struct ChangeCounts {
    int mended = 0, hopeless = 0;
};

/// Compares the shortest change (the smallest set of omitted free moves) of a run that violates `property` with all
/// sets of free moves. `timed` is `network` with its clocks.
void expect_smallest(const Network& network, const Network& timed, const Property& property, const grafverif::Run& run,
                     ChangeCounts& counts) {
    const auto good = [&](const NetworkState& state) {
        const bool is_considered = !property.at_stable || value(network, state, network.settled) == 1;
        return !is_considered || value(network, state, property.operands[0]) == (property.pattern == Pattern::Always);
    };
    std::vector<std::size_t> free;
    for (std::size_t k = 0; k < run.moves.size(); ++k)
        if (nothing_forces(timed, run.moves[k])) free.push_back(k);
    if (free.size() > 6) return;
    std::size_t least = free.size() + 1;
    for (std::size_t bits = 1; bits < std::size_t{1} << free.size(); ++bits) {
        std::set<std::size_t> left_out;
        for (std::size_t k = 0; k < free.size(); ++k)
            if ((bits >> k & 1U) != 0) left_out.insert(free[k]);
        const auto states = made_again(network, timed, run, left_out);
        if (states && std::ranges::all_of(*states, good)) least = std::min(least, left_out.size());
    }
    const ShortestChange change = shortest_change(network, timed, property, run, 1'000'000);
    EXPECT_FALSE(change.exhausted);
    EXPECT_EQ(change.free_moves, free.size());
    ASSERT_EQ(change.found.has_value(), least <= free.size());
    ++(change.found ? counts.mended : counts.hopeless);
    if (!change.found) return;
    EXPECT_EQ(change.found->left_out.size(), least);
    const auto states = replay(network, change.found->run);
    ASSERT_TRUE(states);
    EXPECT_TRUE(std::ranges::all_of(*states, good));
}

TEST(RandomizedExplain, TheShortestChangeIsTheSmallestSetOfFreeMovesThatAvoidsTheViolation) {
    ChangeCounts counts;
    for (int seed = 1; seed <= test_size(150); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        const auto network = network_for(model);
        if (!network) continue;
        for (const Verdict& verdict : searched(*network).verdicts) {
            if (verdict.outcome != Outcome::Violated || !verdict.about.valid()) continue;
            const Property& property = network->properties[verdict.about];
            if (property.pattern != Pattern::Always && property.pattern != Pattern::Never) continue;
            expect_smallest(*network, *network, property, verdict.run.value(), counts);
        }
    }
    EXPECT_GT(counts.mended, test_size(150) / 40);
    EXPECT_GT(counts.hopeless, 0);
}

// -- proof cores
// -------------------------------------------------------------------------------------------------------

/// Returns the state properties that hold according to the reference semantics. Returns nothing if there are too many
/// states or a model error.
std::optional<std::set<std::string>> hold_naively(const Network& network, std::size_t most = 4000) {
    const NaiveTadd naive(network);
    std::set<TaddState> seen = {naive.initial()};
    std::vector<TaddState> open = {naive.initial()};
    std::set<std::string> met, missed;
    while (!open.empty()) {
        const TaddState state = std::move(open.back());
        open.pop_back();
        for (const Property& property : network.properties) {
            if (property.at_stable && !naive.settled(state)) continue;
            const auto holding =
                std::ranges::count_if(property.operands, [&](Id<Expr> operand) { return naive.holds(operand, state); });
            (holding == (property.pattern == Pattern::Never ? 0 : 1) ? met : missed).insert(property.name);
        }
        if (network.race.valid() && state.variables[network.race.index] != 0) return {};
        for (TaddMove& move : naive.successors(state)) {
            if (move.out_of_range || seen.size() > most) return {};
            if (seen.insert(move.next).second) open.push_back(std::move(move.next));
        }
    }
    std::set<std::string> holding;
    for (const Property& property : network.properties)
        if (property.pattern == Pattern::Reachable ? met.contains(property.name) : !missed.contains(property.name))
            holding.insert(property.name);
    return holding;
}

/// Returns the result of hold_naively for one property.
std::optional<bool> holds_naively(const Network& network, const std::string& name) {
    const auto holding = hold_naively(network);
    if (!holding) return {};
    return holding->contains(name);
}

bool is_in(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// Returns the network without timers, instances and timings that are not in the proof core `ground`, and without the
/// element `also`.
Network left_open(const Network& network, const ProofExplanation::ProofCore& ground, const std::string& also) {
    Network open = network;
    const std::vector<std::string> shown_names = display_names(network);
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Network::Process& process = network.processes[id];
        const std::string& name = shown_names[id.index];
        if (process.kind == Network::ProcessKind::Controller) continue;
        if (is_in(ground.parts, name) && name != also) {
            const bool timer = process.kind == Network::ProcessKind::Timer;
            if (!timer && !is_in(ground.timings, name)) drop_timing(open, id);
        } else if (process.kind == Network::ProcessKind::Timer) {
            drop_timing(open, id);
        } else {
            EXPECT_TRUE(drop_instance(open, id));
        }
    }
    return open;
}

/// Returns a loop of a chart with three steps, which moves a cylinder with a short stroke. The conditions and the six
/// properties are random.
std::string random_cylinder(Random& random, bool possible = false) {
    const auto pick = [&](const std::vector<std::string>& words) { return words[below(random, words.size())]; };
    const std::vector<std::string> conditions = {"a", "b", "c", "!a", "!b", "!c", "a && c", "!a && !b"};
    const std::vector<std::string> terms = {"o0", "o1", "a",  "b",  "c",      "!a",
                                            "!b", "X0", "X1", "X2", "X == 3", "X == 0"};
    std::string text = "grafcet g { input a, b, c; output o0, o1;\n";
    for (int k = 0; k < 3; ++k) {
        const std::string n = std::to_string(k);
        text += std::string(k == 0 ? "initial " : "") + "step " + n + " { " +
                pick({"", "o0;", "o1;", "o1 if a || b;"}) + " }\n";
        text += "transition t" + n + ": " + n + " -> " + std::to_string((k + 1) % 3) + " when " +
                (below(random, 4) == 0 ? "2s/X" + n : pick(conditions)) + ";\n";
    }
    text += "transition t3: " + pick({"1 -> 0", "2 -> 1", "0 -> 2"}) + " when " + pick(conditions) + "; }\n";
    text +=
        "closed_loop l { controller g; environment C = push_button(OUT = c);\n"
        "plant Act = cylinder_5_3(G_IN = o0, G_OUT = o1, X = X, X_max = 3);\n"
        "plant Sen = position_sensors_2(X = X, IN = a, OUT = b, X_IN_max = 1, X_OUT_min = 3) initially in;\n";
    for (int k = 0; k < 6; ++k)
        text += "property p" + std::to_string(k) +
                (possible ? ": always possible "
                 : k < 4  ? ": never "
                          : ": reachable ") +
                pick(terms) + " && " + pick(terms) + pick({";\n", " at stable;\n"});
    return text + "}\n";
}

TEST(RandomizedExplain, RunOfAnUntimedLoopIsARunOfItsNetworkWithTheSameSmallestChange) {
    ChangeCounts counts;
    for (int seed = 1; seed <= test_size(24); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const ParseResult reading = read_string(random_cylinder(random), "cylinder");
        ASSERT_TRUE(reading.model) << reading.diagnostics_text();
        const Model& model = *reading.model;
        ModelOptions how{{}, seed % 2 == 0 ? Grain::Atomic : Grain::Phased};
        how.untimed.plant = PlantApproach::Automata;
        how.untimed.time = seed % 5 == 0 ? TimeModel::Discrete : TimeModel::Abstract;
        const auto network = network_for(model, how);
        Diagnostics diagnostics;
        const auto system = transition_system_of(model, Id<ClosedLoop>{0}, how, diagnostics);
        ASSERT_TRUE(network && system);
        const Network timed = expand(*network);
        const Network played = system->ticks.valid() ? timed : without_clocks(timed);
        const SymbolicResult result = searched(*system, {Pattern::Always, Pattern::Never});
        for (std::size_t k = 0; k < result.verdicts.size(); ++k) {
            const Property& property = system->properties[result.verdicts[k].about];
            const auto requested = std::ranges::find(played.properties, property.name, &Property::name);
            if (result.verdicts[k].outcome != Outcome::Violated || requested == played.properties.end()) continue;
            const auto moves = moves_of(played, *system, result.runs[k].value());
            ASSERT_TRUE(moves) << property.name;
            const auto states = replay(played, moves->run);
            ASSERT_TRUE(states);
            EXPECT_EQ(value(played, states->back(), requested->operands[0]), property.pattern == Pattern::Never);
            expect_smallest(played, timed, *requested, moves->run, counts);
        }
    }
    EXPECT_GT(counts.mended, 0);
    EXPECT_GT(counts.hopeless, 0);
}

/// Returns the names of random instances, each with a random level of abstraction.
InputsAbstracted random_abstraction(Random& random, const Model& model) {
    InputsAbstracted made;
    for (const ClosedLoop::Instance& instance : model.loops[{0}].instances)
        for (auto* level : {&made.chosen, &made.untimed, &made.paced})
            if (chance(random, 40)) {
                level->push_back(instance.name);
                break;
            }
    return made;
}

/// Returns the variants of the model in the order of `why_it_holds`. Each variant lacks one element and is paired with
/// the reported kind of this element.
std::vector<std::pair<ProofExplanation::Kind, Model>> left_out_one_by_one(const Model& model) {
    std::vector<std::pair<ProofExplanation::Kind, Model>> all;
    const auto add = [&](ProofExplanation::Kind kind, const auto& leave_out) {
        Model less = model;
        if (leave_out(less)) all.emplace_back(kind, std::move(less));
    };
    const Chart& chart = model.charts[{0}];
    const ClosedLoop& loop = model.loops[{0}];
    for (const auto id : chart.transitions.ids())
        add(ProofExplanation::Kind::Transition,
            [&](Model& less) { return drop_transition(less.charts[{0}], id), true; });
    for (const auto id : chart.steps.ids())
        add(ProofExplanation::Kind::Step, [&](Model& less) { return drop_actions(less.charts[{0}], id); });
    for (const TermPlace& place : terms_of(chart))
        add(ProofExplanation::Kind::Term, [&](Model& less) { return remove_term(less.charts[{0}], place), true; });
    for (const ProofExplanation::Kind kind : {ProofExplanation::Kind::Guard, ProofExplanation::Kind::Edge})
        for (const auto id : loop.instances.ids())
            for (const auto edge : model.components[loop.instances[id].component].edges.ids())
                add(kind, [&](Model& less) {
                    const bool guard = kind == ProofExplanation::Kind::Guard;
                    if (guard && !is_guarded(model.components[loop.instances[id].component], edge)) return false;
                    (guard ? drop_guard : drop_edge)(less, {0}, id, edge);
                    return true;
                });
    return all;
}

TEST(RandomizedExplain, ReportedProofCoresAgreeWithTheReferenceSemantics) {
    int needed = 0, enough = 0;
    // Numbers of elements that the proof does not need, and of elements that it needs.
    std::map<ProofExplanation::Kind, std::array<int, 2>> by_itself;
    for (int seed = 1; seed <= test_size(15); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const ParseResult reading = read_string(random_cylinder(random), "cylinder");
        ASSERT_TRUE(reading.model) << reading.diagnostics_text();
        const Model& model = *reading.model;
        const ModelOptions how{{}, Grain::Atomic};
        const auto network = network_for(model, how);
        ASSERT_TRUE(network);
        const CheckOptions options;
        Diagnostics diagnostics;
        const auto report = check(model, {0}, how, options, diagnostics);
        ASSERT_TRUE(report);
        // With odd seeds, the explanation is computed in passes with abstractions of the variants; the first pass
        // begins with a random abstraction.
        const VariantBounds in_passes{.few_states = 0, .brief = 8};
        Report known = *report;
        for (PropertyResult& answer : known.answers) answer.verdict.abstraction = random_abstraction(random, model);
        const ProofExplanation why = seed % 2 == 1 ? why_it_holds(model, {0}, how, options, known, in_passes)
                                                   : why_it_holds(model, {0}, how, options, *report);
        if (why.grounds.empty()) continue;
        const auto one_by_one = left_out_one_by_one(model);
        const bool states = std::ranges::any_of(why.grounds, &ProofExplanation::ProofCore::about_states);
        std::size_t next = 0;
        for (const auto& [kind, less] : one_by_one) {
            if (kind == ProofExplanation::Kind::Guard && !states) continue;
            ASSERT_LT(next, why.things.size());
            const ProofExplanation::ModelElement& element = why.things[next++];
            ASSERT_EQ(element.kind, kind) << element.name;
            const bool many = kind == ProofExplanation::Kind::Guard || kind == ProofExplanation::Kind::Edge;
            if (many && next % 2 != static_cast<std::size_t>(seed) % 2) continue;
            const auto found = hold_naively(*network_for(less, how), 1500);
            if (!found) continue;
            for (const ProofExplanation::ProofCore& ground : why.grounds) {
                if (is_in(element.open, ground.property) ||
                    (kind == ProofExplanation::Kind::Guard && !ground.about_states))
                    continue;
                const bool fails = is_in(element.needed_by, ground.property);
                EXPECT_EQ(found->contains(ground.property), !fails)
                    << ground.property << ", " << word(kind) << ' ' << element.name << ' ' << element.of;
                ++by_itself[kind][fails ? 1 : 0];
            }
        }
        EXPECT_EQ(next, why.things.size());
        const Network flat = expand(*network);
        for (const ProofExplanation::ProofCore& ground : why.grounds) {
            if (!ground.about_states || !ground.open.empty()) continue;
            SCOPED_TRACE(ground.property);
            const auto found = holds_naively(left_open(flat, ground, ""), ground.property);
            if (!found) continue;
            EXPECT_TRUE(*found);
            ++enough;
            for (const std::string& part : ground.parts) {
                const auto less = holds_naively(left_open(flat, ground, part), ground.property);
                EXPECT_NE(less, true) << part;
                needed += less ? 1 : 0;
            }
        }
    }
    EXPECT_GT(enough, test_size(15));
    EXPECT_GT(needed, test_size(15) / 2);
    EXPECT_EQ(by_itself.size(), 5U);
    for (const auto& [kind, count] : by_itself) {
        EXPECT_GT(count[0], test_size(15)) << word(kind);
        EXPECT_GT(count[1], test_size(15) / 4) << word(kind);
    }
}

// The charts from which `remove_term` removes one term must be exactly the mutants of kind
// `term-dropped`, which `mutants` generates independently from the text of the chart.
TEST(RandomizedExplain, RemovingATermAgreesWithTheTextWithoutIt) {
    int same = 0;
    for (int seed = 1; seed <= test_size(25); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed) + 500);
        const std::string written = chart_text(tidied(random_chart(random)));
        const auto read_again = [](const std::string& text) -> std::optional<std::string> {
            const ParseResult reading = read_string(text, "law");
            if (!reading.model) return {};
            return chart_text(tidied(*reading.model->charts.begin()));
        };
        const ParseResult reading = read_string(written, "law");
        if (!reading.model) continue;
        const Chart& chart = *reading.model->charts.begin();
        Sources sources;
        Diagnostics diagnostics;
        const tree::File file = parse_file(sources.add({"law", chart_text(tidied(chart))}), sources, diagnostics);
        std::set<std::string> mutated, dropped;
        for (const Mutant& mutant : mutants(file, chart.name)) {
            if (mutant.kind != "term-dropped") continue;
            if (const auto text = read_again(mutant.text)) mutated.insert(*text);
        }
        for (const TermPlace& place : terms_of(chart)) {
            if (place.path.empty() || place.of == TermPlace::Of::Event) continue;
            Chart less = chart;
            remove_term(less, place);
            if (const auto text = read_again(chart_text(tidied(less)))) dropped.insert(*text);
        }
        mutated.erase(written);
        dropped.erase(written);
        EXPECT_EQ(dropped, mutated) << written;
        same += static_cast<int>(dropped.size());
    }
    EXPECT_GT(same, test_size(25));
}

/// Returns the states of `network`, without clocks and without the location of the process `left_out`. Returns nothing
/// if there are too many states.
std::optional<std::set<TaddState>> places_of(const Network& network, Id<Network::Process> left_out = {}) {
    const NaiveTadd naive(network);
    std::set<TaddState> seen = {naive.initial()}, places;
    std::vector<TaddState> open = {naive.initial()};
    while (!open.empty()) {
        TaddState state = std::move(open.back());
        open.pop_back();
        for (TaddMove& move : naive.successors(state)) {
            if (seen.size() > 6000) return {};
            if (!move.out_of_range && seen.insert(move.next).second) open.push_back(std::move(move.next));
        }
        state.clocks.clear();
        if (left_out.valid()) state.locations[left_out.index] = 0;
        places.insert(std::move(state));
    }
    return places;
}

// Tests the premise of proofs that remove an instance or the clocks of a process: the removal only
// adds reachable states.
TEST(RandomizedExplain, RemovalOfAnInstanceOrATimingOnlyAddsStates) {
    int instances = 0, timings = 0;
    for (int seed = 1; seed <= test_size(8); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const ParseResult reading = read_string(random_cylinder(random), "cylinder");
        ASSERT_TRUE(reading.model) << reading.diagnostics_text();
        const Network flat = expand(*network_for(*reading.model, ModelOptions{{}, Grain::Atomic}));
        for (const Id<Network::Process> id : flat.processes.ids()) {
            if (flat.processes[id].kind == Network::ProcessKind::Controller) continue;
            const bool timer = flat.processes[id].kind == Network::ProcessKind::Timer;
            const auto with = places_of(flat, id);
            for (const bool whole : {false, true}) {
                Network less = flat;
                if (whole ? timer || !drop_instance(less, id) : !drop_timing(less, id)) continue;
                const auto without = places_of(less, id);
                if (!with || !without) continue;
                EXPECT_TRUE(std::ranges::includes(*without, *with))
                    << flat.processes[id].name << (whole ? "" : "'s times");
                ++(whole ? instances : timings);
            }
        }
    }
    EXPECT_GT(instances, test_size(8));
    EXPECT_GT(timings, test_size(8));
}

// Tests the premise of proofs that remove a guard: the removal only adds reachable states. The
// removal of an edge that is not forced needs no search, because it adds no reachable state.
TEST(RandomizedExplain, RemovalOfAGuardOnlyAddsStatesAndRemovalOfAnUnforcedEdgeAddsNone) {
    int guards = 0, edges = 0;
    for (int seed = 1; seed <= test_size(6); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const ParseResult reading = read_string(random_cylinder(random), "cylinder");
        ASSERT_TRUE(reading.model) << reading.diagnostics_text();
        const Model& model = *reading.model;
        const ModelOptions how{{}, seed % 3 == 0 ? Grain::Phased : Grain::Atomic};
        const auto with = places_of(*network_for(model, how));
        if (!with) continue;
        const ClosedLoop& loop = model.loops[{0}];
        for (const auto id : loop.instances.ids()) {
            const Component& component = model.components[loop.instances[id].component];
            for (const auto edge : component.edges.ids()) {
                Model less = model;
                drop_guard(less, {0}, id, edge);
                if (const auto more = places_of(*network_for(less, how))) {
                    EXPECT_TRUE(std::ranges::includes(*more, *with)) << loop.instances[id].name << edge.index;
                    guards += is_guarded(component, edge) ? 1 : 0;
                    if (!is_guarded(component, edge)) {
                        EXPECT_EQ(*more, *with);
                    }
                }
                if (is_forced(component, edge)) continue;
                less = model;
                drop_edge(less, {0}, id, edge);
                const auto fewer = places_of(*network_for(less, how));
                ASSERT_TRUE(fewer);
                EXPECT_TRUE(std::ranges::includes(*with, *fewer)) << loop.instances[id].name << edge.index;
                ++edges;
            }
        }
    }
    EXPECT_GT(guards, test_size(6));
    EXPECT_GT(edges, test_size(6) / 2);
}

/// Returns the last state of a run, computed by the reference semantics.
TaddState end_of(const NaiveTadd& naive, const grafverif::Run& run) {
    TaddState state = naive.initial();
    const auto take = [&](const Fire* fire) {
        for (const TaddMove& move : naive.successors(state)) {
            const bool same = fire == nullptr ? move.delay() : move.process == fire->process && move.edge == fire->edge;
            if (!same) continue;
            state = move.next;
            return;
        }
        ADD_FAILURE() << "the run cannot be continued";
    };
    for (const Move& move : run.moves)
        if (const Delay* const delay = std::get_if<Delay>(&move))
            for (std::int64_t k = 0; k < delay->units; ++k) take(nullptr);
        else take(std::get_if<Fire>(&move));
    return state;
}

/// Returns the transitions cleared in `state`. The cleared transitions are visible in `state` or,
/// in grain atomic, in the state after the edge of the PLC.
std::set<std::string> cleared_in(const Network& network, const TaddState& state) {
    const Network::Controller& controller = *network.controllers.begin();
    NetworkState now = initial_state(network);
    for (std::size_t k = 0; k < state.locations.size(); ++k) now.locations[k] = {state.locations[k]};
    now.variables = state.variables;
    std::set<std::string> found;
    const auto look = [&](const NetworkState& there) {
        for (const auto& each : controller.words.transitions)
            if (there.variables[each.variable.index] != 0) found.insert(each.name);
    };
    if (network.grain == Grain::Phased) look(now);
    for (const Fire& fire : enabled(network, now)) {
        NetworkState next = now;
        const auto& calls = edge_of(network, fire).calls;
        const bool fires =
            fire.process == controller.process && std::ranges::find(calls, controller.fire) != calls.end();
        if (network.grain == Grain::Phased || !fires) continue;
        EXPECT_EQ(perform(network, next, fire).result, Step::Result::Done);
        look(next);
    }
    return found;
}

struct LostCounts {
    int never = 0, still = 0;
};

/// Compares `note`, which lists dead transitions after the end of the run, with all states that are reachable from that
/// end.
void expect_never_again(const Network& network, const grafverif::Run& run, const std::string& note,
                        LostCounts& counts) {
    const NaiveTadd naive(network);
    const std::string words = note + ",";
    std::set<TaddState> seen = {end_of(naive, run)};
    std::vector<TaddState> open(seen.begin(), seen.end());
    std::set<std::string> cleared;
    while (!open.empty() && seen.size() < 3000) {
        const TaddState state = std::move(open.back());
        open.pop_back();
        cleared.merge(cleared_in(network, state));
        for (const TaddMove& move : naive.successors(state))
            if (seen.insert(move.next).second) open.push_back(move.next);
    }
    for (const auto& each : network.controllers.begin()->words.transitions) {
        const bool named = words.find(" " + each.name + ",") != std::string::npos ||
                           words.find(" " + each.name + " (") != std::string::npos;
        const bool fires = cleared.contains(each.name);
        EXPECT_FALSE(named && fires) << each.name << ": " << words;
        EXPECT_TRUE(named || fires || !open.empty()) << each.name << ": " << words;
        ++(named ? counts.never : counts.still);
    }
}

/// Returns the note that lists dead transitions, or an empty string.
std::string lost_note(const Verdict& verdict) {
    const auto found =
        std::ranges::find_if(verdict.notes, [](const std::string& note) { return note.starts_with(dead_text); });
    return found == verdict.notes.end() ? "" : *found;
}

void expect_some(std::map<Grain, LostCounts>& counts) {
    for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
        EXPECT_GT(counts[grain].never, 0);
        EXPECT_GT(counts[grain].still, 0);
    }
}

TEST(RandomizedExplain, DeadTransitionsAreNeverClearedInTheReferenceSemantics) {
    std::map<Grain, LostCounts> counts;
    for (int seed = 1; seed <= test_size(25); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const ParseResult reading = read_string(random_cylinder(random, true), "cylinder");
        ASSERT_TRUE(reading.model) << reading.diagnostics_text();
        const Grain grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased;
        const auto network = network_for(*reading.model, ModelOptions{{}, grain});
        ASSERT_TRUE(network);
        std::set<std::string> reported;
        for (const Verdict& verdict : searched(*network).verdicts) {
            if (verdict.pattern != Pattern::AlwaysPossible || verdict.outcome != Outcome::Violated) continue;
            const std::string note = lost_note(verdict);
            if (reported.insert(note).second) expect_never_again(*network, verdict.run.value(), note, counts[grain]);
        }
    }
    expect_some(counts);
}

TEST(RandomizedExplain, DeadTransitionsOfAnUntimedLoopAreDeadInItsNetworkWithoutClocks) {
    std::map<Grain, LostCounts> counts;
    for (int seed = 1; seed <= test_size(6); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const ParseResult reading = read_string(random_cylinder(random, true), "cylinder");
        ASSERT_TRUE(reading.model) << reading.diagnostics_text();
        ModelOptions how{{}, seed % 2 == 0 ? Grain::Atomic : Grain::Phased};
        how.untimed.plant = PlantApproach::Automata;
        const auto network = network_for(*reading.model, how);
        Diagnostics diagnostics;
        const auto system = transition_system_of(*reading.model, Id<ClosedLoop>{0}, how, diagnostics);
        ASSERT_TRUE(network && system);
        const Network played = without_clocks(expand(*network));
        const SymbolicResult result = searched(*system, {Pattern::AlwaysPossible});
        std::set<std::string> reported;
        for (std::size_t k = 0; k < result.verdicts.size(); ++k) {
            const Verdict& verdict = result.verdicts[k];
            if (verdict.pattern != Pattern::AlwaysPossible || verdict.outcome != Outcome::Violated) continue;
            const std::string note = lost_note(verdict);
            if (!reported.insert(note).second) continue;
            const auto moves = moves_of(played, *system, result.runs[k].value());
            ASSERT_TRUE(moves);
            expect_never_again(played, moves->run, note, counts[network->grain]);
        }
    }
    expect_some(counts);
}

}  // namespace
}  // namespace grafverif
