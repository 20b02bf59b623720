// SPDX-License-Identifier: MIT
// Searches of interleaved subsystems ("sub-loops"). A search explores some subsystems as a separate system. The search
// decides the queries that concern only these subsystems, and the conditions under which these subsystems can be
// omitted from other queries.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "check/decomposition/preservation.hpp"
#include "check/symbolic/interleaving_premises.hpp"
#include "ir/subsystems.hpp"

namespace grafverif {

/// The search of a system that consists of some parts (independent subsystems) of the complete system.
struct SubsystemResult {
    PartList chosen = {};
    TransitionSystem system = {};
    SymbolicOptions options = {};
    std::vector<Id<Property>> requested = {};  ///< properties of the complete system, in the order of the verdicts
    std::unique_ptr<symbolic::Check> check = {};
    SymbolicResult result = {};
    std::unique_ptr<symbolic::InterleavingPremises> interleaving = {};
    OmittedSubsystem as = {};
    /// `knows_time`, `knows_rest` and `knows_settled` are true if the corresponding members of `as` have been computed.
    bool knows_time = false, knows_rest = false, knows_settled = false;
};

class SubsystemSearches {
public:
    /// Both arguments must outlive the object.
    SubsystemSearches(const TransitionSystem& system, const SymbolicOptions& options)
        : system_(system), options_(options), flat_(flattened(system)), of_(parts_of_symbols(system)) {}

    const FlatSystem& flat() const { return flat_; }
    /// True if the system has clocks.
    bool timed() const { return system_.parts.can_wait.valid(); }
    PartList all() const;
    PartList others(const PartList& chosen) const;

    bool requested(const Property& property) const;
    /// Returns the parts that the operands of a property read.
    PartList reads(const std::vector<Id<Expr>>& operands) const;
    /// True if the property states that no part has a timelock, a deadlock, a race or a value
    /// outside its range; the property is then decided for each part.
    bool about_each(const Property& property) const;

    /// Returns the search of the parts `chosen`. The first call for `chosen` creates the search; later calls return the
    /// stored search.
    SubsystemResult& search(const PartList& chosen);
    symbolic::InterleavingPremises& interleaving(SubsystemResult& search);
    /// Returns the facts about `part` on which the preservation of a verdict about other parts depends.
    const OmittedSubsystem& omitted(std::uint32_t part, const Verdict& verdict, bool at_stable);
    void forget() { searches_.clear(); }

    std::uint64_t bytes() const { return bytes_; }
    double seconds() const { return seconds_; }

private:
    bool set_by_several(Id<Expr> term) const;
    std::vector<Id<Expr>> share(const Property& property, std::uint32_t part) const;
    void run(SubsystemResult& made);
    void know(SubsystemResult& search, PreservationClass claim, bool at_stable);

    const TransitionSystem& system_;
    const SymbolicOptions& options_;
    FlatSystem flat_;
    const std::vector<std::uint32_t> of_;  ///< part of each symbol of the main module; no_part for a symbol of several
                                           ///< parts
    std::map<PartList, SubsystemResult> searches_ = {};
    std::uint64_t bytes_ = 0;
    double seconds_ = 0;
};

}  // namespace grafverif
