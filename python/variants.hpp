// SPDX-License-Identifier: MIT
// Tuning, fault analysis, recordings and certificates for Python, through the internal interface of the library.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "grafverif/grafverif.hpp"

namespace grafverif::python {

/// Text and JSON of a result, as the program prints them, and the text and the timing diagram of each trace of the JSON
/// document, in order.
using Shown = std::tuple<std::string, std::string, std::vector<std::pair<std::string, std::string>>>;

/// Decides properties for all values of constants. `over` contains ranges such as `N=1..8`. The result is empty after
/// an error.
std::optional<Shown> tune(const ParseResult& reading, Id<ClosedLoop> loop, const std::vector<std::string>& over,
                          std::vector<std::string> properties, const ModelOptions& how, const ReadOptions& read,
                          bool every_point, const Limits& limits, Diagnostics& diagnostics);

/// Returns the maximum number of faults of a combination, the maximum value of `order`.
std::uint64_t most_faults_of_combination();

/// Analyses the faults of a closed loop. The result is empty after an error.
std::optional<Shown> faults(const ParseResult& reading, Id<ClosedLoop> loop, std::uint64_t order,
                            std::vector<std::string> properties, const ModelOptions& how, const Limits& limits,
                            Diagnostics& diagnostics);

/// A certificate: the paths, relative to its folder, and contents of its files; the names of the certified properties;
/// the names of all other properties with the reasons.
struct CertificateFiles {
    std::vector<std::pair<std::string, std::string>> files = {};
    std::vector<std::string> certified = {};
    std::vector<std::pair<std::string, std::string>> omitted = {};
};

/// Creates the certificate of a timed report, and adds its failures to the report. The result is empty after an error.
std::optional<CertificateFiles> certify(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                                        const CheckOptions& options, Report& report);

/// A recording whose samples arrive one by one.
class Recording {
public:
    /// The columns of each element of `skew` have a common clock, whose offset is at most the bound in microseconds.
    using Skew = std::vector<std::pair<std::vector<std::string>, std::int64_t>>;

    /// The check has no time limit. `map` contains pairs of the name of a column and the name of a variable.
    Recording(std::shared_ptr<const ParseResult> reading, const std::vector<Id<Chart>>& charts,
              std::optional<ExecutionMode> mode, std::int64_t jitter_ms, const Skew& skew,
              std::vector<std::pair<std::string, std::string>> map, bool stop_early);
    ~Recording();

    /// Adds a line of JSON. Returns false if the check has ended (RecordingMonitor::add).
    bool add(const std::string& line);
    /// Returns the verdicts on the lines so far. The result is empty after an error.
    std::optional<Shown> finish();

    const Diagnostics& diagnostics() const;
    const Sources& sources() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace grafverif::python
