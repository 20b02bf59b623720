// SPDX-License-Identifier: MIT
// Returns phrases of test reports, and visits the rows of a test report in order.
#pragma once

#include <string>
#include <string_view>

#include "report/test_report.hpp"

namespace grafverif {

/// Returns the name of the execution mode: `stability-search` or `every-cycle`.
std::string_view mode_word(ExecutionMode mode);

/// Returns a cause such as `differs in V1, W1` or `no response within 5s`.
std::string cause_text(const TestReport& report, const TestReport::Failure& failure);

/// Returns inputs, expected and actual outputs by name, and the expected situation. Lines end with a line feed.
std::string failure_text(const TestReport& report, const TestReport::Failure& failure);

/// Calls `visit(sequence, row, failure)` for each row; `failure` is null if the row has not failed.
template <class Visit>
void for_each_row(const TestReport& report, Visit visit) {
    std::size_t next = 0;
    for (std::size_t sequence = 0; sequence < report.verdicts.size(); ++sequence) {
        for (std::size_t row = 0; row < report.verdicts[sequence].size(); ++row) {
            const bool failed = report.verdicts[sequence][row] == StepVerdict::Failed;
            visit(sequence, row, failed ? &report.failures[next++] : nullptr);
        }
    }
}

}  // namespace grafverif
