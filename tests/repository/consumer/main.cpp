// SPDX-License-Identifier: MIT
// Checks the closed loop of a file through the installed library.
#include <grafverif/grafverif.hpp>
#include <iostream>

int main(int count, char** arguments) {
    if (count != 2) return 2;
    grafverif::ParseResult file = grafverif::read_file(arguments[1]);
    std::optional<grafverif::Report> report;
    if (file.model && !file.model->loops.empty())
        report = check(*file.model, *file.model->loops.ids().begin(), {}, {}, file.diagnostics);
    std::cerr << file.diagnostics_text();
    if (report) std::cout << text_of(*report);
    return report ? 0 : 2;
}
