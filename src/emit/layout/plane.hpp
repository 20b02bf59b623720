// SPDX-License-Identifier: MIT
// The plane of a drawing: vectors, and the elements that have already been placed.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "emit/layout/layout.hpp"

namespace grafverif::layout {

struct Vector {
    double x = 0, y = 0;
};

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator*(double k, Vector a) { return {k * a.x, k * a.y}; }
inline double length(Vector a) { return std::hypot(a.x, a.y); }
inline Vector unit(Vector a) { return length(a) < 1e-9 ? Vector{1, 0} : (1 / length(a)) * a; }
inline Vector normal(Vector a) { return {-a.y, a.x}; }
inline Vector direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
inline Vector vector(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }
inline Point point(Vector a) { return {static_cast<int>(std::lround(a.x)), static_cast<int>(std::lround(a.y))}; }

/// Returns half the extent of a box in the direction of the unit vector `along`.
inline double reach(Size size, Vector along) {
    return (std::abs(along.x) * size.width + std::abs(along.y) * size.height) / 2;
}

struct Segment {
    Vector from = {}, to = {};
};

/// The boxes and lines that have already been placed. Boxes are indexed by the grid squares that they touch.
class Plane {
public:
    void add(const Box& box);
    void add(const Segment& segment) { segments_.push_back(segment); }

    bool is_free(const Box& box) const;
    /// Returns the number of lines that intersect the box.
    int crossings(const Box& box) const;
    /// Returns the maximum y of all boxes.
    int bottom() const { return bottom_; }
    int left() const { return left_; }

private:
    template <class Visit>
    void each_cell(const Box& box, const Visit& visit) const;

    std::vector<Box> boxes_ = {};
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_ = {};
    std::vector<Segment> segments_ = {};
    int bottom_ = 0, left_ = 0;
};

}  // namespace grafverif::layout
