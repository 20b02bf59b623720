// SPDX-License-Identifier: MIT
#include "random_files.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <regex>
#include <sstream>
#include <string_view>
#include <vector>

namespace grafverif {

namespace {

struct Dice {
    FileRandom& random;

    std::size_t below(std::size_t n) { return static_cast<std::size_t>(random() % n); }
    bool often(unsigned percent) { return random() % 100 < percent; }
    template <class Range>
    auto pick(const Range& range) {
        return *std::next(std::begin(range), static_cast<std::ptrdiff_t>(below(std::size(range))));
    }
};

std::string number(std::size_t n) { return std::to_string(n); }

/// Comments whose text becomes part of the chart if the translation does not escape it.
constexpr std::array comments = {"plain", "two\nlines", "a return\rgrafcet intruder {", "*/ } // grafcet", "\xC3\xBC",
                                 "",      " \t "};

// -- AGRAFE -----------------------------------------------------------------------------------------------------------

class AgrafeFile {
public:
    explicit AgrafeFile(FileRandom& random) : dice_{random} {}

    std::string write() {
        const std::size_t partials = 1 + dice_.below(3);
        for (std::size_t p = 0; p < partials; ++p) plan(p);
        std::string body;
        for (std::size_t p = 0; p < partials; ++p) body += partial(p);
        return R"(<?xml version="1.0" encoding="UTF-8"?>
<g:Grafcet xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:g="http://www.example.org/grafcet" xmlns:t="http://www.example.org/terms" name=")" +
               std::string(dice_.often(90) ? "chart" : dice_.pick(names)) + "\">\n" + declarations() + body +
               "</g:Grafcet>\n";
    }

private:
    static constexpr std::array names = {"a b",      "step", "X7", "1st",   "und_so_weiter",
                                         "\xC3\xA4", "when", "G1", "chart", "M"};

    struct Plan {
        bool expansion = false;
        std::size_t steps = 0, actions = 0;
    };

    void plan(std::size_t p) { plans_.push_back({p > 0 && dice_.often(30), 1 + dice_.below(4), dice_.below(4)}); }

    std::string place(std::size_t p) const { return "//@partialGrafcets." + number(p); }
    std::string step(std::size_t p) { return place(p) + "/@steps." + number(dice_.below(plans_[p].steps)); }

    std::string declarations() {
        std::string text = "  <variableDeclarationContainer>\n";
        const auto one = [&](const std::string& name, const char* type, const char* sort, const std::string& more) {
            if (dice_.often(10)) text += std::string("    <!-- ") + dice_.pick(comments) + " -->\n";
            text += "    <variableDeclarations name=\"" + name + '"' +
                    (*type != '\0' ? std::string(" variableDeclarationType=\"") + type + '"' : "") + more +
                    "><sort xsi:type=\"t:" + sort + "\"/></variableDeclarations>\n";
        };
        one("a", "", "Bool", "");
        one(dice_.often(80) ? "b" : dice_.pick(names), "input", "Bool", "");
        one("level", "", "Integer", "");
        one("O", "output", "Bool", "");
        one(dice_.often(80) ? "P" : dice_.pick(names), "output", "Bool", "");
        one("speed", "output", "Integer", "");
        one("m", "internal", "Bool", "");
        one("n", "internal", "Integer", "");
        one("X", "step", "Bool", " step=\"" + step(0) + '"');
        return text + "  </variableDeclarationContainer>\n";
    }

    static std::string variable(std::size_t k) {
        return "variableDeclaration=\"//@variableDeclarationContainer/@variableDeclarations." + number(k) + '"';
    }

    std::string leaf(const char* element, bool boolean) {
        static constexpr std::array booleans = {0, 1, 3, 4, 6, 8};
        static constexpr std::array integers = {2, 5, 7};
        if (dice_.often(15))
            return std::string("<") + element +
                   (boolean ? " xsi:type=\"t:BooleanConstant\" value=\"" : " xsi:type=\"t:IntegerConstant\" value=\"") +
                   (boolean ? dice_.often(50) ? "true" : "false" : number(dice_.below(9))) + "\"/>";
        const int k = boolean ? dice_.pick(booleans) : dice_.pick(integers);
        return std::string("<") + element + " xsi:type=\"t:Variable\" " + variable(static_cast<std::size_t>(k)) + "/>";
    }

