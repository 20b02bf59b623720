// SPDX-License-Identifier: MIT
// Tests `replay` and `monitor`: verdicts for recordings of a controller in all formats, and errors in logs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <utility>

#include "pipeline/recording/recording.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

constexpr const char* pump =
    "grafcet pump {\n"
    "input START, STOP; output PUMP, HORN; output LEVEL: int 0..9;\n"
    "initial step 1; step 2 { PUMP; LEVEL := 4 on activation; } step 3 { HORN; }\n"
    "transition t1: 1 -> 2 when START && !STOP; transition t2: 2 -> 3 when 3s/X2; transition t3: 2 -> 1 when STOP;\n"
    "transition t4: 3 -> 1 when STOP;\n"
    "}\n";

const std::string head = "time,START,STOP,PUMP,HORN,LEVEL\n0,0,0,0,0,0\n";

Result replayed(const std::string& log, std::vector<std::string> options = {}, const std::string& chart = pump) {
    const Folder folder;
    options.insert(options.begin(), {"replay", folder.write("pump.grafcet", chart), "--log", "-"});
    return grafverif(options, log);
}

testing::AssertionResult conforms(const Result& result) {
    if (result.code == ExitCode::Done && result.out.starts_with("pump: conforms\n")) return testing::AssertionSuccess();
    return testing::AssertionFailure() << result.out << result.err;
}

testing::AssertionResult deviates(const Result& result, const std::string& text) {
    if (result.code == ExitCode::Verdict && result.out.starts_with("pump: deviates\n") &&
        result.out.find(text) != std::string::npos)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << result.out << result.err;
}

TEST(Replay, AcceptsOutputsWithinTheJitter) {
    EXPECT_TRUE(conforms(replayed(head + "1.000,1,,,,\n1.015,,,1,,4\n4.030,,,0,1,\n9,,,,,\n")));
    EXPECT_TRUE(conforms(replayed(head + "1.000,,,1,,4\n1.010,1,,,,\n4.02,,,0,,\n4.035,,,,1,\n9,,,,,\n")));
}

TEST(Replay, RejectsAChangeThatIsTooLate) {
    EXPECT_TRUE(deviates(replayed(head + "1.000,1,,,,\n1.100,,,1,,4\n9,,,,,\n"),
                         "  <standard input>:3: `PUMP` is 0, but the chart sets it to 1 at 1 s\n"));
    EXPECT_TRUE(conforms(replayed(head + "1.000,1,,,,\n1.100,,,1,,4\n4.1,,,0,1,\n9,,,,,\n", {"--jitter", "60ms"})));
    // A jitter of 49 ms explains at most 98 ms between the input and the output.
    EXPECT_EQ(replayed(head + "1.000,1,,,,\n1.100,,,1,,4\n9,,,,,\n", {"--jitter", "49ms"}).code, ExitCode::Verdict);
}

TEST(Replay, RejectsAChangeThatTheChartDoesNotMake) {
    const Result result = replayed(head + "1,1,,1,,4\n2,,,0,,\n9,,,,,\n");
    EXPECT_TRUE(deviates(result,
                         "  <standard input>:4: `PUMP` changes to 0 at 2 s, but the chart requires 1\n"
                         "  active steps: {2}\n"));
    EXPECT_NE(result.out.find("t1"), std::string::npos) << result.out;
}

TEST(Replay, RejectsAWrongIntegerAndAMissingTimerExpiry) {
    EXPECT_TRUE(deviates(replayed(head + "1,1,,1,,5\n9,,,,,\n"), "`LEVEL`"));
    EXPECT_TRUE(deviates(replayed(head + "1,1,,1,,4\n9,,,,,\n"), "`PUMP` is 1, but the chart sets it to 0 at 4 s\n"));
}

TEST(Replay, FollowsBothOrdersOfAnInputAndATimeWithinTheJitter) {
    const std::string start = head + "1,1,,1,,4\n1.5,0,,,,\n";
    EXPECT_TRUE(conforms(replayed(start + "3.99,,1,0,,\n9,,,,,\n")));               // STOP before the 3 s: step 1
    EXPECT_TRUE(conforms(replayed(start + "3.99,,1,0,1,\n4.02,,,,0,\n9,,,,,\n")));  // STOP after the 3 s: step 3
    EXPECT_EQ(replayed(start + "3.9,,1,0,1,\n4.02,,,,0,\n9,,,,,\n").code, ExitCode::Verdict);
    EXPECT_EQ(replayed(start + "3.99,,1,0,1,\n3.991,,,,0,\n9,,,,,\n", {"--jitter", "0ms"}).code, ExitCode::Verdict);
}

TEST(Replay, AllowsAPulseShorterThanTheJitterToBeUnrecorded) {
    const std::string pulse = head + "1,1,,,,\n1.01,0,1,,,4\n9,,,,,\n";
    EXPECT_TRUE(conforms(replayed(pulse)));
    EXPECT_EQ(replayed(pulse, {"--jitter", "2ms"}).code, ExitCode::Verdict);
}

