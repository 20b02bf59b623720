// SPDX-License-Identifier: MIT
#include "engine_loops.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "compose/compose.hpp"
#include "derive/derive.hpp"
#include "ir/network_terms.hpp"
#include "plant/plant.hpp"
#include "read/text.hpp"

namespace grafverif::bench {

namespace {

const std::filesystem::path root = GRAFVERIF_SOURCE_DIR;

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::invalid_argument("cannot read " + path.string());
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

/// Appends `suffix` to the names of all variables, processes and properties of `network`; indices are unchanged.
Network renamed(Network network, const std::string& suffix) {
    for (Network::Variable& variable : network.variables) variable.name += suffix;
    for (Network::Process& process : network.processes) process.name += suffix;
    for (Network::Controller& controller : network.controllers) controller.words.name += suffix;
    for (Property& property : network.properties) property.name += suffix;
    return network;
}

/// Returns the union of `left` and `right`. The indices of `right` follow those of `left`.
Network beside(Network left, const Network& right) {
    const auto variables = static_cast<std::uint32_t>(left.variables.size());
    const auto processes = static_cast<std::uint32_t>(left.processes.size());
    const auto copy = [&](Id<Expr> term) {
        return translate(right.exprs, term, left.exprs, [&](const Expr& leaf) {
            if (leaf.op == Op::At) return left.exprs.at(at_process(leaf) + processes, at_location(leaf));
            return left.exprs.leaf(leaf.op, static_cast<std::uint32_t>(leaf.value) + variables);
        });
    };
    for (const Network::Variable& variable : right.variables) left.variables.add(variable);
    for (Network::Process process : right.processes) {
        Network::Template automaton = right.templates[process.automaton];
        automaton.name += "_2";
        replace_terms(automaton, copy);
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

/// Numbers the names declared in a model text, so that several copies of the text can form one
/// loop.
class Numbered {
public:
    explicit Numbered(const std::string& text) {
        // Matches declared names: after `grafcet`, `plant`, `environment`, `property`, in lists of inputs and outputs,
        // and names bound to ports (the word after `=`, unless it is a component).
        static const std::regex declared("(?:grafcet|plant|environment|property) (\\w+)|[(,]\\s*\\w+ = ([A-Z]\\w*)");
        for (std::sregex_iterator found(text.begin(), text.end(), declared), end; found != end; ++found)
            names_.insert((*found)[1].matched ? (*found)[1].str() : (*found)[2].str());
        static const std::regex lists("(?:input|output) ([^;]+);"), word("\\w+");
        for (std::sregex_iterator list(text.begin(), text.end(), lists), end; list != end; ++list) {
            const std::string of = (*list)[1];
            for (std::sregex_iterator name(of.begin(), of.end(), word); name != end; ++name) names_.insert(name->str());
        }
        for (const std::string& name : names_)
            if (text.find("grafcet " + name + " {") != std::string::npos) chart_ = name;
    }

    /// Returns `text` with `_` and the number `k` appended to each declared name. In properties,
    /// step names are prefixed with the numbered chart name.
    std::string with(int k, const std::string& text) const {
        static const std::regex word("[A-Za-z_]\\w*");
        const std::string number = "_" + std::to_string(k);
        const bool of_property = text.find("property") != std::string::npos || text.starts_with("        ");
        std::string made, last;
        auto from = text.begin();
        for (std::sregex_iterator found(text.begin(), text.end(), word), end; found != end; ++found) {
            const std::string name = found->str();
            made.append(from, text.begin() + found->position());
            from = text.begin() + found->position() + found->length();
            const bool port = found->suffix().str().starts_with(" = ") && last != "plant" && last != "environment";
            last = name;
            const bool step = name.size() > 1 && name[0] == 'X' && std::isdigit(static_cast<unsigned char>(name[1]));
            if (step && of_property) made += chart_ + number + ".";
            made += name;
            if (names_.contains(name) && !port) made += number;
        }
        return made.append(from, text.end());
    }

private:
    std::set<std::string> names_ = {};
    std::string chart_ = {};
};

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

std::string stations(int count) {
    const std::string text = sample("testing_station/testing_station.grafcet");
    const std::size_t loop_begin = text.find("closed_loop");
    const Numbered names(text);
    std::string charts, loop = "closed_loop stations {\n";
    for (int k = 1; k <= count; ++k) {
        const std::string chart = text.substr(text.find("grafcet "), loop_begin - text.find("grafcet "));
        charts += names.with(k, chart);
        std::istringstream lines(text.substr(loop_begin));
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line) && line != "}")
            if (line.find("no_") == std::string::npos) loop += names.with(k, line) + '\n';
    }
    return charts + loop + "    property no_deadlock: no deadlock;\n    property no_timelock: no timelock;\n}\n";
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
