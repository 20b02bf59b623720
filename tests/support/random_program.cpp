// SPDX-License-Identifier: MIT
#include "support/random_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace grafverif {

namespace {

struct Block {
    std::string name = {}, type = {};
};

/// Writes the body of one program unit.
class Writer {
public:
    Writer(Random& random, bool blocks, int functions) : random_(random), functions_(functions) {
        if (!blocks) return;
        shares_ = true;
        for (const char* type : {"R_TRIG", "F_TRIG", "SR", "RS", "TON", "TOF", "TP", "CTU", "CTD", "CTUD"})
            if (chance(random_, 35)) blocks_.push_back({fmt::format("k{}", blocks_.size()), type});
    }

    void add_instances(int inner) {
        for (int i = 0; i < inner; ++i)
            if (chance(random_, 60)) blocks_.push_back({fmt::format("k{}", blocks_.size()), fmt::format("Inner{}", i)});
    }

    std::string variables() const {
        std::string text =
            "VAR x0, x1 : BOOL; x2 : BOOL := TRUE; n0 : INT; n1 : INT := 32760; m0 : SINT; m1 : USINT := 250; d0 : "
            "DINT; "
            "u0 : UINT; c0 : Colour := Green; w0, w1 : WORD; t0 : TIME := T#7ms; i : INT; b0 : BYTE := 16#A5; d1 : "
            "DWORD; v0 : ARRAY[-1..3] OF INT; v1 : ARRAY[0..1, 1..2] OF BOOL; s0 : INT(-3..10); p0 : Pair; p1 : "
            "ARRAY[1..2] OF Pair; END_VAR\n"
            "VAR_TEMP y0 : BOOL; y1 : INT := 3; END_VAR\n";
        if (shares_) text += "VAR kx : Share; END_VAR\n";
        for (const Block& block : blocks_) text += fmt::format("VAR {} : {}; END_VAR\n", block.name, block.type);
        return text;
    }

    /// Returns the declaration of an action, and permits calls of it in the following statements.
    std::string action() {
        in_action_ = true;  // no loops, because a loop around the call may use the same variable
        std::string text = "ACTION act:\n" + statements(1) + statements(2) + "END_ACTION\n";
        for (std::size_t at = 0; (at = text.find('y', at)) != std::string::npos; ++at)  // replaces temporary variables
            if (text[at + 1] == '0' || text[at + 1] == '1') text[at] = text[at + 1] == '0' ? 'x' : 'n';
        in_action_ = false;
        has_action_ = true;
        return text;
    }
    /// Permits calls of the action of an instance in the following statements.
    void call_actions_of_instances() { calls_inner_actions_ = true; }

    std::string body(int statements) {
        std::string text;
        for (int i = 0; i < statements; ++i) text += statement(0);
        return text;
    }

    std::vector<std::string> booleans = {"x0", "x1", "x2", "y0", "a", "b"}, integers = {"n0", "n1", "y1", "e"};

private:
    bool is(int percent) { return chance(random_, percent); }
    int below(int count) { return static_cast<int>(random_number(random_, 0, count - 1)); }
    const std::string& any(const std::vector<std::string>& list) {
        return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
    }

