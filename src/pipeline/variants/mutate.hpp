// SPDX-License-Identifier: MIT
// Mutation testing of a chart: determines which mutants are equivalent, violate a property, or fail its test sequence.
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
    /// `path` is the path of the file; includes of a mutant are resolved like those of the original. All arguments must
    /// outlive the object.
    MutantChecker(const Model& model, Id<Chart> chart, std::string path, const ReadOptions& read,
                  std::optional<ExecutionMode> mode);

    /// Decides the properties of the original, and generates its test sequence. Returns false if a limit was reached.
    bool prepare(const Limits& limits);
    /// Returns the properties of the original with expected verdicts, qualified by their loops: `loop.P1`, or `P1` if
    /// there is a single loop.
    const std::vector<std::string>& properties() const { return properties_; }
    /// Returns those of them that hold vacuously.
    const std::vector<std::string>& vacuous() const { return vacuous_; }
    /// Returns the number of steps of the test sequence, or nothing if there is none, for the reason in no_test().
    std::optional<std::size_t> test_steps() const;
    const std::string& no_test() const { return no_test_; }

    MutantFate fate_of(const Mutant& mutant, const Limits& limits) const;

private:
    struct OriginalVerdicts {
        Id<ClosedLoop> loop = {};
        std::vector<std::string> properties = {};  ///< properties with expected verdicts for the original
        std::vector<std::string> vacuous = {};     ///< those of them that hold vacuously
        bool whole = true;                         ///< true if the original has no model error
    };
    std::string shown(const OriginalVerdicts& requested, const std::string& property) const;
    void ask(const Model& mutated, const OriginalVerdicts& requested, const Limits& limits, MutantFate& fate) const;

    const Model& model_;
    Id<Chart> chart_;
    std::string path_;
    const ReadOptions& read_;
    std::optional<ExecutionMode> mode_;
    std::vector<OriginalVerdicts> requested_ = {};
    std::vector<std::string> properties_ = {}, vacuous_ = {};
    std::optional<TestSequence> test_ = {};
    std::string no_test_ = {};
};

}  // namespace grafverif
