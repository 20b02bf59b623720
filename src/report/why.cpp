// SPDX-License-Identifier: MIT
#include "report/why.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

constexpr std::array kinds = {ProofExplanation::Kind::Transition, ProofExplanation::Kind::Step,
                              ProofExplanation::Kind::Term,       ProofExplanation::Kind::Statement,
                              ProofExplanation::Kind::Guard,      ProofExplanation::Kind::Edge};

/// Without `--verbose`, at most this number of undecided elements of one type are listed by name; otherwise, only their
/// number is printed.
constexpr std::size_t most_open = 3;

std::string listed(const Names& names, std::string_view last = ", ", std::string_view between = ", ") {
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k)
        text += std::string(k == 0 ? "" : k + 1 == names.size() ? last : between) + names[k];
    return text;
}

bool has(const Names& names, const std::string& name) { return std::ranges::find(names, name) != names.end(); }

bool of_plant(ProofExplanation::Kind kind) {
    return kind == ProofExplanation::Kind::Guard || kind == ProofExplanation::Kind::Edge;
}

std::string nth_of(const ProofExplanation::ModelElement& element) {
    return element.nth > 1 ? fmt::format(" ({})", element.nth) : "";
}

/// Returns the name of an element within a list of elements of the same type. The name of an edge or guard does not
/// contain the name of its instance, because by_instance groups these elements by instance.
std::string name_of(const ProofExplanation::ModelElement& element) {
    if (element.kind == ProofExplanation::Kind::Term || element.kind == ProofExplanation::Kind::Statement)
        return fmt::format("`{}`{} of {}", element.name, nth_of(element), element.of);
    return element.name + nth_of(element);
}

using Choice = bool (*)(const ProofExplanation::ModelElement&);

/// Groups the chosen edges by instance. Returns, for each instance, the number of chosen edges, such as `Cups 2 of 6`;
/// or, if `named` is true, their names, such as `Cups (off -> on, on -> off)`.
Names by_instance(const std::vector<ProofExplanation::ModelElement>& edges, Choice chosen, bool named) {
    Names groups;
    for (auto first = edges.begin(); first != edges.end();) {
        const auto last = std::find_if(
            first, edges.end(), [&](const ProofExplanation::ModelElement& each) { return each.of != first->of; });
        Names names;
        for (auto each = first; each != last; ++each)
            if (chosen(*each)) names.push_back(name_of(*each));
        if (!named) groups.push_back(fmt::format("{} {} of {}", first->of, names.size(), last - first));
        else if (!names.empty()) groups.push_back(fmt::format("{} ({})", first->of, listed(names)));
        first = last;
    }
    return groups;
}

std::vector<ProofExplanation::ModelElement> of_kind(const ProofExplanation& why, ProofExplanation::Kind kind) {
    std::vector<ProofExplanation::ModelElement> found;
    for (const ProofExplanation::ModelElement& element : why.things)
        if (element.kind == kind) found.push_back(element);
    return found;
}

/// Returns text about the change of the model that removes one of the named elements, such as `if t1 or t2 is never
/// cleared`.
std::string without(ProofExplanation::Kind kind, const Names& names) {
    const std::string list = listed(names, " or ");
    switch (kind) {
    case ProofExplanation::Kind::Transition: return fmt::format("if {} is never cleared", list);
    case ProofExplanation::Kind::Step: return fmt::format("if step {} has no effect", list);
    case ProofExplanation::Kind::Term:
    case ProofExplanation::Kind::Statement: return "without " + list;
    case ProofExplanation::Kind::Guard: return "without the guard of " + list;
    case ProofExplanation::Kind::Edge: return fmt::format("if {} is never taken", list);
    }
    return {};
}

/// Texts about the elements of charts that the proof of a property needs (`fails`), and about the elements for which
/// the need is undecided.
struct OfCharts {
    Names fails = {};  ///< one text for each type of needed element, such as `if t1 or t2 is never cleared`
    Names open = {};
};

