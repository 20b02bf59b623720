// SPDX-License-Identifier: MIT
// Randomized test: an imported chart is read back as the same chart, and every command accepts it. Random and mutated
// files are either rejected with an error, or their text is read back as the same model with the same equations.
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>

#include "derive/derive.hpp"
#include "read/formats.hpp"
#include "read/text.hpp"
#include "support/print_model.hpp"
#include "support/test_size.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/print/equations.hpp"
#include "unit/read/fixtures.hpp"
#include "unit/read/random_files.hpp"

namespace grafverif {
namespace {

/// Returns the model as text with its derived equations, or an empty string after an error.
std::string meaning(const Model& model, Diagnostics& diagnostics) {
    std::ostringstream out;
    print(out, model);
    for (const Chart& chart : model.charts)
        if (const auto equations = derive(chart, diagnostics)) print_equations(out, *equations);
    return diagnostics.has_errors() ? "" : std::move(out).str();
}

struct Tally {
    int taken = 0;
    std::map<std::string, int> refused = {};  ///< counts of rejected files by the code of the first error
};

void check_law(const std::string& written, bool lossy, Tally& tally) {
    SCOPED_TRACE(written);
    Sources sources;
    Diagnostics diagnostics;
    const tree::File file = read_any(sources.add({"chart.xml", written}), sources, {lossy}, diagnostics);
    ASSERT_EQ(file.broken, diagnostics.has_errors());
    const auto model = model_of({&file, 1}, false, sources, {}, diagnostics);
    const std::string meant = model ? meaning(*model, diagnostics) : "";
    if (diagnostics.has_errors()) {
        for (const Diagnostic& one : diagnostics.all())
            if (one.severity == Severity::Error) {
                ++tally.refused[one.code];
                return;
            }
    }
    ++tally.taken;
    const std::string text = formatted(laid_out(file));
    SCOPED_TRACE(text);
    Diagnostics again;
    const auto back = read_text(sources.add({"back.grafcet", text}), sources, {}, again);
    std::ostringstream rendered;
    render_text(again.all(), sources, Colour::Plain, rendered);
    ASSERT_TRUE(back) << rendered.str();
    ASSERT_EQ(meaning(*back, again), meant);
    Diagnostics canonical;
    ASSERT_EQ(formatted(parse_file(sources.add({"canonical.grafcet", text}), sources, canonical)), text);
}

std::string tally_text(const Tally& tally) {
    return std::to_string(tally.taken) + " taken, " + ::testing::PrintToString(tally.refused);
}

using Maker = std::string (*)(FileRandom&);

void check_random(Maker make, int count, int least_percent) {
    Tally tally;
    for (int seed = 1; seed <= test_size(count); ++seed) {
        FileRandom random(static_cast<std::uint64_t>(seed));
        std::string text = make(random);
        if (random() % 4 == 0) text = mutated(text, random);
        SCOPED_TRACE(seed);
        check_law(text, seed % 3 == 0, tally);
        if (::testing::Test::HasFatalFailure()) return;
    }
    ::testing::Test::RecordProperty("tally", tally_text(tally));
    EXPECT_GT(tally.taken * 100, test_size(count) * least_percent) << tally_text(tally);
}

TEST(RandomizedImport, RandomGrafcetsOfAgrafeReadBackAsTheSameChart) { check_random(random_agrafe, 150, 10); }
TEST(RandomizedImport, RandomTextualChartsReadBackAsTheSameChart) { check_random(random_sfc, 150, 10); }
TEST(RandomizedImport, RandomChartsOfPlcopenReadBackAsTheSameChart) { check_random(random_plcopen, 150, 10); }

TEST(RandomizedImport, MutatedFilesAreReadBackUnchangedOrRejected) {
    const std::string* const fixtures[] = {&fixtures::agrafe, &fixtures::plcopen, &fixtures::sfc};
    for (const std::string* fixture : fixtures) {
        Tally tally;
        for (int seed = 1; seed <= test_size(100); ++seed) {
            FileRandom random(static_cast<std::uint64_t>(seed));
            SCOPED_TRACE(seed);
            check_law(mutated(*fixture, random), seed % 2 == 0, tally);
            if (::testing::Test::HasFatalFailure()) return;
        }
        EXPECT_GT(tally.taken, test_size(10)) << tally_text(tally);
    }
}

}  // namespace
}  // namespace grafverif
