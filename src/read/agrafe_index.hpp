// SPDX-License-Identifier: MIT
// What an AGRAFE document consists of, and what its references name.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "read/xml.hpp"

namespace grafverif {

struct AgrafeEntity {
    enum class Kind { Main, Partial, Expansion, Step, Enclosing, Macro, Entry, Exit, Transition, Synchronization, Action, Declaration };
    Kind kind = Kind::Main;
    pugi::xml_node node = {};
    std::size_t partial = 0;      ///< the partial chart it belongs to; of a partial chart: itself
    std::string name = {};        ///< in our language; set by the reader
    std::vector<std::size_t> in = {}, out = {};   ///< arcs: entities before and after it
};

class AgrafeIndex {
public:
    using Kind = AgrafeEntity::Kind;

    /// Walks the whole document; partial charts within partial charts stand beside them.
    explicit AgrafeIndex(pugi::xml_node root);

    std::vector<AgrafeEntity>& all() { return entities_; }
    AgrafeEntity& operator[](std::size_t entity) { return entities_[entity]; }
    const AgrafeEntity& operator[](std::size_t entity) const { return entities_[entity]; }
    std::optional<std::size_t> find(const std::string& reference) const;

private:
    std::size_t add(Kind kind, pugi::xml_node node, std::size_t partial, std::string path);

    std::vector<AgrafeEntity> entities_ = {};
    std::unordered_map<std::string, std::size_t> paths_ = {};
};

bool is_step(AgrafeEntity::Kind kind);
inline bool is_declaration(AgrafeEntity::Kind kind) { return kind == AgrafeEntity::Kind::Declaration; }
bool is_partial(AgrafeEntity::Kind kind);

}  // namespace grafverif