TEST(Replay, AcceptsDriftOfRepeatedTimes) {
    const std::string blinker =
        "grafcet pump { output L; initial step 1; step 2 { L; }\n"
        "transition a: 1 -> 2 when 1s/X1; transition b: 2 -> 1 when 1s/X2; }\n";
    std::string log = "time;L\n0;0\n";
    for (int k = 1; k <= 200; ++k) log += std::to_string(1010 * k) + "ms;" + std::to_string(k % 2) + "\n";
    EXPECT_TRUE(conforms(replayed(log, {}, blinker)));
    EXPECT_EQ(replayed(log, {"--jitter", "4ms"}, blinker).code, ExitCode::Verdict);
}

TEST(Replay, ReadsEachFormat) {
    const std::string csv = head + "1,1,,1,,4\n2,,,0,,\n9,,,,,\n";
    const std::string json =
        "{\"time\":0,\"START\":false,\"STOP\":false,\"PUMP\":false,\"HORN\":0,\"LEVEL\":0}\n"
        "{\"time\":1,\"START\":true,\"PUMP\":true,\"LEVEL\":4}\n{\"time\":\"2000ms\",\"PUMP\":false}\n{\"time\":9}\n";
    const std::string vcd =
        "$timescale 1 ms $end $scope module plc $end $var wire 1 a START $end $var wire 1 b STOP $end\n"
        "$var reg 1 c PUMP $end $var wire 1 d HORN $end $var integer 32 e LEVEL $end $upscope $end\n"
        "$enddefinitions $end\n#0 $dumpvars 0a 0b 0c 0d b0 e $end\n#1000 1a 1c b100 e\n#2000 0c\n#9000\n";
    const std::string german =
        "\xEF\xBB\xBFZeit;START;STOP;PUMP;HORN;LEVEL\r\n0;0;0;0;0;0\r\n1;1;;TRUE;;4\r\n"
        "2;;;FALSE;;\r\n9;;;;;\r\n";
    for (const std::string& log : {csv, json, vcd, german})
        EXPECT_TRUE(deviates(replayed(log), "`PUMP` changes to 0 at 2 s, but the chart requires 1\n")) << log;
    const std::string tabs =
        "time\tSTART\tSTOP\tPUMP\tHORN\tLEVEL\n0\t0\t0\t0\t0\t0\n1\t1\t\t1\t\t4\n2\t\t\t0\t\t\n9\t\t\t\t\t\n";
    EXPECT_TRUE(deviates(replayed(tabs), "  <standard input>:4: `PUMP` changes to 0 at 2 s"));
    const std::string quoted =
        "\"time\",\"START\",STOP,PUMP, \"HORN\" "
        ",LEVEL,\"a,b\"\n0,0,0,0,0,\"0\",\"x,y\"\n1,1,,1,,4,\n2,,,0,,,\n9,,,,,,\n";
    EXPECT_TRUE(deviates(replayed(quoted), "  <standard input>:4: `PUMP` changes to 0 at 2 s"));
}

TEST(Replay, RejectsUnknownValuesOfAValueChangeDump) {
    const std::string head_of_dump =
        "$timescale 1 ms $end $var wire 1 a START $end $var wire 1 b STOP $end $var wire 1 c PUMP $end\n"
        "$var wire 1 z OTHER $end $enddefinitions $end\n#0 0a 0b 0c xz\n";
    const Result known = replayed(head_of_dump + "#1000 1a 1c zz\n#2000\n");
    EXPECT_EQ(known.code, ExitCode::Done) << known.err;
    const Result unknown = replayed(head_of_dump + "#1000 xa\n#2000\n");
    EXPECT_EQ(unknown.code, ExitCode::Input);
    EXPECT_NE(unknown.err.find("the value of `START` is unknown, not an integer, or longer than 63 bits"),
              std::string::npos)
        << unknown.err;
}

TEST(Replay, ReadsFractionsOfAMicrosecond) {
    const std::string chart =
        "grafcet pump { input A, B; output L; initial step 1; step 2 { L; } transition t: 1 -> 2 when A && !B; }\n";
    const std::string dump =
        "$timescale 100 ns $end $var wire 1 a A $end $var wire 1 b B $end $var wire 1 c L $end $enddefinitions $end\n"
        "#0 0a 0b 0c\n";
    EXPECT_TRUE(conforms(replayed(dump + "#10100 1a 1c\n#10900 1b\n#20000\n", {"--jitter", "0ms"}, chart)));
    EXPECT_EQ(replayed(dump + "#10100 1a 1b 1c\n#20000\n", {"--jitter", "0ms"}, chart).code, ExitCode::Verdict);
}

