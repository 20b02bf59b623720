// SPDX-License-Identifier: MIT
#include "check/inputs/plc_cycle.hpp"

#include <optional>
#include <utility>

namespace grafverif {

namespace {

constexpr std::size_t most_edges_of_plc = 64;  // maximum total number of edges of all paths through the automaton of
                                               // the PLC
constexpr std::size_t most_gates_of_plc = 1U << 20U;  // maximum number of gates of the circuit

}  // namespace

bool PlcCycle::build() {
    Values values;
    for (const VariableId variable : slots_.used()) {
        if (variable == network_.race) values[variable] = {Gate::constant(false)};  // a race ends the run
        else values[variable] = now(variable);
    }
    if (!follow(waiting_, {Gate::constant(true), values})) return false;
    enabled = join(next);
    for (const VariableId variable : slots_.written())
        if (!shared_.contains(variable)) values[variable] = bits_of(initial(variable), variable);
    paths_.clear();
    taken_ = 0;
    if (slots_.process.initial == waiting_) paths_.push_back({Gate::constant(true), std::move(values)});
    else if (!follow(slots_.process.initial, {Gate::constant(true), values})) return false;
    starts = join(first);
    error = error_.literal;
    return true;
}

std::vector<Gate> PlcCycle::now(VariableId variable) {
    std::vector<Gate> bits;
    for (std::size_t place = 0; place < bit_count(type_of(variable)); ++place) {
        const Literal literal = circuit.gates.source();
        before[variable].push_back(literal);
        bits.push_back({&circuit.gates, literal});
    }
    before.try_emplace(variable);
    return bits;
}
BitTerm<Gate> PlcCycle::initial(VariableId variable) const {
    const std::int64_t value = network_.variables[variable].initial;
    return type_of(variable).boolean ? boolean_term(Gate::constant(value != 0)) : integer_term<Gate>(value);
}
BitTerm<Gate> PlcCycle::term_of(const std::vector<Gate>& value, VariableId variable) const {
    const Type type = type_of(variable);
    if (type.boolean) return boolean_term(value.front());
    bits::Integer<Gate> number(value.begin(), value.end());
    number.emplace_back();
    return {false, bits::sum(number, bits::constant<Gate>(type.low)), {}};
}
/// Returns the bits of a value. A value outside the range of the variable is a model error; its bits are those of an
/// arbitrary other value.
std::vector<Gate> PlcCycle::bits_of(const BitTerm<Gate>& term, VariableId variable) const {
    const Type type = type_of(variable);
    if (type.boolean) return {term.bits.front()};
    bits::Integer<Gate> number = bits::difference(term.bits, bits::constant<Gate>(type.low));
    number.resize(bit_count(type), number.back());
    return number;
}

/// Adds the paths from `location` to the waiting location W. Returns false if the paths have too many edges in total.
bool PlcCycle::follow(Id<Network::Location> location, const Path& start) {
    for (const Network::Edge& edge : slots_.automaton.edges) {
        if (edge.from != location) continue;
        Path path = start;
        if (taken_++ == most_edges_of_plc || !take(edge, path)) return false;
        if (path.condition.is_false()) continue;
        if (network_.race.valid() && path.values.contains(network_.race))
            error_ = error_ | (path.condition & path.values.at(network_.race).front());
        if (edge.to == waiting_) paths_.push_back(std::move(path));
        else if (!follow(edge.to, path)) return false;
    }
    return true;
}

bool PlcCycle::take(const Network::Edge& edge, Path& path) {
    std::set<VariableId> read;  // variables that already translated terms read
    std::set<VariableId> shared;
    const auto leaf = [&](const Expr& node) {
        const VariableId variable = slots_.variable(node);
        read.insert(variable);
        if (shared_.contains(variable)) shared.insert(variable);
        return term_of(path.values.at(variable), variable);
    };
    std::optional<BitTerms<Gate>> terms(std::in_place, network_.exprs, leaf);
    const BitTerm<Gate> guard = (*terms)(edge.guard);
    error_ = error_ | (path.condition & guard.undefined);
    path.condition = path.condition & guard.bits.front();
    for (const Network::Assignment& assignment : slots_.assignments(edge)) {
        const VariableId target = slots_.variable(network_.exprs[assignment.target]);
        const BitTerm<Gate> value = (*terms)(assignment.value);
        error_ = error_ | (path.condition & ~within(value, type_of(target).low, type_of(target).high));
        path.values[target] = bits_of(value, target);
        if (circuit.gates.size() > most_gates_of_plc) return false;
        if (read.erase(target) == 0) continue;
        terms.emplace(network_.exprs, leaf);
        read.clear();
    }
    for (const VariableId variable : shared)
        if (!path.read.insert(variable).second) return false;
    return true;
}

/// Joins the results of all paths into one function. Free inputs of the circuit (sources), one per path, select a path.
/// Returns the condition that the selected path is possible.
PlcCycle::Literal PlcCycle::join(std::map<VariableId, Bits>& results) {
    Gate possible = Gate::constant(false);
    Values values;
    for (Path& path : paths_) {
        const Gate taken = path.condition & Gate{&circuit.gates, circuit.gates.source()};
        for (auto& [variable, value] : path.values) {
            std::vector<Gate>& joined = values.try_emplace(variable, value).first->second;
            for (std::size_t place = 0; place < value.size(); ++place)
                joined[place] = ite(taken, value[place], joined[place]);
        }
        possible = possible | taken;
    }
    for (const VariableId variable : slots_.written())
        if (!network_.variables[variable].scratch)
            for (const Gate& bit : values[variable]) results[variable].push_back(bit.literal);
    return possible.literal;
}

}  // namespace grafverif
