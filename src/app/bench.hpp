// SPDX-License-Identifier: MIT
// The test bench: a controller is driven through a test sequence line by line and its outputs are compared in every scan
// (JESA13 section 6). Each sequence starts the controller anew, which is its power-on.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/options.hpp"
#include "grafverif/report/test_report.hpp"

namespace grafverif::app {

struct BenchOptions {
    std::string controller = {};                     ///< the command that runs it, for the shell
    Clock clock = Clock::Simulated;
    bool go_on = false;                              ///< after a failure, as far as that is possible
    std::chrono::milliseconds patience{10'000};      ///< for one answer
    const std::atomic<bool>* stop = nullptr;         ///< set by somebody else: run no further step
    std::function<void(std::size_t)> progress = {};  ///< called with the number of rows done
};

/// Empty where the shell finds no such program. Throws std::system_error where it cannot be started.
std::optional<TestReport> run_test(const TestSequence& test, const BenchOptions& options);

}  // namespace grafverif::app
