// SPDX-License-Identifier: MIT
#include "support/random_panel.hpp"

#include <algorithm>
#include <vector>

namespace grafverif {

namespace {

/// An instance of the panel, the inputs that it writes, and conditions on them.
struct Element {
    std::string instance = "", ports = "";
    std::vector<std::string> conditions = {};  // the first condition is a Boolean input or a comparison
    bool small = false;  // true for an instance with few states, so that a complete search can include many of them
};

const char* const components =
    "component follower(input P; output S) { clock t; initial location off; location going invariant t <= 1s; "
    "location on; urgent off -> going when P do t := 0; timed going -> on when t == 1s do S := true; "
    "urgent on -> off when !P do S := false; }\n"
    "component level(output V: int 0..2) { clock t; initial location any; "
    "timed any -> any when V < 2 && t >= 1s do V := V + 1, t := 0; timed any -> any when V > 0 do V := V - 1; }\n"
    "component expiring(output OUT) { clock t; initial location off; location on invariant t <= 3s; "
    "timed off -> on when t >= 1s do OUT := true, t := 0; }\n"
    "component once(output OUT, DONE) { initial location ready; location over with DONE := true; "
    "timed ready -> over do OUT := true, DONE := true; }\n"
    "component rising(output V: int 0..2) { clock t; initial location any; "
    "timed any -> any when t >= 1s do V := V + 1, t := 0; }\n"
    "component mutual(input P; output S) { initial location any; timed any -> any when P do S := !S; "
    "timed any -> any when S do S := false; }\n"
    "component pulse(input P) { initial location off; location on; urgent off -> on when P; timed on -> off; }\n";

std::vector<Element> elements(Random& random, bool faulty) {
    const auto any = [&](const char* location) {
        return chance(random, 30) ? std::string(" initially ") + location : "";
    };
    std::vector<Element> all{
        {"environment EA = push_button(OUT = A);", "A", {"A", "rise(A)", "fall(A)", "1s/A"}},
        {"environment EB = free(OUT = B);", "B", {"B", "rise(B)"}, true},
        {"environment EB2 = free(OUT = B2);", "B2", {"B2", "!B2", "fall(B2)"}, true},
        {"environment EB3 = free(OUT = B3);", "B3", {"B3", "B3 && !B3"}, true},
        {"environment EP = push_button_released(OUT = P, HOLD = 2s)" + any("pressed") + ";", "P", {"P", "fall(P)"}},
        {"environment ES = switch_2(FIRST = S1, SECOND = S2)" + any("second") + ";",
         "S1, S2",
         {"S1", "S2", "!S1 && !S2", "S1 && S2", "rise(S2)"}},
        {"environment EN = level(V = N);", "N: int 0..2", {"N > 1", "N == 0", "N == 1"}},
        {"environment EE = emergency_stop(OUT = E, NORMALLY_CLOSED = " +
             std::string(chance(random, 50) ? "true" : "false") + ")" + any("pressed") + ";",
         "E",
         {"E", "!E", "rise(E)", "2s/E"},
         true},
        {"environment EK = key_selector_3(FIRST = K1, SECOND = K2, THIRD = K3)" + any("third") + ";",
         "K1, K2, K3",
         {"K2", "K1 || K3", "K1 && K3", "!K1 && !K2 && !K3", "rise(K3)"}},
        {"environment ER = rotary_selector(POSITION = R, POSITIONS = 3);", "R: int 1..3", {"R == 2", "R > 2", "R < 1"}},
        {"environment EH = two_hand_control(LEFT = HL, RIGHT = HR, VALID = HV, WINDOW = 1s, GAP = 1s)" +
             any("refused_both") + ";",
         "HL, HR, HV",
         {"HV", "HL && HR && !HV", "HV && !HL", "rise(HL)"}},
        {"environment EC = light_curtain(CLEAR = CC, BODY = CB, RESPONSE = 1s)" + any("interrupted") + ";",
         "CC, CB",
         {"CC", "CC && CB", "!CC && !CB", "fall(CC)"}},
        {"environment EW = enabling_switch(ENABLE = WE, PANIC = WP)" + any("pressed_through") + ";",
         "WE, WP",
         {"WE", "WP", "WE && WP", "rise(WP)"}},
        {"environment EI = free_integer(OUT = I, HIGH = 2);", "I: int 0..2", {"I == 2", "I != 1"}, true},
        {"environment EF = stuck_fault(FAULT = F);", "F", {"F", "!F"}, true},
        {"environment EO = once(OUT = O, DONE = OD)" + any("over") + ";", "O, OD", {"O", "O && !OD", "rise(OD)"}, true},
        {"environment EG = acknowledge_button(LAMP = L, OUT = G, REACTION = 1s, PATIENCE = 2s);",
         "G",
         {"G", "rise(G)"}},
        {"environment ED = guard_door(LOCK = Q, CLOSED = DC, LOCKED = DL)" + any("open") + ";",
         "DC, DL",
         {"DC", "DL", "DL && !DC"}},
        {"environment EM = mutual(P = M2, S = M1);\nenvironment EM2 = mutual(P = M1, S = M2);",
         "M1, M2",
         {"M1", "M2", "M1 && M2"},
         true}};
    if (chance(random, 15)) all.push_back({"environment EX = expiring(OUT = Z);", "Z", {"Z", "rise(Z)"}});
    if (faulty) all.push_back({"environment EV = rising(V = V);", "V: int 0..2", {"V == 2", "V == 1"}});
    return all;
}

class Panel {
public:
    Panel(Random& random, const PanelOptions& options) : random_(random), options_(options) {
        int wanted = options.elements;
        if (wanted == 0) wanted = chance(random, 75) ? number(2, 3) : chance(random, 60) ? number(4, 5) : number(6, 8);
        std::vector<Element> all = elements(random, options.faulty);
        while (static_cast<int>(panel_.size()) < wanted && !all.empty()) {
            const auto at = all.begin() + number(0, static_cast<int>(all.size()) - 1);
            if (panel_.size() < 3 || at->small || chance(random, 10)) panel_.push_back(*at);
            all.erase(at);
        }
        if (options.faulty && !all.empty()) panel_.push_back(all.back());
        for (const Element& element : panel_)
            if (element.conditions[0].find_first_of(" !") == std::string::npos) plain_.push_back(element.conditions[0]);
        if (plain_.size() > 1 && chance(random, 25)) {
            sensors_ = "plant Shared = " + one_of({"or_sensor", "combination_sensor", "junction"}) +
                       "(A = " + plain_[0] + ", B = " + plain_[1] + ", OUT = V2);\n";
            panel_.push_back({"", "V2", {"V2", "rise(V2)"}});
        }
        if (!plain_.empty() && chance(random, 15)) {
            sensors_ += "plant Slow = delayed_signal(REAL = " + plain_[0] + ", READ = Y);\n";
            panel_.push_back({"", "Y", {"Y", "!Y"}});
        }
        reader_ = !plain_.empty() && chance(random, 25);
    }

