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
    fmt::format_to(out, "grafcet ring {{\n    input {};\n    output {};\n    internal COUNT: int 0..1000 = 0;\n\n",
                   list("a"), list("O"));
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
        {"1", "2,3", "p_a_s"},    {"3", "4", "p_s"},     {"4,13", "5", "p_g"},   {"5", "6", "v_c_d"},
        {"6", "7", "ason"},       {"7", "8", "v_c_u"},   {"8", "9", "h_c_l"},    {"9", "10", "v_c_d"},
        {"10", "11,12", "v_c_u"}, {"12", "13", "h_c_r"}, {"2,11", "14", "true"}, {"14", "1", "!p_a_s"},
    };
    static constexpr const char* inputs[] = {"p_a_s", "p_s", "p_g", "v_c_d", "v_c_u", "h_c_l", "h_c_r", "ason"};
    static constexpr std::pair<const char*, const char*> actions[] = {
        {"5", "D_V_C"}, {"6", "D_V_C"}, {"9", "D_V_C"}, {"6", "ASP"},    {"7", "ASP"},
        {"8", "ASP"},   {"9", "ASP"},   {"8", "L_H_C"}, {"12", "R_H_C"}, {"14", "R_P"},
    };
    std::string text = "grafcet stations {\n";
    for (std::size_t station = 1; station <= count; ++station) {
        const std::string number = std::to_string(station);
        const auto steps = [&](std::string_view list) {
            std::string named;
            for (const char c : list)
                named += named.empty() || named.ends_with(", ") ? "A" + number + "_" + c
                         : c == ','                             ? std::string(", ")
                                                                : std::string(1, c);
            return named;
        };
        for (const char* input : inputs) text += fmt::format("input {}{};\n", input, number);
        for (const char* output : {"D_V_C", "ASP", "L_H_C", "R_H_C", "R_P"})
            text += fmt::format("output {}{};\n", output, number);
        for (int step = 1; step <= 14; ++step) {
            text += fmt::format("{}step A{}_{} {{ ", step == 1 || step == 13 ? "initial " : "", number, step);
            for (const auto& [of, output] : actions)
                if (of == std::to_string(step)) text += fmt::format("{}{}; ", output, number);
            text += "}\n";
        }
        int name = 0;
        for (const Line& line : transitions) {
            const std::string condition(line.condition);
            text += fmt::format("transition t{}_{}: {} -> {} when {};\n", number, ++name, steps(line.from),
                                steps(line.to), condition == "true" ? condition : condition + number);
        }
    }
    return text + "}\n";
}

namespace {

constexpr const char* supervisor = R"(    partial supervisor {{
        initial step 0;
        step 1 {{ RUN := true on activation; }}
        step 2 {{ force cell1 := {{*}}; }}
        step 3 {{ RUN := false on activation; ALARM := true on activation;{0} }}
        step 4;
        step 5;
        transition s0: 0 -> 1 when START && !STOP;
        transition s1: 1 -> 2 when STOP && START;
        transition s2: 1 -> 3 when STOP && !START;
        transition s3: 2 -> 1 when !STOP;
        transition s4: 3 -> 4 when !STOP && START;
        transition s5: 4 -> 5 when !START;
        transition s6: 5 -> 0 when STOP;
    }}
)";

constexpr const char* cell = R"(    partial cell{0} {{
        initial step {0}0;
        step {0}1 {{ CLAMP{0} := true on activation; }}
        step {0}2 {{ DRILL{0} := true on activation; }}
        step {0}3 {{ DRILL{0} := false on activation; }}
        step {0}4 {{ LAMP{0} := true on activation; }}
        step {0}5 {{ BELT{0}; }}
        step {0}6;
        step {0}7 {{ CLAMP{0} := false on activation; }}
        step {0}8 {{ BELT{0} if FREE{0}; }}
        transition c{0}0: {0}0 -> {0}1 when PART{0} && supervisor.X1;
        transition c{0}1: {0}1 -> {0}2 when !UP{0};
        transition c{0}2: {0}2 -> {0}3 when DOWN{0};
        transition c{0}3: {0}3 -> {0}4 when UP{0} && GOOD{0};
        transition c{0}4: {0}3 -> {0}5 when UP{0} && !GOOD{0};
        transition c{0}5: {0}4 -> {0}6 when 2s/X{0}4;
        transition c{0}6: {0}5 -> {0}6 when LEFT{0};
        transition c{0}7: {0}6 -> {0}7 when FREE{0};
        transition c{0}8: {0}7 -> {0}8 when !PART{0};
        transition c{0}9: {0}8 -> {0}0 when LEFT{0} && !FREE{0};
    }}
)";

}  // namespace

std::string production_line(std::size_t count) {
    std::string text = "grafcet production_line {\n    input START, STOP;\n    output RUN, ALARM;\n", orders, cells;
    for (std::size_t k = 1; k <= count; ++k) {
        text += fmt::format(
            "    input PART{0}, DOWN{0}, UP{0}, GOOD{0}, LEFT{0}, FREE{0};\n    output CLAMP{0}, DRILL{0}, BELT{0}, "
            "LAMP{0};\n",
            k);
        orders += fmt::format(" force cell{} := {{INIT}};", k);
        cells += fmt::format(fmt::runtime(cell), k);
    }
    return text + fmt::format(fmt::runtime(supervisor), orders) + cells + "}\n";
}

}  // namespace grafverif::bench