TEST(Replay, NamesTheTimeOfAModelErrorThatExplainsTheRecording) {
    const std::string chart =
        "grafcet pump { input A, B; output L; initial step 1; step 2 { L; }\n"
        "transition a: 1 -> 2 when A; transition b: 2 -> 1 when B; }\n";
    const Result result = replayed("t,A,B,L\n0,0,0,0\n1,1,,1\n2,0,,\n2.01,,1,0\n3,,0,\n100,,,1\n101,,,\n", {}, chart);
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.out.find("an admissible timing has a model error at 2010 ms, and no other timing explains the "
                              "recording"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("<standard input>:7: `L` changes to 1 at 100 s"), std::string::npos) << result.out;
}

TEST(Replay, StatesTheFirstOfSeveralMissingChanges) {
    const std::string chart =
        "grafcet pump { input A; output N: int 0..9; initial step 1; step 2 { N := 3 on activation; }\n"
        "step 3 { N := 5 on activation; } transition a: 1 -> 2 when A; transition b: 2 -> 3 when 10ms/X2; }\n";
    EXPECT_TRUE(
        deviates(replayed("t,A,N\n0,0,0\n1,1,\n9,,\n", {}, chart), "`N` is 0, but the chart sets it to 3 at 1 s"));
}

TEST(Replay, MergesRowsWithTheSameTime) {
    EXPECT_TRUE(conforms(replayed("time,START,STOP,PUMP,HORN,LEVEL\n0,0,0,,0,\n0,,,0,,0\n9,,,,,\n")));
    EXPECT_TRUE(conforms(replayed(head + "1,1,,,,\n1,,,1,,4\n4,,,0,,\n4,,,,1,\n9,,,,,\n", {"--jitter", "0ms"})));
}

TEST(Replay, StatesTheLengthOfTheInconclusivePart) {
    const Result conforming = replayed(head + "1,1,,1,,4\n2,,,,,\n");
    EXPECT_NE(conforming.out.find("3 samples of <standard input> from 0 s to 2 s, jitter 20 ms; the last 0.08 s of "
                                  "the recording are inconclusive\n"),
              std::string::npos)
        << conforming.out;
    // A deviation is found as soon as the samples extend over four times the jitter after the deviation.
    EXPECT_TRUE(conforms(replayed(head + "1,1,,,,\n1.08,,,,,\n")));
    EXPECT_TRUE(
        deviates(replayed(head + "1,1,,,,\n1.080001,,,,,\n"), "`PUMP` is 0, but the chart sets it to 1 at 1 s"));
}

TEST(Replay, LimitsTheOrdersOfEventsAndTheInstants) {
    std::string chart = "grafcet many {\n";
    std::string names = "time", values = "0", changes = "1", changes_back = "1.001";
    for (int k = 0; k < 18; ++k) {
        const std::string n = std::to_string(k);
        chart += "input i" + n + "; output o" + n + "; initial step a" + n + "; step b" + n + " { o" + n +
                 "; } transition t" + n + ": a" + n + " -> b" + n + " when i" + n + ";\n";
        names += ",i" + n + ",o" + n;
        values += ",0,0";
        changes += ",1,";
        changes_back += ",0,";
    }
    const std::string log =
        names + "\n" + values + "\n" + changes + "\n" + changes_back + "\n2" + std::string(36, ',') + "\n";
    const Result orders = replayed(log, {}, chart + "}\n");
    EXPECT_EQ(orders.code, ExitCode::Unknown);
    EXPECT_NE(orders.out.find("too many orders of events are possible; reduce `--jitter`"), std::string::npos)
        << orders.out;
    const Result skew = replayed(log, {"--skew", "i0,i1=1ms"}, chart + "}\n");
    EXPECT_NE(skew.out.find("too many orders of events are possible; reduce `--jitter` or `--skew`"), std::string::npos)
        << skew.out;
    EXPECT_EQ(skew.out.find("clock offset of"), std::string::npos) << "the check has not excluded other offsets";
    const std::string blinker =
        "grafcet blinker { output L; initial step 1; step 2; transition a: 1 -> 2 when 1ms/X1;\n"
        "transition b: 2 -> 1 when 1ms/X2; }\n";
    const Result instants = replayed("time,L\n0,0\n2000,0\n", {"--jitter", "0ms"}, blinker);
    EXPECT_EQ(instants.code, ExitCode::Unknown);
    EXPECT_NE(instants.out.find("too many sequences of instants are possible between two"), std::string::npos)
        << instants.out;
}

TEST(Replay, StopsAtATimeLimit) {
    const std::string blinker =
        "grafcet pump { output L; initial step 1; step 2 { L; }\n"
        "transition a: 1 -> 2 when 1ms/X1; transition b: 2 -> 1 when 1ms/X2; }\n";
    std::string log = "time,L\n0,0\n";
    for (int k = 1; k <= 1'000'000; ++k) log += std::to_string(k) + "ms," + std::to_string(k % 2) + "\n";
    const Result stopped = replayed(log, {"--jitter", "0ms", "--timeout", "150ms"}, blinker);
    EXPECT_EQ(stopped.code, ExitCode::Unknown) << stopped.out;
    EXPECT_NE(stopped.out.find("stopped before the end of the log; no deviation up to the last sample read"),
              std::string::npos)
        << stopped.out;
}

