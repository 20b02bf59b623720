// SPDX-License-Identifier: MIT
// bench_chart SIZE prints a generated ring of SIZE steps. bench_chart line CELLS prints a production line of CELLS
// cells.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "generate.hpp"

int main(int count, char** values) {
    const bool line = count == 3 && std::string_view(values[1]) == "line";
    const long size = line || count == 2 ? std::strtol(values[count - 1], nullptr, 10) : 0;
    if (size < 1) {
        std::fputs("usage: bench_chart SIZE, bench_chart line CELLS\n", stderr);
        return 2;
    }
    const auto wanted = static_cast<std::size_t>(size);
    const std::string text = line ? grafverif::bench::production_line(wanted) : grafverif::bench::ring(wanted);
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 2;
}
