// SPDX-License-Identifier: MIT
// Randomized test: `compare` of random programs and their mutants. The verdict must equal that of a search of the pairs
// of states of two interpreters. The search tries all inputs and times in each pair, up to a limit. A reported sequence
// of scans distinguishes the programs in its last scan, and the search finds no shorter sequence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "pipeline/variants/compare.hpp"
#include "support/random_chart.hpp"
#include "support/row_counts.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

constexpr std::int64_t longest_wait = 3;   ///< preset time of the timers in milliseconds
constexpr std::size_t most_pairs = 2'000;  ///< maximum number of pairs of states in the search

/// A program as a list of statements.
struct RandomText {
    bool timed = false, interval = false;
    std::vector<std::string> statements = {};

    std::string text() const {
        std::string body;
        for (const std::string& one : statements) body += "    " + one + "\n";
        return "PROGRAM main\nVAR_INPUT a, b : BOOL; n : USINT(0..3); END_VAR\nVAR_OUTPUT x : BOOL; y : INT; END_VAR\n"
               "VAR s, r : BOOL; c : INT(0..3); m : USINT; v : ARRAY[0..2] OF BOOL; t : TON; END_VAR\n" +
               body + "END_PROGRAM\n" +
               (interval ? "CONFIGURATION k\nTASK every(INTERVAL := T#2ms, PRIORITY := 1);\n"
                           "PROGRAM p WITH every : main;\nEND_CONFIGURATION\n"
                         : "");
    }
};

std::string any_of(Random& random, const std::vector<std::string>& choices) {
    return choices[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(choices.size()) - 1))];
}

std::string condition(Random& random, int depth = 0) {
    if (depth > 1 || chance(random, 45))
        return any_of(
            random, {"a", "b", "s", "r", "x", "(n > 1)", "(c = 2)", "(y < 3)", "(m = 255)", "v[1]", "t.Q", "(NOT a)"});
    return fmt::format("({} {} {})", condition(random, depth + 1), any_of(random, {"AND", "OR", "XOR", "<>"}),
                       condition(random, depth + 1));
}

std::string statement(Random& random, bool timed, int depth = 0) {
    if (depth < 2 && chance(random, 45)) {
        const std::string then = statement(random, timed, depth + 1);
        return chance(random, 50) ? fmt::format("IF {} THEN {} END_IF;", condition(random), then)
                                  : fmt::format("IF {} THEN {} ELSE {} END_IF;", condition(random), then,
                                                statement(random, timed, depth + 1));
    }
    if (timed && chance(random, 30)) return fmt::format("t(IN := {}, PT := T#3ms);", condition(random));
    if (chance(random, 6)) return any_of(random, {"y := 6 / n;", "v[n] := a;", "y := 5 MOD c;"});
    return any_of(random, {fmt::format("x := {};", condition(random)), fmt::format("s := {};", condition(random)),
                           fmt::format("r := {};", condition(random)), "c := (c + 1) MOD 4;", "c := n;", "y := c;",
                           "y := n + c;", "m := m + 1;", "y := m;", "v[c MOD 3] := b;", "y := MAX(y, n);"});
}

RandomText random_text(Random& random) {
    RandomText made;
    made.timed = chance(random, 30);
    made.interval = made.timed && chance(random, 40);
    const std::int64_t count = random_number(random, 3, 6);
    for (std::int64_t i = 0; i < count; ++i) made.statements.push_back(statement(random, made.timed));
    if (chance(random, 40)) made.statements.push_back("m := (m + 1) MOD 5;");
    return made;
}

/// Returns a program with one statement changed; some changes have no effect.
RandomText changed(RandomText made, Random& random) {
    std::string& one = made.statements[static_cast<std::size_t>(
        random_number(random, 0, static_cast<std::int64_t>(made.statements.size()) - 1))];
    switch (random_number(random, 0, 6)) {
    case 0: one = statement(random, made.timed); break;
    case 1: one = fmt::format("IF NOT ({} AND {}) THEN {} END_IF;", condition(random), condition(random), one); break;
    case 2: one = fmt::format("IF a OR NOT a THEN {} END_IF;", one); break;
    case 3: std::swap(one, made.statements.front()); break;
    case 4: one += " r := r;"; break;
    default:  // a change whose effect may appear after several scans
        one += fmt::format(" IF (m > {}) AND {} THEN {} END_IF;", random_number(random, 0, 3), condition(random),
                           statement(random, made.timed));
        break;
    }
    return made;
}

