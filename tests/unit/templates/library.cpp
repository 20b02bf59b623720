// SPDX-License-Identifier: MIT
#include "library.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "plant/plant.hpp"
#include "read/text.hpp"

namespace grafverif {

namespace {

const std::filesystem::path folder = std::filesystem::path(GRAFVERIF_SOURCE_DIR) / "templates";

}  // namespace

std::vector<std::string> library_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".grafcet") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

Component library_component(const std::string& name) {
    std::ifstream file(folder / (name + ".grafcet"), std::ios::binary);
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> source = sources.add({name + ".grafcet", {std::istreambuf_iterator<char>(file), {}}});
    const auto model = read_text(source, sources, {}, diagnostics);
    if (!model) throw std::invalid_argument(diagnostics.all().front().message);
    return *model->components.begin();
}

Network component_in_seconds(const std::string& name, const std::map<std::string, std::int64_t>& constants) {
    Model model;
    ClosedLoop loop;
    loop.name = "in_seconds";
    loop.time_unit_ms = 1000;
    const Component component = library_component(name);
    ClosedLoop::Instance instance{
        .name = "it", .component = model.components.add(component), .initial = component.initial};
    for (const Component::Parameter& parameter : component.parameters) {
        const auto given = constants.find(parameter.name);
        if (parameter.kind != Component::ParameterKind::Constant)
            instance.arguments.push_back(loop.shared.add({.name = parameter.name}));
        else if (given != constants.end()) instance.arguments.push_back(given->second);
        else instance.arguments.push_back(component.exprs[parameter.initial.value()].value);
    }
    loop.instances.add(std::move(instance));
    Diagnostics diagnostics;
    return plant(model, loop, diagnostics).value();
}

Bench bench(const std::string& name, const std::map<std::string, std::int64_t>& constants,
            const std::string& initially) {
    return Bench(lone_component(library_component(name), constants, initially));
}

std::int64_t only(const Bench& bench, const std::string& variable) {
    const std::set<std::int64_t> values = bench.values(variable);
    EXPECT_EQ(values.size(), 1U) << variable;
    return values.empty() ? -1 : *values.begin();
}

std::string place_of(const Bench& bench) {
    const std::set<std::string> places = bench.locations("it");
    EXPECT_EQ(places.size(), 1U);
    return places.empty() ? std::string() : *places.begin();
}

}  // namespace grafverif
