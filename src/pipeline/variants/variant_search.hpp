// SPDX-License-Identifier: MIT
// Checks properties of variants of a closed loop. The results for the original loop determine the steps and the bounds
// of these checks.
//
// A check that needs few states is repeated for each variant. If the check of the original needs more states, the
// variants are searched in passes with increasing bounds, so that variants that need a small search are decided first.
// The first pass begins with the abstraction that decided the property in the original, because most changes do not
// affect it.
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
    LocalizationLimits begin = {};           ///< limits of the first search of the complete loop, and of localization
    std::vector<std::uint64_t> rounds = {};  ///< maximum number of states of each search of an input abstraction
    bool complete = true;                    ///< true: search the complete loop for undecided properties
    /// True: check only properties that an abstraction decided in the original, beginning with this abstraction.
    bool known = false;
};

struct VariantBounds {
    std::uint64_t few_states = std::uint64_t{1} << 14U;  ///< a check with more states is repeated in passes
    /// Maximum number of states of a first search of the complete loop that is not expected to decide any property.
    std::uint64_t brief = std::uint64_t{1} << 12U;
};

class VariantSearch {
public:
    /// `report` is the result of checking the original loop with `options`. `options` must outlive the search.
    VariantSearch(const CheckOptions& options, const Report& report, const VariantBounds& bounds = {});

    /// Returns the passes, in order. The last pass uses the complete bounds.
    const std::vector<SearchEffort>& efforts() const { return efforts_; }

    /// Returns verdicts on the properties whose names are in `names`. A property that has an observer is decided in a
    /// separate search. Several threads may search different networks.
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
    /// For each property: the abstraction that decided it in the original.
    std::map<std::string, InputsAbstracted> known_ = {};
    std::uint64_t most_states_ = 0;
    std::atomic<std::size_t> searches_ = 0;
};

}  // namespace grafverif
