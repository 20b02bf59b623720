// SPDX-License-Identifier: MIT
// Id<T>: the typed index of an entity in its Table<T>. Unlike a pointer, an id remains meaningful if its table is
// copied or grows, and it can be printed and stored in the tables of another IR.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

namespace grafverif {

template <class T>
struct Id {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t index = none;

    /// True if the id names an entity; false for a default-constructed id.
    bool valid() const { return index != none; }

    auto operator<=>(const Id&) const = default;
};

}  // namespace grafverif

template <class T>
struct std::hash<grafverif::Id<T>> {
    std::size_t operator()(grafverif::Id<T> id) const noexcept { return id.index; }
};
