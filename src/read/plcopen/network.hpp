// SPDX-License-Identifier: MIT
// PlcopenNetwork: the elements of one graphical body in PLCopen XML and the connections between them.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "read/draft.hpp"
#include "read/xml.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

struct PlcopenReader {
    const Xml& xml;
    const Sources& sources;
    Draft& draft;
    bool of_program = false;  ///< true: the result is executed as a program; false: it is converted to a chart
    st::File file = {};

    /// Reports a construct that cannot be read.
    void refuse(Span where, std::string_view what, std::string_view hint);
    bool is_codesys_program() const { return of_program && file.dialect == st::Dialect::Codesys; }
    Diagnostics& diagnostics() { return draft.diagnostics(); }
    st::Name name(const std::string& text, Span where) { return {file.intern(text), where}; }
    /// Parses an expression; invalid after an error.
    Id<st::Expr> expression(const st::Text& text);
    /// Parses statements; empty after an error.
    st::Block statements(const st::Text& text);
    bool flag(pugi::xml_node node, std::string_view attribute) { return xml.flag(node, attribute, diagnostics()); }
    st::Expr& node(Id<st::Expr> id) { return file.exprs[id]; }
    Id<st::Expr> make(st::Op op, const std::vector<Id<st::Expr>>& operands, Span where);
};

struct PlcopenNetwork {
    pugi::xml_node body = {};                                    ///< element `SFC`, `LD` or `FBD`
    std::vector<pugi::xml_node> elements = {};                   ///< elements in the order of the file
    std::unordered_map<std::string, pugi::xml_node> by_id = {};  ///< elements by `localId`

    pugi::xml_node find(const std::string& id) const;
};

/// Returns the elements of a body. Reports duplicate ids.
PlcopenNetwork network_of(PlcopenReader& reader, pugi::xml_node body);

/// A connection: the element at which it begins, and the name of its output. An empty name denotes the first output.
struct PlcopenLine {
    pugi::xml_node source = {};
    std::string output = {};
};

/// True if a connection ends at `point`, even if the element at which it begins is missing.
bool is_connected(pugi::xml_node point);

/// Returns the connections that end at the elements `connectionPointIn` of `point`. Reports dangling connections.
std::vector<PlcopenLine> lines_of(PlcopenReader& reader, const PlcopenNetwork& network, pugi::xml_node point);

/// Returns the elements at which the connections to `point` begin.
std::vector<pugi::xml_node> sources_of(PlcopenReader& reader, const PlcopenNetwork& network, pugi::xml_node point);

/// Returns the network of the chart, followed by the expansions of its macro-steps.
std::vector<st::Network> read_network(PlcopenReader& reader, const st::Unit& unit, pugi::xml_node body);

// -- conditions.cpp
/// Returns the condition of a transition. The id is invalid if the condition is omitted, or after an error.
Id<st::Expr> condition_of(PlcopenReader& reader, const st::Unit& unit, const PlcopenNetwork& network,
                          pugi::xml_node transition);

}  // namespace grafverif
