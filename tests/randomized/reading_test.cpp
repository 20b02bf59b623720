// SPDX-License-Identifier: MIT
// Randomized test: a chart that is printed and read back is the same chart, with the same text and the same equations.
// The test skips charts that the language rejects for semantic reasons, for example a step that no sequence of
// transitions reaches.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "derive/derive.hpp"
#include "read/text.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"
#include "syntax/print/equations.hpp"

namespace grafverif {
namespace {

std::string equations_text(const Chart& chart) {
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    std::ostringstream out;
    if (equations) print_equations(out, *equations);
    return out.str();
}

TEST(RandomizedReading, PrintedChartIsReadBackUnchanged) {
    int read = 0;
    std::map<std::string, int> rejected;
    for (int seed = 1; seed <= test_size(500); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = random_chart(random);
        ASSERT_EQ(verify(chart), std::vector<std::string>{}) << "seed " << seed << "\n\n" << chart_text(chart);
        Diagnostics diagnostics;
        Sources sources;
        const Id<Source> file = sources.add({"law.grafcet", chart_text(chart)});
        const auto model = read_text(file, sources, {}, diagnostics);
        if (!model) {
            for (const Diagnostic& diagnostic : diagnostics.all()) ++rejected[diagnostic.code];
            const bool by_meaning = std::ranges::all_of(diagnostics.all(), [](const Diagnostic& diagnostic) {
                return diagnostic.code == "unreachable-step" || diagnostic.code == "no-initial-step" ||
                       diagnostic.severity != Severity::Error;
            });
            std::ostringstream rendered;
            render_text(diagnostics.all(), sources, Colour::Plain, rendered);
            ASSERT_TRUE(by_meaning) << "seed " << seed << '\n' << rendered.str();
            continue;
        }
        ++read;
        const Chart& again = *model->charts.begin();
        ASSERT_EQ(chart_text(again), chart_text(chart)) << "seed " << seed;
        ASSERT_EQ(equations_text(again), equations_text(chart)) << "seed " << seed;
    }
    EXPECT_GT(read, 50) << ::testing::PrintToString(rejected);
}

}  // namespace
}  // namespace grafverif
