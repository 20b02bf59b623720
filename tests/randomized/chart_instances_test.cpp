// SPDX-License-Identifier: MIT
// Randomized tests of chart instances: a random loop is written once with instances of a random chart, and once with a
// separate chart for each instance. The two loops have the same network except for the names, and
// the same verdicts and runs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "check/timed/timed.hpp"
#include "support/print_network.hpp"
#include "support/random_chart.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

enum class As { Controllers, PartialCharts };

/// Writes a random loop with instances, or with a separate chart for each instance, from the same
/// random choices.
class InstanceWriter {
public:
    InstanceWriter(Random random, As as, bool instances) : random_(random), as_(as), instances_(instances) {}

    std::string loop() {
        for (int& each : choices_) each = pick(0, 99);
        count_ = pick(1, 2);
        const int width = pick(1, 2);
        std::vector<Values> values;
        for (int i = 1; i <= count_; ++i)
            values.push_back({i, pick(0, 1) == 0 ? 0 : pick(1, 3), pick(0, 1) == 0 ? 0 : pick(1, 2), width});
        text_ =
            "component level(output OUT: int 0..3) {\n    initial location low;\n    location high;\n"
            "    timed low -> high do OUT := 3;\n    timed high -> low do OUT := 1;\n}\n";
        if (instances_) {
            line("grafcet h(input A; output Q; T = 1s, LIMIT: int 1..2 = 2, WIDTH: int 1..3 = 1; input C: int 0..3) {");
            body({});
            line("}");
        }
        if (as_ == As::PartialCharts) plc(values);
        else if (!instances_)
            for (const Values& each : values) {
                line("grafcet " + of("H", each) + " {\ninput " + of("A", each) + ", " + of("C", each) +
                     ": int 0..3; output " + of("Q", each) + ";\n");
                body(each);
                line("}");
            }
        closed_loop(values);
        return std::move(text_);
    }

private:
    /// The number of an instance, which is 0 in the template, and its constants; 0 selects the declared value.
    struct Values {
        int number = 0, seconds = 0, limit = 0, width = 1;
    };

    int pick(int low, int high) { return static_cast<int>(random_number(random_, low, high)); }
    void line(const std::string& text) { text_ += text + "\n"; }
    std::string of(const std::string& name, const Values& values) const {
        if (values.number == 0) return name;
        return instances_ ? fmt::format("{}[{}]", name, values.number) : fmt::format("{}_{}_", name, values.number);
    }
    /// Returns the name of an element that an instance declares.
    std::string own(const std::string& name, const Values& values) const {
        return values.number == 0 || as_ == As::Controllers ? name : of("H", values) + name;
    }
    std::string limit(const Values& values) const {
        return values.number == 0 ? "LIMIT" : std::to_string(values.limit == 0 ? 2 : values.limit);
    }

    void body(const Values& values) {
        line("internal " + own("N", values) + ": int 0.." + limit(values) + ";");
        parts(values);
    }

    void parts(const Values& values) {
        const std::string a = of("A", values), q = of("Q", values), c = of("C", values), n = own("N", values);
        const std::string time =
            values.number == 0 ? "T" : fmt::format("{}s", values.seconds == 0 ? 1 : values.seconds);
        const std::string inverted = choices_[0] % 2 == 0 ? "!" : "", edge = choices_[1] % 3 == 0 ? "rise " : "";
        line("initial step 0 " + (choices_[2] % 2 == 0 ? "{ " + q + " if " + c + " > 2; }" : std::string(";")));
        if (choices_[3] % 3 == 0) line("step 1 { " + q + " after " + time + "; }");
        else if (choices_[3] % 3 == 1) line("step 1 { " + q + " if " + inverted + a + "; }");
        else line("step 1 { " + q + "; }");
        const std::string condition = edge.empty() ? inverted + a : "rise (" + a + ")";
        line("transition " + own("t0", values) + ": 0 -> 1 when " + condition + " && " + n + " < " + limit(values) +
             " do " + n + " := " + n + " + 1;");
        const std::string back = choices_[4] % 2 == 0 ? time + "/X1" : "X1 && " + c + " <= " + limit(values);
        line("transition " + own("t1", values) + ": 1 -> 0 when " + back + ";");
        if (values.number == 0) {
            line("for k in 1..WIDTH {\nstep s[k];\ntransition 0 -> s[k] when A && C > k;");
            line("transition s[k] -> 0 when !A;\n}");
            return;
        }
        for (int k = 1; k <= values.width; ++k) {
            line(fmt::format("step s_{}_;\ntransition 0 -> s_{}_ when {} && {} > {};", k, k, a, c, k));
            line(fmt::format("transition s_{}_ -> 0 when !{};", k, a));
        }
    }