    std::string term(const char* element, bool boolean, int depth) {
        if (depth == 0 || dice_.often(30)) return leaf(element, boolean);
        static constexpr std::array junctions = {"And", "Or"}, sums = {"Addition", "Substraction"};
        static constexpr std::array comparisons = {"Equality", "LessThan", "GreaterThan"};
        std::string type, inner;
        const std::size_t kind = dice_.below(10);
        if (!boolean)
            type = dice_.pick(sums), inner = term("subterm", false, depth - 1) + term("subterm", false, depth - 1);
        else if (kind < 4) {
            type = dice_.pick(junctions);
            for (std::size_t k = 0; k < 1 + dice_.below(3); ++k) inner += term("subterm", true, depth - 1);
        } else if (kind < 6) type = "Not", inner = term("subterm", true, depth - 1);
        else if (kind < 8)
            type = dice_.often(50) ? "RisingEdge" : "FallingEdge",
            inner = dice_.often(90) ? leaf("subterm", true) : term("subterm", true, depth - 1);
        else
            type = dice_.pick(comparisons),
            inner = term("subterm", false, depth - 1) + term("subterm", false, depth - 1);
        return std::string("<") + element + " xsi:type=\"t:" + type + "\">" + inner + "</" + element + '>';
    }

    std::string time(const std::array<const char*, 2>& types) {
        if (dice_.often(75)) return {};
        return " delayTime=\"" + number(dice_.below(4)) + "\" resetTime=\"" +
               number(dice_.often(70) ? 0 : dice_.below(3)) + "\" timeConditionType=\"" + dice_.pick(types) +
               (dice_.often(30) ? "\" unit=\"ms\"" : "\"");
    }

    std::string action(std::size_t p, std::size_t id) {
        const std::string head = "    <actionTypes id=\"" + number(id) + "\" xsi:type=\"g:";
        const std::size_t kind = dice_.below(10);
        if (kind < 4) {
            // Indices of the variables that actions write; inputs and integers are rare.
            static constexpr std::array driven = {3, 4, 6, 3, 4, 6, 0, 5};
            const bool conditional = dice_.often(40);
            return head + "ContinuousAction\"" + (conditional ? " continuousActionType=\"assignationCondition\"" : "") +
                   time({"timeDelayed", "timeLimited"}) + "><variable " +
                   variable(static_cast<std::size_t>(dice_.pick(driven))) + "/>" +
                   (conditional ? term("term", true, 2) : "") + "</actionTypes>\n";
        }
        if (kind < 9) {
            const bool event = dice_.often(40), boolean = dice_.often(50);
            static constexpr std::array targets = {3, 4, 6};
            return head + "StoredAction\" storedActionType=\"" +
                   (event             ? "event"
                    : dice_.often(50) ? "activation"
                                      : "deactivation") +
                   "\"><variable " +
                   variable(static_cast<std::size_t>(boolean           ? dice_.pick(targets)
                                                     : dice_.often(50) ? 7
                                                                       : 5)) +
                   "/>" + (event ? term("term", true, 2) : "") + term("value", boolean, 2) + "</actionTypes>\n";
        }
        static constexpr std::array orders = {"currentSituation", "emptySituation", "initialSituation"};
        return head + "ForcingOrder\" partialGrafcet=\"" + place((p + 1) % plans_.size()) + "\" forcingOrderType=\"" +
               dice_.pick(orders) + "\"/>\n";
    }

