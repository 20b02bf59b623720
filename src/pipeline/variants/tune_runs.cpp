// SPDX-License-Identifier: MIT
#include "pipeline/variants/tune_runs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "compose/observe.hpp"
#include "pipeline/check.hpp"
#include "report/charts/tuning.hpp"
#include "report/report.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"

namespace grafverif {

namespace {

/// Maximum number of stored runs of all rows. It limits the memory.
constexpr std::size_t most_stored = 5'000;

/// Returns the distance of a point from the current values, in steps of the grid.
double distance(const Tuning& tuning, std::size_t point) {
    const std::vector<std::size_t> at = tuning.indices(point);
    double sum = 0;
    for (std::size_t k = 0; k < at.size(); ++k) {
        const TunedConstant& constant = tuning.constants[k];
        sum += std::abs(static_cast<double>(constant.value(at[k])) - static_cast<double>(constant.current)) /
               static_cast<double>(constant.step);
    }
    return sum;
}

}  // namespace

Network seen_by(Network network, const std::string& name, bool watched, bool exact) {
    if (!watched) return network;
    for (const Id<Property> id : grafverif::watched(network))
        if (network.properties[id].name == name)
            return expand(observed(network, {id}, exact ? Vacuity::Probed : Vacuity::Ignored));
    return network;
}

void TuneRuns::add(std::size_t row, std::size_t point, const Verdict& verdict, Run run, std::string name, bool watched,
                   bool exact) {
    if (runs_.size() >= most_stored) return;
    Known known{verdict, std::move(name), watched, exact};
    known.verdict.run = std::move(run);
    known.verdict.about = {};
    runs_.emplace(std::pair(row, point), std::move(known));
}

void TuneRuns::add(std::size_t row, std::size_t point, const PropertyResult& result) {
    if (runs_.size() < most_stored) runs_.emplace(std::pair(row, point), Known{.result = result});
}

void TuneRuns::write(const TunePoints& points, std::size_t most, Tuning& tuning) const {
    for (std::size_t row = 0; row < tuning.rows.size(); ++row) {
        std::vector<std::pair<double, std::size_t>> nearest;
        for (auto at = runs_.lower_bound({row, 0}); at != runs_.end() && at->first.first == row; ++at)
            nearest.emplace_back(distance(tuning, at->first.second), at->first.second);
        std::ranges::sort(nearest);
        nearest.resize(std::min(nearest.size(), most));
        for (const auto& [_, point] : nearest) {
            const Known& known = runs_.at({row, point});
            if (known.result) {
                tuning.rows[row].runs.emplace(point, *known.result);
                continue;
            }
            const Network network = seen_by(points.network(point), known.name, known.watched, known.exact);
            if (const auto found = disagreement(project(network, *known.verdict.run), points.charts(point))) {
                tuning.failures.push_back(replay_failure(
                    "the trace of `" + known.verdict.property + "` at " + point_text(tuning, point), *found));
                continue;
            }
            tuning.rows[row].runs.emplace(point, result_of(network, known.verdict, Detail::Chart));
        }
    }
}

}  // namespace grafverif