    std::string arguments(const Values& values) const {
        std::string text = fmt::format("(C = {}, Q = {}, A = {}", of("C", values), of("Q", values), of("A", values));
        if (values.seconds > 0) text += fmt::format(", T = {} * 500ms", 2 * values.seconds);
        if (values.limit > 0) text += fmt::format(", LIMIT = {}", values.limit);
        return text + (values.width > 1 ? ", WIDTH = 3 - 1);" : ");");
    }

    void plc(const std::vector<Values>& values) {
        line("grafcet plc {");
        for (const Values& each : values)
            line("input " + of("A", each) + ", " + of("C", each) + ": int 0..3; output " + of("Q", each) + ";");
        line("partial mode {\ninitial step 0;\nstep 1;\ntransition 0 -> 1 when " + of("H", values[0]) +
             ".X1;\ntransition 1 -> 0 when " + of("H", values[0]) + ".X0;\n}");
        for (const Values& each : values) {
            if (instances_) {
                line("partial " + of("H", each) + " = h" + arguments(each));
                continue;
            }
            line("internal " + own("N", each) + ": int 0.." + limit(each) + ";");
            line("partial " + of("H", each) + " {");
            parts(each);
            line("}");
        }
        line("}");
    }

    void closed_loop(const std::vector<Values>& values) {
        line("closed_loop l {\ngrain atomic;");
        if (as_ == As::PartialCharts) line("controller plc;");
        for (const Values& each : values) {
            const std::string number = std::to_string(each.number);
            if (as_ == As::Controllers && instances_) line("controller " + of("H", each) + " = h" + arguments(each));
            if (as_ == As::Controllers && !instances_) line("controller " + of("H", each) + ";");
            line("environment a" + number + " = free(OUT = " + of("A", each) + ");");
            line("plant c" + number + " = level(OUT = " + of("C", each) + ");");
            line("property p" + number + ": never " + of("H", each) + ".X1 && " + of("Q", each) + ";");
            line("property q" + number + ": " + of("A", each) + " leads to " + of("H", each) + ".X1;");
        }
        line("property r: reachable all steps;\n}");
    }

    Random random_;
    As as_;
    bool instances_;
    int count_ = 1;
    int choices_[5] = {};
    std::string text_ = {};
};

std::string normalized(std::string text, As as) {
    if (as == As::PartialCharts) text = std::regex_replace(text, std::regex(R"((H\[\d\])\.(N|t\d)\b)"), "$1$2");
    return std::regex_replace(text, std::regex(R"(\[(\d+)\])"), "_$1_");
}

TEST(ChartInstances, EqualChartsThatAreWrittenByHand) {
    const int runs = test_size(60);
    int violated = 0;
    for (int seed = 0; seed < runs; ++seed) {
        const As as = seed % 2 == 0 ? As::Controllers : As::PartialCharts;
        const Random random(static_cast<unsigned>(seed));
        const std::string text = InstanceWriter(random, as, true).loop(),
                          by_hand = InstanceWriter(random, as, false).loop();
        SCOPED_TRACE(fmt::format("seed {}\n{}\n{}", seed, text, by_hand));
        const Network instances = read_loop(text).network, written = read_loop(by_hand).network;
        ASSERT_EQ(normalized(network_text(instances), as), network_text(written));
        TimedOptions options;
        options.max_states = 20'000;
        const TimedResult one = check_timed(instances, options), other = check_timed(written, options);
        ASSERT_EQ(one.verdicts.size(), other.verdicts.size());
        ASSERT_EQ(one.states, other.states);
        for (std::size_t i = 0; i < one.verdicts.size(); ++i) {
            ASSERT_EQ(normalized(one.verdicts[i].property, as), other.verdicts[i].property);
            ASSERT_EQ(one.verdicts[i].outcome, other.verdicts[i].outcome);
            ASSERT_EQ(one.verdicts[i].run.has_value(), other.verdicts[i].run.has_value());
            violated += one.verdicts[i].run ? 1 : 0;
        }
    }
    EXPECT_GT(violated, runs / 2);
}

}  // namespace
}  // namespace grafverif
