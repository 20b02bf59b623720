// SPDX-License-Identifier: MIT
#include "draw/columns.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace grafverif::draw {

namespace {

constexpr int gap = 14;                 ///< minimum horizontal distance between parallel parts
constexpr std::size_t rounds = 8;       ///< number of iterations for ordering the strips of a Core
constexpr std::size_t far_enough = 32;  ///< maximum number of parallel parts examined to choose a side

/// Horizontal extent of a block to the left and to the right of its axis, and offset of its axis from the axis of its
/// parent.
struct Reach {
    int left = 0, right = 0, offset = 0;
};

enum class Side : unsigned char { Left, Right };

/// The lanes on one side of a block.
struct SideLanes {
    std::vector<std::size_t> lanes = {};
    int width = 0;
};

class Assignment {
public:
    Assignment(const Flow& flow, const Order& order, const Blocks& blocks, int pitch)
        : flow_(flow), order_(order), blocks_(blocks), pitch_(pitch), reach_(blocks.blocks.size()) {
        columns_.nodes.assign(flow.nodes.size(), 0);
        columns_.arcs = columns_.exits = columns_.entries = std::vector<int>(flow.arcs.size(), 0);
        columns_.lane_of.assign(flow.arcs.size(), nowhere);
    }

    Columns run() {
        choose_lanes();
        pack_lanes();
        for (std::size_t block = 0; block <= blocks_.root; ++block)
            if (blocks_.contains(block)) measure(block);
        place();
        return std::move(columns_);
    }

private:
    const Block& at(std::size_t block) const { return blocks_.blocks[block]; }

    template <class Visit>
    void each_part(std::size_t block, const Visit& visit) const {
        for (std::size_t part = at(block).first; part != nowhere; part = at(part).next) visit(part);
    }

    // -- lanes -------------------------------------------------------------------------------------------------------

    std::size_t smallest_with(std::size_t left, std::size_t right) const {
        while (left != right) {
            std::size_t& lower = left < right ? left : right;
            lower = at(lower).parent;
        }
        return left;
    }

    std::size_t exit_block(std::size_t arc) const {
        const std::size_t stub = blocks_.exits[arc];
        return stub != nowhere ? stub : blocks_.of_node[flow_.arcs[arc].from];
    }
    std::size_t entry_block(std::size_t arc) const {
        const std::size_t stub = blocks_.entries[arc];
        return stub != nowhere ? stub : blocks_.of_node[flow_.arcs[arc].to];
    }

    /// Counts the parallel parts that a horizontal line in `channel` from `block` to the left (right) side of `whole`
    /// would cross. Returns the number for the left side minus the number for the right side. At most `far_enough`
    /// parts of each enclosing block are examined.
    int leaning(std::size_t block, std::size_t whole, std::size_t channel) const {
        int crossed = 0;
        for (; block != whole; block = at(block).parent) {
            const Block& parent = at(at(block).parent);
            if (parent.kind == Block::Kind::Series) continue;
            bool after_block = false;
            std::size_t seen = 0;
            for (std::size_t part = parent.first; part != nowhere && seen < far_enough; part = at(part).next, ++seen) {
                if (part == block) after_block = true;
                else if (at(part).low <= channel && channel <= at(part).high) crossed += after_block ? -1 : 1;
            }
        }
        return crossed;
    }

    /// Assigns each upward link to a lane. On each side, upward links to the same step share a lane.
    void choose_lanes() {
        std::map<std::tuple<std::size_t, Side>, std::size_t> shared;
        std::vector<std::pair<std::size_t, Side>> places;  ///< block and side of each lane
        for (std::size_t arc = 0; arc < flow_.arcs.size(); ++arc) {
            if (!order_.upward[arc]) continue;
            const auto [from, to] = flow_.arcs[arc];
            const std::size_t below = 2 * order_.rows[from] + 2, above = 2 * order_.rows[to];
            const std::size_t whole = smallest_with(exit_block(arc), entry_block(arc));
            const bool right = leaning(exit_block(arc), whole, below) + leaning(entry_block(arc), whole, above) > 0;
            const Side side = right ? Side::Right : Side::Left;
            std::size_t lane = columns_.lanes.size();
            if (blocks_.entries[arc] == nowhere) lane = shared.try_emplace({to, side}, lane).first->second;
            if (lane == columns_.lanes.size()) {
                columns_.lanes.push_back({.low = above, .high = below});
                places.emplace_back(whole, side);
            } else {
                columns_.lanes[lane].high = std::max(columns_.lanes[lane].high, below);
                places[lane].first = smallest_with(places[lane].first, whole);
            }
            columns_.lane_of[arc] = lane;
        }
        for (std::size_t lane = 0; lane < places.size(); ++lane) side_lanes_[places[lane]].lanes.push_back(lane);
    }

