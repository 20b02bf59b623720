// SPDX-License-Identifier: MIT
// Reads the network of a certificate from network.txt: timed automata with variables. Names must be declared before
// they are used. Text that does not conform to the format is an error.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace certify {

using Int = std::int64_t;
using Index = std::size_t;
using State = std::vector<Int>;  // in the order of declaration: values of variables, locations of processes, clocks

inline constexpr Int greatest_clock = Int{1} << 60;
inline constexpr Int unknown = INT64_MIN;  // in State: the state of a fragment does not contain this value
inline constexpr Index most_nesting = 500, most_depth = 5000, most_choices = 1'000'000;

/// Thrown if the files are well-formed but do not prove the claims; the exit code is 1.
using Rejected = std::domain_error;
/// Thrown if a term has no value, because of a division by zero or a result outside 64 bits.
struct NoValue {};

[[noreturn]] inline void reject(const std::string& problem) { throw Rejected(problem); }
[[noreturn]] inline void malformed(const std::string& problem) { throw std::runtime_error(problem); }

inline std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) malformed(path.string() + ": no such file");
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Returns FNV-1a, 64 bits, as a number. The hash detects damage and mixed-up files, not deliberate
/// changes.
inline std::string checksum(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    return std::to_string(hash);
}

/// Reads a text line by line and word by word. Each parenthesis is a word.
struct Words {
    Words(std::string name, std::string_view text) : name_(std::move(name)), rest_(text) {}

    bool next_line() {
        // Control characters (of ASCII, or of UTF-8: the byte 194 and a byte below 160) are rejected, because a terminal
        // would execute them when a name is printed.
        const auto bad = [](unsigned char a, unsigned char b) { return a < ' ' || a == 127 || (a == 194 && b < 160); };
        if (!at_end()) fail("unexpected `" + std::string(word()) + "`");
        if (rest_.empty()) return false;
        const std::string_view text = rest_.substr(0, rest_.find('\n') + 1);
        if (text.empty()) fail("the last line is incomplete");
        line_ = text.substr(0, text.size() - 1);
        rest_.remove_prefix(text.size());
        ++number_;
        if (std::ranges::adjacent_find(text, bad) != text.end()) fail("the line contains a control character");
        return true;
    }
    /// Reads the first line: the kind and the version of the file.
    void header(std::string_view kind) {
        if (!next_line() || !skip(kind) || number() != 2) fail("expected `" + std::string(kind) + " 2`");
    }
    bool at_end() {
        line_.remove_prefix(std::min(line_.find_first_not_of(' '), line_.size()));
        return line_.empty();
    }
    std::string_view word() {
        if (at_end()) fail("the line is incomplete");
        const bool parenthesis = line_[0] == '(' || line_[0] == ')';
        const std::string_view found = line_.substr(0, parenthesis ? 1 : line_.find_first_of(" ()"));
        line_.remove_prefix(found.size());
        return found;
    }
    std::string name() { return std::string(word()); }
    /// Reads the next word and returns true if it is `expected`; otherwise reads nothing and returns false.
    bool skip(std::string_view expected) {
        const std::string_view before = line_, found = at_end() ? "" : word();
        if (found != expected) line_ = before;
        return found == expected;
    }
    bool at_number() { return !at_end() && (line_[0] == '-' || (line_[0] >= '0' && line_[0] <= '9')); }
    Int number(Int low = unknown + 1, Int high = INT64_MAX) {
        const std::string_view text = word();
        Int value = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (failure != std::errc() || end != text.data() + text.size() || value < low || value > high)
            fail("`" + std::string(text) + "` is not a number or is out of range");
        return value;
    }
    Index index(Index size) { return static_cast<Index>(number(0, static_cast<Int>(size) - 1)); }
    std::string_view remainder() { return std::exchange(line_, {}); }
    [[noreturn]] void fail(const std::string& problem) const {
        malformed(name_ + ":" + std::to_string(number_) + ": " + problem);
    }

private:
    std::string name_;
    std::string_view rest_, line_ = {};
    Index number_ = 0;
};

// The network

enum class Op { Not, And, Or, If, Neg, Eq, Ne, Lt, Le, Gt, Ge, Add, Sub, Mul, Div, Mod, Constant, Value };
enum class Pattern { Always, Never, Reachable, ExactlyOne, Inevitable, LeadsTo, Possible, NoDeadlock, NoTimelock };

