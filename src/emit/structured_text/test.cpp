// SPDX-License-Identifier: MIT
// Writes a TestSequence as a test program. Each call is one scan of the controller under test.
//
// Each row of the test is one branch of a CASE statement, with inputs, expected outputs, number of scans and waiting
// time. During a wait, the controller is not called: its timers continue, and the elapsed time is visible at the next
// scan. A timer of the controller starts earlier than the timer of the wait; therefore, if its duration is at most the
// waiting time, the timer has expired when the wait ends. Each sequence uses a separate instance of the controller, so
// that it starts at power-on.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "emit/controller/names.hpp"
#include "emit/structured_text/body.hpp"
#include "emit/structured_text/structured_text.hpp"
#include "emit/structured_text/unit.hpp"
#include "support/printable.hpp"

namespace grafverif::structured_text {

namespace {

using Step = TestSequence::Step;

std::string value_text(const TestSequence::Variable& variable, std::int64_t value) {
    if (variable.type.boolean) return value != 0 ? "TRUE" : "FALSE";
    return std::to_string(value);
}

/// Names of the variables of the test program. For example, `E_V1` is the expected value of output V1.
struct TestNames {
    controller::InterfaceNames interface = {};
    std::vector<std::string> inputs = {}, expected = {};
    std::vector<std::string> controllers = {};  ///< names of the controller instances, one per sequence
    std::string program = {}, row = {}, scan = {}, scans = {}, sequence = {}, pause = {}, wait = {}, done = {},
                passed = {}, failed_row = {}, failures = {}, wrong = {};
};

TestNames test_names(const TestSequence& test) {
    TestNames names;
    std::vector<std::string> inputs, outputs, preferred_names;
    for (const TestSequence::Variable& input : test.inputs) inputs.push_back(input.name);
    for (const TestSequence::Variable& output : test.outputs) outputs.push_back(output.name);
    names.interface = controller::interface_names(test.chart, inputs, outputs, Target::StructuredText);
    for (const std::string& input : inputs) preferred_names.push_back("I_" + input);
    for (const std::string& output : outputs) preferred_names.push_back("E_" + output);
    for (std::size_t k = 0; k < test.sequences.size(); ++k)
        preferred_names.push_back(fmt::format("controller_{}", k + 1));
    std::string* const own[] = {&names.program,  &names.row,        &names.scan,     &names.scans,
                                &names.sequence, &names.pause,      &names.wait,     &names.done,
                                &names.passed,   &names.failed_row, &names.failures, &names.wrong};
    for (const char* preferred : {"test", "row", "scan", "scans", "sequence", "pause", "wait", "done", "passed",
                                  "failed_row", "failures", "wrong"})
        preferred_names.push_back(*preferred == 't' ? "test_" + test.chart : std::string(preferred));
    std::vector<std::string> made = legal_names(Target::StructuredText, preferred_names, {names.interface.block});
    auto next = made.begin();
    for (std::size_t k = 0; k < inputs.size(); ++k) names.inputs.push_back(*next++);
    for (std::size_t k = 0; k < outputs.size(); ++k) names.expected.push_back(*next++);
    for (std::size_t k = 0; k < test.sequences.size(); ++k) names.controllers.push_back(*next++);
    for (std::string* place : own) *place = *next++;
    return names;
}

class TestWriter {
public:
    explicit TestWriter(const TestSequence& test) : test_(test), names_(test_names(test)) {}

