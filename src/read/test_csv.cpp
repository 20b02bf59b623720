// SPDX-License-Identifier: MIT
#include "read/test_csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "read/csv.hpp"
#include "support/messages.hpp"
#include "syntax/print/dialect.hpp"
#include "syntax/print/scan_line.hpp"

namespace grafverif {

namespace {

enum class TestWord : std::uint8_t { Sequence, Step, Wait, Cycles, Situation, Input, Output };

struct TestColumn {
    TestWord word = TestWord::Input;
    std::size_t index = 0;  ///< index of the input or output
};

std::optional<TestWord> test_word(std::string_view text) {
    constexpr std::array<std::string_view, 5> words = {"sequence", "step", "wait", "cycles", "situation"};
    const auto found = std::ranges::find(words, text);
    if (found == words.end()) return {};
    return static_cast<TestWord>(found - words.begin());
}

Span row_span(const CsvRow& row) { return {row.front().where.source, row.front().where.begin, row.back().where.end}; }

class TestTable {
public:
    TestTable(TestSequence& test, Diagnostics& diagnostics) : test_(test), diagnostics_(diagnostics) {
        for (const TestSequence::Variable& input : test.inputs) inputs_.push_back({input.name, input.type});
        for (const TestSequence::Variable& output : test.outputs) outputs_.push_back({output.name, output.type});
    }

    void header(const CsvRow& row) {
        const bool is_native = row.size() >= 4 && row[0].text == "sequence" && row[1].text == "step" &&
                               row[2].text == "wait" && row[3].text == "cycles";
        for (std::size_t k = 0; k < row.size(); ++k) {
            const auto word = test_word(row[k].text);
            const bool fixed = is_native && (k < 4 || (k + 1 == row.size() && word == TestWord::Situation));
            const auto variable = fixed ? std::nullopt : variable_column(row[k].text);
            if (!variable && !word) {
                diagnostics_.add(messages::unknown_column(row[k].where, row[k].text, test_.chart));
                continue;
            }
            const TestColumn column = variable ? *variable : TestColumn{*word, 0};
            if (has(column)) diagnostics_.add(messages::repeated_column(row[k].where, row[k].text));
            columns_.push_back(column);
        }
        for (std::size_t k = 0; k < inputs_.size(); ++k)
            if (!has({TestWord::Input, k}))
                diagnostics_.add(messages::missing_column(row_span(row), "input", inputs_[k].name));
        for (std::size_t k = 0; k < outputs_.size(); ++k)
            if (!has({TestWord::Output, k}))
                diagnostics_.add(messages::missing_column(row_span(row), "output", outputs_[k].name));
    }

    void step(const CsvRow& row) {
        if (row.size() != columns_.size()) {
            diagnostics_.add(messages::row_length(row_span(row), row.size(), columns_.size()));
            return;
        }
        TestSequence::Step step;
        step.inputs.resize(inputs_.size());
        step.outputs.resize(outputs_.size());
        std::string sequence, number, situation;
        for (std::size_t k = 0; k < row.size(); ++k) {
            switch (columns_[k].word) {
            case TestWord::Sequence: sequence = row[k].text; break;
            case TestWord::Step: number = row[k].text; break;
            case TestWord::Situation: situation = row[k].text; break;
            case TestWord::Wait: step.wait_ms = wait(row[k]); break;
            case TestWord::Cycles: step.cycles = cycles(row[k]); break;
            case TestWord::Input: step.inputs[columns_[k].index] = value(row[k], inputs_[columns_[k].index]); break;
            case TestWord::Output: step.outputs[columns_[k].index] = value(row[k], outputs_[columns_[k].index]); break;
            }
        }
        step.situation = situation_of(situation);
        if (test_.sequences.empty() || sequence != sequence_) test_.sequences.emplace_back();
        sequence_ = std::move(sequence);
        place(row, std::move(step), number == "0");
    }

private:
    void place(const CsvRow& row, TestSequence::Step step, bool activation) {
        TestSequence::Sequence& sequence = test_.sequences.back();
        if (activation) {
            if (sequence.activation || !sequence.steps.empty() || step.cycles != 1 || step.wait_ms != 0)
                diagnostics_.add(messages::misplaced_activation(row_span(row)));
            sequence.activation = std::move(step);
            return;
        }
        const bool first = sequence.steps.empty();
        if (first && sequence.activation && sequence.activation->inputs != step.inputs)
            diagnostics_.add(messages::misplaced_activation(row_span(row)));
        if (step.wait_ms != 0 && (first || sequence.steps.back().inputs != step.inputs))
            diagnostics_.add(messages::misplaced_wait(row_span(row), first));
        sequence.steps.push_back(std::move(step));
    }

