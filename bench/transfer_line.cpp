// SPDX-License-Identifier: MIT
// The transfer line as text, in which `@` is replaced by the number of a cell.
#include <string_view>

#include "engine_loops.hpp"

namespace grafverif::bench {

namespace {

constexpr std::string_view head =
    R"(// A transfer line: cells clamp a part, drill it and transfer it, with buffers before, between and after them. One PLC
// runs all cells, with one partial chart each; neighbours are connected by the handshake with the buffer between them.

)";

constexpr std::string_view wires =
    R"(    input GIVEN_@, STORED_@;  // responses of the buffers before and after cell @
    input CLAMP_IN_@, CLAMP_OUT_@, DRILL_IN_@, DRILL_OUT_@;
    output TAKE_@, PUT_@, CLAMP_@, DRILL_@;
)";

constexpr std::string_view chart_of = R"(
    partial cell_@ {
        initial step 0 { TAKE_@; }
        step 1 { CLAMP_@; }
        step 2 { CLAMP_@; DRILL_@; }
        step 3 { CLAMP_@; }
        step 4;  // release the part
        step 5 { PUT_@; }

        transition taken_@: 0 -> 1 when GIVEN_@;
        transition clamped_@: 1 -> 2 when CLAMP_OUT_@;
        transition drilled_@: 2 -> 3 when DRILL_OUT_@;
        transition back_@: 3 -> 4 when DRILL_IN_@;
        transition free_@: 4 -> 5 when CLAMP_IN_@;
        transition stored_@: 5 -> 0 when STORED_@;
    }
)";

constexpr std::string_view components =
    R"(// A buffer stores a part on request if it is not full, and provides a part on request if it is not empty. It
// acknowledges each request; the acknowledgement becomes false with the request.
component buffer(input PUT, TAKE; output STORED, GIVEN; output N: int 0..CAPACITY; CAPACITY = 8) {
    initial location idle;
    location storing;
    location giving;

    urgent idle -> storing when PUT && N < CAPACITY do N := N + 1, STORED := true;
    urgent storing -> idle when !PUT do STORED := false;
    urgent idle -> giving when TAKE && N > 0 do N := N - 1, GIVEN := true;
    urgent giving -> idle when !TAKE do GIVEN := false;
}

// An operator who delivers or removes parts at any time, but not twice within PAUSE.
component somebody(input DONE; output ASK; PAUSE = 1s) {
    clock t;

    initial location away;
    location asking;

    timed away -> asking when t >= PAUSE do ASK := true;
    urgent asking -> away when DONE do ASK := false, t := 0;
}

)";

constexpr std::string_view cylinders_of = R"(
    plant Clamp_@ = cylinder_monostable(G_OUT = CLAMP_@, X = C_@, X_max = 1);
    plant Clamp_Sen_@ = position_sensors_2(X = C_@, IN = CLAMP_IN_@, OUT = CLAMP_OUT_@, X_IN_max = 1,
                                           X_OUT_min = 1) initially in;
    plant Drill_@ = cylinder_monostable(G_OUT = DRILL_@, X = D_@, X_max = 2);
    plant Drill_Sen_@ = position_sensors_2(X = D_@, IN = DRILL_IN_@, OUT = DRILL_OUT_@, X_IN_max = 1,
                                           X_OUT_min = 2) initially in;
)";

constexpr std::string_view questions =
    R"(    property held_@ "the drill of cell @ moves only while the part is clamped": never D_@ > 0 && !CLAMP_OUT_@;
    property released_@ "cell @ never transfers a part that is still clamped": never PUT_@ && !CLAMP_IN_@;
)";

std::string of_cell(std::string_view text, int number) {
    std::string made;
    for (const char c : text) made += c == '@' ? std::to_string(number) : std::string(1, c);
    return made;
}

/// Returns the buffer after cell `k`. `k` = 0 denotes the buffer before all cells, and `k` = `cells` the buffer after
/// them.
std::string buffer(int k, int cells) {
    const std::string put = k == 0 ? "BRING, STORED = BROUGHT" : of_cell("PUT_@, STORED = STORED_@", k);
    const std::string take = k == cells ? "FETCH, GIVEN = FETCHED" : of_cell("TAKE_@, GIVEN = GIVEN_@", k + 1);
    return "    plant Buffer_" + std::to_string(k) + " = buffer(PUT = " + put + ", TAKE = " + take + ", N = N_" +
           std::to_string(k) + ");\n";
}

}  // namespace

std::string transfer_line(int cells) {
    const auto each = [cells](std::string_view text) {
        std::string all;
        for (int k = 1; k <= cells; ++k) all += of_cell(text, k);
        return all;
    };
    std::string text = std::string(head) + "grafcet line {\n" + each(wires) + each(chart_of) + "}\n\n";
    text += std::string(components) + "closed_loop transfer_line {\n    controller line;\n" + each(cylinders_of) + "\n";
    for (int k = 0; k <= cells; ++k) text += buffer(k, cells);
    text += "    environment Bringer = somebody(DONE = BROUGHT, ASK = BRING);\n";
    text += "    environment Fetcher = somebody(DONE = FETCHED, ASK = FETCH);\n\n";
    return text + each(questions) + "    property no_timelock: no timelock;\n}\n";
}

}  // namespace grafverif::bench
