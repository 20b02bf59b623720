// SPDX-License-Identifier: MIT
// What a layered drawing is made of while its places are sought. `Along` is the way it is read, `across` the other one.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "emit/layout/layered.hpp"

namespace grafverif::layout {

inline constexpr std::size_t nothing = static_cast<std::size_t>(-1);

/// What takes up room in a layer: a node with its rows, or a lane for the line that goes back to a node.
struct Item {
    std::size_t node = 0;
    bool lane = false;
    int size = 0;   ///< across
    double at = 0;  ///< across, where it begins
    // of a node:
    bool is_reached_back = false;  ///< by lines that do not come from the layer before it
    int rows = 0;                  ///< across, what its rows need
    int entry = 0;                 ///< from `at`: where the line from the layer before it comes in
    int back_entry = 0;            ///< likewise the other one
};
/// Above the rows of a node that is reached back.
inline constexpr int back_room = 14;

/// Where an arrow leaves its node: across, the room before and behind its line, and that line from Item::at.
struct Row {
    std::size_t to = nothing;
    int before = 0, behind = 0, at = 0;
};

/// Where a line leaves or enters an item.
struct Port {
    std::size_t item = 0;
    std::size_t arrow = nothing;  ///< in the row of this arrow
};

/// The lines to one node in one channel: they meet on a track.
struct Net {
    std::size_t target = 0;
    std::vector<Port> near = {},
                      far = {};  ///< in the layers before and behind the channel; the way to the target first
    std::size_t track = 0;
};

struct Layers {
    std::vector<Item> items = {};                       ///< the nodes first
    std::vector<std::vector<std::size_t>> order = {};   ///< per layer: its items
    std::vector<std::vector<Net>> channels = {};        ///< per layer: the channel behind it
    std::vector<std::vector<std::size_t>> arrows = {};  ///< per node: what leaves it, in the order of the rows
    std::vector<Row> rows = {};                         ///< per arrow
    std::vector<std::size_t> depth = {};                ///< per node: its layer
    std::vector<std::map<std::size_t, std::size_t>> net_of = {};  ///< per channel and target: the place of the net

    const Net& net(std::size_t channel, std::size_t target) const {
        return channels[channel][net_of[channel].at(target)];
    }
};

/// Across, where the line of a port of a net is.
inline double near_place(const Layers& layers, const Port& port) {
    const Item& item = layers.items[port.item];
    return item.at + (port.arrow != nothing ? layers.rows[port.arrow].at : item.back_entry);
}
inline double far_place(const Layers& layers, const Port& port) {
    const Item& item = layers.items[port.item];
    return item.at + item.entry;
}

/// From where to where a net runs on its track.
struct Extent {
    double low = 0, high = 0;
};
Extent extent(const Layers& layers, const Net& net);

/// Puts the items of each layer, and the rows of each node, in an order that makes few lines cross, and at whole places
/// that let no two lines of different nets lie on each other.
void arrange(Layers& layers);

/// Gives the nets of a channel their tracks, by few crossings; nets may share one. Returns how many there are.
/// Requires that the items have their places.
std::size_t assign_tracks(const Layers& layers, std::vector<Net>& channel);

}  // namespace grafverif::layout
