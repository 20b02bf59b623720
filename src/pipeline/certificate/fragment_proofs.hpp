// SPDX-License-Identifier: MIT
// Proofs of verdicts by fragments of a network (fragment.hpp), for networks with too many states for a complete search.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "ir/network_fragments.hpp"
#include "pipeline/certificate/fragment.hpp"

namespace grafverif {

class FragmentProofs {
public:
    struct Proof {
        FragmentContent content = {};
        FragmentStates found = {};
        std::vector<Property> properties = {};  ///< proved properties; empty if the states exclude only model errors
    };

    /// `flat` is expanded. Both arguments must outlive the object.
    FragmentProofs(const Network& flat, const FragmentLimits& limits);

    /// Proves a verdict on single states that a search of fragments, of subsystems, or of an input abstraction has
    /// decided without a run. Returns false if no fragment is found.
    bool prove(const Verdict& reported, const Property& property);
    /// Adds fragments until each model error is excluded by some fragment. Returns false if some model error cannot be
    /// excluded.
    bool exclude_errors();
    const std::vector<Proof>& proofs() const { return proofs_; }
    /// Returns the sets of states that restrict the choices of the proofs.
    const std::vector<FragmentStates>& bounds() const { return bounds_; }

    /// Returns the states of each subsystem, which prove `no deadlock`. Returns nothing if a subsystem is unsuitable.
    std::optional<std::vector<FragmentStates>> subsystems() const;

private:
    bool add(FragmentContent content, const Property* property);
    bool prove_by_cells(std::vector<std::uint32_t> chosen, const Property* property);
    FragmentContent content_of(const LocalNetwork& local) const;
    FragmentContent content_of_parts(const std::vector<std::uint32_t>& chosen) const;
    bool prove_by_inputs(const InputsAbstracted& reduced, const Property& property);
    bool prove_again(const Property& property);
    void omit_unread(FragmentContent& content, const Property& property) const;
    void add_bounds(Id<Network::Process> process);

    const Network& flat_;
    const FragmentLimits& limits_;
    NetworkFragments cells_;
    std::vector<Proof> proofs_ = {};
    std::vector<FragmentStates> bounds_ = {};
    std::set<Id<Network::Process>> bounded_ = {};  ///< the processes that were explored for `bounds_`
};

}  // namespace grafverif
