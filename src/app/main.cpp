// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "app/program.hpp"
#include "app/system/guard.hpp"
#include "support/printable.hpp"

int main(int count, char** values) {
    using namespace grafverif::app;
    expect_memory_to_end();
    std::ios::sync_with_stdio(false);
    try {
        const std::vector<std::string> arguments(values + 1, values + count);
        const bool terminals[] = {::isatty(STDOUT_FILENO) == 1, ::isatty(STDERR_FILENO) == 1};
        const ExitCode code = run(arguments, {std::cin, std::cout, std::cerr, terminals[1], true, terminals[0]});
        std::cout.flush();
        if (!std::cout) {
            std::cerr << "grafverif: error: cannot write to standard output\n";
            return static_cast<int>(ExitCode::Input);
        }
        return static_cast<int>(code);
    } catch (const std::bad_alloc&) {
        std::cerr << "error: the system gives no more memory [out-of-memory]\n";
        return static_cast<int>(ExitCode::Unknown);
    } catch (const std::exception& failure) {
        std::cerr << "grafverif: internal failure: " << grafverif::printable(failure.what()) << '\n';
        return static_cast<int>(ExitCode::Failure);
    }
}
