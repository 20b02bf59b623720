// SPDX-License-Identifier: MIT
// Tests `check --certificate` and the program `grafverif-certify`: accepted certificates, invalid files, and the size
// and independence of the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

struct Certified {
    int code = 0;
    std::string out = {};  ///< standard output and standard error
};

Certified certify(const std::string& folder) {
    const std::string line = std::string(GRAFVERIF_CERTIFY) + " '" + folder + "' 2>&1";
    FILE* const pipe = ::popen(line.c_str(), "r");
    std::string text;
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    return {WEXITSTATUS(::pclose(pipe)), text};
}

/// Returns the checksum of a certificate file.
std::string checksum(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    std::ostringstream digits;
    digits << std::hex << std::setw(16) << std::setfill('0') << hash;
    return std::move(digits).str();
}

/// Writes a certificate with correct checksums; `claims` are the lines of the index after `network`.
std::string write_certificate(const Folder& folder, const std::string& network, const std::string& claims) {
    std::string index = "grafverif-certificate 1\nnetwork " + checksum(network) + '\n' + claims;
    index += "checksum " + checksum(index) + '\n';
    folder.write("network.txt", network);
    return fs::path(folder.write("certificate.txt", index)).parent_path().string();
}

constexpr const char* lamp =
    "grafverif-network 1\nvariable ON 0 1 0\nprocess lamp\nlocation off\nlocation on\ninitial off\n"
    "edge off on 1\nset ON 1\nproperty lit reachable ON\nproperty dark never ON\n";

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
    // Without a certificate, the report is that of `report`.
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

