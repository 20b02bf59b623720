// SPDX-License-Identifier: MIT
// Compares every operation on random functions with truth tables. Garbage collections and reorderings occur between the
// operations, and the invariants of the space are checked after each operation.
#include "bdd/bdd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <numeric>

#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

constexpr std::size_t most_variables = 10;
// A truth table: bit n is the value for the assignment in which variable i is bit i of n.
using Truth = std::bitset<std::size_t{1} << most_variables>;

struct Tabled {
    Bdd bdd = {};
    Truth table = {};
};

class RandomSpace {
public:
    RandomSpace(Random& random, const BddLimits& limits) : random_(random), space_(limits) {
        variables_ = static_cast<std::uint32_t>(random_number(random, 2, most_variables));
        space_.add_variables(variables_);
        if (chance(random, 50)) {
            const auto first = static_cast<std::uint32_t>(random_number(random, 0, variables_ - 2));
            space_.keep_together(first, static_cast<std::size_t>(random_number(random, 2, variables_ - first)));
        }
        for (int i = 0; i < 12; ++i) pool_.push_back(variable());
    }

    /// Applies one operation to some functions of the pool. The result replaces a function of the pool.
    void step() {
        Tabled result = made();
        expect_same(result);
        Tabled& place = pool_[static_cast<std::size_t>(random_number(random_, 0, 11))];
        EXPECT_EQ(place.bdd == result.bdd, place.table == result.table) << "equal functions are equal handles";
        place = std::move(result);
        if (chance(random_, 3)) space_.collect_garbage();
        if (chance(random_, 3)) space_.reorder();
        EXPECT_EQ(verify(space_), std::vector<std::string>());
    }

    void expect_all() const {
        for (const Tabled& each : pool_) expect_same(each);
        EXPECT_EQ(verify(space_), std::vector<std::string>());
    }

private:
    std::size_t size() const { return std::size_t{1} << variables_; }
    const Tabled& any() { return pool_[static_cast<std::size_t>(random_number(random_, 0, 11))]; }
    std::uint32_t index() { return static_cast<std::uint32_t>(random_number(random_, 0, variables_ - 1)); }
    static bool bit(std::size_t n, std::uint32_t i) { return ((n >> i) & 1U) != 0; }
    static std::size_t with(std::size_t n, std::uint32_t i, bool value) {
        return value ? n | std::size_t{1} << i : n & ~(std::size_t{1} << i);
    }

    template <class ValueAt>
    Truth table(const ValueAt& value_at) const {
        Truth result;
        for (std::size_t n = 0; n < size(); ++n) result[n] = value_at(n);
        return result;
    }

    std::vector<bool> assignment(std::size_t n) const {
        std::vector<bool> values(variables_);
        for (std::uint32_t i = 0; i < variables_; ++i) values[i] = bit(n, i);
        return values;
    }

    void expect_same(const Tabled& f) const {
        EXPECT_EQ(table([&](std::size_t n) { return evaluate(f.bdd, assignment(n)); }), f.table);
    }

    Tabled variable() {
        const std::uint32_t i = index();
        return {space_.variable(i), table([&](std::size_t n) { return bit(n, i); })};
    }

    std::vector<std::uint32_t> some_variables() {
        std::vector<std::uint32_t> chosen;
        for (std::uint32_t i = 0; i < variables_; ++i)
            if (chance(random_, 35)) chosen.push_back(i);
        return chosen;
    }

    Truth quantified(Truth t, const std::vector<std::uint32_t>& variables) const {
        for (const std::uint32_t i : variables)
            t = table([&](std::size_t n) { return t[with(n, i, false)] || t[with(n, i, true)]; });
        return t;
    }

    Tabled made() {
        const Tabled f = any(), g = any(), h = any();
        switch (random_number(random_, 0, 13)) {
        case 0: return {f.bdd & g.bdd, f.table & g.table};
        case 1: return {f.bdd | g.bdd, f.table | g.table};
        case 2: return {f.bdd ^ g.bdd, f.table ^ g.table};
        case 3: return {iff(f.bdd, g.bdd), table([&](std::size_t n) { return f.table[n] == g.table[n]; })};
        case 4: return {implies(f.bdd, g.bdd), table([&](std::size_t n) { return !f.table[n] || g.table[n]; })};
        case 5: return {~f.bdd, table([&](std::size_t n) { return !f.table[n]; })};
        case 6:
            return {ite(f.bdd, g.bdd, h.bdd),
                    table([&](std::size_t n) { return f.table[n] ? g.table[n] : h.table[n]; })};
        case 7: return variable();
        case 8: return {Bdd::constant(true), table([](std::size_t) { return true; })};
        case 9: return some(f);
        case 10: return product(f, g);
        case 11: return assumed(f);
        case 12: return renamed(f);
        default: return restricted_to(f, g);
        }
    }

