// SPDX-License-Identifier: MIT
// Expansion: replaces replicated declarations and terms by their copies, and instances of charts by the declarations of
// their charts. The result contains neither index variables nor indices: `plant B[i] = ...` in `for i in 1..2` becomes
// two instances with the names `B[1]` and `B[2]`. Name resolution continues with the result, so that the same rules
// apply to copies and to declarations without replication.
//
// Copies have the positions of the original text. Declarations are expanded in the order of the text, so that a range
// or an index may read the constants that precede it. The cost is linear in the size of the result, and this size is
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

/// Maximum total number of copies, names and terms in the expansions of a model. A long name or text counts once more
/// for every 64 bytes.
inline constexpr std::uint64_t largest_expansion = 1'000'000;

struct Expansion {
    const tree::File& file;
    tree::File& copy;  ///< receives names and terms of the result; must be empty
    Diagnostics& diagnostics;
    Recorder record = {};
    Span owner = {};  ///< position of the name of the expanded declaration

    /// Returns a resolver of terms of `copy` that read only constants. The argument describes the term in messages.
    std::function<Terms(std::string_view)> constant_terms = {};
    /// If set, the expansion calls this function for each group of constants of the result, before it expands the
    /// following declarations.
    std::function<void(const tree::Variables&)> constants = {};
    /// If set, the number of elements in earlier expansions of the model. This expansion adds the number of its
    /// elements.
    std::uint64_t* copied = nullptr;
    const WrittenCharts* charts = nullptr;  ///< the charts of instances; null if there are none
    ChartInstance* instance = nullptr;      ///< if not null: the instance to which the chart is copied

    /// Result: true if an instance is missing because its chart has an error. This error has been reported.
    bool incomplete = false;
    /// Result: the first position of each index variable.
    std::map<std::string, Span, std::less<>> indices = {};
};

/// Return the declaration without replications, constants of charts, and chart instances. After an error, parts of the
/// result may be missing.
tree::Chart expanded(Expansion& expansion, const tree::Chart& written);
tree::Component expanded(Expansion& expansion, const tree::Component& written);
tree::ClosedLoop expanded(Expansion& expansion, const tree::ClosedLoop& written);

/// Calls `resolve` with the declaration, or with its expansion if it contains replications. After an error in a range
/// or an index, does not call `resolve`, unless names are also recorded in text with errors.
template <class Written, class Resolve>
void resolve_expanded(Expansion& expansion, const Written& written, const Resolve& resolve) {
    if (!written.replicated && expansion.instance == nullptr) return resolve(written);
    const std::size_t errors = expansion.diagnostics.errors();
    const Written all = expanded(expansion, written);
    const bool complete = expansion.diagnostics.errors() == errors && !expansion.incomplete;
    if (complete || expansion.record.beyond_errors()) resolve(all);
}

/// Reports each index variable that has the name of another declaration. `declared` returns the position of the
/// declaration of a name.
void check_indices(const Expansion& expansion, const std::function<std::optional<Span>(std::string_view)>& declared);

/// Returns the error that the declaration `name` has the name of an earlier declaration. `first` is the position of the
/// earlier declaration, which may be another copy of the same declaration.
Diagnostic duplicate(tree::Name name, std::string_view kind, std::string_view text, Span first);

/// Context for diagnostics: while the object exists, diagnostics state the index values and the instance of the copy in
/// which a name is declared.
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
