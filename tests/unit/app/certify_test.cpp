// SPDX-License-Identifier: MIT
// Tests the program `grafverif-certify`: its semantics, false claims, invalid files, and its size and independence.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "unit/app/certificate_files.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

constexpr const char* lamp =
    "grafverif-network 2\nvariable ON 0 1 0\nprocess lamp 2 0\n"
    "edge 0 1 1\nset ON 1\nproperty lit reachable ON\nproperty dark never ON\n";

/// Only an edge from the last state of the run shows a race.
TEST(Certify, RejectsARunThatDoesNotLeadToARace) {
    const Folder folder;
    const std::string head = "grafverif-network 2\nvariable race 0 0 0\nvariable A 0 1 0\nprocess p 2 0\n";
    const std::string steps = "edge 0 1 1\nset A 1\nedge 1 1 1\nset race A\n";
    const std::string property = "property no_race never race\nproperty stays never A\n";
    const auto check = [&](const std::string& network, const std::string& claims) {
        return certify(write_certificate(folder, network, claims)).out;
    };
    EXPECT_NE(check(head + steps + property, "violated no_race\n0 1 1 \nend\n").find("no_race: violated"),
              std::string::npos);
    EXPECT_EQ(check(head + steps + property, "violated no_race\nend\n"),
              "rejected: the run of `no_race` does not prove the verdict\n");
    EXPECT_EQ(check(head + "edge 0 0 1\nset A 2\n" + property, "violated stays\nend\n"),
              "rejected: the run of `stays` does not prove the verdict\n");
}

TEST(Certify, AcceptsAShownRunAndRejectsAFalseClaim) {
    const Folder folder;
    const Certified shown = certify(write_certificate(folder, lamp, "holds lit\n1 1\nend\n"));
    EXPECT_EQ(shown.code, 0) << shown.out;
    EXPECT_NE(shown.out.find("lit: holds, shown by a run\ndark: not certified: the file has no verdict\n"),
              std::string::npos);
    const Certified not_shown = certify(write_certificate(folder, lamp, "holds lit\n0 0\nend\n"));
    EXPECT_EQ(not_shown.code, 1);
    EXPECT_EQ(not_shown.out, "rejected: the run of `lit` does not prove the verdict\n");
    const std::string states = "0 0 \n";
    folder.write("states.txt", states);
    const Certified open = certify(write_certificate(folder, lamp, "states " + checksum(states) + "\nholds dark\n"));
    EXPECT_EQ(open.code, 1);
    EXPECT_EQ(open.out, "rejected: states.txt:1: the state has a successor that the file does not contain\n");
}

/// A model error ends a run: its edge has no successor.
TEST(Certify, RejectsRunsWithAModelError) {
    const Folder folder;
    const std::string network =
        "grafverif-network 2\nvariable R 0 0 0\nvariable B 0 1 0\nprocess p 3 0\nedge 0 1 1\nset R 1\n"
        "edge 1 2 1\nset B 1\nproperty never_b never B\nproperty b inevitable B\n";
    EXPECT_EQ(certify(write_certificate(folder, network, "violated b\n0 0 0\nend\n")).code, 0);
    for (const std::string run : {"violated never_b\n0 0 1\n0 1 2\nend\n", "violated b\n0 0 1\nend\n"}) {
        const Certified certified = certify(write_certificate(folder, network, run));
        EXPECT_EQ(certified.code, 1) << run;
        EXPECT_EQ(certified.out, "rejected: a state of a run is not a successor of the previous state\n") << run;
    }
    const std::string states = "0 0 0 \n";
    folder.write("states.txt", states);
    const Certified holds =
        certify(write_certificate(folder, network, "states " + checksum(states) + "\nholds never_b\n"));
    EXPECT_EQ(holds.out, "rejected: a model error is possible: edge 0 (0) of `p` causes a model error\n");
}

