// SPDX-License-Identifier: MIT
// Draft: builds the syntax tree of a chart that is imported from another format. All elements keep their positions in
// the imported file, so that later stages report errors at these positions. A comment refers to a position in the
// imported file; `laid_out` later determines the line of the comment in the generated text.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "support/unique_names.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

class Draft {
public:
    Draft(Id<Source> source, bool lossy, Diagnostics& diagnostics);
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    tree::Name name(std::string_view text, Span where) { return {words_.intern(text), where}; }
    std::string_view text(tree::Name name) const { return file_.text(name); }

    Id<tree::Expr> constant(bool value, Span where);
    Id<tree::Expr> number(std::int64_t value, Span where);
    Id<tree::Expr> duration(std::int64_t milliseconds, Span where);
    Id<tree::Expr> variable(std::string_view name, Span where);
    Id<tree::Expr> member(std::string_view owner, std::string_view name, Span where);
    /// Creates a node of the syntax tree. The result is invalid after an error: the term exceeds the maximum depth.
    /// `And` and `Or` have any number of operands; nested operands with the same operator are flattened.
    Id<tree::Expr> node(tree::Op op, const std::vector<Id<tree::Expr>>& operands, Span where);
    /// Returns a copy of a term. A copy is necessary because an operand belongs to exactly one node.
    Id<tree::Expr> copy(Id<tree::Expr> term);
    const tree::Expr& operator[](Id<tree::Expr> id) const { return file_.exprs[id]; }
    std::vector<Id<tree::Expr>> operands(Id<tree::Expr> id) const;

    /// Adds a comment line (`// ...`) before the element at `where` or, if `trailing` is true, at the end of the line
    /// of this element.
    void comment(Span where, std::string line, bool trailing = false);

    /// Reports a construct that cannot be imported. By default, adds an error. If `lossy` is true, adds a warning and a
    /// comment in the generated text. `hint` states the remedy.
    void refuse(Span where, std::string_view what, std::string_view hint);
    bool lossy() const { return lossy_; }
    Diagnostics& diagnostics() { return *diagnostics_; }

    const tree::File& file() const { return file_; }
    /// Sorts the variables: inputs, outputs, internal variables. Booleans without a comment share one line.
    void group_variables(tree::Chart& chart) const;
    void declare(tree::Chart chart) { file_.declarations.emplace_back(std::move(chart)); }
    tree::File take();

private:
    Id<tree::Expr> leaf(tree::Op op, Span where);

    tree::File file_ = {};
    tree::Words words_;
    Diagnostics* diagnostics_;
    bool lossy_ = false;
    std::size_t errors_ = 0;  ///< number of errors when this draft was created
};

/// Generates unique legal names in one scope. Adds a warning for each name that must be changed.
class LegalNames {
public:
    enum class Kind { Variable, Label, Chart };

    LegalNames(Kind kind, Draft& draft) : kind_(kind), draft_(&draft) {}

    /// Returns a legal unused name that is as similar to `preferred` as possible.
    std::string make(std::string_view preferred, Span where);
    /// Returns a generated legal name that is similar to `preferred`, without a warning.
    std::string invent(std::string_view preferred);
    /// Reserves a legal name, so that no other element gets it.
    void reserve(std::string_view name) { taken_.take(std::string(name)); }

private:
    Kind kind_;
    Draft* draft_;
    UniqueNames taken_ = {};
};

}  // namespace grafverif
