// SPDX-License-Identifier: MIT
// CyclePremises: checks the static premises of macro-steps (macro_steps.hpp) for one PLC and its timers.
#pragma once

#include <set>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/slots.hpp"

namespace grafverif::timed {

/// True if the process is an observer (compose/observe.hpp).
bool is_observer(const Network& network, Id<Network::Process> id);

/// For one edge of a PLC: the processes whose moves may be postponed until after this edge. The two vectors have one
/// element per process.
struct Independence {
    /// True if four conditions hold. The edges of the process are independent of the edge of the PLC. The process
    /// cannot enable or disable another edge of the PLC. The edge of the PLC does not change a variable that an
    /// observer or a property reads. The process writes no variable that a process with the element false reads.
    std::vector<bool> always = {};
    /// As `always`, but only for executions of the edge that do not change the values of the variables `shared`. The
    /// execution may end a cycle in a stable situation, unless an observer reads whether the loop is quiescent.
    std::vector<bool> if_unchanged = {};
    /// Variables that the edge writes and that another process, an observer or a property reads.
    std::vector<Id<Network::Variable>> shared = {};
};

class CyclePremises {
public:
    /// Requires that `network` is expanded. The arguments must outlive the object.
    CyclePremises(const Network& network, const Network::Controller& controller);

    /// Returns the timers that accept a request of the PLC before the PLC can leave its waiting location W.
    const std::vector<Id<Network::Process>>& accepting_timers() const { return accepting_; }

    /// True if a property reads the location of a timer or a variable that the timers write. Also true if a process
    /// other than the PLC and its timers uses a variable that the timers write.
    bool timers_are_observed() const;

    /// Returns one element per location of the PLC. The element is true if each infinite path from the location passes
    /// through the waiting location W. The element of W is false.
    std::vector<bool> locations_in_cycle() const;

    /// Returns one element per location of the PLC. The element is true if the edges of the location read no variable
    /// that the timers write, and write no variable that the timers use.
    std::vector<bool> independent_locations() const;

    /// Returns one element per location of the PLC. The element is true if only edges from the waiting location W lead
    /// to the location, and these edges change only flags that request a cycle. All elements are false if an observer
    /// or a property reads these flags or the location of the PLC. If an element is true, no process except the PLC can
    /// distinguish the location from W.
    std::vector<bool> locations_like_waiting() const;

    /// Returns the independent processes for each edge of the PLC.
    std::vector<Independence> independence() const;

    /// Returns the outputs of the PLC that are dead while the PLC is within a cycle or not stable: no edge and no
    /// property reads them.
    std::vector<Id<Network::Variable>> dead_outputs() const;

private:
    using Variables = std::set<Id<Network::Variable>>;
    struct Uses {
        Variables read = {}, written = {};
    };

    bool is_entered(Id<Network::Location> location) const;
    bool reads(Id<Expr> term, const Variables& variables) const;
    bool meet(const Variables& left, const Variables& right) const;
    std::vector<bool> closed(std::vector<bool> processes) const;
    Variables variables_read() const;
    Variables read_by_properties() const;
    void take(Id<Expr> term, Variables& variables) const;
    bool is_location_observed() const;
    bool is_quiescence_observed() const;
    Variables requests() const;
    Uses uses_of(const Network::Edge& edge) const;
    bool waits_for(const Network::Template& timer) const;

    const Network& network_;
    const Network::Controller& controller_;
    const Network::Template& plc_;
    std::vector<Id<Network::Process>> accepting_ = {};
    Variables used_ = {}, written_ = {};  // variables that the timers use, and variables that they write
    std::vector<Uses> uses_ = {};         // variables that each process reads and writes; empty for observers and the
                                          // PLC
    std::vector<bool> is_other_ = {};     // per process: true unless it is an observer or the PLC
    Variables of_observers_ = {};         // variables that observers write
    Variables seen_by_observers_ = {};    // variables that observers read
};

}  // namespace grafverif::timed
