// SPDX-License-Identifier: MIT
// Randomized test: charts that `compare` reports as equal have equal outputs in random scans of the interpreter. In the
// interpreter, a distinguishing sequence distinguishes the charts in its last scan and not before. If it is reported as
// shortest, no shorter random sequence distinguishes them. The test uses charts and their mutants in both execution
// modes, including timed charts. The test also checks that a mutant of `mutate` is read back as
// written and differs from its chart in one element, and compares some mutants with their charts.
#include "pipeline/variants/compare.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <sstream>

#include "compare/difference.hpp"
#include "compare/mutants.hpp"
#include "derive/derive.hpp"
#include "emit/structured_text/structured_text.hpp"
#include "grafverif/grafverif.hpp"
#include "report/charts/comparison.hpp"
#include "run/interpreter.hpp"
#include "run/scanner.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif {
namespace {

constexpr std::size_t most_steps = 6;  ///< maximum number of steps of a chart that is compared

/// Counts the cases in the random charts.
struct Met {
    int equal = 0, different = 0, timed = 0, stops = 0, long_ones = 0, shortest = 0, unknown = 0;
};

/// Executes one chart scan by scan with the interpreter, independently of Lockstep.
class Plc {
public:
    Plc(const Chart& chart, ExecutionMode mode) : chart_(chart), mode_(mode), state_(power_on(chart)) {}

