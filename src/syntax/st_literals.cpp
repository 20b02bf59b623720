// SPDX-License-Identifier: MIT
#include "syntax/st_literals.hpp"

#include <array>
#include <charconv>
#include <string>

#include "grafverif/syntax/st_tree.hpp"

namespace grafverif::st {

namespace {

constexpr std::int64_t longest = std::int64_t{1} << 40U;   ///< milliseconds

struct Unit {
    std::string_view name = {};
    std::int64_t microseconds = 0;
};
constexpr std::array<Unit, 6> units = {{
    {"MS", 1000}, {"US", 1}, {"D", 86'400'000'000}, {"H", 3'600'000'000}, {"M", 60'000'000}, {"S", 1'000'000}}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string without_underscores(std::string_view digits) {
    std::string kept;
    for (const char c : digits)
        if (c != '_') kept += c;
    return kept;
}

/// One part, `30m`, taken off the front of `rest`; microseconds.
std::optional<std::int64_t> part_of(std::string_view& rest) {
    std::size_t end = 0;
    while (end < rest.size() && is_digit(rest[end])) ++end;
    const auto whole = integer_of(rest.substr(0, end), 10);
    if (end == 0 || !whole) return {};
    std::string_view decimals;
    if (end < rest.size() && rest[end] == '.') {
        std::size_t stop = ++end;
        while (stop < rest.size() && is_digit(rest[stop])) ++stop;
        decimals = rest.substr(end, stop - end);
        end = stop;
    }
    rest.remove_prefix(end);
    for (const Unit& unit : units) {
        if (!rest.starts_with(unit.name)) continue;
        rest.remove_prefix(unit.name.size());
        if (*whole > longest) return {};
        std::int64_t scale = unit.microseconds;
        std::int64_t value = 0;
        if (__builtin_mul_overflow(*whole, scale, &value)) return {};
        for (const char digit : decimals) {
            if (digit != '0' && scale % 10 != 0) return {};
            scale /= 10;
            value += (digit - '0') * scale;
        }
        return value;
    }
    return {};
}

}  // namespace

std::optional<std::int64_t> integer_of(std::string_view digits, int base) {
    const std::string kept = without_underscores(digits);
    std::int64_t value = 0;
    const auto [end, failure] = std::from_chars(kept.data(), kept.data() + kept.size(), value, base);
    if (failure != std::errc() || end != kept.data() + kept.size()) return {};
    return value;
}

std::optional<std::int64_t> milliseconds_of(std::string_view duration) {
    const std::string kept = capitals(without_underscores(duration));
    std::string_view rest = kept;
    if (rest.starts_with('-') || rest.empty()) return {};
    std::int64_t total = 0;
    while (!rest.empty()) {
        const auto part = part_of(rest);
        if (!part || *part > 1000 * longest) return {};
        total += *part;
        if (total > 1000 * longest) return {};
    }
    if (total % 1000 != 0) return {};
    return total / 1000;
}

}  // namespace grafverif::st
