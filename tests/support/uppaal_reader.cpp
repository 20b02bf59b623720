// SPDX-License-Identifier: MIT
#include "support/uppaal_reader.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <unordered_map>

#include "emit/uppaal/uppaal.hpp"
#include "support/print_network.hpp"
#include "support/uppaal_queries_reader.hpp"
#include "support/uppaal_terms.hpp"

namespace grafverif::test {
namespace {

using Kind = Network::ParameterKind;
using Role = Network::Role;
using Template = Network::Template;

const std::map<std::string, Role> roles = {
    {"inputs of the controller", Role::Input},       {"outputs of the controller", Role::Output},
    {"internal variables", Role::Internal},          {"step activities", Role::Step},
    {"firing conditions", Role::FiringCondition},    {"inputs as sampled in this cycle", Role::Sample},
    {"outputs not yet written", Role::Image},        {"outputs of timers", Role::TimerEnd},
    {"timers to start or stop", Role::TimerPending}, {"previous values, for edges", Role::Previous},
    {"levels that timers observe", Role::Watched},   {"flags between controller, timers and plant", Role::Flag},
    {"variables of the plant", Role::Plant}};

const std::map<std::string, Network::ProcessKind> kinds = {{"plant", Network::ProcessKind::Plant},
                                                           {"environment", Network::ProcessKind::Environment},
                                                           {"controller", Network::ProcessKind::Controller},
                                                           {"timers", Network::ProcessKind::Timer},
                                                           {"observers of properties", Network::ProcessKind::Observer}};

/// Returns the text between the first `before` and the next `after`.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const std::size_t begin = text.find(before);
    if (begin == std::string::npos) throw std::runtime_error("no `" + before + "` in: " + text);
    const std::size_t end = after.empty() ? text.size() : text.find(after, begin + before.size());
    return text.substr(begin + before.size(), end - begin - before.size());
}

template <class T>
Id<T> find(const std::unordered_map<std::string, Id<T>>& map, const std::string& name) {
    const auto found = map.find(name);
    if (found == map.end()) throw std::runtime_error("unknown name `" + name + "`");
    return found->second;
}

/// A line in the header of the project, which names the process and the variables of a controller.
struct ControllerLine {
    std::string name = {}, process = {}, waiting = {}, stable = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
};

class Reader {
public:
    explicit Reader(const std::string& xml) {
        const pugi::xml_parse_result result = document_.load_string(xml.c_str());
        if (!result) throw std::runtime_error(std::string("not well-formed: ") + result.description());
    }