    /// Computes the columns of lanes relative to the side of their block. Shorter lanes are placed nearer to the block.
    /// Lanes without a common row may share a column.
    void pack_lanes() {
        for (auto& [place, side_lanes] : side_lanes_) {
            // For each column: first and last channel of its lanes.
            std::vector<std::set<std::pair<std::size_t, std::size_t>>> taken;
            std::ranges::stable_sort(side_lanes.lanes, {}, [&](std::size_t lane) {
                return columns_.lanes[lane].high - columns_.lanes[lane].low;
            });
            for (const std::size_t number : side_lanes.lanes) {
                Lane& lane = columns_.lanes[number];
                const auto free_in = [&](const std::set<std::pair<std::size_t, std::size_t>>& column) {
                    const auto next = column.lower_bound({lane.low, 0});
                    return (next == column.end() || next->first > lane.high) &&
                           (next == column.begin() || std::prev(next)->second < lane.low);
                };
                const auto column = std::ranges::find_if(taken, free_in) - taken.begin();
                if (column == std::ssize(taken)) taken.emplace_back();
                taken[static_cast<std::size_t>(column)].emplace(lane.low, lane.high);
                lane.x = static_cast<int>(column + 1) * pitch_;
            }
            side_lanes.width = static_cast<int>(taken.size()) * pitch_;
        }
    }

    // -- widths, bottom-up --------------------------------------------------------------------------------------------

    void measure(std::size_t number) {
        const Block& block = at(number);
        Reach& reach = reach_[number];
        switch (block.kind) {
        case Block::Kind::Node:
            reach.left = flow_.nodes[block.what].space.left;
            reach.right = flow_.nodes[block.what].space.right;
            break;
        case Block::Kind::Arc:
        case Block::Kind::Exit:
        case Block::Kind::Entry: reach.left = reach.right = (pitch_ - gap + 1) / 2; break;
        case Block::Kind::Series: measure_series(number); break;
        case Block::Kind::Parallel: measure_parallel(number); break;
        case Block::Kind::Core: measure_core(number); break;
        }
        for (const Side side : {Side::Left, Side::Right}) {
            const auto side_lanes = side_lanes_.find({number, side});
            if (side_lanes == side_lanes_.end()) continue;
            int& edge = side == Side::Left ? reach.left : reach.right;
            for (const std::size_t lane : side_lanes->second.lanes) columns_.lanes[lane].x += edge;
            edge += side_lanes->second.width + pitch_ / 2;
        }
    }

    /// Places the parts of a Series on one axis. If an attached branch makes a part extend into the rows of the next
    /// part, the next part is placed to the right of this part.
    void measure_series(std::size_t number) {
        std::vector<Strip> strips;
        each_part(number, [&](std::size_t part) {
            if (strips.empty() || at(part).low < strips.back().high) strips.push_back({.low = at(part).low});
            Strip& strip = strips.back();
            strip.high = std::max(strip.high, at(part).high);
            strip.reach.left = std::max(strip.reach.left, reach_[part].left);
            strip.reach.right = std::max(strip.reach.right, reach_[part].right);
            strip.parts.push_back(part);
        });
        if (strips.size() > 1) pack(number, strips);
        settle(number, strips.front().reach.offset);
    }

    /// Consecutive parts of a block with a common axis.
    struct Strip {
        std::size_t low = 0, high = 0;
        Reach reach = {};
        std::vector<std::size_t> parts = {};
    };

    /// Places each strip as far to the left as possible without overlapping the preceding strips.
    void pack(std::size_t number, std::vector<Strip>& strips) {
        const std::size_t low = at(number).low;
        std::vector<int> skyline(at(number).high - low + 1, 0);
        for (Strip& strip : strips) {
            const auto begin = skyline.begin() + static_cast<std::ptrdiff_t>(strip.low - low);
            const auto end = skyline.begin() + static_cast<std::ptrdiff_t>(strip.high - low + 1);
            strip.reach.offset = *std::max_element(begin, end) + strip.reach.left;
            std::fill(begin, end, strip.reach.offset + strip.reach.right + gap);
            for (const std::size_t part : strip.parts) reach_[part].offset = strip.reach.offset;
        }
    }

    /// Places the parts of a Parallel next to each other. The axis of the block is in the middle between the axes of
    /// the first and the last part that connect both ends of the block.
    void measure_parallel(std::size_t number) {
        int right = 0, first = 0, last = 0;
        bool any = false;
        const auto look = [&](bool open_ones) {
            right = 0;
            each_part(number, [&](std::size_t part) {
                Reach& reach = reach_[part];
                reach.offset = right + reach.left;
                right = reach.offset + reach.right + gap;
                if (at(part).open && !open_ones) return;
                if (!any) first = reach.offset;
                last = reach.offset;
                any = true;
            });
        };
        look(false);
        if (!any) look(true);
        settle(number, (first + last) / 2);
    }

