// SPDX-License-Identifier: MIT
// Tests `check --certificate`: the certificates that the check writes, which `grafverif-certify` accepts, and the verdicts
// without certificate.
#include <gtest/gtest.h>

#include "unit/app/certificate_files.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

TEST(Certificate, ProvesTheVerdictsOfTheTestingStation) {
    const Folder folder;
    const Result result = grafverif({"check", station, "--certificate", folder.file("station")});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_NE(result.out.find("certificate: 4 of 4 verdicts; check it with `grafverif-certify "), std::string::npos);
    EXPECT_NE(result.out.find("\n  set of states: P14, P15, no_deadlock, no_timelock\n"), std::string::npos)
        << result.out;
    const Certified certified = certify(folder.file("station"));
    EXPECT_EQ(certified.code, 0) << certified.out;
    for (const char* property : {"P14", "P15", "no_deadlock", "no_timelock"})
        EXPECT_NE(certified.out.find(std::string(property) + ": holds, proved by the states\n"), std::string::npos);
}

TEST(Certificate, TheReportStatesTheKindForEachVerdict) {
    const Folder folder;
    const std::string text =
        "grafcet lamp { input ON; output LAMP; initial step 0; step 1 { LAMP; } transition on: 0 -> 1 when ON; }\n"
        "closed_loop room { controller lamp; environment a = free(OUT = ON); property dark: never LAMP;\n"
        "property lit: reachable LAMP; property one: exactly one of {X0, X1}; }\n";
    const Result result = grafverif({"check", folder.write("room.grafcet", text), "--certificate", folder.file("room"),
                                     "--report", folder.file("room.html")});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_NE(result.out.find("\n  set of states: one, no_timelock\n  run: dark, lit\n"), std::string::npos)
        << result.out;
    const std::string page = folder.read("room.html");
    for (const char* const outcome :
         {"violated (certificate: run)", "holds (certificate: run)", "holds (certificate: set of states)"})
        EXPECT_NE(page.find(std::string("<span class=\"outcome\">") + outcome + "</span>"), std::string::npos)
            << outcome;
    EXPECT_NE(page.find("Certificate: run in " + folder.file("room") + "."), std::string::npos);
    EXPECT_NE(page.find("data-run=\"dark\""), std::string::npos);
    const Result limited = grafverif({"check", folder.file("room.grafcet"), "--certificate", folder.file("few"),
                                      "--max-states", "2", "--property", "one", "--report", folder.file("few.html")});
    EXPECT_EQ(limited.code, ExitCode::Unknown) << limited.out;
    const std::string unknown = folder.read("few.html");
    EXPECT_NE(unknown.find("unknown (certificate: none)"), std::string::npos);
    EXPECT_NE(unknown.find("Certificate: none: the verdict is unknown."), std::string::npos);
    // Without a certificate, `check --report` writes the same file as `report`.
    ASSERT_EQ(grafverif({"check", folder.file("room.grafcet"), "--report", folder.file("plain.html")}).code,
              ExitCode::Verdict);
    ASSERT_EQ(grafverif({"report", folder.file("room.grafcet"), "-o", folder.file("report.html")}).code,
              ExitCode::Verdict);
    EXPECT_EQ(folder.read("plain.html"), folder.read("report.html"));
}

TEST(Certificate, StatesTheReasonForAVerdictWithoutCertificate) {
    const Folder folder;
    const Result result = grafverif(
        {"check", station, "--certificate", folder.file("station"), "--max-states", "100", "--property", "P15"});
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.out.find("P15 is not certified: the verdict is unknown"), std::string::npos) << result.out;
    const Certified certified = certify(folder.file("station"));
    EXPECT_EQ(certified.code, 0);
    EXPECT_NE(certified.out.find("P15: not certified: the verdict is unknown"), std::string::npos) << certified.out;
}