/// The results of a folder begin with the name of the folder, so that the results of different
/// folders differ.
TEST(Certify, NamesTheFolderOfAProperty) {
    const Folder folder;
    const std::string dark = "grafverif-network 2\nprocess p 1 0\nproperty dark never 0\n", states = "0 \n";
    std::string index =
        "grafverif-certificate 2\nnetwork " + checksum(dark) + "\nstates " + checksum(states) + "\nholds dark\n";
    index += "checksum " + checksum(index) + '\n';
    fs::create_directories(folder.file("dark"));
    folder.write("dark/network.txt", dark);
    folder.write("dark/states.txt", states);
    folder.write("dark/certificate.txt", index);
    const Certified found = certify(write_certificate(folder, lamp, "also dark\n"));
    EXPECT_EQ(found.code, 0);
    EXPECT_NE(
        found.out.find("\ndark/dark: holds, proved by the states\ndark: not certified: the file has no verdict\n"),
        std::string::npos)
        << found.out;
}

/// Two processes; the second one writes a variable of the first one, and reads it.
constexpr const char* pair =
    "grafverif-network 2\nvariable A 0 1 0\nvariable B 0 1 0\nprocess p 2 0\nclock x\ninvariant 1 x <= 2\n"
    "edge 0 1 A\nreset x\nedge 1 0 urgent B\nset A 0\nprocess q 2 0\nedge 0 1 1\nset B 1\nedge 1 0 1\nset B 0\n"
    "property off never A\nproperty on always (= @q 0)\nproperty lives no-deadlock\n";

TEST(Certify, ComputesTheMovesOfFragments) {
    const Folder folder;
    const auto check = [&](const std::string& states, const std::string& claims) {
        fs::create_directories(folder.file("f"));
        folder.write("f/states.txt", states);
        return certify(write_certificate(folder, pair, "states " + checksum(states) + " f\n" + claims)).out;
    };
    EXPECT_NE(check("0 * 0 0 * \n", "holds off\n").find("off: holds, proved by the states\n"), std::string::npos);
    // The process q is not in the states, so it may be in each location.
    EXPECT_EQ(check("0 * 0 0 * \n", "holds on\n"), "rejected: f/states.txt:1: the state decides `on`\n");
    EXPECT_EQ(check("0 * 0 0 * \n", "holds lives\n"),
              "rejected: f/states.txt is incomplete, or a model error is possible\n");
    EXPECT_EQ(check("0 * 0 0 0 \n", "holds on\n"),
              "rejected: f/states.txt:1: the state has a successor that the file does not contain\n");
    // An unknown variable may have each value: p can leave its location.
    EXPECT_EQ(check("* * 0 0 * \n", "holds off\n"),
              "rejected: f/states.txt:1: the state has a successor that the file does not contain\n");
    EXPECT_EQ(check("0 * 0 * * \n0 * 0 0 * \n", "holds off\n"), "rejected: f/states.txt:1: the state is invalid\n");
    EXPECT_EQ(check("0 * 0 0 * \n0 * 0 0 * \n", "holds off\n"), "rejected: f/states.txt: the states are not sorted\n");
    EXPECT_EQ(check("", "holds off\n"), "rejected: f/states.txt contains no state\n");
}

/// A selector has two outputs, one of which is always true. A PLC samples them in two variables, and then sets an
/// output if both samples are true.
constexpr const char* selector =
    "grafverif-network 2\nvariable A 0 1 1\nvariable B 0 1 0\nvariable SA 0 1 0\nvariable SB 0 1 0\nvariable OUT 0 1 "
    "0\n"
    "process sel 2 0\nedge 0 1 1\nset A 0\nset B 1\nedge 1 0 1\nset A 1\nset B 0\n"
    "process plc 2 0\nedge 0 1 1\nset SA A\nset SB B\nedge 1 0 1\nset OUT (and SA SB)\nset SA 0\nset SB 0\n"
    "property off never OUT\nproperty one never (and A B)\nproperty ends inevitable OUT\n";