    std::string partial(std::size_t p) {
        const Plan& plan = plans_[p];
        std::string text =
            "  <partialGrafcets xsi:type=\"g:" + std::string(plan.expansion ? "MacrostepExpansion" : "PartialGrafcet") +
            "\" name=\"" + (dice_.often(80) ? "G" + number(p) : std::string(dice_.pick(names))) + "\">\n";
        std::string arcs;
        const auto arc = [&](const std::string& from, const std::string& to) {
            arcs += "    <arcs source=\"" + from + "\" target=\"" + to + "\"/>\n";
        };
        for (std::size_t s = 0; s < plan.steps; ++s)
            text += "    <steps xsi:type=\"g:Step\" id=\"" + number(dice_.often(95) ? 10 * p + s : 1) + '"' +
                    (s == 0 || dice_.often(10) ? " initial=\"true\"" : "") + "/>\n";
        std::vector<std::string> nodes;
        for (std::size_t s = 0; s < plan.steps; ++s) nodes.push_back(place(p) + "/@steps." + number(s));
        std::size_t macros = 0;
        for (std::size_t q = p + 1; q < plans_.size(); ++q) {
            if (!plans_[q].expansion || dice_.often(60)) continue;
            text += "    <macrosteps id=\"" + number(q) + "\" expansion=\"" + place(q) + "\"/>\n";
            nodes.push_back(place(p) + "/@macrosteps." + number(macros++));
        }
        if (plan.expansion) {
            text += "    <entryStep id=\"" + number(p) + "\"/><exitStep id=\"" + number(p) + "\"/>\n";
            nodes.insert(nodes.begin(), place(p) + "/@entryStep");
            nodes.push_back(place(p) + "/@exitStep");
        }
        for (std::size_t k = 0; k + 1 < nodes.size() + (plan.expansion ? 0 : 1); ++k) {
            const std::string here = place(p) + "/@transitions." + number(k);
            text += "    <transitions id=\"" + number(k) + '"' + time({"timeDependent", "timeDelayed"}) + '>' +
                    term("term", true, 3) + "</transitions>\n";
            arc(nodes[k], here);
            arc(here, nodes[(k + 1) % nodes.size()]);
        }
        for (std::size_t k = 0; k < plan.actions; ++k) {
            text += action(p, k);
            arcs += "    <actionLinks step=\"" + step(p) + "\" actionType=\"" + place(p) + "/@actionTypes." +
                    number(k) + "\"/>\n";
        }
        return text + arcs + "  </partialGrafcets>\n";
    }

    Dice dice_;
    std::vector<Plan> plans_ = {};
};

// -- Sequential Function Charts
// -----------------------------------------------------------------------------------------

/// Generates the parts that the textual form and PLCopen XML have in common.
class SfcParts {
public:
    explicit SfcParts(FileRandom& random) : dice{random} {}

    std::string step(std::size_t k) const { return "S" + number(k); }

    std::string condition(int depth) {
        static constexpr std::array leaves = {"a",    "b",    "level > 3",    "n = 2", "TRUE",
                                              "lamp", "S0.X", "S1.T >= T#2s", "m",     "level + n < 7"};
        if (depth == 0 || dice.often(40)) return dice.pick(leaves);
        static constexpr std::array joints = {" AND ", " OR ", " XOR "};
        if (dice.often(25)) return "NOT (" + condition(depth - 1) + ')';
        return '(' + condition(depth - 1) + dice.pick(joints) + condition(depth - 1) + ')';
    }

    std::string statements() {
        static constexpr std::array some = {"lamp := a AND b;",
                                            "n := 3;",
                                            "m := NOT m;",
                                            "IF a THEN n := 1; ELSE n := 2; END_IF",
                                            "motor := level > 2;",
                                            "n := n + 1;",
                                            "CASE level OF 1: n := 0; 2: n := 4; ELSE n := 5; END_CASE",
                                            "m := b; lamp := m;"};
        std::string text;
        for (std::size_t k = 1 + dice.below(2); k > 0; --k) text += std::string(dice.pick(some)) + ' ';
        return text;
    }

    std::string qualifier() {
        static constexpr std::array all = {"N", "S", "R", "P", "P0", "P1", "D", "L", "SD", "DS", "SL"};
        return dice.pick(all);
    }
    static bool is_timed(const std::string& qualifier) { return qualifier.find_first_of("DL") != std::string::npos; }
    /// Returns the name of a Boolean variable or of the action `work`.
    std::string acted() {
        static constexpr std::array all = {"lamp", "motor", "horn", "m", "lamp", "motor", "work"};
        return dice.pick(all);
    }

