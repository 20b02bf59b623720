// SPDX-License-Identifier: MIT
// Sub-loops that take turns, each searched as a system of its own with what is asked of it alone, and what each must be for
// others to be judged without it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "check/parts/carry.hpp"
#include "check/symbolic/turns.hpp"
#include "ir/system_parts.hpp"

namespace grafverif {

/// Some parts, searched as a system of their own.
struct Searched {
    PartList chosen = {};
    TransitionSystem system = {};
    SymbolicOptions options = {};
    std::vector<Id<Property>> asked = {};  ///< of the whole, in the order of its verdicts
    std::unique_ptr<symbolic::Check> check = {};
    SymbolicResult result = {};
    std::unique_ptr<symbolic::Turns> turns = {};
    Neighbour as = {};
    bool knows_time = false, knows_rest = false, knows_settled = false;  ///< what of `as` was found out
};

class TurnSearches {
public:
    /// Both outlive this.
    TurnSearches(const TransitionSystem& system, const SymbolicOptions& options)
        : system_(system), options_(options), flat_(flattened(system)), of_(parts_of_symbols(system)) {}

    const FlatSystem& flat() const { return flat_; }
    /// Clocks count.
    bool timed() const { return system_.parts.can_wait.valid(); }
    PartList all() const;
    PartList others(const PartList& chosen) const;

    bool asked(const Property& property) const;
    /// The parts that the operands read.
    PartList reads(const std::vector<Id<Expr>>& operands) const;
    /// It speaks of every part alike: that none can lock time, come to an end, race or leave a range.
    bool about_each(const Property& property) const;

    /// Of these parts; made when first asked for. What was made stays.
    Searched& search(const PartList& chosen);
    symbolic::Turns& turns(Searched& search);
    /// A part as far as a verdict on others needs to know it.
    const Neighbour& neighbour(std::uint32_t part, const Verdict& verdict, bool at_stable);
    void forget() { searches_.clear(); }

    std::uint64_t bytes() const { return bytes_; }
    double seconds() const { return seconds_; }

private:
    bool set_by_several(Id<Expr> term) const;
    std::vector<Id<Expr>> share(const Property& property, std::uint32_t part) const;
    void run(Searched& made);
    void know(Searched& search, Claim claim, bool at_stable);

    const TransitionSystem& system_;
    const SymbolicOptions& options_;
    FlatSystem flat_;
    const std::vector<std::uint32_t> of_;  ///< per symbol of main, its part
    std::map<PartList, Searched> searches_ = {};
    std::uint64_t bytes_ = 0;
    double seconds_ = 0;
};

}  // namespace grafverif
