// SPDX-License-Identifier: MIT
#include "draw/routes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

namespace grafverif::draw {

namespace {

using Point = Drawing::Point;
using Line = Drawing::Line;

constexpr int track_pitch = 12, channel_margin = 10;
constexpr int double_line = 4;  ///< distance between the two lines of a double line
constexpr int overhang = 10;    ///< length by which a double line extends beyond its outermost links
constexpr int piece_gap = 36;   ///< distance between adjacent pieces of a folded flow
constexpr int page_height = 1600;
constexpr double page_shape = 1.3;  ///< ratio of the height of a page to its width

/// Horizontal lines in the upper or lower part of a channel. Lines that would overlap are on separate tracks.
class Tracks {
public:
    void add(int low, int high, std::size_t& track) { spans_.push_back({low, high, &track}); }

    int assign() {
        std::ranges::stable_sort(spans_, {}, &Span::low);
        std::set<std::pair<int, std::size_t>> free_from;  // for each track: end of its last line, and its number
        for (const Span& span : spans_) {
            const auto first = free_from.begin();
            if (first == free_from.end() || first->first >= span.low) {
                *span.track = free_from.size();
            } else {
                *span.track = first->second;
                free_from.erase(first);
            }
            free_from.emplace(span.high, *span.track);
        }
        return static_cast<int>(free_from.size());
    }

private:
    struct Span {
        int low = 0, high = 0;
        std::size_t* track = nullptr;
    };
    std::vector<Span> spans_ = {};
};

class Router {
public:
    Router(const Flow& flow, const Order& order, const Columns& columns, int pieces)
        : flow_(flow), order_(order), columns_(columns), rows_(std::max<std::size_t>(order.row_count, 1)) {
        assign_tracks();
        settle_heights();
        cut(pieces);
    }

    Routes run() {
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node) {
            routes_.nodes.push_back(placed({columns_.nodes[node], centre(node), piece_of_row(order_.rows[node])}));
            add_meetings(node);
        }
        for (std::size_t arc = 0; arc < flow_.arcs.size(); ++arc) {
            arc_ = arc;
            routes_.arcs.emplace_back();
            order_.upward[arc] ? route_upward(arc) : route_downward(arc);
        }
        return std::move(routes_);
    }

private:
    /// Value that replaces the track of a link that needs no horizontal line.
    static constexpr std::size_t straight = nowhere;

    struct Place {
        int x = 0, y = 0;
        std::size_t piece = 0;
    };

    // -- tracks ------------------------------------------------------------------------------------------------------

    bool meets_below(std::size_t node) const { return flow_.nodes[node].bar && flow_.nodes[node].out.size() > 1; }
    bool meets_above(std::size_t node) const { return flow_.nodes[node].bar && flow_.nodes[node].in.size() > 1; }

    /// `leaves_at` returns the x position at which a link leaves the horizontal line below its first node. `enters_at`
    /// returns the x position at which a link enters the horizontal line above its last node.
    int leaves_at(std::size_t arc) const {
        if (!order_.upward[arc]) return columns_.arcs[arc];
        return has_exit(arc) ? columns_.exits[arc] : lane(arc).x;
    }
    int enters_at(std::size_t arc) const {
        if (!order_.upward[arc]) return columns_.arcs[arc];
        return has_entry(arc) ? columns_.entries[arc] : lane(arc).x;
    }
    const Lane& lane(std::size_t arc) const { return columns_.lanes[columns_.lane_of[arc]]; }
    bool has_exit(std::size_t arc) const { return flow_.nodes[flow_.arcs[arc].from].out.size() > 1; }
    bool has_entry(std::size_t arc) const { return meets_above(flow_.arcs[arc].to); }

    std::pair<int, int> span_below(std::size_t node) const {
        std::pair<int, int> span{columns_.nodes[node], columns_.nodes[node]};
        for (const std::size_t arc : flow_.nodes[node].out)
            span = {std::min(span.first, leaves_at(arc)), std::max(span.second, leaves_at(arc))};
        return span;
    }
    std::pair<int, int> span_above(std::size_t node) const {
        std::pair<int, int> span{columns_.nodes[node], columns_.nodes[node]};
        for (const std::size_t arc : flow_.nodes[node].in)
            span = {std::min(span.first, enters_at(arc)), std::max(span.second, enters_at(arc))};
        return span;
    }

