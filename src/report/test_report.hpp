// SPDX-License-Identifier: MIT
// TestReport: the results of testing a controller, step by step, for output as text, JSON or JUnit XML.
//
// Invariants (see verify): one verdict per row of the test, a row being the activation of a sequence or one of its
// steps. A row has failed if and only if there is a failure for it; the failures are in the order of the rows.
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
        Different,      ///< an output differs from the expected one
        NotUnderstood,  ///< the response is not a line of outputs
        Silent,         ///< no response within the time limit
        Ended,          ///< the program ended before it responded
        Flood,          ///< more than one line, or one without end
    };
    struct Failure {
        std::size_t sequence = 0;  ///< index in TestSequence::sequences
        std::size_t row = 0;       ///< of the sequence, including its activation
        std::uint32_t scan = 1;    ///< of the row, from 1: the first failed scan
        Cause cause = Cause::Different;
        std::vector<std::int64_t> answered = {};  ///< per output; for Different only
        std::string message = {};                 ///< details; empty for Different
        bool operator==(const Failure&) const = default;
    };

    TestSequence test = {};
    std::string controller = {};                          ///< the command that runs it
    std::vector<std::vector<StepVerdict>> verdicts = {};  ///< per sequence, per row
    std::vector<Failure> failures = {};
    double seconds = 0;

    bool operator==(const TestReport&) const = default;
};

/// The activation, if there is one, and the steps.
std::vector<const TestSequence::Step*> rows_of(const TestSequence::Sequence& sequence);
/// `step 2`, `sequence 3, step 2`; an activation is step 0.
std::string row_name(const TestSequence& test, std::size_t sequence, std::size_t row);

struct TestTally {
    std::size_t passed = 0, failed = 0, not_run = 0;
    bool operator==(const TestTally&) const = default;
};
TestTally tally(const TestReport& report);

std::vector<std::string> verify(const TestReport& report);

/// One line per row, the differences below failed rows, and a summary. `failures_only`: only failed rows.
void print_text(const TestReport& report, bool failures_only, std::ostream& out);

/// `{"chart", "mode", "controller", "verdict":"passed|failed|unknown", "passed", "failed", "not_run", "seconds",
/// "steps":[{"sequence", "step", "verdict":"passed|failed|not run", "cycles", "wait_ms", "inputs":{}, "expected":{},
/// "situation", "failure":{"cause", "scan", "answered":{}, "message"}}]}`; missing values, and `failure` of other rows,
/// are null.
void print_json(const TestReport& report, std::ostream& out);

/// A test case per row: passed, failed, or skipped if it was not run.
std::string junit_suite(const TestReport& report);

}  // namespace grafverif
