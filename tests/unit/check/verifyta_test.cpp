// SPDX-License-Identifier: MIT
// Converts the output of verifyta to verdicts. The texts were not printed by the real program, whose licence forbids
// automated tests: they have verdict lines of the documented form, and possible lines around them.
#include "check/external/verifyta.hpp"

#include <gtest/gtest.h>

#include <map>

#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

using End = ProgramResult::End;

ProgramResult printed(const std::string& out, int status = 0, const std::string& err = "") {
    return {End::Exited, status, out, err};
}

TEST(Verifyta, ReadsTheDocumentedLines) {
    struct Case {
        const char* out;
        Outcome outcome;
        Obstacle obstacle;
    };
    for (const Case& c : {
             Case{"Options for the verification:\n  Generating no trace\n\nVerifying formula 1 at line 1\n -- Formula "
                  "is satisfied.\n",
                  Outcome::Holds, Obstacle::None},
             Case{"Verifying formula 1 at line 1\n -- Formula is NOT satisfied.\n", Outcome::Violated, Obstacle::None},
             Case{"-- Formula is satisfied.", Outcome::Holds, Obstacle::None},
             Case{"\r\n -- Formula is satisfied.\r\n", Outcome::Holds, Obstacle::None},
             Case{"\033[2K\033[1;32m -- Formula is satisfied.\033[0m\n", Outcome::Holds, Obstacle::None},
             Case{" -- Formula MAY be satisfied.\n", Outcome::Unknown, Obstacle::Inexact},
             Case{" -- Formula MAY NOT be satisfied.\n", Outcome::Unknown, Obstacle::Inexact},
             Case{" -- Formula MAY be satisfied.\n -- Formula is satisfied.\n", Outcome::Unknown, Obstacle::Disagrees},
             Case{" -- Formula is satisfied.\n -- Formula is NOT satisfied.\n", Outcome::Unknown, Obstacle::Disagrees},
             Case{" -- Formula is satisfied.\n -- Formula is satisfied.\n", Outcome::Unknown, Obstacle::Disagrees},
             Case{"I wonder whether -- Formula is satisfied.\n", Outcome::Unknown, Obstacle::Failed},
             Case{" -- Formula is satisfied. Or is it?\n", Outcome::Unknown, Obstacle::Failed},
             Case{" -- Formula is s\033[2Katisfied.\n", Outcome::Unknown, Obstacle::Failed},
             Case{" -- Formula is\033satisfied.\n", Outcome::Unknown, Obstacle::Failed},
             Case{"", Outcome::Unknown, Obstacle::Failed},
             Case{"\033", Outcome::Unknown, Obstacle::Failed},
             Case{"\033[", Outcome::Unknown, Obstacle::Failed},
         }) {
        SCOPED_TRACE(c.out);
        const ExternalAnswer answer = read_verifyta(printed(c.out));
        EXPECT_EQ(answer.outcome, c.outcome);
        EXPECT_EQ(answer.obstacle, c.obstacle);
        EXPECT_EQ(answer.reason.empty(), c.outcome != Outcome::Unknown) << answer.reason;
    }
}

TEST(Verifyta, ExitCodesAreNotDocumentedAndDecideNothing) {
    EXPECT_EQ(read_verifyta(printed(" -- Formula is satisfied.\n", 1)).outcome, Outcome::Holds);
    EXPECT_EQ(read_verifyta(printed("", 0)).reason, "verifyta gave no verdict: exit code 0");
}

TEST(Verifyta, ItsErrorMessageIsTheReason) {
    EXPECT_EQ(read_verifyta(printed("", 1, "\n model.xml:1: [error] Syntax error.\nmore\n")).reason,
              "verifyta gave no verdict: model.xml:1: [error] Syntax error.");
    EXPECT_EQ(read_verifyta(printed("", 1, "\033[31merror:\033[0m no licence\n")).reason,
              "verifyta gave no verdict: error: no licence");
}

