// SPDX-License-Identifier: MIT
// Searches of interleaved subsystems ("sub-loops"): each is searched as a separate system with the queries that concern
// it alone, and with the side conditions under which it can be omitted from queries about others.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "check/decomposition/preservation.hpp"
#include "check/symbolic/interleaving_premises.hpp"
#include "ir/subsystems.hpp"

namespace grafverif {

/// Some parts, searched as a separate system.
struct SubsystemResult {
    PartList chosen = {};
    TransitionSystem system = {};
    SymbolicOptions options = {};
    std::vector<Id<Property>> requested = {};  ///< of the complete system, in the order of its verdicts
    std::unique_ptr<symbolic::Check> check = {};
    SymbolicResult result = {};
    std::unique_ptr<symbolic::InterleavingPremises> turns = {};
    OmittedSubsystem as = {};
    bool knows_time = false, knows_rest = false, knows_settled = false;  ///< the properties of `as` that are known
};

class SubsystemSearches {
public:
    /// Both arguments must outlive the object.
    SubsystemSearches(const TransitionSystem& system, const SymbolicOptions& options)
        : system_(system), options_(options), flat_(flattened(system)), of_(parts_of_symbols(system)) {}

    const FlatSystem& flat() const { return flat_; }
    /// True if clocks matter.
    bool timed() const { return system_.parts.can_wait.valid(); }
    PartList all() const;
    PartList others(const PartList& chosen) const;

    bool requested(const Property& property) const;
    /// The parts that the operands read.
    PartList reads(const std::vector<Id<Expr>>& operands) const;
    /// True if it concerns all parts in the same way: no part causes a timelock, terminates, races or leaves a range.
    bool about_each(const Property& property) const;

    /// The search of these parts; created on first use and kept.
    SubsystemResult& search(const PartList& chosen);
    symbolic::InterleavingPremises& turns(SubsystemResult& search);
    /// The properties of a part that a verdict on others requires.
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
    const std::vector<std::uint32_t> of_;  ///< per symbol of main, its part
    std::map<PartList, SubsystemResult> searches_ = {};
    std::uint64_t bytes_ = 0;
    double seconds_ = 0;
};

}  // namespace grafverif
