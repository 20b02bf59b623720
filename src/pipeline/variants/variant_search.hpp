// SPDX-License-Identifier: MIT
// Checks properties of variants of a closed loop. The results for the original loop determine the steps and the bounds
// of the checks of its variants.
//
// If the check of the original loop needs few states, each variant is checked in the same way. Otherwise, the variants
// are searched in passes with increasing bounds, so that variants that need only a small search are decided first. The
// first pass begins with the abstraction that decided the property for the original loop, because most variants do not
// change the abstracted part.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/localization/localization.hpp"
#include "check/shares.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif {

/// Bounds of one pass.
struct SearchEffort {
    LocalizationLimits begin = {};           ///< limits of the first complete search and of localization
    std::vector<std::uint64_t> rounds = {};  ///< maximum number of states per search with input abstraction
    bool complete = true;                    ///< true: search the complete loop for undecided properties
    /// If true, check only properties that an abstraction decided for the original loop, beginning with this
    /// abstraction.
    bool known = false;
};

struct VariantBounds {
    std::uint64_t few_states = std::uint64_t{1} << 14U;  ///< if a check has more states, variants are checked in passes
    /// Maximum number of states of a first search of the complete loop that is not expected to decide any property.
    std::uint64_t brief = std::uint64_t{1} << 12U;
};

class VariantSearch {
public:
    /// `report` is the result of checking the original loop with `options`. `options` must outlive the search.
    VariantSearch(const CheckOptions& options, const Report& report, const VariantBounds& bounds = {});

    /// Returns the passes, in order. The last pass uses the complete bounds.
    const std::vector<SearchEffort>& efforts() const { return efforts_; }

    /// Returns verdicts on the properties of `network` with the given names. A property that has an observer is decided
    /// in a separate search. Several threads may call this function concurrently with different networks.
    std::vector<Verdict> operator()(const Network& network, std::vector<std::string> names, const SearchEffort& effort,
                                    const Deadline& deadline);

    std::size_t searches() const { return searches_; }
    bool stopped() const { return is_over(options_.limits.deadline, options_.limits.stop); }
    /// Returns `time limit reached` or `stopped`.
    std::string_view reason() const;

private:
    std::vector<Verdict> searched(const Network& network, const std::vector<std::string>& names,
                                  const SearchEffort& effort, const Deadline& deadline,
                                  std::optional<Id<Property>> watched);

    const CheckOptions& options_;
    std::vector<SearchEffort> efforts_ = {};
    /// For each property: the abstraction that decided it for the original loop.
    std::map<std::string, InputsAbstracted> known_ = {};
    std::uint64_t most_states_ = 0;
    std::atomic<std::size_t> searches_ = 0;
};

}  // namespace grafverif