TEST(Replay, MapsColumnsToNames) {
    const std::string log = "t,I0.0,STOP,Q0.0,HORN,LEVEL,X\n0,0,0,0,0,0,5\n1,1,,1,,4,\n4,,,0,1,,\n9,,,,,,\n";
    const Result result = replayed(log, {"--map", "I0.0=START", "--map", "Q0.0=PUMP"});
    EXPECT_TRUE(conforms(result));
    EXPECT_NE(
        result.err.find("note: columns ignored, because no checked chart has an input or output of the same name: `X`"),
        std::string::npos)
        << result.err;
    EXPECT_NE(replayed(log, {"--map", "I0.1=START"}).err.find("did you mean `I0.0`?"), std::string::npos);
    EXPECT_NE(replayed(log, {"--map", "I0.0=STRT"}).err.find("did you mean `START`?"), std::string::npos);
    EXPECT_NE(replayed(log, {"--map", "START"}).err.find("use COLUMN=NAME"), std::string::npos);
}

// The columns of the outputs have the times of a clock that is 300 ms ahead.
const std::string skewed = head +
                           "1,1,,,,\n1.310,,,1,,4\n2,0,,,,\n4.305,,,0,1,\n6,,1,,,\n6.3,,,,0,\n7,,0,,,\n"
                           "8,1,,,,\n8.29,,,1,,\n8.5,0,,,,\n9,,1,,,\n9.312,,,0,,\n10,,,,,\n12,,,,,\n";

TEST(Replay, FindsTheOffsetOfAClock) {
    EXPECT_TRUE(deviates(replayed(skewed), "`PUMP` is 0, but the chart sets it to 1 at 1 s"));
    const Result found = replayed(skewed, {"--skew", "PUMP,HORN,LEVEL=500ms"});
    EXPECT_TRUE(conforms(found));
    // Each change of an output is recorded at most 40 ms before or after the time of the input change plus the offset.
    EXPECT_NE(found.out.find("  clock offset of `PUMP`, `HORN`, `LEVEL`: 0.272 s to 0.33 s (--skew 500 ms)\n"),
              std::string::npos)
        << found.out;
    EXPECT_NE(found.out.find("15 samples of <standard input> from 0 s to 12 s, jitter 20 ms, skew 500 ms; the last "
                             "1.08 s of the recording are inconclusive\n"),
              std::string::npos)
        << found.out;
    const Result inputs = replayed(skewed, {"--skew", "START,STOP=500ms"});
    EXPECT_TRUE(conforms(inputs));
    EXPECT_NE(inputs.out.find("  clock offset of `START`, `STOP`: -0.33 s to -0.272 s (--skew 500 ms)\n"),
              std::string::npos)
        << inputs.out;
    const Result small = replayed(skewed, {"--skew", "PUMP,HORN,LEVEL=100ms"});
    EXPECT_TRUE(deviates(small,
                         "  No admissible timing explains the recording with any clock offset within the bounds."
                         " The timing that agrees with the longest part of the recording:\n"));
    EXPECT_NE(small.out.find("  clock offset of `PUMP`, `HORN`, `LEVEL`: "), std::string::npos) << small.out;
}

TEST(Replay, RejectsAnOffsetThatChanges) {
    // The first change is recorded 300 ms late, the second one 100 ms late.
    const std::string log = head + "1,1,,,,\n1.3,,,1,,4\n2,0,1,,,\n2.1,,,0,,\n9,,,,,\n";
    const Result result = replayed(log, {"--skew", "PUMP,HORN,LEVEL=500ms"});
    EXPECT_TRUE(deviates(result, "`PUMP` changes to 0 at 2.1 s, but the chart requires 1\n"));
    EXPECT_NE(result.out.find("  clock offset of `PUMP`, `HORN`, `LEVEL`: 0.26 s to 0.34 s (--skew 500 ms)\n"),
              std::string::npos)
        << result.out;
    EXPECT_TRUE(conforms(replayed(log, {"--skew", "PUMP,HORN,LEVEL=500ms", "--jitter", "60ms"})));
}

TEST(Replay, FindsTheOffsetsOfSeveralClocks) {
    const std::string log = head + "0.8,,,1,,4\n1,1,,,,\n2,0,,,,\n3.8,,,0,,\n4.4,,,,1,\n6,,1,,,\n6.4,,,,0,\n9,,,,,\n";
    EXPECT_EQ(replayed(log, {"--skew", "PUMP,HORN,LEVEL=500ms"}).code, ExitCode::Verdict);
    const Result found = replayed(log, {"--skew", "PUMP,LEVEL=250ms", "--skew", "HORN=0.5", "--format", "json"});
    EXPECT_EQ(found.code, ExitCode::Done) << found.out << found.err;
    const auto json = nlohmann::json::parse(found.out);
    EXPECT_EQ(json["skew"], 0.5);
    const auto& offsets = json["charts"][0]["offsets"];
    ASSERT_EQ(offsets.size(), 2U);
    EXPECT_EQ(offsets[0]["columns"], nlohmann::json({"PUMP", "LEVEL"}));
    EXPECT_EQ(offsets[0]["bound"], 0.25);
    EXPECT_LE(offsets[0]["low"], -0.2);
    EXPECT_GE(offsets[0]["high"], -0.2);
    EXPECT_LE(offsets[1]["low"], 0.4);
    EXPECT_GE(offsets[1]["high"], 0.4);
}