struct Term {
    Op op = Op::Constant;
    Int value = 0;               // Constant: the value
    Int low = 0, high = 1;       // bounds of the value; `low` is `unknown` if the term may have no value
    Index place = 0, depth = 1;  // `place`: for Value, index in State
    std::vector<Index> operands = {};
};
using Constraint = std::tuple<Index, Op, Int>;             // clock (index in State), relation and bound
using Assignments = std::vector<std::pair<Index, Index>>;  // target (index in State) and term
struct Edge {
    Index from = 0, to = 0, guard = 0;
    bool urgent = false;
    std::vector<Constraint> constraint = {};
    std::set<Index> resets = {};
    Assignments assignments = {};
};
using Constraints = std::vector<std::vector<Constraint>>;  // constraints by location
using Caps = std::vector<std::map<Index, Int>>;            // caps by location and clock (State index)
struct Process {
    std::string name = {};
    Index place = 0;  // index in State
    Constraints invariants = {};
    Caps caps = {};  // a cap also represents all greater values
    std::vector<Edge> edges = {};
};
struct Property {
    std::string name = {};
    bool stable = false;  // true if the property concerns only states in which `settled` is true
    Pattern pattern = Pattern::Always;
    std::vector<Index> operands = {};
};

struct Network {
    explicit Network(const std::string& text) : words_("network.txt", text) {
        std::string words = "not and or if neg = != < <= > >= + - * / % always never reachable exactly-one inevitable ";
        Words known("", words += "leads-to always-possible no-deadlock no-timelock\n");
        known.next_line();
        for (Index i = 0; i < 16; ++i) declare("operator ", known.name(), i);
        for (Index i = 0; i < 9; ++i) declare("pattern ", known.name(), i);
        words_.header("grafverif-network");
        while (words_.next_line()) read_line(words_.name());
        raise_caps();
    }

    /// Reads a name and returns its index.
    Index find(Words& words, std::string kind) const {
        const auto found = declared_.find(kind += words.word());
        return found != declared_.end() ? found->second : (words.fail("unknown " + kind), 0);
    }

    std::vector<Process> processes = {};
    std::vector<Property> properties = {};
    std::vector<Term> terms = {Term{}};  // all terms; index 0 is not used
    Index settled = 0;                   // term
    State initial = {};
    std::vector<std::pair<Int, Int>> ranges = {};  // range of each value of State, by its index
    std::set<Index> assigned = {};                 // variables that some edge assigns (index in State)

private:
    void read_line(const std::string& kind) {
        const bool is_named = kind == "variable" || kind == "define" || kind == "process" || kind == "property";
        const std::string name = is_named ? words_.name() : "";
        if (kind == "name") words_.remainder();
        else if (kind == "variable") {
            const Int low = words_.number(), high = words_.number(low);
            declare("term ", name, add_place(low, high, words_.number(low, high)));
            declare("variable ", name, initial.size() - 1);
        } else if (kind == "define") declare("term ", name, term());
        else if (kind == "settled") declare(kind, "", settled = term());
        else if (kind == "property" && name.find('/') != name.npos) words_.fail("a property has a `/` in its name");
        else if (kind == "property") read_property({name, words_.skip("stable")});
        else if (kind == "process") {
            const Index count = words_.index(1'000'000), first = words_.index(count);
            declare("term @", name, add_place(0, static_cast<Int>(count) - 1, static_cast<Int>(first)));
            declare("process ", name, processes.size());
            processes.push_back({name, initial.size() - 1, Constraints(count), Caps(count)});
        } else if (processes.empty()) words_.fail("unexpected `" + kind + "`");
        else read_part(kind, processes.back());
    }

    void read_part(const std::string& kind, Process& process) {
        Edge* const edge = process.edges.empty() ? nullptr : &process.edges.back();
        if (kind == "clock") {
            declare("clock " + process.name + ' ', words_.name(), initial.size());
            for (auto& caps : process.caps) caps[initial.size()] = 0;
            add_place(0, greatest_clock, 0);
        } else if (kind == "invariant") {
            const Index at = words_.index(process.caps.size());
            process.invariants[at].push_back(constraint(process, at));
        } else if (kind == "edge") {
            const Index from = words_.index(process.caps.size()), to = words_.index(process.caps.size());
            const bool urgent = words_.skip("urgent");
            process.edges.push_back({from, to, term(), urgent});
        } else if (edge && kind == "when") edge->constraint.push_back(constraint(process, edge->from));
        else if (edge && kind == "reset") edge->resets.insert(find(words_, "clock " + process.name + ' '));
        else if (edge && kind == "set") {
            const Index target = find(words_, "variable ");
            assigned.insert(target);
            edge->assignments.emplace_back(target, term());
        } else words_.fail("unexpected `" + kind + "`");
    }