    /// Returns the outputs by name, or nothing if the chart stops. `inputs` are in the order of the chart's inputs.
    std::optional<std::vector<std::pair<std::string, std::int64_t>>> scan(std::int64_t wait,
                                                                          const std::vector<std::int64_t>& inputs) {
        if (state_.started) state_ = pass_time(state_, wait);
        std::vector<std::int64_t> values(chart_.variables.size());
        std::size_t next = 0;
        for (const auto id : chart_.variables.ids())
            if (chart_.variables[id].kind == Chart::VariableKind::Input) values[id.index] = inputs[next++];
        const Cycle run = cycle(chart_, state_, values, mode_);
        if (run.race || run.fault || run.gave_up || !run.endless.empty()) return {};
        state_ = run.state;
        std::vector<std::pair<std::string, std::int64_t>> outputs;
        for (const auto id : chart_.variables.ids())
            if (chart_.variables[id].kind == Chart::VariableKind::Output)
                outputs.emplace_back(chart_.variables[id].name, state_.outputs[id.index]);
        return outputs;
    }

private:
    const Chart& chart_;
    ExecutionMode mode_;
    State state_;
};

/// Returns the index of the first scan with different outputs. Returns nothing if the outputs are equal until the
/// charts stop.
std::optional<std::size_t> difference(const Chart& a, const Chart& b, ExecutionMode mode,
                                      const std::vector<Comparison::Scan>& scans) {
    Plc one(a, mode), other(b, mode);
    for (std::size_t k = 0; k < scans.size(); ++k) {
        const auto of_a = one.scan(scans[k].wait_ms, scans[k].inputs),
                   of_b = other.scan(scans[k].wait_ms, scans[k].inputs);
        if (of_a != of_b) return k;
        if (!of_a) return {};
    }
    return {};
}

std::vector<Comparison::Scan> random_scans(const Comparison& about, Random& random) {
    std::vector<Comparison::Scan> scans;
    std::vector<std::int64_t> inputs;
    for (const Comparison::Variable& input : about.inputs) inputs.push_back(std::max<std::int64_t>(0, input.type.low));
    for (int k = 0; k < 25; ++k) {
        for (std::size_t i = 0; i < inputs.size(); ++i)
            if (chance(random, 40))
                inputs[i] = random_number(random, about.inputs[i].type.low, about.inputs[i].type.high);
        const std::int64_t units = chance(random, 50) ? 0 : random_number(random, 1, chance(random, 50) ? 3 : 20);
        scans.push_back({units * about.resolution_ms, inputs});
    }
    return scans;
}

/// Returns the chart with one element changed. The changed chart may be invalid.
Chart mutant(Chart chart, Random& random) {
    const auto any = [&](auto& table) -> auto& {
        return table[*(table.ids().begin() + random_number(random, 0, static_cast<std::int64_t>(table.size()) - 1))];
    };
    switch (random_number(random, 0, 5)) {
    case 0: {
        Chart::Transition& transition = any(chart.transitions);
        transition.condition = chart.exprs.negation(transition.condition);
        break;
    }
    case 1: {
        Chart::Transition& transition = any(chart.transitions);
        transition.condition = chart.exprs.conjunction(transition.condition, any(chart.transitions).condition);
        break;
    }
    case 2:
        if (!chart.continuous.empty()) {
            Chart::ContinuousAction& action = any(chart.continuous);
            action.condition = chart.exprs.constant(false);
        }
        break;
    case 3:
        if (!chart.time_conditions.empty()) {
            Chart::TimeCondition& time = any(chart.time_conditions);
            if (time.rise_ms > 0) time.rise_ms += 500;
        }
        break;
    case 4:
        if (!chart.stored.empty()) {
            Chart::StoredAction& action = any(chart.stored);
            if (action.on == Chart::StoredOn::Activation) action.on = Chart::StoredOn::Deactivation;
        }
        break;
    case 5: {
        Chart::Transition& transition = any(chart.transitions);
        if (!transition.from.empty())
            transition.condition = chart.exprs.conjunction(transition.condition,
                                                           chart.exprs.leaf(Op::Step, transition.from.front().index));
        break;
    }
    }
    return tidied(chart);
}

std::string text_of_comparison(const Comparison& comparison) {
    std::ostringstream text;
    print_result(comparison, Colour::Plain, text);
    return std::move(text).str();
}

Model model_of(const Chart& chart) {
    Model model;
    model.charts.add(chart);
    return model;
}

/// Returns the error in the verdict on both charts. Returns an empty string if the verdict is right, or if one of the
/// charts is rejected.
std::string violation(const Chart& a, const Chart& b, ExecutionMode mode, Random random, Met& met) {
    Diagnostics diagnostics;
    if (!derive(a, diagnostics) || !derive(b, diagnostics)) return {};
    const Model one = model_of(a), other = model_of(b);
    CompareOptions options{.mode = mode};
    options.limits.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    const auto found =
        compare(one, *one.charts.ids().begin(), other, *other.charts.ids().begin(), options, diagnostics);
    if (!found) return diagnostics.all().front().code == "not-comparable" ? "" : diagnostics.all().front().message;
    if (!found->failures.empty()) return found->failures.front();
    met.timed += found->resolution_ms > 0 ? 1 : 0;
    if (found->outcome == Comparison::Outcome::Unknown) return ++met.unknown, "";
    if (found->outcome == Comparison::Outcome::Different) {
        ++met.different;
        met.long_ones += found->scans.size() > 2 ? 1 : 0;
        met.stops += found->answers[0].back().stop.empty() && found->answers[1].back().stop.empty() ? 0 : 1;
        if (difference(a, b, mode, found->scans) != found->scans.size() - 1)
            return "the scans do not distinguish the charts";
        if (!found->shortest) return "";
        ++met.shortest;
    } else ++met.equal;
    for (int run = 0; run < 40; ++run) {
        const std::vector<Comparison::Scan> scans = random_scans(*found, random);
        const auto apart = difference(a, b, mode, scans);
        if (apart && (found->outcome == Comparison::Outcome::Equal || *apart + 1 < found->scans.size()))
            return "random scans distinguish the charts, in scan " + std::to_string(*apart + 1);
    }
    return {};
}

TEST(RandomizedCompare, VerdictsAreThoseOfRandomScans) {
    Met met;
    for (int seed = 1; seed <= test_size(16); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = tidied(random_chart(random, chance(random, 50) ? TimedTerms::Any : TimedTerms::Steps));
        if (chart.steps.size() > most_steps) continue;
        const ExecutionMode mode = chance(random, 50) ? ExecutionMode::StabilitySearch : ExecutionMode::EveryCycle;
        const Chart other = mutant(chart, random);
        const std::string wrong = violation(chart, other, mode, random, met);
        ASSERT_EQ(wrong, "") << "seed " << seed << ", " << word(mode) << '\n' << chart_text(chart) << chart_text(other);
    }
    RecordProperty("equal", met.equal);
    RecordProperty("unknown", met.unknown);
    if (std::getenv("GRAFVERIF_TEST_SIZE") != nullptr)
        std::cout << met.equal << " equal, " << met.different << " different (" << met.shortest << " shortest, "
                  << met.long_ones << " of three scans or more, " << met.stops << " stops), " << met.timed << " timed, "
                  << met.unknown << " unknown\n";
    EXPECT_GT(met.different, 1);
    EXPECT_GT(met.timed, 0);
    EXPECT_GT(met.equal + met.different, met.unknown);
}

TEST(RandomizedCompare, AChartWithOtherNamesForItsStepsIsTheSame) {
    Met met;
    for (int seed = 1; seed <= test_size(4); ++seed) {
        Random random(static_cast<std::uint64_t>(seed) + 1000);
        const Chart chart = tidied(random_chart(random));
        if (chart.steps.size() > most_steps) continue;
        Chart renamed = chart;
        for (const auto step : renamed.steps.ids()) renamed.steps[step].name = "R" + renamed.steps[step].name;
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle})
            ASSERT_EQ(violation(chart, renamed, mode, random, met), "") << "seed " << seed << '\n' << chart_text(chart);
        ASSERT_EQ(met.different, 0) << "seed " << seed << '\n' << chart_text(chart);
        ASSERT_TRUE(difference(chart, chart).empty());
        for (const ChartChange& change : difference(chart, renamed))
            ASSERT_TRUE(change.kind == ChartChange::Kind::Renamed || !change.before.empty() || !change.after.empty());
    }
    EXPECT_GT(met.equal, 0);
}