    std::string text() {
        const bool two = chance(random_, 15);
        std::string text = chart("c", "L", "Q") + (two ? chart("d", "K", "U") : "") + components;
        text +=
            "closed_loop panel {\ncontroller c" + std::string(chance(random_, 30) ? " with every_cycle" : "") + ";\n";
        if (two) text += "controller d;\n";
        text += "plant Fol = follower(P = Q, S = D);\n" + sensors_;
        if (reader_) text += "plant Lamp = pulse(P = " + plain_.back() + ");\n";
        for (const Element& element : panel_)
            if (!element.instance.empty()) text += element.instance + "\n";
        const std::string when = one_of({"", " at stable"});
        text += "property p1: never " + term() + when + ";\nproperty p2: always " + term() +
                ";\nproperty p3: reachable " + term() + when +
                ";\nproperty p4: exactly one of {c.X0, c.X1, c.X2};\n"
                "property p5: reachable all steps;\nproperty d: no deadlock;\nproperty p6: never c.X1 && L && !Q" +
                when + ";\n";
        if (options_.observed) text += "property w1: " + sentence() + ";\n";
        if (options_.progress)
            text += "property g1: always possible " + term() + when + ";\nproperty g2: always possible " + atom() +
                    ";\nproperty g3: (" + atom() + ") leads to (" + term() + ");\nproperty g4: inevitable " + term() +
                    ";\n";
        if (options_.progress && options_.observed)
            text += "property w2: " +
                    one_of({"inevitable (" + atom() + ")", "(" + atom() + ") leads to (" + atom() + ")"}) +
                    one_of({" before (" + atom() + ")", " after (" + atom() + ")",
                            " after (" + atom() + ") until (" + atom() + ")"}) +
                    ";\n";
        return text + "}\n";
    }

private:
    int number(int low, int high) { return static_cast<int>(random_number(random_, low, high)); }
    std::string one_of(const std::vector<std::string>& from) {
        return from[static_cast<std::size_t>(number(0, static_cast<int>(from.size()) - 1))];
    }

