// SPDX-License-Identifier: MIT
// Orders and positions the items of layers iteratively. Each item is attracted to the other ends of its lines,
// alternately in the previous and in the next layer. The items of a layer are then placed as near to their preferred
// positions as the order and the gaps permit. These positions are computed by isotonic regression: overlapping items
// are merged into blocks at the mean of their preferred positions. The final layout is the iteration with the smallest
// total length of lines on tracks.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "emit/layout/channels.hpp"

namespace grafverif::layout {

namespace {

/// Minimum distance of parallel lines of different nets.
constexpr int line_gap = 4;

int gap(const Item& above, const Item& below) {
    return above.lane && below.lane ? 10 : above.lane || below.lane ? 13 : 24;
}

/// The preferred start of an item: the weighted mean `sum / weight` of the added positions.
struct PreferredPosition {
    double sum = 0, weight = 0;
    void add(double place, double by) {
        sum += by * place;
        weight += by;
    }
};

class Arranger {
public:
    explicit Arranger(Layers& layers) : layers_(layers), preferred_(layers.items.size()) {
        for (std::vector<std::size_t>& order : layers_.order) place(order);
        for (std::size_t node = 0; node < layers_.arrows.size(); ++node) lay_rows(node);
    }

    void arrange() {
        constexpr int rounds = 10;
        const std::size_t count = layers_.order.size();
        Layers best;
        double shortest = std::numeric_limits<double>::infinity();
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t layer = 1; layer < count; ++layer) draw(layer, true, false, true);
            for (std::size_t layer = count; layer-- > 0;) draw(layer, false, true, true);
            for (std::size_t node = 0; node < layers_.arrows.size(); ++node) lay_rows(node);
            for (int again = 0; again < 2; ++again) {
                for (std::size_t layer = 0; layer < count; ++layer) draw(layer, true, true, false);
                for (std::size_t layer = count; layer-- > 0;) draw(layer, true, true, false);
            }
            const double now = cost();
            if (now >= shortest) continue;
            shortest = now;
            best = layers_;
        }
        if (count > 0) layers_ = std::move(best);
        for (std::size_t layer = 1; layer < count; ++layer) straighten_nodes(layer);
        straighten_lanes();
        for (std::size_t layer = 0; layer < count; ++layer) settle(layer);
        to_origin();
    }

private:
    /// Moves the items of a layer towards the other ends of their lines. If `before` is true, the ends in the previous
    /// layer attract the items; if `after` is true, the ends in the next layer. If `reorder` is true, the items are
    /// also reordered.
    void draw(std::size_t layer, bool before, bool after, bool reorder) {
        std::vector<std::size_t>& order = layers_.order[layer];
        for (const std::size_t item : order) preferred_[item] = {};
        if (before && layer > 0)
            for (const Net& net : layers_.channels[layer - 1]) attract_before(layer - 1, net);
        if (after)
            for (const Net& net : layers_.channels[layer]) attract_after(layer, net);
        if (reorder)
            std::ranges::stable_sort(order, {}, [this](std::size_t item) {
                return preferred_position(item) + layers_.items[item].size / 2.0;
            });
        place(order);
    }

    /// Returns the weight with which a line attracts `item` to the position at which the line is straight. Forward
    /// lines have the highest weight, followed by lanes of backward lines. A backward line has a low weight at a node.
    double weight(std::size_t channel, const Net& net, std::size_t item) const {
        if (layers_.depth[net.target] > channel) return 8;
        return layers_.items[item].lane ? 2 : 0.25;
    }

    void attract_before(std::size_t channel, const Net& net) {
        double sum = 0;
        for (const Port& port : net.near) sum += near_place(layers_, port);
        for (const Port& port : net.far)
            preferred_[port.item].add(sum / static_cast<double>(net.near.size()) - layers_.items[port.item].entry,
                                      weight(channel, net, port.item));
    }

