// SPDX-License-Identifier: MIT
// What verdicts rest on, in words: of one verdict, or of several, where what they share is said once.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "grafverif/ir/report.hpp"

namespace grafverif {

/// What a verdict rests on: engine, mode, grain, time, states; of an untimed one what it says of the timed loop.
std::string basis_words(const Report& report, const Answer& answer);

/// The same of several: `shared` and the `words` of its group hold of each, but that an undecided one may have been given
/// up before any state was looked at.
struct SharedBasis {
    struct Group {
        std::string words = {};
        std::vector<const Answer*> answers = {};
    };
    std::string shared = {};
    std::vector<Group> groups = {};  ///< of those of whom there is more to say, in the order of their first answer
};
SharedBasis shared_basis(const Report& report, const std::vector<const Answer*>& answers);

/// The property of which this is one step (`S` of `S.X7`); empty: it is about itself.
std::string family_of(const Answer& answer);

/// Number of answers of a report per family_of.
using FamilySizes = std::map<std::string, std::size_t>;
FamilySizes family_sizes(const Report& report);

/// `P1, P2, S`: the names of the answers, one for a property all steps of which are among them.
std::string names_of(const FamilySizes& all, const std::vector<const Answer*>& answers);

}  // namespace grafverif
