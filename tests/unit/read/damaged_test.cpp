// SPDX-License-Identifier: MIT
// Tests damaged files of other formats, which are truncated or have changed bytes at any position. The reader never
// crashes. A rejected file has an error, and an accepted file can be written and read back.
#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <string>

#include "fixtures.hpp"
#include "read/formats.hpp"
#include "read/text.hpp"
#include "support/damage.hpp"
#include "support/test_size.hpp"
#include "syntax/language/format.hpp"

namespace grafverif {
namespace {

const std::string& fixture(std::size_t i) {
    static const std::string* const all[] = {&fixtures::agrafe, &fixtures::plcopen, &fixtures::sfc};
    return *all[i % 3];
}

void check_damaged(const std::string& text, bool lossy) {
    Sources sources;
    Diagnostics diagnostics;
    ReadContext context;
    context.lossy = lossy;
    const Id<Source> source = sources.add({"damaged.xml", text});
    const auto model = read_text(source, sources, context, diagnostics);
    ASSERT_EQ(model.has_value(), !diagnostics.has_errors()) << text;
    std::ostringstream rendered;
    render_text(diagnostics.all(), sources, Colour::Plain, rendered);  // the rendered text contains every location
    if (!model) return;
    ASSERT_EQ(verify(*model), std::vector<std::string>{}) << text;
    Diagnostics none;
    const std::string once = formatted(laid_out(read_any(source, sources, {lossy}, none)));
    Diagnostics again;
    ASSERT_TRUE(read_text(sources.add({"back.grafcet", once}), sources, {}, again)) << text << '\n' << once;
}

TEST(DamagedImport, TruncatedAnywhereIsAcceptedOrRejected) {
    std::mt19937 random(1);
    for (int i = 0; i < test_size(300); ++i) {
        const std::string& text = fixture(random());
        check_damaged(text.substr(0, random() % (text.size() + 1)), i % 2 == 0);
        if (::testing::Test::HasFatalFailure()) return;
    }
}

TEST(DamagedImport, WithChangedBytesIsAcceptedOrRejected) {
    std::mt19937 random(2);
    const std::string likely = "<>/\"=&;:()[] 0123456789ATNR.@#!\x80\xFF";
    for (int i = 0; i < test_size(1500); ++i) {
        SCOPED_TRACE(i);
        check_damaged(damaged(fixture(random()), {likely, 3, 60}, random), i % 2 == 0);
        if (::testing::Test::HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace grafverif
