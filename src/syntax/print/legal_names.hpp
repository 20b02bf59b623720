// SPDX-License-Identifier: MIT
// Maps names to legal identifiers of a target by a table of its reserved words. The chart and the plant define the
// names. A target may reserve a name (`X` in UPPAAL's queries, `S` in NuSMV) or reject its form (a location named `2`,
// an expanded property `P.X7`). Emitters print the mapped names unchanged.
//
// The map is injective over the names of one scope and deterministic: it depends only on the order of the names. Legal
// names are unchanged, independently of the other names. If a legal name occurs several times, its first occurrence is
// unchanged.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace grafverif {

/// UppaalLocal: names that cannot occur in queries, such as parameters of a template. A UppaalLocal name can be a
/// keyword of queries. StructuredText: identifiers of IEC 61131-3, which are case-insensitive and have no double or
/// trailing `_`. C: identifiers without double or trailing `_` that are not keywords of C or C++, for members of
/// structs.
enum class Target { Uppaal, UppaalLocal, Nusmv, StructuredText, C };

/// True if `name` has another meaning in the target: a keyword, a built-in, or an operator of its properties.
bool is_reserved(Target target, std::string_view name);

/// True if `name` is allowed as an identifier in the target.
bool is_legal(Target target, std::string_view name);

/// Returns legal identifiers for `names`, which share one scope. No result is in `taken`. Letters of other scripts are
/// transliterated to ASCII (`Förderer`: `Foerderer`), `FULL[1]` becomes `FULL_1`, other characters that are not allowed
/// in identifiers become `_`, and a number gets a leading `_`. A reserved or used name gets a trailing `_`, then `_2`,
/// `_3`, ... until it is unused (in Structured Text and C immediately `_2`).
std::vector<std::string> legal_names(Target target, std::span<const std::string> names,
                                     const std::unordered_set<std::string>& taken = {});

/// A changed name. The header of a model lists these names.
struct Renaming {
    std::string name = {};
    std::string legal = {};
    bool operator==(const Renaming&) const = default;
};

/// Returns the elements of `names` that differ from the corresponding elements of `legal`, in order.
std::vector<Renaming> renamings(std::span<const std::string> names, std::span<const std::string> legal);

}  // namespace grafverif
