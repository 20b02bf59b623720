// SPDX-License-Identifier: MIT
#include "support/text/identifier.hpp"

#include <gtest/gtest.h>

namespace grafverif {

namespace {

bool is_name(std::string_view text) { return !text.empty() && identifier_length(text) == text.size(); }

TEST(Identifier, MayBeOfAnyScript) {
    for (const std::string_view name :
         {"A", "_", "x1", "Förderer", "Größe_2", "モーター", "двигатель", "東京", "é", "देव"})
        EXPECT_TRUE(is_name(name)) << name;
    for (const std::string_view text :
         {"", "1a", "a-b", "↑A", "A↑", "“a”", "\u0301a", "a\u202Eb", "a\u00A0b", "½", "\xC3", "a\xFF"})
        EXPECT_FALSE(is_name(text)) << text;
    EXPECT_EQ(identifier_length("Grö≤e"), 4U);
}

TEST(Identifier, IsNormalizedToComposedCharacters) {
    EXPECT_EQ(composed("Fo\u0308rderer"), "Förderer");
    EXPECT_EQ(composed("\u212Bngstr\u00F6m"), "Ångström");
    EXPECT_EQ(composed("plain_1"), "plain_1");
}

TEST(Identifier, IsSpelledInAsciiAsItReads) {
    EXPECT_EQ(in_ascii("Förderer"), "Foerderer");
    EXPECT_EQ(in_ascii("GRÖSSE_ß"), "GROESSE_ss");
    EXPECT_EQ(in_ascii("P.Höhe$1"), "P.Hoehe$1");
    EXPECT_EQ(in_ascii("モーター"), "mota");
    EXPECT_EQ(in_ascii("Ωmega"), "Omega");
    for (const std::string_view name : {"двигатель", "東京", "שלום", "देव"})
        for (const char c : in_ascii(name)) EXPECT_LT(static_cast<unsigned char>(c), 0x80U) << name;
}

}  // namespace

}  // namespace grafverif