TEST(Replay, RejectsInvalidClocks) {
    for (const char* const text : {"PUMP", "=1s", "PUMP=", "PUMP=1h", "PUMP,=1s", "PUMP=-1s"}) {
        const Result result = replayed(skewed, {"--skew", text});
        EXPECT_EQ(result.code, ExitCode::Input) << text;
        EXPECT_NE(result.err.find("use COLUMN[,COLUMN...]=TIME, such as `PUMP,HORN=500ms`"), std::string::npos)
            << result.err;
    }
    EXPECT_NE(replayed(skewed, {"--skew", "PUMPE=1s"}).err.find("did you mean `PUMP`?"), std::string::npos);
    EXPECT_NE(replayed(skewed, {"--skew", "PUMP,HORN=1s", "--skew", "PUMP=1s"})
                  .err.find("`--skew` names the column `PUMP` twice; name it once"),
              std::string::npos);
    EXPECT_NE(
        replayed("time,START,NOTE\n0,0,1\n1,0,2\n", {"--skew", "NOTE=1s"}).err.find("remove the column from `--skew`"),
        std::string::npos);
}

TEST(Replay, ReportsMissingColumns) {
    const Result inputs = replayed("time,PUMP\n0,0\n");
    EXPECT_EQ(inputs.code, ExitCode::Input);
    EXPECT_NE(inputs.err.find("<standard input>:1:1: error: the log has no column for `START`, `STOP` of `pump`"),
              std::string::npos)
        << inputs.err;
    const Result outputs = replayed("time,START,STOP,PUMP\n0,0,0,0\n1,1,0,1\n2,,,\n");
    EXPECT_TRUE(conforms(outputs));
    EXPECT_NE(outputs.err.find("warning: the log has no column for `HORN`, `LEVEL` of `pump`, which are not checked"),
              std::string::npos)
        << outputs.err;
    EXPECT_NE(replayed("time,START,STOP\n0,0,0\n").err.find("[unrecorded]"), std::string::npos);
}

TEST(Replay, ReportsEachErrorOfALogWithItsPlace) {
    const Result result = replayed(
        head + "1,1,,,,\n0.5,,,,,\nx,,,,,\n2,on,,,,\n3,2,,,,\n4,1\n\n5,,,,12,\n-1,,,,,\n1e9,,,,,\n6,0.5,,,,\n");
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.out, "");
    for (const char* const text :
         {":4:1: error: the time is before the time of the previous sample", ":5:1: error: `x` is not a time",
          ":6:3: error: `on` is neither a Boolean nor an integer", ":7:3: error: the value 2 of `START` is outside",
          ":8:1: error: this line has 2 fields, but the first line has 6", ":10:6: error: the value 12 of `HORN`",
          ":11:1: error: `-1` is not a time", ":12:1: error: `1e9` is not a time",
          ":13:3: error: `0.5` is neither a Boolean nor an integer", "    2,on,,,,\n      ^^\n"})
        EXPECT_NE(result.err.find(text), std::string::npos) << text << '\n' << result.err;
}

TEST(Replay, RejectsLogsThatAreEmptyOrNotText) {
    for (const std::string& log :
         {std::string(), std::string("\n \n"), std::string("time,START,STOP,PUMP\n"), std::string("time\n1\n"),
          std::string("\xFF\xFEt\0i\0m\0", 8), std::string("{\"time\":0}\n"), std::string("{\"time\":0\n"),
          std::string("[1]\n"), std::string("$var wire 1 a"), std::string("$timescale 3 ms $end"),
          std::string("time,START,STOP,PUMP\n0,,0,0\n"), std::string("time,START,STOP,PUMP,PUMP\n0,0,0,0,0\n"),
          std::string(3 << 20, '1')}) {
        const Result result = replayed(log);
        EXPECT_EQ(result.code, ExitCode::Input) << log.substr(0, 50) << result.out;
        EXPECT_NE(result.err.find("error: "), std::string::npos) << log.substr(0, 50);
    }
}

TEST(Replay, ReportsDeviationsAsJson) {
    const Result result = replayed(head + "1,1,,1,,4\n2,,,0,,\n9,,,,,\n", {"--format", "json"});
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["jitter"], 0.02);
    const auto& chart = json["charts"][0];
    EXPECT_EQ(chart["verdict"], "deviates");
    const auto& deviation = chart["deviation"];
    EXPECT_EQ(deviation["time"], 2.0);
    EXPECT_EQ(deviation["line"], 4);
    EXPECT_EQ(deviation["output"], "PUMP");
    EXPECT_EQ(deviation["recorded"], 0);
    EXPECT_EQ(deviation["allowed"], 1);
    EXPECT_EQ(deviation["situation"], "{2}");
    EXPECT_EQ(deviation["trace"]["steps"].size(), 2U);
}

