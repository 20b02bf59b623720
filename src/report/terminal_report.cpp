// SPDX-License-Identifier: MIT
// Verdicts as text: a line each, what it rests on under it, then notes and the trace.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>

#include "report/profile.hpp"
#include "report/terminal.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

class Printer {
public:
    Printer(const Report& report, const TextOptions& options, std::ostream& out)
        : report_(report), options_(options), out_(out) {}

    void print() {
        for (const Breakdown& breakdown : report_.breakdowns) print(breakdown);
        shared_reason_ = shared_reason();
        for (const Answer& answer : report_.answers) print(answer);
        if (!shared_reason_.empty()) print_shared_reason();
        if (report_.profile) print_profile(*report_.profile, out_);
        print_tally();
    }

private:
    /// `text` in the colour of what it says.
    std::string painted(std::string_view text, int colour) const {
        if (options_.colour == Colour::Plain) return std::string(text);
        return fmt::format("\033[1;{}m{}\033[0m", colour, text);
    }

    /// What keeps the engine from several verdicts, said once; empty: there is no such thing.
    std::string shared_reason() const {
        std::map<std::string_view, std::size_t> times;
        for (const Answer& answer : report_.answers)
            if (answer.verdict.outcome == Outcome::Unknown) ++times[answer.verdict.reason];
        const auto most = std::ranges::max_element(times, {}, [](const auto& entry) { return entry.second; });
        return most != times.end() && most->second > 1 ? std::string(most->first) : std::string();
    }

    std::string outcome(const Verdict& verdict) const {
        constexpr int red = 31, green = 32, yellow = 33;
        if (verdict.outcome == Outcome::Unknown) return painted("unknown", yellow);
        std::string text(word(verdict.outcome));
        if (verdict.vacuous) text += ", vacuously";
        if (verdict.expected_violated) text += as_expected(verdict) ? ", as expected" : ", but expected to be violated";
        return painted(text, as_expected(verdict) ? green : red);
    }

    void print(const Answer& answer) {
        const Verdict& verdict = answer.verdict;
        out_ << verdict.property;
        if (!answer.text.empty()) out_ << " \"" << printable(answer.text) << '"';
        if (!verdict.declared) out_ << " (not declared)";
        out_ << ": " << outcome(verdict) << "\n    " << basis_words(report_, answer) << '\n';
        if (!verdict.reason.empty() && verdict.reason != shared_reason_)
            out_ << "    why: " << printable(verdict.reason) << '\n';
        for (const std::string& note : verdict.notes) out_ << "    note: " << printable(note) << '\n';
        if (!answer.trace) return;
        const bool witness = verdict.outcome == Outcome::Holds;
        if (witness && !options_.verbose) return;
        print_told(witness ? "witness" : "counterexample", *answer.trace, end_of(verdict));
    }

    void print_shared_reason() {
        std::string names;
        for (const Answer& answer : report_.answers)
            if (answer.verdict.outcome == Outcome::Unknown && answer.verdict.reason == shared_reason_)
                names += (names.empty() ? "" : ", ") + answer.verdict.property;
        out_ << "why unknown (" << names << "): " << printable(shared_reason_) << '\n';
    }

    /// `end`: said of a trace that does not repeat.
    void print_told(std::string_view what, const ChartRun& run, std::string_view end) {
        out_ << '\n' << what << ":\n";
        print_trace(run, out_);
        if (!run.loop_from && !end.empty()) out_ << "    " << end << '\n';
        out_ << '\n';
    }

    void print(const Breakdown& breakdown) {
        out_ << painted("the model breaks off", 31) << ": " << printable(breakdown.message) << " [" << breakdown.code
             << "]\n";
        if (!breakdown.trace.steps.empty()) print_told("the way there", breakdown.trace, "");
    }

    void print_tally() {
        const Tally count = tally(report_);
        std::string line;
        const auto add = [&line](std::size_t number, std::string_view one, std::string_view many) {
            if (number != 0) line += fmt::format("{}{} {}", line.empty() ? "" : ", ", number, number == 1 ? one : many);
        };
        add(count.holds, "holds", "hold");
        add(count.violated, "violated", "violated");
        add(count.unknown + count.undeclared_unknown, "unknown", "unknown");
        add(report_.breakdowns.size(), "place where the model breaks off", "places where the model breaks off");
        out_ << report_.model << ": " << (line.empty() ? "no properties" : line);
        if (count.unexpected != 0) out_ << "; " << count.unexpected << " against expectation";
        if (options_.verbose && !report_.answers.empty())
            out_ << fmt::format(" ({:.3f} s)", report_.answers.back().verdict.seconds);
        out_ << '\n';
    }

    const Report& report_;
    const TextOptions& options_;
    std::ostream& out_;
    std::string shared_reason_ = {};
};

/// `a, b, c and 46 more`
std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 3;
    std::string words;
    for (std::size_t i = 0; i < std::min(shown, names.size()); ++i)
        words += fmt::format("{}`{}`", i == 0 ? "" : ", ", names[i]);
    return names.size() <= shown ? words : fmt::format("{} and {} more", words, names.size() - shown);
}

/// What a verdict on sub-loops leaves out, and why it may.
std::string scope_words(const Scope& scope) {
    if (scope.searched.empty()) return {};
    const bool one = scope.searched.size() == 1;
    const std::string what = fmt::format("; sub-loop{} {}", one ? "" : "s", some_of(scope.searched));
    if (scope.left_out.empty()) return what + ", each by itself";
    const std::string rest = fmt::format("{} alone; left out: {}", what, some_of(scope.left_out));
    if (scope.because.empty()) return rest;
    return fmt::format("{}, {} {}", rest, scope.left_out.size() == 1 ? "which" : "each of which", scope.because);
}

}  // namespace

std::string basis_words(const Report& report, const Answer& answer) {
    const Basis& basis = report.basis;
    const Verdict& verdict = answer.verdict;
    const std::string states = verdict.states.empty() ? "" : "; " + verdict.states + " states";
    if (!basis.untimed.empty()) {
        const std::string grain = basis.grain.empty() ? "" : ", " + basis.grain + " grain";
        return fmt::format("{}, untimed: {}; {}{}{}{}", basis.engine, basis.untimed, basis.mode, grain, states,
                           answer.carries.empty() ? "" : "; " + answer.carries);
    }
    return fmt::format("{} engine; {}, {} grain; time unit {}, cycle time taken as zero{}{}", basis.engine, basis.mode,
                       basis.grain, seconds_text(basis.time_unit_ms), states, scope_words(verdict.scope));
}

std::string_view end_of(const Verdict& verdict) {
    if (verdict.outcome == Outcome::Holds) return {};
    if (verdict.pattern == Pattern::NoTimelock) return "from here on time cannot pass";
    if (verdict.pattern == Pattern::NoDeadlock && !verdict.scope.left_out.empty())
        return "from here on nothing of the sub-loop can happen, but time may pass";
    if (verdict.pattern == Pattern::NoDeadlock) return "from here on nothing can happen, but time may pass";
    const bool liveness = verdict.pattern == Pattern::Inevitable || verdict.pattern == Pattern::LeadsTo;
    return liveness ? "from here on nothing can happen" : "";
}

void print_report(const Report& report, const TextOptions& options, std::ostream& out) {
    Printer(report, options, out).print();
}

}  // namespace grafverif
