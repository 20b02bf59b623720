// SPDX-License-Identifier: MIT
#include "emit/layout/layered.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <utility>

#include "emit/layout/channels.hpp"

namespace grafverif::layout {

namespace {

constexpr int label_margin = 5;  ///< space between a label and its line, and between a label and the box
constexpr int loop_depth = 9;    ///< distance between the two lines of a loop

/// Distances in a channel: before its tracks, between them, and after them.
constexpr int before_tracks = 10, track_gap = 9, after_tracks = 18;

/// Converts between the coordinates along/across and x/y, for both reading directions.
struct Axes {
    Direction direction = Direction::Across;

    int along(Size size) const { return direction == Direction::Across ? size.width : size.height; }
    int across(Size size) const { return direction == Direction::Across ? size.height : size.width; }
    Point point(int along, int across) const {
        return direction == Direction::Across ? Point{along, across} : Point{across, along};
    }
    Box box(int along, int across, int length, int breadth) const {
        const Point size = point(length, breadth);
        return {point(along, across), {size.x, size.y}};
    }
};

/// Returns the distance of each node from the first node. Unreachable nodes get larger distances than all other nodes,
/// so that no forward arrow skips a layer.
std::vector<std::size_t> depths(const States& states) {
    std::vector<std::vector<std::size_t>> next(states.nodes.size());
    for (const States::Arrow& arrow : states.arrows)
        if (!arrow.ends) next[arrow.from].push_back(arrow.to);
    std::vector<std::size_t> depth(states.nodes.size(), nothing);
    std::size_t layers = 0;
    const auto explore = [&](std::size_t first) {
        if (depth[first] != nothing) return;
        depth[first] = layers;
        for (std::queue<std::size_t> found({first}); !found.empty(); found.pop()) {
            layers = std::max(layers, depth[found.front()] + 1);
            for (const std::size_t to : next[found.front()])
                if (depth[to] == nothing) {
                    depth[to] = depth[found.front()] + 1;
                    found.push(to);
                }
        }
    };
    if (!states.nodes.empty()) explore(states.first);
    for (std::size_t node = 0; node < states.nodes.size(); ++node) explore(node);
    return depth;
}

class Layering {
public:
    Layering(const States& states, Axes axes) : states_(states), axes_(axes) { layers_.depth = depths(states); }

    Layers layers() {
        const std::size_t count = states_.nodes.empty() ? 0 : *std::ranges::max_element(layers_.depth) + 1;
        layers_.order.resize(count);
        layers_.channels.resize(count);
        layers_.net_of.resize(count);
        layers_.arrows.resize(states_.nodes.size());
        for (std::size_t node = 0; node < states_.nodes.size(); ++node) {
            layers_.items.push_back({.node = node});
            layers_.order[layers_.depth[node]].push_back(node);
        }
        for (std::size_t k = 0; k < states_.arrows.size(); ++k) add_arrow(k);
        for (std::size_t node = 0; node < states_.nodes.size(); ++node) measure(node);
        return std::move(layers_);
    }

private:
    void add_arrow(std::size_t k) {
        const States::Arrow& arrow = states_.arrows[k];
        layers_.arrows[arrow.from].push_back(k);
        layers_.rows.push_back(row(arrow));
        if (arrow.ends || arrow.from == arrow.to) return;
        const std::size_t layer = layers_.depth[arrow.from];
        net(layer, arrow.to).near.push_back({arrow.from, k});
        if (layers_.depth[arrow.to] <= layer) lead_back(arrow.to, layer);
    }

    /// Returns the net of lines to node `target` in a channel. If the net is new and the channel is adjacent to the
    /// node, the net starts with the port of the node.
    Net& net(std::size_t channel, std::size_t target) {
        std::vector<Net>& nets = layers_.channels[channel];
        const auto [known, added] = layers_.net_of[channel].try_emplace(target, nets.size());
        if (!added) return nets[known->second];
        nets.push_back({.target = target});
        if (layers_.depth[target] == channel + 1) nets.back().far.push_back({target});
        if (layers_.depth[target] == channel) nets.back().near.push_back({target});
        return nets.back();
    }

