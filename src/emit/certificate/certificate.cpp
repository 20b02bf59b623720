// SPDX-License-Identifier: MIT
#include "emit/certificate/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "ir/junction.hpp"
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
        write("grafverif-network 2\nname {}\n", word_of(network_.name));
        // A race is a model error: it assigns the flag a value outside its range.
        for (const Id<Network::Variable> id : network_.variables.ids()) {
            const Network::Variable& variable = network_.variables[id];
            write("variable {} {} {} {}\n", word_of(variable.name), variable.type.low,
                  id == network_.race ? variable.initial : variable.type.high, variable.initial);
        }
        for (const Network::Process& process : network_.processes) write_process(process);
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

    void write_process(const Network::Process& process) {
        const Network::Template& automaton = network_.templates[process.automaton];
        write("process {} {} {}\n", word_of(process.name), automaton.locations.size(), process.initial.index);
        for (const Network::Clock& clock : automaton.clocks) write("clock {}\n", word_of(clock.name));
        for (const Id<Network::Location> id : automaton.locations.ids()) {
            write("name location {} {}\n", id.index, word_of(automaton.locations[id].name));
            write_constraints(fmt::format("invariant {}", id.index), automaton, automaton.locations[id].invariant);
        }
        for (const Network::Edge& edge : automaton.edges) {
            write_line(fmt::format("edge {} {}{}", edge.from.index, edge.to.index, edge.urgent ? " urgent" : ""),
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
            if (network_.race == Id<Network::Variable>{target}) {
                for (const Id<Expr> reason : operands_of(network_.exprs, one.value, Op::Or))
                    if (reason != one.target) write_line("set " + variable_name(target), {reason});
                continue;
            }
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
            return fmt::format("(= @{} {})", word_of(process.name), at_location(node));
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
    return std::to_string(sum);
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

std::string obstacle(const Network& flat) {
    std::vector<std::size_t> depth(flat.exprs.size());
    for (std::uint32_t i = 0; i < flat.exprs.size(); ++i) {
        for (const Id<Expr> operand : flat.exprs.operands(Id<Expr>{i}))
            depth[i] = std::max(depth[i], depth[operand.index] + 1);
        const Expr& node = flat.exprs[Id<Expr>{i}];
        if (node.op == Op::Integer && node.value == unknown_value) return "a number of the model is too small";
        if (depth[i] > most_depth) return "a term of the model is nested too deeply";
    }
    return {};
}

std::string network_text(const Network& flat, const std::vector<Property>& properties) {
    return Writer(flat).text(properties);
}

std::vector<std::int64_t> state_values(const Network& flat, const NetworkState& state) {
    std::vector<std::int64_t> values;
    for (const Id<Network::Variable> id : flat.variables.ids())
        values.push_back(flat.variables[id].scratch ? flat.variables[id].initial : state.variables[id.index]);
    for (std::size_t process = 0; process < state.locations.size(); ++process) {
        values.push_back(state.locations[process].index);
        values.insert(values.end(), state.clocks[process].begin(), state.clocks[process].end());
    }
    return values;
}

std::string state_line(const std::vector<std::int64_t>& values) {
    std::string line;
    for (const std::int64_t value : values) line += value == unknown_value ? "* " : fmt::format("{} ", value);
    line += '\n';
    return line;
}

std::string states_text(std::vector<std::vector<std::int64_t>> states) {
    std::ranges::sort(states);
    std::string text;
    for (const std::vector<std::int64_t>& state : states) text += state_line(state);
    return text;
}

std::optional<std::string> run_text(const Network& flat, const Run& run, std::size_t most_bytes) {
    const std::vector<ProcessClocks> clocks = analyse_clocks(flat);
    NetworkState state = initial_state(flat);
    const auto line = [&] {
        NetworkState reduced = state;
        for (std::size_t process = 0; process < clocks.size(); ++process)
            for (std::size_t clock = 0; clock < reduced.clocks[process].size(); ++clock) {
                std::int64_t& value = reduced.clocks[process][clock];
                value = std::min(value,
                                 std::max<std::int64_t>(clocks[process].cap[state.locations[process].index][clock], 0));
            }
        return state_line(state_values(flat, reduced));
    };
    std::string text, last = line();
    const auto perform_one = [&](const Move& move) {
        if (perform(flat, state, move).result != Step::Result::Done) return false;
        text += last = line();
        return text.size() < most_bytes;
    };
    for (const Move& move : run.moves) {
        const auto* const delay = std::get_if<Delay>(&move);
        if (delay == nullptr && !perform_one(move)) return {};
        for (std::int64_t units = delay == nullptr ? 0 : delay->units; units > 0; --units) {
            const std::string before = last;
            if (!perform_one(Delay{1})) return {};
            if (before != last) continue;
            // longer delays lead to the same state
            if (units > 1 && perform(flat, state, Delay{units - 1}).result != Step::Result::Done) return {};
            break;
        }
    }
    return text + "end\n";
}

}  // namespace grafverif::certificate
