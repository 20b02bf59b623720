// SPDX-License-Identifier: MIT
// AIGER 1.9 reader and simulator for the ASCII and the binary form, based on the specification
// alone. The reader is the reference for exported files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace grafverif {

struct AigerFile {
    struct Latch {
        std::uint32_t literal = 0, next = 0;
    };
    struct And {
        std::uint32_t out = 0, left = 0, right = 0;
    };
    std::uint32_t most = 0;  ///< the greatest variable index
    std::vector<std::uint32_t> inputs = {}, bads = {};
    std::vector<Latch> latches = {};
    std::vector<std::vector<std::uint32_t>> justice = {};
    std::vector<And> ands = {};
    std::vector<std::string> symbols = {};  ///< the lines of the symbol table
    std::string error_text = {};            ///< the reason why the file is invalid
};

AigerFile read_aiger(const std::string& text);

/// Returns the value of a literal. `values` has one entry for each variable.
inline bool aiger_value(const std::vector<bool>& values, std::uint32_t literal) {
    return values[literal / 2] != (literal % 2 != 0);
}
/// Returns the values of all variables in each step. `inputs` has the values of the inputs in each step.
std::vector<std::vector<bool>> aiger_run(const AigerFile& file, const std::vector<std::vector<bool>>& inputs);

}  // namespace grafverif