    Tabled some(const Tabled& f) {
        const std::vector<std::uint32_t> v = some_variables();
        return {exists(f.bdd, variable_set(space_, v)), quantified(f.table, v)};
    }

    Tabled product(const Tabled& f, const Tabled& g) {
        const std::vector<std::uint32_t> v = some_variables();
        return {and_exists(f.bdd, g.bdd, variable_set(space_, v)), quantified(f.table & g.table, v)};
    }

    Tabled assumed(const Tabled& f) {
        std::vector<BddLiteral> literals;
        for (const std::uint32_t i : some_variables()) literals.push_back({i, chance(random_, 50)});
        std::ranges::shuffle(literals, random_);
        return {cofactor(f.bdd, cube(space_, literals)), table([&](std::size_t n) {
                    for (const BddLiteral literal : literals) n = with(n, literal.variable, literal.value);
                    return f.table[n];
                })};
    }

    Tabled renamed(const Tabled& f) {
        std::vector<std::uint32_t> to(variables_);
        std::iota(to.begin(), to.end(), 0U);
        std::ranges::shuffle(to, random_);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (std::uint32_t i = 0; i < variables_; ++i)
            if (to[i] != i) pairs.emplace_back(i, to[i]);
        return {BddRenaming(pairs)(f.bdd), table([&](std::size_t n) {
                    std::size_t before = 0;
                    for (std::uint32_t i = 0; i < variables_; ++i) before = with(before, i, bit(n, to[i]));
                    return f.table[before];
                })};
    }

    /// Tests operations that only read a function, and simplification, whose result is arbitrary outside the care set.
    Tabled restricted_to(const Tabled& f, const Tabled& care) {
        std::vector<std::uint32_t> all(variables_), used;
        std::iota(all.begin(), all.end(), 0U);
        for (const std::uint32_t i : all)
            if (table([&](std::size_t n) { return f.table[with(n, i, true)] != f.table[with(n, i, false)]; }).any())
                used.push_back(i);
        EXPECT_EQ(support(f.bdd), used);
        EXPECT_EQ(small_count(f.bdd, all), f.table.count());
        EXPECT_EQ(count(f.bdd, all), std::to_string(f.table.count()));
        Bdd together;
        for_each_cube(f.bdd, [&](std::span<const BddLiteral> literals) {
            const Bdd one = cube(space_, literals);
            EXPECT_TRUE((one & together).is_false());
            together |= one;
            return true;
        });
        EXPECT_EQ(together, f.bdd);
        if (!f.bdd.is_constant()) {
            EXPECT_EQ(ite(space_.variable(f.bdd.top()), f.bdd.high(), f.bdd.low()), f.bdd);
        }
        if (care.bdd.is_false()) return f;
        Tabled result{simplify(f.bdd, care.bdd), {}};
        result.table = table([&](std::size_t n) { return evaluate(result.bdd, assignment(n)); });
        EXPECT_EQ(result.table & care.table, f.table & care.table);
        return result;
    }

    Random& random_;
    BddSpace space_;
    std::uint32_t variables_ = 0;
    std::vector<Tabled> pool_ = {};
};

TEST(RandomizedBdd, OperationsAgreeWithTruthTables) {
    const int worlds = test_size(30);
    for (int seed = 0; seed < worlds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        RandomSpace world(random, {});
        for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) world.step();
        world.expect_all();
    }
}

TEST(RandomizedBdd, OperationsAgreeWithTruthTablesIfMemoryIsScarce) {
    const int worlds = test_size(20);
    int exhausted = 0;
    for (int seed = 0; seed < worlds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        // The space is limited to some thousand nodes, so that garbage collections occur within operations.
        RandomSpace world(random, {.memory = 135'000});
        for (int i = 0; i < 100 && !testing::Test::HasFailure(); ++i) try {
                world.step();
            } catch (const BddExhausted& failure) {
                EXPECT_EQ(failure.cause(), BddExhausted::Cause::Memory);
                ++exhausted;
                world.expect_all();
            }
    }
    RecordProperty("exhausted", exhausted);
}

}  // namespace
}  // namespace grafverif
