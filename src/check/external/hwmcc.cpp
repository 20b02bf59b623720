// SPDX-License-Identifier: MIT
#include "check/external/hwmcc.hpp"

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>

namespace grafverif::hwmcc {

namespace {

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    return line;
}

/// Returns the bits of a line, or nullopt if the line contains other characters. The character `x`, an unspecified
/// value, is read as 0.
std::optional<std::vector<bool>> bits_of(std::string_view line) {
    std::vector<bool> bits;
    for (const char c : line) {
        if (c != '0' && c != '1' && c != 'x') return {};
        bits.push_back(c == '1');
    }
    return bits;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (!line.empty()) {
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == std::string_view::npos) break;
        line.remove_prefix(begin);
        words.push_back(line.substr(0, line.find_first_of(" \t")));
        line.remove_prefix(words.back().size());
    }
    return words;
}

}  // namespace

Circuit with_numbers(Circuit circuit) {
    if (circuit.inputs.empty()) circuit.inputs.push_back({node_of(circuit.gates.source()), {}});
    for (std::size_t i = 0; i < circuit.inputs.size(); ++i) circuit.inputs[i].name = "i" + std::to_string(i);
    for (std::size_t i = 0; i < circuit.latches.size(); ++i) circuit.latches[i].name = "l" + std::to_string(i);
    return circuit;
}

std::optional<bool> witness_result(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = next_line(text);
        if (line == "1" || line == "sat") return true;
        if (line == "0" || line == "unsat") return false;
        if (line == "2") return {};
    }
    return {};
}

std::string witness_of_abc(std::string_view text) {
    const std::size_t end = text.find("# DONE");
    return end == std::string_view::npos ? "" : "1\nb0\n" + std::string(text.substr(0, end)) + "\n.\n";
}

std::optional<std::vector<std::vector<bool>>> read_witness(const Circuit& circuit, const Numbering& numbering,
                                                           std::string_view text) {
    std::string_view line;
    while (!text.empty() && line != "1" && line != "sat") line = next_line(text);
    line = next_line(text);
    if (line.starts_with('b') || line.starts_with('j')) line = next_line(text);
    const auto latches = bits_of(line);
    if (!latches || latches->size() != numbering.latches.size()) return {};
    if (std::ranges::find(*latches, true) != latches->end()) return {};  // the initial value of every latch must be 0
    std::vector<std::vector<bool>> run;
    while (!text.empty()) {
        line = next_line(text);
        if (line == ".") break;
        const auto inputs = bits_of(line);
        if (!inputs || inputs->size() != numbering.inputs.size()) return {};
        std::vector<bool>& state = run.emplace_back(circuit.inputs.size());
        for (std::size_t i = 0; i < inputs->size(); ++i) state[numbering.inputs[i]] = (*inputs)[i];
    }
    if (run.empty()) return {};
    return run;
}

std::optional<std::vector<pdr::Cube>> read_invariant(const Circuit& circuit, std::string_view text) {
    std::vector<std::uint32_t> columns;
    std::vector<pdr::Cube> cubes;
    bool ended = false;
    while (!text.empty() && !ended) {
        const std::vector<std::string_view> words = words_of(next_line(text));
        if (words.empty() || words[0].starts_with('#')) continue;
        if (words[0] == ".ilb") {
            for (const std::string_view name : std::span(words).subspan(1)) {
                std::size_t latch = circuit.latches.size();
                if (name.starts_with('l')) std::from_chars(name.data() + 1, name.data() + name.size(), latch);
                if (latch >= circuit.latches.size()) return {};
                columns.push_back(circuit.latches[latch].node);
            }
        } else if (words[0].starts_with('.')) {
            ended = words[0] == ".e";
        } else {
            if (words[0].size() != columns.size()) return {};
            pdr::Cube& cube = cubes.emplace_back();
            for (std::size_t i = 0; i < columns.size(); ++i)
                if (words[0][i] != '-') cube.push_back(2 * columns[i] + (words[0][i] == '0' ? 1U : 0U));
            std::ranges::sort(cube);
        }
    }
    if (!ended) return {};
    return cubes;
}

std::string failure_of(const ProgramResult& program_result) {
    if (std::string ended = ended_by(program_result); !ended.empty()) return ended;
    return program_result.status == 0
               ? "the program printed no verdict"
               : "the program printed no verdict and exited with status " + std::to_string(program_result.status);
}

}  // namespace grafverif::hwmcc
