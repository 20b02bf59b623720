// SPDX-License-Identifier: MIT
// The runs that violate properties at points of a grid, for the player of a report.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "ir/tuning.hpp"
#include "pipeline/variants/tune_points.hpp"

namespace grafverif {

/// Returns the network that decides the property called `name`, with its observer if `watched` is true. An observer has
/// probes only if `exact` is true: `network` is the network of a point, and not a relaxation.
Network seen_by(Network network, const std::string& name, bool watched, bool exact);

class TuneRuns {
public:
    /// Stores a run that decides `verdict` in the network `seen_by(network of the point, name, watched, exact)`. The
    /// total number of stored runs is limited; further runs are ignored.
    void add(std::size_t row, std::size_t point, const Verdict& verdict, Run run, std::string name, bool watched,
             bool exact);

    /// Stores the result of the check of the model at a point, or of a model that is equal to it. The check has replayed
    /// the run.
    void add(std::size_t row, std::size_t point, const PropertyResult& result);

    /// Adds the runs to `rows` of `tuning`: for each row, the runs of the `most` points that are nearest to the current
    /// values. Each run is replayed on the charts of its point. A run that fails the replay becomes an internal error.
    void write(const TunePoints& points, std::size_t most, Tuning& tuning) const;

private:
    struct Known {
        Verdict verdict = {};
        std::string name = {};
        bool watched = false, exact = false;
        std::optional<PropertyResult> result = {};  ///< if present, the other members are not used
    };
    std::map<std::pair<std::size_t, std::size_t>, Known> runs_ = {};  ///< by row and point
};

}  // namespace grafverif