TEST(Certify, RestrictsChoicesToBounds) {
    const Folder folder;
    fs::create_directories(folder.file("f"));
    fs::create_directories(folder.file("b"));
    const auto check = [&](const std::string& states, const std::string& bounds, const std::string& claims) {
        folder.write("f/states.txt", states);
        folder.write("b/states.txt", bounds);
        const std::string bound = bounds.empty() ? "" : "bounds " + checksum(bounds) + " b\n";
        return certify(write_certificate(folder, selector, bound + "states " + checksum(states) + " f\n" + claims)).out;
    };
    const std::string valuations = "0 1 * * * 1 * \n1 0 * * * 0 * \n";
    // The outputs of the selector are unknown. The samples are open until the PLC reads them.
    const std::string open = "* * * * 0 * 1 \n* * 0 0 0 * 0 \n";
    EXPECT_EQ(check(open, valuations, "holds off\n"),
              "rejected: f/states.txt:1: the state has a successor that the file does not contain\n");
    EXPECT_EQ(check(open, "", "holds one\n"),
              "rejected: f/states.txt:1: the state has a successor that the file does not contain\n");
    const std::string both = "* * * * 0 * 1 \n* * * * 1 * 1 \n* * 0 0 0 * 0 \n* * 0 0 1 * 0 \n";
    EXPECT_EQ(check(both, "", "holds one\n"), "rejected: f/states.txt:1: the state decides `one`\n");
    EXPECT_NE(check(both, valuations, "holds one\n").find("one: holds, proved by the states\n"), std::string::npos);
    EXPECT_EQ(check(both, valuations, "holds off\n"), "rejected: f/states.txt:2: the state decides `off`\n");
    EXPECT_EQ(check(both, valuations, "holds ends\n"),
              "rejected: f/states.txt is incomplete, or a model error is possible\n");
    // Bounds must also be closed, and prove no property.
    EXPECT_EQ(check(both, "1 0 * * * 0 * \n", "holds one\n"),
              "rejected: b/states.txt:1: the state has a successor that the file does not contain\n");
    const std::string only = "bounds " + checksum(valuations) + " b\nholds one\n";
    EXPECT_EQ(certify(write_certificate(folder, selector, only)).out,
              "error: certificate.txt:3: b/states.txt is damaged or belongs to another certificate\n");
    folder.write("b/states.txt", valuations);
    EXPECT_EQ(certify(write_certificate(folder, selector, only)).out, "rejected: no states prove `one`\n");
}

/// Within an edge, a variable may have a value outside of the bounds.
TEST(Certify, AppliesBoundsOnlyToTheValuesBeforeAnEdge) {
    const Folder folder;
    fs::create_directories(folder.file("f"));
    fs::create_directories(folder.file("b"));
    const std::string network =
        "grafverif-network 2\nvariable A 0 1 1\nvariable B 0 1 1\nvariable C 0 1 1\nprocess p 1 0\n"
        "edge 0 0 1\nset A B\nset C A\nset A 1\nprocess q 1 0\nedge 0 0 1\nset B (not B)\nproperty ok always C\n";
    const std::string bounds = "1 * * * * \n", states = "* * 1 0 * \n";
    folder.write("b/states.txt", bounds);
    folder.write("f/states.txt", states);
    const std::string claims = "bounds " + checksum(bounds) + " b\nstates " + checksum(states) + " f\nholds ok\n";
    EXPECT_EQ(certify(write_certificate(folder, network, claims)).out,
              "rejected: f/states.txt:1: the state has a successor that the file does not contain\n");
}

/// The samples are known in the states in which the PLC has read one of them: a choice is part of the successor.
TEST(Certify, KeepsChoicesOfOpenVariables) {
    const Folder folder;
    fs::create_directories(folder.file("f"));
    const std::string head =
        "grafverif-network 2\nvariable IN 0 1 0\nvariable S 0 1 0\nvariable FIRST 0 1 0\nvariable BAD 0 1 0\n"
        "process button 1 0\nedge 0 0 1\nset IN (not IN)\nprocess plc 3 0\nedge 0 1 1\nset S IN\n"
        "edge 1 2 1\nset FIRST S\n";
    const auto check = [&](const std::string& network, const std::string& states) {
        folder.write("f/states.txt", states);
        const std::string claims = "states " + checksum(states) + " f\nholds ok\n";
        return certify(write_certificate(folder, network, claims)).out;
    };
    // A copy of an open variable is also open, so that the copies are chosen separately.
    const std::string copies = head + "property ok never (and FIRST (not S))\n";
    EXPECT_EQ(check(copies, "* * * 0 * 2 \n* * 0 0 * 1 \n* 0 0 0 * 0 \n"),
              "rejected: f/states.txt:1: the state decides `ok`\n");
    // A guard chooses the value. The successor contains the choice, so that FIRST has the value of S.
    const std::string chosen = head + "edge 2 2 S\nset BAD (not S)\nproperty ok never BAD\n";
    EXPECT_NE(check(chosen, "* * * 0 * 2 \n* * 0 0 * 1 \n* 0 0 0 * 0 \n* 1 * 0 * 2 \n").find("ok: holds"),
              std::string::npos);
    EXPECT_EQ(check(chosen, "* * * 0 * 2 \n* * 0 0 * 1 \n* 0 0 0 * 0 \n"),
              "rejected: f/states.txt:1: the state has a successor that the file does not contain\n");
}