/// Two interpreters that execute the same scans.
struct Pair {
    std::array<ProgramRun, 2> runs;
    /// For each program: if scans are repeated until the program is stable, the cells that must not change in a stable
    /// program; otherwise nothing.
    std::array<std::optional<std::vector<std::size_t>>, 2> settled = {};

    enum class Result { Same, Different, BothStop };
    Result scan(const std::vector<std::int64_t>& inputs, std::int64_t wait) {
        std::array<std::vector<std::int64_t>, 2> outputs;
        std::array<bool, 2> stops = {};
        for (const std::size_t k : {0U, 1U}) {
            runs[k].scan(inputs, wait);
            stops[k] = settled[k] && !settles(k, inputs);
            for (std::size_t i = 0; i < runs[k].cells().size(); ++i)
                if (runs[k].layout().cells[i].output) outputs[k].push_back(runs[k].cells()[i]);
        }
        for (const std::size_t k : {0U, 1U}) stops[k] = stops[k] || runs[k].fault();
        if (stops[0] && stops[1]) return Result::BothStop;
        if (stops[0] || stops[1]) return Result::Different;
        return outputs[0] == outputs[1] ? Result::Same : Result::Different;
    }
    /// Repeats the scan until the cells do not change. Returns false if they change in many repetitions.
    bool settles(std::size_t k, const std::vector<std::int64_t>& inputs) {
        for (int count = 0; count < 600 && !runs[k].fault(); ++count) {
            const std::vector<std::int64_t> before(runs[k].cells().begin(), runs[k].cells().end());
            runs[k].scan(inputs, 0);
            if (std::ranges::none_of(*settled[k], [&](std::size_t i) { return before[i] != runs[k].cells()[i]; }))
                return true;
        }
        return runs[k].fault().has_value();
    }
    std::vector<std::int64_t> key() const {
        std::vector<std::int64_t> values;
        for (const ProgramRun& run : runs) values.insert(values.end(), run.cells().begin(), run.cells().end());
        return values;
    }
};

struct Searched {
    bool complete = true;
    /// Minimum number of scans to a difference, and to a stop of both programs; 0 if none was found.
    std::size_t difference = 0, stop = 0;
    std::size_t depth = 0;  ///< number of scans that were explored completely
};

/// Explores all pairs of states, in the order of the number of scans that lead to them.
Searched search(const Program& a, const Program& b, const Pair& first) {
    Searched found;
    std::set<std::vector<std::int64_t>> seen;
    std::vector<Pair> layer = {first};
    const std::optional<std::int64_t> interval = a.interval_ms ? a.interval_ms : b.interval_ms;
    for (std::size_t depth = 1; !layer.empty() && found.difference == 0; ++depth) {
        std::vector<Pair> next;
        for (const Pair& before : layer)
            for (std::int64_t number = 0; number < 16 * (longest_wait + 1); ++number) {
                const std::int64_t wait = interval.value_or(depth == 1 ? 0 : number / 16);
                if (number / 16 > 0 && (interval || depth == 1)) break;
                Pair now = before;
                const Pair::Result result = now.scan({number & 1, number >> 1 & 1, number >> 2 & 3}, wait);
                if (result == Pair::Result::Different) found.difference = depth;
                if (result == Pair::Result::BothStop && found.stop == 0) found.stop = depth;
                if (result == Pair::Result::Same && seen.insert(now.key()).second) next.push_back(std::move(now));
            }
        found.depth = depth;
        found.complete = next.empty();
        if (seen.size() > most_pairs) break;
        layer = std::move(next);
    }
    return found;
}

std::string error_texts(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream text;
    render_text(diagnostics.all(), sources, Colour::Plain, text);
    return text.str();
}

/// Returns the error in the replay of a difference or a run-time fault, or an empty string.
std::string replay_error(const Comparison& found, Pair pair) {
    for (std::size_t scan = 0; scan < found.scans.size(); ++scan) {
        const Pair::Result result = pair.scan(found.scans[scan].inputs, found.scans[scan].wait_ms);
        const Pair::Result last = found.faulty ? Pair::Result::BothStop : Pair::Result::Different;
        if (result != (scan + 1 == found.scans.size() ? last : Pair::Result::Same))
            return fmt::format("scan {} of the replay has another result", scan + 1);
    }
    return {};
}

