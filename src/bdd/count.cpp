// SPDX-License-Identifier: MIT
// Exact counting; BuDDy's own count is a double.
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <limits>
#include <unordered_map>

#include "bdd/nodes.hpp"

namespace grafverif {

namespace {

using Number = boost::multiprecision::cpp_int;

Number counted(const Bdd& f, std::span<const std::uint32_t> variables) {
    // The place of a node is that of its variable among `variables`; a constant stands below them all. The count of
    // a node is over the variables from its own place on.
    const auto place = [&](int node) {
        if (node < 2) return variables.size();
        const auto found = std::ranges::lower_bound(variables, static_cast<std::uint32_t>(::bdd_var(node)));
        assert(found != variables.end() && *found == static_cast<std::uint32_t>(::bdd_var(node)));
        return static_cast<std::size_t>(found - variables.begin());
    };
    std::unordered_map<int, Number> counts{{0, 0}, {1, 1}};
    const auto below = [&](int node, std::size_t from) {   // over the variables from place `from` on
        return Number(counts.at(node) << (place(node) - from));
    };
    for (const int node : bdd::nodes_of(f.node())) {
        const std::size_t next = place(node) + 1;
        counts.emplace(node, below(::bdd_low(node), next) + below(::bdd_high(node), next));
    }
    return below(f.node(), 0);
}

}  // namespace

std::string count(const Bdd& f, std::span<const std::uint32_t> variables) { return counted(f, variables).str(); }

std::optional<std::uint64_t> small_count(const Bdd& f, std::span<const std::uint32_t> variables) {
    const Number number = counted(f, variables);
    if (number > std::numeric_limits<std::uint64_t>::max()) return {};
    return number.convert_to<std::uint64_t>();
}

}  // namespace grafverif
