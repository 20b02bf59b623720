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
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace certify {

using Int = std::int64_t;
using State = std::vector<Int>;  // in the order of declaration: values of variables, locations of processes, clocks

inline constexpr Int greatest_clock = Int{1} << 60;
inline constexpr std::size_t most_nesting = 500, most_depth = 5000;

/// Thrown if the files are well-formed but do not prove the claims; the exit code is 1.
using Rejected = std::domain_error;
/// Thrown if a term has no value, because of a division by zero or a result outside 64 bits.
struct NoValue {};

[[noreturn]] inline void reject(const std::string& problem) { throw Rejected(problem); }
[[noreturn]] inline void malformed(const std::string& problem) { throw std::runtime_error(problem); }

inline std::string content_of(const std::filesystem::path& path) {
    if (std::error_code failure; !std::filesystem::is_regular_file(path, failure))
        malformed(path.string() + ": no such file");
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Returns FNV-1a, 64 bits, as hexadecimal digits. The checksum detects damaged and exchanged files, but not deliberate
/// changes.
inline std::string checksum(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[hash >> shift & 15U];
    return digits;
}

/// Reads a text line by line and word by word. Each parenthesis is a word.
class Words {
public:
    Words(std::string name, std::string_view text) : name_(std::move(name)), rest_(text) {}

    bool next_line() {
        if (!at_end()) unexpected(word());
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        if (end == std::string_view::npos) fail("the last line is incomplete");
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        ++number_;
        // Control characters (of ASCII, or of UTF-8 after the byte 0xc2) are rejected, because a terminal would execute
        // them when a name is printed.
        for (unsigned char previous = ' '; const char c : line_) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte < 0x20 || byte == 0x7f || (byte >= 0x80 && byte < 0xa0 && (previous < 0x80 || previous == 0xc2)))
                fail("the line contains a control character");
            previous = byte;
        }
        return true;
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
    /// Reads the next word and returns true if it is `expected`; otherwise reads nothing and returns false.
    bool skip(std::string_view expected) {
        const std::string_view before = line_, found = at_end() ? "" : word();
        if (found != expected) line_ = before;
        return found == expected;
    }
    bool at_number() { return !at_end() && (line_[0] == '-' || (line_[0] >= '0' && line_[0] <= '9')); }
    Int number(Int low = INT64_MIN, Int high = INT64_MAX) {
        const std::string_view text = word();
        Int value = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (failure != std::errc() || end != text.data() + text.size() || value < low || value > high)
            fail("`" + std::string(text) + "` is not a number or is out of range");
        return value;
    }
    /// Reads a word that is an element of `list`, or the member `name` of an element of `list`, and returns the index
    /// of the element.
    template <class List, class... Name>
    std::size_t choice(const List& list, Name... name) {
        const auto found = std::ranges::find(list, word(), name...);
        if (found == std::end(list)) fail("unknown word");
        return static_cast<std::size_t>(found - std::begin(list));
    }
    std::string_view remainder() { return std::exchange(line_, {}); }
    [[noreturn]] void unexpected(std::string_view word) const { fail("unexpected `" + std::string(word) + "`"); }
    [[noreturn]] void fail(const std::string& problem) const {
        malformed(name_ + ":" + std::to_string(number_) + ": " + problem);
    }

private:
    std::string name_;
    std::string_view rest_, line_ = {};
    std::size_t number_ = 0;
};

// The network

enum class Op { Not, And, Or, If, Neg, Eq, Ne, Lt, Le, Gt, Ge, Add, Sub, Mul, Div, Mod, Constant, Value };
inline constexpr std::string_view operators[] = {"not", "and", "or", "if", "neg", "=", "!=", "<",
                                                 "<=",  ">",   ">=", "+",  "-",   "*", "/",  "%"};
enum class Pattern { Always, Never, Reachable, ExactlyOne, Inevitable, LeadsTo, Possible, NoDeadlock, NoTimelock };
inline constexpr std::string_view patterns[] = {"always",          "never",       "reachable",
                                                "exactly-one",     "inevitable",  "leads-to",
                                                "always-possible", "no-deadlock", "no-timelock"};

struct Term {
    Op op = Op::Constant;
    Int value = 0;          // for a Constant: its value
    std::size_t place = 0;  // for a Value: index of the value in State
    std::vector<std::size_t> operands = {};
    std::size_t depth = 1;
};
struct Constraint {
    std::size_t clock = 0;  // index in State
    Op relation = Op::Le;
    Int bound = 0;
    /// Returns the least value from which on either all values satisfy the constraint, or all values violate it.
    Int cap() const { return relation == Op::Lt || relation == Op::Ge ? bound : bound + 1; }
};
struct Location {
    std::string name = {};
    std::vector<Constraint> invariant = {};
    // By clock (index in State): the cap, which also represents all greater values.
    std::map<std::size_t, Int> caps = {};
};
struct Edge {
    std::size_t from = 0, to = 0, guard = 0;
    bool urgent = false;
    std::vector<Constraint> constraint = {};
    std::set<std::size_t> resets = {};
    // Pairs of the index of the assigned variable in State, and the term of its new value.
    std::vector<std::pair<std::size_t, std::size_t>> assignments = {};
};
struct Clock {
    std::string name = {};
    std::size_t place = 0;  // index in State
};
struct Process {
    std::string name = {};
    std::size_t place = 0;  // index in State
    std::vector<Clock> clocks = {};
    std::vector<Location> locations = {};
    std::vector<Edge> edges = {};
};
struct Property {
    std::string name = {};
    bool stable = false;  // true if the property concerns only states in which `settled` is true
    Pattern pattern = Pattern::Always;
    std::vector<std::size_t> operands = {};
};

class Network {
public:
    explicit Network(const std::string& text) : words_("network.txt", text) {
        if (!words_.next_line() || !words_.skip("grafverif-network") || words_.number() != 1)
            words_.fail("this is not a network of version 1");
        while (words_.next_line()) read_line(words_.word());
        for (const Process& process : processes)
            if (!declared_.contains("initial " + process.name)) words_.fail("a process has no initial location");
    }

    /// True if the range of the value with the index `place` in State contains `value`.
    bool admits(std::size_t place, Int value) const {
        return ranges[place].first <= value && value <= ranges[place].second;
    }

    std::vector<Process> processes = {};
    std::vector<Property> properties = {};
    std::vector<Term> terms = {Term{}};  // all terms; index 0 is not used
    std::size_t settled = 0, race = 0;   // terms
    State initial = {};
    std::vector<std::pair<Int, Int>> ranges = {};  // range of each value of State, by its index

private:
    void read_line(std::string_view kind) {
        if (kind == "name") words_.remainder();
        else if (kind == "variable" || kind == "define") {
            const std::string name = declare("term ", words_.word());
            terms_.emplace(name, kind == "define" ? term() : add({Op::Value, 0, initial.size()}));
            if (kind == "define") return;
            const Int low = words_.number(), high = words_.number(low);
            add_place(low, high, words_.number(low, high));
        } else if (kind == "race" || kind == "settled") {
            declare(std::string(kind), {});
            (kind == "race" ? race : settled) = term();
        } else if (kind == "property") read_property();
        else if (kind == "process") {
            processes.push_back({declare("process ", words_.word()), initial.size()});
            add_place(0, 0, 0);
        } else if (processes.empty()) words_.unexpected(kind);
        else read_part(kind, processes.back());
    }

    void read_part(std::string_view kind, Process& process) {
        if (kind == "clock" && process.locations.empty()) {
            process.clocks.push_back({declare("clock " + process.name + ' ', words_.word()), initial.size()});
            add_place(0, greatest_clock, 0);
        } else if (kind == "location") {
            process.locations.push_back({declare("location " + process.name + ' ', words_.word())});
            for (const Clock& clock : process.clocks) process.locations.back().caps[clock.place] = 0;
            ranges[process.place].second = std::ssize(process.locations) - 1;
        } else if (kind == "initial") {
            declare("initial ", process.name);
            initial[process.place] = static_cast<Int>(location(process));
        } else if (kind == "invariant" && !process.locations.empty())
            process.locations.back().invariant.push_back(constraint(process));
        else if (kind == "cap" && !process.locations.empty()) {
            Int& cap = process.locations.back().caps.at(clock(process));
            cap = words_.number(0, greatest_clock);
        } else if (kind == "edge") {
            const std::size_t from = location(process), to = location(process);
            const bool urgent = words_.skip("urgent");
            process.edges.push_back({from, to, term(), urgent});
        } else if (process.edges.empty()) words_.unexpected(kind);
        else if (kind == "when") process.edges.back().constraint.push_back(constraint(process));
        else if (kind == "reset") process.edges.back().resets.insert(clock(process));
        else if (kind == "set") {
            const std::size_t target = term();
            if (terms[target].op != Op::Value) words_.fail("the target is not a variable");
            process.edges.back().assignments.emplace_back(terms[target].place, term());
        } else words_.unexpected(kind);
    }

    void read_property() {
        Property one{declare("property ", words_.word()), words_.skip("stable")};
        one.pattern = static_cast<Pattern>(words_.choice(patterns));
        while (!words_.at_end()) one.operands.push_back(term());
        const std::size_t count = one.pattern >= Pattern::NoDeadlock ? 0 : one.pattern == Pattern::LeadsTo ? 2 : 1;
        if (one.pattern != Pattern::ExactlyOne && one.operands.size() != count) words_.fail("wrong number of operands");
        if (one.stable && settled == 0) words_.fail("`settled` is not defined");
        properties.push_back(std::move(one));
    }

    std::string declare(std::string kind, std::string_view name) {
        if (!declared_.insert(kind += name).second) words_.fail("`" + kind + "` is declared twice");
        return std::string(name);
    }
    void add_place(Int low, Int high, Int first) {
        ranges.emplace_back(low, high);
        initial.push_back(first);
    }

    std::size_t location(const Process& of) { return words_.choice(of.locations, &Location::name); }
    std::size_t clock(const Process& of) { return of.clocks[words_.choice(of.clocks, &Clock::name)].place; }
    Constraint constraint(const Process& process) {
        const std::size_t restricted = clock(process);
        const Op relation = static_cast<Op>(words_.choice(operators));
        if (relation < Op::Eq || relation > Op::Ge || relation == Op::Ne) words_.fail("invalid relation");
        return {restricted, relation, words_.number(-greatest_clock, greatest_clock - 1)};
    }

    std::size_t add(Term term) {
        for (const std::size_t operand : term.operands) term.depth = std::max(term.depth, terms[operand].depth + 1);
        if (term.depth > most_depth) words_.fail("a term is nested too deeply");
        terms.push_back(std::move(term));
        return terms.size() - 1;
    }
    /// Reads a term: a number, the name of a variable or of a defined term, or an operator with its operands.
    std::size_t term(std::size_t nesting = 0) {
        if (nesting > most_nesting) words_.fail("parentheses are nested too deeply");
        if (words_.at_number()) return add({Op::Constant, words_.number()});
        if (!words_.skip("(")) {
            const auto found = terms_.find(words_.word());
            if (found == terms_.end()) words_.fail("unknown variable or term");
            return found->second;
        }
        Term made{Op::Eq};
        if (words_.skip("at")) {
            const std::size_t p = words_.choice(processes, &Process::name), at = location(processes[p]);
            made.operands = {add({Op::Value, 0, processes[p].place}), add({Op::Constant, static_cast<Int>(at)})};
        } else made.op = static_cast<Op>(words_.choice(operators));
        while (!words_.skip(")")) made.operands.push_back(term(nesting + 1));
        const std::size_t count = made.op == Op::Not || made.op == Op::Neg ? 1 : made.op == Op::If ? 3 : 2;
        if (made.op != Op::And && made.op != Op::Or && made.operands.size() != count)
            words_.fail("wrong number of operands");
        return add(std::move(made));
    }

    Words words_;
    std::map<std::string, std::size_t, std::less<>> terms_ = {};
    std::set<std::string> declared_ = {};  // declared names; a second declaration is an error
};

}  // namespace certify