TEST(Certificate, OmitsDeadlocksOfSubsystems) {
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
    EXPECT_NE(certified.out.find("lit: violated, shown by a run\n"), std::string::npos) << certified.out;
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

TEST(Certify, AcceptsAShownRunAndRejectsAFalseClaim) {
    const Folder folder;
    const Certified shown = certify(write_certificate(folder, lamp, "holds lit\ntake lamp 0\nend\n"));
    EXPECT_EQ(shown.code, 0) << shown.out;
    EXPECT_NE(shown.out.find("lit: holds, shown by a run\ndark: not certified: no claim\n"), std::string::npos);
    const Certified not_shown = certify(write_certificate(folder, lamp, "holds lit\ndelay 1\nend\n"));
    EXPECT_EQ(not_shown.code, 1);
    EXPECT_EQ(not_shown.out, "rejected: the run of `lit` does not show its verdict\n");
    const std::string states = "0 0 \n";
    folder.write("states.txt", states);
    const Certified open = certify(write_certificate(folder, lamp, "states " + checksum(states) + "\nholds dark\n"));
    EXPECT_EQ(open.code, 1);
    EXPECT_EQ(open.out, "rejected: states.txt:1: the state has a successor that the file does not contain\n");
}

/// A race ends a run: neither an edge nor a delay may follow.
TEST(Certify, RejectsRunsThatContinueAfterARace) {
    const Folder folder;
    const std::string network =
        "grafverif-network 1\nvariable R 0 1 0\nvariable B 0 1 0\nrace R\nprocess p\nlocation a\n"
        "location b\nlocation c\ninitial a\nedge a b 1\nset R 1\nedge b c 1\nset R 0\nset B 1\n"
        "property never_b never B\nproperty races reachable R\nproperty b inevitable B\n";
    EXPECT_EQ(certify(write_certificate(folder, network, "holds races\ntake p 0\nend\n")).code, 0);
    for (const std::string run :
         {"violated never_b\ntake p 0\ntake p 1\nend\n", "holds races\ntake p 0\ndelay 1\nend\n",
          "violated b\ntake p 0\nloop\ndelay 1\nend\n"}) {
        const Certified certified = certify(write_certificate(folder, network, run));
        EXPECT_EQ(certified.code, 1) << run;
        EXPECT_EQ(certified.out, "rejected: a run continues after a race\n") << run;
    }
}

/// The folder of a property proves only this property, so that each property has one result.
TEST(Certify, RejectsFoldersOfOtherProperties) {
    const Folder folder;
    const auto check = [&](const std::string& outer, const std::string& claims, const std::string& inner) {
        const std::string states = "0 \n";
        std::string index =
            "grafverif-certificate 1\nnetwork " + checksum(inner) + "\nstates " + checksum(states) + "\nholds dark\n";
        index += "checksum " + checksum(index) + '\n';
        fs::create_directories(folder.file("dark"));
        folder.write("dark/network.txt", inner);
        folder.write("dark/states.txt", states);
        folder.write("dark/certificate.txt", index);
        return certify(write_certificate(folder, outer, claims));
    };
    const std::string head = "grafverif-network 1\nprocess p\nlocation l\ninitial l\n";
    const std::string dark = head + "property dark never 0\n";
    EXPECT_EQ(check(head, "also dark\n", dark).code, 0);
    EXPECT_EQ(check(lamp, "also dark\n", dark).out, "error: certificate.txt:3: two claims about `dark`\n");
    EXPECT_EQ(check(head, "also dark\nalso dark\n", dark).out, "error: certificate.txt:4: two claims about `dark`\n");
    EXPECT_EQ(check(head, "also dark\n", dark + "property lit reachable 1\n").out,
              "error: certificate.txt:2: the network of the folder `dark` must have only the property `dark`\n");
}

TEST(Certify, RejectsMalformedFilesWithAMessage) {
    const Folder folder;
    const std::string head = "grafverif-network 1\nvariable V 0 1 0\nprocess p\nlocation l\n";
    std::string nested = "edge l l ", chain = head + "define a0 V\n";
    for (int i = 0; i < 600; ++i) nested += "(not ";
    nested += "V" + std::string(600, ')') + '\n';
    for (int i = 1; i < 6000; ++i) chain += "define a" + std::to_string(i) + " (not a" + std::to_string(i - 1) + ")\n";
    const std::vector<std::pair<std::string, std::string>> networks = {
        {"", "network.txt:0: this is not a network of version 1"},
        {"grafverif-network 2\n", "network.txt:1: this is not a network of version 1"},
        {"grafverif-network 1\nprocess p\n", "network.txt:2: a process has no initial location"},
        {"grafverif-network 1\nvariable V 0 9999999999999999999999 0\n",
         "network.txt:2: `9999999999999999999999` is not a number, or too large or small"},
        {head + "initial l\nprocess q\nlocation l\n", "network.txt:7: a process has no initial location"},
        {head + "variable V 0 1 0\n", "network.txt:5: `term V` is declared twice"},
        {head, "network.txt:4: a process has no initial location"},
        {head + "location l\n", "network.txt:5: `location p l` is declared twice"},
        {head + "process q\nclock x\nclock x\n", "network.txt:7: `clock q x` is declared twice"},
        {head + "clock x\n", "network.txt:5: unexpected `clock`"},
        {head + "cap x 1\n", "network.txt:5: unknown word"},
        {head + "process q\ncap x 1\n", "network.txt:6: unexpected `cap`"},
        {head + "process q\nclock x\nlocation l\ncap x -1\n",
         "network.txt:8: `-1` is not a number, or too large or small"},
        {head + "edge l l (at p l V)\n", "network.txt:5: wrong number of operands"},
        {head + "edge l l (at p m)\n", "network.txt:5: unknown word"},
        {head + "initial l\ninitial l\n", "network.txt:6: `initial p` is declared twice"},
        {head + "race V\nrace 0\n", "network.txt:6: `race` is declared twice"},
        {head + "settled 1\nsettled 0\n", "network.txt:6: `settled` is declared twice"},
        {head + "property a always 1\nproperty a always V\n", "network.txt:6: `property a` is declared twice"},
        {"grafverif-network 1\nprocess p\nlocation l\nprocess p\n", "network.txt:4: `process p` is declared twice"},
        {head + "variable W 0 1 2\n", "network.txt:5: `2` is not a number, or too large or small"},
        {head + "edge l m 1\n", "network.txt:5: unknown word"},
        {head + "edge l l (and V\n", "network.txt:5: the line is incomplete"},
        {head + "edge l l (not V V)\n", "network.txt:5: wrong number of operands"},
        {head + "edge l l W\n", "network.txt:5: unknown variable or term"},
        {head + "edge l l V V\n", "network.txt:5: unexpected `V`"},
        {head + "set V 1\n", "network.txt:5: unexpected `set`"},
        {head + "property p stable always V\n", "network.txt:5: `settled` is not defined"},
        {head + "edge l l V", "network.txt:4: the last line is incomplete"},
        {head + nested, "network.txt:5: parentheses are nested too deeply"},
        {chain, "network.txt:5005: a term is too deep"},
    };
    for (const auto& [network, message] : networks) {
        const Certified found = certify(write_certificate(folder, network, ""));
        EXPECT_EQ(found.code, 2) << network.substr(0, 200);
        EXPECT_EQ(found.out, "error: " + message + '\n') << network.substr(0, 200);
    }
    const std::vector<std::pair<std::string, std::string>> indices = {
        {"holds missing\n", "certificate.txt:3: unknown word"},
        {"holds dark\n", "certificate.txt:3: the claim requires `states`"},
        {"proves lit\n", "certificate.txt:3: unknown line"},
        {"omitted lit late\rlit: holds, proved by the states\n",
         "certificate.txt:3: the line contains a control character"},
        {"omitted lit \xc2\x9b"
         "2A\n",
         "certificate.txt:3: the line contains a control character"},
        {"also ../other\n", "certificate.txt:3: invalid folder"},
        {"also .other\n", "certificate.txt:3: invalid folder"},
        {"holds lit\ntake lamp 7\nend\n", "certificate.txt:4: `7` is not a number, or too large or small"},
        {"holds lit\ntake lamp 0\nend\nholds lit\ntake lamp 0\nend\n", "certificate.txt:6: two claims about `lit`"},
        {"states 0\n", folder.file("states.txt") + ": no such file"},
    };
    for (const auto& [claims, message] : indices) {
        const Certified found = certify(write_certificate(folder, lamp, claims));
        EXPECT_EQ(found.code, 2) << claims;
        EXPECT_EQ(found.out, "error: " + message + '\n') << claims;
    }
    EXPECT_EQ(certify(folder.file("missing")).code, 2);
}

/// A longer delay than the run can contain, and a folder that contains itself, end with a message.
TEST(Certify, BoundsItsWork) {
    const Folder folder;
    const Certified waits = certify(write_certificate(folder, lamp, "holds lit\ndelay 4611686018427387904\nend\n"));
    EXPECT_EQ(waits.code, 2);
    EXPECT_EQ(waits.out, "error: certificate.txt:4: `4611686018427387904` is not a number, or too large or small\n");
    const std::string path = write_certificate(folder, lamp, "also again\n");
    fs::create_directory_symlink(path, fs::path(path) / "again");
    const Certified endless = certify(path);
    EXPECT_EQ(endless.code, 2);
    EXPECT_EQ(endless.out,
              "error: certificate.txt:2: the network of the folder `again` must have only the property `again`\n");
}

/// 500,000 states in the order that is worst for a repeated search of predecessors.
TEST(Certify, ChecksLongPathsInLinearTime) {
    const Folder folder;
    const std::string network =
        "grafverif-network 1\nvariable V 0 500000 0\nprocess p\nlocation l\ninitial l\n"
        "edge l l urgent (< V 500000)\nset V (+ V 1)\nproperty ends inevitable (= V 500000)\n";
    std::string states;
    for (int i = 500'000; i >= 0; --i) states += std::to_string(i) + " 0 \n";
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
    EXPECT_LE(lines, 600U) << "lines without comments and includes";
}

}  // namespace
}  // namespace grafverif::app