/// Returns a text about the differing elements, or an empty string if the charts differ only in the
/// element that the mutation reports.
std::string misplaced(const Mutant& mutant, const Chart& a, const Chart& b) {
    std::set<std::string> subjects;
    for (const ChartChange& change : difference(a, b)) {
        std::string subject = change.subject;
        if (subject.starts_with("action of ")) subject.erase(0, std::string("action of ").size());
        const std::size_t partial = subject.rfind('.');  // `step G1.11` is `step 11` in its partial chart
        if (subject.starts_with("step ") && partial != subject.npos) subject = "step " + subject.substr(partial + 1);
        subjects.insert(subject);
    }
    const std::size_t places = mutant.kind == "and-divergence" || mutant.kind == "or-divergence" ? 2 : 1;
    if (subjects.contains(mutant.subject) && subjects.size() <= places) return {};
    return mutant.kind + " of " + mutant.subject + " is reported for " + ::testing::PrintToString(subjects);
}

TEST(RandomizedCompare, MutantsDifferInOnePlaceAndEquivalentOnesAreNeverDistinguished) {
    Met met;
    constexpr std::size_t most = 4;  // maximum number of mutants of each chart that are compared
    int read = 0, refused = 0;
    std::set<std::string> kinds;
    for (int seed = 1; seed <= test_size(8); ++seed) {
        Random random(static_cast<std::uint64_t>(seed) + 2000);
        const Chart drawn = tidied(random_chart(random, TimedTerms::Steps));
        if (drawn.steps.size() > most_steps) continue;
        Sources sources;
        Diagnostics diagnostics;
        const tree::File file = parse_file(sources.add({"law", chart_text(drawn)}), sources, diagnostics);
        const ParseResult original = read_string(formatted(file), "law", {});
        if (!original.model) continue;
        const Chart& chart = *original.model->charts.begin();
        std::vector<Mutant> all = mutants(file, chart.name);
        std::shuffle(all.begin(), all.end(), random);
        for (std::size_t k = 0; k < std::min<std::size_t>(all.size(), 40); ++k) {
            SCOPED_TRACE(all[k].text);
            const tree::File back = parse_file(sources.add({"mutant", all[k].text}), sources, diagnostics);
            ASSERT_FALSE(back.broken) << "seed " << seed;
            ASSERT_EQ(formatted(back), all[k].text) << "seed " << seed;
            const ParseResult reading = read_string(all[k].text, "law", {});
            if (!reading.model && ++refused) continue;
            ++read;
            kinds.insert(all[k].kind);
            const Chart& mutated = *reading.model->charts.begin();
            ASSERT_EQ(misplaced(all[k], chart, mutated), "") << "seed " << seed << '\n' << formatted(file);
            if (k >= most) continue;
            const ExecutionMode mode = chance(random, 50) ? ExecutionMode::StabilitySearch : ExecutionMode::EveryCycle;
            ASSERT_EQ(violation(chart, mutated, mode, random, met), "") << "seed " << seed << ", " << word(mode) << '\n'
                                                                        << formatted(file);
        }
    }
    if (std::getenv("GRAFVERIF_TEST_SIZE") != nullptr)
        std::cout << read << " mutants of " << kinds.size() << " kinds, " << refused << " rejected; " << met.equal
                  << " equal, " << met.different << " different, " << met.unknown << " unknown\n";
    EXPECT_GT(read, refused);
    EXPECT_GT(kinds.size(), 5U);
    EXPECT_GT(met.equal + met.different, met.unknown);
}

