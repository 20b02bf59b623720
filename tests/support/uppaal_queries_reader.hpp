// SPDX-License-Identifier: MIT
// Reads exported queries back into properties. The comment of a query identifies its pattern if several patterns have
// the same form.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "grafverif/ir/network.hpp"
#include "support/uppaal_terms.hpp"

namespace grafverif::test {

class QueryReader {
public:
    QueryReader(Network& network, TermReader terms) : network_(network), terms_(std::move(terms)) {}

    /// Adds a property for each query, and `settled` if a query reads it.
    void read(pugi::xml_node queries);

private:
    void read_query(const std::string& formula, const std::string& comment);
    void read_formula(Cursor& cursor, Property& property);
    void read_universal(Cursor& cursor, Property& property);
    bool read_exactly_one(Cursor& cursor, Property& property);
    Id<Expr> read_operand(Cursor& cursor, const Property& property);
    bool is_boolean(Id<Expr> term) const;

    Network& network_;
    TermReader terms_;
};

}  // namespace grafverif::test
