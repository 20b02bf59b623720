// SPDX-License-Identifier: MIT
// Names made legal for a target, once, by a table of the target's reserved words. Our names are those of the chart and
// the plant; a target may reserve some (`X` in UPPAAL's queries, `S` in NuSMV) or have no spelling for others (a
// location called `2`, an expanded property `P.X7`). Emitters print what stands here and repair no name themselves.
//
// The map is injective over the entities of one scope and deterministic: it depends on the order of the names alone.
// A name that is legal stays as it is, whatever the others are; of several entities with one name the first keeps it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace grafverif {

/// UppaalLocal: what no query can name, such as the parameters of a template; the words of queries may be used there.
/// StructuredText: identifiers of IEC 61131-3, where upper and lower case are the same and `_` neither doubles nor ends
/// a name.
enum class Target { Uppaal, UppaalLocal, Nusmv, StructuredText };

/// Whether `name` means something else in the target: a keyword, a built-in, or an operator of its properties.
bool is_reserved(Target target, std::string_view name);

/// Whether `name` may stand for an entity in the target.
bool is_legal(Target target, std::string_view name);

/// What the entities called `names`, which share one scope, are called in the target; none gets a name in `taken`.
/// Letters of other scripts are spelled in ASCII (`Förderer`: `Foerderer`), what no identifier may hold becomes `_`, a number gets a `_` in front, and a reserved or taken name one behind,
/// then `_2`, `_3`, ... until it is free (in Structured Text at once).
std::vector<std::string> legal_names(Target target, std::span<const std::string> names,
                                     const std::unordered_set<std::string>& taken = {});

/// A name that had to change, for the map in a model's header.
struct Renaming {
    std::string name = {};
    std::string legal = {};
    bool operator==(const Renaming&) const = default;
};

/// Those of `names` whose entry in `legal` differs, in order.
std::vector<Renaming> renamings(std::span<const std::string> names, std::span<const std::string> legal);

}  // namespace grafverif