/// Returns the Structured Text of the chart, or nothing if it cannot be expressed.
std::optional<std::string> controller_text(const Chart& chart, ExecutionMode mode) {
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!equations || !structured_text::expressible(*equations, diagnostics)) return {};
    std::ostringstream out;
    structured_text::emit(*equations, {mode, 12, structured_text::Form::Text}, out);
    return std::move(out).str();
}

/// Compares a chart with the Structured Text of `other`. Returns nothing if one of them is rejected.
std::optional<Comparison> with_controller(const Chart& chart, const Chart& other, ExecutionMode mode, bool turned,
                                          std::string& error) {
    const auto text = controller_text(other, mode);
    Diagnostics diagnostics;
    if (!text || !derive(chart, diagnostics) || variables_of_kind(chart, Chart::VariableKind::Output).empty())
        return {};
    Sources sources;
    const Model model = model_of(chart);
    const CompareOperand of_chart{&model, *model.charts.ids().begin(), {}};
    const CompareOperand program{nullptr, {}, sources.add({"controller.st", *text})};
    CompareOptions options{.mode = mode};
    options.limits.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    options.resolution_ms = 500;
    auto found = turned ? compare(program, of_chart, options, {.stop = {"FAULT"}}, sources, diagnostics)
                        : compare(of_chart, program, options, {.stop = {"FAULT"}}, sources, diagnostics);
    std::ostringstream errors;
    render_text(diagnostics.all(), sources, Colour::Plain, errors);
    if (!found) error = std::move(errors).str() + *text;
    else if (!found->failures.empty()) error = found->failures.front() + '\n' + *text;
    return found;
}

/// True if the program stops in the last scan and the chart does not, for example because the program reaches its
/// maximum number of evolutions.
bool is_cut(const Comparison& found, std::size_t program) {
    return !found.scans.empty() && !found.answers[program].back().stop.empty() &&
           found.answers[1 - program].back().stop.empty();
}

