// SPDX-License-Identifier: MIT
// What becomes of plausible mistakes in a chart: which are none, which its properties notice, which its test sequence catches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/mutation.hpp"

namespace grafverif {

/// A chart, what is asked of it, and its mutants; may be used by several threads at once.
class MutantBench {
public:
    /// `path`: of the file, whose includes are looked for as those of the original. All outlives the bench.
    MutantBench(const Model& model, Id<Chart> chart, std::string path, const ReadOptions& read,
                std::optional<ExecutionMode> mode);

    /// Decides the properties of the original, and makes its test sequence. False: stopped at a limit.
    bool prepare(const Limits& limits);
    /// The properties that are as expected of the original, with their loops: `loop.P1`, or `P1` of one loop alone.
    const std::vector<std::string>& properties() const { return properties_; }
    /// Those of them that hold vacuously.
    const std::vector<std::string>& vacuous() const { return vacuous_; }
    /// Steps of the test sequence; empty: there is none, for the reason told.
    std::optional<std::size_t> test_steps() const;
    const std::string& no_test() const { return no_test_; }

    MutantFate fate_of(const Mutant& mutant, const Limits& limits) const;

private:
    struct Asked {
        Id<ClosedLoop> loop = {};
        std::vector<std::string> properties = {};  ///< as expected of the original
        std::vector<std::string> vacuous = {};     ///< those of them that hold vacuously
        bool whole = true;                         ///< the original nowhere breaks off
    };
    std::string shown(const Asked& asked, const std::string& property) const;
    void ask(const Model& mutated, const Asked& asked, const Limits& limits, MutantFate& fate) const;

    const Model& model_;
    Id<Chart> chart_;
    std::string path_;
    const ReadOptions& read_;
    std::optional<ExecutionMode> mode_;
    std::vector<Asked> asked_ = {};
    std::vector<std::string> properties_ = {}, vacuous_ = {};
    std::optional<TestSequence> test_ = {};
    std::string no_test_ = {};
};

}  // namespace grafverif
