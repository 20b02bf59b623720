// SPDX-License-Identifier: MIT
#include "pipeline/variants/tune_points.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "check/timed/property_queries.hpp"
#include "pipeline/models.hpp"
#include "pipeline/variants/in_parallel.hpp"
#include "pipeline/variants/read_again.hpp"
#include "report/charts/tuning.hpp"

namespace grafverif {

namespace {

/// Number of points whose models are read in parallel before their networks are added to the set of frames (networks
/// without the constants of clock constraints).
constexpr std::size_t at_once = 64;

/// Adds the property `no timelock` to a network that does not declare it, because every check decides this property.
void add_timelock(Network& network) {
    if (std::ranges::none_of(network.properties, timed::about_time))
        network.properties.add(timed::undeclared_timelock(network));
}

}  // namespace

std::optional<Model> model_at(const Tuning& tuning, std::size_t point, Id<Source> main, const Sources& sources,
                              ReadOptions options, Sources& to, Diagnostics& diagnostics) {
    const std::vector<std::size_t> indices = tuning.indices(point);
    for (std::size_t k = 0; k < indices.size(); ++k)
        options.constants[tuning.constants[k].name] =
            value_text(tuning.constants[k], tuning.constants[k].value(indices[k]));
    return read_again(main, {}, sources, to, options, diagnostics);
}

TunePoints::TunePoints(const Model& model, Id<ClosedLoop> loop, Id<Source> main, const Sources& sources,
                       const TuneRequest& request, const Tuning& tuning)
    : model_(model), loop_(loop), main_(main), sources_(sources), request_(request), tuning_(tuning) {}

std::size_t TunePoints::FrameSet::add(Network frame) {
    const std::uint64_t hash = hash_of(frame);
    const auto [first, last] = by_hash.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (frames[known->second] == frame) return known->second;
    by_hash.emplace(hash, frames.size());
    frames.push_back(std::move(frame));
    return frames.size() - 1;
}

void TunePoints::read_point(std::size_t point, std::optional<std::int64_t> unit_ms, Read& read) const {
    auto model = model_at(tuning_, point, main_, sources_, request_.read, read.sources, read.diagnostics);
    const auto loop = model ? find_loop(*model, model_.loops[loop_].name) : std::nullopt;
    if (!loop) return;
    if (unit_ms) model->loops[*loop].time_unit_ms = unit_ms;
    auto network = network_of(*model, *loop, request_.how, read.diagnostics);
    if (!network) return;
    add_timelock(*network);
    read.member = member_of(*network);
    const std::vector<const Chart*> charts = charts_of(*model, model->loops[*loop]);
    if (std::ranges::any_of(charts, [](const Chart* chart) { return !chart->instance_of.empty(); }))
        for (const Chart* const chart : charts) read.charts.push_back(*chart);
}

std::vector<const Chart*> TunePoints::charts(std::size_t point) const {
    if (!points_[point].charts) return charts_of(model_, model_.loops[loop_]);
    std::vector<const Chart*> charts;
    for (const Chart& chart : charts_[*points_[point].charts]) charts.push_back(&chart);
    return charts;
}

void TunePoints::report(std::size_t point, const Read& read, Diagnostics& diagnostics) const {
    for (Diagnostic each : read.diagnostics.all()) {
        const auto& known = diagnostics.all();
        if (each.severity != Severity::Error && std::ranges::find(known, each.code, &Diagnostic::code) != known.end())
            continue;
        const Id<Source> source = each.where.source;
        const bool same = sources_.contains(source) && read.sources.contains(source) &&
                          sources_[source].name == read.sources[source].name;
        if (!same) each.where = {};
        each.message = "for `" + point_text(tuning_, point) + "`: " + each.message;
        diagnostics.add(std::move(each));
    }
}

bool TunePoints::read_all(std::optional<std::int64_t> unit_ms, const std::function<bool()>& stopped,
                          Diagnostics& diagnostics) {
    points_.clear();
    points_.resize(tuning_.points);
    set_ = {};
    charts_.clear();
    for (std::size_t first = 0; first < tuning_.points && !stopped(); first += at_once) {
        std::vector<Read> reads(std::min(at_once, tuning_.points - first));
        in_parallel(reads.size(), request_.jobs, stopped,
                    [&](std::size_t k) { read_point(first + k, unit_ms, reads[k]); });
        for (std::size_t k = 0; k < reads.size(); ++k) {
            report(first + k, reads[k], diagnostics);
            if (reads[k].diagnostics.has_errors()) return false;
            if (!reads[k].member) continue;  // reading was stopped before this point
            unit_ms_ = std::gcd(unit_ms_, reads[k].member->frame.time_unit_ms);
            points_[first + k].frame = set_.add(std::move(reads[k].member->frame));
            points_[first + k].constants = std::move(reads[k].member->constants);
            if (reads[k].charts.empty()) continue;
            if (charts_.empty() || charts_.back() != reads[k].charts) charts_.push_back(std::move(reads[k].charts));
            points_[first + k].charts = charts_.size() - 1;
        }
    }
    return true;
}

bool TunePoints::read(const std::function<bool()>& stopped, Diagnostics& diagnostics) {
    if (!read_all({}, stopped, diagnostics)) return false;
    const auto differs = [&](const Network& frame) { return frame.time_unit_ms != unit_ms_; };
    return std::ranges::none_of(set_.frames, differs) || read_all(unit_ms_, stopped, diagnostics);
}

const ClockFacts& TunePoints::facts(std::size_t point) {
    Point& at = points_[point];
    if (!at.facts) at.facts.emplace(network(point));
    return *at.facts;
}

std::size_t TunePoints::axis_of(const GridBox& box) const {
    std::size_t best = 0;
    std::pair<bool, std::size_t> most{false, 0};
    for (std::size_t k = 0; k < box.first.size(); ++k) {
        std::vector<std::size_t> end = box.first;
        end[k] = box.last[k];
        const std::size_t a = tuning_.point(box.first), b = tuning_.point(end);
        const bool changes = known(a) && known(b) && &frame(a) != &frame(b);
        const std::pair<bool, std::size_t> here{changes, box.last[k] - box.first[k]};
        if (here.second > 0 && here > most) {
            most = here;
            best = k;
        }
    }
    return best;
}

std::size_t TunePoints::agreement(std::size_t point, const std::string& property) {
    if (set_.frames.size() == 1) return 0;
    auto& [frames, numbers] = agreements_[property];
    const std::size_t frame = *points_[point].frame;
    if (const auto known = numbers.find(frame); known != numbers.end()) return known->second;
    return numbers[frame] = frames.add(with_only(set_.frames[frame], property));
}

}  // namespace grafverif
