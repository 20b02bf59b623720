// SPDX-License-Identifier: MIT
// Localization: an abstraction for the timed engine. If the complete network has too many states, a property is decided
// on the fragments ("cells") that it reads. All other fragments are over-approximated (ir/network_fragments.hpp). If
// `always`, `never` or `exactly one of` holds in the abstraction, or `reachable` is violated in it, the complete
// network has the same verdict (proof: docs/explanation/decomposition.md, "Cells").
//
// Refinement: if the abstraction has a run that may be spurious, or a model error, the search is repeated with more
// fragments. The fragments whose values the abstraction reads are added. If the abstractions do not decide the
// property, the complete network is explored.
//
// A verdict is reported only if the search has shown that no model error is possible in the complete network. Therefore
// each reported verdict is also the verdict on the complete network.
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
    /// Maximum number of states in the first search of the complete network.
    std::uint64_t whole = std::uint64_t{1} << 17U;
    /// Maximum number of states of an abstraction; 0 disables localization.
    std::uint64_t local = std::uint64_t{1} << 22U;
    /// Limits the number of transitions of an abstraction to `transitions` times the maximum number of states, except
    /// in the last round. If many omitted variables of an abstraction can change at any time, states have hundreds of
    /// transitions.
    std::uint64_t transitions = 8;
};

/// Searches the complete network, either directly or compositionally.
using WholeSearch = std::function<TimedResult(const Network&, const TimedOptions&)>;

class LocalizationCheck;

/// Executes check_timed_by_cells in steps, for callers that decide unknown verdicts between the steps by other methods.
class CellSearch {
public:
    /// Prepares a search of the expanded network `network`. Each step of the search reads `options` again.
    CellSearch(Network network, const TimedOptions& options, const LocalizationLimits& limits,
               const LocalAblations& ablations = {}, const WholeSearch& whole = check_timed_by_parts);
    ~CellSearch();
    CellSearch(CellSearch&&) = delete;

    /// Performs the first search of the complete network, and then the first round of localization.
    void begin();
    /// Performs a round of localization; each search of the round explores at most `states` states. Has no effect if an
    /// earlier round had the same or a greater limit. Returns false if no search remains for the next round.
    bool refine(std::uint64_t states, const Deadline& deadline);
    /// Returns the current result. Undecided verdicts have the outcome Unknown and the obstacle `Bound`. A caller that
    /// decides an undecided verdict also sets Verdict::abstraction.
    TimedResult& found();
    /// True if a search of the complete network is necessary: some verdict is undecided, and either its property is
    /// selected or declared, or no verdict was decided on fragments.
    bool needs_whole();
    /// Searches the complete network to decide the undecided verdicts. Has no effect if the first search of the
    /// complete network already had the limit `max_states` of the options.
    void search_complete();
    TimedResult result();

private:
    std::unique_ptr<LocalizationCheck> search_;
};

/// Checks the properties with the function `whole`, limited to `limits.whole` states. If this search decides every
/// property, its verdicts are the result. If the search reaches the state limit, localization follows. Then, if
/// CellSearch::needs_whole() is true, `whole` searches the network again with the limits of `options`. The limits of
/// `options` apply to each search separately. If no declared or selected property requires the complete network, an
/// undeclared `no timelock` remains unknown. Requires verify(network).empty().
TimedResult check_timed_by_cells(const Network& network, const TimedOptions& options = {},
                                 const LocalizationLimits& limits = {}, const LocalAblations& ablations = {},
                                 const WholeSearch& whole = check_timed_by_parts);

}  // namespace grafverif
