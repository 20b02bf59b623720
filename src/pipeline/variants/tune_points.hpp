// SPDX-License-Identifier: MIT
// Reads and stores the networks of all points of a grid. The networks are members of families (ir/network_family.hpp).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ir/network_family.hpp"
#include "pipeline/variants/tune.hpp"

namespace grafverif {

/// Reads the model again with the values at a point of the grid. Adds the sources to `to`. The result is empty after an
/// error.
std::optional<Model> model_at(const Tuning& tuning, std::size_t point, Id<Source> main, const Sources& sources,
                              ReadOptions options, Sources& to, Diagnostics& diagnostics);

class TunePoints {
public:
    /// All references must outlive this object. `tuning` contains the constants.
    TunePoints(const Model& model, Id<ClosedLoop> loop, Id<Source> main, const Sources& sources,
               const TuneRequest& request, const Tuning& tuning);

    /// Reads the model for each point. All networks have the same time unit, a common divisor of the time units of all
    /// points, and contain `no timelock`, even if the loop does not declare it. Returns false after an error: the model
    /// is rejected for some values. If `stopped` becomes true, the remaining points are not read, and their verdicts
    /// are unknown.
    bool read(const std::function<bool()>& stopped, Diagnostics& diagnostics);

    std::int64_t time_unit_ms() const { return unit_ms_; }
    bool known(std::size_t point) const { return points_[point].frame.has_value(); }
    const Network& frame(std::size_t point) const { return set_.frames[*points_[point].frame]; }
    const ClockConstants& constants(std::size_t point) const { return points_[point].constants; }
    Network network(std::size_t point) const { return network_of(frame(point), constants(point)); }
    const ClockFacts& facts(std::size_t point);
    /// Returns the charts of the controllers at a point. Only charts that are instances depend on the constants.
    std::vector<const Chart*> charts(std::size_t point) const;

    /// Returns the constant along which a box is split: the constant with the most values. Constants that affect a
    /// network in other ways than through its clock constraints have priority.
    std::size_t axis_of(const GridBox& box) const;

    /// Returns a number that is equal for two points if their networks have the same processes, except for the
    /// constants of clock constraints, and the same property `property`.
    std::size_t agreement(std::size_t point, const std::string& property);

private:
    struct Point {
        std::optional<std::size_t> frame = {};
        ClockConstants constants = {};
        std::optional<ClockFacts> facts = {};
        std::optional<std::size_t> charts = {};  ///< index into charts_; empty if no controller is an instance
    };
    /// A set of frames (networks without the constants of clock constraints), indexed by hash.
    struct FrameSet {
        std::vector<Network> frames = {};
        std::multimap<std::uint64_t, std::size_t> by_hash = {};
        std::size_t add(Network frame);
    };
    struct Read {
        std::optional<FamilyMember> member = {};
        std::vector<Chart> charts = {};
        Sources sources = {};
        Diagnostics diagnostics = {};
    };
    void read_point(std::size_t point, std::optional<std::int64_t> unit_ms, Read& read) const;
    bool read_all(std::optional<std::int64_t> unit_ms, const std::function<bool()>& stopped, Diagnostics& diagnostics);
    /// Adds the errors of a point, and those of its warnings whose type was not reported for another point.
    void report(std::size_t point, const Read& read, Diagnostics& diagnostics) const;

    const Model& model_;
    Id<ClosedLoop> loop_;
    Id<Source> main_;
    const Sources& sources_;
    const TuneRequest& request_;
    const Tuning& tuning_;
    std::int64_t unit_ms_ = 0;
    std::vector<Point> points_ = {};
    FrameSet set_ = {};
    std::vector<std::vector<Chart>> charts_ = {};
    std::map<std::string, std::pair<FrameSet, std::map<std::size_t, std::size_t>>> agreements_ = {};
};

}  // namespace grafverif
