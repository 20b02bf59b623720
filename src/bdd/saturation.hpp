// SPDX-License-Identifier: MIT
// Saturation (Ciardo, Luettgen, Siminiscu 2001): all states that steps of several kinds lead to, where a kind of step
// reads and writes few variables. A diagram is closed from below: first each part of it under the steps that concern
// lower variables alone, then the whole under those whose topmost variable it begins with, and so again until nothing
// is new. What it does at one place it knows at all others; and no diagram of states of one distance is ever made.
#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "bdd/relation.hpp"

namespace grafverif::bdd {

/// Steps of one kind, and what their images quantify.
struct Steps {
    Steps(const BddSpace& space, std::vector<NextBit> bits, std::vector<Bdd> conditions,
          std::vector<std::uint32_t> choices, std::span<const std::uint32_t> free);

    Relation relation;
    Relation::Quantified gone;
};

class Saturation {
public:
    /// `kinds` outlives this; no order changes meanwhile.
    Saturation(const BddSpace& space, const std::deque<Steps>& kinds);
    Saturation(const Saturation&) = delete;
    Saturation& operator=(const Saturation&) = delete;
    ~Saturation() { forget(); }

    /// The states that any number of steps leads to from one of `from`.
    Bdd closure(const Bdd& from) { return closed(from, 0); }

private:
    struct Level {
        std::uint32_t level = 0;  ///< of the topmost variable
        std::vector<const Steps*> kinds = {};
    };
    struct Asked {
        Bdd states = {};
        std::size_t from = 0;
        bool operator==(const Asked&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Asked& asked) const { return asked.states.hash() + asked.from; }
    };

    Bdd closed(const Bdd& states, std::size_t from);
    Bdd closed_here(const Bdd& states, std::size_t from);
    void remember(const Asked& asked, const Bdd& result);
    void forget();

    const BddSpace& space_;
    std::vector<Level> levels_ = {};  ///< from the top down
    std::unordered_map<Asked, Bdd, Hash> known_ = {};
};

}  // namespace grafverif::bdd