/// The loop has too many states for a complete search. Input abstraction and a search for runs decide the properties;
/// `body` has an observer.
TEST(Certificate, ARunProvesAVerdictWithoutACompleteSearch) {
    const Folder folder;
    const std::string lift = (root / "bench/stations/lift_mistake.grafcet").string();
    const Result result = grafverif({"check", lift, "--property", "level", "--property", "body", "--property",
                                     "all.GP.X14", "--max-states", "140000", "--certificate", folder.file("lift")});
    EXPECT_NE(result.out.find("\n  run: level, body, all.GP.X14\n"), std::string::npos) << result.out << result.err;
    EXPECT_NE(result.out.find("\n  no_timelock is not certified: the complete search does not decide the property: "
                              "state limit reached"),
              std::string::npos)
        << result.out;
    const Certified certified = certify(folder.file("lift"));
    EXPECT_EQ(certified.code, 0) << certified.out;
    for (const char* const claim : {"\nlevel: violated, shown by a run\n", "\nall.GP.X14: holds, shown by a run\n",
                                    "\nbody/body: violated, shown by a run\n"})
        EXPECT_NE(certified.out.find(claim), std::string::npos) << claim << certified.out;
}

/// The verdict on `serves` is unknown. The check therefore uses all of its time, which is half of the time limit.
TEST(Certificate, HasTimeAlsoIfAVerdictIsUnknown) {
    const Folder folder;
    const std::string lift = (root / "bench/stations/independent/goods_lift.grafcet").string();
    const Result result = grafverif({"check", lift, "--property", "contactors", "--property", "serves", "--timeout",
                                     "10s", "--certificate", folder.file("lift")});
    ASSERT_NE(result.out.find("\ncontactors                  holds"), std::string::npos) << result.out << result.err;
    EXPECT_NE(result.out.find("serves is not certified: the verdict is unknown"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("  set of states of a fragment: contactors\n"), std::string::npos) << result.out;
    const Certified certified = certify(folder.file("lift"));
    EXPECT_NE(certified.out.find("\ncontactors: holds, proved by the states\n"), std::string::npos) << certified.out;
}

constexpr const char* lamp_chart =
    "grafcet lamp { input ON; output LAMP; internal C: int 0..3 = 0; initial step 0; step 1 { LAMP; C := 1 on "
    "activation; }\n transition on: 0 -> 1 when ON; transition off: 1 -> 0 when !ON; }\n"
    "closed_loop room { controller lamp; environment a = free(OUT = ON);\n";

/// The bytes of these letters contain 0xc2, which begins the control characters U+0080 to U+009F; the third operand of
/// `one` has no value in states in which the other two are true; the name is longer than the name of a file may be.
TEST(Certificate, IsAcceptedForUnusualNamesAndOperands) {
    const std::string name(900, 'n');
    for (const std::string& property :
         {std::string("property \u00b5\u00aa: never LAMP"),
          std::string("property one: exactly one of {X0, X0 || X1, 6 / C > 2}"),
          "property " + name + ": X0 leads to X1 within 2s", std::string("property all: inevitable X1 && X0 at stable"),
          std::string("property always_so: true leads to false")}) {
        const Folder folder;
        const std::string file = folder.write("room.grafcet", lamp_chart + property + "; }\n");
        const Result result = grafverif({"check", file, "--certificate", folder.file("room")});
        EXPECT_EQ(result.code, ExitCode::Verdict) << result.out << result.err;
        EXPECT_NE(result.out.find("certificate: 2 of 2 verdicts"), std::string::npos) << property << result.out;
        const Certified certified = certify(folder.file("room"));
        EXPECT_EQ(certified.code, 0) << property << certified.out;
        EXPECT_NE(certified.out.find(": violated, shown by a run"), std::string::npos) << certified.out;
    }
}

/// The least number of 64 bits represents an unknown value in a certificate.
TEST(Certificate, OmitsModelsWithTheLeastNumber) {
    const Folder folder;
    const std::string file = folder.write(
        "room.grafcet", std::string(lamp_chart) + "property r: reachable C > 0 - 9223372036854775807 - 1; }\n");
    const Result result = grafverif({"check", file, "--certificate", folder.file("room")});
    EXPECT_NE(result.out.find("r is not certified: a number of the model is too small"), std::string::npos)
        << result.out << result.err;
    EXPECT_EQ(certify(folder.file("room")).code, 0);
}

/// Two subsystems: the right one blocks, the left one moves forever.
constexpr const char* half_blocked = R"(
grafcet left { input A; output L; initial step 0; step 1 { L; }
    transition on: 0 -> 1 when A; transition off: 1 -> 0 when 2s/X1; }
grafcet right { input B; output R; initial step 0; step 1 { R; } transition on: 0 -> 1 when B; }
component once(output OUT) {
    clock t;
    initial location up invariant t <= 2s;
    location down;
    timed up -> down when t >= 1s do OUT := true;
}
closed_loop lamps {
    controller left;
    controller right;
    environment PA = push_button(OUT = A);
    environment PB = once(OUT = B);
    property moves: no deadlock;
    property lit: L leads to !L within 3s;
}
)";

