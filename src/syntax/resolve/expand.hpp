// SPDX-License-Identifier: MIT
// Expansion: replaces replicated declarations and terms by their copies, and instances of charts by the declarations of
// their charts. The result contains neither index variables nor indices: `plant B[i] = ...` in `for i in 1..2` becomes
// two instances with the names `B[1]` and `B[2]`. Name resolution continues with the result, so that copies obey the
// same rules as declarations that are written out.
//
// Copies keep the positions of the original text. Declarations are expanded in the order of the text; a range or an
// index may read the constants that are declared before it. The cost is linear in the size of the result, which is
// limited.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/tree.hpp"
#include "syntax/resolve/chart_instance.hpp"
#include "syntax/resolve/references.hpp"
#include "syntax/resolve/terms.hpp"

namespace grafverif {

/// Maximum number of copies, names and terms in the expansions of a model. A long name or text counts once more for
/// every 64 bytes.
inline constexpr std::uint64_t largest_expansion = 1'000'000;

struct Expansion {
    const tree::File& file;
    tree::File& copy;  ///< receives names and terms of the result; must be empty
    Diagnostics& diagnostics;
    Recorder record = {};
    Span owner = {};  ///< name of the expanded declaration
    /// Resolves terms of `copy` that read only constants; the argument is named in errors.
    std::function<Terms(std::string_view)> constant_terms = {};
    /// Called for each group of constants of the result, if set, before the following declarations are expanded.
    std::function<void(const tree::Variables&)> constants = {};
    /// If set, the number of elements in earlier expansions of the model, to which the elements of this one are added.
    std::uint64_t* copied = nullptr;
    const WrittenCharts* charts = nullptr;  ///< the charts of instances; null if there are none
    ChartInstance* instance = nullptr;      ///< if not null, the chart is copied to this instance
    /// Result: true if an instance is missing because its chart has an error, which has been reported.
    bool incomplete = false;
    /// Result: the first position of each index variable.
    std::map<std::string, Span, std::less<>> indices = {};
};

/// Return the declaration without replications, parameters and instances. After an error, parts may be missing.
tree::Chart expanded(Expansion& expansion, const tree::Chart& written);
tree::Component expanded(Expansion& expansion, const tree::Component& written);
tree::ClosedLoop expanded(Expansion& expansion, const tree::ClosedLoop& written);

/// Calls `resolve` with the declaration, or with its expansion if it contains replications. Does not call it if there
/// is an error in a range or an index, unless names are also recorded in text with errors.
template <class Written, class Resolve>
void resolve_expanded(Expansion& expansion, const Written& written, const Resolve& resolve) {
    if (!written.replicated && expansion.instance == nullptr) return resolve(written);
    const std::size_t errors = expansion.diagnostics.errors();
    const Written all = expanded(expansion, written);
    const bool complete = expansion.diagnostics.errors() == errors && !expansion.incomplete;
    if (complete || expansion.record.beyond_errors()) resolve(all);
}

/// Reports each index variable with the name of another declaration. `declared` returns the position of a name.
void check_indices(const Expansion& expansion, const std::function<std::optional<Span>(std::string_view)>& declared);

/// Reports that the declaration `name` has the name of an earlier one at `first`, which may be another copy of it.
Diagnostic duplicate(tree::Name name, std::string_view kind, std::string_view text, Span first);

/// While it exists, diagnostics state the index values and the instance of the copy in which `name` is declared, if it
/// is in a copy.
class InCopy {
public:
    InCopy(Diagnostics& diagnostics, const tree::File& file, tree::Name name);
    /// `copy` is the number of the copy plus one; 0 if the diagnostics do not concern a copy. Requires that `file`
    /// outlives the object.
    InCopy(Diagnostics& diagnostics, const tree::File& file, std::uint32_t copy);
    InCopy(const InCopy&) = delete;
    InCopy& operator=(const InCopy&) = delete;
    ~InCopy();

private:
    Diagnostics* diagnostics_;
    Diagnostics::Context outer_ = {};
};

}  // namespace grafverif