    std::string boolean(int depth) {
        if (depth > 2 || is(35)) {
            if (!blocks_.empty() && is(25)) {
                const Block& block = blocks_[static_cast<std::size_t>(below(static_cast<int>(blocks_.size())))];
                const bool bistable = block.type == "SR" || block.type == "RS";
                return block.name + (bistable ? ".Q1" : block.type == "CTUD" ? (is(50) ? ".QU" : ".qd") : ".Q");
            }
            if (is(12)) return is(50) ? "p0.f" : fmt::format("p1[{}].f", index("n1", 1, 2));
            if (is(12)) return fmt::format("v1[{}, {}]", index("n0", 0, 1), index("e", 1, 2));
            return is(8) ? (is(50) ? "TRUE" : "FALSE") : any(booleans);
        }
        switch (below(14)) {
        case 10: return fmt::format("({} AND_THEN {})", boolean(depth + 1), boolean(depth + 1));
        case 11: return fmt::format("({} OR_ELSE {})", boolean(depth + 1), boolean(depth + 1));
        case 12: return fmt::format("({} {} b0)", bits(), comparison());
        case 0: return "NOT " + parenthesised(boolean(depth + 1));
        case 1: return fmt::format("({} AND {} & {})", boolean(depth + 1), boolean(depth + 1), boolean(depth + 1));
        case 2: return fmt::format("({} OR {})", boolean(depth + 1), boolean(depth + 1));
        case 3: return fmt::format("({} XOR {} XOR {})", boolean(depth + 1), boolean(depth + 1), boolean(depth + 1));
        case 4: return fmt::format("({} = {})", boolean(depth + 1), boolean(depth + 1));
        case 5: return fmt::format("(c0 {} {})", is(50) ? "=" : "<>", colour());
        case 6: return fmt::format("(t0 {} T#{}ms)", comparison(), below(12));
        case 7: return fmt::format("(w0 {} {})", comparison(), below(5));
        case 8: return fmt::format("SEL({}, {}, {})", boolean(depth + 1), boolean(depth + 1), boolean(depth + 1));
        case 9: return fmt::format("INT_TO_BOOL({})", integer(depth + 1));
        default: return fmt::format("({} {} {})", integer(depth + 1), comparison(), integer(depth + 1));
        }
    }

    std::string comparison() {
        static constexpr std::array words = {"=", "<>", "<", "<=", ">", ">="};
        return words[static_cast<std::size_t>(below(6))];
    }
    std::string colour() {
        static constexpr std::array words = {"Red", "green", "BLUE", "Colour#Blue"};
        return words[static_cast<std::size_t>(below(4))];
    }
    /// Returns an index that is rarely outside of the array.
    std::string index(const std::string& variable, int low, int high) {
        if (is(50)) return std::to_string(low + below(high - low + 1));
        return is(97) ? fmt::format("LIMIT({}, {}, {})", low, variable, high) : variable;
    }
    /// Returns a term of the type BYTE.
    std::string bits() {
        switch (below(7)) {
        case 0: return "(NOT b0)";
        case 1: return fmt::format("(b0 AND {})", below(256));
        case 2: return fmt::format("(b0 OR INT_TO_BYTE({}))", integer(2));
        case 3: return fmt::format("(b0 XOR 16#{:X} XOR b0)", below(256));
        case 4: return fmt::format("{}(b0, {})", is(50) ? "SHL" : "SHR", below(10));
        case 5: return fmt::format("{}(b0, {})", is(50) ? "ROL" : "ROR", below(10));
        default: return "b0";
        }
    }
    std::string composite() {
        switch (below(14)) {
        case 0:
        case 1: return fmt::format("v0[{}] := {};\n", index("n0", -1, 3), integer(0));
        case 2: return fmt::format("v1[{}, {}] := {};\n", index("n0", 0, 1), index("e", 1, 2), boolean(0));
        case 3: return fmt::format("p0.n := {};\n", integer(0));
        case 4: return fmt::format("p1[{}].n := {};\n", index("n1", 1, 2), integer(0));
        case 5: return fmt::format("p1[{}].f := {};\n", index("n0", 1, 2), boolean(0));
        case 6: return is(50) ? "p0 := p1[1];\n" : fmt::format("p1[{}] := p0;\n", index("n0", 1, 2));
        case 7: return is(95) ? fmt::format("s0 := LIMIT(-3, {}, 10);\n", integer(0)) : "s0 := n0;\n";
        case 8: return fmt::format("b0 := {};\n", bits());
        case 9: return fmt::format("d1 := {} XOR {};\n", is(50) ? "ROL(d1, 5)" : "SHR(d1, 3)", is(50) ? "b0" : "w1");
        case 10: return fmt::format("w1 := (w1 {} w0) {} b0;\n", is(50) ? "AND" : "OR", is(50) ? "XOR" : "OR");
        case 11:
            switch (below(5)) {
            case 0: return fmt::format("IF t0 < T#1s THEN t0 := t0 + T#{}ms; END_IF;\n", below(9));
            case 1: return fmt::format("IF t0 > T#9ms THEN t0 := t0 - T#{}ms; END_IF;\n", below(9));
            case 2: return fmt::format("t0 := T#{}ms * ABS(e MOD 5);\n", below(9));
            case 3: return is(15) ? "t0 := t0 / (e MOD 3);\n" : fmt::format("t0 := t0 / {};\n", below(4) + 1);
            default: return is(10) ? "t0 := t0 - T#3ms;\n" : "d0 := TIME_TO_DINT(t0);\n";
            }
        case 12:
            if (!shares_) return ";\n";
            return fmt::format("kx(p := {}, c := p0, e := {}, o => x1);\n", is(50) ? "n0, q := n1" : "n1, q := v0[2]",
                               integer(1));
        default:
            if (has_action_ && is(50)) return "act();\n";
            if (!calls_inner_actions_) return ";\n";
            for (const Block& block : blocks_)
                if (block.type.starts_with("Inner") && is(60)) return block.name + ".act();\n";
            return ";\n";
        }
    }
    static std::string parenthesised(const std::string& text) { return "(" + text + ")"; }