    /// Adds the missing lanes of a backward line: one in each layer between `layer` and the layer of the target.
    void lead_back(std::size_t target, std::size_t layer) {
        layers_.items[target].is_reached_back = true;
        for (; layer > layers_.depth[target] && lanes_.insert({layer, target}).second; --layer) {
            const Port lane{layers_.items.size()};
            layers_.items.push_back({.node = target, .lane = true});
            layers_.order[layer].push_back(lane.item);
            std::vector<Port>& near = net(layer, target).near;
            near.insert(near.begin(), lane);  // the port towards the target must be the first port
            net(layer - 1, target).far.push_back(lane);
        }
    }

    Row row(const States::Arrow& arrow) const {
        const int label = axes_.across(arrow.label);
        const int loop = arrow.from == arrow.to && !arrow.ends ? loop_depth : 0;
        const std::size_t to = arrow.ends ? nothing : arrow.to;
        if (axes_.direction == Direction::Across) return {to, label + 3, 5 + loop};
        return {to, 8, label + 2 * label_margin + loop};
    }

    /// Computes the size of a node from its text and rows.
    void measure(std::size_t node) {
        Item& item = layers_.items[node];
        item.rows = item.is_reached_back ? back_space : 0;
        for (const std::size_t arrow : layers_.arrows[node]) {
            const Row& row = layers_.rows[arrow];
            const bool in_middle = layers_.arrows[node].size() == 1 && !item.is_reached_back;
            item.rows += in_middle ? 2 * std::max(row.before, row.after) : row.before + row.after;
        }
        item.size = std::max(axes_.across(states_.nodes[node]), item.rows);
        item.entry = item.size / 2;
    }

    const States& states_;
    Axes axes_;
    Layers layers_ = {};
    std::set<std::pair<std::size_t, std::size_t>> lanes_ = {};  ///< existing lanes by layer and target
};

/// Converts layers with positioned items into a drawing.
class Painter {
public:
    Painter(const States& states, Axes axes, Layers& layers) : states_(states), axes_(axes), layers_(layers) {}

    Layered paint() {
        drawing_.nodes.resize(states_.nodes.size());
        drawing_.arrows.resize(states_.arrows.size());
        int along = 0;
        for (std::size_t layer = 0; layer < layers_.order.size(); ++layer) along = place_layer(layer, along);
        for (std::size_t layer = 0; layer < layers_.order.size(); ++layer) {
            for (const std::size_t item : layers_.order[layer])
                if (!layers_.items[item].lane) draw_node(layers_.items[item], places_[layer]);
            for (const Net& net : layers_.channels[layer]) add_joints(net, track(layer, net));
        }
        double breadth = 0;
        for (const Item& item : layers_.items) breadth = std::max(breadth, item.at + item.size);
        const Box all = axes_.box(0, 0, along, static_cast<int>(breadth));
        drawing_.size = all.size;
        return std::move(drawing_);
    }

private:
    /// Positions in the direction `along`: the positions of the nodes of a layer, of their rows, and of the channel
    /// after the layer.
    struct Place {
        int nodes = 0, rows = 0, channel = 0;
    };

    /// Places a layer at `along`. Returns the start of the next layer.
    int place_layer(std::size_t layer, int along) {
        int nodes = 0, rows = 0;
        for (const std::size_t item : layers_.order[layer]) {
            const std::size_t node = layers_.items[item].node;
            if (layers_.items[item].lane) continue;
            nodes = std::max(nodes, axes_.along(states_.nodes[node]));
            for (const std::size_t arrow : layers_.arrows[node]) rows = std::max(rows, length(arrow));
        }
        places_.push_back({along, along + nodes, along + nodes + rows});
        const std::size_t tracks = assign_tracks(layers_, layers_.channels[layer]);
        along += nodes + rows;
        return tracks == 0 ? along + before_tracks
                           : along + before_tracks + static_cast<int>(tracks) * track_gap + after_tracks;
    }

