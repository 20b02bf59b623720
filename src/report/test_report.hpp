// SPDX-License-Identifier: MIT
// TestReport: the results of testing a controller, step by step, and functions that write them as text, JSON or JUnit
// XML.
//
// Invariants (see verify): there is one verdict per row of the test. A row is the activation of a sequence (its
// power-on) or one of its steps. The verdict of a row is Failed if and only if `failures` contains a failure of this
// row. The failures are in the order of the rows.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/ir/test_sequence.hpp"

namespace grafverif {

enum class StepVerdict { Passed, Failed, NotRun };

struct TestReport {
    enum class Cause {
        Different,      ///< an output differs from the expected output
        NotUnderstood,  ///< the response is not a valid line of outputs
        Silent,         ///< there was no response within the time limit
        Ended,          ///< the controller ended, or closed its output, before it responded
        Flood,          ///< the response has more than one line, or its line is too long
    };
    struct Failure {
        std::size_t sequence = 0;  ///< index in TestSequence::sequences
        std::size_t row = 0;       ///< index of the row in the sequence; the activation is also a row
        std::uint32_t scan = 1;    ///< number of the first failed scan of the row, starting at 1
        Cause cause = Cause::Different;
        std::vector<std::int64_t> answered = {};  ///< actual value of each output; only for the cause Different
        std::string message = {};                 ///< details of the cause; empty for the cause Different
        bool operator==(const Failure&) const = default;
    };

    TestSequence test = {};
    std::string controller = {};                          ///< the command that runs the controller
    std::vector<std::vector<StepVerdict>> verdicts = {};  ///< verdict per sequence and row
    std::vector<Failure> failures = {};
    double seconds = 0;

    bool operator==(const TestReport&) const = default;
};

/// Returns the rows of a sequence: its activation, if the sequence has an activation, and its steps.
std::vector<const TestSequence::Step*> rows_of(const TestSequence::Sequence& sequence);
/// Returns a name such as `step 2` or `sequence 3, step 2`; an activation is step 0.
std::string row_name(const TestSequence& test, std::size_t sequence, std::size_t row);

struct TestTally {
    std::size_t passed = 0, failed = 0, not_run = 0;
    bool operator==(const TestTally&) const = default;
};
TestTally tally(const TestReport& report);

std::vector<std::string> verify(const TestReport& report);

/// Prints one line per row, the differences below failed rows, and a summary. If `failures_only` is true, only failed
/// rows are printed.
void print_text(const TestReport& report, bool failures_only, std::ostream& out);

/// Prints the report as JSON. Missing values, and `failure` of rows that have not failed, are null. The document is
/// `{"chart", "mode", "controller", "verdict":"passed|failed|unknown", "passed", "failed", "not_run", "seconds",
/// "steps":[{"sequence", "step", "verdict":"passed|failed|not run", "cycles", "wait_ms", "inputs":{}, "expected":{},
/// "situation", "failure":{"cause", "scan", "answered":{}, "message"}}]}`.
void print_json(const TestReport& report, std::ostream& out);

/// Returns a test case per row: passed, failed, or skipped if it was not run.
std::string junit_suite(const TestReport& report);

}  // namespace grafverif