    std::string integer(int depth) {
        if (depth > 2 || is(35)) {
            if (is(30)) return std::to_string(is(80) ? below(9) - 4 : is(50) ? 32767 : -32768);
            if (!blocks_.empty() && is(20)) {
                const Block& block = blocks_[static_cast<std::size_t>(below(static_cast<int>(blocks_.size())))];
                if (block.type.starts_with("CT")) return block.name + ".CV";
                if (block.type.starts_with("Inner")) return block.name + ".v";
            }
            if (is(12)) return fmt::format("v0[{}]", index("n1", -1, 3));
            if (is(12)) return is(50) ? "p0.n" : fmt::format("p1[{}].n", index("e", 1, 2));
            if (is(8)) return "s0";
            return any(integers);
        }
        switch (below(15)) {
        case 0: return fmt::format("(n0 + {})", integer(depth + 1));
        case 1: return fmt::format("({} - n1)", integer(depth + 1));
        case 2: return fmt::format("(n1 * {})", integer(depth + 1));
        case 3: return fmt::format("({} / (n0 * 2 + 1))", integer(depth + 1));
        case 4: return fmt::format("(n1 MOD ({}))", is(80) ? "e * 2 + 1" : integer(depth + 1));
        case 5: return "(-n0)";
        case 6: return "ABS(n0)";
        case 7: return fmt::format("MIN({}, n1, {})", integer(depth + 1), integer(depth + 1));
        case 8: return fmt::format("MAX(n0, {})", integer(depth + 1));
        case 9: return fmt::format("LIMIT({}, n0, {})", integer(depth + 1), integer(depth + 1));
        case 10: return fmt::format("DINT_TO_INT(d0 + {})", integer(depth + 1));
        case 11: return fmt::format("BOOL_TO_INT({})", boolean(depth + 1));
        case 12: return fmt::format("INT_TO_SINT({}) + m0 + USINT_TO_INT(m1)", integer(depth + 1));
        case 13: return "UINT_TO_INT(u0) + n0";
        default:
            if (functions_ == 0) return "MOVE(n1)";
            return is(50) ? fmt::format("Fun{}({}, {})", below(functions_), integer(depth + 1), boolean(depth + 1))
                          : fmt::format("Fun{}(q := {}, p := {})", below(functions_), boolean(depth + 1),
                                        integer(depth + 1));
        }
    }

    std::string statements(int depth) {
        std::string text;
        for (int i = below(3) + 1; i > 0; --i) text += statement(depth + 1);
        return text;
    }

