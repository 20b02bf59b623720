// SPDX-License-Identifier: MIT
#include "families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <ranges>
#include <vector>

namespace grafverif::bench {

namespace {

struct Family {
    struct Link {
        std::vector<std::size_t> from = {}, to = {};
    };
    std::string name = {};
    std::size_t steps = 0;                  ///< number of steps, which are numbered from 1
    std::vector<std::size_t> initial = {};  ///< initial steps, each with an output
    std::vector<Link> links = {};

    std::size_t step() { return ++steps; }
};

std::string numbers(const std::vector<std::size_t>& all) {
    std::string text;
    for (const std::size_t number : all) text += (text.empty() ? "" : ", ") + std::to_string(number);
    return text;
}

std::string names(const char* stem, std::size_t count) {
    std::string text;
    for (std::size_t k = 0; k < count; ++k) text += fmt::format("{}{}{}", k == 0 ? "" : ", ", stem, k);
    return text;
}

std::string text_of(const Family& family) {
    std::size_t inputs = 1;
    while ((std::size_t{1} << inputs) < family.links.size()) ++inputs;
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "grafcet {} {{\n    input {};\n    output {};\n\n", family.name, names("i", inputs),
                   names("O", family.initial.size()));
    for (std::size_t step = 1; step <= family.steps; ++step) {
        const auto initial = std::ranges::find(family.initial, step);
        if (initial == family.initial.end()) fmt::format_to(out, "    step {};\n", step);
        else fmt::format_to(out, "    initial step {} {{ O{}; }}\n", step, initial - family.initial.begin());
    }
    for (std::size_t c = 0; c < family.links.size(); ++c) {
        fmt::format_to(out, "    transition t{}: {} -> {} when ", c, numbers(family.links[c].from),
                       numbers(family.links[c].to));
        for (std::size_t k = 0; k < inputs; ++k)
            fmt::format_to(out, "{}{}i{}", k == 0 ? "" : " && ", ((c >> k) & 1U) != 0 ? "!" : "", k);
        fmt::format_to(out, ";\n");
    }
    fmt::format_to(out, "}}\n");
    return fmt::to_string(text);
}

void add_ring(Family& family, std::size_t steps) {
    const std::size_t first = family.steps + 1;
    family.initial.push_back(first);
    for (std::size_t k = 0; k < steps; ++k) family.links.push_back({{first + k}, {first + (k + 1) % steps}});
    family.steps += steps;
}

/// Adds `branches` branches below `step`; if `levels` is greater than 1, each branch contains
/// further branches. Returns the last step of each branch.
std::vector<std::size_t> add_branches(Family& family, std::size_t step, std::size_t levels, std::size_t branches) {
    std::vector<std::size_t> opened, closing;
    for (std::size_t k = 0; k < branches; ++k) opened.push_back(family.step());
    family.links.push_back({{step}, opened});
    for (const std::size_t open : opened) {
        std::vector<std::size_t> ends;
        if (levels > 1) {
            ends = add_branches(family, open, levels - 1, branches);
        } else {
            ends = {family.step()};
            family.links.push_back({{open}, ends});
        }
        closing.push_back(family.step());
        family.links.push_back({ends, {closing.back()}});
    }
    return closing;
}

}  // namespace

std::string basic_sequence(std::size_t steps) {
    Family family{fmt::format("basic_sequence_{}", steps), 0, {}, {}};
    add_ring(family, steps);
    return text_of(family);
}

std::string hierarchical_parallel(std::size_t rings, std::size_t steps) {
    Family family{fmt::format("hierarchical_parallel_{}_{}", rings, steps), 0, {}, {}};
    for (std::size_t ring = 0; ring < rings; ++ring) add_ring(family, steps);
    return text_of(family);
}

std::string basic_parallel(std::size_t levels, std::size_t branches) {
    Family family{fmt::format("basic_parallel_{}_{}", levels, branches), 0, {}, {}};
    const std::size_t first = family.step();
    family.initial.push_back(first);
    const std::vector<std::size_t> closing = add_branches(family, first, levels, branches);
    const std::size_t last = family.step();
    family.links.push_back({closing, {last}});
    family.links.push_back({{last}, {first}});
    return text_of(family);
}

}  // namespace grafverif::bench