    /// Returns a condition on the panel. If `edges`, the condition may contain edges and times.
    std::string state(bool edges) {
        std::string found = "D";
        if (chance(random_, 85)) {
            const Element& element = panel_[static_cast<std::size_t>(number(0, static_cast<int>(panel_.size()) - 1))];
            found = one_of(element.conditions);
            const bool plain = found.find('(') == std::string::npos && found.find('/') == std::string::npos;
            if (!edges && !plain) found = element.conditions[0];
        }
        return (chance(random_, 30) ? "!(" : "(") + found + ")";
    }
    std::string condition(int step) {
        const std::string x = "X" + std::to_string(step);
        return one_of({state(true), state(true), state(true) + " && " + state(true), state(true) + " || " + state(true),
                       "1s/" + x, "2s/" + x + " && " + state(true), "true"});
    }
    std::string actions(const std::string& lamp, const std::string& order) {
        return one_of({"", lamp + ";", lamp + " if " + state(false) + ";", lamp + "; " + order + ";",
                       order + " if " + state(false) + ";", "C := C + 1 on activation;", "C := 0 on activation;",
                       "M := true on activation;", "M := false on deactivation;", lamp + " after 1s;"});
    }
    std::string chart(const std::string& name, const std::string& lamp, const std::string& order) {
        std::string text = "grafcet " + name + " {\ninput D;\n";
        for (const Element& element : panel_) text += "input " + element.ports + ";\n";
        text += "output " + lamp + ", " + order + "; internal C: int 0..2 = 0; internal M;\n";
        for (int step = 0; step < 3; ++step)
            text += (step == 0 ? "initial step 0 { " : "step " + std::to_string(step) + " { ") + actions(lamp, order) +
                    " }\n";
        for (int step = 0; step < 3; ++step)
            text += "transition t" + std::to_string(step) + ": " + std::to_string(step) + " -> " +
                    std::to_string((step + 1) % 3) + " when " + condition(step) + ";\n";
        if (chance(random_, 50)) text += "transition back: 1 -> 0 when " + condition(1) + ";\n";
        return text + "}\n";
    }
    std::string atom() {
        return one_of(
            {"c.X0", "c.X1", "c.X2", "L", "Q", "D", "(c.C == 2)", "c.M", state(false), reader_ ? "Lamp in on" : "L"});
    }
    std::string term() { return atom() + one_of({" && ", " || ", " && !"}) + "(" + atom() + ")"; }
    std::string sentence() {
        const bool half = chance(random_, 25);  // the duration is not a multiple of the other durations
        return one_of({"(" + atom() + ") leads to (" + term() + ") within " + (half ? "1500ms" : "2s"),
                       "(" + atom() + ") holds for " + (half ? "1500ms" : "1s"),
                       "(" + atom() + ") holds at most " + (half ? "1500ms" : "2s"),
                       "never " + atom() + " between (" + atom() + ") and (" + atom() + ")",
                       "(" + atom() + ") at most 2 times", "(" + atom() + ") precedes (" + atom() + ")"});
    }

    Random& random_;
    const PanelOptions& options_;
    std::vector<Element> panel_ = {};
    std::vector<std::string> plain_ = {};  // Boolean inputs
    std::string sensors_ = "";
    bool reader_ = false;
};

}  // namespace

std::string random_panel(Random& random, const PanelOptions& options) { return Panel(random, options).text(); }

}  // namespace grafverif
