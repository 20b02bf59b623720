// SPDX-License-Identifier: MIT
// Checks formulas for external tools against the model into which they are written. The check is necessary, because
// NuSMV rejects a complete model if one name is unknown.
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "emit/nusmv/nusmv.hpp"
#include "emit/nusmv/text.hpp"
#include "emit/wide.hpp"
#include "syntax/print/formula.hpp"

namespace grafverif::nusmv {

namespace {

using System = TransitionSystem;
using Type = FormulaName::Type;

/// The names of a model and their meanings.
class KnownNames {
public:
    explicit KnownNames(const System& system) : system_(system) {
        const Names names = names_of(system);
        add(names.symbols[system.main.index], "", {});
        for (const Id<System::Instance> id : system.instances.ids())
            add(names.symbols[system.instances[id].module.index], names.instances[id.index] + ".", id);
        for (const std::string& value : names.values) values_.insert(value);
    }

    std::optional<FormulaName> operator()(std::string_view name) const {
        if (values_.contains(std::string(name))) return FormulaName{Type::Value, false};
        const auto found = places_.find(std::string(name));
        if (found == places_.end()) return {};
        return FormulaName{type_of(found->second), is_of_steps(found->second)};
    }

private:
    /// A symbol of an instance; if the id of the instance is invalid, a symbol of main.
    using Place = std::pair<Id<System::Instance>, Id<System::Symbol>>;

    void add(const std::vector<std::string>& names, const std::string& path, Id<System::Instance> instance) {
        for (std::size_t i = 0; i < names.size(); ++i)
            places_.emplace(path + names[i], Place{instance, {static_cast<std::uint32_t>(i)}});
    }

    const System::Symbol& symbol(Place place) const {
        const auto& [instance, id] = place;
        return system_.modules[instance.valid() ? system_.instances[instance].module : system_.main].symbols[id];
    }

    Type type_of(Place place) const {
        const System::Symbol& here = symbol(place);
        if (std::holds_alternative<System::ParameterSymbol>(here.kind))
            return type_of({{}, system_.instances[place.first].arguments[place.second.index]});
        if (const auto* member = std::get_if<System::MemberSymbol>(&here.kind))
            return type_of({member->instance, member->symbol});
        if (!here.values.empty()) return Type::Value;
        return here.type.boolean ? Type::Boolean : Type::Number;
    }

    /// True if the value of the symbol depends on a choice that is made for each step, and not only on the state.
    bool is_of_steps(Place place) const {
        System seen = system_;
        Table<System::Symbol>& main = seen.modules[seen.main].symbols;
        Id<System::Symbol> id = place.second;
        if (place.first.valid()) {
            const System::Symbol inner = symbol(place);
            id = main.add({"", inner.type, System::MemberSymbol{place.first, place.second}, "", {}, {}});
        }
        const FlatSystem flat = flattened(seen);
        return std::ranges::any_of(leaves(flat.exprs, flat.symbols[id.index]), [&](Id<Expr> leaf) {
            return flat.variables[{static_cast<std::uint32_t>(flat.exprs[leaf].value)}].choice;
        });
    }

    const System& system_;
    std::unordered_map<std::string, Place> places_ = {};
    std::unordered_set<std::string> values_ = {};
};

/// Returns `system` without the properties for which `fault` returns a reason, and adds these properties to the list of
/// omitted properties.
System without_faulty(System system, const std::function<std::optional<std::string>(const Property&)>& fault) {
    Table<Property> kept;
    std::vector<System::Omitted> omitted;
    auto before = system.omitted.begin();
    for (const Id<Property> id : system.properties.ids()) {
        for (; before != system.omitted.end() && before->before <= id.index; ++before) {
            omitted.push_back(*before);
            omitted.back().before = kept.size();
        }
        Property property = system.properties[id];
        if (auto what = fault(property)) {
            property.operands.clear();
            omitted.push_back({std::move(property), std::move(*what), kept.size()});
        } else {
            kept.add(std::move(property));
        }
    }
    for (; before != system.omitted.end(); ++before) {
        omitted.push_back(*before);
        omitted.back().before = kept.size();
    }
    system.properties = std::move(kept);
    system.omitted = std::move(omitted);
    return system;
}

}  // namespace

System sayable(System system) {
    const auto passed_through = [](const Property& property) { return formula_language(property.pattern).has_value(); };
    if (std::ranges::none_of(system.properties, passed_through)) return system;
    const KnownNames names(system);
    return without_faulty(system, [&](const Property& property) -> std::optional<std::string> {
        const auto language = formula_language(property.pattern);
        const auto fault = language ? formula_fault(*language, property.raw, std::cref(names)) : std::nullopt;
        return fault ? std::optional(fault->what) : std::nullopt;
    });
}

System narrow(System system) {
    FlatSystem flat = flattened(system);
    std::vector<Id<Expr>> terms;
    for (const Property& property : system.properties)
        for (const Id<Expr> operand : property.operands) terms.push_back(flattened(system, flat, operand));
    const std::vector<bool> wide = wide_terms(flat);
    if (std::ranges::none_of(terms, [&](Id<Expr> term) { return wide[term.index]; })) return system;
    return without_faulty(system, [&](const Property& property) -> std::optional<std::string> {
        const bool any = std::ranges::any_of(
            property.operands, [&](Id<Expr> operand) { return wide[flattened(system, flat, operand).index]; });
        return any ? std::optional<std::string>(too_wide) : std::nullopt;
    });
}

}  // namespace grafverif::nusmv
