// SPDX-License-Identifier: MIT
#include "pipeline/variants/tune_runs.hpp"

#include <cmath>
#include <iterator>
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

/// Returns the distance of a point from the current values of the constants, in steps of the grid.
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

TuneRuns::Known* TuneRuns::place(std::size_t row, std::size_t point) {
    auto& runs = runs_[row];
    const auto [place, added] = runs.try_emplace({distance(tuning_, point), point});
    if (!added) return nullptr;  // the point already has a run
    if (runs.size() <= most_) return &place->second;
    const auto farthest = std::prev(runs.end());
    Known* const made = farthest == place ? nullptr : &place->second;
    runs.erase(farthest);
    return made;
}

void TuneRuns::add(std::size_t row, std::size_t point, const Verdict& verdict, Run run, std::string name, bool watched,
                   bool exact) {
    Known* const known = place(row, point);
    if (known == nullptr) return;
    *known = {verdict, std::move(name), watched, exact};
    known->verdict.run = std::move(run);
    known->verdict.about = {};
}

void TuneRuns::add(std::size_t row, std::size_t point, const PropertyResult& result) {
    if (Known* const known = place(row, point)) known->result = result;
}

void TuneRuns::write(const TunePoints& points, Tuning& tuning) const {
    for (const auto& [row, runs] : runs_)
        for (const auto& [at, known] : runs) {
            const std::size_t point = at.second;
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

}  // namespace grafverif