TEST(Replay, PrintsTheSameRunWithAndWithoutAReport) {
    const Folder folder;
    const std::string file = folder.write("pump.grafcet", pump);
    std::string log = head;
    for (int k = 1; k <= 40; ++k) {
        const std::string second = std::to_string(10 * k);
        log += second + ",1,,1,," + (k == 1 ? "4" : "") + "\n" + second + ".2,0,,,,\n" + second + ".5,,1,0,,\n" +
               second + ".7,,0,,,\n";
    }
    log = folder.write("log.csv", log + "500,,,1,,\n510,,,,,\n");
    for (const char* const format : {"json", "text"}) {
        const auto printed = [&](std::vector<std::string> options) {
            options.insert(options.begin(), {"replay", file, "--log", log, "--format", format});
            const Result result = grafverif(options);
            EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
            return result.out;
        };
        const std::string text = printed({});
        EXPECT_EQ(printed({"--report", folder.file("page.html")}), text);
        if (format == std::string("text")) {
            EXPECT_NE(text.find("agrees with the longest part of the recording ends with:\n"), std::string::npos)
                << text;
            continue;
        }
        const auto deviation = nlohmann::json::parse(text)["charts"][0]["deviation"];
        EXPECT_EQ(deviation["complete"], false);
        EXPECT_EQ(deviation["trace"]["steps"].size(), 16U);
    }
    EXPECT_NE(folder.read("page.html").find("Play the run up to the deviation"), std::string::npos);
}

TEST(Replay, WritesAReportWithTheRun) {
    const Folder folder;
    const std::string file =
        folder.write("pump.grafcet",
                     std::string(pump) +
                         "closed_loop l { controller pump; environment A = push_button(OUT = START); environment B "
                         "= push_button(OUT = STOP);\nproperty P1: never PUMP && START; property P2: never HORN; }\n");
    const auto page = [&](const std::string& log, ExitCode code) {
        const Result result =
            grafverif({"replay", file, "--log", folder.write("log.csv", log), "--report", folder.file("page.html")});
        EXPECT_EQ(result.code, code) << result.out << result.err;
        EXPECT_NE(result.out.find("samples of "), std::string::npos);
        return folder.read("page.html");
    };
    const auto contains = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    };
    // The last row of the run is the last instant before the deviation. The values from 1 s on violate P1.
    const std::string late = page(head + "1,1,,1,,4\n2,0,,,,\n3,,,0,,\n9,,,,,\n", ExitCode::Verdict);
    contains(late, "<strong>The recording deviates from 1 chart and violates 1 property.</strong>");
    contains(late, "log.csv:5: <code>PUMP</code> changes to 0 at 3 s, but the chart requires 1.");
    contains(late,
             "<button type=\"button\" class=\"play\" data-run=\"pump\">▶ Play the run up to the deviation</button>");
    contains(late, "id=\"property-l.P1\"");
    contains(late, "<a href=\"#pump/1\">Show 1 s in the run of pump</a>");
    contains(late, "not violated by these samples");
    const auto json = [](const std::string& text) {
        const std::string begin = "<script type=\"application/json\" id=\"data\">";
        const std::size_t from = text.find(begin) + begin.size();
        return nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
    };
    const auto run = json(late)["runs"][0];
    EXPECT_EQ(run["kind"], "recording");
    EXPECT_EQ(run["rows"].size(), 3U);
    EXPECT_EQ(run["rows"][1]["cleared"], "t1");
    EXPECT_NE(run["end"].get<std::string>().find("log.csv:5: `PUMP` changes to 0"), std::string::npos);
    EXPECT_EQ(json(late)["charts"][0]["name"], "pump");
    // The run of a recording that conforms contains all instants, even if `replay` does not print all of them.
    std::string log = head;
    for (int k = 1; k <= 40; ++k) {
        const std::string second = std::to_string(10 * k);
        log += second + ",1,,1,," + (k == 1 ? "4" : "") + "\n" + second + ".2,0,,,,\n" + second + ".5,,1,0,,\n" +
               second + ".7,,0,,,\n";
    }
    const std::string conforming = page(log + "500,,,,,\n", ExitCode::Verdict);
    contains(conforming, "Play the recording");
    EXPECT_EQ(json(conforming)["runs"][0]["rows"].size(), 161U);
    EXPECT_EQ(conforming.find("earlier instants are omitted"), std::string::npos);
}

TEST(Replay, ChecksAllChartsOfAFile) {
    const std::string two = std::string(pump) +
                            "grafcet lamp { input PUMP; output LAMP; initial step 1; step 2 { LAMP; }\n"
                            "transition a: 1 -> 2 when PUMP; transition b: 2 -> 1 when !PUMP; }\n";
    const std::string log = "time,START,STOP,PUMP,LAMP\n0,0,0,0,0\n1,1,,1,1\n1.5,,1,0,\n9,,,,\n";
    const Result result = replayed(log, {}, two);
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_NE(result.out.find("pump: conforms\nlamp: deviates\n"), std::string::npos) << result.out << result.err;
    EXPECT_TRUE(conforms(replayed(log, {"--chart", "pump"}, two)));
}

