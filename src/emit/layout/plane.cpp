// SPDX-License-Identifier: MIT
#include "emit/layout/plane.hpp"

#include <algorithm>

namespace grafverif::layout {
namespace {

constexpr int cell = 128;

int cell_of(int coordinate) { return coordinate >= 0 ? coordinate / cell : -((cell - 1 - coordinate) / cell); }

std::uint64_t key(int column, int row) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32U) | static_cast<std::uint32_t>(row);
}

/// True if the segment intersects the box, that is, if some point of the segment is in all four half planes that bound
/// the box.
bool runs_through(const Segment& segment, const Box& box) {
    const Vector step = segment.to - segment.from;
    double first = 0, last = 1;
    const auto clip = [&](double slope, double limit) {  // restricts t to values with slope * t <= limit
        if (std::abs(slope) < 1e-9) return limit >= 0;
        if (slope > 0) last = std::min(last, limit / slope);
        else first = std::max(first, limit / slope);
        return first <= last;
    };
    return clip(-step.x, segment.from.x - box.at.x) && clip(step.x, box.at.x + box.size.width - segment.from.x) &&
           clip(-step.y, segment.from.y - box.at.y) && clip(step.y, box.at.y + box.size.height - segment.from.y);
}

}  // namespace

bool overlap(const Box& left, const Box& right) {
    return left.at.x < right.at.x + right.size.width && right.at.x < left.at.x + left.size.width &&
           left.at.y < right.at.y + right.size.height && right.at.y < left.at.y + left.size.height;
}

Box node_box(Point centre) {
    return {{centre.x - node_radius, centre.y - node_radius}, {2 * node_radius, 2 * node_radius}};
}

template <class Visit>
void Plane::each_cell(const Box& box, const Visit& visit) const {
    for (int column = cell_of(box.at.x); column <= cell_of(box.at.x + box.size.width); ++column)
        for (int row = cell_of(box.at.y); row <= cell_of(box.at.y + box.size.height); ++row) visit(key(column, row));
}

void Plane::add(const Box& box) {
    const auto index = static_cast<std::uint32_t>(boxes_.size());
    boxes_.push_back(box);
    each_cell(box, [&](std::uint64_t at) { cells_[at].push_back(index); });
    bottom_ = index == 0 ? box.at.y + box.size.height : std::max(bottom_, box.at.y + box.size.height);
    left_ = index == 0 ? box.at.x : std::min(left_, box.at.x);
}

bool Plane::is_free(const Box& box) const {
    bool free = true;
    each_cell(box, [&](std::uint64_t at) {
        const auto found = free ? cells_.find(at) : cells_.end();
        if (found == cells_.end()) return;
        free = std::ranges::none_of(found->second, [&](std::uint32_t index) { return overlap(boxes_[index], box); });
    });
    return free;
}

int Plane::crossings(const Box& box) const {
    return static_cast<int>(
        std::ranges::count_if(segments_, [&](const Segment& line) { return runs_through(line, box); }));
}

}  // namespace grafverif::layout