    void assign_tracks() {
        below_.assign(flow_.nodes.size(), straight);
        above_.assign(flow_.nodes.size(), straight);
        exit_.assign(flow_.arcs.size(), straight);
        entry_.assign(flow_.arcs.size(), straight);
        std::vector<Tracks> upper(rows_ + 1), lower(rows_ + 1);
        const auto add = [](Tracks& tracks, std::pair<int, int> span, bool meets, std::size_t& track) {
            if (!meets && span.first == span.second) return;
            const int extra = meets ? overhang + 6 : 6;
            tracks.add(span.first - extra, span.second + extra, track);
        };
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node) {
            const std::size_t row = order_.rows[node];
            add(upper[row + 1], span_below(node), meets_below(node), below_[node]);
            add(lower[row], span_above(node), meets_above(node), above_[node]);
        }
        for (std::size_t arc = 0; arc < flow_.arcs.size(); ++arc) {
            if (!order_.upward[arc]) continue;
            const auto [from, to] = flow_.arcs[arc];
            if (has_exit(arc))
                add(lower[order_.rows[from] + 1], std::minmax(columns_.exits[arc], lane(arc).x), false, exit_[arc]);
            if (has_entry(arc))
                add(upper[order_.rows[to]], std::minmax(columns_.entries[arc], lane(arc).x), false, entry_[arc]);
        }
        for (std::size_t channel = 0; channel <= rows_; ++channel) {
            upper_count_.push_back(upper[channel].assign());
            lower_count_.push_back(lower[channel].assign());
        }
    }

    // -- heights -----------------------------------------------------------------------------------------------------

