// SPDX-License-Identifier: MIT
// Reads PLC programs for tests, and returns their diagnostics and the values of a variable scan by scan.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "derive/program/scan.hpp"
#include "read/program/program.hpp"
#include "run/program/interpreter.hpp"
#include "support/render.hpp"

namespace grafverif {

struct ReadProgram {
    Sources sources = {};
    Diagnostics diagnostics = {};
    std::optional<ProgramText> text = {};

    explicit ReadProgram(const std::string& program) {
        text = read_program(sources.add({"test.st", program}), sources, diagnostics);
        if (text) scan_of(text->program(), diagnostics);
    }
    std::string codes() const {
        std::string list;
        for (const Diagnostic& one : diagnostics.all()) {
            const Place at = place(sources[one.where.source].text, one.where.begin);
            list += std::to_string(at.line) + ":" + std::to_string(at.column) + " " + one.code + "\n";
        }
        return list;
    }
};

/// Returns the values of `variable` after each scan. `inputs` contains the values of all inputs for each scan.
inline std::string values(const std::string& program, const std::string& variable,
                          const std::vector<std::vector<std::int64_t>>& inputs, std::int64_t elapsed = 10) {
    const ReadProgram reading(program);
    if (!reading.text) return reading.codes();
    ProgramRun run(reading.text->program());
    std::string list;
    for (const std::vector<std::int64_t>& each : inputs) {
        run.scan(each, elapsed);
        for (std::size_t i = 0; i < run.layout().cells.size(); ++i)
            if (run.layout().cells[i].name == variable)
                list += (list.empty() ? "" : " ") + std::to_string(run.cells()[i]);
    }
    return list;
}

}  // namespace grafverif
