// SPDX-License-Identifier: MIT
#include "check/external/nusmv.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "check/evidence.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

namespace {

constexpr std::string_view mark = "grafverif: ";
/// Maximum number of values that are read from a trace; further states are ignored.
constexpr std::size_t most_values = 50'000'000;

/// Divides the output at its markers. Maps the name in each marker to the text between this marker and the next one.
/// The text after the last marker is excluded, because it may be incomplete.
std::unordered_map<std::string, std::vector<std::string_view>> sections(std::string_view text) {
    std::unordered_map<std::string, std::vector<std::string_view>> found;
    for (std::size_t at = text.find(mark); at != std::string_view::npos;) {
        const std::size_t line_end = std::min(text.find('\n', at), text.size());
        std::string_view name = text.substr(at + mark.size(), line_end - at - mark.size());
        name = name.substr(0, name.find_last_not_of(" \r") + 1);  // NuSMV `echo` appends a blank
        const std::size_t next = text.find(mark, line_end);
        if (next == std::string_view::npos) break;
        found[std::string(name)].push_back(text.substr(line_end, next - line_end));
        at = next;
    }
    return found;
}

std::string_view trimmed_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    return line;
}

/// Returns the results of all specifications in a section of the output, in their order: true or false.
std::vector<bool> truths(std::string_view section) {
    std::vector<bool> found;
    while (!section.empty()) {
        const std::string_view line = trimmed_line(section);
        if (!line.starts_with("-- specification") && !line.starts_with("-- invariant") && !line.starts_with("-- LTL"))
            continue;
        if (line.ends_with("is true") || line.ends_with("is false")) found.push_back(line.ends_with("is true"));
    }
    return found;
}

/// Reads a counterexample as printed by NuSMV. NuSMV omits unchanged values and prints the choices of a step before the
/// state to which the step leads.
class TraceReader {
public:
    TraceReader(const FlatSystem& flat, const SystemSpelling& spelling) : flat_(flat), spelling_(spelling) {
        for (const Id<FlatSystem::Variable> id : flat.variables.ids()) places_[spelling.variables[id.index]] = id;
        for (const FlatSystem::Variable& variable : flat.variables) now_.push_back(variable.type.low);
    }

    /// Returns the trace in a section. The loop of the trace is included only if `repeats` is true. The result is
    /// nullopt if the section contains no trace, or if the trace has an invalid value.
    std::optional<ExternalTrace> read(std::string_view section, bool repeats) {
        bool in_trace = false;
        while (!section.empty()) {
            const std::string_view line = trimmed_line(section);
            if (line.starts_with("Trace Type:")) in_trace = true;
            if (!in_trace) continue;
            if (line.starts_with("-- Loop starts here")) begin_loop();
            else if (line.starts_with("-> Input:")) close_state();
            else if (line.starts_with("-> State:")) begin_state();
            else if (const std::size_t at = line.find(" = "); at != std::string_view::npos)
                if (!assign(line.substr(0, at), line.substr(at + 3))) return {};
        }
        close_state();
        return run(repeats);
    }

private:
    void begin_loop() {
        close_state();
        if (!loop_) loop_ = states_.size();
    }

    void close_state() {
        if (open_ && states_.size() * now_.size() < most_values) states_.push_back(now_);
        open_ = false;
    }

    void begin_state() {
        close_state();
        for (const Id<FlatSystem::Variable> id : flat_.variables.ids())
            if (flat_.variables[id].choice && !states_.empty()) states_.back()[id.index] = now_[id.index];
        open_ = true;
    }

    bool assign(std::string_view name, std::string_view value) {
        const auto place = places_.find(std::string(name));
        if (place == places_.end()) return true;  // the name of a DEFINE, whose value is not needed
        const auto number = value_of(place->second, value);
        if (number) now_[place->second.index] = *number;
        return number.has_value();
    }

    std::optional<std::int64_t> value_of(Id<FlatSystem::Variable> id, std::string_view text) const {
        if (text == "TRUE" || text == "FALSE") return text == "TRUE";
        const std::vector<std::string>& names = spelling_.values[id.index];
        const auto named = std::ranges::find(names, text);
        if (named != names.end()) return flat_.variables[id].type.low + (named - names.begin());
        std::int64_t number = 0;
        const std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), number);
        if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return {};
        return number;
    }

    std::optional<ExternalTrace> run(bool repeats) {
        if (states_.empty()) return {};
        ExternalTrace run{std::move(states_), {}};
        if (repeats && loop_ && *loop_ + 1 < run.states.size()) {
            run.loop = loop_;
            run.states.pop_back();  // the last state is equal to the first state of the loop
        }
        return run;
    }

    const FlatSystem& flat_;
    const SystemSpelling& spelling_;
    std::unordered_map<std::string, Id<FlatSystem::Variable>> places_ = {};
    std::vector<std::int64_t> now_ = {};
    std::vector<std::vector<std::int64_t>> states_ = {};
    bool open_ = false;
    std::optional<std::size_t> loop_ = {};
};

/// Reads the number of states in a line such as `reachable states: 19456 (2^14.25) out of ...`. The result is empty if
/// NuSMV has rounded the number (`1.2e+21`).
std::string state_count(std::string_view section) {
    constexpr std::string_view before = "reachable states: ";
    const std::size_t at = section.find(before);
    if (at == std::string_view::npos) return {};
    section.remove_prefix(at + before.size());
    const std::size_t end = section.find_first_not_of("0123456789");
    return end != std::string_view::npos && section[end] == ' ' ? std::string(section.substr(0, end)) : std::string();
}

