// SPDX-License-Identifier: MIT
// Mutation testing of a chart: determines which mutants are equivalent to the chart, violate a property, or fail the
// test sequence of the chart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/mutation.hpp"

namespace grafverif {

/// Checks mutants of a chart against its properties and its test sequence. Thread-safe.
class MutantChecker {
public:
    /// `main` is the source from which `model` was parsed; `sources` also contains its includes. All arguments must
    /// outlive the checker.
    MutantChecker(const Model& model, Id<Chart> chart, Id<Source> main, const Sources& sources, const ReadOptions& read,
                  std::optional<ExecutionMode> mode);

    /// Decides the properties of the original chart in at most a quarter of the time limit, and generates its test
    /// sequence. Returns false if a limit was reached before any property was decided.
    bool prepare(const Limits& limits);
    /// Returns the properties whose verdict for the original chart is the expected one. If there are several loops, the
    /// names are qualified, such as `loop.P1`.
    const std::vector<std::string>& properties() const { return properties_; }
    /// Returns those elements of `properties()` that hold vacuously.
    const std::vector<std::string>& vacuous() const { return vacuous_; }
    /// Returns the properties that are unknown for the original. Mutants are not checked against these properties.
    const std::vector<std::string>& undecided() const { return undecided_; }
    /// Returns the number of steps of the test sequence. If there is no test sequence, the result is empty, and
    /// `no_test()` returns the reason.
    std::optional<std::size_t> test_steps() const;
    const std::string& no_test() const { return no_test_; }

    MutantResult result_of(const Mutant& mutant, const Limits& limits) const;

    /// Returns the model in which the mutant replaces the file that declares the chart, or nullopt after an error.
    std::optional<Model> model_of(const Mutant& mutant, Diagnostics& diagnostics) const;

private:
    struct OriginalVerdicts {
        Id<ClosedLoop> loop = {};
        std::vector<std::string> properties = {};  ///< properties with expected verdicts for the original
        std::vector<std::string> vacuous = {};     ///< the properties that hold vacuously
        std::vector<std::string> undecided = {};
        bool whole = true;  ///< true if the original has no model error
    };
    /// True if a mutant changes the chart `id`: it is the mutated chart, an instance of the mutated chart, or a chart
    /// that contains such an instance. The steps of an instance have the source positions of the steps of the mutated
    /// chart.
    bool is_changed(Id<Chart> id) const;
    std::string shown(const OriginalVerdicts& requested, const std::string& property) const;
    void check_model(const Model& mutated, const OriginalVerdicts& requested, const Limits& limits,
                     MutantResult& mutant_result) const;

    const Model& model_;
    Id<Chart> chart_;
    Id<Source> main_ = {};
    const Sources& sources_;
    const ReadOptions& read_;
    std::optional<ExecutionMode> mode_;
    std::vector<OriginalVerdicts> requested_ = {};
    std::vector<std::string> properties_ = {}, vacuous_ = {}, undecided_ = {};
    std::optional<TestSequence> test_ = {};
    std::string no_test_ = {};
};

}  // namespace grafverif