/// Returns the error in the verdict, or an empty string.
std::string violation(const std::string& one, const std::string& other, bool same_text, bool settles,
                      std::map<std::string, int>& seen) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> a = sources.add({"a.st", one}), b = sources.add({"b.st", other});
    const auto of_a = read_program(a, sources, diagnostics), of_b = read_program(b, sources, diagnostics);
    if (!of_a || !of_b) return error_texts(diagnostics, sources);
    CompareOptions options;
    options.limits.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    const auto found = compare({nullptr, {}, a}, {nullptr, {}, b}, options, {.settles = settles}, sources, diagnostics);
    if (!found) {
        const std::string error = error_texts(diagnostics, sources);
        return settles && error.find("`--compare settled` cannot be used") != std::string::npos ? "" : error;
    }
    if (!found->failures.empty()) return found->failures.front();
    Pair pair{{ProgramRun(of_a->program()), ProgramRun(of_b->program())}};
    if (settles)
        for (const std::size_t k : {0U, 1U})
            pair.settled[k] = lockstep_side(*side_of_program(k == 0 ? a : b, sources, diagnostics), true, {}).settled;
    const Searched searched = search(of_a->program(), of_b->program(), pair);
    ++seen[found->faulty ? "model errors" : std::string(word(found->outcome))];
    seen["timed"] += found->resolution_ms > 0 && !found->interval_ms ? 1 : 0;
    seen["with an interval"] += found->interval_ms ? 1 : 0;
    seen["complete searches"] += searched.complete ? 1 : 0;
    if (same_text && found->outcome == Comparison::Outcome::Different) return "a program differs from itself";
    if (found->faulty || found->outcome == Comparison::Outcome::Different) {
        const std::string error = replay_error(*found, pair);
        if (!error.empty()) return error;
    }
    const std::size_t scans = found->scans.size();
    switch (found->outcome) {
    case Comparison::Outcome::Equal:
        if (searched.difference != 0) return "the programs are different";
        if (searched.stop != 0) return "a run-time fault is not reported";
        break;
    case Comparison::Outcome::Different:
        ++seen[scans > 2 ? "of three scans or more" : "of one or two scans"];
        if (searched.complete && searched.difference == 0) return "the programs are equal";
        if (found->shortest && searched.difference != 0 && searched.difference < scans)
            return "a shorter sequence exists";
        if (found->shortest) ++seen["shortest"];
        else if (!settles) return "the difference is not proved to be a shortest one";
        break;
    case Comparison::Outcome::Unknown:
        if (found->faulty && searched.difference != 0) return "the programs are different, not only faulty";
        if (found->faulty && searched.complete && searched.stop == 0) return "there is no run-time fault";
        if (!found->faulty && searched.complete && searched.stop != 0) ++seen["neither settles"];
        break;
    }
    return {};
}

TEST(RandomizedComparePrograms, VerdictsAreThoseOfACompleteSearch) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(40); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const RandomText program = random_text(random);
        const RandomText other = changed(program, random);
        ASSERT_EQ(violation(program.text(), other.text(), false, false, seen), "") << "seed " << seed << '\n'
                                                                                   << program.text() << other.text();
        if (seed % 8 != 0) continue;
        ASSERT_EQ(violation(program.text(), program.text(), true, false, seen), "") << "seed " << seed << '\n'
                                                                                    << program.text();
    }
    print_counts(seen);
    EXPECT_GT(seen["equal"], test_size(5));
    EXPECT_GT(seen["different"], test_size(2));
    EXPECT_GT(seen["model errors"], 0);
    EXPECT_GT(seen["of three scans or more"], 0);
    EXPECT_GT(seen["complete searches"], test_size(10));
    EXPECT_LE(seen["unknown"], test_size(3));
}

TEST(RandomizedComparePrograms, VerdictsOnSettledProgramsAreThoseOfACompleteSearch) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(12); ++seed) {
        Random random(static_cast<std::uint64_t>(seed) + 1000);
        const RandomText program = random_text(random);
        const RandomText other = changed(program, random);
        ASSERT_EQ(violation(program.text(), other.text(), false, true, seen), "") << "seed " << seed << '\n'
                                                                                  << program.text() << other.text();
    }
    print_counts(seen);
    EXPECT_GT(seen["equal"], 0);
    EXPECT_GT(seen["different"], 0);
    EXPECT_GT(seen["neither settles"], 0);
}

}  // namespace
}  // namespace grafverif
