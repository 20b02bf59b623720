// SPDX-License-Identifier: MIT
// Tests scripts of `simulate`: waiting, events within one instant, and moves without a choice.
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

/// GO leads from step 0 to step 3 within one instant. Step 4 is left after 5 s; step 5 is then transient.
const std::string passing =
    "grafcet c { input GO; output A, B; initial step 0; step 1 { A; } step 2 { B; } step 3; step 4; step 5;\n"
    "transition a: 0 -> 1 when GO; transition b: 1 -> 2 when GO; transition d: 2 -> 3 when GO;\n"
    "transition e: 3 -> 4 when !GO; transition f: 4 -> 5 when 5s/X4; transition g: 5 -> 0 when true; }\n"
    "closed_loop l { time unit 1s; controller c with every_cycle; environment Go = free(OUT = GO); }\n"
    "closed_loop search { time unit 1s; controller c with stability_search; environment Go = free(OUT = GO); }\n";

struct ScriptRun {
    int code = 0;
    std::string out = {}, err = {};
};

ScriptRun script(const std::string& model, const std::vector<std::string>& options, const std::string& text) {
    const Folder folder;
    std::vector<std::string> command = {"simulate", folder.write("m.grafcet", model), "--script",
                                        folder.write("s.txt", text)};
    command.insert(command.end(), options.begin(), options.end());
    const Result result = grafverif(command);
    return {static_cast<int>(result.code), result.out, result.err};
}

TEST(Script, WaitUntilIsMetByAStateOfTheCurrentInstant) {
    for (const std::vector<std::string>& of :
         {std::vector<std::string>{"--loop", "l"}, {"--loop", "search"}, {"--chart", "c"}}) {
        SCOPED_TRACE(of.back());
        const ScriptRun run = script(passing, of,
                                     "GO = true\nwait until X1\nwait until X2\nexpect within 1s X1\nexpect X3\n"
                                     "GO = false\nwait until X5\nexpect X0\nwait until X0\n");
        // The expectation of a second `X1` (line 4) is not met, but that of `X3` (line 5) is.
        EXPECT_NE(run.err.find(":4: not met: expected `X1`, but `X1` is not active after 1 s\n"), std::string::npos)
            << run.err;
        EXPECT_EQ(run.err.find(":5:"), std::string::npos) << run.err;
        EXPECT_EQ(run.err.find("nothing changes"), std::string::npos) << run.err;
        // The elapsed time is 1 s from line 4 plus 5 s in step 4.
        EXPECT_NE(run.out.find(" 6 s  c: 5s/X4 is true"), std::string::npos) << run.out;
    }
}

TEST(Script, WaitUntilIgnoresStatesBeforeTheLastCommand) {
    const ScriptRun run = script(passing, {"--loop", "l"}, "GO = true\nwait 3s\nGO = false\nwait until X3\n");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find(":4: not met: expected `X3`"), std::string::npos) << run.err;
    const ScriptRun plain = script(passing, {"--loop", "l"}, "GO = true\nexpect X1\n");
    EXPECT_EQ(plain.code, 1) << "without a time, `expect` refers to the current state";
}

TEST(Script, UndoRestoresTheStatesForWaitUntil) {
    const ScriptRun run =
        script(passing, {"--loop", "l"}, "GO = true\nGO = false\nundo\nwait until X1\nwait until X2\n");
    EXPECT_EQ(run.code, 0) << run.err;
}

/// In `idle`, an urgent edge and a timed edge become enabled simultaneously. The urgent edge is taken.
TEST(Script, AnUrgentEdgeIsTakenAlthoughATimedOneIsPossible) {
    const std::string model =
        "grafcet c { input AT_TOP; output UP; initial step 0; step 1 { UP; } step 2;\n"
        "transition a: 0 -> 1 when 1s/X0; transition b: 1 -> 2 when AT_TOP; }\n"
        "component lift(input ON; output TOP) { clock t;\n"
        "initial location idle; location rising invariant t <= 4s; location top; location stuck;\n"
        "urgent idle -> rising when ON do t := 0; timed idle -> stuck when ON;\n"
        "timed rising -> top when t >= 2s do TOP := true; }\n"
        "closed_loop l { controller c with stability_search; plant Lift = lift(ON = UP, TOP = AT_TOP); }\n";
    const ScriptRun run =
        script(model, {}, "wait until Lift in rising\nwait until AT_TOP\nexpect X2 and Lift in top\n");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("5 s"), std::string::npos) << run.out;
    const ScriptRun chosen = script(model, {"--verbose"}, "do Lift stuck\n");
    EXPECT_NE(chosen.err.find("`Lift` cannot move to `stuck` now"), std::string::npos) << chosen.err;
}

TEST(Script, SeveralUrgentEdgesRemainAChoice) {
    const std::string model =
        "grafcet c { input OK; output TEST; initial step 0; step 1 { TEST; }\n"
        "transition a: 0 -> 1 when 1s/X0; transition b: 1 -> 0 when OK; }\n"
        "component tester(input ON; output OUT) { initial location idle; location good; location bad;\n"
        "urgent idle -> good when ON do OUT := true; urgent idle -> bad when ON; }\n"
        "closed_loop l { controller c with stability_search; plant T = tester(ON = TEST, OUT = OK); }\n";
    const ScriptRun run = script(model, {}, "wait until OK\n");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("time cannot pass before a choice"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace grafverif::app
