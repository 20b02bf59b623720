// SPDX-License-Identifier: MIT
// Supervisory control: conditions on the charts of a closed loop that enforce its properties. They are found by a game
// on the untimed model in grain atomic and written into the text of the charts. They are then parsed from there and
// proved again by two engines before they are reported.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/supervise/supervise.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif {

struct SuperviseRequest {
    std::vector<std::string> properties = {};  ///< names; empty: all about states alone that are not expected violated
    std::string marked = {};                   ///< a term of the loop; empty: the initial situation
    bool transitions = true, outputs = true;   ///< which elements may get conditions
    std::optional<ExecutionMode> mode = {};
    ReadOptions read = {};  ///< how the model was parsed
    Limits limits = {};
};

/// A condition, and the element that it restricts.
struct ChartCondition {
    std::string chart = {};
    std::string subject = {};  ///< `t3`, `CLOSE`
    std::string step = {};     ///< of an output: the step variable of the action, `X10`; otherwise empty
    std::string term = {};     ///< as in the text, added to the existing condition
    bool sum = false;          ///< requires parentheses after `&&`
    Span origin = {};          ///< of the transition or action
};

struct Supervised {
    std::string loop = {};
    /// A property of the loop about which the result states nothing.
    struct Ignored {
        std::string property = {}, reason = {};
    };
    std::vector<std::string> kept = {};  ///< names of properties
    std::vector<Ignored> ignored = {};
    std::string marked = {};  ///< as given; empty: the initial situation
    Supervisor::Outcome outcome = Supervisor::Outcome::Unknown;
    std::string reason = {};  ///< of an unknown outcome
    Supervisor::Permissiveness claim = Supervisor::Permissiveness::Least;
    std::vector<std::string> hidden = {}, traded = {};  ///< subjects; see Supervisor
    std::vector<ChartCondition> conditions = {};
    Outcome timelock = Outcome::Unknown;     ///< result of `no timelock` with the conditions
    std::optional<Id<Source>> file = {};     ///< the file that gets the conditions; invalid if several or none get any
    std::string text = {};                   ///< of that file with the conditions
    std::optional<ChartRun> run = {};        ///< if there are no conditions: a run that cannot be prevented
    bool blocked = false;                    ///< its end is not bad yet, but leads to no marked state
    std::vector<std::string> failures = {};  ///< internal failures; all other results are invalid then
};

/// `main`: the source that `model` was parsed from, with its includes in `sources`. Nothing after an error: unknown
/// properties, or properties that are not about states alone; an invalid term.
std::optional<Supervised> supervised(const Model& model, Id<ClosedLoop> loop, Id<Source> main, Sources& sources,
                                     const SuperviseRequest& ask, Diagnostics& diagnostics);

}  // namespace grafverif
