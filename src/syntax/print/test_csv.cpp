// SPDX-License-Identifier: MIT
#include "syntax/print/test_csv.hpp"

#include <ostream>
#include <string_view>

#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// Prints a field according to RFC 4180. A field that contains a comma, a quote or a line end is printed in quotes.
void print_field(std::ostream& out, std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        out << text;
        return;
    }
    out << '"';
    for (const char c : text) out << (c == '"' ? "\"\"" : std::string_view(&c, 1));
    out << '"';
}

void print_row(std::ostream& out, const TestSequence& test, std::size_t sequence, std::size_t number,
               const TestSequence::Step& step) {
    out << sequence << ',' << number << ',' << (step.wait_ms == 0 ? "" : duration_text(step.wait_ms)) << ','
        << step.cycles;
    for (const std::int64_t value : step.inputs) out << ',' << value;
    for (const std::int64_t value : step.outputs) out << ',' << value;
    out << ',';
    print_field(out, test.situations[step.situation].text);
    out << '\n';
}

}  // namespace

void print_test_csv(std::ostream& out, const TestSequence& test) {
    out << "sequence,step,wait,cycles";
    for (const TestSequence::Variable& input : test.inputs) out << ',' << input.name;
    for (const TestSequence::Variable& output : test.outputs) out << ',' << output.name;
    out << ",situation\n";
    for (std::size_t k = 0; k < test.sequences.size(); ++k) {
        const TestSequence::Sequence& sequence = test.sequences[k];
        if (sequence.activation) print_row(out, test, k + 1, 0, *sequence.activation);
        for (std::size_t i = 0; i < sequence.steps.size(); ++i) print_row(out, test, k + 1, i + 1, sequence.steps[i]);
    }
}

}  // namespace grafverif
