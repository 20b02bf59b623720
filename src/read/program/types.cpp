// SPDX-License-Identifier: MIT
// Resolves elementary types and the types that a file declares. Array types with the same bounds and the same element
// type are the same type.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif::program {

namespace {

constexpr std::size_t most_types = 200;  ///< maximum nesting depth of types

}  // namespace

namespace {

constexpr std::int64_t most_elements = 100'000;

}  // namespace

// -- types ------------------------------------------------------------------------------------------------------------

void Reader::index_types() {
    for (std::size_t index = 0; index < file_->types.size(); ++index) {
        const st::TypeDeclaration& declaration = file_->types[index];
        type_declarations_.try_emplace(declaration.name.word.index, index);
        record_.declare(DeclarationKind::DataType, text(declaration.name.word), declaration.name.where,
                        declaration.where);
    }
    type_states_.assign(file_->types.size(), State::New);
}

void Reader::declare_types() {
    for (std::size_t index = 0; index < file_->types.size(); ++index) {
        const st::Name name = file_->types[index].name;
        const std::size_t first = type_declarations_.at(name.word.index);
        if (first != index || (type_states_[index] == State::New && types_.contains(name.word.index)))
            diagnostics->add(
                messages::duplicate_name(name.where, "type", text(name.word), file_->types[first].name.where));
        else declare_type(index);
    }
}

/// Declares a type, unless it was already declared because another type refers to it.
void Reader::declare_type(std::size_t index) {
    if (type_states_[index] != State::New) return;
    type_states_[index] = State::Open;
    const st::TypeDeclaration& declaration = file_->types[index];
    if (declaration.structure) declare_structure(declaration);
    else {
        if (declaration.initial.valid())
            reject(file_->exprs[declaration.initial].where, "an initial value of a type",
                   "declare the initial value for each variable");
        const auto type = declaration.type.values.empty()
                              ? type_of(declaration.type, declaration.where)
                              : enumeration(text(declaration.name.word), declaration.type, declaration.where);
        if (type) types_[declaration.name.word.index] = *type;
    }
    type_states_[index] = State::Done;
}

std::optional<Id<Type>> Reader::enumeration(std::string_view name, const st::Type& type, Span /*where*/) {
    Type made{
        Type::Kind::Enumeration, std::string(name), 0, static_cast<std::int64_t>(type.values.size()) - 1, {}, {}, {}};
    const Id<Type> id{static_cast<std::uint32_t>(program.types.size())};
    record_values(name, type);
    for (const st::Name value : type.values) {
        const auto [known, fresh] = values_.try_emplace(
            value.word.index, EnumerationValue{id, static_cast<std::int64_t>(made.values.size()), value.where});
        if (!fresh)
            diagnostics->add(messages::duplicate_name(value.where, "value", text(value.word), known->second.origin));
        made.values.push_back(text(value.word));
    }
    return program.types.add(std::move(made));
}

