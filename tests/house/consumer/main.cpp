// SPDX-License-Identifier: MIT
// Reads a chart and prints its equations through the installed headers.
#include <iostream>

#include "derive/derive.hpp"
#include "read/text.hpp"
#include "syntax/print/equations.hpp"

int main() {
    using namespace grafverif;
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> file = sources.add(
        {"blink.grafcet", "grafcet blink { input a; output L; initial step 0; step 1 { L; }\n"
                          "transition go: 0 -> 1 when a; transition back: 1 -> 0 when !a; }\n"});
    const auto model = read_text(file, sources, {}, diagnostics);
    const auto equations = model ? derive(*model->charts.begin(), diagnostics) : std::nullopt;
    render_text(diagnostics.all(), sources, Colour::Plain, std::cerr);
    if (!equations) return 1;
    print_equations(std::cout, *equations);
    return 0;
}