TEST(Replay, ChecksStatePropertiesOfRecordedVariables) {
    const std::string loop =
        std::string(pump) +
        "closed_loop l { controller pump; environment A = push_button(OUT = START); environment B = push_button(OUT = "
        "STOP);\n"
        "property P1: never PUMP && HORN; property P2: always STOP => !PUMP; property P3: never X2 && X3;\n"
        "property P4: reachable HORN; }\n";
    // For 9 ms, the recorded values of PUMP and STOP are both true, which delays of the recording explain.
    const std::string log = head + "1,1,0,1,,4\n2,0,,,,\n3,,1,,,\n3.009,,,0,,\n";
    const Result passed = replayed(log + "9,,,,,\n", {}, loop);
    EXPECT_EQ(passed.code, ExitCode::Done) << passed.out << passed.err;
    EXPECT_NE(passed.out.find("property P1: not violated by these samples\n"
                              "property P2: not violated by these samples\n6 samples"),
              std::string::npos)
        << passed.out;
    const Result failed = replayed(log + "5,1,,1,,\n5.1,,0,,,\n9,,,,,\n", {}, loop);
    EXPECT_EQ(failed.code, ExitCode::Verdict);
    EXPECT_NE(failed.out.find("property P2: violated\n  <standard input>:7: the values from 5 s on violate it\n"),
              std::string::npos)
        << failed.out;
}

TEST(Replay, ToleratesTheOffsetsOfClocksInProperties) {
    const std::string loop =
        std::string(pump) +
        "closed_loop l { controller pump; environment A = push_button(OUT = START); environment B = push_button(OUT = "
        "STOP);\nproperty P1: never PUMP && STOP; property P2: never PUMP && LEVEL == 4; property P3: never START && "
        "PUMP; "
        "}\n";
    // For 300 ms, PUMP and STOP are both true, because their clocks differ. START and PUMP are both true for 700 ms.
    const std::string log = head + "1,1,,,,\n1.3,,,1,,4\n2,0,1,,,\n2.3,,,0,,\n9,,,,,\n";
    const Result skew = replayed(log, {"--skew", "PUMP,LEVEL=300ms"}, loop);
    EXPECT_NE(skew.out.find("property P1: not violated"), std::string::npos) << skew.out;
    EXPECT_NE(skew.out.find("property P3: violated"), std::string::npos) << skew.out;
    // PUMP and LEVEL have the same clock.
    EXPECT_NE(skew.out.find("property P2: violated"), std::string::npos) << skew.out;
}

