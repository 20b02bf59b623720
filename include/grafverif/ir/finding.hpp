// SPDX-License-Identifier: MIT
// Finding: something about a chart that its author should know, with the run that shows it. Analysis: all findings about
// one chart, and what they rest on.
//
// A finding says either that something can happen, and its evidence is a shortest run in which it does, or that something
// never happens, and then its evidence, where there is any, is a run that comes as near as can be. A run is short in
// changes of the inputs first, in evolutions then. What can happen is found where the ends of timers are known by their
// order only; a run is then given concrete times, and Timing says whether that was possible. What never happens does not
// happen at any times. So is it with what never comes again from some situation on: its evidence is a shortest run there.
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
    /// Whether the evidence holds in real time.
    enum class Timing {
        Untimed,      ///< no time condition has a part in it
        Confirmed,    ///< the evidence says when
        Unconfirmed,  ///< no times were found at which the evidence can happen: the finding may be none
    };
    struct Related {
        Span where = {};
        std::string message = {};
        bool operator==(const Related&) const = default;
    };

    std::string code = {};  ///< `step-never-active`
    Level level = Level::Warning;
    std::string subject = {};  ///< what `accept` may name: `X4`, `t3`, `LOCK`; empty: the whole chart
    std::string message = {};  ///< worded as a diagnostic
    Span origin = {};
    std::vector<Related> related = {};
    std::vector<std::string> lost = {};  ///< steps, transitions and variables that never come again, in this order
    std::optional<ChartRun> evidence = {};
    std::string evidence_shows = {};  ///< what happens at the end of the evidence
    Timing timing = Timing::Untimed;
    std::optional<std::string> accepted = {};  ///< the reason given in the source

    bool operator==(const Finding&) const = default;
};

/// Two Boolean inputs that are never true together.
struct Exclusion {
    Id<Chart::Variable> first = {}, second = {};
    std::string reason = {};
    Span origin = {};

    bool operator==(const Exclusion&) const = default;
};

/// What an analysis asked and did not come to decide.
struct OpenQuestion {
    std::string code = {};  ///< of the finding that there may be
    std::string subject = {};
    std::size_t instants = 0;     ///< in the first so many instants nothing speaks for it
    std::int64_t evolutions = 0;  ///< a counter: nor in so many evolutions, however they are divided; 0: not known

    bool operator==(const OpenQuestion&) const = default;
};

struct Analysis {
    std::string chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::vector<Finding> findings = {};   ///< errors first, then by code and place
    std::vector<std::string> notes = {};  ///< what all findings rest on
    std::size_t questions = 0;            ///< how many were asked
    std::vector<OpenQuestion> open =
        {};  ///< those that were not decided; all others are: there is what was found, and no more
    /// Why questions are open; empty: none is.
    std::string obstacle = {};
    std::size_t instants = 0;  ///< changes of the inputs to the farthest situation looked at
    double seconds = 0;
    std::uint64_t bytes = 0;
    std::vector<std::string> failures = {};  ///< evidence that the rules do not confirm: faults of ours

    bool operator==(const Analysis&) const = default;
};

/// A code, its usual level and what it means, in one sentence.
struct FindingKind {
    std::string_view code = {};
    Finding::Level level = Finding::Level::Warning;
    std::string_view meaning = {};
};

/// Every code there is, in the order of reports.
std::span<const FindingKind> finding_kinds();

/// Whether a code is about what never comes again: a question that is decided only when every situation is known.
bool is_trap(std::string_view code);

/// `error`, `warning`, `note`.
std::string_view word(Finding::Level level);

/// Whether somebody should act on it: no note, and not accepted.
bool is_open(const Finding& finding);

std::vector<std::string> verify(const Analysis& analysis);

}  // namespace grafverif
