// SPDX-License-Identifier: MIT
// Text of the assumptions of one or several verdicts, in which common parts are stated once.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "grafverif/ir/report.hpp"

namespace grafverif {

/// Returns the assumptions of a verdict: engine, mode, granularity, time, states; for an untimed verdict also its
/// implication for the timed loop.
std::string settings_text(const Report& report, const PropertyResult& answer);

/// The assumptions of several verdicts. Each verdict has the assumptions in `shared` and in `words` of its group. The
/// number of states does not apply to an undecided verdict whose search found no state.
struct SharedSettings {
    struct Group {
        std::string words = {};
        std::vector<const PropertyResult*> answers = {};
    };
    std::string shared = {};
    std::vector<Group> groups = {};  ///< groups of verdicts with additional text, in the order of their first verdict
};
SharedSettings shared_settings(const Report& report, const std::vector<const PropertyResult*>& answers);

/// Returns `S` if the result is for one step of the property `S` (`S.X7`); returns an empty string for any other
/// result.
std::string family_of(const PropertyResult& answer);

/// Number of verdicts of a report for each result of family_of.
using FamilySizes = std::map<std::string, std::size_t>;
FamilySizes family_sizes(const Report& report);

/// Returns the names of the verdicts, such as `P1, P2, S`. If all steps of a property are included, only the name of
/// the property is listed.
std::string names_of(const FamilySizes& all, const std::vector<const PropertyResult*>& answers);

}  // namespace grafverif
