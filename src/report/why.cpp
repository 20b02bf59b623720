// SPDX-License-Identifier: MIT
#include "report/why.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

std::string listed(const Names& names, std::string_view last = ", ") {
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k)
        text += (k == 0 ? "" : k + 1 == names.size() ? std::string(last) : ", ") + names[k];
    return text;
}

std::string transitions_words(const Why::Ground& ground) {
    if (ground.transitions.empty()) return "no transition by itself is needed for it";
    return fmt::format("it fails where {} is never cleared", listed(ground.transitions, " or "));
}

std::string parts_words(const Why::Ground& ground) {
    Names parts;
    for (const std::string& name : ground.parts) {
        const bool timed = std::ranges::find(ground.timings, name) != ground.timings.end();
        parts.push_back(name + (timed ? " with its times" : ""));
    }
    if (parts.empty()) return "whatever the plant and the timers do, it holds";
    return fmt::format("of the plant and the timers it rests on {}: whatever the others do, it holds", listed(parts));
}

void print_folded(const std::string& text, std::ostream& out) {
    bool first = true;
    for (const std::string& line : wrapped(text, widest_line - 4)) {
        out << (first ? "" : "    ") << printable(line) << '\n';
        first = false;
    }
}

}  // namespace

void print_why(const Why& why, std::ostream& out) {
    if (why.grounds.empty()) {
        out << "\nwhy it holds: no property that the model declares does\n";
        return;
    }
    out << fmt::format("\nwhy it holds, by {} more {}:\n", why.searches, why.searches == 1 ? "search" : "searches");
    for (const Why::Ground& ground : why.grounds) {
        Names said;
        if (ground.open.empty() || !ground.transitions.empty()) said.push_back(transitions_words(ground));
        if (ground.about_states && ground.open.empty()) said.push_back(parts_words(ground));
        if (!ground.open.empty() && !ground.parts.empty())
            said.push_back("of the plant and the timers it needs, among others, " + listed(ground.parts));
        if (!ground.open.empty()) said.push_back("not decided: " + listed(ground.open));
        if (ground.never_asked) said.emplace_back("its left side never holds");
        std::string text = ground.property + ": " + said.front();
        for (std::size_t k = 1; k < said.size(); ++k) text += "; " + said[k];
        print_folded(text, out);
    }
    if (!why.unneeded_transitions.empty())
        print_folded("no property fails without transition " + listed(why.unneeded_transitions, " or "), out);
    if (!why.unneeded_parts.empty())
        print_folded("no property about all states rests on " + listed(why.unneeded_parts, " or "), out);
    if (!why.ended.empty()) out << "not all was tried: " << why.ended << '\n';
}

nlohmann::ordered_json why_json(const Why& why) {
    Json grounds = Json::array();
    for (const Why::Ground& ground : why.grounds)
        grounds.push_back({{"property", ground.property},
                           {"transitions", ground.transitions},
                           {"parts", ground.about_states ? Json(ground.parts) : Json(nullptr)},
                           {"timings", ground.about_states ? Json(ground.timings) : Json(nullptr)},
                           {"open", ground.open},
                           {"never_asked", ground.never_asked}});
    return {{"properties", std::move(grounds)},
            {"unneeded_transitions", why.unneeded_transitions},
            {"unneeded_parts", why.unneeded_parts},
            {"searches", why.searches},
            {"ended", why.ended.empty() ? Json(nullptr) : Json(why.ended)}};
}

}  // namespace grafverif
