// SPDX-License-Identifier: MIT
#include "emit/aiger/aiger.hpp"

#include <algorithm>
#include <utility>

namespace grafverif::aiger {

namespace {

using Literal = Gates::Literal;

std::string one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    return text;
}

class Writer {
public:
    Writer(const Circuit& circuit, const std::vector<AigerProperty>& questions, Form form, Extent extent)
        : circuit_(circuit),
          questions_(questions),
          form_(form),
          needed_(circuit.gates.size(), extent == Extent::Whole) {
        if (extent == Extent::Cone) close();
        number();
    }

    AigerText result() {
        header();
        latches();
        for (const AigerProperty& question : questions_)
            if (question.justice.empty()) line(literal(question.bad));
        for (const AigerProperty& question : questions_)
            if (!question.justice.empty()) line(question.justice.size());
        for (const AigerProperty& question : questions_)
            for (const Literal each : question.justice) line(literal(each));
        gates();
        symbols();
        return std::move(written_);
    }

private:
    /// Marks all nodes on which the selected properties depend, directly or through latches.
    void close() {
        std::vector<Literal> roots;
        for (const AigerProperty& question : questions_) {
            roots.push_back(question.bad);
            roots.insert(roots.end(), question.justice.begin(), question.justice.end());
        }
        std::vector<bool> followed(circuit_.latches.size());
        for (bool grew = true; grew;) {
            grew = false;
            for (const std::uint32_t node : cone(circuit_.gates, roots)) needed_[node] = true;
            roots.clear();
            for (std::size_t i = 0; i < followed.size(); ++i) {
                if (followed[i] || !needed_[circuit_.latches[i].node]) continue;
                followed[i] = grew = true;
                roots.push_back(circuit_.latches[i].next);
            }
        }
        // At least one input is kept, because a witness without inputs does not determine the length of the run.
        const bool some = std::ranges::any_of(circuit_.inputs, [&](const auto& input) { return needed_[input.node]; });
        if (!some && !circuit_.inputs.empty()) needed_[circuit_.inputs.front().node] = true;
    }

    void number() {
        written_.literals.assign(circuit_.gates.size(), 0);
        for (std::size_t i = 0; i < circuit_.inputs.size(); ++i)
            if (take(circuit_.inputs[i].node)) written_.inputs.push_back(i);
        for (std::size_t i = 0; i < circuit_.latches.size(); ++i)
            if (take(circuit_.latches[i].node)) written_.latches.push_back(i);
        for (std::uint32_t node = 1; node < circuit_.gates.size(); ++node)
            if (circuit_.gates.is_gate(node) && take(node)) gates_.push_back(node);
    }
    bool take(std::uint32_t node) {
        if (!needed_[node]) return false;
        written_.literals[node] = static_cast<Literal>(2 * ++last_);
        return true;
    }

    Literal literal(Literal gate_literal) const {
        return written_.literals[node_of(gate_literal)] ^ (gate_literal & 1U);
    }

    void header() {
        const auto lists = static_cast<std::size_t>(
            std::ranges::count_if(questions_, [](const AigerProperty& each) { return !each.justice.empty(); }));
        std::string& text = written_.text;
        text = form_ == Form::Ascii ? "aag" : "aig";
        for (const std::size_t count : {last_, written_.inputs.size(), written_.latches.size(), std::size_t{0},
                                        gates_.size(), questions_.size() - lists})
            text += ' ' + std::to_string(count);
        if (lists != 0) text += " 0 " + std::to_string(lists);
        text += '\n';
        if (form_ == Form::Ascii)
            for (const std::size_t input : written_.inputs) line(literal(2 * circuit_.inputs[input].node));
    }

    void latches() {
        for (const std::size_t index : written_.latches) {
            const Circuit::Latch& latch = circuit_.latches[index];
            if (form_ == Form::Ascii) written_.text += std::to_string(literal(2 * latch.node)) + ' ';
            line(literal(latch.next));
        }
    }

    void gates() {
        for (const std::uint32_t node : gates_) {
            const Literal out = written_.literals[node];
            const auto [low, high] =
                std::minmax({literal(circuit_.gates[node].left), literal(circuit_.gates[node].right)});
            if (form_ == Form::Ascii) {
                written_.text += std::to_string(out) + ' ' + std::to_string(high) + ' ';
                line(low);
            } else {
                difference(out - high);
                difference(high - low);
            }
        }
    }

    void symbols() {
        const auto name = [&](char kind, std::size_t index, const std::string& symbol) {
            written_.text += kind + std::to_string(index) + ' ' + one_line(symbol) + '\n';
        };
        for (std::size_t i = 0; i < written_.inputs.size(); ++i) name('i', i, circuit_.inputs[written_.inputs[i]].name);
        for (std::size_t i = 0; i < written_.latches.size(); ++i)
            name('l', i, circuit_.latches[written_.latches[i]].name);
        std::size_t bad = 0, justice = 0;
        for (const AigerProperty& question : questions_)
            question.justice.empty() ? name('b', bad++, question.name) : name('j', justice++, question.name);
    }

    void line(std::size_t number) { written_.text += std::to_string(number) + '\n'; }
    void difference(Literal value) {
        for (; value > 0x7FU; value >>= 7U) written_.text += static_cast<char>((value & 0x7FU) | 0x80U);
        written_.text += static_cast<char>(value);
    }

    const Circuit& circuit_;
    const std::vector<AigerProperty>& questions_;
    Form form_;
    AigerText written_ = {};
    std::vector<bool> needed_ = {};  ///< for each node of the circuit: true if the file contains the node
    std::vector<std::uint32_t> gates_ = {};
    std::size_t last_ = 0;
};

}  // namespace

AigerText written(const Circuit& circuit, const std::vector<AigerProperty>& questions, Form form, Extent extent) {
    return Writer(circuit, questions, form, extent).result();
}

std::vector<AigerProperty> queries_of(const TransitionSystem& system, const FlatSystem& flat, const Circuit& circuit) {
    std::vector<AigerProperty> questions;
    for (const Circuit::Target& target : circuit.targets)
        questions.push_back({system.properties[target.about].name, target.bad, target.justice});
    for (const Circuit::Target& target : circuit.targets)
        if (target.undefined != Gates::no)
            questions.push_back({system.properties[target.about].name + " has no value", target.undefined, {}});
    for (const Circuit::Leak& leak : circuit.leaks)
        questions.push_back({flat.variables[leak.variable].name + " leaves its range", leak.bad, {}});
    return questions;
}

}  // namespace grafverif::aiger