    Unit unit() {
        rows();
        wait();
        scan();
        write_check();
        Unit unit{true, names_.program, comment(), {}, {}};
        unit.variables = variables();
        unit.body = std::move(text_);
        return unit;
    }

private:
    template <class... Arguments>
    void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), text, std::forward<Arguments>(arguments)...);
        text_ += '\n';
    }

    void rows() {
        line("IF {} THEN RETURN; END_IF;", names_.done);
        line("CASE {} OF", names_.row);
        for (std::size_t k = 0; k < test_.sequences.size(); ++k) {
            const TestSequence::Sequence& sequence = test_.sequences[k];
            if (sequence.activation) row(k, 0, *sequence.activation);
            for (std::size_t i = 0; i < sequence.steps.size(); ++i) row(k, i + 1, sequence.steps[i]);
        }
        line("ELSE {} := TRUE; {} := {} = 0; RETURN;", names_.done, names_.passed, names_.failures);
        line("END_CASE;");
    }

    void row(std::size_t sequence, std::size_t number, const Step& step) {
        ++count_;
        std::string text = fmt::format("{}:", count_);
        if (test_.sequences.size() > 1) text += fmt::format(" {} := {};", names_.sequence, sequence + 1);
        text += fmt::format(" {} := {};", names_.scans, step.cycles);
        if (waits_) text += fmt::format(" {} := {};", names_.pause, time_literal(step.wait_ms));
        for (std::size_t k = 0; k < test_.inputs.size(); ++k)
            text += fmt::format(" {} := {};", names_.inputs[k], value_text(test_.inputs[k], step.inputs[k]));
        for (std::size_t k = 0; k < test_.outputs.size(); ++k)
            text += fmt::format(" {} := {};", names_.expected[k], value_text(test_.outputs[k], step.outputs[k]));
        const std::string situation = comment_text(printable(test_.situations[step.situation].text));
        line("(* {}step {}{}{} *)", test_.sequences.size() > 1 ? fmt::format("sequence {}, ", sequence + 1) : "",
             number, situation.empty() ? "" : ": ", situation);
        line("{}", text);
    }

    void wait() {
        if (!waits_) return;
        line("IF {} = 0 AND {} > T#0s THEN", names_.scan, names_.pause);
        line("    {}(IN := TRUE, PT := {});", names_.wait, names_.pause);
        line("    IF NOT {}.Q THEN RETURN; END_IF;", names_.wait);
        line("    {}(IN := FALSE);", names_.wait);
        line("END_IF;");
    }

    void scan() {
        if (test_.sequences.size() == 1) return call(0, "");
        line("CASE {} OF", names_.sequence);
        for (std::size_t k = 0; k < test_.sequences.size(); ++k) call(k, fmt::format("{}: ", k + 1));
        line("END_CASE;");
    }

    /// Prints one scan and the comparison of the outputs after the scan.
    void call(std::size_t sequence, const std::string& label) {
        const std::string& controller = names_.controllers[sequence];
        std::string arguments, wrong;
        for (std::size_t k = 0; k < test_.inputs.size(); ++k)
            arguments += fmt::format("{}{} := {}", k == 0 ? "" : ", ", names_.interface.variables[k], names_.inputs[k]);
        for (std::size_t k = 0; k < test_.outputs.size(); ++k)
            wrong += fmt::format("{}({}.{} <> {})", k == 0 ? "" : " OR ", controller,
                                 names_.interface.variables[test_.inputs.size() + k], names_.expected[k]);
        line("{}{}({});", label, controller, arguments);
        line("{} := {};", names_.wrong, wrong.empty() ? "FALSE" : wrong);
    }

    void write_check() {
        line("IF {} THEN", names_.wrong);
        line("    IF {} = 0 THEN {} := {}; END_IF;", names_.failures, names_.failed_row, names_.row);
        line("    {} := {} + 1;", names_.failures, names_.failures);
        line("END_IF;");
        line("{} := {} + 1;", names_.scan, names_.scan);
        line("IF {} >= {} THEN", names_.scan, names_.scans);
        line("    {} := 0;", names_.scan);
        line("    {} := {} + 1;", names_.row, names_.row);
        line("END_IF;");
    }

    std::string comment() const {
        return fmt::format(
            "{}: conformance test of the function block {}, written by grafverif\n"
            "Call it in every cycle of a task until {} is TRUE. {} is TRUE if no output was wrong in any of the {} "
            "rows.\n"
            "{} is the first row with a wrong output, and {} is the number of scans with a wrong output.\n",
            test_.chart, names_.interface.block, names_.done, names_.passed, count_, names_.failed_row,
            names_.failures);
    }

    std::vector<UnitVariable> variables() const {
        std::vector<UnitVariable> made = {
            {Section::Output, names_.done, "BOOL", false, "FALSE", "the test is complete"},
            {Section::Output, names_.passed, "BOOL", false, "FALSE",
             "the test is complete, and the controller conforms"},
            {Section::Output, names_.failures, "UDINT", false, "0", "scans with a wrong output"},
            {Section::Output, names_.failed_row, "UDINT", false, "0", "the first row with a wrong output"},
            {Section::Output, names_.row, "UDINT", false, "1", "the current row"},
            {Section::Local, names_.scan, "UDINT", false, "0", "number of completed scans in this row"},
            {Section::Local, names_.scans, "UDINT", false, "1", "number of scans to execute in this row"},
            {Section::Local, names_.wrong, "BOOL", false, "FALSE", "an output is wrong"},
        };
        if (test_.sequences.size() > 1)
            made.push_back({Section::Local, names_.sequence, "UDINT", false, "1", "the current sequence"});
        if (waits_) {
            made.push_back({Section::Local, names_.pause, "TIME", false, "T#0s", "time to wait before the row"});
            made.push_back({Section::Local, names_.wait, "TON", true, "", ""});
        }
        for (const std::string& controller : names_.controllers)
            made.push_back({Section::Local, controller, names_.interface.block, true, "", "the controller under test"});
        const auto declare = [&](const std::vector<TestSequence::Variable>& variables,
                                 const std::vector<std::string>& names) {
            for (std::size_t k = 0; k < variables.size(); ++k)
                made.push_back({Section::Local, names[k], variables[k].type.boolean ? "BOOL" : "DINT", false, "", ""});
        };
        declare(test_.inputs, names_.inputs);
        declare(test_.outputs, names_.expected);
        return made;
    }

    const TestSequence& test_;
    TestNames names_;
    std::string text_ = {};
    std::size_t count_ = 0;
    bool waits_ = std::ranges::any_of(test_.sequences, [](const TestSequence::Sequence& sequence) {
        return std::ranges::any_of(sequence.steps, [](const Step& step) { return step.wait_ms != 0; });
    });
};

}  // namespace

void emit_test(const TestSequence& test, Form form, std::ostream& out) {
    print(TestWriter(test).unit(), form, row_of(Dialect::Iec), out);
}

}  // namespace grafverif::structured_text
