// SPDX-License-Identifier: MIT
// AgrafeReader: context of the functions that convert an AGRAFE document to a syntax tree. The context contains the
// elements of the document and their names.
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

// The elements of an AGRAFE document and the targets of its references.

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
    std::size_t partial = 0;  ///< index of the enclosing partial chart; for a partial chart, its own index
    std::string name = {};    ///< name of the element in the input language; set by the reader
    std::vector<std::size_t> in = {}, out = {};  ///< predecessors and successors through arcs
};

class AgrafeIndex {
public:
    using Kind = AgrafeEntity::Kind;

    /// Traverses the complete document. All partial charts, including nested ones, are stored in one list.
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
    std::unordered_map<std::string, std::size_t> namesakes = {};  ///< for each name: number of steps with this name
    std::vector<OpenInteger> integers = {};
    std::unordered_set<Id<tree::Word>> without_kind = {};  ///< variables without a declared type

    Diagnostics& diagnostics() { return draft.diagnostics(); }

    /// Returns the index of the element to which `attribute` of `node` refers, if `accepts` is true for the type of
    /// this element. Reports a missing or dangling reference; `what` describes the accepted type in messages.
    std::optional<std::size_t> reference(pugi::xml_node node, std::string_view attribute, std::string_view what,
                                         bool (*accepts)(AgrafeEntity::Kind));
    /// Returns the indices of all elements in a list of references.
    std::vector<std::size_t> references(pugi::xml_node node, std::string_view attribute, std::string_view what,
                                        bool (*accepts)(AgrafeEntity::Kind));
    /// Returns the integer value of an attribute, or `otherwise` if the value is missing or invalid. Reports an invalid
    /// value.
    std::int64_t number(pugi::xml_node node, std::string_view attribute, std::int64_t otherwise);
    bool flag(pugi::xml_node node, std::string_view attribute) { return xml.flag(node, attribute, diagnostics()); }
};

// -- terms.cpp
/// Converts a term; the result is invalid after an error.
Id<tree::Expr> agrafe_term(AgrafeReader& reader, pugi::xml_node term);
/// The times of a transition or an action. Only Kind::Dependent (type timeDependent in AGRAFE) represents a time
/// condition `t1/term/t2`.
struct AgrafeTime {
    enum class Kind { None, Dependent, Delayed, Limited };
    Kind kind = Kind::None;
    std::int64_t rise_ms = 0, fall_ms = 0;
};
AgrafeTime agrafe_time(AgrafeReader& reader, pugi::xml_node node);
/// Returns the time condition `t1/term/t2` with the times t1 and t2 of `time`.
Id<tree::Expr> timed(AgrafeReader& reader, const AgrafeTime& time, Id<tree::Expr> term, Span where);

// -- actions.cpp
/// Returns, for each element of the document, its actions. Only steps have actions.
std::vector<std::vector<tree::Action>> agrafe_actions(AgrafeReader& reader);

// -- links.cpp
/// Sets `in` and `out` of every element according to the arcs. Reports arcs that are not allowed.
void read_arcs(AgrafeReader& reader);
/// Returns the steps upstream (`backwards`) or downstream of a transition, through synchronizations.
std::vector<std::size_t> linked_steps(AgrafeReader& reader, std::size_t transition, bool backwards);

}  // namespace grafverif
