// SPDX-License-Identifier: MIT
// Recording: records an interactive simulation as a script that repeats the commands and expects the observed values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulate/simulation.hpp"

namespace grafverif {

class Recording {
public:
    /// Requires that Simulation::begin has been called. The simulation must outlive the recording.
    explicit Recording(Simulation& simulation) : simulation_(simulation) {}

    /// Executes a command in the same way as Simulation::execute. `line` is the text of the command.
    std::string execute(const Command& command, std::string_view line);

    /// Returns the executed commands, without commands that were undone or rejected. After each command, an `expect`
    /// states the values of the steps, outputs and internal variables that the command changed.
    std::string script() const;

private:
    struct Line {
        std::string text = {}, claim = {};
        std::size_t commands = 0;  ///< number of commands that the simulation can undo after this line
    };

    std::string claim(const ChartRun::State& before) const;

    Simulation& simulation_;
    std::vector<Line> lines_ = {};
};

/// First line of a saved script.
inline constexpr std::string_view saved_session = "// A session of `grafverif simulate`";

}  // namespace grafverif
