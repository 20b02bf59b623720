// SPDX-License-Identifier: MIT
// Prints the textual parts of a UPPAAL project: terms, constraints and assignments with the names of one template, and
// the three programs of a project (global declarations, declarations of a template, system definition).
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "emit/uppaal/names.hpp"
#include "grafverif/ir/network.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::uppaal {

/// Prints terms in UPPAAL syntax. Parameters belong to the template `automaton`. Without a template, as in queries, a
/// term may contain location tests.
class Terms {
public:
    Terms(const Network& network, const Names& names, Id<Network::Template> automaton = {});

    void write(std::ostream& out, Id<Expr> root) const;
    std::string text(Id<Expr> root) const;
    /// Returns the term in parentheses, unless it binds as tightly as a name.
    std::string bracketed(Id<Expr> root) const;
    /// Returns clock constraints as text, such as `t <= STEP && u <= 3`.
    std::string text(const std::vector<Network::ClockConstraint>& constraints) const;
    /// Returns an assignment as text, such as `x = a || b`.
    std::string text(const Network::Assignment& assignment) const;
    /// Prints the assignment as a statement. A conditional value becomes an `if` statement.
    void write_statement(std::ostream& out, const Network::Assignment& assignment) const;

private:
    const Network* network_;
    const Names* names_;
    Id<Network::Template> automaton_;
    LeafPrinter leaf_;
};

/// A data guard that is too long for a label and becomes a function of its template.
struct GuardFunction {
    std::string name = {};
    std::string body = {};
};

void write_global_declarations(std::ostream& out, const Network& network, const Names& names);
void write_template_declarations(std::ostream& out, const Network& network, const Names& names,
                                 Id<Network::Template> automaton, const std::vector<GuardFunction>& guards);
/// Returns the parameters of a template as text, such as `bool &G_IN, int[0,20] &X, const int D`.
std::string parameter_list(const Network::Template& automaton, const LocalNames& names);
void write_system(std::ostream& out, const Network& network, const Names& names);

/// Returns `text` in lines of at most `width` columns, broken after a comma or a Boolean operator.
std::vector<std::string> lines_of(std::string_view text, std::size_t width);

}  // namespace grafverif::uppaal
