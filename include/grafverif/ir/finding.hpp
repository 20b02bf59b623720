// SPDX-License-Identifier: MIT
// Finding: a potential defect of a chart, with a run as evidence. Analysis: all findings about one chart, with their
// assumptions.
//
// A finding states that an event is possible, with a shortest run to the event as evidence, or that an event is
// impossible. For an impossible event, the evidence, if any, is a run that comes as close to the event as possible. A
// run is shorter than another run if it has fewer input changes. Of two runs with the same number
// of input changes, the run with fewer evolutions is shorter. The search for possible events takes
// into account only the order in which timer outputs change, not the times of these changes.
// After the search, concrete times are computed for the run, and Timing states if such times exist.
// Therefore, an event that the search finds impossible is impossible for all times. A finding that
// elements are never used again is also valid for all times; its evidence is a shortest run to a
// situation after which these elements are never used.
//
// Invariants (see verify): every code is one of finding_kinds(); an accepted finding has a reason.
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
    /// Result of the search for concrete times of the evidence.
    enum class Timing {
        Untimed,      ///< the evidence does not depend on time conditions
        Confirmed,    ///< concrete times were found, and the evidence contains these times
        Unconfirmed,  ///< no times were found for the evidence; the finding may be spurious
    };
    struct Related {
        Span where = {};
        std::string message = {};
        bool operator==(const Related&) const = default;
    };

    std::string code = {};  ///< finding code, such as `step-never-active`
    Level level = Level::Warning;
    /// Subject that `accept` can name, such as `X4`, `t3` or `LOCK`; empty if the finding concerns the complete chart.
    std::string subject = {};
    std::string message = {};  ///< text in the form of a diagnostic message
    Span origin = {};
    std::vector<Related> related = {};
    std::vector<std::string> lost = {};  ///< steps, transitions and variables that are never used again, in this order
    std::optional<ChartRun> evidence = {};
    std::string evidence_shows = {};  ///< description of the event at the end of the run `evidence`
    Timing timing = Timing::Untimed;
    /// Reason that `accept` gives for accepting the finding; empty if the finding is not accepted.
    std::optional<std::string> accepted = {};

    bool operator==(const Finding&) const = default;
};

/// Two Boolean inputs that are never true simultaneously.
struct Exclusion {
    Id<Chart::Variable> first = {}, second = {};
    std::string reason = {};
    Span origin = {};

    bool operator==(const Exclusion&) const = default;
};

/// A query of the analysis whose result is unknown.
struct OpenQuestion {
    std::string code = {};  ///< code of the potential finding
    std::string subject = {};
    std::size_t instants = 0;  ///< no run with at most this number of input changes is evidence

    /// For a counter: no run with at most this number of evolutions is evidence; 0 if unknown.
    std::int64_t evolutions = 0;

    bool operator==(const OpenQuestion&) const = default;
};

struct Analysis {
    std::string chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    /// The findings, sorted by level (errors first), code and position.
    std::vector<Finding> findings = {};
    std::vector<std::string> notes = {};  ///< assumptions that apply to all findings
    std::size_t questions = 0;            ///< number of queries
    std::vector<OpenQuestion> open = {};  ///< queries without a result; all other queries have been decided

    /// Reason why the queries in `open` are undecided; empty if `open` is empty.
    std::string obstacle = {};
    std::size_t instants = 0;  ///< number of input changes to the farthest explored situation
    double seconds = 0;
    std::uint64_t bytes = 0;
    std::vector<std::string> failures = {};  ///< internal errors: evidence that the replay does not confirm

    bool operator==(const Analysis&) const = default;
};

/// A finding code, its default level and its meaning in one sentence.
struct FindingKind {
    std::string_view code = {};
    Finding::Level level = Finding::Level::Warning;
    std::string_view meaning = {};
};

/// Returns all codes, in the order of reports.
std::span<const FindingKind> finding_kinds();

/// True if the code concerns elements that are never used again. A query about elements that are
/// never used again is decided only if all reachable situations are known.
bool is_trap(std::string_view code);

/// Returns `error`, `warning` or `note`.
std::string_view word(Finding::Level level);

/// True if the finding requires action: it is not a note and is not accepted.
bool is_open(const Finding& finding);

std::vector<std::string> verify(const Analysis& analysis);

}  // namespace grafverif