    Dice dice;
};

class SfcText {
public:
    explicit SfcText(FileRandom& random) : parts_(random) {}

    std::string write() {
        Dice& dice = parts_.dice;
        std::string text = std::string("(* ") + dice.pick(comments) + " *)\n" +
                           (dice.often(70) ? "PROGRAM" : "FUNCTION_BLOCK") + " press\n" +
                           "  VAR_INPUT a, b : BOOL; level : INT; END_VAR\n  VAR_OUTPUT lamp, motor, horn : BOOL; "
                           "END_VAR\n  VAR m : BOOL" +
                           (dice.often(50) ? " := TRUE" : "") + "; n : INT := 1; END_VAR\n";
        const std::size_t steps = 2 + dice.below(4);
        for (std::size_t k = 0; k < steps; ++k) text += step(k);
        for (std::size_t k = 0; k < steps; ++k) {
            transition(text, parts_.step(k), parts_.step((k + 1) % steps));
            if (dice.often(30)) transition(text, parts_.step(k), parts_.step(dice.below(steps)));
            if (dice.often(15))
                transition(text, "(" + parts_.step(k) + ", " + parts_.step((k + 2) % steps) + ")", parts_.step(0));
        }
        text += "ACTION work: " + parts_.statements() + "END_ACTION\n";
        return text + (text.find("PROGRAM press") != std::string::npos ? "END_PROGRAM\n" : "END_FUNCTION_BLOCK\n");
    }

private:
    std::string step(std::size_t k) {
        std::string text = (k == 0 ? "INITIAL_STEP " : "STEP ") + parts_.step(k) + ": ";
        for (std::size_t actions = parts_.dice.below(3); actions > 0; --actions) {
            const std::string qualifier = parts_.qualifier();
            text += parts_.acted() + '(' + qualifier + (SfcParts::is_timed(qualifier) ? ", T#2s" : "") + "); ";
        }
        return text + (parts_.dice.often(10) ? std::string("(* ") + parts_.dice.pick(comments) + " *) " : "") +
               "END_STEP\n";
    }

    void transition(std::string& text, const std::string& from, const std::string& to) {
        text += "TRANSITION " + (parts_.dice.often(30) ? "t" + number(++named_) + ' ' : std::string()) +
                (parts_.dice.often(20) ? "(PRIORITY := " + number(parts_.dice.below(4)) + ") " : "") + "FROM " + from +
                " TO " + to + " := " + parts_.condition(2) + "; END_TRANSITION\n";
    }

    SfcParts parts_;
    std::size_t named_ = 0;
};

class PlcopenFile {
public:
    explicit PlcopenFile(FileRandom& random) : parts_(random) {}

    std::string write() {
        Dice& dice = parts_.dice;
        const std::size_t steps = 2 + dice.below(3);
        std::string body;
        for (std::size_t k = 0; k < steps; ++k) {
            body += "<step localId=\"" + number(k) + "\" name=\"" + parts_.step(k) + '"' +
                    (k == 0 ? " initialStep=\"true\"" : "") + "><connectionPointIn>" +
                    (k == 0 ? "" : wire(100 + k - 1)) + "</connectionPointIn></step>\n";
            if (dice.often(60)) body += block(k);
            body += transition(100 + k, k);
            if (dice.often(30)) body += transition(200 + k, k) + jump(300 + k, 200 + k, dice.below(steps));
        }
        body += jump(400, 100 + steps - 1, 0);
        const auto variables = [](const char* list, std::initializer_list<const char*> names, const char* type) {
            std::string text = std::string("<") + list + '>';
            for (const char* name : names)
                text += std::string("<variable name=\"") + name + "\"><type><" + type + "/></type></variable>";
            return text + "</" + list + ">\n";
        };
        return std::string(
                   "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<project "
                   "xmlns=\"http://www.plcopen.org/xml/tc6_0201\">\n<!-- ") +
               dice.pick(comments) + " -->\n<types><pous><pou name=\"press\" pouType=\"program\"><interface>" +
               variables("inputVars", {"a", "b"}, "BOOL") + variables("inputVars", {"level"}, "INT") +
               variables("outputVars", {"lamp", "motor", "horn"}, "BOOL") + variables("localVars", {"m"}, "BOOL") +
               variables("localVars", {"n"}, "INT") + "</interface>\n<actions><action name=\"work\"><body><ST><p>" +
               parts_.statements() + "</p></ST></body></action></actions>\n<body><SFC>\n" + body +
               "</SFC></body></pou></pous></types></project>\n";
    }

private:
    static std::string wire(std::size_t to) { return "<connection refLocalId=\"" + number(to) + "\"/>"; }