    std::string statement(int depth) {
        if (is(22)) return composite();
        switch (below(depth > 2 ? 8 : 14)) {
        case 0:
        case 1: return fmt::format("{} := {};\n", any({"x0", "x1", "x2", "y0", "o"}), boolean(0));
        case 2:
        case 3: return fmt::format("{} := {};\n", any({"n0", "n1", "y1", "r"}), integer(0));
        case 4:
            switch (below(7)) {
            case 0: return fmt::format("m0 := m0 {} {};\n", is(50) ? "+" : "*", below(100));
            case 1: return fmt::format("m1 := m1 {} {};\n", is(50) ? "-" : "+", below(100));
            case 2: return fmt::format("d0 := d0 + {} * INT_TO_DINT(n1);\n", below(30000));
            case 3: return fmt::format("u0 := u0 {} {};\n", is(50) ? "-" : "*", below(1000));
            case 4: return fmt::format("c0 := {};\n", colour());
            case 5: return fmt::format("w0 := {};\n", below(5));
            default: return fmt::format("t0 := T#{}ms;\n", below(12));
            }
        case 5:
        case 6: return invocation();
        case 7: return is(12) ? (loops_ > 0 && is(60) ? "EXIT;\n" : "RETURN;\n") : ";\n";
        case 8:
        case 9:
        case 10: {
            std::string text = fmt::format("IF {} THEN\n{}", boolean(0), statements(depth));
            while (is(35)) text += fmt::format("ELSIF {} THEN\n{}", boolean(0), statements(depth));
            if (is(50)) text += "ELSE\n" + statements(depth);
            return text + "END_IF;\n";
        }
        case 11:
            if (is(30))
                return fmt::format("CASE c0 OF\nRed: {}Green, Blue: {}END_CASE;\n", statements(depth),
                                   statements(depth));
            return fmt::format("CASE {} OF\n-1, 1..3: {}0: {}{}END_CASE;\n", any({"n0", "n1", "e"}), statements(depth),
                               statements(depth), is(50) ? "ELSE " + statements(depth) : "");
        default: return loop(depth);
        }
    }

    std::string loop(int depth) {
        if (loops_ > 0 || in_action_) return ";\n";
        ++loops_;
        const std::string inner = statements(depth + 1);
        const std::string leave = is(40) ? fmt::format("IF {} THEN EXIT; END_IF;\n", boolean(1)) : "";
        --loops_;
        switch (below(4)) {
        case 0:
            return fmt::format("FOR i := {} TO {} BY {} DO\n{}{}END_FOR;\n", below(3), below(5), below(2) + 1, inner,
                               leave);
        case 1: return fmt::format("FOR i := 3 TO {} BY -1 DO\n{}{}END_FOR;\n", below(4), leave, inner);
        case 2:
            return fmt::format("i := 0;\nWHILE i < 3 {} DO\ni := i + 1;\n{}{}END_WHILE;\n",
                               is(40) ? "AND " + boolean(1) : "", inner, leave);
        default:
            return fmt::format("i := 0;\nREPEAT\ni := i + 1;\n{}{}UNTIL i >= 3 {} END_REPEAT;\n", leave, inner,
                               is(40) ? "OR " + boolean(1) : "");
        }
    }

    std::string invocation() {
        if (blocks_.empty()) return ";\n";
        const Block& block = blocks_[static_cast<std::size_t>(below(static_cast<int>(blocks_.size())))];
        const std::string& type = block.type;
        const auto call = [&](const std::string& arguments) { return block.name + "(" + arguments + ");\n"; };
        if (is(10)) return call("");
        if (type == "R_TRIG" || type == "F_TRIG") return call(fmt::format("CLK := {}, Q => x0", boolean(1)));
        if (type == "SR") return call(fmt::format("S1 := {}, R := {}", boolean(1), boolean(1)));
        if (type == "RS") return call(fmt::format("{}, {}", boolean(1), boolean(1)));
        if (type == "CTU") return call(fmt::format("CU := {}, R := {}, PV := {}", boolean(1), boolean(1), below(4)));
        if (type == "CTD")
            return call(fmt::format("CD := {}, LD := {}, PV := {}, CV => n0", boolean(1), boolean(1), below(4)));
        if (type == "CTUD")
            return call(fmt::format("CU := {}, CD := {}, R := {}, LD := {}, PV := 2", boolean(1), boolean(1),
                                    boolean(1), boolean(1)));
        if (type.starts_with("Inner")) return call(fmt::format("a := {}, e := {}, o => x1", boolean(1), integer(1)));
        return call(fmt::format("IN := {}, PT := {}{}", boolean(1), is(85) ? fmt::format("T#{}ms", below(25)) : "t0",
                                is(40) ? ", ET => t0" : ""));
    }