    void settle_heights() {
        std::vector<int> up(rows_, 0), down(rows_, 0);
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node) {
            const std::size_t row = order_.rows[node];
            up[row] = std::max(up[row], flow_.nodes[node].space.up);
            down[row] = std::max(down[row], flow_.nodes[node].space.down);
        }
        int y = 0;
        for (std::size_t channel = 0; channel <= rows_; ++channel) {
            tops_.push_back(y);
            const int upper = upper_count_[channel] * track_pitch, lower = lower_count_[channel] * track_pitch;
            middles_.push_back(y + upper + channel_margin);
            y += upper + lower + (channel == 0 || channel == rows_ ? 1 : 2) * channel_margin;
            bottoms_.push_back(y);
            if (channel == rows_) break;
            centres_.push_back(y + up[channel]);
            y += up[channel] + down[channel];
        }
    }

    int centre(std::size_t node) const { return centres_[order_.rows[node]]; }
    int upper_y(std::size_t channel, std::size_t track) const {
        return tops_[channel] + channel_margin + static_cast<int>(track) * track_pitch;
    }
    int lower_y(std::size_t channel, std::size_t track) const {
        return bottoms_[channel] - channel_margin - static_cast<int>(track) * track_pitch;
    }

    // -- folding -----------------------------------------------------------------------------------------------------

    /// Returns, for each channel, the number of vertical lines that cross its middle.
    std::vector<int> passing() const {
        std::vector<int> changes(rows_ + 2, 0);
        const auto pass = [&](std::size_t first, std::size_t last) {
            if (first > last) return;
            ++changes[first];
            --changes[last + 1];
        };
        for (std::size_t arc = 0; arc < flow_.arcs.size(); ++arc)
            if (!order_.upward[arc]) pass(order_.rows[flow_.arcs[arc].from] + 1, order_.rows[flow_.arcs[arc].to]);
        for (const Lane& lane : columns_.lanes) pass(lane.low / 2, lane.high / 2);
        for (std::size_t channel = 1; channel < changes.size(); ++channel) changes[channel] += changes[channel - 1];
        return changes;
    }

    void cut(int pieces) {
        const int height = bottoms_.back();
        if (pieces == 0 && height > page_height)
            pieces = static_cast<int>(std::ceil(std::sqrt(height / (page_shape * (columns_.width + piece_gap)))));
        const std::vector<int> crossing = passing();
        begins_ = {0};
        for (int piece = 1; piece < pieces; ++piece) {
            const std::int64_t aim = std::int64_t{height} * piece / pieces, slack = height / pieces / 5;
            const auto from = std::ranges::lower_bound(middles_, static_cast<int>(aim - slack)) - middles_.begin();
            std::size_t best = nowhere;
            for (auto channel = static_cast<std::size_t>(from); channel < rows_; ++channel) {
                if (middles_[channel] > aim + slack && best != nowhere) break;
                const bool better = best == nowhere || crossing[channel] < crossing[best] ||
                                    (crossing[channel] == crossing[best] &&
                                     std::abs(middles_[channel] - aim) < std::abs(middles_[best] - aim));
                if (channel > begins_.back() && better) best = channel;
            }
            if (best != nowhere) begins_.push_back(best);
        }
        measure_pieces();
    }

    /// Computes the horizontal extent of each piece from the nodes and links in the piece, and the positions of the
    /// pieces.
    void measure_pieces() {
        const std::size_t count = begins_.size();
        std::vector<int> left(count, columns_.width), right(count, 0);
        const auto reach = [&](std::size_t first, std::size_t last, int low, int high) {
            for (std::size_t piece = first; piece <= last; ++piece) {
                left[piece] = std::min(left[piece], low);
                right[piece] = std::max(right[piece], high);
            }
        };
        for (std::size_t node = 0; node < flow_.nodes.size(); ++node) {
            const std::size_t piece = piece_of_row(order_.rows[node]);
            const ReservedSpace& space = flow_.nodes[node].space;
            reach(piece, piece, columns_.nodes[node] - space.left, columns_.nodes[node] + space.right);
        }
        for (std::size_t arc = 0; arc < flow_.arcs.size(); ++arc) {
            const std::size_t from = order_.rows[flow_.arcs[arc].from], to = order_.rows[flow_.arcs[arc].to];
            const std::size_t first = piece_of_row(std::max<std::size_t>(std::min(from, to), 1) - 1);
            const std::size_t last = piece_of_row(std::min(std::max(from, to) + 1, rows_ - 1));
            std::vector<int> passed{order_.upward[arc] ? lane(arc).x : columns_.arcs[arc]};
            if (order_.upward[arc] && has_exit(arc)) passed.push_back(columns_.exits[arc]);
            if (order_.upward[arc] && has_entry(arc)) passed.push_back(columns_.entries[arc]);
            for (const int x : passed) reach(first, last, x - overhang, x + overhang);
        }
        int x = 0;
        for (std::size_t piece = 0; piece < count; ++piece) {
            const std::size_t end = piece + 1 < count ? begins_[piece + 1] : rows_;
            const int begin_y = piece == 0 ? 0 : middles_[begins_[piece]] - reference_height - channel_margin;
            const int end_y = piece + 1 < count ? middles_[end] + reference_height + channel_margin : bottoms_.back();
            if (count == 1) left[0] = 0, right[0] = columns_.width;
            shift_x_.push_back(x - left[piece]);
            shift_y_.push_back(-begin_y);
            x += std::max(0, right[piece] - left[piece]) + piece_gap;
            routes_.size.height = std::max(routes_.size.height, end_y - begin_y);
        }
        routes_.size.width = x - piece_gap;
    }

    std::size_t piece_of_row(std::size_t row) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(begins_, row) - begins_.begin()) - 1;
    }
    Point placed(const Place& place) const {
        return {place.x + shift_x_[place.piece], place.y + shift_y_[place.piece]};
    }

    // -- lines -------------------------------------------------------------------------------------------------------

    /// `upper` and `lower` return a point on a track in the upper or lower part of `channel`.
    Place upper(int x, std::size_t channel, std::size_t track) const {
        return {x, upper_y(channel, track), piece_of_row(channel == 0 ? 0 : channel - 1)};
    }
    Place lower(int x, std::size_t channel, std::size_t track) const {
        return {x, lower_y(channel, track), piece_of_row(std::min(channel, rows_ - 1))};
    }
    Place port(std::size_t node, int sign) const {
        return {columns_.nodes[node], centre(node) + sign * flow_.nodes[node].port, piece_of_row(order_.rows[node])};
    }

    void add_meetings(std::size_t node) {
        const std::size_t row = order_.rows[node];
        const auto meet = [&](std::pair<int, int> span, Place from, Place to, int further) {
            Routes::Meeting meeting{node, {}};
            if (from.y != to.y) meeting.lines.push_back({{placed(from), placed(to)}});
            for (const int y : {to.y, to.y + further})
                meeting.lines.push_back(
                    {{placed({span.first - overhang, y, to.piece}), placed({span.second + overhang, y, to.piece})}});
            routes_.meetings.push_back(std::move(meeting));
        };
        if (meets_above(node))
            meet(span_above(node), port(node, -1), lower(columns_.nodes[node], row, above_[node]), -double_line);
        if (meets_below(node))
            meet(span_below(node), port(node, 1), upper(columns_.nodes[node], row + 1, below_[node]), double_line);
    }

    /// Returns the path of a link from its first node to the column in which the link continues downwards.
    std::vector<Place> beginning(std::size_t arc) const {
        const std::size_t node = flow_.arcs[arc].from, channel = order_.rows[node] + 1;
        if (meets_below(node)) {
            Place place = upper(leaves_at(arc), channel, below_[node]);
            place.y += double_line;
            return {place};
        }
        if (below_[node] == straight) return {port(node, 1)};
        return {port(node, 1), upper(columns_.nodes[node], channel, below_[node]),
                upper(leaves_at(arc), channel, below_[node])};
    }
    std::vector<Place> end(std::size_t arc) const {
        const std::size_t node = flow_.arcs[arc].to, channel = order_.rows[node];
        if (meets_above(node)) {
            Place place = lower(enters_at(arc), channel, above_[node]);
            place.y -= double_line;
            return {place};
        }
        if (above_[node] == straight) return {port(node, -1)};
        return {lower(enters_at(arc), channel, above_[node]), lower(columns_.nodes[node], channel, above_[node]),
                port(node, -1)};
    }

    void route_downward(std::size_t arc) {
        std::vector<Place> places = beginning(arc);
        for (const Place& place : end(arc)) places.push_back(place);
        add_lines(places);
    }

    /// Routes an upward link: down and to its lane, up the lane (with an arrow next to the target node) to above the
    /// target node, and down into this node.
    void route_upward(std::size_t arc) {
        const auto [from, to] = flow_.arcs[arc];
        const int x = lane(arc).x;
        std::vector<Place> up = beginning(arc);
        if (has_exit(arc)) {
            up.push_back(lower(columns_.exits[arc], order_.rows[from] + 1, exit_[arc]));
            up.push_back(lower(x, order_.rows[from] + 1, exit_[arc]));
        }
        const Place arrow{x, centre(to), piece_of_row(order_.rows[to])};
        up.push_back(arrow);
        add_lines(up);
        routes_.arcs[arc].back().arrow = true;
        std::vector<Place> down{arrow};
        if (has_entry(arc)) {
            down.push_back(upper(x, order_.rows[to], entry_[arc]));
            down.push_back(upper(columns_.entries[arc], order_.rows[to], entry_[arc]));
        }
        for (const Place& place : end(arc)) down.push_back(place);
        add_lines(down);
    }

    /// Adds lines that connect `places`. The lines are cut at the boundaries of pieces.
    void add_lines(const std::vector<Place>& places) {
        std::vector<Line>& lines = routes_.arcs[arc_];
        lines.emplace_back();
        const auto add = [&](const Place& place) {
            std::vector<Point>& points = lines.back().points;
            const Point point = placed(place);
            if (!points.empty() && points.back() == point) return;
            const std::size_t size = points.size();
            if (size > 1 && ((points[size - 2].x == points[size - 1].x && points[size - 1].x == point.x) ||
                             (points[size - 2].y == points[size - 1].y && points[size - 1].y == point.y)))
                points.back() = point;
            else points.push_back(point);
        };
        std::size_t piece = places.front().piece;
        for (const Place& place : places) {
            while (piece != place.piece) {
                const bool down = piece < place.piece;
                const std::size_t next = down ? piece + 1 : piece - 1, boundary = std::max(piece, next);
                const int middle = middles_[begins_[boundary]], before = down ? channel_margin : -channel_margin;
                add({place.x, middle + before, piece});
                refer(lines.back().points.back(), down, place.x, boundary);
                lines.emplace_back();
                piece = next;
                add({place.x, middle - before, piece});
                refer(lines.back().points.back(), !down, place.x, boundary);
            }
            add(place);
        }
    }

    /// Adds a label to one end of a line that is cut at `boundary`. Links with the same x position share a line; each
    /// end of a shared line has only one label.
    void refer(Point at, bool below, int x, std::size_t boundary) {
        const std::size_t number = numbers_.try_emplace({boundary, x}, numbers_.size() + 1).first->second;
        if (named_.emplace(number, below).second) routes_.references.push_back({at, below, number, arc_});
    }

    const Flow& flow_;
    const Order& order_;
    const Columns& columns_;
    std::size_t rows_;
    /// For each node: track of its links below the node, and above the node.
    std::vector<std::size_t> below_ = {}, above_ = {};
    std::vector<std::size_t> exit_ = {}, entry_ = {};  ///< for each arc: tracks of its stubs
    std::vector<int> upper_count_ = {}, lower_count_ = {};
    /// For each channel: y positions of its top, middle and bottom.
    std::vector<int> tops_ = {}, middles_ = {}, bottoms_ = {};
    std::vector<int> centres_ = {};                 ///< for each row: y position of its centre
    std::vector<std::size_t> begins_ = {};          ///< for each piece of a folded flow: its first row
    std::vector<int> shift_x_ = {}, shift_y_ = {};  ///< for each piece of a folded flow: its displacement

    /// For each cut line: its number, by boundary and x position.
    std::map<std::pair<std::size_t, int>, std::size_t> numbers_ = {};
    std::set<std::pair<std::size_t, bool>> named_ = {};
    std::size_t arc_ = 0;
    Routes routes_ = {};
};

}  // namespace

Routes routes_of(const Flow& flow, const Order& order, const Columns& columns, int pieces) {
    return Router(flow, order, columns, pieces).run();
}

}  // namespace grafverif::draw
