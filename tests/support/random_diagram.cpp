// SPDX-License-Identifier: MIT
#include "support/random_diagram.hpp"

#include <algorithm>

namespace grafverif {

namespace {

using Circuit = Rungs::Circuit;

Circuit random_circuit(Random& random, int depth) {
    Circuit made;
    if (depth == 0 || chance(random, 35)) {
        made.variable = static_cast<std::size_t>(random_number(random, 0, Rungs::inputs + Rungs::outputs - 1));
        made.edge = chance(random, 15);
        made.negated = !made.edge && chance(random, 30);
        return made;
    }
    made.kind = chance(random, 50) ? Rungs::Kind::Series : Rungs::Kind::Parallel;
    for (std::int64_t count = random_number(random, 2, 3); count > 0; --count)
        made.parts.push_back(random_circuit(random, depth - 1));
    return made;
}

bool flow(Circuit& circuit, bool power, const std::vector<bool>& values) {
    if (circuit.kind == Rungs::Kind::Contact) {
        const bool now = values[circuit.variable];
        const bool rises = now && !circuit.before;
        circuit.before = now;
        return power && (circuit.edge ? rises : now != circuit.negated);
    }
    const bool series = circuit.kind == Rungs::Kind::Series;
    bool out = series && power;
    for (Circuit& part : circuit.parts) {
        const bool passed = flow(part, series ? out : power, values);
        out = series ? passed : out || passed;
    }
    return out;
}

class XmlWriter {
public:
    explicit XmlWriter(Random& random) : random_(random) {}

    std::string document(const Rungs& rungs) {
        for (std::size_t i = 0; i < rungs.rungs.size(); ++i) rung(rungs.rungs[i], i);
        std::ranges::shuffle(elements_, random_);
        std::string text =
            "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><pous><pou name=\"p\" "
            "pouType=\"program\"><interface><inputVars>";
        for (std::size_t i = 0; i < Rungs::inputs; ++i) text += variable(diagram_variable(i), "<BOOL/>");
        text += "</inputVars><outputVars>";
        for (std::size_t i = 0; i < Rungs::outputs; ++i)
            text += variable(diagram_variable(Rungs::inputs + i), "<BOOL/>");
        text += "</outputVars><localVars>";
        for (std::size_t i = 0; i < rungs.rungs.size(); ++i)
            if (rungs.rungs[i].latch) text += variable("sr" + std::to_string(i), "<derived name=\"SR\"/>");
        text += "</localVars></interface><body><LD><leftPowerRail localId=\"0\"/>\n";
        for (const std::string& element : elements_) text += element + '\n';
        return text + "</LD></body></pou></pous></types></project>\n";
    }

private:
    static std::string variable(const std::string& name, const std::string& type) {
        return "<variable name=\"" + name + "\"><type>" + type + "</type></variable>";
    }

    static std::string connected(const std::vector<std::string>& sources) {
        std::string text = "<connectionPointIn>";
        for (const std::string& source : sources) text += "<connection refLocalId=\"" + source + "\"/>";
        return text + "</connectionPointIn>";
    }

    std::string position() const {
        return "<position x=\"" + std::to_string(next_) + "\" y=\"" + std::to_string(100 * row_ + next_ % 7) + "\"/>";
    }

    std::string id() { return std::to_string(++next_); }

    std::vector<std::string> circuit(const Circuit& from, const std::vector<std::string>& sources) {
        if (from.kind == Rungs::Kind::Contact) {
            const std::string own = id();
            elements_.push_back("<contact localId=\"" + own + "\" negated=\"" + (from.negated ? "true" : "false") +
                                "\" edge=\"" + (from.edge ? "rising" : "none") + "\">" + position() +
                                connected(sources) + "<variable>" + diagram_variable(from.variable) +
                                "</variable></contact>");
            return {own};
        }
        const bool series = from.kind == Rungs::Kind::Series;
        std::vector<std::string> ends = series ? sources : std::vector<std::string>();
        for (const Circuit& part : from.parts) {
            const std::vector<std::string> out = circuit(part, series ? ends : sources);
            if (series) ends = out;
            else ends.insert(ends.end(), out.begin(), out.end());
        }
        return ends;
    }

    void rung(const Rungs::Rung& from, std::size_t row) {
        row_ = row;
        std::vector<std::string> ends = circuit(from.set, {"0"});
        if (from.latch) {
            const std::vector<std::string> reset = circuit(from.reset, {"0"});
            const std::string own = id();
            elements_.push_back("<block localId=\"" + own + "\" typeName=\"SR\" instanceName=\"sr" +
                                std::to_string(row) + "\">" + position() +
                                "<inputVariables><variable formalParameter=\"S1\">" + connected(ends) +
                                "</variable><variable formalParameter=\"R\">" + connected(reset) +
                                "</variable></inputVariables><outputVariables><variable formalParameter=\"Q1\"/>"
                                "</outputVariables></block>");
            ends = {own};
        }
        const char* const marks[] = {"", " negated=\"true\"", " storage=\"set\"", " storage=\"reset\"",
                                     " edge=\"rising\""};
        const std::string own = id();
        elements_.push_back("<coil localId=\"" + own + "\"" + marks[static_cast<std::size_t>(from.coil)] + ">" +
                            position() + connected(ends) + "<variable>" + diagram_variable(from.variable) +
                            "</variable></coil>");
    }

    Random& random_;
    std::vector<std::string> elements_ = {};
    std::size_t next_ = 0, row_ = 0;
};

}  // namespace

std::string diagram_variable(std::size_t variable) {
    return variable < Rungs::inputs ? "i" + std::to_string(variable) : "q" + std::to_string(variable - Rungs::inputs);
}

Rungs random_rungs(Random& random) {
    Rungs made;
    for (std::int64_t count = random_number(random, 1, 6); count > 0; --count) {
        Rungs::Rung rung;
        rung.set = random_circuit(random, 3);
        rung.latch = chance(random, 25);
        if (rung.latch) rung.reset = random_circuit(random, 2);
        rung.coil = static_cast<Rungs::Coil>(random_number(random, 0, 4));
        rung.variable = Rungs::inputs + static_cast<std::size_t>(random_number(random, 0, Rungs::outputs - 1));
        made.rungs.push_back(std::move(rung));
    }
    return made;
}

void Rungs::scan(const std::vector<std::int64_t>& sampled) {
    for (std::size_t i = 0; i < inputs; ++i) values[i] = sampled[i] != 0;
    for (Rung& rung : rungs) {
        bool power = flow(rung.set, true, values);
        if (rung.latch) {
            const bool reset = flow(rung.reset, true, values);
            rung.latched = power || (rung.latched && !reset);
            power = rung.latched;
        }
        const bool rises = power && !rung.before;
        rung.before = power;
        switch (rung.coil) {
        case Coil::Plain: values[rung.variable] = power; break;
        case Coil::Negated: values[rung.variable] = !power; break;
        case Coil::Rising: values[rung.variable] = rises; break;
        case Coil::Set:
        case Coil::Reset:
            if (power) values[rung.variable] = rung.coil == Coil::Set;
            break;
        }
    }
}

std::string xml_of(const Rungs& rungs, Random& random) { return XmlWriter(random).document(rungs); }

}  // namespace grafverif