TEST(Verifyta, AProgramThatWasEndedGaveNoVerdict) {
    ProgramResult result = printed(" -- Formula is satisfied.\n");
    for (const End end : {End::Signalled, End::TimedOut, End::Stopped, End::TooMuchOutput}) {
        result.end = end;
        EXPECT_EQ(read_verifyta(result).outcome, Outcome::Unknown);
        EXPECT_FALSE(read_verifyta(result).reason.empty());
    }
}

/// A network with three properties, and the output of a stand-in for verifyta for each formula.
struct Asked {
    Sketch s = {};
    std::vector<ExternalQuestion> questions = {};
    std::map<std::string, std::string> says = {};
    std::vector<std::string> runs = {};  // the formulas it was run on

    void ask(const std::string& name, Pattern pattern, std::vector<Id<Expr>> operands, const std::string& formula,
             const std::string& said) {
        s.property(name, pattern, std::move(operands));
        const Id<Property> last{static_cast<std::uint32_t>(s.network.properties.size() - 1)};
        questions.push_back({last, name, formula, formula.empty() ? "cannot be said" : ""});
        says[formula] = said;
    }
    std::string told(const std::vector<std::string>& properties = {}) {
        ExternalOptions options{properties, [&](const std::string& formula) {
                                    runs.push_back(formula);
                                    return printed(" -- Formula is " + says[formula] + "satisfied.\n");
                                }};
        std::string text;
        for (const Verdict& verdict : check_verifyta(s.network, questions, options))
            text += verdict.property + ' ' + std::string(word(verdict.outcome)) +
                    (verdict.declared ? "" : ", undeclared") + '\n';
        return text;
    }
};

TEST(Verifyta, ChecksOneFormulaAtATime) {
    Asked asked;
    asked.ask("a", Pattern::Always, {asked.s.yes()}, "A[] true", "");
    asked.ask("b", Pattern::Never, {asked.s.yes()}, "A[] not true", "NOT ");
    asked.ask("c", Pattern::AlwaysPossible, {asked.s.yes()}, "", "");
    EXPECT_EQ(asked.told(), "a holds\nb violated\nc unknown\nno_timelock unknown, undeclared\n");
    EXPECT_EQ(asked.runs, (std::vector<std::string>{"A[] true", "A[] not true"}));
    EXPECT_EQ(asked.told({"b"}), "b violated\nno_timelock unknown, undeclared\n");
}

TEST(Verifyta, ProvesNothingIfStoredActionsMayRace) {
    Asked asked;
    asked.s.network.race = asked.s.boolean("race");
    const auto add = [&](const std::string& race) {
        asked.questions.clear();
        asked.s.network.properties = {};
        asked.ask("a", Pattern::Always, {asked.s.yes()}, "A[] true", "");
        asked.ask("no_race", Pattern::Never, {asked.s.is(asked.s.network.race)}, "A[] not race", race);
    };
    add("");
    EXPECT_EQ(asked.told({"a"}), "a holds\nno_race holds\nno_timelock unknown, undeclared\n");
    add("NOT ");
    EXPECT_EQ(asked.told(), "a unknown\nno_race violated\nno_timelock unknown, undeclared\n");
}

TEST(Verifyta, ChecksNoFurtherFormulaAfterAnInterrupt) {
    Asked asked;
    asked.ask("a", Pattern::Always, {asked.s.yes()}, "A[] true", "");
    asked.ask("b", Pattern::Always, {asked.s.yes()}, "A[] 1", "");
    int runs = 0;
    const auto verdicts = check_verifyta(asked.s.network, asked.questions,
                                         {{}, [&](const std::string&) {
                                              ++runs;
                                              return ProgramResult{End::Stopped, 0, " -- Formula is satisfied.\n", ""};
                                          }});
    EXPECT_EQ(runs, 1);
    ASSERT_EQ(verdicts.size(), 3u);
    EXPECT_EQ(verdicts[1].obstacle, Obstacle::Stopped);
}

}  // namespace
}  // namespace grafverif