    static std::string escaped(std::string text) {
        for (std::size_t at = 0; (at = text.find_first_of("<>", at)) != std::string::npos; at += 4)
            text.replace(at, 1, text[at] == '<' ? "&lt;" : "&gt;");
        return text;
    }

    std::string transition(std::size_t id, std::size_t from) {
        return "<transition localId=\"" + number(id) + '"' +
               (parts_.dice.often(20) ? " priority=\"" + number(parts_.dice.below(3)) + '"' : "") +
               "><connectionPointIn>" + wire(from) + "</connectionPointIn><condition><inline name=\"\"><ST><p>" +
               escaped(parts_.condition(2)) + "</p></ST></inline></condition></transition>\n";
    }

    std::string jump(std::size_t id, std::size_t from, std::size_t to) {
        return "<jumpStep localId=\"" + number(id) + "\" targetName=\"" + parts_.step(to) + "\"><connectionPointIn>" +
               wire(from) + "</connectionPointIn></jumpStep>\n";
    }

    std::string block(std::size_t step) {
        const std::string qualifier = parts_.qualifier();
        return "<actionBlock localId=\"" + number(500 + step) + "\"><connectionPointIn>" + wire(step) +
               "</connectionPointIn><action qualifier=\"" + qualifier + '"' +
               (SfcParts::is_timed(qualifier) ? " duration=\"T#3s\"" : "") + "><reference name=\"" + parts_.acted() +
               "\"/></action></actionBlock>\n";
    }

    SfcParts parts_;
};

std::vector<std::string> all_of(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        found.push_back(match->str());
    return found;
}

}  // namespace

std::string random_agrafe(FileRandom& random) { return AgrafeFile(random).write(); }
std::string random_sfc(FileRandom& random) { return SfcText(random).write(); }
std::string random_plcopen(FileRandom& random) { return PlcopenFile(random).write(); }

std::string mutated(const std::string& text, FileRandom& random) {
    Dice dice{random};
    static const std::regex value("\"[^\"\n]*\""), word("[A-Za-z_][A-Za-z_0-9]*");
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    const std::vector<std::string> values = all_of(text, value), words = all_of(text, word);
    for (std::size_t changes = 1 + dice.below(3); changes > 0 && lines.size() > 2; --changes) {
        const std::size_t at = dice.below(lines.size());
        const auto line = lines.begin() + static_cast<std::ptrdiff_t>(at);
        const auto replace = [&](const std::regex& pattern, const std::vector<std::string>& by) {
            const std::vector<std::string> here = all_of(*line, pattern);
            if (here.empty() || by.empty()) return;
            const std::string old = dice.pick(here);
            line->replace(line->find(old), old.size(), dice.pick(by));
        };
        switch (dice.below(6)) {
        case 0: lines.erase(line); break;
        case 1: lines.insert(line, lines[dice.below(lines.size())]); break;
        case 2: std::swap(*line, lines[dice.below(lines.size())]); break;
        case 3: replace(word, words); break;
        default: replace(value, values); break;
        }
    }
    std::string result;
    for (const std::string& line : lines) result += line + '\n';
    return result;
}

}  // namespace grafverif
