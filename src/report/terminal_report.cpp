// SPDX-License-Identifier: MIT
// Prints verdicts as text: the settings of the check, the failures with their notes and traces, and a table of all
// verdicts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "ir/patterns.hpp"
#include "report/profile.hpp"
#include "report/settings_text.hpp"
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

bool fails(const PropertyResult& answer) {
    const Verdict& verdict = answer.verdict;
    return verdict.outcome == Outcome::Unknown ? verdict.declared : !as_expected(verdict);
}

/// Returns the remark on a property for which `Verdict::declared` is false: the model does not declare the property, or
/// the command does not select it.
const char* undeclared(const Verdict& verdict) { return verdict.about.valid() ? " (not selected)" : " (not declared)"; }

using Answers = std::vector<const PropertyResult*>;

/// The text of a reason or note, and the results of the properties that have this text.
struct Shared {
    std::string text = {};
    Answers answers = {};
};
class SharedTexts {
public:
    void add(const std::string& text, const PropertyResult& answer) {
        const auto [place, fresh] = index_.try_emplace(text, all_.size());
        if (fresh) all_.push_back({text, {}});
        all_[place->second].answers.push_back(&answer);
    }
    const std::vector<Shared>& all() const { return all_; }
    /// Returns the element of `all()` with the text `text`. Requires that the text has been added.
    const Shared& operator[](const std::string& text) const { return all_[index_.at(text)]; }

private:
    std::vector<Shared> all_ = {};
    std::map<std::string, std::size_t> index_ = {};
};

/// Returns `text` in lines of at most 100 columns. All lines except the first are indented.
std::string folded(const std::string& text, std::size_t indentation) {
    std::string lines;
    for (const std::string& line : wrapped(text, widest_line, widest_line - indentation))
        lines += std::string(lines.empty() ? 0 : indentation, ' ') + printable(line) + '\n';
    return lines;
}

/// A row of the table of verdicts at the end of the output.
struct Row {
    std::string property = {}, verdict = {}, place = {}, text = {};
    int colour = 0;  ///< colour of the verdict
};

class Printer {
public:
    Printer(const Report& report, const TextOptions& options, std::ostream& out)
        : report_(report), options_(options), out_(out), families_(family_sizes(report)) {}

    void print() {
        for (const PropertyResult& answer : report_.answers) {
            if (options_.failures_only && !fails(answer)) continue;
            shown_.push_back(&answer);
            if (is_reason_only(answer)) reasons_.add(answer.verdict.reason, answer);
            for (const std::string& note : answer.verdict.notes) notes_.add(note, answer);
        }
        for (const ModelErrorTrace& breakdown : report_.error_traces) print(breakdown);
        if (!shown_.empty()) print_basis();
        print_in_full();
        if (options_.failures_only) return;
        if (report_.profile) print_profile(*report_.profile, out_ << '\n');
        print_table();
        print_tally();
    }

private:
    /// Returns `text` in the colour that represents its meaning.
    std::string painted(std::string_view text, int colour) const {
        if (options_.colour == Colour::Plain) return std::string(text);
        return fmt::format("\033[1;{}m{}\033[0m", colour, text);
    }

    static constexpr int red = 31, green = 32, yellow = 33;

    static int colour_of(const Verdict& verdict) {
        if (verdict.outcome == Outcome::Unknown) return yellow;
        return as_expected(verdict) ? green : red;
    }

    static std::string outcome(const Verdict& verdict) {
        std::string text(word(verdict.outcome));
        if (verdict.vacuous) text += ", vacuously";
        if (verdict.outcome != Outcome::Unknown && verdict.expected_violated)
            text += as_expected(verdict) ? ", as expected" : ", but expected to be violated";
        return text;
    }

    /// True if the table of verdicts contains all information about the property: it holds as expected.
    static bool in_table_only(const PropertyResult& answer) {
        return answer.verdict.outcome == Outcome::Holds && as_expected(answer.verdict);
    }

    /// True if the property is undecided and its reason is the only information about it.
    static bool is_reason_only(const PropertyResult& answer) {
        const Verdict& verdict = answer.verdict;
        return verdict.outcome == Outcome::Unknown && !verdict.reason.empty() && !answer.trace && verdict.notes.empty();
    }