    /// Returns the length of a row with its label.
    int length(std::size_t arrow) const { return axes_.along(states_.arrows[arrow].label) + 3 * label_margin; }

    int track(std::size_t channel, const Net& net) const {
        return places_[channel].channel + before_tracks + static_cast<int>(net.track) * track_gap;
    }

    void draw_node(const Item& item, const Place& place) {
        const int at = static_cast<int>(item.at);
        drawing_.nodes[item.node] = axes_.box(place.nodes, at, place.rows - place.nodes, item.size);
        for (const std::size_t k : layers_.arrows[item.node]) {
            const Size label = states_.arrows[k].label;
            const int row = at + layers_.rows[k].at;
            const bool across = axes_.direction == Direction::Across;
            drawing_.arrows[k].label = axes_.box(place.rows + (across ? 2 : 1) * label_margin,
                                                 across ? row - 1 - label.height : row + label_margin,
                                                 axes_.along(label), axes_.across(label));
            line_.clear();
            to(place.rows, row);
            draw_line(k, place, row);
            drawing_.arrows[k].points = std::move(line_);
        }
    }

    void draw_line(std::size_t k, const Place& place, int row) {
        const States::Arrow& arrow = states_.arrows[k];
        if (arrow.ends) return to(place.rows + length(k), row);
        if (arrow.from == arrow.to) {
            const bool across = axes_.direction == Direction::Across;
            const int back = row + (across ? loop_depth : arrow.label.width + 2 * label_margin);
            to(place.rows + length(k), row);
            to(place.rows + length(k), back);
            return to(place.rows, back);
        }
        for (std::size_t channel = layers_.depth[arrow.from];; --channel) {
            const Net& net = layers_.net(channel, arrow.to);
            const bool forward = layers_.depth[arrow.to] > channel;
            const Port& next = forward ? net.far.front() : net.near.front();
            const int destination = static_cast<int>(forward ? far_place(layers_, next) : near_place(layers_, next));
            to(track(channel, net), row);
            to(track(channel, net), destination);
            if (forward) return to(places_[channel + 1].nodes, destination);
            if (!layers_.items[next.item].lane) return to(places_[channel].rows, destination);
            row = destination;
        }
    }

    /// Continues the current line to a point. Points at which the line does not turn are omitted.
    void to(int along, int across) {
        const Point next = axes_.point(along, across);
        if (!line_.empty() && line_.back() == next) return;
        if (line_.size() > 1) {
            const Point last = line_.back(), before = line_[line_.size() - 2];
            if ((before.x == last.x && last.x == next.x) || (before.y == last.y && last.y == next.y)) line_.pop_back();
        }
        line_.push_back(next);
    }

    void add_joints(const Net& net, int along) {
        const auto [low, high] = extent(layers_, net);
        std::map<int, int> lines;  // lines that leave the track, indexed by position
        for (const Port& port : net.near) lines[static_cast<int>(near_place(layers_, port))] |= 1;
        for (const Port& port : net.far) lines[static_cast<int>(far_place(layers_, port))] |= 2;
        for (const auto& [place, sides] : lines)
            if ((sides == 3 ? 2 : 1) + (place > low ? 1 : 0) + (place < high ? 1 : 0) > 2)
                drawing_.joints.push_back(axes_.point(along, place));
    }

    const States& states_;
    Axes axes_;
    Layers& layers_;
    Layered drawing_ = {};
    std::vector<Place> places_ = {};  ///< position of each layer
    std::vector<Point> line_ = {};    ///< points of the current line
};

}  // namespace

Layered layered(const States& states, Direction direction) {
    const Axes axes{direction};
    Layers layers = Layering(states, axes).layers();
    arrange(layers);
    return Painter(states, axes, layers).paint();
}

}  // namespace grafverif::layout
