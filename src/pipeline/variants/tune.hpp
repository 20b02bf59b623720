// SPDX-License-Identifier: MIT
// Tuning: decides for which values of constants of a closed loop its properties hold, exactly on a grid.
//
// A verdict at a point of the grid is the result of a check of the model with the values of this point. If this model
// is not checked, the verdict follows from the check of another model by one of these arguments
// (docs/explanation/parameters.md):
//
//   equality    the models agree on the processes and on the property
//   relaxation  the verdict on a network that has all runs of the models of several points applies to these points
//   retiming    a run that decides the property at one point is, with other delays, also a run at another point
//
// The search never assumes monotonicity: the verdicts at neighbouring points alone do not imply a verdict.
#pragma once

#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/tuning.hpp"

namespace grafverif {

/// Maximum number of points of a grid.
constexpr std::uint64_t most_points = 10'000;

struct TuneRequest {
    std::vector<TunedConstant> constants = {};
    std::vector<std::string> properties = {};  ///< names of properties; all if empty
    ModelOptions how = {};
    ReadOptions read = {};  ///< options with which the model was read
    Limits limits = {};
    unsigned jobs = 0;         ///< number of threads (0: one per core); does not affect the result
    std::size_t runs = 0;      ///< for each property: maximum number of points with a run in the result
    bool every_point = false;  ///< true: check each point; derive no verdict from other checks
};

/// Decides the properties of `loop`. `main` is the source from which `model` was read; `sources` also contains its
/// includes. The result is empty after an error: a property does not exist, or the model is rejected for some values.
/// If a limit is reached, the result contains all verdicts found so far; all other verdicts are unknown, with the
/// reason `reasons[0]`.
std::optional<Tuning> tuned(const Model& model, Id<ClosedLoop> loop, Id<Source> main, const Sources& sources,
                            const TuneRequest& request, Diagnostics& diagnostics);

}  // namespace grafverif