std::optional<Id<Type>> Reader::type_of(const st::Type& type, Span where) {
    struct Level {
        std::size_t& depth;
        explicit Level(std::size_t& of) : depth(++of) {}
        ~Level() { --depth; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;
    };
    const Level level(type_depth_);
    if (type_depth_ > most_types)
        return reject(where, fmt::format("a type with more than {} levels of nesting", most_types),
                      "reduce the nesting"),
               std::nullopt;
    if (!type.values.empty()) return enumeration("enumeration", type, where);
    if (!type.dimensions.empty()) return array(type, where);
    if (type.composite) return reject(where, "a pointer or qualified type", "use elementary types"), std::nullopt;
    if (type.low.valid()) return subrange(type, where);
    if (const auto known = types_.find(type.name.word.index); known != types_.end()) return known->second;
    if (const auto declared = type_declarations_.find(type.name.word.index); declared != type_declarations_.end()) {
        if (type_states_[declared->second] == State::Open) {
            diagnostics->add(messages::recursive_unit(type.name.where, text(type.name.word)));
            return {};
        }
        declare_type(declared->second);
        const auto known = types_.find(type.name.word.index);
        return known == types_.end() ? std::nullopt : std::optional(known->second);  // an error has been reported
    }
    if (const auto unit = units_.find(type.name.word.index); unit != units_.end()) {
        if (file_->units[unit->second].kind != st::UnitKind::FunctionBlock)
            return reject(type.name.where, "an instance of " + quoted(text(type.name.word)),
                          "instantiate function blocks only"),
                   std::nullopt;
        declare(unit->second);
        if (states_[unit->second] == State::Open) {
            diagnostics->add(messages::recursive_unit(type.name.where, text(type.name.word)));
            return {};
        }
        const Id<Type> id =
            program.types.add({Type::Kind::Block, text(type.name.word), 0, 0, {}, declared_[unit->second], {}});
        types_[type.name.word.index] = id;
        return id;
    }
    static constexpr std::array known_elsewhere = {"REAL",  "LREAL",       "STRING",       "WSTRING", "LINT",
                                                   "ULINT", "LWORD",       "LTIME",        "DATE",    "TOD",
                                                   "DT",    "TIME_OF_DAY", "DATE_AND_TIME"};
    const std::string name = capitals(type.name.word);
    // Programs can declare variables of these standard types, but cannot use them.
    if (std::ranges::find(known_elsewhere, name) != known_elsewhere.end()) {
        const Id<Type> id = program.types.add({Type::Kind::Unsupported, name, 0, 0, {}, {}, {}});
        types_[type.name.word.index] = id;
        return id;
    }
    diagnostics->add(messages::unknown(type.name.where, "type", text(type.name.word), ""));
    return {};
}

/// Declares a structure; the Program represents it as a block without a body.
void Reader::declare_structure(const st::TypeDeclaration& declaration) {
    Unit unit;
    unit.kind = Unit::Kind::Structure;
    unit.name = text(declaration.name.word);
    unit.origin = declaration.name.where;
    const Id<Unit> id = program.units.add(std::move(unit));
    scopes_.emplace_back();
    calls_.emplace_back();
    declare_variables(id, declaration.members, false);
    if (declaration.members.empty()) reject(declaration.name.where, "a structure without members", "declare a member");
    types_[declaration.name.word.index] =
        program.types.add({Type::Kind::Block, text(declaration.name.word), 0, 0, {}, id, {}});
}

std::optional<Id<Type>> Reader::array(const st::Type& type, Span where) {
    if (type.dimensions.size() > most_types)
        return reject(where, fmt::format("an array with more than {} dimensions", most_types), "use fewer dimensions"),
               std::nullopt;
    st::Type inner = type;
    inner.dimensions.clear();
    inner.composite = false;
    auto element = type_of(inner, where);
    if (!element) return {};
    for (std::size_t i = type.dimensions.size(); i-- > 0;) {
        std::array<std::int64_t, 2> bounds = {};
        for (std::size_t side = 0; side < 2; ++side) {
            const Id<st::Expr> bound = type.dimensions[i][side];
            if (!bound.valid()) return reject(where, "this array", "write bounds such as `1..10`"), std::nullopt;
            const auto known = constant(bound, dint_);
            if (!known) return {};
            bounds[side] = *known;
        }
        const std::int64_t count = bounds[1] - bounds[0] + 1;
        if (count < 1) return reject(where, "an array without elements", "write the smaller bound first"), std::nullopt;
        if (count * std::max<std::int64_t>(size_of(program, *element), 1) > most_elements) {
            diagnostics->add(messages::program_too_large(where, "elementary variables in one array", most_elements));
            return {};
        }
        Type made{Type::Kind::Array, {}, bounds[0], bounds[1], {}, {}, *element};
        made.name = "ARRAY[" + std::to_string(made.low) + ".." + std::to_string(made.high) + "] OF " +
                    program.types[*element].name;
        const auto [known, fresh] = arrays_.try_emplace({element->index, made.low, made.high});
        if (fresh) known->second = program.types.add(std::move(made));
        element = known->second;
    }
    return element;
}

std::optional<Id<Type>> Reader::subrange(const st::Type& type, Span where) {
    st::Type whole = type;
    whole.low = whole.high = {};
    const auto base = type_of(whole, where);
    if (!base) return {};
    if (program.types[*base].kind != Type::Kind::Integer || program.types[*base].element.valid())
        return reject(where, "a subrange of this type", "use an integer type"), std::nullopt;
    const auto low = constant(type.low, *base), high = constant(type.high, *base);
    if (!low || !high) return {};
    if (*low > *high) return reject(where, "an empty subrange", "write the smaller bound first"), std::nullopt;
    Type made{Type::Kind::Integer, {}, *low, *high, {}, {}, *base};
    made.name = program.types[*base].name + "(" + std::to_string(*low) + ".." + std::to_string(*high) + ")";
    return program.types.add(std::move(made));
}

}  // namespace grafverif::program
