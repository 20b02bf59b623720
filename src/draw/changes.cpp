// SPDX-License-Identifier: MIT
#include "draw/changes.hpp"

#include <map>
#include <string>
#include <vector>

namespace grafverif::draw {

namespace {

/// Returns a text that identifies the content of a drawn element, independently of its position. For a link, the
/// content consists of its ends and its direction. The text is empty if the drawn element does not represent an element
/// of the chart.
std::string content(const Drawing::Element& element) {
    if (!element.id.empty()) return element.classes + '\n' + element.title;
    if (!element.classes.starts_with("link")) return {};
    std::string text = "link";
    for (const auto& [name, value] : element.data) text += '\n' + name + ' ' + value;
    return text;
}

}  // namespace

void mark_changes(Drawing& drawing, const Drawing& other) {
    std::map<std::string, int> there;  // for each content: number of elements of `other` that are not matched yet
    std::map<std::string, std::string> by_id;
    for (const Drawing::Element& element : other.elements) {
        ++there[content(element)];
        if (!element.id.empty()) by_id.emplace(element.id, content(element));
    }
    std::vector<Drawing::Element*> moved;
    for (Drawing::Element& element : drawing.elements) {
        const std::string element_text = content(element);
        if (element_text.empty()) continue;
        const auto found = by_id.find(element.id);
        if (found != by_id.end() && found->second == element_text) --there[element_text];
        else moved.push_back(&element);
    }
    for (Drawing::Element* element : moved)
        if (there[content(*element)]-- <= 0) element->classes += " changed";
}

}  // namespace grafverif::draw