TEST(Certify, DelaysOfSeveralUnitsNeedBoundsThatAreMultiples) {
    const Folder folder;
    fs::create_directories(folder.file("f"));
    const auto check = [&](const std::string& when, const std::string& states, const std::string& claim) {
        const std::string network =
            "grafverif-network 2\nvariable A 0 1 0\nprocess p 2 0\nclock x\ninvariant 0 x <= 6\n"
            "edge 0 1 1\nwhen x " +
            when +
            "\nprocess q 2 0\nedge 0 1 1\nset A 1\nproperty off never (= @p 1)\n"
            "property passes no-timelock\nproperty low reachable (> @p 1)\n";
        folder.write("f/states.txt", states);
        return certify(write_certificate(folder, network, "step 3\nstates " + checksum(states) + " f\n" + claim)).out;
    };
    const std::string states = "* 0 0 * \n* 0 3 * \n* 0 6 * \n* 1 0 * \n";
    EXPECT_NE(check(">= 6", states, "violated low\n").find("low: violated, proved by the states\n"), std::string::npos);
    EXPECT_EQ(check(">= 6", states, "holds off\n"), "rejected: f/states.txt:4: the state decides `off`\n");
    EXPECT_EQ(check(">= 5", states, "violated low\n"),
              "rejected: a bound is strict, or is not a multiple of the step\n");
    EXPECT_EQ(check("> 3", states, "violated low\n"),
              "rejected: a bound is strict, or is not a multiple of the step\n");
    EXPECT_EQ(check(">= 6", states, "holds passes\n"),
              "rejected: f/states.txt is incomplete, or a model error is possible\n");
}

/// In steps of two units, each of the urgent edges would stop time in every run to location 3. With a reset at time 1,
/// both edges are disabled when time passes.
TEST(Certify, UrgentEdgesWithClocksDoNotStopLongDelays) {
    const Folder folder;
    fs::create_directories(folder.file("f"));
    const std::string network =
        "grafverif-network 2\nprocess P 5 0\nclock t\nclock x\nedge 0 1 1\nreset x\nedge 1 4 urgent 1\nwhen t <= 0\n"
        "edge 1 2 1\nwhen t = 4\nedge 2 4 urgent 1\nwhen x <= 2\nedge 2 3 1\nwhen t >= 6\nproperty bad never (= @P "
        "3)\n";
    // Location, t and x; caps are 7 and 3.
    const std::string states =
        "0 0 0\n0 2 0\n0 4 0\n0 6 0\n1 0 0\n1 2 0\n1 4 0\n1 4 2\n1 6 0\n1 6 2\n1 6 3\n"
        "2 4 0\n2 4 2\n4 0 0\n";
    folder.write("f/states.txt", states);
    const std::string claims = "step 2\nstates " + checksum(states) + " f\nholds bad\n";
    EXPECT_EQ(certify(write_certificate(folder, network, claims)).out,
              "rejected: f/states.txt:5: the state has a successor that the file does not contain\n");
}