    /// True if the note is printed before the verdicts, because the note belongs to a property that holds as expected,
    /// or to several properties. Any other note is printed after the verdict of its property.
    bool is_reported_above(const Shared& note) const {
        return note.answers.size() > 1 || in_table_only(*note.answers.front());
    }

    void print_basis() {
        const SharedSettings settings = shared_settings(report_, shown_);
        out_ << report_.model << ", checked with: " << printable(settings.shared) << '\n';
        for (const SharedSettings::Group& group : settings.groups)
            out_ << folded(fmt::format("    {}: {}", names_of(families_, group.answers), group.words), 8);
        for (const Shared& note : notes_.all()) {
            if (!is_reported_above(note)) continue;
            const bool all = note.answers.size() == shown_.size();
            out_ << folded(
                fmt::format("    note{}: {}", all ? "" : " (" + names_of(families_, note.answers) + ")", note.text), 8);
        }
    }

    /// Prints the violated and undecided properties, in the order of the model. Undecided properties with the same
    /// reason are printed together.
    void print_in_full() {
        bool alone = false;
        for (const PropertyResult* answer : shown_) {
            const std::string text = in_full(*answer);
            const bool lone_line = std::ranges::count(text, '\n') == 1;
            if (!text.empty()) out_ << (alone && lone_line ? "" : "\n") << text;
            if (!text.empty()) alone = lone_line;
        }
    }

    static std::string name_in_full(const PropertyResult& answer) {
        return printable(answer.place) + (answer.place.empty() ? "" : ": ") + answer.verdict.property +
               (answer.text.empty() ? "" : " \"" + printable(answer.text) + '"') +
               (answer.verdict.declared ? "" : undeclared(answer.verdict));
    }

    std::string in_full(const PropertyResult& answer) const {
        const Verdict& verdict = answer.verdict;
        const bool witness = verdict.outcome == Outcome::Holds && answer.trace && options_.verbose;
        if (in_table_only(answer) && !witness) return {};
        const Shared* const reason = is_reason_only(answer) ? &reasons_[verdict.reason] : nullptr;
        const bool together = reason != nullptr && reason->answers.size() > 1;
        if (together && reason->answers.front() != &answer) return {};
        std::ostringstream out;
        const std::string outcome_text = outcome(verdict);
        std::string head = together ? folded(names_of(families_, reason->answers) + ": " + outcome_text, 4)
                                    : name_in_full(answer) + ": " + outcome_text + '\n';
        head.replace(head.size() - outcome_text.size() - 1, outcome_text.size(),
                     painted(outcome_text, colour_of(verdict)));
        out << head;
        if (!verdict.reason.empty()) out << "    why: " << printable(verdict.reason) << '\n';
        for (const std::string& note : verdict.notes)
            if (!is_reported_above(notes_[note])) out << "    note: " << printable(note) << '\n';
        if (witness) print_reported("witness", *answer.trace, end_of(verdict), out);
        if (answer.trace && verdict.outcome != Outcome::Holds)
            print_reported("counterexample", *answer.trace, end_of(verdict), out);
        return std::move(out).str();
    }

    /// Prints a trace. If the last events of the trace do not repeat forever, the text `end` is printed after the
    /// trace.
    static void print_reported(std::string_view what, const ChartRun& run, std::string_view end, std::ostream& out) {
        out << what << ":\n";
        print_trace(run, out);
        if (!run.loop_from && !end.empty()) out << "    " << end << '\n';
    }

    void print(const ModelErrorTrace& breakdown) {
        out_ << painted("model error", red) << ": " << printable(breakdown.message) << " [" << breakdown.code << "]\n";
        if (!breakdown.trace.steps.empty()) print_reported("trace", breakdown.trace, "", out_);
        out_ << '\n';
    }

    /// Returns the rows of the table. All steps that a property `reachable all steps` reaches share one row.
    std::vector<Row> rows() const {
        std::vector<Row> rows;
        std::set<std::string> families;
        FamilySizes holding;
        for (const PropertyResult& answer : report_.answers)
            if (outcome(answer.verdict) == word(Outcome::Holds)) ++holding[family_of(answer)];
        for (const PropertyResult& answer : report_.answers) {
            const Verdict& verdict = answer.verdict;
            const std::string family = family_of(answer), outcome_text = outcome(verdict);
            Row row{verdict.property, outcome_text, answer.place, answer.text, colour_of(verdict)};
            if (!verdict.declared) row.property += undeclared(verdict);
            if (!family.empty() && outcome_text == word(Outcome::Holds)) {
                if (!families.insert(family).second) continue;
                row.property = steps_that_hold(answer, holding);
            }
            rows.push_back(std::move(row));
        }
        return rows;
    }

