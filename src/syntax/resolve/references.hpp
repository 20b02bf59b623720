// SPDX-License-Identifier: MIT
// References: the declarations of names and, for each other occurrence of a name, the declaration that the name
// denotes. Name resolution records references on request, and can continue after errors to record more of them.
//
// A declaration is identified by the position of its name. Therefore a declaration that name resolution expands to
// several elements is recorded once, and all references to these elements refer to this declaration. If several
// declarations have the same name (an error), each declaration is recorded, and references refer to the first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafverif/support/source.hpp"

namespace grafverif {

enum class DeclarationKind {
    Chart,
    Component,
    Loop,
    Partial,
    Input,
    Output,
    Internal,
    Step,
    Transition,
    InputParameter,
    OutputParameter,
    Constant,
    Own,
    Clock,
    Location,
    Instance,
    PlantVariable,
    Property,
    Observer,
    Fault,
    Unit,              ///< a program, function block or function of a PLC program
    Action,            ///< an action of a unit
    DataType,          ///< a data type of a PLC program
    EnumerationValue,  ///< a value of a data type
};

struct References {
    struct Declaration {
        DeclarationKind kind = DeclarationKind::Chart;
        std::string name = {};  ///< name without indices
        Span where = {};        ///< position of the name
        Span whole = {};        ///< position of the declaration
        Span owner = {};        ///< name of the enclosing declaration; no source at file level
        std::string text = {};  ///< text in one line; if empty, the source text is used
    };
    struct Reference {
        Span where = {};        ///< position of the occurrence; for a step variable `X2`, it includes the `X`
        Span declaration = {};  ///< position of the declared name
        bool writes = false;    ///< true if the occurrence is the target of an action, assignment or output
    };

    std::vector<Declaration> declarations = {};
    std::vector<Reference> references = {};
    /// Pairs of declarations that must have the same name. Reason: a closed loop connects inputs and outputs of
    /// controllers by name, and a fault inherits arguments of its instance by the names of parameters.
    std::vector<std::pair<Span, Span>> shared = {};
};

/// Returns the name of the original declaration for the name of a copy: `B` for `B[3]`.
inline std::string_view without_indices(std::string_view name) { return name.substr(0, name.find('[')); }

/// Adds declarations and references to a `References` object, if one is given. If `beyond_errors` is true, name
/// resolution continues after errors only to record references, and its diagnostics and its result are meaningless.
class Recorder {
public:
    Recorder() = default;
    explicit Recorder(References* references, bool beyond_errors = false)
        : references_(references), beyond_errors_(beyond_errors) {}

    bool beyond_errors() const { return beyond_errors_; }
    /// True if names are recorded.
    bool is_recording() const { return references_ != nullptr; }
    /// Returns a recorder that records nothing.
    Recorder silent() const { return Recorder(nullptr, beyond_errors_); }

    void declare(DeclarationKind kind, std::string_view name, Span where, Span whole, Span owner = {},
                 std::string text = {}) const {
        if (references_ != nullptr && where.source.valid())  // some variables of PLC programs have no position
            references_->declarations.push_back(
                {kind, std::string(without_indices(name)), where, whole, owner, std::move(text)});
    }
    void refer(Span where, Span declaration, bool writes = false) const {
        if (references_ != nullptr && declaration.source.valid())
            references_->references.push_back({where, declaration, writes});
    }
    /// Adds all declarations and references of `names`.
    void add(References names) const {
        if (references_ == nullptr) return;
        const auto append = [](auto& to, auto& from) {
            to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
        };
        append(references_->declarations, names.declarations);
        append(references_->references, names.references);
        append(references_->shared, names.shared);
    }
    void share(Span one, Span other) const {
        if (references_ != nullptr) references_->shared.emplace_back(one, other);
    }

private:
    References* references_ = nullptr;
    bool beyond_errors_ = false;
};

/// Returns the position of `name`, without its indices, at the end of `where`; for example, the position of `X2` in
/// `G2.X2`.
inline Span last_name(Span where, std::string_view name) {
    name = without_indices(name);
    const auto length = static_cast<std::uint32_t>(std::min<std::size_t>(name.size(), where.end - where.begin));
    return {where.source, where.end - length, where.end};
}

}  // namespace grafverif