    void attract_after(std::size_t channel, const Net& net) {
        double sum = 0;
        for (const Port& port : net.near) sum += near_place(layers_, port);
        for (const Port& port : net.far) sum += far_place(layers_, port);
        const auto others = static_cast<double>(net.near.size() + net.far.size() - 1);
        for (const Port& port : net.near) {
            const double here = near_place(layers_, port);
            preferred_[port.item].add((sum - here) / others - (here - layers_.items[port.item].at),
                                      weight(channel, net, port.item));
        }
    }

    double preferred_position(std::size_t item) const {
        const PreferredPosition& preferred = preferred_[item];
        return preferred.weight == 0 ? layers_.items[item].at : preferred.sum / preferred.weight;
    }

    /// Assigns to each item the position nearest to its preferred position, under the given order and gaps.
    void place(const std::vector<std::size_t>& order) {
        struct Block {
            double sum = 0, weight = 0;  ///< sum over the preferred positions of the first item of the block
            std::size_t items = 0;
            double begin() const { return sum / weight; }
        };
        std::vector<Block> blocks;
        std::vector<double> offsets;
        for (std::size_t k = 0; k < order.size(); ++k) {
            const Item* const last = k > 0 ? &layers_.items[order[k - 1]] : nullptr;
            offsets.push_back(last == nullptr ? 0 : offsets.back() + last->size + gap(*last, layers_.items[order[k]]));
            const double weight = std::max(0.1, preferred_[order[k]].weight);
            Block block{weight * (preferred_position(order[k]) - offsets.back()), weight, 1};
            for (; !blocks.empty() && blocks.back().begin() >= block.begin(); blocks.pop_back()) {
                block.sum += blocks.back().sum;
                block.weight += blocks.back().weight;
                block.items += blocks.back().items;
            }
            blocks.push_back(block);
        }
        std::size_t k = 0;
        for (const Block& block : blocks)
            for (std::size_t left = block.items; left > 0; --left, ++k)
                layers_.items[order[k]].at = block.begin() + offsets[k];
    }

    /// Orders the rows of a node by the positions of their targets. Rows of loops come first, and rows without a target
    /// come last.
    void lay_rows(std::size_t node) {
        Item& item = layers_.items[node];
        std::vector<std::size_t>& arrows = layers_.arrows[node];
        std::ranges::stable_sort(arrows, {}, [&](std::size_t arrow) { return destination(node, arrow); });
        if (arrows.size() == 1 && !item.is_reached_back) {
            layers_.rows[arrows.front()].at = item.size / 2;
            return;
        }
        int at = (item.size - item.rows) / 2;
        if (item.is_reached_back) {
            item.back_entry = at + back_space / 2;
            at += back_space;
        }
        for (const std::size_t arrow : arrows) {
            Row& row = layers_.rows[arrow];
            row.at = at + row.before;
            at = row.at + row.after;
        }
    }

    double destination(std::size_t node, std::size_t arrow) const {
        constexpr double end = std::numeric_limits<double>::infinity();
        const std::size_t to = layers_.rows[arrow].to;
        if (to == node || to == nothing) return to == node ? -end : end;
        const Net& net = layers_.net(layers_.depth[node], to);
        const bool forward = layers_.depth[to] > layers_.depth[node];
        return forward ? far_place(layers_, net.far.front()) : near_place(layers_, net.near.front());
    }

    /// Moves nodes so that a line from the previous layer enters without a bend, if there is enough space.
    void straighten_nodes(std::size_t layer) {
        constexpr int corner = 10;
        const std::vector<std::size_t>& order = layers_.order[layer];
        for (std::size_t k = 0; k < order.size(); ++k) {
            Item& item = layers_.items[order[k]];
            const auto known = layers_.net_of[layer - 1].find(item.node);
            if (item.lane || known == layers_.net_of[layer - 1].end()) continue;
            const double middle = item.at + item.size / 2;
            double off = std::numeric_limits<double>::infinity();
            for (const Port& port : layers_.channels[layer - 1][known->second].near)
                if (const double here = near_place(layers_, port) - middle; std::abs(here) < std::abs(off)) off = here;
            const Extent range = range_of(order, k);
            const double at = std::max(range.low, std::min(range.high, item.at + off));
            if (std::abs(item.at + off - at) <= item.size / 2 - corner) item.at = at;
        }
    }

