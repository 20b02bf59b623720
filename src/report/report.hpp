// SPDX-License-Identifier: MIT
// Report: what an engine found out about one model, ready to be shown. The writers of this room turn it into text, JSON
// and JUnit XML; a single trace also into a waveform and a drawing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/flat_system.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/verdict.hpp"
#include "report/tell.hpp"

namespace grafverif {

/// What every verdict of a report rests on.
struct Basis {
    std::string engine = {};  ///< `timed`
    std::string mode = {};    ///< `stability-search`, `every-cycle`; both where controllers differ
    std::string grain = {};   ///< `phased`, `atomic`
    std::int64_t time_unit_ms = 1000;
    /// What an untimed model is made of: `no plant`, `plant automata, interleaved`; empty: the check is timed.
    std::string untimed = {};

    bool operator==(const Basis&) const = default;
};

/// Of the controllers and the grain of `network`.
Basis basis_of(const Network& network, std::string engine);
/// Of an untimed check; it has no grain of its own unless the caller says so.
Basis basis_of(const TransitionSystem& system, std::string engine, std::string untimed);

struct Answer {
    Verdict verdict = {};
    std::string text = {};            ///< of the property, as the model has it
    std::optional<ChartRun> trace = {};  ///< tells the verdict's run
    std::string carries = {};         ///< of an untimed verdict: what it says of the timed loop

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

    bool operator==(const Report&) const = default;
};

/// `verdict` with the text of its property; its run is told, and dropped.
Answer answer_of(const Network& network, Verdict verdict, Detail detail);
/// The same of an untimed check; `run` shows the verdict.
Answer answer_of(const TransitionSystem& system, Verdict verdict, const std::optional<SystemRun>& run, Detail detail);
Breakdown breakdown_of(const TransitionSystem& system, const SystemFault& fault, Detail detail);
Breakdown breakdown_of(const Network& network, const ModelError& error, Detail detail);

/// How many verdicts there are of each kind. An unknown verdict that the model does not ask for is only a note.
struct Tally {
    std::size_t holds = 0, violated = 0, unknown = 0, undeclared_unknown = 0;
    std::size_t unexpected = 0;  ///< decided, and not as the model expects
    bool operator==(const Tally&) const = default;
};
Tally tally(const Report& report);

}  // namespace grafverif
