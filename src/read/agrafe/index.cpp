// SPDX-License-Identifier: MIT
#include <utility>

#include "read/agrafe/reader.hpp"

namespace grafverif {

namespace {

using Kind = AgrafeEntity::Kind;

/// Returns the type of an element, for example `EnclosingStep` for `xsi:type="grafcet:EnclosingStep"`.
std::string type_of(pugi::xml_node node) { return std::string(local_name(attribute(node, "type").value())); }

std::optional<Kind> kind_of(pugi::xml_node node) {
    const std::string_view feature = local_name(node.name());
    if (feature == "steps") return type_of(node) == "EnclosingStep" ? Kind::Enclosing : Kind::Step;
    if (feature == "transitions") return Kind::Transition;
    if (feature == "synchronizations") return Kind::Synchronization;
    if (feature == "macrosteps") return Kind::Macro;
    if (feature == "entryStep") return Kind::Entry;
    if (feature == "exitStep") return Kind::Exit;
    if (feature == "actionTypes") return Kind::Action;
    if (feature == "partialGrafcets") return type_of(node) == "MacrostepExpansion" ? Kind::Expansion : Kind::Partial;
    return {};
}

/// True for features that have a single element. References contain no index for these features.
bool is_single(std::string_view feature) {
    return feature == "entryStep" || feature == "exitStep" || feature == "variableDeclarationContainer";
}

}  // namespace

bool is_step(Kind kind) {
    return kind == Kind::Step || kind == Kind::Enclosing || kind == Kind::Macro || kind == Kind::Entry ||
           kind == Kind::Exit;
}

bool is_partial(Kind kind) { return kind == Kind::Main || kind == Kind::Partial || kind == Kind::Expansion; }

std::size_t AgrafeIndex::add(Kind kind, pugi::xml_node node, std::size_t partial, std::string path) {
    const std::size_t entity = entities_.size();
    entities_.push_back({kind, node, partial, {}, {}, {}});
    if (const pugi::xml_attribute id = node.attribute("xmi:id")) paths_.emplace(id.value(), entity);
    paths_.emplace(std::move(path), entity);
    return entity;
}

AgrafeIndex::AgrafeIndex(pugi::xml_node root) {
    struct Open {
        std::size_t partial = 0;
        std::string path = {};
    };
    std::vector<Open> open = {{add(Kind::Main, root, 0, "/"), "/"}};
    for (std::size_t i = 0; i < open.size(); ++i) {
        const auto [partial, path] = open[i];
        std::unordered_map<std::string_view, std::size_t> counts;
        const pugi::xml_node grafcet = entities_[partial].node;
        for (const pugi::xml_node& node : grafcet.children()) {
            if (node.type() != pugi::node_element) continue;
            const std::string_view feature = local_name(node.name());
            std::string here = path + "/@" + std::string(feature);
            if (!is_single(feature)) here += '.' + std::to_string(counts[feature]++);
            if (feature == "variableDeclarationContainer") {
                std::size_t number = 0;
                for (const pugi::xml_node& declaration : node.children())
                    if (is(declaration, "variableDeclarations"))
                        add(Kind::Declaration, declaration, partial,
                            here + "/@variableDeclarations." + std::to_string(number++));
            }
            const auto kind = kind_of(node);
            if (!kind) continue;
            const std::size_t entity = add(*kind, node, is_partial(*kind) ? entities_.size() : partial, here);
            if (is_partial(*kind)) open.push_back({entity, here});
        }
    }
}

std::optional<std::size_t> AgrafeIndex::find(const std::string& reference) const {
    const std::size_t hash = reference.find('#');
    const auto found = paths_.find(hash == std::string::npos ? reference : reference.substr(hash + 1));
    return found == paths_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace grafverif
