// SPDX-License-Identifier: MIT
// bench_chart SIZE: prints the generated ring of SIZE steps.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "generate.hpp"

int main(int count, char** values) {
    const long size = count == 2 ? std::strtol(values[1], nullptr, 10) : 0;
    if (size < 1) {
        std::fputs("usage: bench_chart SIZE\n", stderr);
        return 2;
    }
    const std::string text = grafverif::bench::ring(static_cast<std::size_t>(size));
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 2;
}
