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

/// Collects the runs, and keeps those of the points nearest to the current values.
class TuneRuns {
public:
    /// Stores runs of at most `most` points per row: those nearest to the current values. `tuning` contains the
    /// constants and must outlive this object.
    TuneRuns(const Tuning& tuning, std::size_t most) : tuning_(tuning), most_(most) {}

    /// Stores a run that decides `verdict` in the network `seen_by(network of the point, name, watched, exact)`.
    void add(std::size_t row, std::size_t point, const Verdict& verdict, Run run, std::string name, bool watched,
             bool exact);

    /// Stores the result of the check of the model at a point, or of a model that is equal to it. The check has
    /// replayed the run.
    void add(std::size_t row, std::size_t point, const PropertyResult& result);

    /// Adds the runs to `rows` of `tuning`. Each run is replayed on the charts of its point. A run that fails the
    /// replay becomes an internal error.
    void write(const TunePoints& points, Tuning& tuning) const;

private:
    struct Known {
        Verdict verdict = {};
        std::string name = {};
        bool watched = false, exact = false;
        std::optional<PropertyResult> result = {};  ///< if present, the other members are not used
    };
    /// Returns the place for the run of a point; null if `most_` nearer points of the row have runs.
    Known* place(std::size_t row, std::size_t point);

    const Tuning& tuning_;
    std::size_t most_;
    /// For each row: runs by distance and point.
    std::map<std::size_t, std::map<std::pair<double, std::size_t>, Known>> runs_ = {};
};

}  // namespace grafverif
