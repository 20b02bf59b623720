// SPDX-License-Identifier: MIT
// Randomized tests of replication: a random model is written with `for`, indices, `all`, `any` and lists, and without
// them, with names such as `B_1__2_` for `B[1][2]`. Both texts have the same model except for the names.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "pipeline/components.hpp"
#include "read/text.hpp"
#include "support/print_model.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

/// A range `NAME in LOW..HIGH` and the current value of the index variable.
struct Index {
    std::string name = {};
    int low = 0, high = 0, value = 0;
};

/// Writes a random model twice. Every function appends to both texts, and a replication repeats its body in the text
/// without replications. The random choices in the body are repeated by starting from the same random state.
class Writer {
public:
    Writer(Random random, bool replicated) : random_(random), replicated_(replicated) {}

    std::string model() {
        chart();
        loop();
        return std::move(text_);
    }

private:
    int pick(int low, int high) { return static_cast<int>(random_number(random_, low, high)); }
    void line(const std::string& text) { text_ += text + "\n"; }

    /// Returns the text of a value: `i`, `i + 1` or a number.
    std::string value(const Index& index, int offset = 0) const {
        if (!replicated_) return std::to_string(index.value + offset);
        return offset == 0 ? index.name : fmt::format("{} + {}", index.name, offset);
    }
    std::string element(const std::string& name, const std::vector<std::string>& indices) const {
        std::string text = name;
        for (const std::string& index : indices) text += replicated_ ? '[' + index + ']' : '_' + index + '_';
        return text;
    }

    template <class Body>
    void repeat(Index index, const Body& body) {
        if (replicated_) {
            line(fmt::format("for {} in {}..{} {{", index.name, index.low, index.high));
            body(index);
            line("}");
            return;
        }
        const Random start = random_;
        for (index.value = index.low; index.value <= index.high; ++index.value) {
            random_ = start;
            body(index);
        }
    }

    template <class Body>
    std::string junction(Index index, bool all, const Body& body) {
        if (replicated_)
            return fmt::format("{}({} in {}..{}: {})", all ? "all" : "any", index.name, index.low, index.high,
                               body(index));
        const Random start = random_;
        std::string text;
        for (index.value = index.low; index.value <= index.high; ++index.value) {
            random_ = start;
            text += (text.empty() ? "(" : all ? " && (" : " || (") + body(index) + ")";
        }
        return '(' + text + ')';
    }

    template <class Body>
    std::string list(Index index, const Body& body) {
        if (replicated_) return fmt::format("{} for {} in {}..{}", body(index), index.name, index.low, index.high);
        const Random start = random_;
        std::string text;
        for (index.value = index.low; index.value <= index.high; ++index.value) {
            random_ = start;
            text += (text.empty() ? "" : ", ") + body(index);
        }
        return text;
    }

    Index range(const std::string& name) {
        const int low = pick(0, 2);
        return {name, low, low + pick(0, 2)};
    }

    /// Returns a term over the inputs of the chart.
    std::string inputs() {
        const bool all = pick(0, 1) == 0, inverted = pick(0, 1) == 0;
        return junction({"k", rows_.low, rows_.high}, all, [&](const Index& row) {
            return junction({"n", columns_.low, columns_.high}, !all, [&](const Index& column) {
                return std::string(inverted ? "!" : "") + element("B", {value(row), value(column)});
            });
        });
    }

    void chart() {
        rows_ = range("i");
        columns_ = range("j");
        line("grafcet g {");
        repeat(rows_, [&](const Index& row) {
            repeat(columns_, [&](const Index& column) {
                line("input " + element("B", {value(row), value(column)}) + ';');
            });
            line("output " + element("Q", {value(row)}) + ';');
        });
        repeat(rows_, [&](const Index& row) {
            line("partial " + element("p", {value(row)}) + " {");
            line("initial step " + element("s", {value(row, 0)}) + ';');
            line("step 1 { " + element("Q", {value(row)}) + (pick(0, 1) == 0 ? " if " + inputs() : "") + "; }");
            const std::string inverted = pick(0, 1) == 0 ? "!" : "";
            line("transition " + element("up", {value(row)}) + ": " + element("s", {value(row)}) + " -> 1 when " +
                 inverted + inputs() + ';');
            const int column = pick(columns_.low, columns_.high);
            line("transition " + element("down", {value(row)}) + ": 1 -> " + element("s", {value(row)}) + " when " +
                 element("B", {value(row), std::to_string(column)}) + " && 2s/X1;");
            line("}");
        });
        line("}");
    }

    void loop() {
        line("closed_loop l {\ncontroller g;");
        const int first = pick(1, 3);
        line(fmt::format("constant FIRST = {};", first));
        repeat(rows_, [&](const Index& row) {
            line("constant " + element("T", {value(row)}) + fmt::format(" = ({}) * 1s;", value(row, 1)));
            repeat(columns_, [&](const Index& column) {
                line("environment " + element("E", {value(row), value(column, 1)}) + " = push_button_released(OUT = " +
                     element("B", {value(row), value(column)}) + ", HOLD = " + element("T", {value(row)}) + ");");
            });
            line("plant " + element("L", {value(row)}) + " = lamp(ON = " + element("Q", {value(row)}) + " && " +
                 inputs() + ");");
        });
        repeat(rows_, [&](const Index& row) {
            line("property " + element("lit", {value(row)}) + ": " + element("Q", {value(row)}) + " leads to !" +
                 element("L", {value(row)}) + " in lit within " + element("T", {value(row)}) + ';');
        });
        line("property one: exactly one of {" +
             list(rows_, [&](const Index& row) { return element("p", {value(row)}) + ".X1 && " + inputs(); }) + ", X" +
             element("s", {std::to_string(rows_.low)}) + "};");
        line("}");
    }

    Random random_;
    bool replicated_;
    std::string text_ = {};
    Index rows_ = {}, columns_ = {};
};

/// Returns the model of a text as canonical text, or the errors.
std::string resolved(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    ReadContext context;
    context.library = library();
    const auto model = read_text(sources.add({"model.grafcet", text}), sources, context, diagnostics);
    std::ostringstream out;
    render_text(diagnostics.all(), sources, Colour::Plain, out);
    if (!model) return "rejected\n" + out.str() + text;
    print(out, *model);
    return out.str();
}

TEST(Replication, EqualsTheModelThatIsWrittenByHand) {
    const int runs = test_size(200);
    for (int seed = 0; seed < runs; ++seed) {
        SCOPED_TRACE(seed);
        const Random random(static_cast<unsigned>(seed));
        const std::string copies = resolved(Writer(random, true).model());
        const std::string by_hand = resolved(Writer(random, false).model());
        ASSERT_FALSE(copies.starts_with("rejected")) << copies;
        ASSERT_EQ(std::regex_replace(copies, std::regex(R"(\[(\d+)\])"), "_$1_"), by_hand);
    }
}

}  // namespace
}  // namespace grafverif
