// SPDX-License-Identifier: MIT
#include "pipeline/variants/match_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/wording.hpp"
#include "syntax/resolve/nearest_of.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

namespace {

using Plug = CompareSide::Plug;
using Plugs = std::vector<Plug>;
using Entry = std::pair<std::string, std::string>;  ///< the two names of `--map`

bool same_word(std::string_view a, std::string_view b) { return st::capitals(a) == st::capitals(b); }

std::string type_text(const Plug& plug) {
    const std::string range =
        plug.type.boolean ? "a Boolean" : fmt::format("an integer from {} to {}", plug.type.low, plug.type.high);
    if (plug.program_type == nullptr || plug.type.boolean) return range;
    switch (plug.program_type->kind) {
    case Program::Type::Kind::Time: return "a duration";
    case Program::Type::Kind::Enumeration: return "an enumeration";
    case Program::Type::Kind::Bits: return fmt::format("a bit string ({})", plug.program_type->name);
    default: return range;
    }
}

bool is_of_kind(const Plug& plug, Program::Type::Kind kind) {
    return plug.program_type != nullptr && plug.program_type->kind == kind;
}

std::string entry_text(const Entry& entry) { return fmt::format("`--map {}={}`", entry.first, entry.second); }

/// Returns the name and type of an input or output for the report.
Comparison::Variable variable_of(const Plug& plug) {
    Comparison::Variable made{plug.name, plug.type, {}, is_of_kind(plug, Program::Type::Kind::Time)};
    if (plug.program_type != nullptr) made.values = plug.program_type->values;
    return made;
}

/// True if the values of `a` and `b` can be compared exactly. Two enumerations must have the same values in the same
/// order; the case of these names is ignored, because identifiers of IEC 61131-3 are not case-sensitive. The range of
/// integers in a chart may differ from the range in a program, but an input of a program must accept each value of the
/// chart's input.
bool comparable(const Plug& a, const Plug& b, bool input) {
    if (a.type.boolean != b.type.boolean) return false;
    if (a.type.boolean) return true;
    if ((a.program_type == nullptr) == (b.program_type == nullptr))
        return a.type == b.type && (a.program_type == nullptr ||
                                    (a.program_type->kind == b.program_type->kind &&
                                     std::ranges::equal(a.program_type->values, b.program_type->values, same_word)));
    const Plug& of_program = a.program_type != nullptr ? a : b;
    const Plug& of_chart = a.program_type != nullptr ? b : a;
    const Program::Type::Kind kind = of_program.program_type->kind;
    if (kind != Program::Type::Kind::Integer && kind != Program::Type::Kind::Bits) return false;
    return !input || (of_program.type.low <= of_chart.type.low && of_chart.type.high <= of_program.type.high);
}

/// Assigns each input and output of side a to an input or output of side b.
class Matching {
public:
    Matching(std::array<CompareSide, 2>& sides, const ProgramCompareOptions& options, Comparison& result,
             Diagnostics& diagnostics)
        : sides_(sides), options_(options), result_(result), diagnostics_(diagnostics) {}

    bool match() {
        const std::size_t before = diagnostics_.errors();
        set_labels();
        take_stops();
        take_ignored();
        if (!is_valid_map()) return false;
        for (const CompareSide& side : sides_)
            for (const Plug& plug : side.unsupported)
                diagnostics_.add(messages::not_comparable(
                    plug.origin, fmt::format("the type of the output `{}` is not supported", plug.name),
                    fmt::format("use another type, or pass `--ignore {}`", plug.name)));
        result_.inputs = pairs(&CompareSide::inputs, "input");
        result_.outputs = pairs(&CompareSide::outputs, "output");
        if (diagnostics_.errors() != before) return false;
        if (result_.outputs.empty()) diagnostics_.add(messages::nothing_to_compare(sides_[0].origin, sides_[0].name));
        rename();
        return diagnostics_.errors() == before;
    }

private:
    bool with_programs() const { return sides_[0].is_program() || sides_[1].is_program(); }

    /// Sets the names of the sides for messages. If both sides have the same name, appends `(a)` and `(b)`, as in the
    /// report.
    void set_labels() {
        const bool equal = same_word(sides_[0].name, sides_[1].name);
        for (const std::size_t k : {0U, 1U}) {
            const std::string_view mark = k == 0 ? " (a)" : " (b)";
            sides_[k].label = fmt::format("`{}`{}", messages::clipped(sides_[k].name), equal ? mark : "");
        }
    }

    /// Returns the name of the output of side `k` that `--stop-output` selects; empty if the option selects none.
    std::string stop_name(std::size_t k) const {
        if (options_.stop.empty() || !sides_[k].is_program()) return {};
        return options_.stop.size() == 1 ? options_.stop.front() : options_.stop[k];
    }
    std::string stop_text() const { return fmt::format("--stop-output {}", fmt::join(options_.stop, "=")); }

