// SPDX-License-Identifier: MIT
// Table<T>: the entities of one type of an IR, in the order of their addition. An entity is addressed by its Id<T>.
#pragma once

#include <cassert>
#include <cstdint>
#include <ranges>
#include <utility>
#include <vector>

#include "grafverif/support/id.hpp"

namespace grafverif {

template <class T>
class Table {
public:
    Id<T> add(T entity) {
        entities_.push_back(std::move(entity));
        return Id<T>{static_cast<std::uint32_t>(entities_.size() - 1)};
    }

    T& operator[](Id<T> id) {
        assert(id.index < entities_.size());
        return entities_[id.index];
    }
    const T& operator[](Id<T> id) const {
        assert(id.index < entities_.size());
        return entities_[id.index];
    }

    std::size_t size() const { return entities_.size(); }
    bool empty() const { return entities_.empty(); }
    bool contains(Id<T> id) const { return id.index < entities_.size(); }

    auto begin() { return entities_.begin(); }
    auto end() { return entities_.end(); }
    auto begin() const { return entities_.begin(); }
    auto end() const { return entities_.end(); }

    /// Returns a range of all ids of the table, in order.
    auto ids() const {
        return std::views::iota(std::uint32_t{0}, static_cast<std::uint32_t>(entities_.size())) |
               std::views::transform([](std::uint32_t index) { return Id<T>{index}; });
    }

    bool operator==(const Table&) const = default;

private:
    std::vector<T> entities_ = {};
};

}  // namespace grafverif
