// SPDX-License-Identifier: MIT
// Recording: what somebody does with a simulation, as a script that does it again and expects what was seen.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulate/simulation.hpp"

namespace grafverif {

class Recording {
public:
    /// `simulation`, which has begun, outlives the recording.
    explicit Recording(Simulation& simulation) : simulation_(simulation) {}

    /// As Simulation::obey; `line` is what was typed.
    std::string obey(const Command& command, std::string_view line);

    /// What has been done, without what was undone or refused; behind each command an `expect` of the steps, outputs and
    /// internal variables that it changed.
    std::string script() const;

private:
    struct Line {
        std::string text = {}, claim = {};
        std::size_t commands = 0;  ///< that there are to undo with it
    };

    std::string claim(const ChartRun::State& before) const;

    Simulation& simulation_;
    std::vector<Line> lines_ = {};
};

/// What a script that was saved begins with.
inline constexpr std::string_view saved_session = "// A session of `grafverif simulate`";

}  // namespace grafverif