    std::optional<TestColumn> variable_column(std::string_view name) const {
        for (std::size_t k = 0; k < inputs_.size(); ++k)
            if (inputs_[k].name == name) return TestColumn{TestWord::Input, k};
        for (std::size_t k = 0; k < outputs_.size(); ++k)
            if (outputs_[k].name == name) return TestColumn{TestWord::Output, k};
        return {};
    }

    bool has(const TestColumn& wanted) const {
        return std::ranges::any_of(columns_, [&](const TestColumn& column) {
            return column.word == wanted.word && column.index == wanted.index;
        });
    }

    std::int64_t value(const CsvField& field, const ScanColumn& column) {
        const ScanValues read = read_scan_line(field.text, {&column, 1});
        if (read.values) return read.values->front();
        diagnostics_.add(messages::bad_field(field.where, read.problem));
        return 0;
    }

    std::int64_t wait(const CsvField& field) {
        if (field.text.empty()) return 0;
        const auto milliseconds = duration_ms(field.text);
        if (!milliseconds)
            diagnostics_.add(messages::bad_field(
                field.where,
                "`" + shown_line(field.text) + "` is not a duration; write it as in `3s`, `250ms` or `2min`"));
        return milliseconds.value_or(0);
    }

    std::uint32_t cycles(const CsvField& field) {
        std::uint32_t count = 0;
        const char* const end = field.text.data() + field.text.size();
        const auto [rest, failure] = std::from_chars(field.text.data(), end, count);
        if (failure == std::errc{} && rest == end && count > 0) return count;
        diagnostics_.add(messages::bad_field(
            field.where,
            "`" + shown_line(field.text) + "` is not a number of cycles; write a whole number above zero"));
        return 1;
    }

    Id<TestSequence::Situation> situation_of(const std::string& text) {
        const auto [found, fresh] = situations_.try_emplace(text);
        if (fresh) found->second = test_.situations.add({text});
        return found->second;
    }

    TestSequence& test_;
    Diagnostics& diagnostics_;
    std::vector<ScanColumn> inputs_ = {}, outputs_ = {};
    std::vector<TestColumn> columns_ = {};
    std::string sequence_ = {};
    std::unordered_map<std::string, Id<TestSequence::Situation>> situations_ = {};
};

/// Returns a test without steps, with the inputs and outputs of `chart` in order of declaration.
TestSequence test_without_steps(const Chart& chart, ExecutionMode mode) {
    TestSequence test;
    test.chart = chart.name;
    test.mode = mode;
    for (const Chart::Variable& variable : chart.variables) {
        if (variable.kind == Chart::VariableKind::Input) test.inputs.push_back({variable.name, variable.type});
        if (variable.kind == Chart::VariableKind::Output) test.outputs.push_back({variable.name, variable.type});
    }
    return test;
}

}  // namespace

std::optional<TestSequence> read_test_csv(Id<Source> file, const Sources& sources, const Chart& chart,
                                          ExecutionMode mode, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    TestSequence test = test_without_steps(chart, mode);
    TestTable reader(test, diagnostics);
    CsvRows rows(file, sources, '\0', diagnostics);
    CsvRow row;
    if (rows.next(row)) reader.header(row);
    if (diagnostics.errors() != errors) return {};
    while (!diagnostics.full() && rows.next(row)) reader.step(row);
    const bool lacking = test.sequences.empty() || std::ranges::any_of(test.sequences, [](const auto& sequence) {
                             return sequence.steps.empty();
                         });
    if (lacking && diagnostics.errors() == errors) diagnostics.add(messages::empty_test(rows.here()));
    if (diagnostics.errors() != errors) return {};
    return test;
}

}  // namespace grafverif