std::string failure_of(const ProgramResult& program_result) {
    if (std::string ended = ended_by(program_result); !ended.empty()) return ended;
    std::string_view text = program_result.err;
    std::string last;
    while (!text.empty())
        if (const std::string_view line = trimmed_line(text); !line.empty()) last = line;
    constexpr std::size_t longest = 200;
    if (last.size() > longest) last = last.substr(0, longest) + "...";
    return last.empty() ? "the program printed no verdict"
                        : "the program printed no verdict; end of its output: " + last;
}

UnknownReason obstacle_of(const ProgramResult& program_result) {
    const bool stopped =
        program_result.end == ProgramResult::End::TimedOut || program_result.end == ProgramResult::End::Stopped;
    return stopped ? UnknownReason::Stopped : UnknownReason::Failed;
}

/// The output of NuSMV, divided into sections by markers. If a signal has ended NuSMV, the output is ignored.
class NusmvOutput {
public:
    explicit NusmvOutput(const ProgramResult& program_result) {
        if (program_result.end != ProgramResult::End::Signalled) sections_ = sections(program_result.out);
    }

    /// Returns the section with the name `name`. Returns an empty string if no section or several sections have this
    /// name.
    std::string_view section(const std::string& name) const {
        const auto found = sections_.find(name);
        return found == sections_.end() || found->second.size() != 1 ? std::string_view() : found->second.front();
    }
    std::vector<bool> truths_of(const std::string& name) const {
        std::vector<bool> all;
        if (const auto found = sections_.find(name); found != sections_.end())
            for (const std::string_view section : found->second)
                for (const bool truth : truths(section)) all.push_back(truth);
        return all;
    }

private:
    std::unordered_map<std::string, std::vector<std::string_view>> sections_ = {};
};

struct NusmvQuery {
    const TransitionSystem& system;
    FlatSystem& flat;
    const SystemSpelling& spelling;
    const Property& property;
};

/// Validates the result of the program and sets the verdict. Returns the counterexample or witness that the program
/// printed, or nullopt if it printed none.
std::optional<SystemRun> validated(Verdict& verdict, const NusmvOutput& answers, const std::string& name,
                                   const NusmvQuery& question, const ProgramResult& program_result) {
    const std::vector<bool> truths = answers.truths_of(name);
    if (truths.size() != 1) {
        if (truths.empty()) set_unknown(verdict, obstacle_of(program_result), failure_of(program_result));
        else distrust(verdict, "the program printed more than one verdict");
        return {};
    }
    const Pattern pattern = question.property.pattern;
    const bool reachable = pattern == Pattern::Reachable;
    verdict.outcome = truths.front() != reachable ? Outcome::Holds : Outcome::Violated;
    if (truths.front()) return {};
    const bool about_paths = is_liveness(pattern) || pattern == Pattern::RawLtl || pattern == Pattern::RawCtl;
    const auto printed_trace = TraceReader(question.flat, question.spelling).read(answers.section(name), about_paths);
    const std::string why = !printed_trace ? "the program printed no trace for its verdict"
                                           : doubt(question.system, question.flat, question.property, *printed_trace);
    if (!why.empty()) {
        distrust(verdict, why);
        return {};
    }
    SystemRun run{{}, printed_trace->loop};
    for (const std::vector<std::int64_t>& state : printed_trace->states)
        run.states.push_back(symbol_values(question.flat, state));
    return run;
}

}  // namespace

std::string nusmv_commands(const std::string& model, const SystemSpelling& spelling,
                           const std::vector<std::size_t>& properties) {
    const auto section = [](std::string_view name) { return "echo " + std::string(mark) + std::string(name) + "\n"; };
    std::string text = "set on_failure_script_quits\nset dynamic_reorder 1\nread_model -i " + model +
                       "\nflatten_hierarchy\nencode_variables\nbuild_model\n";
    text += section("fsm") + "check_fsm\n" + section("states") + "print_reachable_states\n";
    for (const std::size_t property : properties)
        text += section(std::to_string(property)) + "check_property -P \"" + spelling.properties[property] + "\"\n";
    return text + section("end") + "quit\n";
}

NusmvResult read_nusmv(const TransitionSystem& system, const SystemSpelling& spelling,
                       const std::vector<std::size_t>& properties, const ProgramResult& program_result) {
    FlatSystem flat = flattened(system);
    const NusmvOutput answers(program_result);
    NusmvResult result;
    const std::string_view totality = answers.section("fsm");
    for (const std::string_view words : {"The transition relation is total", "the machine is deadlock-free"})
        result.total = result.total || totality.find(words) != std::string_view::npos;
    result.states = state_count(answers.section("states"));
    for (const std::size_t index : properties) {
        const Property& property = system.properties[{static_cast<std::uint32_t>(index)}];
        Verdict verdict = verdict_on({static_cast<std::uint32_t>(index)}, property);
        verdict.states = result.states;
        std::optional<SystemRun> run;
        if (!totality.empty() && !result.total)
            set_unknown(verdict, UnknownReason::Faulty, "some reachable state has no successor");
        else if (totality.empty()) set_unknown(verdict, obstacle_of(program_result), failure_of(program_result));
        else
            run =
                validated(verdict, answers, std::to_string(index), {system, flat, spelling, property}, program_result);
        result.verdicts.push_back(std::move(verdict));
        result.runs.push_back(std::move(run));
    }
    return result;
}

}  // namespace grafverif