OfCharts of_charts(const ProofExplanation& why, const ProofExplanation::ProofCore& ground, std::size_t most) {
    OfCharts result;
    for (const ProofExplanation::Kind kind : kinds) {
        if (of_plant(kind)) continue;
        Names needed, open;
        for (const ProofExplanation::ModelElement& element : of_kind(why, kind)) {
            if (has(element.needed_by, ground.property)) needed.push_back(name_of(element));
            if (has(element.open, ground.property)) open.push_back(name_of(element));
        }
        if (!needed.empty()) result.fails.push_back(without(kind, needed));
        const bool many = open.size() > most;
        for (const std::string& name : many ? Names{} : open)
            result.open.push_back(fmt::format("{} {}", word(kind), name));
        if (many) result.open.push_back(fmt::format("{} {}s", open.size(), word(kind)));
    }
    return result;
}

std::string parts_text(const ProofExplanation::ProofCore& ground) {
    Names parts;
    for (const std::string& name : ground.parts) {
        const bool timed = std::ranges::find(ground.timings, name) != ground.timings.end();
        parts.push_back(name + (timed ? " with its timing" : ""));
    }
    if (parts.empty()) return "holds for any behaviour of the plant and the timers";
    return "of the plant and the timers, the property depends only on " + listed(parts, " and ");
}

void print_folded(const std::string& text, std::ostream& out) {
    bool first = true;
    for (const std::string& line : wrapped(text, widest_line - 4)) {
        out << (first ? "" : "    ") << printable(line) << '\n';
        first = false;
    }
}

std::string plural(ProofExplanation::Kind kind) {
    switch (kind) {
    case ProofExplanation::Kind::Transition: return "transitions";
    case ProofExplanation::Kind::Step: return "steps with actions";
    case ProofExplanation::Kind::Term: return "terms of conditions";
    case ProofExplanation::Kind::Statement: return "statements";
    case ProofExplanation::Kind::Guard: return "guards of the plant";
    case ProofExplanation::Kind::Edge: return "edges of the plant";
    }
    return {};
}

bool is_needed(const ProofExplanation::ModelElement& element) { return !element.needed_by.empty(); }
bool is_free(const ProofExplanation::ModelElement& element) {
    return element.needed_by.empty() && element.open.empty();
}

/// Returns text about the elements of one type: the number of elements that the proof of at least one property needs,
/// and the names of the elements that no proof needs.
std::string coverage_text(ProofExplanation::Kind kind, const std::vector<ProofExplanation::ModelElement>& elements,
                          bool verbose) {
    const auto covered = std::ranges::count_if(elements, is_needed), free = std::ranges::count_if(elements, is_free);
    const auto open = std::ssize(elements) - covered - free;
    std::string text = fmt::format("{}: {} of {}", plural(kind), covered, elements.size());
    if (open > 0) text += fmt::format(", {} undecided", open);
    const bool some = free > 0 && free < std::ssize(elements);
    if (of_plant(kind) && some) text += fmt::format(" ({})", listed(by_instance(elements, is_needed, false)));
    Names names;
    for (const ProofExplanation::ModelElement& element : elements)
        if (!of_plant(kind) && is_free(element)) names.push_back(name_of(element));
    if (of_plant(kind) && verbose) names = by_instance(elements, is_free, true);
    if (names.empty() || !some) return text;
    const std::string_view who = kind == ProofExplanation::Kind::Guard ? "no property of all states" : "no property";
    return fmt::format("{}; {} fails {}", text, who, without(kind, names));
}

std::string proof_core_text(const ProofExplanation& why, const ProofExplanation::ProofCore& ground, bool verbose) {
    const std::size_t most = verbose ? std::max(why.things.size(), ground.open.size()) : most_open;
    OfCharts charts = of_charts(why, ground, most);
    Names sentences;
    if (!charts.fails.empty()) sentences.push_back("fails " + listed(charts.fails, ", or "));
    else if (charts.open.empty())
        sentences.emplace_back(of_kind(why, ProofExplanation::Kind::Statement).empty()
                                   ? "no single transition, step or term of the charts is needed"
                                   : "no single transition or statement is needed");
    if (ground.about_states && ground.open.empty()) sentences.push_back(parts_text(ground));
    if (!ground.open.empty() && !ground.parts.empty())
        sentences.push_back("of the plant and the timers, the property depends on " + listed(ground.parts) +
                            ", and possibly on undecided elements");
    if (ground.open.size() > most) charts.open.push_back(fmt::format("{} instances and timers", ground.open.size()));
    else charts.open.insert(charts.open.end(), ground.open.begin(), ground.open.end());
    if (!charts.open.empty()) sentences.push_back("undecided: " + listed(charts.open));
    if (ground.vacuous) sentences.emplace_back("vacuous: the premise is never true");
    return listed(sentences, "; ", "; ");
}

