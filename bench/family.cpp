// SPDX-License-Identifier: MIT
// bench_family NAME M [N] prints a chart of a family as input for the program.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "families.hpp"

int main(int count, char** values) {
    using namespace grafverif::bench;
    const std::string_view name = count > 1 ? values[1] : "";
    const long m = count > 2 ? std::strtol(values[2], nullptr, 10) : 0,
               n = count > 3 ? std::strtol(values[3], nullptr, 10) : 0;
    std::string text;
    if (name == "BASIC_SEQUENCE" && m > 0) text = basic_sequence(static_cast<std::size_t>(m));
    if (name == "HIERARCHICAL_PARALLEL" && m > 0 && n > 0)
        text = hierarchical_parallel(static_cast<std::size_t>(m), static_cast<std::size_t>(n));
    if (name == "BASIC_PARALLEL" && m > 0 && n > 0)
        text = basic_parallel(static_cast<std::size_t>(m), static_cast<std::size_t>(n));
    if (text.empty()) {
        std::fputs("usage: bench_family BASIC_SEQUENCE M | HIERARCHICAL_PARALLEL M N | BASIC_PARALLEL M N\n", stderr);
        return 2;
    }
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 2;
}
