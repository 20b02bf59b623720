// SPDX-License-Identifier: MIT
#include "support/random_scans.hpp"

#include <fmt/format.h>

#include <array>

namespace grafverif {

namespace {

class Writer {
public:
    Writer(Random& random, int milliseconds) : random_(random), milliseconds_(milliseconds) {}

    RandomScans write(bool timers) {
        RandomScans made;
        std::string variables = "  x, y : BOOL;\n  n : SINT := 126;\n  k : INT(-3..3);\n  r : R_TRIG;\n";
        made.booleans = {"x", "y", "r.Q"};
        made.integers = {"n", "k"};
        made.counter = is(40);
        if (made.counter) {
            variables += "  c : CTU;\n";
            made.booleans.emplace_back("c.Q");
        }
        if (timers && is(80)) {
            static constexpr std::array types = {"TON", "TOF", "TP"};
            variables += fmt::format("  t : {};\n", types[static_cast<std::size_t>(below(3))]);
            made.timers = true;
            made.booleans.push_back("t.Q");
        }
        known_ = made.booleans;
        const bool chart = is(35);
        std::string body = fmt::format("r(CLK := {});\n", condition(0));
        if (made.counter)
            body += fmt::format("c(CU := {}, R := {}, PV := {});\n", condition(0), condition(0), 1 + below(3));
        if (made.timers)
            body += fmt::format("t(IN := {}, PT := T#{}ms);\n", condition(0), (1 + below(4)) * milliseconds_);
        for (int i = 0; i < 4; ++i) body += statement(0);
        made.text = "PROGRAM Main\nVAR_INPUT\n  a, B : BOOL;\nEND_VAR\nVAR_OUTPUT\n  q0, q1 : BOOL;\nEND_VAR\nVAR\n" +
                    variables + "END_VAR\n" + (chart ? chart_of(body, made, timers) : body) + "END_PROGRAM\n";
        return made;
    }

private:
    bool is(int percent) { return chance(random_, percent); }
    int below(int count) { return static_cast<int>(random_number(random_, 0, count - 1)); }

    std::string condition(int depth) {
        if (depth > 1 || is(40)) {
            static constexpr std::array names = {"a", "b", "A", "x", "Y", "q0"};
            if (is(40)) return known_[static_cast<std::size_t>(below(static_cast<int>(known_.size())))];
            return names[static_cast<std::size_t>(below(6))];
        }
        switch (below(5)) {
        case 0: return "NOT " + operand(depth);
        case 1: return fmt::format("{} OR {}", operand(depth), operand(depth));
        case 2: return fmt::format("{} XOR {}", operand(depth), operand(depth));
        case 3: return fmt::format("({} {} {})", is(50) ? "n" : "k", is(50) ? "<" : "=", below(4) - 1);
        default: return fmt::format("{} AND {}", operand(depth), operand(depth));
        }
    }
    std::string operand(int depth) { return '(' + condition(depth + 1) + ')'; }

    std::string statement(int depth) {
        switch (below(depth < 2 ? 8 : 5)) {
        case 0: return fmt::format("q0 := {};\n", condition(0));
        case 1: return fmt::format("q1 := {};\n", condition(0));
        case 2: return fmt::format("{} := {};\n", is(50) ? "x" : "y", condition(0));
        case 3:
            if (is(8)) return "n := n / INT_TO_SINT(k);\n";
            return fmt::format("n := n {} {};\n", is(70) ? "+" : "*", 1 + below(60));
        case 4: return is(90) ? fmt::format("k := LIMIT(-3, k + {}, 3);\n", below(5) - 2) : "k := n;\n";
        case 5:
            return fmt::format("IF {} THEN\n{}ELSE\n{}END_IF;\n", condition(0), statement(depth + 1),
                               statement(depth + 1));
        case 6: return fmt::format("IF {} THEN\n{}END_IF;\n", condition(0), statement(depth + 1));
        default:
            return fmt::format("CASE k OF\n0: {}1..2: {}ELSE {}END_CASE;\n", statement(depth + 1), statement(depth + 1),
                               statement(depth + 1));
        }
    }

    /// Returns a chart of three steps. The first and the last step execute `body`.
    std::string chart_of(const std::string& body, RandomScans& made, bool timers) {
        for (const char* name : {"S0.X", "S1.X", "S2.X"}) made.booleans.emplace_back(name);
        const bool timed = timers && is(60);
        made.timers = made.timers || timed;
        const std::string wait = timed ? fmt::format("S1.T >= T#{}ms", (1 + below(3)) * milliseconds_) : condition(1);
        return fmt::format(
            "INITIAL_STEP S0: main(N); END_STEP\nSTEP S1: q1({}); END_STEP\nSTEP S2: second(P); main(N); END_STEP\n"
            "TRANSITION FROM S0 TO S1 := {}; END_TRANSITION\nTRANSITION FROM S1 TO S2 := {}; END_TRANSITION\n"
            "TRANSITION FROM S2 TO S0 := {}; END_TRANSITION\nACTION main:\n{}END_ACTION\nACTION "
            "second:\n{}END_ACTION\n",
            timed ? fmt::format("D, T#{}ms", (1 + below(2)) * milliseconds_) : "N", condition(0), wait, condition(0),
            body, statement(1));
    }

    Random& random_;
    const int milliseconds_;
    std::vector<std::string> known_ = {};
};

}  // namespace

RandomScans random_scans(Random& random, bool timers, int milliseconds) {
    return Writer(random, milliseconds).write(timers);
}

}  // namespace grafverif
