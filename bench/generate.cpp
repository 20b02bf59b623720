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

std::string assembly_stations(std::size_t count) {
    struct Line {
        const char* from;
        const char* to;
        const char* condition;
    };
    static constexpr Line transitions[] = {
        {"1", "2,3", "p_a_s"}, {"3", "4", "p_s"},    {"4,13", "5", "p_g"},   {"5", "6", "v_c_d"},
        {"6", "7", "ason"},    {"7", "8", "v_c_u"},  {"8", "9", "h_c_l"},    {"9", "10", "v_c_d"},
        {"10", "11,12", "v_c_u"}, {"12", "13", "h_c_r"}, {"2,11", "14", "true"}, {"14", "1", "!p_a_s"},
    };
    static constexpr const char* inputs[] = {"p_a_s", "p_s", "p_g", "v_c_d", "v_c_u", "h_c_l", "h_c_r", "ason"};
    static constexpr std::pair<const char*, const char*> actions[] = {
        {"5", "D_V_C"}, {"6", "D_V_C"}, {"9", "D_V_C"}, {"6", "ASP"}, {"7", "ASP"},
        {"8", "ASP"},   {"9", "ASP"},   {"8", "L_H_C"}, {"12", "R_H_C"}, {"14", "R_P"},
    };
    std::string text = "grafcet stations {\n";
    for (std::size_t station = 1; station <= count; ++station) {
        const std::string number = std::to_string(station);
        const auto steps = [&](std::string_view list) {
            std::string named;
            for (const char c : list) named += named.empty() || named.ends_with(", ") ? "A" + number + "_" + c : c == ',' ? std::string(", ") : std::string(1, c);
            return named;
        };
        for (const char* input : inputs) text += fmt::format("input {}{};\n", input, number);
        for (const char* output : {"D_V_C", "ASP", "L_H_C", "R_H_C", "R_P"}) text += fmt::format("output {}{};\n", output, number);
        for (int step = 1; step <= 14; ++step) {
            text += fmt::format("{}step A{}_{} {{ ", step == 1 || step == 13 ? "initial " : "", number, step);
            for (const auto& [of, output] : actions)
                if (of == std::to_string(step)) text += fmt::format("{}{}; ", output, number);
            text += "}\n";
        }
        int name = 0;
        for (const Line& line : transitions) {
            const std::string condition(line.condition);
            text += fmt::format("transition t{}_{}: {} -> {} when {};\n", number, ++name, steps(line.from), steps(line.to),
                                condition == "true" ? condition : condition + number);
        }
    }
    return text + "}\n";
}

}  // namespace grafverif::bench
