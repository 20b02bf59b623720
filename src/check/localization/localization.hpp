// SPDX-License-Identifier: MIT
// Localization for the timed engine. If the complete network has too many states, a property is decided on the
// fragments ("cells") that it reads, with the rest over-approximated (ir/network_fragments.hpp). The abstraction
// preserves `always`, `never` and `exactly one of` that hold, and `reachable` that is violated (proof:
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
#include <memory>

#include "check/decomposition/decomposition.hpp"
#include "check/shares.hpp"
#include "check/timed/timed.hpp"
#include "ir/network_fragments.hpp"

namespace grafverif {

struct LocalizationLimits {
    std::uint64_t whole = std::uint64_t{1} << 17U;  ///< states explored in the first search of the complete network
    std::uint64_t local = std::uint64_t{1} << 22U;  ///< states of an abstraction; 0: no localization
};

/// Searches the complete network: directly, or compositionally.
using WholeSearch = std::function<TimedResult(const Network&, const TimedOptions&)>;

class LocalizationCheck;

/// The steps of check_timed_by_cells, for callers that decide open verdicts between them.
class CellSearch {
public:
    /// `network` is expanded. The search reads `options` at the beginning of each step.
    CellSearch(Network network, const TimedOptions& options, const LocalizationLimits& limits,
               const LocalAblations& ablations = {}, const WholeSearch& whole = check_timed_by_parts);
    ~CellSearch();
    CellSearch(CellSearch&&) = delete;

    /// The first search of the complete network, and localization.
    void begin();
    /// Open verdicts have the obstacle `Bound`. A caller that decides one sets its `abstraction`.
    TimedResult& found();
    /// True if a requested verdict is open, or if nothing was decided without the complete network.
    bool needs_whole();
    /// The search of the complete network for the open verdicts, unless the first one already used the allowed bound.
    void search_complete();
    TimedResult result();

private:
    std::unique_ptr<LocalizationCheck> search_;
};

/// As `whole`, with the same results if the complete network has few states; the limits apply to each search. An
/// undeclared `no timelock` is left unknown if no other query needs the complete network. Requires
/// verify(network).empty().
TimedResult check_timed_by_cells(const Network& network, const TimedOptions& options = {},
                                 const LocalizationLimits& limits = {}, const LocalAblations& ablations = {},
                                 const WholeSearch& whole = check_timed_by_parts);

}  // namespace grafverif
