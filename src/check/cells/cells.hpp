// SPDX-License-Identifier: MIT
// Localization for the timed engine. If the complete network has too many states, a property is decided on the
// fragments ("cells") that it reads, with the rest over-approximated (ir/network_cells.hpp). The abstraction preserves
// `always`, `never` and `exactly one of` that hold, and `reachable` that is violated (proof:
// docs/explanation/decomposition.md, "Cells").
//
// Refinement: if the abstraction admits a run that may be spurious, or a model error, the fragments whose values are
// read are added. The last iteration explores the complete network.
//
// A verdict is reported only if no model error is possible anywhere in the complete network, so it is the verdict of
// the complete network.
#pragma once

#include <cstdint>
#include <functional>

#include "check/parts/parts.hpp"
#include "check/timed/timed.hpp"
#include "ir/network_cells.hpp"

namespace grafverif {

/// Name of the property that the first search of the complete network adds: some state is quiescent.
inline constexpr const char* settled_probe = "some state is quiescent";

struct CellLimits {
    std::uint64_t whole = std::uint64_t{1} << 17U;  ///< states explored in the first search of the complete network
    std::uint64_t local = std::uint64_t{1} << 22U;  ///< states of an abstraction
};

/// Searches the complete network: directly, or compositionally.
using WholeSearch = std::function<TimedResult(const Network&, const TimedOptions&)>;

/// As `whole`, with the same results if the complete network has few states; the limits apply to each search. An
/// undeclared `no timelock` is left unknown if no other query needs the complete network. Requires
/// verify(network).empty().
TimedResult check_timed_by_cells(const Network& network, const TimedOptions& options = {},
                                 const CellLimits& limits = {}, const LocalAblations& ablations = {},
                                 const WholeSearch& whole = check_timed_by_parts);

}  // namespace grafverif