    void take_stops() {
        if (options_.stop.empty()) return;
        for (const std::size_t k : {0U, 1U}) take_stop(k);
        const auto& taken = result_.stop_outputs;
        if (options_.stop.size() == 2) {
            for (const std::size_t k : {0U, 1U})
                if (taken[k].empty())
                    reject_stop(fmt::format("requires a program with the output `{}`, but {} is not such a program",
                                            options_.stop[k], sides_[k].label),
                                "name an output of each program; pass one NAME if only one program has such an output");
        } else if (taken[0].empty() && taken[1].empty())
            reject_stop("does not name an output of a program", "name an output of a program");
    }

    /// Adds an error that has no position in a file.
    void reject(std::string_view problem, std::string_view remedy) {
        diagnostics_.add(messages::not_comparable({}, problem, remedy));
    }

    void reject_stop(std::string_view problem, std::string_view remedy) {
        const bool unsupported = has_unsupported(sides_[0], stop_name(0)) || has_unsupported(sides_[1], stop_name(1));
        reject(fmt::format("`{}` {}", stop_text(),
                           unsupported ? "names an output of a type that is not supported" : problem),
               unsupported ? "use another type" : remedy);
    }

    /// If side `k` has the output that `--stop-output` names, makes this output internal, so that it is not compared.
    void take_stop(std::size_t k) {
        CompareSide& side = sides_[k];
        const std::string name = stop_name(k);
        const auto plug =
            std::ranges::find_if(side.outputs, [&](const Plug& one) { return same_word(one.name, name); });
        if (plug == side.outputs.end()) return;
        Exprs& exprs = side.scan->equations.exprs;
        const Id<Expr> value = side.scan->after[plug->own];
        side.stop = plug->type.boolean ? value : exprs.apply(Op::NotEqual, value, exprs.integer(0));
        side.stop_cell = plug->own;
        result_.stop_outputs[k] = plug->name;
        side.scan->equations.variables[plug->variable].role = Equations::Role::Internal;
        side.outputs.erase(plug);
    }

    void take_ignored() {
        for (const std::string& name : options_.ignored) {
            bool found = false;
            for (CompareSide& side : sides_) {
                const auto has_name = [&](const Plug& one) { return is_called(side, one, name); };
                const bool dropped = std::erase_if(side.unsupported, has_name) > 0;
                if (dropped) result_.ignored.push_back(name);
                found = found || dropped;
                const auto plug = std::ranges::find_if(side.outputs, has_name);
                if (plug == side.outputs.end()) continue;
                found = true;
                result_.ignored.push_back(plug->name);
                if (side.is_program()) side.scan->equations.variables[plug->variable].role = Equations::Role::Internal;
                side.outputs.erase(plug);
            }
            if (!found) report_not_ignored(name);
        }
        std::ranges::sort(result_.ignored);
        result_.ignored.erase(std::ranges::unique(result_.ignored).begin(), result_.ignored.end());
    }

    /// True if `name` is the name of the output by which side `k` reports a stop.
    bool reports_stop(std::size_t k, std::string_view name) const {
        return !result_.stop_outputs[k].empty() && same_word(result_.stop_outputs[k], name);
    }

    void report_not_ignored(const std::string& name) {
        for (const std::size_t k : {0U, 1U})
            if (reports_stop(k, name)) {
                reject(fmt::format("`--ignore {}` omits the output `{}` of {}, which reports a stop according to `{}`",
                                   name, result_.stop_outputs[k], sides_[k].label, stop_text()),
                       "remove one of these options");
                return;
            }
        reject(fmt::format("`--ignore {}` does not name an output of the compared files", name), "name an output");
    }

    static bool same_name(const CompareSide& side, std::string_view a, std::string_view b) {
        return side.is_program() ? same_word(a, b) : a == b;
    }
    static bool is_called(const CompareSide& side, const Plug& plug, std::string_view name) {
        return same_name(side, plug.name, name);
    }

    static bool has_unsupported(const CompareSide& side, std::string_view name) {
        return std::ranges::any_of(side.unsupported, [&](const Plug& one) { return is_called(side, one, name); });
    }

    /// True if each entry of `--map` names an existing input or output of each side, and no name is assigned twice.
    /// Otherwise, adds errors.
    bool is_valid_map() {
        const std::size_t before = diagnostics_.errors();
        for (std::size_t i = 0; i < options_.map.size(); ++i) {
            check_names(options_.map[i]);
            for (std::size_t j = 0; j < i; ++j) check_conflict(options_.map[j], options_.map[i]);
        }
        return diagnostics_.errors() == before;
    }

