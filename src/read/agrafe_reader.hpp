// SPDX-License-Identifier: MIT
// AgrafeReader: an AGRAFE document while it is read: what its entities are called, and how their parts become ours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "read/agrafe_index.hpp"
#include "read/draft.hpp"
#include "read/integer_ranges.hpp"
#include "read/xml.hpp"

namespace grafverif {

struct AgrafeReader {
    const Xml& xml;
    AgrafeIndex index;
    Draft& draft;
    std::string chart = {};
    std::unordered_map<std::string, std::size_t> namesakes = {};   ///< steps of a name, over all partial charts
    std::vector<OpenInteger> integers = {};
    std::unordered_set<Id<tree::Word>> without_kind = {};   ///< variables of no declared kind: inputs by default

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
    bool flag(pugi::xml_node node, std::string_view attribute);
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