/// Prints the proof cores. Properties with the same proof core text share one entry, which is printed at the position
/// of the first of these properties.
void print_proof_cores(const ProofExplanation& why, bool verbose, std::ostream& out) {
    std::vector<std::pair<Names, std::string>> sentences;
    for (const ProofExplanation::ProofCore& ground : why.grounds) {
        const std::string words = proof_core_text(why, ground, verbose);
        auto same = std::ranges::find(sentences, words, &std::pair<Names, std::string>::second);
        if (same == sentences.end()) same = sentences.insert(sentences.end(), {{}, words});
        same->first.push_back(ground.property);
    }
    for (const auto& [names, words] : sentences) print_folded(listed(names) + ": " + words, out);
}

}  // namespace

void name_places(ProofExplanation& why, const Sources& sources) {
    const auto is_statement = [](const ProofExplanation::ModelElement& element) {
        return element.kind == ProofExplanation::Kind::Statement && element.origin.source.valid();
    };
    std::set<std::uint32_t> files;
    for (const ProofExplanation::ModelElement& element : why.things)
        if (is_statement(element)) files.insert(element.origin.source.index);
    for (ProofExplanation::ModelElement& element : why.things)
        if (is_statement(element) && sources.contains(element.origin.source))
            element.of =
                files.size() > 1
                    ? file_and_line(sources, element.origin)
                    : fmt::format("line {}", place(sources[element.origin.source].text, element.origin.begin).line);
}

void print_why(const ProofExplanation& why, bool verbose, std::ostream& out) {
    if (why.grounds.empty()) {
        out << "\n"
               "proof dependencies: no declared property holds\n";
        return;
    }
    out << fmt::format(
        "\n"
        "proof dependencies ({} additional {}):\n",
        why.searches, why.searches == 1 ? "search" : "searches");
    print_proof_cores(why, verbose, out);
    if (!why.unneeded_parts.empty())
        print_folded("no property of all states depends on " + listed(why.unneeded_parts, " or "), out);
    out << "\n"
           "proof coverage of these properties:\n";
    for (const ProofExplanation::Kind kind : kinds)
        if (const auto elements = of_kind(why, kind); !elements.empty())
            print_folded(coverage_text(kind, elements, verbose), out);
    if (!why.ended.empty()) out << "incomplete: " << why.ended << '\n';
}

nlohmann::ordered_json why_json(const ProofExplanation& why) {
    const auto needed = [&](ProofExplanation::Kind kind, const std::string& property) {
        Json names = Json::array();
        for (const ProofExplanation::ModelElement& element : why.things)
            if (element.kind == kind && has(element.needed_by, property)) names.push_back(element.name);
        return names;
    };
    Json grounds = Json::array(), unneeded = Json::array(), elements = Json::array();
    for (const ProofExplanation::ProofCore& ground : why.grounds) {
        Names open = of_charts(why, ground, why.things.size()).open;
        open.insert(open.end(), ground.open.begin(), ground.open.end());
        grounds.push_back({{"property", ground.property},
                           {"transitions", needed(ProofExplanation::Kind::Transition, ground.property)},
                           {"steps", needed(ProofExplanation::Kind::Step, ground.property)},
                           {"parts", ground.about_states ? Json(ground.parts) : Json(nullptr)},
                           {"timings", ground.about_states ? Json(ground.timings) : Json(nullptr)},
                           {"open", open},
                           {"vacuous", ground.vacuous}});
    }
    for (const ProofExplanation::ModelElement& element : why.things) {
        if (element.kind == ProofExplanation::Kind::Transition && element.needed_by.empty() && element.open.empty())
            unneeded.push_back(element.name);
        elements.push_back({{"kind", word(element.kind)},
                            {"name", element.name + nth_of(element)},
                            {"of", element.of.empty() ? Json(nullptr) : Json(element.of)},
                            {"needed_by", element.needed_by},
                            {"open", element.open}});
    }
    return {{"properties", std::move(grounds)},
            {"unneeded_transitions", std::move(unneeded)},
            {"unneeded_parts", why.unneeded_parts},
            {"coverage", std::move(elements)},
            {"searches", why.searches},
            {"ended", why.ended.empty() ? Json(nullptr) : Json(why.ended)}};
}

}  // namespace grafverif