TEST(RandomizedCompare, StructuredTextOfAChartIsEqualToIt) {
    Met met;
    int rejected = 0, cut = 0;
    for (int seed = 1; seed <= test_size(20); ++seed) {
        Random random(static_cast<std::uint64_t>(seed) + 3000);
        const Chart chart = tidied(random_chart(random, chance(random, 20) ? TimedTerms::Any : TimedTerms::Steps));
        if (chart.steps.size() > most_steps) continue;
        const ExecutionMode mode = chance(random, 20) ? ExecutionMode::StabilitySearch : ExecutionMode::EveryCycle;
        const bool turned = chance(random, 50);
        std::string error;
        const auto found = with_controller(chart, chart, mode, turned, error);
        ASSERT_EQ(error, "") << "seed " << seed << ", " << word(mode) << '\n' << chart_text(chart);
        if (!found && ++rejected) continue;
        met.timed += found->resolution_ms > 0 ? 1 : 0;
        if (found->outcome == Comparison::Outcome::Unknown && ++met.unknown) continue;
        if (found->outcome == Comparison::Outcome::Different && mode == ExecutionMode::StabilitySearch &&
            is_cut(*found, turned ? 0 : 1) && ++cut)
            continue;
        ASSERT_EQ(found->outcome, Comparison::Outcome::Equal)
            << "seed " << seed << ", " << word(mode) << '\n'
            << chart_text(chart) << *controller_text(chart, mode) << text_of_comparison(*found);
        ++met.equal;
    }
    if (std::getenv("GRAFVERIF_TEST_SIZE") != nullptr)
        std::cout << met.equal << " equal, " << met.timed << " timed, " << met.unknown << " unknown, " << rejected
                  << " rejected, " << cut << " need more evolutions\n";
    EXPECT_GT(met.equal, met.unknown);
    EXPECT_GT(met.timed, 0);
}

TEST(RandomizedCompare, AChartAndTheStructuredTextOfAMutantDifferAsTheChartsDo) {
    Met met;
    for (int seed = 1; seed <= test_size(20); ++seed) {
        Random random(static_cast<std::uint64_t>(seed) + 4000);
        const Chart chart = tidied(random_chart(random, chance(random, 30) ? TimedTerms::Any : TimedTerms::Steps));
        if (chart.steps.size() > most_steps) continue;
        const Chart other = mutant(chart, random);
        const ExecutionMode mode = chance(random, 20) ? ExecutionMode::StabilitySearch : ExecutionMode::EveryCycle;
        std::string error;
        const bool turned = chance(random, 50);
        const auto found = with_controller(chart, other, mode, turned, error);
        ASSERT_EQ(error, "") << "seed " << seed << ", " << word(mode) << '\n' << chart_text(chart);
        if (!found) continue;
        const Model one = model_of(chart), second = model_of(other);
        CompareOptions options{.mode = mode};
        options.limits.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
        if (found->resolution_ms > 0) options.resolution_ms = 500;
        Diagnostics diagnostics;
        const auto charts =
            compare(one, *one.charts.ids().begin(), second, *second.charts.ids().begin(), options, diagnostics);
        const bool decided =
            charts && charts->outcome != Comparison::Outcome::Unknown && found->outcome != Comparison::Outcome::Unknown;
        if (!decided && ++met.unknown) continue;
        if (mode == ExecutionMode::StabilitySearch && is_cut(*found, turned ? 0 : 1)) continue;
        ASSERT_EQ(found->outcome, charts->outcome)
            << "seed " << seed << ", " << word(mode) << '\n'
            << chart_text(chart) << chart_text(other) << text_of_comparison(*found) << text_of_comparison(*charts);
        ++(found->outcome == Comparison::Outcome::Equal ? met.equal : met.different);
        if (found->shortest && charts->shortest) {
            ++met.shortest;
            ASSERT_EQ(found->scans.size(), charts->scans.size()) << "seed " << seed << '\n'
                                                                 << chart_text(chart) << chart_text(other);
        }
    }
    if (std::getenv("GRAFVERIF_TEST_SIZE") != nullptr)
        std::cout << met.equal << " equal, " << met.different << " different (" << met.shortest << " shortest), "
                  << met.unknown << " unknown\n";
    EXPECT_GT(met.different, 1);
    EXPECT_GT(met.equal + met.different, met.unknown);
}

}  // namespace
}  // namespace grafverif
