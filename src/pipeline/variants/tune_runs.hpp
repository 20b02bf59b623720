// SPDX-License-Identifier: MIT
// Collects the runs that violate properties at points of a grid, for the player of a report.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "ir/tuning.hpp"
#include "pipeline/variants/tune_points.hpp"

namespace grafverif {

/// Returns the network in which the property `name` is decided; if `watched` is true, the network contains the observer
/// of the property. The observer has probes (properties that detect vacuous verdicts) only if `exact` is true. `exact`
/// states that `network` is the network of a point, not a relaxation.
Network seen_by(Network network, const std::string& name, bool watched, bool exact);

/// Collects runs, and keeps only the runs of the points nearest to the current values of the constants.
class TuneRuns {
public:
    /// For each row, the object keeps runs of at most `most` points. `tuning` contains the constants and must outlive
    /// this object.
    TuneRuns(const Tuning& tuning, std::size_t most) : tuning_(tuning), most_(most) {}

    /// Stores a run that decides `verdict` in the network `seen_by(network of the point, name, watched, exact)`.
    void add(std::size_t row, std::size_t point, const Verdict& verdict, Run run, std::string name, bool watched,
             bool exact);

    /// Stores the result of a check for a point. The checked model is the model at the point or an equal model. The
    /// check has replayed the run.
    void add(std::size_t row, std::size_t point, const PropertyResult& result);

    /// Adds the runs to `rows` of `tuning`, after replaying each run on the charts of its point. If the replay of a run
    /// fails, an internal error is added instead.
    void write(const TunePoints& points, Tuning& tuning) const;

private:
    struct Known {
        Verdict verdict = {};
        std::string name = {};
        bool watched = false, exact = false;
        std::optional<PropertyResult> result = {};  ///< if present, the other members of Known are not used
    };
    /// Returns the object in which the run of a point must be stored; null if the point already has a run, or if
    /// `most_` nearer points of the row have runs.
    Known* place(std::size_t row, std::size_t point);

    const Tuning& tuning_;
    std::size_t most_;
    /// For each row: the runs, ordered by distance and point.
    std::map<std::size_t, std::map<std::pair<double, std::size_t>, Known>> runs_ = {};
};

}  // namespace grafverif
