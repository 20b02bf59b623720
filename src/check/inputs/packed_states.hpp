// SPDX-License-Identifier: MIT
// A set of packed states, numbered in the order of insertion.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "check/timed/layout.hpp"

namespace grafverif {

class PackedStates {
public:
    explicit PackedStates(std::size_t words) : words_(words) {}
    PackedStates(PackedStates&&) = delete;

    struct Added {
        std::uint32_t state = 0;
        bool is_new = false;
    };
    Added add(const timed::Word* words);

    std::size_t size() const { return states_.size() / words_; }
    const timed::Word* words(std::size_t state) const { return states_.data() + state * words_; }
    /// Returns the approximate memory in bytes.
    std::uint64_t bytes() const;

private:
    struct Hash {
        const PackedStates& states;
        std::size_t operator()(std::uint32_t state) const;
    };
    struct Equal {
        const PackedStates& states;
        bool operator()(std::uint32_t a, std::uint32_t b) const;
    };
    const std::size_t words_;
    std::vector<timed::Word> states_ = {};
    std::unordered_set<std::uint32_t, Hash, Equal> known_{0, Hash{*this}, Equal{*this}};
};

}  // namespace grafverif
