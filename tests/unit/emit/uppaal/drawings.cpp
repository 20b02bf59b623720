// SPDX-License-Identifier: MIT
#include "unit/emit/uppaal/drawings.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <string_view>
#include <vector>

namespace grafverif::test {
namespace {

struct Box {
    int left = 0, top = 0, right = 0, bottom = 0;
    std::string what = {};
};

Box text_box(const pugi::xml_node node) {
    std::string_view text = node.child_value();
    int width = 0, lines = 0;
    for (bool more = true; more; ++lines) {
        const std::size_t end = text.find('\n');
        width = std::max(width, static_cast<int>(text.substr(0, end).size()));
        more = end != std::string_view::npos;
        if (more) text.remove_prefix(end + 1);
    }
    const int x = node.attribute("x").as_int(), y = node.attribute("y").as_int();
    return {x, y, x + 8 * width, y + 16 * lines, node.child_value()};
}

std::vector<Box> boxes(const pugi::xml_node automaton) {
    std::vector<Box> list;
    for (const pugi::xml_node location : automaton.children("location")) {
        const int x = location.attribute("x").as_int(), y = location.attribute("y").as_int();
        list.push_back({x - 12, y - 12, x + 12, y + 12, std::string("location ") + location.child_value("name")});
        if (location.child("name")) list.push_back(text_box(location.child("name")));
        for (const pugi::xml_node label : location.children("label")) list.push_back(text_box(label));
    }
    for (const pugi::xml_node edge : automaton.children("transition"))
        for (const pugi::xml_node label : edge.children("label")) list.push_back(text_box(label));
    return list;
}

}  // namespace

std::string overlaps(const std::string& xml) {
    pugi::xml_document document;
    if (!document.load_string(xml.c_str())) return "not well-formed";
    std::string found;
    for (const pugi::xml_node automaton : document.child("nta").children("template")) {
        std::vector<Box> list = boxes(automaton);
        std::ranges::sort(list, {}, &Box::left);
        for (auto a = list.begin(); a != list.end(); ++a)
            for (auto b = a + 1; b != list.end() && b->left < a->right; ++b)
                if (a->top < b->bottom && b->top < a->bottom)
                    found +=
                        std::string(automaton.child_value("name")) + ": `" + a->what + "` overlaps `" + b->what + "`\n";
    }
    return found;
}

}  // namespace grafverif::test