    void check_names(const Entry& entry) {
        const std::array<std::string_view, 2> names = {entry.first, entry.second};
        std::array<std::string_view, 2> kinds;
        for (const std::size_t k : {0U, 1U}) {
            kinds[k] = kind_of(sides_[k], names[k]);
            if (kinds[k].empty()) report_unknown(sides_[k], names[k], entry);
        }
        if (kinds[0].empty() || kinds[1].empty() || kinds[0] == kinds[1]) return;
        reject(fmt::format("{} assigns the {} `{}` to the {} `{}`", entry_text(entry), kinds[0], names[0], kinds[1],
                           names[1]),
               "name two inputs or two outputs");
    }

    /// Adds an error if two entries of `--map` name the same input or output.
    void check_conflict(const Entry& one, const Entry& other) {
        const bool first = same_name(sides_[0], one.first, other.first);
        const bool second = same_name(sides_[1], one.second, other.second);
        if (!first && !second) return;
        const std::string both = fmt::format("{} and {}", entry_text(one), entry_text(other));
        reject(first && second ? both + " are the same assignment"
                               : fmt::format("{} assign two names to `{}` of {}", both, first ? one.first : one.second,
                                             sides_[first ? 0 : 1].label),
               "remove one of them");
    }

    /// Returns `input` or `output`; empty if the side has no input or output with this name.
    static std::string_view kind_of(const CompareSide& side, std::string_view name) {
        const auto has_name = [&](const Plug& plug) { return is_called(side, plug, name); };
        if (std::ranges::any_of(side.inputs, has_name)) return "input";
        return std::ranges::any_of(side.outputs, has_name) ? "output" : "";
    }

    void report_unknown(const CompareSide& side, std::string_view name, const Entry& entry) {
        if (const std::string option = omitting_option(side, name); !option.empty()) {
            reject(fmt::format("`{}` omits the output `{}` of {}, which {} assigns", option, name, side.label,
                               entry_text(entry)),
                   "remove one of these options");
            return;
        }
        if (has_unsupported(side, name)) {
            reject(fmt::format("{} assigns the output `{}` of {}, but the type of this output is not supported",
                               entry_text(entry), name, side.label),
                   fmt::format("use another type, or pass `--ignore {}` instead", name));
            return;
        }
        std::vector<std::string> known;
        for (const Plugs* plugs : {&side.inputs, &side.outputs})
            for (const Plug& plug : *plugs) known.push_back(plug.name);
        diagnostics_.add(messages::no_such_choice("input or output", name, known, nearest_of(name, known)));
    }

    /// Returns the option of this command line that excludes the output `name` from the comparison; empty if no option
    /// excludes it.
    std::string omitting_option(const CompareSide& side, std::string_view name) const {
        for (const std::string& ignored : options_.ignored)
            if (same_name(side, ignored, name)) return "--ignore " + ignored;
        return reports_stop(&side == &sides_[0] ? 0 : 1, name) ? stop_text() : "";
    }

    /// Returns the name in the second side that `--map` assigns to an input or output of the first side.
    std::optional<std::string> mapped(const Plug& plug) const {
        for (const auto& [first, second] : options_.map)
            if (is_called(sides_[0], plug, first)) return second;
        return {};
    }
    bool is_mapped(const Plug& of_b) const {
        return std::ranges::any_of(options_.map,
                                   [&](const auto& one) { return is_called(sides_[1], of_b, one.second); });
    }

    /// Returns the counterpart of an input or output of the first side among `rest`, the unassigned inputs or outputs
    /// of the second side. If a side is a program, accepts a name that differs only in case, provided that exactly one
    /// such name exists.
    Plugs::iterator counterpart(const Plug& plug, Plugs& rest) const {
        if (const auto name = mapped(plug))
            return std::ranges::find_if(rest, [&](const Plug& one) { return is_called(sides_[1], one, *name); });
        const auto exact =
            std::ranges::find_if(rest, [&](const Plug& one) { return !is_mapped(one) && one.name == plug.name; });
        if (exact != rest.end() || !with_programs()) return exact;
        const auto similar = [&](const Plug& one) { return !is_mapped(one) && same_word(one.name, plug.name); };
        return std::ranges::count_if(rest, similar) == 1 ? std::ranges::find_if(rest, similar) : rest.end();
    }

