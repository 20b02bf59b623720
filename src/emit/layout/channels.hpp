// SPDX-License-Identifier: MIT
// Data of a layered drawing during layout. The direction `along` is the reading direction; the direction `across` is
// perpendicular to it.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "emit/layout/layered.hpp"

namespace grafverif::layout {

inline constexpr std::size_t nothing = static_cast<std::size_t>(-1);

/// An item that occupies space in a layer: a node with its rows, or a lane for a backward line to a node.
struct Item {
    std::size_t node = 0;
    bool lane = false;
    int size = 0;   ///< size in the direction `across`
    double at = 0;  ///< start in the direction `across`

    // The following members are valid only for a node.
    bool is_reached_back = false;  ///< true if the node has incoming lines that do not come from the previous layer
    int rows = 0;                  ///< size of the rows in the direction `across`
    int entry = 0;                 ///< position of incoming lines from the previous layer, relative to `at`
    int back_entry = 0;            ///< position of all other incoming lines, relative to `at`
};
/// Height of the space above the rows of a node that has incoming backward lines.
inline constexpr int back_space = 14;

/// An outgoing arrow of a node. All values are distances in the direction `across`: the space before and after the line
/// of the arrow, and the position of the line relative to Item::at.
struct Row {
    std::size_t to = nothing;
    int before = 0, after = 0, at = 0;
};

/// A point at which a line leaves or enters an item.
struct Port {
    std::size_t item = 0;
    std::size_t arrow = nothing;  ///< arrow whose row contains the port; `nothing` if the port is not in a row
};

/// A net: the lines to one node in one channel (the space between two layers). All lines of a net join on one track.
struct Net {
    std::size_t target = 0;
    /// Ports in the layers before and after the channel; the port towards the target is first.
    std::vector<Port> near = {}, far = {};
    std::size_t track = 0;
};

struct Layers {
    std::vector<Item> items = {};                       ///< all items: nodes first, then lanes
    std::vector<std::vector<std::size_t>> order = {};   ///< order of the items in each layer
    std::vector<std::vector<Net>> channels = {};        ///< nets of the channel after each layer
    std::vector<std::vector<std::size_t>> arrows = {};  ///< outgoing arrows of each node, in the order of the rows
    std::vector<Row> rows = {};                         ///< row in which each arrow leaves its node
    std::vector<std::size_t> depth = {};                ///< layer of each node
    std::vector<std::map<std::size_t, std::size_t>> net_of = {};  ///< index of the net by target, per channel

    const Net& net(std::size_t channel, std::size_t target) const {
        return channels[channel][net_of[channel].at(target)];
    }
};

/// Returns the position, in the direction `across`, of the line at a port of a net.
inline double near_place(const Layers& layers, const Port& port) {
    const Item& item = layers.items[port.item];
    return item.at + (port.arrow != nothing ? layers.rows[port.arrow].at : item.back_entry);
}
inline double far_place(const Layers& layers, const Port& port) {
    const Item& item = layers.items[port.item];
    return item.at + item.entry;
}

/// The range that a net occupies on its track.
struct Extent {
    double low = 0, high = 0;
};
Extent extent(const Layers& layers, const Net& net);

/// Orders the items of each layer, and the rows of each node, to minimize crossings. Assigns integer positions such
/// that lines of different nets do not coincide.
void arrange(Layers& layers);

/// Assigns tracks to the nets of a channel such that few nets cross. Several nets may share a track. Returns the number
/// of tracks. Requires that the items have positions.
std::size_t assign_tracks(const Layers& layers, std::vector<Net>& channel);

}  // namespace grafverif::layout
