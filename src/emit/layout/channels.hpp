// SPDX-License-Identifier: MIT
// Data of a layered drawing during layout. `Along` is the reading direction, `across` the perpendicular one.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "emit/layout/layered.hpp"

namespace grafverif::layout {

inline constexpr std::size_t nothing = static_cast<std::size_t>(-1);

/// An item that occupies space in a layer: a node with its rows, or a lane for a line back to a node.
struct Item {
    std::size_t node = 0;
    bool lane = false;
    int size = 0;   ///< extent across
    double at = 0;  ///< start across
    // of a node:
    bool is_reached_back = false;  ///< has incoming lines that do not come from the previous layer
    int rows = 0;                  ///< extent of its rows across
    int entry = 0;                 ///< relative to `at`: entry of lines from the previous layer
    int back_entry = 0;            ///< the same for other lines
};
/// Space above the rows of a node with backward lines.
inline constexpr int back_room = 14;

/// Outgoing arrow of a node. Across: the space before and after its line, and the position of the line relative to
/// Item::at.
struct Row {
    std::size_t to = nothing;
    int before = 0, behind = 0, at = 0;
};

/// Point where a line leaves or enters an item.
struct Port {
    std::size_t item = 0;
    std::size_t arrow = nothing;  ///< in the row of this arrow
};

/// The lines to one node in one channel; they join on a track.
struct Net {
    std::size_t target = 0;
    std::vector<Port> near = {},
                      far = {};  ///< ports in the layers before and after the channel; the one towards the target first
    std::size_t track = 0;
};

struct Layers {
    std::vector<Item> items = {};                       ///< nodes first
    std::vector<std::vector<std::size_t>> order = {};   ///< items per layer
    std::vector<std::vector<Net>> channels = {};        ///< per layer: the channel after it
    std::vector<std::vector<std::size_t>> arrows = {};  ///< per node: outgoing arrows in the order of the rows
    std::vector<Row> rows = {};                         ///< per arrow
    std::vector<std::size_t> depth = {};                ///< layer per node
    std::vector<std::map<std::size_t, std::size_t>> net_of = {};  ///< per channel and target: index of the net

    const Net& net(std::size_t channel, std::size_t target) const {
        return channels[channel][net_of[channel].at(target)];
    }
};

/// Position across of the line at a port of a net.
inline double near_place(const Layers& layers, const Port& port) {
    const Item& item = layers.items[port.item];
    return item.at + (port.arrow != nothing ? layers.rows[port.arrow].at : item.back_entry);
}
inline double far_place(const Layers& layers, const Port& port) {
    const Item& item = layers.items[port.item];
    return item.at + item.entry;
}

/// Range of a net on its track.
struct Extent {
    double low = 0, high = 0;
};
Extent extent(const Layers& layers, const Net& net);

/// Orders the items of each layer, and the rows of each node, to minimize crossings. Assigns integer positions such
/// that lines of different nets do not coincide.
void arrange(Layers& layers);

/// Assigns tracks to the nets of a channel, minimizing crossings; nets may share a track. Returns the number of tracks.
/// Requires that the items have positions.
std::size_t assign_tracks(const Layers& layers, std::vector<Net>& channel);

}  // namespace grafverif::layout