    /// Returns text such as `S (9 of 11 steps)`. If the property has a verdict on only one step, returns the name of
    /// this verdict.
    std::string steps_that_hold(const PropertyResult& first, const FamilySizes& families_that_hold) const {
        const std::string family = family_of(first);
        const std::size_t holding = families_that_hold.at(family), all = families_.at(family);
        if (all == 1) return first.verdict.property;
        return fmt::format("{} ({}{} steps)", family, holding == all ? "" : fmt::format("{} of ", holding), all);
    }

    void print_table() {
        std::vector<Row> all = rows();
        if (all.empty()) return;
        all.insert(all.begin(), {"property", "verdict", "location", "description"});
        constexpr std::array columns = {&Row::property, &Row::verdict, &Row::place, &Row::text};
        std::array<std::size_t, columns.size()> widths = {};  // width of each column; 0 if the column is empty
        for (std::size_t k = 0; k < columns.size(); ++k)
            for (Row& row : all) {
                std::string& cell = row.*columns[k] = printable(row.*columns[k]);
                if (&row != &all.front() && !cell.empty())
                    widths[k] = std::max({widths[k], columns_of(cell), columns_of(all[0].*columns[k])});
            }
        const std::size_t used = 2 * 3 + widths[0] + widths[1] + widths[2];
        constexpr std::size_t least_of_text = 20;
        if (options_.columns != 0) {
            const std::size_t available = options_.columns > used ? options_.columns - used : 0;
            widths[3] = available < least_of_text ? 0 : std::min(widths[3], available);
        }
        out_ << '\n';
        for (const Row& row : all) {
            std::string line, blanks;
            for (std::size_t k = 0; k < columns.size(); ++k) {
                if (widths[k] == 0) continue;
                const std::string cell = cut_to(row.*columns[k], widths[k]);
                if (!cell.empty())
                    line += std::exchange(blanks, "") + (k == 1 && row.colour != 0 ? painted(cell, row.colour) : cell);
                blanks += std::string(widths[k] + 2 - columns_of(cell), ' ');
            }
            out_ << line << '\n';
        }
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
        add(report_.error_traces.size(), "model error", "model errors");
        out_ << report_.model << ": " << (line.empty() ? "no properties" : line);
        if (count.unexpected != 0) out_ << "; " << count.unexpected << " unexpected";
        if (options_.verbose && !report_.answers.empty())
            out_ << fmt::format(" ({:.3f} s)", report_.answers.back().verdict.seconds);
        out_ << '\n';
    }

    const Report& report_;
    const TextOptions& options_;
    std::ostream& out_;
    FamilySizes families_;
    Answers shown_ = {};
    SharedTexts reasons_ = {}, notes_ = {};
};

}  // namespace

std::string coloured(std::string_view word, Outcome outcome, Colour colour) {
    if (colour == Colour::Plain) return std::string(word);
    const char* const code = outcome == Outcome::Holds      ? "\x1b[32m"
                             : outcome == Outcome::Violated ? "\x1b[31m"
                                                            : "\x1b[33m";
    return fmt::format("{}{}\x1b[0m", code, word);
}

std::string_view end_of(const Verdict& verdict) {
    if (verdict.outcome == Outcome::Holds) return {};
    if (verdict.pattern == Pattern::NoTimelock) return "from here, time cannot pass";
    if (verdict.pattern == Pattern::NoDeadlock && !verdict.scope.left_out.empty())
        return "from here, no edge of the sub-loop can be taken, but time may pass";
    if (verdict.pattern == Pattern::NoDeadlock) return "from here, no edge can be taken, but time may pass";
    return is_liveness(verdict.pattern) ? "from here, no edge can be taken" : "";
}

void print_report(const Report& report, const TextOptions& options, std::ostream& out) {
    Printer(report, options, out).print();
}

}  // namespace grafverif