    Random& random_;
    int functions_;
    bool shares_ = false, in_action_ = false, has_action_ = false, calls_inner_actions_ = false;
    std::vector<Block> blocks_ = {};
    int loops_ = 0;
};

}  // namespace

std::string random_program(Random& random) {
    std::string text =
        "TYPE Colour : (Red, Green, Blue); Pair : STRUCT f : BOOL; n : INT := 2; END_STRUCT; END_TYPE\n"
        "FUNCTION_BLOCK Share\nVAR_IN_OUT p, q : INT; c : Pair; END_VAR VAR_INPUT e : INT; END_VAR\n"
        "VAR_OUTPUT o : BOOL; END_VAR VAR last : INT; END_VAR\n"
        "p := p + q; IF e > last THEN q := p; c.f := NOT c.f; END_IF; c.n := c.n + last; last := e; o := c.f;\n"
        "END_FUNCTION_BLOCK\nVAR_GLOBAL g : INT := 5; h : BOOL; END_VAR\n";
    const int functions = static_cast<int>(random_number(random, 0, 2));
    for (int i = 0; i < functions; ++i) {
        Writer writer(random, false, i);
        writer.booleans = {"x0", "x1", "x2", "y0", "q"};
        writer.integers = {"n0", "n1", "y1", "p", "g"};
        std::string body = writer.body(4) + fmt::format("Fun{} := n0 + p;\n", i);
        text += fmt::format(
            "FUNCTION Fun{} : INT\nVAR_INPUT p : INT; q : BOOL; END_VAR\nVAR o : BOOL; r, e : INT; "
            "END_VAR\n{}{}END_FUNCTION\n",
            i, writer.variables(), body);
    }
    const int inner = static_cast<int>(random_number(random, 0, 2));
    for (int i = 0; i < inner; ++i) {
        Writer writer(random, true, functions);
        writer.add_instances(i);
        if (i > 0) writer.call_actions_of_instances();
        const std::string action = writer.action();
        std::string body = writer.body(static_cast<int>(random_number(random, 2, 6)));
        text += fmt::format(
            "FUNCTION_BLOCK Inner{}\nVAR_INPUT a, b : BOOL; e : INT; END_VAR\nVAR_OUTPUT o, Q : BOOL; r, v : INT; "
            "END_VAR\n"
            "VAR_EXTERNAL g : INT; END_VAR\n{}{}{}Q := o; v := r + n0; g := g + 1;\nEND_FUNCTION_BLOCK\n",
            i, writer.variables(), action, body);
    }
    Writer writer(random, true, functions);
    writer.add_instances(inner);
    writer.booleans.emplace_back("h");
    writer.integers.emplace_back("g");
    writer.call_actions_of_instances();
    const std::string action = writer.action();
    std::string body = writer.body(static_cast<int>(random_number(random, 3, 9)));
    text += fmt::format(
        "PROGRAM Main\nVAR a AT %IX0.0 : BOOL; b AT %IX0.1 : BOOL; END_VAR\nVAR_INPUT e : INT; END_VAR\n"
        "VAR_OUTPUT o : BOOL; r : INT; END_VAR\n{}{}{}END_PROGRAM\n",
        writer.variables(), action, body);
    if (chance(random, 50))
        text +=
            "CONFIGURATION Plant RESOURCE Cpu ON PLC\nTASK Fast(INTERVAL := T#10ms, PRIORITY := 1);\n"
            "PROGRAM One WITH Fast : Main;\nEND_RESOURCE END_CONFIGURATION\n";
    return text;
}

}  // namespace grafverif
