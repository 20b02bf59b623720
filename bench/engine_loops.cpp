// SPDX-License-Identifier: MIT
#include "engine_loops.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "compose/compose.hpp"
#include "derive/derive.hpp"
#include "plant/plant.hpp"
#include "read/text.hpp"

namespace grafverif::bench {

namespace {

const std::filesystem::path root = GRAFVERIF_SOURCE_DIR;

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::invalid_argument("no file " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

struct LibraryFile {
    std::string name = {}, text = {};
};

template <class T>
T required(std::optional<T> value, const Diagnostics& diagnostics, const Sources& sources) {
    if (value) return std::move(*value);
    std::ostringstream text;
    render_text(diagnostics.all(), sources, Colour::Plain, text);
    throw std::invalid_argument(text.str());
}

/// Every variable, process and property of `network` under another name; indices stay.
Network renamed(Network network, const std::string& suffix) {
    for (Network::Variable& variable : network.variables) variable.name += suffix;
    for (Network::Process& process : network.processes) process.name += suffix;
    for (Network::Controller& controller : network.controllers) controller.words.name += suffix;
    for (Property& property : network.properties) property.name += suffix;
    return network;
}

/// Both networks in one, the second one's indices behind the first one's.
Network beside(Network left, const Network& right) {
    const auto variables = static_cast<std::uint32_t>(left.variables.size());
    const auto processes = static_cast<std::uint32_t>(left.processes.size());
    const auto copy = [&](Id<Expr> term) {
        return translate(right.exprs, term, left.exprs, [&](const Expr& leaf) {
            if (leaf.op == Op::At) return left.exprs.at(at_process(leaf) + processes, at_location(leaf));
            return left.exprs.leaf(leaf.op, static_cast<std::uint32_t>(leaf.value) + variables);
        });
    };
    const auto copy_constraints = [&](std::vector<Network::ClockConstraint>& list) {
        for (Network::ClockConstraint& constraint : list) constraint.bound = copy(constraint.bound);
    };
    const auto copy_assignments = [&](std::vector<Network::Assignment>& list) {
        for (auto& [target, value] : list) target = copy(target), value = copy(value);
    };
    for (const Network::Variable& variable : right.variables) left.variables.add(variable);
    for (Network::Process process : right.processes) {
        Network::Template automaton = right.templates[process.automaton];
        automaton.name += "_2";
        for (Network::Location& location : automaton.locations) copy_constraints(location.invariant);
        for (Network::Procedure& procedure : automaton.procedures) copy_assignments(procedure.assignments);
        for (Network::Edge& edge : automaton.edges) {
            edge.guard = copy(edge.guard);
            copy_constraints(edge.constraint);
            copy_assignments(edge.assignments);
        }
        process.automaton = left.templates.add(std::move(automaton));
        left.processes.add(std::move(process));
    }
    for (Property property : right.properties) {
        for (Id<Expr>& operand : property.operands) operand = copy(operand);
        left.properties.add(std::move(property));
    }
    left.settled = left.exprs.conjunction(left.settled, copy(right.settled));
    return left;
}

}  // namespace

std::string sample(const std::string& path) { return content(root / "samples" / path); }

LoopParts parts(const std::string& text) {
    std::vector<LibraryFile> files;
    for (const auto& entry : std::filesystem::directory_iterator(root / "templates"))
        files.push_back({entry.path().stem().string(), content(entry.path())});
    std::vector<LibraryEntry> entries;
    for (const LibraryFile& file : files) entries.push_back({file.name, file.text, file.name});
    Sources sources;
    Diagnostics diagnostics;
    const ReadContext context{[](const std::string&, std::string&) { return std::nullopt; }, entries};
    LoopParts made;
    made.model =
        required(read_text(sources.add({"loop.grafcet", text}), sources, context, diagnostics), diagnostics, sources);
    const ClosedLoop& first = made.model.loops[{0}];
    for (const ClosedLoop::Controller& controller : first.controllers)
        made.equations.push_back(
            required(derive(made.model.charts[controller.chart], diagnostics), diagnostics, sources));
    made.plant = required(plant(made.model, first, diagnostics), diagnostics, sources);
    return made;
}

Network loop(const std::string& text, Grain grain) {
    const LoopParts of = parts(text);
    Diagnostics diagnostics;
    return required(compose(of.plant, of.model.loops[{0}], of.equations, {.grain = grain}, diagnostics), diagnostics,
                    {});
}

Network two_stations(Grain grain) {
    const Network station = expand(loop(sample("testing_station/testing_station.grafcet"), grain));
    return beside(renamed(station, "_a"), renamed(station, "_b"));
}

std::string cylinders(int cylinders) {
    std::ostringstream chart, loop;
    chart << "grafcet motion {\n    input START;\n    initial step 0;\n";
    loop << "closed_loop cell {\n    controller motion with stability_search;\n    environment Start = push_button(OUT "
            "= START);\n";
    std::ostringstream out, wait;
    for (int k = 1; k <= cylinders; ++k) {
        const std::string n = std::to_string(k), step = std::to_string(10 * k);
        chart << "    input IN" << n << ", MID" << n << ", OUT" << n << ";\n    output GO_OUT" << n << ", GO_IN" << n
              << ";\n"
              << "    step " << 10 * k << " { GO_OUT" << n << "; }\n    step " << 10 * k + 1 << " { GO_IN" << n
              << "; }\n    step " << 10 * k + 2 << ";\n"
              << "    transition out" << n << ": " << 10 * k << " -> " << 10 * k + 1 << " when OUT" << n << ";\n"
              << "    transition in" << n << ": " << 10 * k + 1 << " -> " << 10 * k + 2 << " when IN" << n << ";\n";
        out << (k == 1 ? "" : ", ") << step;
        wait << (k == 1 ? "" : ", ") << 10 * k + 2;
        loop << "    plant Act" << n << " = cylinder_5_3(G_IN = GO_IN" << n << ", G_OUT = GO_OUT" << n << ", X = P" << n
             << ", X_max = " << 6 + k << ");\n"
             << "    plant Sen" << n << " = position_sensors_3(X = P" << n << ", IN = IN" << n << ", MID = MID" << n
             << ", OUT = OUT" << n << ", X_IN_max = 1, X_MID_min = 3, X_MID_max = 4, X_OUT_min = " << 6 + k
             << ") initially in;\n";
    }
    chart << "    transition go: 0 -> " << out.str() << " when START;\n    transition back: " << wait.str()
          << " -> 0 when !START;\n}\n\n";
    loop << "    property back: X10 leads to X12;\n    property D: no deadlock;\n    property T: no timelock;\n}\n";
    return chart.str() + loop.str();
}

}  // namespace grafverif::bench
