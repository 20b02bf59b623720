// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "app/program.hpp"

int main(int count, char** values) {
    using namespace grafverif::app;
    std::ios::sync_with_stdio(false);
    try {
        const std::vector<std::string> arguments(values + 1, values + count);
        const ExitCode code = run(arguments, {std::cin, std::cout, std::cerr, ::isatty(STDERR_FILENO) == 1});
        std::cout.flush();
        if (!std::cout) {
            std::cerr << "grafverif: error: cannot write to standard output\n";
            return static_cast<int>(ExitCode::Input);
        }
        return static_cast<int>(code);
    } catch (const std::bad_alloc&) {
        std::cerr << "grafverif: error: out of memory [too-large]\n";
        return static_cast<int>(ExitCode::Input);
    } catch (const std::exception& failure) {
        std::cerr << "grafverif: internal failure: " << failure.what() << '\n';
        return static_cast<int>(ExitCode::Failure);
    }
}
