// SPDX-License-Identifier: MIT
// Report: what an engine found out about one model: every verdict with what it rests on, and the run that shows it in
// the words of the charts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/named_constant.hpp"
#include "grafverif/ir/state_profile.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// What every verdict of a report rests on.
struct Basis {
    std::string engine = {};  ///< `timed`
    std::string mode = {};    ///< `stability-search`, `every-cycle`; both where controllers differ
    std::string grain = {};   ///< `phased`, `atomic`
    std::int64_t time_unit_ms = 1000;
    /// What an untimed model is made of: `no plant`, `plant automata, interleaved`; empty: the check is timed.
    std::string untimed = {};
    std::vector<NamedConstant> constants = {};  ///< of the loop, with the values in force

    bool operator==(const Basis&) const = default;
};

struct Answer {
    Verdict verdict = {};
    std::string text = {};               ///< of the property, as the model has it
    std::optional<ChartRun> trace = {};  ///< the verdict's run
    std::string carries = {};            ///< of an untimed verdict: what it says of the timed loop
    std::string place = {};  ///< `file:line` of the property, where somebody with the sources has looked it up

    bool operator==(const Answer&) const = default;
};

/// A place where the model breaks off.
struct Breakdown {
    std::string code = {};  ///< `out-of-range`, `action-race`, `no-value`
    std::string message = {};
    ChartRun trace = {};

    bool operator==(const Breakdown&) const = default;
};

struct Report {
    std::string model = {};  ///< the closed loop
    Basis basis = {};
    std::vector<Answer> answers = {};
    std::vector<Breakdown> breakdowns = {};
    std::vector<std::string> failures =
        {};  ///< faults of ours: runs that the rules do not confirm; none of them is told
    std::optional<StateProfile> profile = {};  ///< where the states came from: of a search that was long, or on request

    bool operator==(const Report&) const = default;
};

}  // namespace grafverif