    Network read() {
        const pugi::xml_node nta = document_.child("nta");
        read_declarations(nta.child_value("declaration"));
        for (const pugi::xml_node node : nta.children("template")) read_template(node);
        read_system(nta.child_value("system"));
        for (const ControllerLine& line : controllers_) add_controller(line);
        QueryReader(network_, terms(nullptr)).read(nta.child("queries"));
        return std::move(network_);
    }

private:
    void read_declarations(const std::string& text) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line) && !line.empty();) read_header_line(line);
        const std::string rest(std::istreambuf_iterator<char>(lines), {});
        Cursor cursor(rest);
        Role role = Role::Plant;
        while (!cursor.at_end()) {
            if (cursor.peek().kind == Token::Kind::Comment) {
                const auto found = roles.find(cursor.take().text);
                if (found != roles.end()) role = found->second;
                continue;
            }
            if (cursor.accept("urgent")) {
                for (const char* word : {"broadcast", "chan"}) cursor.expect(word);
                channel_ = cursor.name();
                cursor.expect(";");
                continue;
            }
            read_variable(cursor, role);
        }
    }

    void read_header_line(const std::string& line) {
        if (line.find(" is renamed to ") != std::string::npos) {
            original_[between(line, " is renamed to ", "")].push_back(between(line, "//   ", " is renamed to "));
        } else if (line.starts_with("// Grain: ")) {
            network_.grain = line.starts_with("// Grain: atomic") ? Grain::Atomic : Grain::Phased;
        } else if (line.starts_with("// Time unit: ")) {
            const std::string unit = between(line, "unit: ", ".");
            network_.time_unit_ms = std::stoll(unit) * (unit.ends_with("ms") ? 1 : 1000);
        } else if (line.starts_with("// Controller ")) {
            const ExecutionMode mode = line.find(" with stability search (") != std::string::npos
                                           ? ExecutionMode::StabilitySearch
                                           : ExecutionMode::EveryCycle;
            controllers_.push_back({.name = between(line, "// Controller ", " with"), .mode = mode});
        } else if (line.starts_with("//   process ")) {
            ControllerLine& last = controllers_.back();
            last.process = between(line, "process ", ",");
            last.waiting = between(line, "cycles in ", ";");
            last.stable = between(line, "situation: ", "");
        } else if (network_.name.empty()) {
            network_.name = between(line, "// ", ": the closed loop");
        }
    }

    /// Returns the original of the name `legal` in the scope of the template called `scope`, or in the global scope if
    /// `scope` is empty.
    std::string original(const std::string& legal, const std::string& scope = {}) const {
        const auto found = original_.find(legal);
        if (found == original_.end()) return legal;
        for (const std::string& name : found->second) {
            const bool local = !scope.empty() && name.starts_with(scope + ".");
            if (local) return name.substr(scope.size() + 1);
            // The firing condition of a transition of a chart instance has a dot in its name.
            const bool global = name.find('.') == std::string::npos || name.starts_with("CF_");
            if (scope.empty() && global) return name;
        }
        return legal;
    }

    static Type read_type(Cursor& cursor, const Type& plain_integer) {
        if (cursor.accept("bool")) return {};
        cursor.expect("int");
        if (!cursor.accept("[")) return plain_integer;
        const std::int64_t low = cursor.number();
        cursor.expect(",");
        const std::int64_t high = cursor.number();
        cursor.expect("]");
        return integer_type(low, high);
    }

    static std::int64_t read_value(Cursor& cursor) {
        if (cursor.accept("true")) return 1;
        return cursor.accept("false") ? 0 : cursor.number();
    }

    void read_variable(Cursor& cursor, Role role) {
        Network::Variable variable{.role = role};
        variable.scratch = cursor.accept("meta");
        variable.type = read_type(cursor, {});
        const std::string name = cursor.name();
        variable.name = original(name);
        if (cursor.accept("=")) variable.initial = read_value(cursor);
        cursor.expect(";");
        variables_.emplace(name, network_.variables.add(std::move(variable)));
    }

    // -- templates ------------------------------------------------------------------------------------------------

    /// Maps the names in the current template to their meanings.
    struct Scope {
        std::string name = {};
        std::unordered_map<std::string, Id<Network::Parameter>> parameters = {};
        std::unordered_map<std::string, Id<Network::Clock>> clocks = {};
        std::unordered_map<std::string, Id<Network::Location>> locations = {};  // locations by XML id
        std::unordered_map<std::string, Id<Network::Procedure>> procedures = {};
        std::unordered_map<std::string, Id<Expr>> guards = {};
    };

    TermReader terms(const Scope* scope) {
        return {network_.exprs,
                [this, scope](const std::string& name) {
                    const auto local = scope ? scope->parameters.find(name) : decltype(scope->parameters.end()){};
                    if (scope && local != scope->parameters.end())
                        return network_.exprs.leaf(Op::Parameter, local->second.index);
                    return network_.exprs.leaf(Op::Variable, find(variables_, name).index);
                },
                [this](const std::string& process, const std::string& location) { return at(process, location); },
                [scope](const std::string& name) { return scope->guards.at(name); }};
    }

    Id<Expr> at(const std::string& process, const std::string& location) {
        const Id<Network::Process> id = find(processes_, process);
        const Id<Network::Location> there = find(location_names_[network_.processes[id].automaton.index], location);
        return network_.exprs.at(id.index, there.index);
    }

    void read_template(const pugi::xml_node node) {
        Template automaton;
        Scope scope;
        scope.name = automaton.name = original(node.child_value("name"));
        read_parameters(node.child_value("parameter"), automaton, scope);
        auto& names = location_names_.emplace_back();
        for (const pugi::xml_node location : node.children("location")) {
            const Id<Network::Location> id =
                automaton.locations.add({original(location.child_value("name"), scope.name), {}, {}});
            scope.locations.emplace(location.attribute("id").value(), id);
            names.emplace(location.child_value("name"), id);
        }
        read_template_declarations(node.child_value("declaration"), automaton, scope);
        for (const pugi::xml_node location : node.children("location")) {
            const pugi::xml_node label = location.child("label");
            if (label)
                read_guard(label.child_value(), scope,
                           automaton.locations[find(scope.locations, location.attribute("id").value())].invariant);
        }
        automaton.initial = find(scope.locations, node.child("init").attribute("ref").value());
        for (const pugi::xml_node transition : node.children("transition")) read_edge(transition, automaton, scope);
        templates_.emplace(node.child_value("name"), network_.templates.add(std::move(automaton)));
    }

    void read_parameters(const std::string& text, Template& automaton, Scope& scope) {
        Cursor cursor(text);
        while (!cursor.at_end()) {
            Network::Parameter parameter;
            const bool constant = cursor.accept("const");
            parameter.type = read_type(cursor, integer_type(least_integer, greatest_integer));
            parameter.kind = constant ? Kind::Constant : Kind::Read;
            if (!constant) cursor.expect("&");
            const std::string name = cursor.name();
            parameter.name = original(name, scope.name);
            scope.parameters.emplace(name, automaton.parameters.add(std::move(parameter)));
            if (!cursor.at_end()) cursor.expect(",");
        }
    }

    void read_template_declarations(const std::string& text, Template& automaton, Scope& scope) {
        if (const std::size_t writes = text.find("writes "); text.starts_with("//") && writes < text.find('\n')) {
            Cursor names(text.substr(writes + 7, text.find('\n') - writes - 7));
            do automaton.parameters[find(scope.parameters, names.name())].kind = Kind::Written;
            while (names.accept(","));
        }
        Cursor cursor(text);
        while (!cursor.at_end()) {
            if (cursor.peek().kind == Token::Kind::Comment) {
                cursor.take();
            } else if (cursor.accept("clock")) {
                const std::string name = cursor.name();
                scope.clocks.emplace(name, automaton.clocks.add({original(name, scope.name)}));
                cursor.expect(";");
            } else if (cursor.accept("bool")) {
                read_guard_function(cursor, scope);
            } else {
                read_procedure(cursor, automaton, scope);
            }
        }
    }

    void read_guard_function(Cursor& cursor, Scope& scope) {
        const std::string name = cursor.name();
        for (const char* word : {"(", ")", "{", "return"}) cursor.expect(word);
        const Id<Expr> body = terms(&scope).term(cursor);
        scope.guards.emplace(name, body);
        for (const char* word : {";", "}"}) cursor.expect(word);
    }

    void read_procedure(Cursor& cursor, Template& automaton, Scope& scope) {
        cursor.expect("void");
        const std::string name = cursor.name();
        Network::Procedure procedure{.name = original(name, scope.name)};
        for (const char* word : {"(", ")", "{"}) cursor.expect(word);
        while (!cursor.accept("}")) {
            if (cursor.peek().kind == Token::Kind::Comment) cursor.take();
            else procedure.assignments.push_back(read_statement(cursor, scope));
        }
        scope.procedures.emplace(name, automaton.procedures.add(std::move(procedure)));
    }

    /// Reads `x = e;`, or a chain of `if (c) x = e; else ...`, in which a missing last branch keeps the value.
    Network::Assignment read_statement(Cursor& cursor, const Scope& scope) {
        std::vector<std::pair<Id<Expr>, Id<Expr>>> branches;  // pairs of a condition and a value
        Network::Assignment assignment;
        for (bool more = true; more;) {
            Id<Expr> condition;
            if (cursor.accept("if")) condition = terms(&scope).primary(cursor);
            assignment.target = terms(&scope).primary(cursor);
            cursor.expect("=");
            const Id<Expr> value = terms(&scope).term(cursor);
            cursor.expect(";");
            assignment.value = condition.valid() ? assignment.target : value;
            if (condition.valid()) branches.emplace_back(condition, value);
            more = condition.valid() && cursor.accept("else");
        }
        for (auto branch = branches.rbegin(); branch != branches.rend(); ++branch)
            assignment.value = network_.exprs.conditional(branch->first, branch->second, assignment.value);
        return assignment;
    }

    /// Separates the conditions on data and on clocks of a guard or invariant; returns the condition on data.
    Id<Expr> read_guard(const std::string& text, const Scope& scope,
                        std::vector<Network::ClockConstraint>& constraints) {
        Cursor cursor(text);
        const TermReader reader = terms(&scope);
        const std::size_t start = cursor.mark();
        if (!mentions_clock(text, scope)) return reader.term(cursor);
        cursor.back_to(start);
        std::vector<Id<Expr>> data;
        do {
            const auto clock = scope.clocks.find(cursor.peek().text);
            if (clock == scope.clocks.end()) {
                data.push_back(reader.conjunct(cursor));
                continue;
            }
            cursor.take();
            const std::string relation = cursor.take().text;
            constraints.push_back({clock->second,
                                   relation == "<"    ? Op::Less
                                   : relation == "<=" ? Op::LessEqual
                                   : relation == "==" ? Op::Equal
                                   : relation == ">=" ? Op::GreaterEqual
                                                      : Op::Greater,
                                   reader.sum(cursor)});
        } while (cursor.accept("&&"));
        if (!cursor.at_end()) throw std::runtime_error("unexpected text at the end of `" + text + "`");
        return network_.exprs.conjunction(data);
    }

    static bool mentions_clock(const std::string& text, const Scope& scope) {
        return std::ranges::any_of(tokens(text), [&](const Token& token) { return scope.clocks.contains(token.text); });
    }

    void read_edge(const pugi::xml_node node, Template& automaton, const Scope& scope) {
        Network::Edge edge;
        edge.from = find(scope.locations, node.child("source").attribute("ref").value());
        edge.to = find(scope.locations, node.child("target").attribute("ref").value());
        edge.guard = network_.exprs.constant(true);
        for (const pugi::xml_node label : node.children("label")) {
            const std::string kind = label.attribute("kind").value(), text = label.child_value();
            if (kind == "guard") edge.guard = read_guard(text, scope, edge.constraint);
            else if (kind == "assignment") read_updates(text, scope, edge);
            else if (kind == "synchronisation" && text == channel_ + '!') edge.urgent = true;
            else throw std::runtime_error("a label of kind " + kind + ": " + text);
        }
        automaton.edges.add(std::move(edge));
    }

    void read_updates(const std::string& text, const Scope& scope, Network::Edge& edge) {
        Cursor cursor(text);
        do {
            const std::string word = cursor.peek().text;
            if (scope.procedures.contains(word) && cursor.peek(1).text == "(") {
                for (const std::string& token : {word, std::string("("), std::string(")")}) cursor.expect(token);
                edge.calls.push_back(find(scope.procedures, word));
            } else if (scope.clocks.contains(word)) {
                for (const std::string& token : {word, std::string("="), std::string("0")}) cursor.expect(token);
                edge.resets.push_back(find(scope.clocks, word));
            } else {
                const Id<Expr> target = terms(&scope).primary(cursor);
                cursor.expect("=");
                edge.assignments.push_back({target, terms(&scope).term(cursor)});
            }
        } while (cursor.accept(","));
        if (!cursor.at_end()) throw std::runtime_error("unexpected text at the end of `" + text + "`");
    }

    // -- the system -----------------------------------------------------------------------------------------------

    void read_system(const std::string& text) {
        Cursor cursor(text);
        Network::ProcessKind kind = Network::ProcessKind::Plant;
        std::string owner;
        while (!cursor.accept("system")) {
            if (cursor.peek().kind == Token::Kind::Comment) {
                const std::string heading = cursor.take().text;
                if (heading.find(" = ") != std::string::npos) continue;  // durations of the preceding process
                const std::size_t of = heading.find(" of ");
                owner = of == std::string::npos ? "" : heading.substr(of + 4);
                kind = kinds.at(heading.substr(0, of));
                continue;
            }
            const Id<Network::Process> id = read_process(cursor, kind);
            if (kind == Network::ProcessKind::Timer) timers_[owner].push_back(id);
        }
        for (const Id<Network::Process> id : network_.processes.ids()) {
            if (find(processes_, cursor.name()) != id)
                throw std::runtime_error("the system lists its processes in another order");
            cursor.expect(id.index + 1 == network_.processes.size() ? ";" : ",");
        }
    }

    Id<Network::Process> read_process(Cursor& cursor, Network::ProcessKind kind) {
        Network::Process process{.kind = kind};
        const std::string name = cursor.name();
        process.name = original(name);
        cursor.expect("=");
        process.automaton = find(templates_, cursor.name());
        process.initial = network_.templates[process.automaton].initial;
        cursor.expect("(");
        for (const Network::Parameter& parameter : network_.templates[process.automaton].parameters) {
            if (!process.arguments.empty()) cursor.expect(",");
            if (parameter.kind == Kind::Constant) process.arguments.emplace_back(read_value(cursor));
            else process.arguments.emplace_back(find(variables_, cursor.name()));
        }
        for (const char* word : {")", ";"}) cursor.expect(word);
        const Id<Network::Process> id = network_.processes.add(std::move(process));
        processes_.emplace(name, id);
        return id;
    }

    void add_controller(const ControllerLine& line) {
        const Id<Network::Process> process = find(processes_, line.process);
        const Id<Network::Location> waiting =
            find(location_names_[network_.processes[process].automaton.index], line.waiting);
        Network::Controller controller{
            {.name = line.name, .mode = line.mode}, process, waiting, find(variables_, line.stable)};
        for (const Id<Network::Process> timer : timers_[controllers_.size() > 1 ? line.name : ""])
            controller.timers.push_back({timer});
        network_.controllers.add(std::move(controller));
    }

    pugi::xml_document document_ = {};
    Network network_ = {};
    std::string channel_ = {};
    std::vector<ControllerLine> controllers_ = {};
    std::unordered_map<std::string, std::vector<std::string>> original_ = {};
    std::unordered_map<std::string, Id<Network::Variable>> variables_ = {};
    std::unordered_map<std::string, Id<Template>> templates_ = {};
    std::unordered_map<std::string, Id<Network::Process>> processes_ = {};
    std::vector<std::unordered_map<std::string, Id<Network::Location>>> location_names_ = {};
    std::unordered_map<std::string, std::vector<Id<Network::Process>>> timers_ = {};
};

}  // namespace

Network read_uppaal(const std::string& xml) { return Reader(xml).read(); }

Network as_read_back(Network network) {
    const std::vector<uppaal::Inexpressible> left_out = uppaal::inexpressible(network);
    Table<Property> queries;
    bool queries_settled = false;
    for (const Id<Property> id : network.properties.ids()) {
        if (std::ranges::any_of(left_out, [&](const uppaal::Inexpressible& other) { return other.property == id; }))
            continue;
        const Property& property = network.properties[id];
        queries_settled = queries_settled || (property.at_stable && property.pattern != Pattern::RawUppaal);
        queries.add(property);
    }
    network.properties = std::move(queries);
    if (!queries_settled) network.settled = {};
    return network;
}

std::string comparable_text(const Network& network) {
    std::istringstream lines(network_text(network));
    std::vector<std::string> variables;
    std::string head, rest;
    for (std::string line; std::getline(lines, line);) {
        const bool in_head = rest.empty() && !line.starts_with("template ");
        if (in_head && line.find(": ") != std::string::npos) variables.push_back(line);
        else (in_head ? head : rest) += line + '\n';
    }
    std::ranges::sort(variables);
    for (const std::string& line : variables) head += line + '\n';
    return head + rest;
}

}  // namespace grafverif::test