    void read_property(Property one) {
        one.pattern = static_cast<Pattern>(find(words_, "pattern "));
        while (!words_.at_end()) one.operands.push_back(term());
        const Index count = one.pattern >= Pattern::NoDeadlock ? 0 : one.pattern == Pattern::LeadsTo ? 2 : 1;
        if (one.pattern != Pattern::ExactlyOne && one.operands.size() != count) words_.fail("wrong number of operands");
        if (one.stable && settled == 0) words_.fail("`settled` is not defined");
        declare("property ", one.name, properties.size());
        properties.push_back(std::move(one));
    }

    /// Declares a name. A second declaration of the same name and kind is an error.
    void declare(const std::string& kind, const std::string& name, Index index) {
        if (!declared_.emplace(kind + name, index).second) words_.fail("`" + kind + name + "` is declared twice");
    }
    /// Adds an element to State, and returns the term that reads it.
    Index add_place(Int low, Int high, Int first) {
        ranges.emplace_back(low, high);
        initial.push_back(first);
        return add({.op = Op::Value, .low = low, .high = high, .place = initial.size() - 1});
    }
    /// Reads a constraint that concerns a location. The cap of the clock is at least the least value from which on all
    /// values satisfy the constraint or all values violate it.
    Constraint constraint(Process& process, Index at) {
        const Index clock = find(words_, "clock " + process.name + ' ');
        const Op relation = static_cast<Op>(find(words_, "operator "));
        if (relation < Op::Eq || relation > Op::Ge || relation == Op::Ne) words_.fail("invalid relation");
        const Int bound = words_.number(-greatest_clock, greatest_clock - 1);
        Int& cap = process.caps[at].at(clock);
        cap = std::max(cap, relation == Op::Lt || relation == Op::Ge ? bound : bound + 1);
        return {clock, relation, bound};
    }
    /// Raises the cap of each location to the caps of the targets of its edges that do not reset the clock.
    void raise_caps() {
        for (bool more = true; std::exchange(more, false);)
            for (Process& process : processes)
                for (const Edge& edge : process.edges)
                    for (auto& [clock, cap] : process.caps[edge.from])
                        if (const Int least = process.caps[edge.to].at(clock);
                            cap < least && !edge.resets.contains(clock))
                            cap = least, more = true;
    }

    Index add(Term term) {
        if (term.op == Op::Neg || (term.op >= Op::Add && term.op <= Op::Mod)) term.low = unknown;
        for (const Index operand : term.operands) {
            const Term& part = terms[operand];
            term.depth = std::max(term.depth, part.depth + 1);
            if (term.op == Op::If) term.high = std::max(term.high, part.high);
            if (term.op == Op::If || part.low == unknown) term.low = std::min(term.low, part.low);
        }
        if (term.depth > most_depth) words_.fail("a term is nested too deeply");
        terms.push_back(std::move(term));
        return terms.size() - 1;
    }
    /// Reads a term: a number, a name, or an operator with its operands. `@NAME` is the location of a process.
    Index term(Index nesting = 0) {
        if (nesting > most_nesting) words_.fail("parentheses are nested too deeply");
        if (words_.at_number()) {
            const Int value = words_.number();
            return add({Op::Constant, value, value, value});
        }
        if (!words_.skip("(")) return find(words_, "term ");
        Term made{static_cast<Op>(find(words_, "operator "))};
        while (!words_.skip(")")) made.operands.push_back(term(nesting + 1));
        const Index count = made.op == Op::Not || made.op == Op::Neg ? 1 : made.op == Op::If ? 3 : 2;
        if (made.op != Op::And && made.op != Op::Or && made.operands.size() != count)
            words_.fail("wrong number of operands");
        return add(std::move(made));
    }

    Words words_;
    std::map<std::string, Index> declared_ = {};
};

}  // namespace certify
