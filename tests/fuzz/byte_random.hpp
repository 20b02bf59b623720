// SPDX-License-Identifier: MIT
// Random numbers for the randomized tests, derived from the input bytes of a fuzzer. Each number uses one byte, so that
// a changed byte changes one choice. After the last byte the numbers are an infinite pseudorandom sequence that depends
// on the bytes.
#pragma once

#include <array>
#include <cstdint>
#include <sstream>
#include <string_view>

#include "support/random_chart.hpp"

namespace grafverif::fuzz {

/// Inverts the tempering of std::mt19937_64: returns the state from which the generator draws `number` next.
inline std::uint64_t untempered(std::uint64_t number) {
    number ^= number >> Random::tempering_l;
    number ^= (number << Random::tempering_t) & Random::tempering_c;
    std::uint64_t found = number;  // each round corrects more of the lower bits
    for (int round = 0; round < 4; ++round) found = number ^ ((found << Random::tempering_s) & Random::tempering_b);
    std::uint64_t state = found;
    for (int round = 0; round < 3; ++round) state = found ^ ((state >> Random::tempering_u) & Random::tempering_d);
    return state;
}

inline Random byte_random(std::string_view bytes) {
    std::stringstream text;
    std::uint64_t mixed = bytes.size();
    for (std::size_t k = 0; k < Random::state_size; ++k) {
        if (k < bytes.size()) mixed = (mixed ^ static_cast<unsigned char>(bytes[k])) * 0x9E3779B97F4A7C15U;
        const std::uint64_t number = k < bytes.size() ? static_cast<unsigned char>(bytes[k])
                                                      : mixed = mixed * 6364136223846793005U + 1442695040888963407U;
        text << untempered(number) << ' ';
    }
    text << 0;  // the position in the state, in the format of libstdc++
    Random random;
    text >> random;
    return random;
}

}  // namespace grafverif::fuzz
