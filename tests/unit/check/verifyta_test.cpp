// SPDX-License-Identifier: MIT
// Tests the conversion of the output of verifyta to verdicts. The texts were not printed by the real program, because
// its licence forbids automated tests. The texts contain verdict lines of the documented form, and
// other lines that may surround the verdict lines.
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
        UnknownReason obstacle;
    };
    for (const Case& c : {
             Case{"Options for the verification:\n  Generating no trace\n\nVerifying formula 1 at line 1\n -- Formula "
                  "is satisfied.\n",
                  Outcome::Holds, UnknownReason::None},
             Case{"Verifying formula 1 at line 1\n -- Formula is NOT satisfied.\n", Outcome::Violated,
                  UnknownReason::None},
             Case{"-- Formula is satisfied.", Outcome::Holds, UnknownReason::None},
             Case{"\r\n -- Formula is satisfied.\r\n", Outcome::Holds, UnknownReason::None},
             Case{"\033[2K\033[1;32m -- Formula is satisfied.\033[0m\n", Outcome::Holds, UnknownReason::None},
             Case{" -- Formula MAY be satisfied.\n", Outcome::Unknown, UnknownReason::Inexact},
             Case{" -- Formula MAY NOT be satisfied.\n", Outcome::Unknown, UnknownReason::Inexact},
             Case{" -- Formula MAY be satisfied.\n -- Formula is satisfied.\n", Outcome::Unknown,
                  UnknownReason::Disagrees},
             Case{" -- Formula is satisfied.\n -- Formula is NOT satisfied.\n", Outcome::Unknown,
                  UnknownReason::Disagrees},
             Case{" -- Formula is satisfied.\n -- Formula is satisfied.\n", Outcome::Unknown, UnknownReason::Disagrees},
             Case{"I wonder whether -- Formula is satisfied.\n", Outcome::Unknown, UnknownReason::Failed},
             Case{" -- Formula is satisfied. Or is it?\n", Outcome::Unknown, UnknownReason::Failed},
             Case{" -- Formula is s\033[2Katisfied.\n", Outcome::Unknown, UnknownReason::Failed},
             Case{" -- Formula is\033satisfied.\n", Outcome::Unknown, UnknownReason::Failed},
             Case{"", Outcome::Unknown, UnknownReason::Failed},
             Case{"\033", Outcome::Unknown, UnknownReason::Failed},
             Case{"\033[", Outcome::Unknown, UnknownReason::Failed},
         }) {
        SCOPED_TRACE(c.out);
        const ExternalResult answer = read_verifyta(printed(c.out));
        EXPECT_EQ(answer.outcome, c.outcome);
        EXPECT_EQ(answer.obstacle, c.obstacle);
        EXPECT_EQ(answer.reason.empty(), c.outcome != Outcome::Unknown) << answer.reason;
    }
}

TEST(Verifyta, ExitCodesAreNotDocumentedAndDecideNothing) {
    EXPECT_EQ(read_verifyta(printed(" -- Formula is satisfied.\n", 1)).outcome, Outcome::Holds);
    EXPECT_EQ(read_verifyta(printed("", 0)).reason, "verifyta printed no verdict: exit code 0");
}

TEST(Verifyta, ItsErrorMessageIsTheReason) {
    EXPECT_EQ(read_verifyta(printed("", 1, "\n model.xml:1: [error] Syntax error.\nmore\n")).reason,
              "verifyta printed no verdict: model.xml:1: [error] Syntax error.");
    EXPECT_EQ(read_verifyta(printed("", 1, "\033[31merror:\033[0m no licence\n")).reason,
              "verifyta printed no verdict: error: no licence");
}

TEST(Verifyta, AProgramThatWasEndedGaveNoVerdict) {
    ProgramResult result = printed(" -- Formula is satisfied.\n");
    for (const End end : {End::Signalled, End::TimedOut, End::Stopped, End::TooMuchOutput}) {
        result.end = end;
        EXPECT_EQ(read_verifyta(result).outcome, Outcome::Unknown);
        EXPECT_FALSE(read_verifyta(result).reason.empty());
    }
}

/// A network with three properties, and the output that a stand-in for verifyta gives for each formula.
struct Requested {
    Sketch s = {};
    std::vector<ExternalQuery> questions = {};
    std::map<std::string, std::string> says = {};
    std::vector<std::string> runs = {};  // the formulas for which the stand-in was run

    void add_property(const std::string& name, Pattern pattern, std::vector<Id<Expr>> operands,
                      const std::string& formula, const std::string& output) {
        s.property(name, pattern, std::move(operands));
        const Id<Property> last{static_cast<std::uint32_t>(s.network.properties.size() - 1)};
        questions.push_back({last, name, formula, formula.empty() ? "cannot be said" : ""});
        says[formula] = output;
    }
    std::string outcome_text(const std::vector<std::string>& properties = {}) {
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
    Requested requested;
    requested.add_property("a", Pattern::Always, {requested.s.yes()}, "A[] true", "");
    requested.add_property("b", Pattern::Never, {requested.s.yes()}, "A[] not true", "NOT ");
    requested.add_property("c", Pattern::AlwaysPossible, {requested.s.yes()}, "", "");
    EXPECT_EQ(requested.outcome_text(), "a holds\nb violated\nc unknown\nno_timelock unknown, undeclared\n");
    EXPECT_EQ(requested.runs, (std::vector<std::string>{"A[] true", "A[] not true"}));
    EXPECT_EQ(requested.outcome_text({"b"}), "b violated\nno_timelock unknown, undeclared\n");
}

TEST(Verifyta, ProvesNothingIfStoredActionsMayRace) {
    Requested requested;
    requested.s.network.race = requested.s.boolean("race");
    const auto add = [&](const std::string& race) {
        requested.questions.clear();
        requested.s.network.properties = {};
        requested.add_property("a", Pattern::Always, {requested.s.yes()}, "A[] true", "");
        requested.add_property("no_race", Pattern::Never, {requested.s.is(requested.s.network.race)}, "A[] not race",
                               race);
    };
    add("");
    EXPECT_EQ(requested.outcome_text({"a"}), "a holds\nno_race holds\nno_timelock unknown, undeclared\n");
    add("NOT ");
    EXPECT_EQ(requested.outcome_text(), "a unknown\nno_race violated\nno_timelock unknown, undeclared\n");
}

TEST(Verifyta, ChecksNoFurtherFormulaAfterAnInterrupt) {
    Requested requested;
    requested.add_property("a", Pattern::Always, {requested.s.yes()}, "A[] true", "");
    requested.add_property("b", Pattern::Always, {requested.s.yes()}, "A[] 1", "");
    int runs = 0;
    const auto verdicts = check_verifyta(requested.s.network, requested.questions,
                                         {{}, [&](const std::string&) {
                                              ++runs;
                                              return ProgramResult{End::Stopped, 0, " -- Formula is satisfied.\n", ""};
                                          }});
    EXPECT_EQ(runs, 1);
    ASSERT_EQ(verdicts.size(), 3u);
    EXPECT_EQ(verdicts[1].obstacle, UnknownReason::Stopped);
}

}  // namespace
}  // namespace grafverif
