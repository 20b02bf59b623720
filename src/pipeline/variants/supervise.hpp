// SPDX-License-Identifier: MIT
// Conditions on the charts of a closed loop under which its properties hold: found by a game on the untimed model in grain
// atomic, written into the text of the charts, read back from there and proved again by two engines before anybody is
// told.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/supervise/supervise.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif {

struct SuperviseAsk {
    std::vector<std::string> properties = {};  ///< names; empty: all about states alone that are not expected violated
    std::string marked = {};                   ///< a term of the loop; empty: the initial situation
    bool transitions = true, outputs = true;   ///< which of them may get conditions
    std::optional<ExecutionMode> mode = {};
    ReadOptions read = {};  ///< how the model was read
    Limits limits = {};
};

/// A condition, and what it is one of.
struct ChartCondition {
    std::string chart = {};
    std::string subject = {};  ///< `t3`, `CLOSE`
    std::string step = {};     ///< of an output: the step variable of the action, `X10`; else empty
    std::string term = {};     ///< as the text has it, added to what is there
    bool sum = false;          ///< it needs brackets behind `&&`
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
    std::string marked = {};  ///< as asked; empty: the initial situation
    Supervisor::Outcome outcome = Supervisor::Outcome::Unknown;
    std::string reason = {};  ///< of an unknown outcome
    Supervisor::Claim claim = Supervisor::Claim::Least;
    std::vector<std::string> hidden = {}, traded = {};  ///< subjects; see Supervisor
    std::vector<ChartCondition> conditions = {};
    Outcome timelock = Outcome::Unknown;  ///< whether time never stops in the timed loop with them, grain atomic
    std::optional<Id<Source>> file = {};  ///< where the conditions go; not one: they go to several, or there are none
    std::string text = {};                ///< of that file with them
    std::optional<ChartRun> run = {};     ///< where there are none to be had: what nobody prevents
    bool blocked = false;                 ///< its end is not bad yet: nothing marked can be reached any more without
    std::vector<std::string> failures = {};  ///< faults of ours; nothing else counts then
};

/// `main`: the source that `model` was read from, with all it includes in `sources`. Nothing after an error: properties
/// that there are not, or that are about more than states; a term that is none.
std::optional<Supervised> supervised(const Model& model, Id<ClosedLoop> loop, Id<Source> main, Sources& sources,
                                     const SuperviseAsk& ask, Diagnostics& diagnostics);

}  // namespace grafverif
