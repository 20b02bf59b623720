// SPDX-License-Identifier: MIT
#include "read/program/properties.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "syntax/language/readable.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

using Kind = ProgramProperty::Kind;
using Error = ProgramProperty::Error;

struct KindName {
    std::string_view name = {};
    Kind kind = Kind::Invariant;
};
constexpr std::array kinds = {
    KindName{"invariant", Kind::Invariant},     KindName{"mutual_exclusion", Kind::MutualExclusion},
    KindName{"absence", Kind::Absence},         KindName{"reachability", Kind::Reachability},
    KindName{"reachable", Kind::Reachable},     KindName{"assertion", Kind::Assertion},
    KindName{"termination", Kind::Termination},
};

class PropertyReader {
public:
    PropertyReader(Id<Source> source, Sources& sources, ProgramText& program, Diagnostics& diagnostics)
        : source_(source), sources_(sources), program_(program), diagnostics_(diagnostics) {}

    std::vector<ProgramProperty> read(const YAML::Node& root) {
        const YAML::Node list = root.IsMap() ? root["properties"] : YAML::Node(YAML::NodeType::Undefined);
        if (!list.IsDefined() || !list.IsSequence()) {
            reject({source_, 0, 0}, "the file has no list `properties`",
                   "add the list, with an `id` and a `kind` per entry");
            return {};
        }
        for (const YAML::Node& one : list) property(one);
        if (list.size() == 0) reject(where(list), "the list `properties` is empty", "add a property");
        return std::move(properties_);
    }

    void reject(Span where, const std::string& what, const std::string& hint) {
        diagnostics_.add(messages::bad_property(where, what, hint));
    }

    Span where(const YAML::Node& node) const { return where(node.Mark(), node.IsScalar() ? node.Scalar().size() : 1); }
    Span where(const YAML::Mark& mark, std::size_t length) const {
        const std::string& text = sources_[source_].text;
        std::size_t at = 0;
        for (int line = 0; line < mark.line && at < text.size(); ++line) {
            const std::size_t end = text.find('\n', at);
            at = end == std::string::npos ? text.size() : end + 1;
        }
        at = std::min(at + static_cast<std::size_t>(std::max(mark.column, 0)), text.size());
        const std::size_t end = std::min(at + std::max<std::size_t>(length, 1), text.size());
        return {source_, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)};
    }

