// SPDX-License-Identifier: MIT
#include "emit/aiger/aiger.hpp"
#include "support/json_text.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/constants.hpp"

namespace grafverif::aiger {

namespace {

using Json = nlohmann::ordered_json;

std::string_view what_it_means(Pattern pattern) {
    return pattern == Pattern::Reachable ? "a run to this state proves that the property holds"
                                         : "a run to this state proves that the property is violated";
}

class Map {
public:
    Map(const TransitionSystem& system, const FlatSystem& flat, const Circuit& circuit, const AigerText& written)
        : system_(system), flat_(flat), circuit_(circuit), written_(written) {}

    Json json() const {
        Json map = {{"version", 1}, {"model", system_.name}, {"scope", system_.scope}};
        if (!system_.constants.empty()) map["constants"] = constants_text(system_.constants);
        map["value"] =
            "base plus the number whose bits are these literals, least significant first; if `sign` is true, the last "
            "bit has a negative weight";
        map["questions"] = questions();
        map["variables"] = Json::array();
        for (const Id<FlatSystem::Variable> id : flat_.variables.ids())
            map["variables"].push_back(named(flat_.variables[id].name, circuit_.words[id.index]));
        map["controllers"] = Json::array();
        for (const TransitionSystem::Controller& controller : system_.controllers)
            map["controllers"].push_back(chart(controller.words));
        map["plant"] = Json::array();
        for (const TransitionSystem::Component& component : system_.components) {
            Json entry = {{"name", component.name}};
            if (component.location.valid()) {
                entry["location"] = word(circuit_.symbols[component.location.index]);
                entry["locations"] = system_.modules[system_.main].symbols[component.location].values;
            }
            entry["variables"] = list(component.variables);
            map["plant"].push_back(std::move(entry));
        }
        return map;
    }

private:
    Json questions() const {
        Json questions = Json::array();
        std::size_t bad = 0, justice = 0;
        for (const Circuit::Target& target : circuit_.targets) {
            const Property& property = system_.properties[target.about];
            const bool runs = !target.justice.empty();
            questions.push_back({{"symbol", (runs ? "j" : "b") + std::to_string(runs ? justice++ : bad++)},
                                 {"property", property.name},
                                 {"text", property.text},
                                 {"meaning", runs ? "a run that satisfies every condition of this justice property "
                                                    "infinitely often proves that the property is violated"
                                                  : what_it_means(property.pattern)}});
        }
        return questions;
    }

    Json word(const Circuit::Word& word) const {
        Json literals = Json::array();
        for (const Gates::Literal bit : word.bits) literals.push_back(written_.literals[node_of(bit)] ^ (bit & 1U));
        return {{"base", word.base}, {"sign", word.with_sign}, {"bits", std::move(literals)}};
    }
    Json named(const std::string& name, const Circuit::Word& value) const {
        Json entry = {{"name", name}};
        entry.update(word(value));
        return entry;
    }
    Json list(const std::vector<TransitionSystem::Named>& names) const {
        Json entries = Json::array();
        for (const TransitionSystem::Named& each : names)
            entries.push_back(named(each.name, circuit_.symbols[each.variable.index]));
        return entries;
    }
    Json chart(const ControllerWords<TransitionSystem::Symbol>& words) const {
        Json steps = Json::array();
        for (const auto& [name, variable] : words.steps)
            steps.push_back(named(name.text(), circuit_.symbols[variable.index]));
        return {{"name", words.name},
                {"steps", std::move(steps)},
                {"inputs", list(words.inputs)},
                {"outputs", list(words.outputs)},
                {"internals", list(words.internals)}};
    }

    const TransitionSystem& system_;
    const FlatSystem& flat_;
    const Circuit& circuit_;
    const AigerText& written_;
};

}  // namespace

std::string map_of(const TransitionSystem& system, const FlatSystem& flat, const Circuit& circuit,
                   const AigerText& written) {
    return json_text(Map(system, flat, circuit, written).json()) + "\n";
}

}  // namespace grafverif::aiger