TEST(Replay, ReportsModelErrorsAsUnknown) {
    const std::string unstable =
        "grafcet pump { input GO; output L; initial step 1; step 2 { L; }\n"
        "transition a: 1 -> 2 when GO; transition b: 2 -> 1 when GO; }\n";
    const Result result = replayed("time,GO,L\n0,0,0\n1,1,1\n9,,\n", {}, unstable);
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.out.find("pump: unknown\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("[total-instability]"), std::string::npos) << result.out;
    const Result every = replayed("time,GO,L\n0,0,0\n", {"--mode", "every-cycle"}, unstable);
    EXPECT_EQ(every.code, ExitCode::Input);
}

TEST(Replay, AcceptsTheTraceOfASimulation) {
    const Folder folder;
    const std::string trace = folder.file("trace.vcd");
    ASSERT_EQ(grafverif({"simulate", station, "--random", "7", "--steps", "300", "--trace-vcd", trace}).code,
              ExitCode::Done);
    const Result result = grafverif({"replay", station, "--log", trace, "--jitter", "1ms"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_NE(result.out.find("testing_station: conforms\n"), std::string::npos) << result.out;
}

TEST(Monitor, EndsAtTheFirstDeviation) {
    const Folder folder;
    const std::string file = folder.write("pump.grafcet", pump);
    const Result result = grafverif({"monitor", file}, head + "1,1,,1,,4\n2,,,0,,\n3,,,,,\nnot read\n");
    EXPECT_TRUE(deviates(result, "`PUMP` changes to 0 at 2 s"));
    EXPECT_TRUE(conforms(grafverif({"monitor", file, "--skew", "PUMP,HORN,LEVEL=500ms"}, skewed)));
    const Result bad = grafverif({"monitor", file}, head + "1,1,,1,,4\nbad\nworse\n2,7,,,,\n");
    EXPECT_EQ(bad.code, ExitCode::Input);
    EXPECT_NE(bad.err.find(":4:1: error: `bad` is not a time"), std::string::npos) << bad.err;
    EXPECT_EQ(bad.err.find("worse"), std::string::npos) << bad.err;
    const Result range = grafverif({"monitor", file}, head + "1,2,,1,,4\nbad\n");
    EXPECT_NE(range.err.find("the value 2 of `START` is outside"), std::string::npos) << range.err;
    EXPECT_EQ(range.err.find(":4:"), std::string::npos) << range.err;
    // The samples before an invalid line are reported.
    const Result before = grafverif({"monitor", file}, head + "1,1,,1,,4\n2,,,,,\nbad\n");
    EXPECT_EQ(before.code, ExitCode::Input);
    EXPECT_NE(before.out.find("pump: unknown\n  an invalid line ended the check; no deviation up to this line\n"),
              std::string::npos)
        << before.out;
}

TEST(Monitor, EndsAtTheDeviationOfOneOfSeveralChartsOrAViolatedProperty) {
    const Folder folder;
    const std::string lamp =
        "grafcet lamp { input PUMP; output LAMP; initial step 1; step 2 { LAMP; }\n"
        "transition a: 1 -> 2 when PUMP; transition b: 2 -> 1 when !PUMP; }\n";
    const std::string loop =
        "closed_loop l { controller pump; environment A = push_button(OUT = START); environment B = push_button(OUT = "
        "STOP);\nproperty P: never START; }\n";
    const std::string two = folder.write("two.grafcet", std::string(pump) + lamp);
    const std::string log = "time,START,STOP,PUMP,LAMP\n0,0,0,0,0\n1,1,,1,1\n2,,1,0,\n3,,,,\nnot read\n";
    const Result result = grafverif({"monitor", two}, log);
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_NE(result.out.find("pump: conforms\nlamp: deviates\n"), std::string::npos) << result.out;
    const Result violated = grafverif({"monitor", folder.write("loop.grafcet", std::string(pump) + loop)},
                                      head + "1,1,,1,,4\n2,,,,,\nnot read\n");
    EXPECT_EQ(violated.code, ExitCode::Verdict) << violated.err;
    EXPECT_NE(violated.out.find("property P: violated\n"), std::string::npos) << violated.out;
}

/// Returns a random recording of the pump in JSON lines. Most changes of outputs are those of the chart.
std::vector<std::string> random_samples(std::mt19937_64& random) {
    std::vector<std::string> lines = {
        R"({"time": 0, "START": false, "STOP": false, "PUMP": false, "HORN": false, "LEVEL": 0})"};
    std::int64_t ms = 0;
    const auto add = [&](std::int64_t wait, const std::string& values) {
        ms += wait;
        lines.push_back("{\"time\": \"" + std::to_string(ms) + "ms\"" + (values.empty() ? "" : ", ") + values + "}");
    };
    for (int round = 0; round < 3; ++round) {
        add(1000 + static_cast<std::int64_t>(random() % 1000), R"("START": true)");
        add(static_cast<std::int64_t>(random() % 24), R"("PUMP": true, "LEVEL": 4)");
        add(500, random() % 2 == 0 ? "" : R"("START": false)");
        add(300, R"("STOP": true)");
        add(random() % 5 == 0 ? 200 : static_cast<std::int64_t>(random() % 24), R"("PUMP": false)");
        add(400, R"("START": false, "STOP": false)");
    }
    add(2000, random() % 8 == 0 ? R"("PUMP": 7)" : "");
    return lines;
}

// If samples are added one by one, the verdicts are those of the complete recording.
TEST(RecordingMonitor, HasTheReportOfTheCompleteRecording) {
    ParseResult read = read_string(pump, "pump.grafcet");
    ASSERT_TRUE(read.model.has_value());
    std::mt19937_64 random(1);
    int conforming = 0, deviating = 0, rejected = 0;
    for (int k = 0; k < 60; ++k) {
        const std::vector<std::string> lines = random_samples(random);
        const RecordingOptions options{.stop_early = k % 2 == 0};
        std::string log;
        for (const std::string& line : lines) log += line + '\n';
        const auto once = [log](std::string& block) mutable {
            block = std::exchange(log, "");
            return !block.empty();
        };
        Sources sources, sources_by_line;
        Diagnostics diagnostics, diagnostics_by_line;
        const auto whole = check_recording(*read.model, {{0}}, once, "log", options, sources, diagnostics);
        RecordingMonitor monitor(*read.model, {{0}}, "log", options, sources_by_line, diagnostics_by_line);
        bool open = true;
        for (const std::string& line : lines) open = open && monitor.add(line);
        EXPECT_EQ(whole, monitor.finish()) << k;
        EXPECT_EQ(diagnostics.errors(), diagnostics_by_line.errors()) << k;
        rejected += diagnostics.has_errors() ? 1 : 0;
        if (!whole) continue;
        const bool deviates = whole->verdicts[0].kind == RecordingVerdict::Kind::Deviates;
        EXPECT_FALSE(open && deviates && k % 2 == 0) << k;
        ++(deviates ? deviating : conforming);
    }
    EXPECT_GT(conforming, 10);
    EXPECT_GT(deviating, 5);
    EXPECT_GT(rejected, 2);
}

}  // namespace
}  // namespace grafverif::app
