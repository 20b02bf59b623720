// SPDX-License-Identifier: MIT
// Changes bytes of texts at random positions, for tests of readers.
#pragma once

#include <random>
#include <string>
#include <string_view>

namespace grafverif {

struct Damage {
    std::string_view likely = {};    ///< bytes with a syntactic meaning in the text
    std::size_t most_changes = 3;    ///< maximum number of changes: a new byte, deleted bytes, or a copied piece
    std::size_t longest_piece = 60;  ///< all copied pieces are shorter than this length
};

inline std::string damaged(std::string text, const Damage& damage, std::mt19937& random) {
    for (std::size_t left = 1 + random() % damage.most_changes; left > 0 && !text.empty(); --left) {
        const std::size_t at = random() % text.size();
        switch (random() % 4) {
        case 0: text[at] = static_cast<char>(random() % 256); break;
        case 1: text[at] = damage.likely[random() % damage.likely.size()]; break;
        case 2: text.erase(at, 1 + random() % 8); break;
        default: text.insert(at, text.substr(random() % text.size(), random() % damage.longest_piece));
        }
    }
    return text;
}

}  // namespace grafverif
