// SPDX-License-Identifier: MIT
// The timed engine by cells: where the whole has too many states, what a property says of some cells is decided in these,
// with all others left out (ir/network_cells.hpp), for `always`, `never`, `exactly one of` that hold and `reachable` that
// is violated (docs/engines.md, "Cells", has the proofs). Where a local network has a run that the whole may not have, or
// breaks off, more cells are taken in, those whose values are read; in the end the whole is searched.
//
// A verdict of cells is given only where the whole cannot break off anywhere, so that it is the one of the whole.
#pragma once

#include <cstdint>
#include <functional>

#include "check/parts/parts.hpp"
#include "check/timed/timed.hpp"
#include "ir/network_cells.hpp"

namespace grafverif {

/// The sizes of the searches.
/// Name of the property that the first look at the complete network adds: some state is quiescent.
inline constexpr const char* settled_probe = "some state is settled";

struct CellLimits {
    std::uint64_t whole = std::uint64_t{1} << 17U;  ///< states of the whole that are looked at first
    std::uint64_t local = std::uint64_t{1} << 22U;  ///< of a local network
};

/// How the whole is searched: in one, or by sub-loops.
using WholeSearch = std::function<TimedResult(const Network&, const TimedOptions&)>;

/// As `whole`, and the same where the whole has few states; the bounds are those of each search. An undeclared
/// `no timelock` is left unknown where nothing else needs the whole. Requires verify(network).empty().
TimedResult check_timed_by_cells(const Network& network, const TimedOptions& options = {},
                                 const CellLimits& limits = {}, const LocalAblations& ablations = {},
                                 const WholeSearch& whole = check_timed_by_parts);

}  // namespace grafverif
