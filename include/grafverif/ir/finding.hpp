// SPDX-License-Identifier: MIT
// Finding: a potential defect of a chart, with a run as evidence. Analysis: all findings about one chart, with their
// assumptions.
//
// A finding states that something can happen, with a shortest run to it as evidence; or that something never happens,
// optionally with a run that comes as near as possible. Length is measured in input changes first, then in evolutions.
// Possible events are found with timer outputs that respect only their order. The run is then given concrete times, and
// Timing states if this succeeded. Impossible events are impossible for all times. The same is true of elements that
// are never used again after some situation; the evidence is a shortest run to it.
//
// Invariants (see verify): every code is one of finding_codes(); an accepted finding has a reason.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

struct Finding {
    enum class Level { Error, Warning, Note };
    /// States if the evidence is possible in real time.
    enum class Timing {
        Untimed,      ///< independent of time conditions
        Confirmed,    ///< the evidence contains times
        Unconfirmed,  ///< no times were found for the evidence: the finding may be spurious
    };
    struct Related {
        Span where = {};
        std::string message = {};
        bool operator==(const Related&) const = default;
    };

    std::string code = {};  ///< `step-never-active`
    Level level = Level::Warning;
    std::string subject = {};  ///< subject that `accept` can name: `X4`, `t3`, `LOCK`; empty: the chart
    std::string message = {};  ///< text as in a diagnostic
    Span origin = {};
    std::vector<Related> related = {};
    std::vector<std::string> lost = {};  ///< steps, transitions and variables that are never used again, in this order
    std::optional<ChartRun> evidence = {};
    std::string evidence_shows = {};  ///< event at the end of the evidence
    Timing timing = Timing::Untimed;
    std::optional<std::string> accepted = {};  ///< reason given in the source

    bool operator==(const Finding&) const = default;
};

/// Two Boolean inputs that are never true simultaneously.
struct Exclusion {
    Id<Chart::Variable> first = {}, second = {};
    std::string reason = {};
    Span origin = {};

    bool operator==(const Exclusion&) const = default;
};

/// A query of the analysis without a result.
struct OpenQuestion {
    std::string code = {};  ///< of the potential finding
    std::string subject = {};
    std::size_t instants = 0;     ///< no evidence within this number of instants
    std::int64_t evolutions = 0;  ///< for a counter: nor within this number of evolutions in total; 0: unknown

    bool operator==(const OpenQuestion&) const = default;
};

struct Analysis {
    std::string chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::vector<Finding> findings = {};   ///< errors first, then by code and position
    std::vector<std::string> notes = {};  ///< assumptions of all findings
    std::size_t questions = 0;            ///< number of queries
    std::vector<OpenQuestion> open = {};  ///< queries without a result; the results of all others are complete
    /// Reason for open queries; empty if there are none.
    std::string obstacle = {};
    std::size_t instants = 0;  ///< input changes to the farthest explored situation
    double seconds = 0;
    std::uint64_t bytes = 0;
    std::vector<std::string> failures = {};  ///< internal errors: evidence that fails the replay

    bool operator==(const Analysis&) const = default;
};

/// A code, its default level and its meaning in one sentence.
struct FindingKind {
    std::string_view code = {};
    Finding::Level level = Finding::Level::Warning;
    std::string_view meaning = {};
};

/// All codes, in the order of reports.
std::span<const FindingKind> finding_kinds();

/// True if a code concerns elements that are never used again: decided only if all situations are known.
bool is_trap(std::string_view code);

/// `error`, `warning`, `note`.
std::string_view word(Finding::Level level);

/// True if the finding requires action: not a note, and not accepted.
bool is_open(const Finding& finding);

std::vector<std::string> verify(const Analysis& analysis);

}  // namespace grafverif