TEST(Certify, RejectsSubsystemsThatDependOnEachOther) {
    const Folder folder;
    const auto check = [&](const std::string& network, const std::vector<std::string>& parts) {
        std::string claims;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::string name = "part" + std::to_string(i);
            fs::create_directories(folder.file(name));
            folder.write(name + "/states.txt", parts[i]);
            claims += "subsystem " + checksum(parts[i]) + ' ' + name + '\n';
        }
        return certify(write_certificate(folder, network, claims + "holds lives\n")).out;
    };
    const std::string head = "grafverif-network 2\nvariable A 0 1 0\nvariable B 0 1 0\nprocess p 1 0\n";
    const std::string apart = head +
                              "edge 0 0 1\nset A (not A)\nprocess q 1 0\nedge 0 0 1\nset B (not B)\n"
                              "property lives no-deadlock\n";
    const std::string left = "0 * 0 * \n1 * 0 * \n", right = "* 0 * 0 \n* 1 * 0 \n";
    EXPECT_NE(check(apart, {left, right}).find("lives: holds, proved by the states\n"), std::string::npos);
    EXPECT_EQ(check(apart, {left}), "rejected: no states prove `lives`\n");
    EXPECT_EQ(check("grafverif-network 2\nproperty lives no-deadlock\n", {}), "rejected: no states prove `lives`\n");
    const std::string reads = head +
                              "edge 0 0 B\nset A (not A)\nprocess q 1 0\nedge 0 0 1\nset B (not B)\n"
                              "property lives no-deadlock\n";
    EXPECT_EQ(check(reads, {left, right}), "rejected: a subsystem reads a value of another subsystem\n");
    const std::string writes = head +
                               "edge 0 0 1\nset A (not A)\nprocess q 1 0\nedge 0 0 1\nset A (not B)\n"
                               "property lives no-deadlock\n";
    EXPECT_EQ(check(writes, {left, right}),
              "rejected: an edge of another subsystem changes a value of this subsystem\n");
    const std::string blocked = head +
                                "edge 0 0 0\nset A (not A)\nprocess q 1 0\nedge 0 0 1\nset B (not B)\n"
                                "property lives no-deadlock\n";
    EXPECT_EQ(check(blocked, {"0 * 0 * \n", right}),
              "rejected: part0/states.txt:1: the state violates `no deadlock`\n");
}

TEST(Certify, RejectsMalformedFilesWithAMessage) {
    const Folder folder;
    const std::string head = "grafverif-network 2\nvariable V 0 1 0\nprocess p 1 0\n";
    std::string nested = "edge 0 0 ", chain = head + "define a0 V\n";
    for (int i = 0; i < 600; ++i) nested += "(not ";
    nested += "V" + std::string(600, ')') + '\n';
    for (int i = 1; i < 6000; ++i) chain += "define a" + std::to_string(i) + " (not a" + std::to_string(i - 1) + ")\n";
    const std::vector<std::pair<std::string, std::string>> networks = {
        {"", "network.txt:0: expected `grafverif-network 2`"},
        {"grafverif-network 1\n", "network.txt:1: expected `grafverif-network 2`"},
        {"grafverif-network 2\nprocess p\n", "network.txt:2: the line is incomplete"},
        {"grafverif-network 2\nprocess p 0 0\n", "network.txt:2: `0` is not a number or is out of range"},
        {"grafverif-network 2\nprocess p 2 2\n", "network.txt:2: `2` is not a number or is out of range"},
        {"grafverif-network 2\nvariable V 0 9999999999999999999999 0\n",
         "network.txt:2: `9999999999999999999999` is not a number or is out of range"},
        {"grafverif-network 2\nvariable V -9223372036854775808 0 0\n",
         "network.txt:2: `-9223372036854775808` is not a number or is out of range"},
        {head + "variable V 0 1 0\n", "network.txt:4: `term V` is declared twice"},
        {head + "clock x\nclock x\n", "network.txt:5: `clock p x` is declared twice"},
        {head + "invariant 1 x <= 1\n", "network.txt:4: `1` is not a number or is out of range"},
        {head + "invariant 0 x <= 1\n", "network.txt:4: unknown clock p x"},
        {head + "clock x\ninvariant 0 x != 1\n", "network.txt:5: invalid relation"},
        {head + "location l\n", "network.txt:4: unexpected `location`"},
        {head + "settled 1\nsettled 0\n", "network.txt:5: `settled` is declared twice"},
        {head + "property a always 1\nproperty a always V\n", "network.txt:5: `property a` is declared twice"},
        {head + "process p 1 0\n", "network.txt:4: `term @p` is declared twice"},
        {head + "variable W 0 1 2\n", "network.txt:4: `2` is not a number or is out of range"},
        {head + "edge 0 1 1\n", "network.txt:4: `1` is not a number or is out of range"},
        {head + "edge 0 0 (and V\n", "network.txt:4: the line is incomplete"},
        {head + "edge 0 0 (not V V)\n", "network.txt:4: wrong number of operands"},
        {head + "edge 0 0 (at V V)\n", "network.txt:4: unknown operator at"},
        {head + "edge 0 0 W\n", "network.txt:4: unknown term W"},
        {head + "edge 0 0 V V\n", "network.txt:4: unexpected `V`"},
        {head + "edge 0 0 V\nset @p 0\n", "network.txt:5: unknown variable @p"},
        {head + "set V 1\n", "network.txt:4: unexpected `set`"},
        {head + "property p/q always V\n", "network.txt:4: a property has a `/` in its name"},
        {head + "property p stable always V\n", "network.txt:4: `settled` is not defined"},
        {head + "edge 0 0 V", "network.txt:3: the last line is incomplete"},
        {head + nested, "network.txt:4: parentheses are nested too deeply"},
        {chain, "network.txt:5004: a term is nested too deeply"},
    };
    for (const auto& [network, message] : networks) {
        const Certified found = certify(write_certificate(folder, network, ""));
        EXPECT_EQ(found.code, 2) << network.substr(0, 200);
        EXPECT_EQ(found.out, "error: " + message + '\n') << network.substr(0, 200);
    }
    const std::vector<std::pair<std::string, std::string>> indices = {
        {"holds missing\n", "certificate.txt:3: unknown property missing"},
        {"proves lit\n", "certificate.txt:3: unknown line"},
        {"omitted lit late\rlit: holds, proved by the states\n",
         "certificate.txt:3: the line contains a control character"},
        {"omitted lit \xc2\x9b"
         "2A\n",
         "certificate.txt:3: the line contains a control character"},
        {"also ../other\n", "certificate.txt:3: invalid folder"},
        {"also .other\n", "certificate.txt:3: invalid folder"},
        {"holds lit\n7 1\nend\n", "certificate.txt:4: `7` is not a number or is out of range"},
        {"holds lit\n1 1\nend\nholds lit\n1 1\nend\n", "certificate.txt:6: two claims about `lit`"},
        {"reacts other\n", "certificate.txt:3: unknown process other"},
        {"states 0\n", folder.file("states.txt") + ": no such file"},
    };
    for (const auto& [claims, message] : indices) {
        const Certified found = certify(write_certificate(folder, lamp, claims));
        EXPECT_EQ(found.code, 2) << claims;
        EXPECT_EQ(found.out, "error: " + message + '\n') << claims;
    }
    EXPECT_EQ(certify(folder.file("missing")).code, 2);
}