    std::vector<Comparison::Variable> pairs(Plugs CompareSide::*member, std::string_view kind) {
        const bool input = kind == "input";
        std::vector<Comparison::Variable> common;
        Plugs &of_a = sides_[0].*member, rest = std::move(sides_[1].*member), of_b;
        for (Plug& plug : of_a) {
            const auto twin = counterpart(plug, rest);
            if (twin == rest.end()) {
                report_missing(kind, plug, 0);
                continue;
            }
            if (!comparable(plug, *twin, input)) report_types(kind, plug, *twin);
            if (input && plug.type != twin->type) {
                const Type range = plug.program_type == nullptr ? plug.type : twin->type;
                if (!plug.type.boolean) result_.restricted.push_back(plug.name);
                plug.type = twin->type = range;
            }
            common.push_back(variable_of(plug));
            of_b.push_back(std::move(*twin));
            rest.erase(twin);
        }
        for (const Plug& plug : rest) report_missing(kind, plug, 1);
        sides_[1].*member = std::move(of_b);
        return common;
    }

    void report_missing(std::string_view kind, const Plug& plug, std::size_t k) {
        const CompareSide& owner = sides_[k];
        if (!with_programs() && options_.map.empty()) {
            diagnostics_.add(messages::not_in_both(plug.origin, kind, plug.name, owner.label));
            return;
        }
        const std::string pair = k == 0 ? plug.name + "=NAME" : "NAME=" + plug.name;
        std::string remedy = fmt::format("declare it in both, or pass `--map {}`", pair);
        if (kind == "output") remedy += fmt::format(" or `--ignore {}`", plug.name);
        if (kind == "output" && owner.is_program()) remedy += fmt::format(" or `--stop-output {}`", plug.name);
        diagnostics_.add(messages::not_comparable(
            plug.origin, fmt::format("the {} `{}` exists only in {}", kind, plug.name, owner.label), remedy));
    }

    void report_types(std::string_view kind, const Plug& a, const Plug& b) {
        if (!with_programs()) {
            diagnostics_.add(messages::other_type(a.origin, kind, a.name, type_text(a), type_text(b)));
            return;
        }
        if (is_of_kind(a, Program::Type::Kind::Enumeration) && is_of_kind(b, Program::Type::Kind::Enumeration)) {
            report_values(kind, a, b);
            return;
        }
        const bool only_in_programs = std::ranges::any_of(std::array{&a, &b}, [](const Plug* one) {
            return is_of_kind(*one, Program::Type::Kind::Enumeration) || is_of_kind(*one, Program::Type::Kind::Time);
        });
        const bool with_chart = a.program_type == nullptr || b.program_type == nullptr;
        diagnostics_.add(
            messages::not_comparable(a.origin,
                                     fmt::format("the {} `{}` is {} in {} and {} in {}", kind, a.name, type_text(a),
                                                 sides_[0].label, type_text(b), sides_[1].label),
                                     with_chart && only_in_programs ? "declare it as an integer in the program"
                                                                    : "declare it with the same type in both"));
    }

    /// Reports the first position at which the values of two enumerations differ.
    void report_values(std::string_view kind, const Plug& a, const Plug& b) {
        const std::vector<std::string>&of_a = a.program_type->values, &of_b = b.program_type->values;
        const auto [first, second] = std::ranges::mismatch(of_a, of_b, same_word);
        const std::string one = first == of_a.end() ? "missing" : "`" + *first + "`";
        const std::string other = second == of_b.end() ? "missing" : "`" + *second + "`";
        diagnostics_.add(messages::not_comparable(
            a.origin,
            fmt::format("value {} of the enumeration of the {} `{}` is {} in {} and {} in {}", first - of_a.begin() + 1,
                        kind, a.name, one, sides_[0].label, other, sides_[1].label),
            "declare the same values in the same order in both"));
    }

    /// Renames the inputs and outputs of the second side to the names in the first side. Other variables that already
    /// have one of these names get another name. Each input gets the range that `pairs` has determined for both sides.
    void rename() {
        for (const auto member : {&CompareSide::inputs, &CompareSide::outputs})
            for (std::size_t i = 0; i < (sides_[0].*member).size(); ++i)
                for (CompareSide& side : sides_) {
                    Equations::Variable& variable = side.equations().variables[(side.*member)[i].variable];
                    const std::string name = (sides_[0].*member)[i].name;
                    for (Equations::Variable& other : side.equations().variables)
                        if (&other != &variable && other.name == name) other.name = "other " + other.name;
                    variable.name = name;
                    if (member == &CompareSide::inputs) variable.type = (side.*member)[i].type;
                }
    }

    std::array<CompareSide, 2>& sides_;
    const ProgramCompareOptions& options_;
    Comparison& result_;
    Diagnostics& diagnostics_;
};

}  // namespace

bool match_sides(std::array<CompareSide, 2>& sides, const ProgramCompareOptions& options, Comparison& result,
                 Diagnostics& diagnostics) {
    return Matching(sides, options, result, diagnostics).match();
}

}  // namespace grafverif
