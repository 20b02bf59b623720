// SPDX-License-Identifier: MIT
#include "emit/certificate/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "ir/network_clocks.hpp"
#include "support/overloaded.hpp"

namespace grafverif::certificate {

namespace {

std::string_view operator_of(Op op) {
    switch (op) {
    case Op::Not: return "not";
    case Op::And: return "and";
    case Op::Or: return "or";
    case Op::Conditional: return "if";
    case Op::Negate: return "neg";
    case Op::Equal: return "=";
    case Op::NotEqual: return "!=";
    case Op::Less: return "<";
    case Op::LessEqual: return "<=";
    case Op::Greater: return ">";
    case Op::GreaterEqual: return ">=";
    case Op::Plus: return "+";
    case Op::Minus: return "-";
    case Op::Times: return "*";
    case Op::Divide: return "/";
    case Op::Modulo: return "%";
    case Op::False:
    case Op::True:
    case Op::Integer:
    case Op::Duration:
    case Op::Variable:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At:
    case Op::Rise:
    case Op::Fall: break;
    }
    unreachable();
}

std::string_view word(Pattern pattern) {
    switch (pattern) {
    case Pattern::Always: return "always";
    case Pattern::Never: return "never";
    case Pattern::Reachable: return "reachable";
    case Pattern::ExactlyOneOf: return "exactly-one";
    case Pattern::Inevitable: return "inevitable";
    case Pattern::LeadsTo: return "leads-to";
    case Pattern::NoDeadlock: return "no-deadlock";
    case Pattern::NoTimelock: return "no-timelock";
    case Pattern::AlwaysPossible: return "always-possible";
    case Pattern::ReachableAllSteps:
    case Pattern::Watched:
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::RawLtl: break;
    }
    unreachable();
}

/// Writes a network. A term that is used several times, or whose depth is large, is written once, as a definition `$N`,
/// in the line before its first use.
class Writer {
public:
    explicit Writer(const Network& flat) : network_(flat), uses_(flat.exprs.size()), defined_(flat.exprs.size()) {
        std::vector<std::size_t> nesting(flat.exprs.size());
        for (std::uint32_t i = 0; i < flat.exprs.size(); ++i)
            for (const Id<Expr> operand : flat.exprs.operands(Id<Expr>{i})) {
                ++uses_[operand.index];
                nesting[i] = std::max(nesting[i], nesting[operand.index] % most_nesting + 1);
            }
        for (std::uint32_t i = 0; i < flat.exprs.size(); ++i)
            if (nesting[i] == most_nesting) uses_[i] = 2;
    }

    std::string text(const std::vector<Property>& properties) && {
        write("grafverif-network 1\nname {}\n", word_of(network_.name));
        for (const Network::Variable& variable : network_.variables)
            write("variable {} {} {} {}\n", word_of(variable.name), variable.type.low, variable.type.high,
                  variable.initial);
        if (network_.race.valid()) write("race {}\n", variable_name(network_.race.index));
        const std::vector<ProcessClocks> clocks = analyse_clocks(network_);
        for (const Id<Network::Process> id : network_.processes.ids())
            write_process(network_.processes[id], clocks[id.index]);
        if (network_.settled.valid()) write_line("settled", {network_.settled});
        for (const Property& property : properties)
            write_line(fmt::format("property {}{} {}", word_of(property.name), property.at_stable ? " stable" : "",
                                   word(property.pattern)),
                       property.operands);
        return std::move(out_);
    }

private:
    static constexpr std::size_t most_nesting = 100;

    template <class... Arguments>
    void write(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<Arguments>(arguments)...);
    }

    void write_process(const Network::Process& process, const ProcessClocks& clocks) {
        const Network::Template& automaton = network_.templates[process.automaton];
        write("process {}\n", word_of(process.name));
        for (const Network::Clock& clock : automaton.clocks) write("clock {}\n", word_of(clock.name));
        for (const Id<Network::Location> id : automaton.locations.ids()) {
            write("location {}\n", word_of(automaton.locations[id].name));
            write_constraints("invariant", automaton, automaton.locations[id].invariant);
            for (const Id<Network::Clock> clock : automaton.clocks.ids())
                if (const std::int64_t cap = clocks.cap[id.index][clock.index]; cap > 0)
                    write("cap {} {}\n", word_of(automaton.clocks[clock].name), cap);
        }
        const auto name = [&](Id<Network::Location> id) { return word_of(automaton.locations[id].name); };
        write("initial {}\n", name(process.initial));
        for (const Network::Edge& edge : automaton.edges) {
            write_line(fmt::format("edge {} {}{}", name(edge.from), name(edge.to), edge.urgent ? " urgent" : ""),
                       {edge.guard});
            write_constraints("when", automaton, edge.constraint);
            for (const Id<Network::Clock> clock : edge.resets)
                write("reset {}\n", word_of(automaton.clocks[clock].name));
            write_assignments(edge.assignments);
            for (const Id<Network::Procedure> call : edge.calls)
                write_assignments(automaton.procedures[call].assignments);
            for (const std::uint32_t variable : std::exchange(assigned_scratch_, {}))
                write("set {} {}\n", variable_name(variable), network_.variables[{variable}].initial);
        }
    }

