// SPDX-License-Identifier: MIT
#include "check/decomposition/subsystem_searches.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "ir/junction.hpp"

namespace grafverif {

bool SubsystemSearches::requested(const Property& property) const {
    const std::vector<std::string>& names = options_.properties;
    return names.empty() || std::ranges::find(names, property.name) != names.end();
}

PartList SubsystemSearches::all() const {
    PartList every(system_.parts.each.size());
    std::iota(every.begin(), every.end(), 0U);
    return every;
}

PartList SubsystemSearches::others(const PartList& chosen) const {
    PartList rest = all();
    std::erase_if(rest, [&](std::uint32_t part) { return std::ranges::binary_search(chosen, part); });
    return rest;
}

PartList SubsystemSearches::reads(const std::vector<Id<Expr>>& operands) const {
    const Table<TransitionSystem::Symbol>& symbols = system_.modules[system_.main].symbols;
    PartList read;
    std::vector<Id<Expr>> open = operands;
    while (!open.empty()) {
        const Id<Expr> term = open.back();
        open.pop_back();
        for (const Id<Expr> leaf : leaves(system_.exprs, term)) {
            const Id<TransitionSystem::Symbol> symbol{static_cast<std::uint32_t>(system_.exprs[leaf].value)};
            const auto* define = std::get_if<TransitionSystem::DefineSymbol>(&symbols[symbol].kind);
            if (of_[symbol.index] != no_part) read.push_back(of_[symbol.index]);
            else if (define != nullptr) open.push_back(define->value);
            else return all();  // several parts write this variable
        }
    }
    std::ranges::sort(read);
    read.erase(std::ranges::unique(read).begin(), read.end());
    return read.empty() ? PartList{0} : read;
}

/// True if `term` is a flag that several parts set. In the search of a single part, the part has a separate copy of the
/// flag.
bool SubsystemSearches::set_by_several(Id<Expr> term) const {
    if (system_.exprs[term].op != Op::Variable) return false;
    const Id<TransitionSystem::Symbol> symbol{static_cast<std::uint32_t>(system_.exprs[term].value)};
    const TransitionSystem::Symbol& of = system_.modules[system_.main].symbols[symbol];
    return of_[symbol.index] == no_part && std::holds_alternative<TransitionSystem::StateSymbol>(of.kind);
}

bool SubsystemSearches::about_each(const Property& property) const {
    if (property.at_stable || property.operands.size() != 1) return false;
    const Id<Expr> operand = property.operands.front();
    if (property.pattern == Pattern::AlwaysPossible)
        return timed() && flat_.justice.empty() &&
               (operand == system_.parts.can_move || operand == system_.parts.can_wait);
    return property.pattern == Pattern::Never && reads({operand}).size() > 1 &&
           std::ranges::all_of(operands_of(system_.exprs, operand, Op::Or),
                               [&](Id<Expr> each) { return set_by_several(each) || reads({each}).size() == 1; });
}

/// Returns the disjuncts of `property` that concern `part`. Requires about_each(property): the property is decided for
/// each part separately.
std::vector<Id<Expr>> SubsystemSearches::share(const Property& property, std::uint32_t part) const {
    std::vector<Id<Expr>> found = operands_of(system_.exprs, property.operands.front(), Op::Or);
    std::erase_if(found, [&](Id<Expr> each) { return !set_by_several(each) && reads({each}) != PartList{part}; });
    return found;
}

/// Returns the result of a search of the system that consists of the parts `chosen`. The search decides all requested
/// properties that read exactly these parts. The first call for these parts performs the search.
SubsystemResult& SubsystemSearches::search(const PartList& chosen) {
    const auto [known, fresh] = searches_.try_emplace(chosen);
    SubsystemResult& made = known->second;
    if (!fresh) return made;
    made.chosen = chosen;
    made.system = with_parts(system_, chosen);
    for (const Id<Property> id : system_.properties.ids()) {
        Property property = system_.properties[id];
        if (!requested(property)) continue;
        if (about_each(property)) {
            if (chosen.size() > 1) continue;
            if (property.pattern == Pattern::Never)
                property.operands = {made.system.exprs.disjunction(share(property, chosen.front()))};
        } else if (reads(property.operands) != chosen) {
            continue;
        }
        made.requested.push_back(id);
        made.system.properties.add(std::move(property));
    }
    run(made);
    return made;
}

void SubsystemSearches::run(SubsystemResult& made) {
    made.options = options_;
    made.options.properties = {};
    for (const auto& [parts, search] : searches_)
        if (search.check) made.options.max_memory -= std::min(made.options.max_memory / 2, search.check->bytes());
    made.check = std::make_unique<symbolic::Check>(made.system, made.options);
    made.result = made.check->result();
    bytes_ += made.result.bytes;
    seconds_ += made.result.seconds;
    if (made.chosen.size() > 1) return;
    made.as.name = system_.parts.each[made.chosen.front()].name;
    made.as.searched = made.check->complete();
}

symbolic::InterleavingPremises& SubsystemSearches::interleaving(SubsystemResult& search) {
    if (search.interleaving) return *search.interleaving;
    std::vector<Id<Expr>> moves;
    for (const std::uint32_t part : search.chosen) moves.push_back(system_.parts.each[part].moves);
    search.interleaving =
        std::make_unique<symbolic::InterleavingPremises>(search.system, *search.check, system_.parts.waits, moves);
    return *search.interleaving;
}

/// Determines the facts about a part on which the preservation of verdicts about other parts depends.
void SubsystemSearches::know(SubsystemResult& search, PreservationClass claim, bool at_stable) {
    OmittedSubsystem& as = search.as;
    if (!as.searched || (claim == PreservationClass::Everywhere && !at_stable)) return;
    // Each flag `knows_...` is set last. Therefore, if a computation ends with an exception because of the memory
    // limit, the next call repeats the computation.
    if (timed() && !search.knows_time) {
        as.never_locks = interleaving(search).never_locks();
        as.diverges = as.never_locks || interleaving(search).diverges();
        search.knows_time = true;
    }
    if (claim == PreservationClass::Unavoidable && !search.knows_rest) {
        as.rests = interleaving(search).rests();
        search.knows_rest = true;
    }
    if (!at_stable || !search.system.settled.valid() || search.knows_settled) return;
    const Bdd settled = search.check->meaning(search.system, search.system.settled);
    as.settles = timed() ? (interleaving(search).ready() & ~settled).is_false()
                         : !(interleaving(search).reached() & settled).is_false();
    search.knows_settled = true;
}

const OmittedSubsystem& SubsystemSearches::omitted(std::uint32_t part, const Verdict& verdict, bool at_stable) {
    SubsystemResult& found = search({part});
    know(found, preservation_class_of(verdict), at_stable);
    return found.as;
}

}  // namespace grafverif