TEST(Certificate, OmitsViolatedDeadlocksOfSubsystems) {
    const Folder folder;
    const std::string loop = folder.write("loop.grafcet", half_blocked);
    const Result separate = grafverif({"check", loop, "--certificate", folder.file("separate")});
    EXPECT_EQ(separate.code, ExitCode::Verdict) << separate.err;
    EXPECT_NE(separate.out.find("moves is not certified: the verdict applies to each subsystem; pass `--monolithic`"),
              std::string::npos)
        << separate.out;
    const Result together = grafverif({"check", loop, "--monolithic", "--certificate", folder.file("together")});
    EXPECT_EQ(together.code, ExitCode::Verdict) << together.err;
    const Certified certified = certify(folder.file("together"));
    EXPECT_EQ(certified.code, 0);
    EXPECT_NE(certified.out.find("moves: holds, proved by the states\n"), std::string::npos) << certified.out;
    EXPECT_NE(certified.out.find("lit/lit: violated, shown by a run\n"), std::string::npos) << certified.out;
}

TEST(Certificate, ProvesDeadlocksOfSubsystems) {
    const Folder folder;
    std::string text = half_blocked;
    const std::string once = "environment PB = once(OUT = B);";
    text.replace(text.find(once), once.size(), "environment PB = push_button(OUT = B);");
    const Result result =
        grafverif({"check", folder.write("loop.grafcet", text), "--certificate", folder.file("loop")});
    EXPECT_NE(result.out.find("\n  sets of states of subsystems: moves\n"), std::string::npos) << result.out;
    const Certified certified = certify(folder.file("loop"));
    EXPECT_EQ(certified.code, 0) << certified.out;
    EXPECT_NE(certified.out.find("moves: holds, proved by the states\n"), std::string::npos) << certified.out;
}

TEST(Certificate, NamesAnUnknownVerdictOfAnObserver) {
    const Folder folder;
    const std::string loop = folder.write("loop.grafcet", half_blocked);
    grafverif({"check", loop, "--max-states", "5", "--certificate", folder.file("few")});
    EXPECT_FALSE(fs::exists(folder.file("few/lit")));
    const Certified certified = certify(folder.file("few"));
    EXPECT_NE(certified.out.find("lit: not certified: the verdict is unknown\n"), std::string::npos) << certified.out;
}

TEST(Certificate, NamesAllOmittedVerdictsOfAChart) {
    const Folder folder;
    const std::string chart = folder.write("chart.grafcet",
                                           "grafcet c { input A; initial step 0; step 1; transition t: 0 -> 1 when A; "
                                           "transition u: 1 -> 0 when !A; }\n");
    const Result result = grafverif({"check", chart, "--engine", "pdr", "--certificate", folder.file("chart")});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_NE(result.out.find("certificate: 2 of 3 verdicts"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("stabilises is not certified: the circuit does not contain the property"),
              std::string::npos);
}

/// Two steps that are activated at the same time assign different values to C.
TEST(Certificate, ARunToTheStateBeforeARaceProvesThatTheRaceIsPossible) {
    const Folder folder;
    const std::string text =
        "grafcet pair { input ON; internal C: int 0..3 = 0; initial step 0; step 1 { C := 1 on activation; }\n"
        "step 2 { C := 2 on activation; } transition t: 0 -> 1, 2 when ON; }\n"
        "closed_loop room { controller pair; environment a = free(OUT = ON); }\n";
    const Result result =
        grafverif({"check", folder.write("room.grafcet", text), "--certificate", folder.file("room")});
    EXPECT_NE(result.out.find("  run: no_race\n"), std::string::npos) << result.out << result.err;
    const Certified certified = certify(folder.file("room"));
    EXPECT_EQ(certified.code, 0);
    EXPECT_NE(certified.out.find("\nno_race: violated, shown by a run\n"), std::string::npos) << certified.out;
}

}  // namespace
}  // namespace grafverif::app
