// SPDX-License-Identifier: MIT
#include "emit/nusmv/text.hpp"

#include <ostream>
#include <unordered_set>
#include <variant>

namespace grafverif::nusmv {

namespace {

using System = TransitionSystem;

/// Returns legal names for `names`. Records changed names under `scope`.
std::vector<std::string> legal(Names& result, const std::string& scope, const std::vector<std::string>& names) {
    std::vector<std::string> made = legal_names(Target::Nusmv, names);
    std::vector<Renaming> changes = renamings(names, made);
    if (!changes.empty()) result.changed.push_back({scope, std::move(changes)});
    return made;
}

/// Names the symbols of a module; in main, also the instances, which share its scope.
void name_symbols(Names& result, const System& system, Id<System::Module> id) {
    const System::Module& module = system.modules[id];
    std::vector<std::string> preferred_names;
    std::vector<std::size_t> owners;
    for (const Id<System::Symbol> symbol : module.symbols.ids()) {
        if (std::holds_alternative<System::MemberSymbol>(module.symbols[symbol].kind)) continue;
        preferred_names.push_back(module.symbols[symbol].name);
        owners.push_back(symbol.index);
    }
    if (id == system.main)
        for (const System::Instance& instance : system.instances) preferred_names.push_back(instance.name);
    const std::vector<std::string> made = legal(result, "in module " + result.modules[id.index], preferred_names);
    std::vector<std::string>& symbols = result.symbols[id.index];
    symbols.resize(module.symbols.size());
    for (std::size_t i = 0; i < owners.size(); ++i) symbols[owners[i]] = made[i];
    if (id == system.main)
        result.instances.assign(made.begin() + static_cast<std::ptrdiff_t>(owners.size()), made.end());
}

void name_members(Names& result, const System& system) {
    const System::Module& main = system.modules[system.main];
    for (const Id<System::Symbol> id : main.symbols.ids()) {
        const auto* member = std::get_if<System::MemberSymbol>(&main.symbols[id].kind);
        if (member == nullptr) continue;
        const System::Instance& instance = system.instances[member->instance];
        result.symbols[system.main.index][id.index] = result.instances[member->instance.index] + "." +
                                                      result.symbols[instance.module.index][member->symbol.index];
    }
}

/// Chooses one name for each named value. The name differs from the names of symbols in all modules, because constants
/// are global in NuSMV.
void name_values(Names& result, const System& system) {
    std::vector<std::string> preferred_names;
    for (const System::Module& module : system.modules)
        for (const System::Symbol& symbol : module.symbols)
            for (const std::string& value : symbol.values)
                if (result.value_places.try_emplace(value, preferred_names.size()).second)
                    preferred_names.push_back(value);
    if (preferred_names.empty()) return;
    std::unordered_set<std::string> taken(result.instances.begin(), result.instances.end());
    for (const std::vector<std::string>& symbols : result.symbols) taken.insert(symbols.begin(), symbols.end());
    result.values = legal_names(Target::Nusmv, preferred_names, taken);
    std::vector<Renaming> changes = renamings(preferred_names, result.values);
    if (!changes.empty()) result.changed.push_back({"of values", std::move(changes)});
}

/// Returns the name of the specification of a property. The specification of `reachable p` is negated, and its name
/// (`never_...`) indicates the negation.
std::string specification_name(const Property& property) {
    return property.pattern == Pattern::Reachable ? "never_" + property.name : property.name;
}

}  // namespace

Names names_of(const System& system) {
    Names result;
    std::vector<std::string> modules, properties;
    for (const System::Module& module : system.modules) modules.push_back(module.name);
    for (const Property& property : system.properties) properties.push_back(specification_name(property));
    result.modules = legal(result, "of modules", modules);
    result.symbols.resize(modules.size());
    for (const Id<System::Module> id : system.modules.ids()) name_symbols(result, system, id);
    name_members(result, system);
    name_values(result, system);
    result.properties = legal(result, "of properties", properties);
    return result;
}

Id<Expr> NamedValues::named(Id<System::Module> module, Id<Expr> term, Id<System::Symbol> symbol) {
    if (names_.values.empty()) return term;
    const auto [known, fresh] = known_.try_emplace(Key{module, term, symbol});
    if (fresh) {
        const Id<Expr> made = rewritten(module, term, symbol);  // this call may insert elements into `known_`
        known_[Key{module, term, symbol}] = made;
        return made;
    }
    return known->second;
}

Id<Expr> NamedValues::rewritten(Id<System::Module> module, Id<Expr> term, Id<System::Symbol> symbol) {
    const Expr node = exprs_[term];
    const Table<System::Symbol>& symbols = system_.modules[module].symbols;
    if (node.op == Op::Integer && names_values(module, symbol)) {
        const auto offset = static_cast<std::size_t>(node.value - symbols[symbol].type.low);
        const std::size_t place = names_.value_places.at(symbols[symbol].values[offset]);
        return exprs_.leaf(Op::Variable, static_cast<std::uint32_t>(symbols.size() + place));
    }
    std::vector<Id<Expr>> operands(exprs_.operands(term).begin(), exprs_.operands(term).end());
    if (operands.empty()) return term;
    Id<System::Symbol> compared;
    if (node.op == Op::Equal || node.op == Op::NotEqual)
        for (const Id<Expr> operand : operands) {
            const Expr& side = exprs_[operand];
            const Id<System::Symbol> leaf{static_cast<std::uint32_t>(side.value)};
            if (side.op == Op::Variable && names_values(module, leaf)) compared = leaf;
        }
    if (node.op == Op::Conditional) compared = symbol;
    for (std::size_t i = 0; i < operands.size(); ++i)
        operands[i] =
            named(module, operands[i], node.op == Op::Conditional && i == 0 ? Id<System::Symbol>{} : compared);
    return exprs_.apply(node.op, operands);
}

LeafPrinter leaf_printer(const Names& names, Id<System::Module> module) {
    return [&symbols = names.symbols[module.index], &values = names.values](std::ostream& out, const Expr& leaf) {
        const auto index = static_cast<std::size_t>(leaf.value);
        out << (index < symbols.size() ? symbols[index] : values[index - symbols.size()]);
    };
}

void print_comment(std::ostream& out, std::string_view text) {
    constexpr std::size_t width = 97;
    while (!text.empty()) {
        std::size_t length = text.size();
        if (length > width) {
            const std::size_t space = text.rfind(' ', width);
            length =
                space != std::string_view::npos && space > 0 ? space : std::min(text.find(' ', width), text.size());
        }
        out << "-- " << text.substr(0, length) << '\n';
        text.remove_prefix(length);
        while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    }
}

}  // namespace grafverif::nusmv
