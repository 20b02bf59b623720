// SPDX-License-Identifier: MIT
// ChartInstance: the arguments of an instance of a chart. An instance is a copy of the chart's syntax tree. In the
// copy, variables replace the ports (the inputs and outputs of the chart), and values replace the constants (see
// expand.hpp). Name resolution treats the copy in the same way as any other chart.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/tree.hpp"
#include "syntax/resolve/references.hpp"
#include "syntax/resolve/terms.hpp"

namespace grafverif {

/// The syntax trees of the charts of a model, by name.
struct WrittenCharts {
    struct Entry {
        const tree::File* file = nullptr;
        const tree::Chart* chart = nullptr;
    };
    std::unordered_map<std::string, Entry> charts = {};
    std::unordered_set<std::string> in_error = {};  ///< names of charts with errors; they cannot be instantiated

    /// Returns the chart to instantiate, or null after an error. Reports the error, unless the chart itself has errors.
    const Entry* find(const tree::File& file, tree::Name name, Diagnostics& diagnostics) const;
};

struct ChartInstance {
    struct Argument {
        Span parameter = {}, where = {};  ///< positions of the argument's name and value
        std::string variable = {};        ///< bound to a port
        Id<tree::Expr> term = {};         ///< for a step variable that is bound to a port, such as `line.X1`
        TermKind kind = TermKind::Wrong;  ///< type of the value; Wrong for a variable
        std::int64_t value = 0;
        bool is_term = false;  ///< true if the value is neither a constant nor a variable, which is an error for a port
        bool used = false;
    };
    std::string name = {};
    Span where = {};        ///< position of the name of the instance
    Span chart_where = {};  ///< position of the chart's name in the declaration of the instance
    std::map<std::string, Argument, std::less<>> arguments = {};
    Recorder record = {};      ///< records the names in the arguments
    bool wrong = false;        ///< true if an error in an argument has been reported
    bool has_defaults = true;  ///< set by the expansion: true if all constants have their declared values
    bool too_large = false;    ///< set by the expansion: true if the copies are too large
};

/// Resolves the values of arguments in the declaration of an instance.
struct ArgumentReader {
    const tree::File& file;
    Diagnostics& diagnostics;
    std::function<Terms(std::string_view)> constant_terms = {};
    /// Returns the variable that a term `OWNER.NAME` denotes, such as `B[1].HERE`; empty after an error. If this
    /// function is not set, the term denotes a step variable.
    std::function<std::optional<std::string>(const tree::Expr&)> variable = {};
};

/// Resolves the arguments of an instance of `chart`. Requires arguments without index variables. The expansion later
/// reports unknown and missing arguments, and terms that are bound to ports.
ChartInstance read_arguments(const ArgumentReader& reader, const std::vector<tree::Argument>& arguments,
                             const WrittenCharts::Entry& chart);

/// The declared type, range and value of a constant.
struct DeclaredConstant {
    TermKind kind = TermKind::Wrong;  ///< Boolean, Integer or Duration
    std::int64_t value = 0;
    std::int64_t low = 0, high = 0;  ///< limits of an integer
    bool contains(std::int64_t other) const { return kind != TermKind::Integer || (low <= other && other <= high); }
};
/// Resolves the declaration of a constant with a value. The result is empty after every error
/// except an error about a value out of range.
std::optional<DeclaredConstant> declared_constant(const tree::File& file, const tree::Variable& written,
                                                  Diagnostics& diagnostics,
                                                  const std::function<Terms(std::string_view)>& constant_terms);

}  // namespace grafverif
