// SPDX-License-Identifier: MIT
#include "generate.hpp"

#include <fmt/format.h>

#include <iterator>

namespace grafverif::bench {

namespace {

constexpr std::size_t ports = 16;

std::string list(const char* stem) {
    std::string names;
    for (std::size_t i = 0; i < ports; ++i) names += fmt::format("{}{}{}", i == 0 ? "" : ", ", stem, i);
    return names;
}

}  // namespace

std::string ring(std::size_t steps) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "grafcet ring {{\n    input {};\n    output {};\n    internal COUNT: int 0..1000 = 0;\n\n", list("a"), list("O"));
    for (std::size_t i = 0; i < steps; ++i) {
        fmt::format_to(out, "    {}step {} {{ O{};", i == 0 ? "initial " : "", i, i % ports);
        if (i % 10 == 3) fmt::format_to(out, " O{} if a{};", (i + 1) % ports, (i + 2) % ports);
        if (i % 10 == 7) fmt::format_to(out, " COUNT := COUNT % 1000 + 1 on activation;");
        fmt::format_to(out, " }}\n");
    }
    for (std::size_t i = 0; i < steps; ++i) {
        fmt::format_to(out, "    transition t{0}: {0} -> {1} when ", i, (i + 1) % steps);
        if (i % 10 == 5) fmt::format_to(out, "{}s/X{};\n", 1 + i % 7, i);
        else fmt::format_to(out, "a{} && !a{};\n", i % ports, (i + 1) % ports);
    }
    fmt::format_to(out, "}}\n\nclosed_loop ring_loop {{\n    controller ring;\n");
    for (std::size_t i = 0; i < ports; ++i) fmt::format_to(out, "    environment B{0} = push_button(OUT = a{0});\n", i);
    fmt::format_to(out, "    property all: reachable X{};\n}}\n", steps - 1);
    return fmt::to_string(text);
}

}  // namespace grafverif::bench
