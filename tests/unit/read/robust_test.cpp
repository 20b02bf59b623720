// SPDX-License-Identifier: MIT
// Tests damaged texts, which are truncated or have changed bytes at any position. The reader never crashes, and a
// rejected text has an error. The printed text of generated charts is read back unchanged.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "read/text.hpp"
#include "support/damage.hpp"
#include "support/print_model.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return std::move(text).str();
}

std::vector<std::string> texts() {
    std::vector<fs::path> paths;
    for (const char* folder : {"samples", "templates", "tests/diagnostics"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(GRAFVERIF_SOURCE_DIR) / folder))
            if (entry.path().extension() == ".grafcet") paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::vector<std::string> found;
    for (const fs::path& path : paths)
        if (std::string text = content(path); text.size() < 20'000) found.push_back(std::move(text));
    return found;
}

/// Reads `text`. Formatting must succeed if the text is valid.
void check(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    const auto model = read_text(sources.add({"damaged.grafcet", text}), sources, {}, diagnostics);
    ASSERT_EQ(model.has_value(), !diagnostics.has_errors()) << text;
    std::ostringstream rendered;
    render_text(diagnostics.all(), sources, Colour::Plain, rendered);  // rendering must accept every location
    if (!model) return;
    ASSERT_EQ(verify(*model), std::vector<std::string>{}) << text;
    Diagnostics none;
    const tree::File file = parse_file(Id<Source>{0}, sources, none);
    const std::string once = formatted(file);
    const tree::File again = parse_file(sources.add({"formatted", once}), sources, none);
    ASSERT_FALSE(again.broken) << text;
    ASSERT_EQ(formatted(again), once);
}

TEST(DamagedText, TruncatedAnywhereIsAcceptedOrRejected) {
    std::mt19937 random(1);
    const std::vector<std::string> all = texts();
    ASSERT_GT(all.size(), 50u);
    for (int i = 0; i < test_size(1500); ++i) {
        const std::string& text = all[random() % all.size()];
        const std::size_t length = random() % (text.size() + 1);
        SCOPED_TRACE(length);
        check(text.substr(0, length));
        check(text.substr(length));
        if (::testing::Test::HasFatalFailure()) return;
    }
}

TEST(DamagedText, WithChangedBytesIsAcceptedOrRejected) {
    std::mt19937 random(2);
    const std::vector<std::string> all = texts();
    const std::string likely = "{}();:,.=<>!&|+-*/%\"'_ \n\t0123456789aXs\\#\x80\xE2\xFF";
    for (int i = 0; i < test_size(2500); ++i) {
        SCOPED_TRACE(i);
        check(damaged(all[random() % all.size()], {likely, 4, 40}, random));
        if (::testing::Test::HasFatalFailure()) return;
    }
}

TEST(PrintModel, PrintsRandomChartsSoThatTheyReadBackAsThemselves) {
    int read = 0;
    for (int seed = 1; seed <= test_size(300); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        std::ostringstream once, twice;
        print(once, random_chart(random));
        Sources sources;
        Diagnostics diagnostics;
        const auto model = read_text(sources.add({"printed.grafcet", once.str()}), sources, {}, diagnostics);
        if (!model) {  // the language rejects some charts for semantic reasons
            for (const Diagnostic& diagnostic : diagnostics.all())
                ASSERT_TRUE(diagnostic.code == "unreachable-step" || diagnostic.code == "no-initial-step")
                    << "seed " << seed << ' ' << diagnostic.code << '\n'
                    << once.str();
            continue;
        }
        print(twice, *model->charts.begin());
        ASSERT_EQ(once.str(), twice.str()) << "seed " << seed;
        ++read;
    }
    EXPECT_GT(read, 30);
}

}  // namespace
}  // namespace grafverif
