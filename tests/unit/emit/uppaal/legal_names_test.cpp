// SPDX-License-Identifier: MIT
#include "syntax/print/legal_names.hpp"

#include <gtest/gtest.h>

#include <random>
#include <unordered_set>

namespace grafverif {
namespace {

using Names = std::vector<std::string>;

TEST(LegalNames, KeepLegalNames) {
    const Names names = {"START", "X_2", "H_Act", "_"};
    EXPECT_EQ(legal_names(Target::Uppaal, names), names);
    EXPECT_EQ(legal_names(Target::Nusmv, names), names);
}

TEST(LegalNames, AvoidKeywordsOfTheTarget) {
    struct Case {
        Target target = Target::Uppaal;
        std::string name = {}, legal = {};
    };
    const std::vector<Case> cases = {
        {Target::Uppaal, "X", "X_"},
        {Target::UppaalLocal, "X", "X"},
        {Target::Nusmv, "X", "X_"},
        {Target::Uppaal, "S", "S"},
        {Target::Nusmv, "S", "S_"},
        {Target::Uppaal, "init", "init_"},
        {Target::UppaalLocal, "init", "init_"},
        {Target::Uppaal, "sat", "sat_"},
        {Target::Nusmv, "sat", "sat"},
        {Target::Uppaal, "M_PI", "M_PI_"},
        {Target::Uppaal, "int8_t", "int8_t_"},
        {Target::Nusmv, "self", "self_"},
        {Target::Nusmv, "next", "next_"},
        {Target::Uppaal, "next", "next"},
        {Target::Uppaal, "deadlock", "deadlock_"},
        {Target::Uppaal, "location", "location_"},
        {Target::Nusmv, "F", "F_"},
        {Target::Uppaal, "X12", "X12"},
        {Target::Uppaal, "X_head[1]_0", "X_head_1_0"},
        {Target::Nusmv, "slot[2][-1]", "slot_2__1"},
        {Target::StructuredText, "FULL[1]", "FULL_1"},
        {Target::StructuredText, "X12", "X12"},
        {Target::StructuredText, "Step", "Step_2"},
        {Target::StructuredText, "r_trig", "r_trig_2"},
        {Target::StructuredText, "a__b_", "a_b_0"},
        {Target::StructuredText, "2", "_2"},
        {Target::StructuredText, "_", "_0"},
    };
    for (const auto& [target, name, legal] : cases) {
        SCOPED_TRACE(name);
        EXPECT_EQ(legal_names(target, Names{name}), Names{legal});
    }
}

TEST(LegalNames, OfCopiesDifferFromNamesThatAreWrittenOut) {
    EXPECT_EQ(legal_names(Target::Uppaal, Names{"B[1]", "B_1", "B_1_"}), (Names{"B_1_2", "B_1", "B_1_"}));
}

TEST(LegalNames, AreCaseInsensitiveInStructuredText) {
    EXPECT_EQ(legal_names(Target::StructuredText, Names{"a", "A", "a_2"}), (Names{"a", "A_3", "a_2"}));
    EXPECT_EQ(legal_names(Target::StructuredText, Names{"GO"}, {"go"}), Names{"GO_2"});
    EXPECT_EQ(legal_names(Target::Uppaal, Names{"a", "A"}), (Names{"a", "A"}));
}

TEST(LegalNames, SpellOutIllegalCharacters) {
    EXPECT_EQ(legal_names(Target::Uppaal, Names{"2", "P.X7", "a-b", "", "\xC3\xA9"}),
              (Names{"_2", "P_X7", "a_b", "_", "e"}));
}

TEST(LegalNames, SpellOtherScriptsInAscii) {
    const Names names = {"Förderer", "Foerderer", "Größe$P", "モーター", "東京"};
    EXPECT_EQ(legal_names(Target::Nusmv, names), (Names{"Foerderer_", "Foerderer", "Groesse_P", "mota", "dong_jing"}));
    EXPECT_EQ(legal_names(Target::StructuredText, names)[0], "Foerderer_2");
}

TEST(LegalNames, KeepALegalNameForItsLaterOwner) {
    EXPECT_EQ(legal_names(Target::Uppaal, Names{"X", "X_", "X_2"}), (Names{"X_3", "X_", "X_2"}));
}

TEST(LegalNames, GiveEntitiesWithEqualNamesDifferentNames) {
    EXPECT_EQ(legal_names(Target::Uppaal, Names{"free", "free", "free"}), (Names{"free", "free_", "free_2"}));
}

TEST(LegalNames, AvoidNamesInUse) {
    EXPECT_EQ(legal_names(Target::Uppaal, Names{"W", "P0"}, {"W", "W_"}), (Names{"W_2", "P0"}));
}

TEST(LegalNames, ListOnlyChangedNames) {
    const Names names = {"X", "Y"}, legal = legal_names(Target::Uppaal, names);
    EXPECT_EQ(renamings(names, legal), (std::vector<Renaming>{{"X", "X_"}}));
}

TEST(LegalNames, AreLegalAndDistinctForAnyNames) {
    std::mt19937 random(7);
    const Names parts = {"X", "_", "2", ".", "init", "A", "sat", "EX", " "};
    for (int round = 0; round < 500; ++round) {
        Names names;
        for (int i = 0; i < 30; ++i) {
            std::string& name = names.emplace_back();
            for (std::size_t k = random() % 4; k > 0; --k) name += parts[random() % parts.size()];
        }
        for (const Target target : {Target::Uppaal, Target::UppaalLocal, Target::Nusmv}) {
            const Names legal = legal_names(target, names);
            EXPECT_EQ(std::unordered_set<std::string>(legal.begin(), legal.end()).size(), names.size())
                << "round " << round;
            for (const std::string& name : legal) EXPECT_TRUE(is_legal(target, name)) << name << " in round " << round;
        }
    }
}

TEST(LegalNames, AreComputedInLinearTime) {
    const Names names(200'000, "X");  // a quadratic search would take minutes
    EXPECT_EQ(legal_names(Target::Uppaal, names).back(), "X_200000");
}

}  // namespace
}  // namespace grafverif
