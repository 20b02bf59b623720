// SPDX-License-Identifier: MIT
// AgrafeReader: an AGRAFE document while it is read: what its entities are called, and how their parts become ours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "read/draft.hpp"
#include "read/integer_ranges.hpp"
#include "read/xml.hpp"

namespace grafverif {

// What an AGRAFE document consists of, and what its references name.

struct AgrafeEntity {
    enum class Kind {
        Main,
        Partial,
        Expansion,
        Step,
        Enclosing,
        Macro,
        Entry,
        Exit,
        Transition,
        Synchronization,
        Action,
        Declaration
    };
    Kind kind = Kind::Main;
    pugi::xml_node node = {};
    std::size_t partial = 0;                     ///< the partial chart it belongs to; of a partial chart: itself
    std::string name = {};                       ///< in our language; set by the reader
    std::vector<std::size_t> in = {}, out = {};  ///< arcs: entities before and after it
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

struct AgrafeReader {
    const Xml& xml;
    AgrafeIndex index;
    Draft& draft;
    std::string chart = {};
    std::unordered_map<std::string, std::size_t> namesakes = {};  ///< steps of a name, over all partial charts
    std::vector<OpenInteger> integers = {};
    std::unordered_set<Id<tree::Word>> without_kind = {};  ///< variables of no declared kind: inputs by default

    Diagnostics& diagnostics() { return draft.diagnostics(); }

    /// The entity that `attribute` of `node` names, if it is one of `kinds`. Reports a missing or dangling one; `what`
    /// is the kind in words.
    std::optional<std::size_t> reference(pugi::xml_node node, std::string_view attribute, std::string_view what,
                                         bool (*accepts)(AgrafeEntity::Kind));
    /// All that a list of references names.
    std::vector<std::size_t> references(pugi::xml_node node, std::string_view attribute, std::string_view what,
                                        bool (*accepts)(AgrafeEntity::Kind));
    /// A whole number; `otherwise` where it is missing, or wrong and reported.
    std::int64_t number(pugi::xml_node node, std::string_view attribute, std::int64_t otherwise);
    bool flag(pugi::xml_node node, std::string_view attribute) { return xml.flag(node, attribute, diagnostics()); }
};

// -- agrafe_terms.cpp
/// Not valid after an error.
Id<tree::Expr> agrafe_term(AgrafeReader& reader, pugi::xml_node term);
/// What a transition or action with times waits for; `t1/term/t2` where its type is timeDependent.
struct AgrafeTime {
    enum class Kind { None, Dependent, Delayed, Limited };
    Kind kind = Kind::None;
    std::int64_t rise_ms = 0, fall_ms = 0;
};
AgrafeTime agrafe_time(AgrafeReader& reader, pugi::xml_node node);
/// `t1/term/t2`.
Id<tree::Expr> timed(AgrafeReader& reader, const AgrafeTime& time, Id<tree::Expr> term, Span where);

// -- agrafe_actions.cpp
/// The actions of each entity that is a step.
std::vector<std::vector<tree::Action>> agrafe_actions(AgrafeReader& reader);

// -- agrafe_links.cpp
/// Sets `in` and `out` of every entity from the arcs; reports arcs that lead where none may.
void read_arcs(AgrafeReader& reader);
/// The steps before (`backwards`) or after a transition, through synchronizations.
std::vector<std::size_t> linked_steps(AgrafeReader& reader, std::size_t transition, bool backwards);

}  // namespace grafverif