    /// Moves the parts so that the position `axis` becomes 0.
    void settle(std::size_t number, int axis) {
        Reach& whole = reach_[number];
        each_part(number, [&](std::size_t part) {
            Reach& reach = reach_[part];
            reach.offset -= axis;
            whole.left = std::max(whole.left, reach.left - reach.offset);
            whole.right = std::max(whole.right, reach.right + reach.offset);
        });
    }

    /// Orders the strips of a Core (an irreducible part of the graph) so that their connections are short.
    void measure_core(std::size_t number) {
        std::vector<std::size_t> parts;
        each_part(number, [&](std::size_t part) { parts.push_back(part); });
        std::ranges::stable_sort(parts, {}, [&](std::size_t part) { return at(part).key; });
        order_strips(parts);
        std::vector<Strip> strips;
        for (const std::size_t part : parts) strips.push_back({at(part).low, at(part).high, reach_[part], {part}});
        pack(number, strips);
        settle(number, strips.front().reach.offset);
    }

    void order_strips(std::vector<std::size_t>& strips) const {
        std::map<std::size_t, std::vector<std::size_t>> ends;  // for each end: the strips that meet there
        for (const std::size_t strip : strips)
            for (const std::size_t end : {at(strip).above, at(strip).below})
                if (end != nowhere) ends[end].push_back(strip);
        std::vector<std::size_t> best = strips;
        double least = length(strips, ends);
        for (std::size_t round = 0; round < rounds; ++round) {
            const std::map<std::size_t, double> centres = centres_of(strips, ends);
            std::ranges::stable_sort(strips, {}, [&](std::size_t strip) { return centres.at(strip); });
            const double now = length(strips, ends);
            if (now >= least) continue;
            least = now;
            best = strips;
        }
        strips = best;
    }

    using Ends = std::map<std::size_t, std::vector<std::size_t>>;

    static std::map<std::size_t, double> places_of(const std::vector<std::size_t>& strips) {
        std::map<std::size_t, double> places;
        for (std::size_t k = 0; k < strips.size(); ++k) places[strips[k]] = static_cast<double>(k);
        return places;
    }

    /// Returns, for each strip, the barycentre of all strips that are connected to it.
    static std::map<std::size_t, double> centres_of(const std::vector<std::size_t>& strips, const Ends& ends) {
        const std::map<std::size_t, double> places = places_of(strips);
        std::map<std::size_t, std::pair<double, double>> sums;
        for (const auto& [end, meeting] : ends) {
            double sum = 0;
            for (const std::size_t strip : meeting) sum += places.at(strip);
            for (const std::size_t strip : meeting) {
                sums[strip].first += sum;
                sums[strip].second += static_cast<double>(meeting.size());
            }
        }
        std::map<std::size_t, double> centres;
        for (const auto& [strip, sum] : sums) centres[strip] = sum.first / sum.second;
        return centres;
    }

    static double length(const std::vector<std::size_t>& strips, const Ends& ends) {
        const std::map<std::size_t, double> places = places_of(strips);
        double sum = 0;
        for (const auto& [end, meeting] : ends) {
            const auto [least, most] =
                std::ranges::minmax(meeting, {}, [&](std::size_t strip) { return places.at(strip); });
            sum += places.at(most) - places.at(least);
        }
        return sum;
    }

    // -- positions, top-down ------------------------------------------------------------------------------------------

    void place() {
        std::vector<int> axes(blocks_.root + 1, 0);
        axes[blocks_.root] = reach_[blocks_.root].left;
        for (std::size_t number = blocks_.root + 1; number-- > 0;) {
            if (!blocks_.contains(number)) continue;
            const Block& block = at(number);
            each_part(number, [&](std::size_t part) { axes[part] = axes[number] + reach_[part].offset; });
            switch (block.kind) {
            case Block::Kind::Node: columns_.nodes[block.what] = axes[number]; break;
            case Block::Kind::Arc: columns_.arcs[block.what] = axes[number]; break;
            case Block::Kind::Exit: columns_.exits[block.what] = axes[number]; break;
            case Block::Kind::Entry: columns_.entries[block.what] = axes[number]; break;
            case Block::Kind::Series:
            case Block::Kind::Parallel:
            case Block::Kind::Core: break;
            }
        }
        for (const auto& [place, side_lanes] : side_lanes_)
            for (const std::size_t lane : side_lanes.lanes) {
                int& x = columns_.lanes[lane].x;
                x = axes[place.first] + (place.second == Side::Left ? -x : x);
            }
        columns_.width = reach_[blocks_.root].left + reach_[blocks_.root].right;
    }

    const Flow& flow_;
    const Order& order_;
    const Blocks& blocks_;
    int pitch_;
    std::vector<Reach> reach_;
    std::map<std::pair<std::size_t, Side>, SideLanes> side_lanes_ = {};
    Columns columns_ = {};
};

}  // namespace

Columns columns_of(const Flow& flow, const Order& order, const Blocks& blocks, int pitch) {
    return Assignment(flow, order, blocks, pitch).run();
}

}  // namespace grafverif::draw
