// SPDX-License-Identifier: MIT
#include "simulate/completion.hpp"

#include <algorithm>
#include <sstream>

#include "simulate/called.hpp"

namespace grafverif {

namespace {

using Words = std::vector<std::string>;

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

Words locations_of(const ChartRun& run, std::string_view instance) {
    const auto found = std::ranges::find(run.instances, instance, &ChartRun::Instance::name);
    return found == run.instances.end() ? Words{} : found->locations;
}

Words inputs_of(const ChartRun& run) {
    Words names;
    for (const ChartRun::Signal& signal : run.signals)
        if (signal.role == ChartRun::Role::Input || signal.role == ChartRun::Role::Plant) names.push_back(signal.name);
    return names;
}

/// Returns completions of the last word in an expectation. `before` contains the previous words of the expectation.
Words in_claim(const ChartRun& run, const Words& before) {
    if (before.size() > 1 && before.back() == "in") return locations_of(run, before[before.size() - 2]);
    const bool begins = before.size() < 2 || before.back() == "until" || before.back() == "and" ||
                        before.back() == "not" || before.back().ends_with(',');
    if (!begins && before[before.size() - 2] != "within") return {"and", "in"};
    Words words = {"not"};
    if (before.size() == 1) words.emplace_back("within");
    append(words, names_of(run));
    append(words, instances_of(run));
    return words;
}

Words possible(const ChartRun& run, const Words& before) {
    if (before.empty()) {
        Words words;
        for (const std::string_view each : command_text)
            if (each.find(' ') == std::string_view::npos) words.emplace_back(each);
        append(words, inputs_of(run));
        return words;
    }
    const std::string& first = before[0];
    if (before.back() == "=") return {"true", "false"};
    if (first == "do") return before.size() == 1 ? instances_of(run) : locations_of(run, before[1]);
    if (first == "force" && before.size() > 1) return {"on", "off"};
    if (first == "force") {
        Words steps;
        for (const ChartRun::Step& step : run.steps) steps.push_back(step.full_name());
        return steps;
    }
    if (first == "wait" && before.size() == 1) return {"until"};
    if (first == "expect" || first == "wait") return in_claim(run, before);
    return {};
}

}  // namespace

std::size_t last_word(std::string_view line) {
    const std::size_t blank = line.find_last_of(" \t,");
    return blank == std::string_view::npos ? 0 : blank + 1;
}

std::vector<std::string> completions(const Simulation& simulation, std::string_view line) {
    const std::string_view begun = line.substr(last_word(line));
    std::istringstream text{std::string(line.substr(0, last_word(line)))};
    Words before;
    for (std::string word; text >> word;) before.push_back(word);
    Words words = possible(simulation.recorded_run(), before);
    std::erase_if(words, [&](const std::string& word) { return !word.starts_with(begun); });
    std::ranges::sort(words);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
}

}  // namespace grafverif