    void write_constraints(std::string_view kind, const Network::Template& automaton,
                           const std::vector<Network::ClockConstraint>& constraints) {
        for (const Network::ClockConstraint& one : constraints)
            write("{} {} {} {}\n", kind, word_of(automaton.clocks[one.clock].name), operator_of(one.relation),
                  bound_value(network_, {}, one.bound));
    }

    void write_assignments(const std::vector<Network::Assignment>& assignments) {
        for (const Network::Assignment& one : assignments) {
            const auto target = static_cast<std::uint32_t>(network_.exprs[one.target].value);
            write_line("set " + variable_name(target), {one.value});
            if (network_.variables[{target}].scratch) assigned_scratch_.insert(target);
        }
    }

    /// Writes a line with terms, after the definitions that the terms need.
    void write_line(std::string_view start, const std::vector<Id<Expr>>& terms) {
        std::string line(start);
        for (const Id<Expr> term : terms) line += ' ' + use(term);
        out_ += line + '\n';
    }

    std::string variable_name(std::uint32_t index) const { return word_of(network_.variables[{index}].name); }

    std::string use(Id<Expr> term) {
        if (is_leaf(network_.exprs[term].op) || is_constant(network_.exprs[term].op) || uses_[term.index] < 2)
            return spelled(term);
        if (!defined_[term.index]) {
            const std::string meaning = spelled(term);
            write("define ${} {}\n", term.index, meaning);
            defined_[term.index] = true;
        }
        return fmt::format("${}", term.index);
    }

    std::string spelled(Id<Expr> term) {
        const Expr& node = network_.exprs[term];
        if (node.op == Op::True || node.op == Op::False) return node.op == Op::True ? "1" : "0";
        if (node.op == Op::Integer) return std::to_string(node.value);
        if (node.op == Op::Variable) return variable_name(static_cast<std::uint32_t>(node.value));
        if (node.op == Op::At) {
            const Network::Process& process = network_.processes[{at_process(node)}];
            const Network::Template& automaton = network_.templates[process.automaton];
            return fmt::format("(at {} {})", word_of(process.name),
                               word_of(automaton.locations[{at_location(node)}].name));
        }
        std::string text = fmt::format("({}", operator_of(node.op));
        for (const Id<Expr> operand : network_.exprs.operands(term)) text += ' ' + use(operand);
        return text + ')';
    }

    const Network& network_;
    std::string out_ = {};
    std::vector<std::size_t> uses_;
    std::vector<bool> defined_;
    std::set<std::uint32_t> assigned_scratch_ = {};  ///< scratch variables that the current edge assigns
};

}  // namespace

std::string checksum(std::string_view text) {
    std::uint64_t sum = 14'695'981'039'346'656'037U;
    for (const char byte : text) {
        sum ^= static_cast<unsigned char>(byte);
        sum *= 1'099'511'628'211U;
    }
    return fmt::format("{:016x}", sum);
}

std::string word_of(std::string_view name) {
    std::string word;
    for (const char c : name) {
        const bool digit = c >= '0' && c <= '9';
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 128;
        const bool plain = letter || (digit && !word.empty()) || c == '_' || c == '.' || c == '[' || c == ']';
        word += plain ? std::string(1, c) : fmt::format("%{:02x}", static_cast<unsigned char>(c));
    }
    return word.empty() ? "%" : word;
}

bool is_too_deep(const Network& flat) {
    std::vector<std::size_t> depth(flat.exprs.size());
    for (std::uint32_t i = 0; i < flat.exprs.size(); ++i)
        for (const Id<Expr> operand : flat.exprs.operands(Id<Expr>{i}))
            depth[i] = std::max(depth[i], depth[operand.index] + 1);
    return std::ranges::any_of(depth, [](std::size_t each) { return each > most_depth; });
}

std::string network_text(const Network& flat, const std::vector<Property>& properties) {
    return Writer(flat).text(properties);
}

void write_state(const Network& flat, const NetworkState& state, std::string& text) {
    const auto add = [&](std::int64_t value) { fmt::format_to(std::back_inserter(text), "{} ", value); };
    for (const Id<Network::Variable> id : flat.variables.ids())
        add(flat.variables[id].scratch ? flat.variables[id].initial : state.variables[id.index]);
    for (std::size_t process = 0; process < state.locations.size(); ++process) {
        add(state.locations[process].index);
        for (const std::int64_t clock : state.clocks[process]) add(clock);
    }
    text += '\n';
}

std::int64_t units_of(const Run& run) {
    std::int64_t units = 0;
    for (const Move& move : run.moves)
        if (const auto* delay = std::get_if<Delay>(&move)) units += delay->units;
    return units;
}

std::string run_text(const Network& flat, const Run& run) {
    std::string text;
    for (std::size_t i = 0; i < run.moves.size(); ++i) {
        if (run.loop == i) text += "loop\n";
        text += std::visit(overloaded{[](const Delay& delay) { return fmt::format("delay {}\n", delay.units); },
                                      [&](const Fire& fire) {
                                          return fmt::format("take {} {}\n", word_of(flat.processes[fire.process].name),
                                                             fire.edge.index);
                                      }},
                           run.moves[i]);
    }
    return text + "end\n";
}

}  // namespace grafverif::certificate