    /// Aligns the lanes of a backward line, as far as the neighbouring items permit.
    void straighten_lanes() {
        std::vector<std::size_t> place_of(layers_.items.size());
        for (const std::vector<std::size_t>& order : layers_.order)
            for (std::size_t k = 0; k < order.size(); ++k) place_of[order[k]] = k;
        std::map<std::size_t, std::vector<std::size_t>> runs;  // lanes of each target, in the order of layers
        for (std::size_t layer = 0; layer < layers_.order.size(); ++layer)
            for (const std::size_t item : layers_.order[layer])
                if (layers_.items[item].lane) runs[layers_.items[item].node].push_back(item);
        for (const auto& [target, lanes] : runs) {
            std::size_t layer = layers_.depth[target] + 1;
            for (std::size_t begin = 0, end = 0; begin < lanes.size(); begin = end) {
                Extent range = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
                double sum = 0;
                for (; end < lanes.size(); ++end) {
                    const Extent here = range_of(layers_.order[layer + end], place_of[lanes[end]]);
                    const Extent both = {std::max(range.low, here.low), std::min(range.high, here.high)};
                    if (end > begin && both.low > both.high) break;
                    range = both;
                    sum += layers_.items[lanes[end]].at;
                }
                const double mean = sum / static_cast<double>(end - begin);
                for (std::size_t k = begin; k < end; ++k)
                    layers_.items[lanes[k]].at = std::max(range.low, std::min(range.high, mean));
            }
        }
    }

    /// Returns the range in which the `k`th item of a layer can be moved.
    Extent range_of(const std::vector<std::size_t>& order, std::size_t k) const {
        constexpr double far = std::numeric_limits<double>::infinity();
        const Item& item = layers_.items[order[k]];
        const Item* const above = k > 0 ? &layers_.items[order[k - 1]] : nullptr;
        const Item* const below = k + 1 < order.size() ? &layers_.items[order[k + 1]] : nullptr;
        return {above == nullptr ? -far : above->at + above->size + gap(*above, item),
                below == nullptr ? far : below->at - gap(item, *below) - item.size};
    }

    double cost() const {
        double sum = 0;
        for (const std::vector<Net>& channel : layers_.channels)
            for (const Net& net : channel) {
                const auto [low, high] = extent(layers_, net);
                sum += high - low;
            }
        return sum;
    }

    /// Rounds the positions of the items of a layer, and gives each node an entry that does not coincide with a line of
    /// another net.
    void settle(std::size_t layer) {
        std::map<int, std::size_t> lines;  // incoming lines of the channel before the layer, with their targets
        if (layer > 0)
            for (const Net& net : layers_.channels[layer - 1])
                for (const Port& port : net.near) lines[static_cast<int>(near_place(layers_, port))] = net.target;
        const Item* last = nullptr;
        for (const std::size_t k : layers_.order[layer]) {
            Item& item = layers_.items[k];
            int at = static_cast<int>(std::lround(item.at));
            const int least = last == nullptr ? at - jog : static_cast<int>(last->at) + last->size + gap(*last, item);
            at = std::max(at, least);
            if (item.lane) at = continued(item, at, least, lines);
            while (!enter(item, at, lines)) ++at;
            item.at = at;
            last = &item;
        }
    }

    static constexpr int jog = 12;  ///< minimum length of a jog (a short sideways displacement of a line)

    /// Returns the position of the line that a lane continues if this line is near `at`, otherwise `at`.
    static int continued(const Item& lane, int at, int least, const std::map<int, std::size_t>& lines) {
        for (auto line = lines.lower_bound(std::max(least, at - jog)); line != lines.end() && line->first <= at + jog;
             ++line)
            if (line->second == lane.node) return line->first;
        return at;
    }

