// SPDX-License-Identifier: MIT
// Text of the assumptions of one verdict, or of several, with common parts stated once.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "grafverif/ir/report.hpp"

namespace grafverif {

/// The assumptions of a verdict: engine, mode, grain, time, states; for an untimed one its implication for the timed
/// loop.
std::string settings_text(const Report& report, const PropertyResult& answer);

/// The assumptions of several verdicts. `shared` and the `words` of its group apply to each, except that the search of
/// an undecided one may have ended before its first state.
struct SharedSettings {
    struct Group {
        std::string words = {};
        std::vector<const PropertyResult*> answers = {};
    };
    std::string shared = {};
    std::vector<Group> groups = {};  ///< of the verdicts with additional text, in the order of the first
};
SharedSettings shared_settings(const Report& report, const std::vector<const PropertyResult*>& answers);

/// The property of which this is one step (`S` of `S.X7`); empty if it is not a step.
std::string family_of(const PropertyResult& answer);

/// Number of verdicts of a report per family_of.
using FamilySizes = std::map<std::string, std::size_t>;
FamilySizes family_sizes(const Report& report);

/// `P1, P2, S`: the names of the verdicts, with one name for a property if all its steps are included.
std::string names_of(const FamilySizes& all, const std::vector<const PropertyResult*>& answers);

}  // namespace grafverif
