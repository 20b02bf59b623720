// SPDX-License-Identifier: MIT
// Maps the names of a chart and its plant to legal identifiers of a target language. A target language may reserve a
// name (`X` in UPPAAL's queries, `S` in NuSMV) or reject its form (a location named `2`, a property `P.X7`). The
// emitters print the mapped names unchanged.
//
// The map is injective over the names of one scope, and deterministic: it depends only on the names and their order. A
// legal name is mapped to itself, independently of the other names. If a legal name occurs several times, its first
// occurrence is unchanged.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace grafverif {

/// A target language. UppaalLocal: names in a UPPAAL template to which queries cannot refer, such as parameters;
/// therefore, keywords of the query language are allowed as names. StructuredText: identifiers of IEC 61131-3, which
/// are case-insensitive and have no double or trailing `_`. C: identifiers without double or trailing `_` that are not
/// keywords of C or C++, for members of structs.
enum class Target { Uppaal, UppaalLocal, Nusmv, StructuredText, C };

/// True if the target language reserves `name` as a keyword, as a built-in function or constant, or as an operator of
/// properties.
bool is_reserved(Target target, std::string_view name);

/// True if `name` is allowed as an identifier in the target language.
bool is_legal(Target target, std::string_view name);

/// Returns legal identifiers for `names`, which belong to one scope. No identifier in the result is in `taken`. Letters
/// of other scripts are transliterated to ASCII (`Förderer`: `Foerderer`), `FULL[1]` becomes `FULL_1`, other characters
/// that are not allowed in identifiers become `_`, and a number gets a leading `_`. A name that is reserved or already
/// used gets the suffix `_`, or the first of the suffixes `_2`, `_3`, ... that makes it unused. In Structured Text and
/// C, the first suffix is `_2`.
std::vector<std::string> legal_names(Target target, std::span<const std::string> names,
                                     const std::unordered_set<std::string>& taken = {});

/// A name that was changed. The header of a generated model lists the changed names.
struct Renaming {
    std::string name = {};
    std::string legal = {};
    bool operator==(const Renaming&) const = default;
};

/// Returns the elements of `names` that differ from the corresponding elements of `legal`, in order.
std::vector<Renaming> renamings(std::span<const std::string> names, std::span<const std::string> legal);

}  // namespace grafverif