    /// Determines the entry for lines to an item that begins at `at`. The entry of a lane is `at`. The entry of a node
    /// is the position of an incoming line if possible, otherwise a position near the middle of the node. Returns false
    /// if each possible entry coincides with a line of another net.
    static bool enter(Item& item, int at, const std::map<int, std::size_t>& lines) {
        constexpr int corner = 8;
        const auto is_free = [&](int place) {
            const auto end = lines.lower_bound(place + line_gap);
            return std::all_of(lines.lower_bound(place - line_gap + 1), end,
                               [&](const auto& line) { return line.second == item.node; });
        };
        if (item.lane) return is_free(at);
        int preferred = item.size / 2;
        const auto end = lines.upper_bound(at + item.size - corner);
        for (auto line = lines.lower_bound(at + corner); line != end; ++line)
            if (line->second == item.node) preferred = line->first - at;
        for (int away = 0; away < item.size; ++away)
            for (const int entry : {preferred - away, preferred + away}) {
                if (entry < corner || entry > item.size - corner || !is_free(at + entry)) continue;
                item.entry = entry;
                return true;
            }
        return false;
    }

    void to_origin() {
        double low = std::numeric_limits<double>::infinity();
        for (const Item& item : layers_.items) low = std::min(low, item.at);
        for (Item& item : layers_.items) item.at -= low;
    }

    Layers& layers_;
    std::vector<PreferredPosition> preferred_;
};

/// The positions of the lines of a net on both sides of its track.
struct Sides {
    std::vector<double> near = {}, far = {};
    Extent extent = {};
};

/// Returns the number of `places` inside `extent`.
std::ptrdiff_t within(const std::vector<double>& places, Extent extent) {
    return std::ranges::lower_bound(places, extent.high) - std::ranges::upper_bound(places, extent.low);
}

/// Returns the number of crossings if the track of `first` precedes the track of `second`.
std::ptrdiff_t crossings_between(const Sides& first, const Sides& second) {
    return within(first.far, second.extent) + within(second.near, first.extent);
}

std::vector<Sides> places_of_nets(const Layers& layers, const std::vector<Net>& channel) {
    std::vector<Sides> list;
    for (const Net& net : channel) {
        Sides& each = list.emplace_back();
        for (const Port& port : net.near) each.near.push_back(near_place(layers, port));
        for (const Port& port : net.far) each.far.push_back(far_place(layers, port));
        std::ranges::sort(each.near);
        std::ranges::sort(each.far);
        each.extent = extent(layers, net);
    }
    return list;
}

}  // namespace

Extent extent(const Layers& layers, const Net& net) {
    Extent extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto include = [&extent](double place) {
        extent = {std::min(extent.low, place), std::max(extent.high, place)};
    };
    for (const Port& port : net.near) include(near_place(layers, port));
    for (const Port& port : net.far) include(far_place(layers, port));
    return extent;
}

void arrange(Layers& layers) { Arranger(layers).arrange(); }

std::size_t assign_tracks(const Layers& layers, std::vector<Net>& channel) {
    constexpr int rounds = 12, track_gap = 6;
    const std::vector<Sides> all = places_of_nets(layers, channel);
    std::vector<std::size_t> order(channel.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&all](std::size_t net) { return all[net].extent.low; });
    bool swapped = true;
    for (int round = 0; swapped && round < rounds; ++round) {
        swapped = false;
        for (std::size_t k = 0; k + 1 < order.size(); ++k) {
            const Sides &first = all[order[k]], &second = all[order[k + 1]];
            if (crossings_between(second, first) >= crossings_between(first, second)) continue;
            std::swap(order[k], order[k + 1]);
            swapped = true;
        }
    }
    std::size_t count = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        std::size_t& track = channel[order[k]].track;
        const Extent here = all[order[k]].extent;
        track = 0;
        for (std::size_t before = 0; before < k; ++before) {
            const Extent there = all[order[before]].extent;
            if (there.low < here.high + track_gap && here.low < there.high + track_gap)
                track = std::max(track, channel[order[before]].track + 1);
        }
        count = std::max(count, track + 1);
    }
    return count;
}

}  // namespace grafverif::layout