private:
    void property(const YAML::Node& from) {
        if (!from.IsMap())
            return reject(where(from), "this property is not a map", "write keys with values, such as `id: P1`");
        ProgramProperty made;
        made.origin = where(from);
        std::map<std::string, YAML::Node> entries;
        for (const auto& entry : from) {
            if (!entry.first.IsScalar()) {
                reject(where(entry.first), "a key must be a word, not a list or a map",
                       "write a key such as `id`, `kind` or `expression`");
                continue;
            }
            if (!entries.emplace(entry.first.Scalar(), entry.second).second)
                reject(where(entry.first), "the key `" + entry.first.Scalar() + "` occurs twice", "remove one entry");
        }
        const auto word = [&](const char* key) -> std::optional<std::string> {
            const auto found = entries.find(key);
            if (found == entries.end()) {
                reject(made.origin, "the property has no `" + std::string(key) + "`", "add it");
                return {};
            }
            if (found->second.IsScalar() && !found->second.Scalar().empty()) return found->second.Scalar();
            reject(where(found->second), "`" + std::string(key) + "` is empty or has several values",
                   "write a single value");
            return {};
        };
        const auto name = word("id");
        const auto kind = word("kind");
        if (!name || !kind) return;
        const auto [place, fresh] = names_.try_emplace(*name, made.origin);
        if (!fresh) diagnostics_.add(messages::duplicate_name(made.origin, "property", *name, place->second));
        made.name = *name;
        const auto known = std::ranges::find(kinds, *kind, &KindName::name);
        if (known == kinds.end()) {
            std::vector<std::string> names;
            for (const KindName& each : kinds) names.emplace_back(each.name);
            const std::string nearest = nearest_of(*kind, names);
            return reject(where(entries["kind"]), "`" + *kind + "` is not a kind of property",
                          nearest.empty() ? "use a kind such as `invariant`" : "did you mean `" + nearest + "`?");
        }
        made.kind = known->kind;
        for (const auto& [key, value] : entries) check_key(made.kind, key, value);
        const std::size_t errors = diagnostics_.errors();
        conditions(made, entries);
        if (diagnostics_.errors() == errors) properties_.push_back(std::move(made));
    }

    void check_key(Kind kind, const std::string& key, const YAML::Node& value) {
        static constexpr std::array common = {"id", "kind", "justification", "name", "description"};
        if (std::ranges::find(common, key) != common.end()) return;
        const bool belongs = (key == "variables" && kind == Kind::MutualExclusion) ||
                             (key == "subtype" && kind == Kind::Absence) ||
                             (key == "location" && kind == Kind::Assertion) ||
                             (key == "expression" && kind != Kind::MutualExclusion && kind != Kind::Absence &&
                              kind != Kind::Termination);
        if (!belongs)
            reject(where(value), "the key `" + key + "` is not allowed for this kind of property", "remove it");
    }

    void conditions(ProgramProperty& made, std::map<std::string, YAML::Node>& entries) {
        switch (made.kind) {
        case Kind::MutualExclusion: return exclusion(made, entries["variables"]);
        case Kind::Absence: return absence(made, entries["subtype"]);
        case Kind::Termination: made.text = "every scan ends"; return;
        case Kind::Invariant:
        case Kind::Reachability:
        case Kind::Reachable:
        case Kind::Assertion: break;
        }
        if (entries.contains("location"))
            reject(where(entries["location"]), "an assertion at a `location` in the program is not supported",
                   "omit `location`, and write an `expression` that must be true at the end of each scan");
        const YAML::Node expression = entries["expression"];
        if (!expression.IsDefined() || !expression.IsScalar())
            return reject(made.origin, "the property has no `expression`",
                          "write an expression over the variables of the program");
        made.text = expression.Scalar();
        if (const auto node = condition(expression)) made.conditions.push_back(*node);
    }

    void exclusion(ProgramProperty& made, const YAML::Node& variables) {
        if (!variables.IsDefined() || !variables.IsSequence() || variables.size() < 2)
            return reject(made.origin, "the property has no list of two or more `variables`",
                          "add a list such as `[A, B]`");
        made.text = "at most one of ";
        for (const YAML::Node& one : variables) {
            if (!one.IsScalar()) {
                reject(where(one), "an element of `variables` is not the name of a variable",
                       "write names of variables");
                continue;
            }
            made.text += (made.conditions.empty() ? "" : ", ") + one.Scalar();
            if (const auto node = condition(one)) made.conditions.push_back(*node);
        }
    }

    void absence(ProgramProperty& made, const YAML::Node& subtype) {
        const std::string word = subtype.IsDefined() && subtype.IsScalar() ? subtype.Scalar() : "";
        if (word == "overflow") made.error = Error::Overflow;
        else if (word == "div_zero") made.error = Error::DivisionByZero;
        else if (word == "array_bounds") made.error = Error::ArrayBounds;
        else
            return reject(made.origin, "the property has no valid `subtype`",
                          "use `overflow`, `div_zero` or `array_bounds`");
        made.text = "no " + word;
    }

    /// Reads a condition. If the property file contains the text of the expression literally, the positions in the
    /// condition refer to the property file. Otherwise, the positions refer to a new source with the text of the
    /// expression.
    std::optional<Id<Program::Node>> condition(const YAML::Node& from) {
        const std::string expression = from.Scalar();
        Span place = where(from);
        const std::string& text = sources_[source_].text;
        if (place.begin < text.size() && (text[place.begin] == '"' || text[place.begin] == '\'')) ++place.begin;
        place.end = static_cast<std::uint32_t>(std::min(place.begin + expression.size(), text.size()));
        if (text.compare(place.begin, expression.size(), expression) != 0) {
            const std::string name = sources_[source_].name + " (expression)";
            const Id<Source> own = sources_.add({name, expression});
            place = {own, 0, static_cast<std::uint32_t>(expression.size())};
        }
        if (!is_readable(place, sources_, diagnostics_)) return {};
        return program_.condition({{place, false}}, sources_, diagnostics_);
    }

    Id<Source> source_;
    Sources& sources_;
    ProgramText& program_;
    Diagnostics& diagnostics_;
    std::vector<ProgramProperty> properties_ = {};
    std::map<std::string, Span> names_ = {};
};

}  // namespace

std::optional<std::vector<ProgramProperty>> read_properties(Id<Source> source, Sources& sources, ProgramText& program,
                                                            Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    make_utf8(source, sources, diagnostics);
    const Span whole{source, 0, static_cast<std::uint32_t>(sources[source].text.size())};
    if (!is_readable(whole, sources, diagnostics)) return {};
    PropertyReader reader(source, sources, program, diagnostics);
    std::vector<ProgramProperty> properties;
    try {
        properties = reader.read(YAML::Load(sources[source].text));
    } catch (const YAML::Exception& exception) {
        reader.reject(reader.where(exception.mark, 1), "the file is not valid YAML: " + exception.msg,
                      "correct the file");
    }
    if (diagnostics.errors() != errors) return {};
    return properties;
}

}  // namespace grafverif
