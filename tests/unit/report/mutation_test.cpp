// SPDX-License-Identifier: MIT
#include "report/charts/mutation.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace grafverif {
namespace {

/// Returns the line with the score of the specification, which detects `noticed` of `all` mutants.
std::string score(std::size_t noticed, std::size_t all) {
    Mutation mutation{.chart = "c", .properties = {"p"}};
    mutation.mutants.resize(all);
    mutation.results.assign(all, MutantResult{.kind = MutantResult::Kind::Unnoticed});
    for (std::size_t k = 0; k < noticed; ++k) mutation.results[k]->kind = MutantResult::Kind::Noticed;
    std::ostringstream out;
    print_mutation(mutation, Sources(), out);
    const std::string text = out.str();
    const std::size_t begin = text.find("the specification detects ");
    return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(MutationReport, PercentagesAreRoundedToTheNearestInteger) {
    EXPECT_EQ(score(26, 30), "the specification detects 26 of 30 mutants, 87 %");
    EXPECT_EQ(score(1, 3), "the specification detects 1 of 3 mutants, 33 %");
    EXPECT_EQ(score(1, 200), "the specification detects 1 of 200 mutants, 1 %");
}

TEST(MutationReport, OnlyAllMutantsAreAHundredPercentAndOnlyNoneAreZero) {
    EXPECT_EQ(score(300, 300), "the specification detects 300 of 300 mutants, 100 %");
    EXPECT_EQ(score(299, 300), "the specification detects 299 of 300 mutants, 99 %");
    EXPECT_EQ(score(1, 300), "the specification detects 1 of 300 mutants, 1 %");
    EXPECT_EQ(score(0, 300), "the specification detects 0 of 300 mutants, 0 %");
}

}  // namespace
}  // namespace grafverif