/// The check of a folder that contains itself ends with a message.
TEST(Certify, BoundsItsWork) {
    const Folder folder;
    const std::string path = write_certificate(folder, lamp, "also again\n");
    fs::create_directory_symlink(path, fs::path(path) / "again");
    const Certified endless = certify(path);
    EXPECT_EQ(endless.code, 2);
    EXPECT_NE(endless.out.find("no such file"), std::string::npos) << endless.out;
}

/// 500,000 states.
TEST(Certify, ChecksLongPathsInLinearTime) {
    const Folder folder;
    const std::string network =
        "grafverif-network 2\nvariable V 0 500000 0\nprocess p 1 0\n"
        "edge 0 0 urgent (< V 500000)\nset V (+ V 1)\nproperty ends inevitable (= V 500000)\n";
    std::string states;
    for (int i = 0; i <= 500'000; ++i) states += std::to_string(i) + " 0 \n";
    folder.write("states.txt", states);
    const Certified certified =
        certify(write_certificate(folder, network, "states " + checksum(states) + "\nholds ends\n"));
    EXPECT_EQ(certified.code, 0) << certified.out;
}

TEST(Certify, IsSmallAndIncludesNoOtherModule) {
    std::size_t lines = 0;
    for (const auto& entry : fs::directory_iterator(root / "src/certify")) {
        if (entry.path().extension() == ".txt") continue;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            const std::size_t start = line.find_first_not_of(' ');
            if (start == std::string::npos || line.substr(start).starts_with("//")) continue;
            if (!line.starts_with("#include")) ++lines;
            if (!line.starts_with("#include \"")) continue;
            EXPECT_TRUE(fs::exists(root / "src/certify" / line.substr(10, line.size() - 11))) << line;
        }
    }
    EXPECT_LE(lines, 661U) << "lines without comments and includes";
}

}  // namespace
}  // namespace grafverif::app
