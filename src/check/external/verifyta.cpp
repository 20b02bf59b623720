// SPDX-License-Identifier: MIT
#include "check/external/verifyta.hpp"

#include <algorithm>
#include <chrono>

#include "check/vacuity.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

constexpr char escape = '\033';

/// Returns `text` with one marker, `escape`, in place of each terminal control sequence. A line with a marker is not
/// reliable, because the program may have overwritten it.
std::string marked(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        result += text[i];
        if (text[i] != escape) continue;
        if (i + 1 == text.size() || text[i + 1] != '[') continue;
        // skips to the final byte of the control sequence
        for (i += 2; i < text.size() && (text[i] < '@' || text[i] > '~');) ++i;
    }
    return result;
}

/// Returns the number of lines of `text` that equal `wanted`, apart from surrounding blanks and markers.
std::size_t lines(std::string_view text, std::string_view wanted) {
    constexpr std::string_view blanks = " \t\r\033";
    std::size_t count = 0;
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        if (line.substr(0, line.find_last_not_of(blanks) + 1) == wanted) ++count;
    }
    return count;
}

/// Returns the first line of `text` that is not blank, without markers.
std::string first_line(std::string text) {
    std::erase(text, escape);
    constexpr std::size_t longest = 200;
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return {};
    return text.substr(begin, std::min(text.find_first_of("\r\n", begin) - begin, longest));
}

ExternalResult undecided(UnknownReason obstacle, std::string reason) {
    return {Outcome::Unknown, obstacle, std::move(reason)};
}

/// Returns the reason for an unknown verdict if a signal, a time limit or an output limit ended the program. Returns
/// nullopt if the program exited.
std::optional<ExternalResult> ended_early(const ProgramResult& result) {
    switch (result.end) {
    case ProgramResult::End::Exited: return {};
    case ProgramResult::End::Signalled:
        return undecided(UnknownReason::Failed, "verifyta was terminated by signal " + std::to_string(result.status));
    case ProgramResult::End::TimedOut:
        return undecided(UnknownReason::Stopped, "verifyta was stopped at the time limit");
    case ProgramResult::End::Stopped: return undecided(UnknownReason::Stopped, "verifyta was stopped");
    case ProgramResult::End::TooMuchOutput:
        return undecided(UnknownReason::Failed, "the output of verifyta is too large");
    }
    unreachable();
}

Verdict verdict_on(const Network& network, const ExternalQuery& question) {
    Verdict verdict = grafverif::verdict_on(question.property, network.properties[question.property]);
    verdict.property = question.name;
    return verdict;
}

/// True if the query concerns action races: its property states that the flag for races is never set.
bool queries_race(const Network& network, const ExternalQuery& question) {
    const Property& property = network.properties[question.property];
    if (!network.race.valid() || property.pattern != Pattern::Never || property.at_stable) return false;
    const Expr& operand = network.exprs[property.operands[0]];
    return operand.op == Op::Variable && operand.value == network.race.index;
}

Verdict unasked(Verdict verdict) {
    set_unknown(verdict, UnknownReason::Stopped, "stopped before the check of this property");
    return verdict;
}

Verdict run_query(Verdict verdict, const ExternalQuery& question, const ExternalOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    ExternalResult answer = question.formula.empty() ? undecided(UnknownReason::Unsupported, question.reason)
                                                     : read_verifyta(options.run(question.formula));
    verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    verdict.outcome = answer.outcome;
    verdict.obstacle = answer.obstacle;
    verdict.reason = std::move(answer.reason);
    return verdict;
}

/// Makes a decided verdict unknown, because stored actions of the model may race.
void withdraw(Verdict& verdict) {
    if (verdict.outcome == Outcome::Unknown) return;
    set_unknown(verdict, UnknownReason::Faulty, "stored actions can race; see `no_race`");
}

}  // namespace

ExternalResult read_verifyta(const ProgramResult& result) {
    if (auto answer = ended_early(result)) return *answer;
    const std::string text = marked(result.out);
    const std::size_t satisfied = lines(text, "-- Formula is satisfied."),
                      refuted = lines(text, "-- Formula is NOT satisfied.");
    const std::size_t open =
        lines(text, "-- Formula MAY be satisfied.") + lines(text, "-- Formula MAY NOT be satisfied.");
    if (satisfied + refuted + open > 1)
        return undecided(UnknownReason::Disagrees,
                         "engine-disagrees: verifyta printed more than one verdict on one formula");
    if (open == 1)
        return undecided(UnknownReason::Inexact, "verifyta reports that the formula may or may not be satisfied");
    if (satisfied + refuted == 1) return {satisfied == 1 ? Outcome::Holds : Outcome::Violated, UnknownReason::None, {}};
    std::string error_line = first_line(marked(result.err));
    if (error_line.empty()) error_line = "exit code " + std::to_string(result.status);
    return undecided(UnknownReason::Failed, "verifyta printed no verdict: " + error_line);
}

std::vector<Verdict> check_verifyta(const Network& network, std::span<const ExternalQuery> questions,
                                    const ExternalOptions& options) {
    const auto requested = [&](const Property& property) {
        return options.properties.empty() ||
               std::ranges::find(options.properties, property.name) != options.properties.end();
    };
    std::vector<Verdict> verdicts;
    const auto holds = [&](std::string_view name) {
        const auto known = std::ranges::find(verdicts, name, &Verdict::property);
        return known != verdicts.end() && known->outcome == Outcome::Holds;
    };
    std::optional<std::size_t> race;  // index of the verdict on races
    bool stopped = false;
    for (const ExternalQuery& question : questions) {
        const Property& property = network.properties[question.property];
        if (queries_race(network, question)) race = verdicts.size();
        else if (is_probe(property) ? !holds(probed_by(property)) : !requested(property)) continue;
        verdicts.push_back(stopped ? unasked(verdict_on(network, question))
                                   : run_query(verdict_on(network, question), question, options));
        stopped = stopped || verdicts.back().obstacle == UnknownReason::Stopped;
    }
    if (network.race.valid() && (!race || verdicts[*race].outcome != Outcome::Holds))
        for (std::size_t i = 0; i < verdicts.size(); ++i)
            if (i != race) withdraw(verdicts[i]);
    apply_probes(network.properties, verdicts);
    std::erase_if(verdicts, [&](const Verdict& verdict) { return is_probe(network.properties[verdict.about]); });
    const auto about_time = [](const Property& property) { return property.pattern == Pattern::NoTimelock; };
    if (std::ranges::none_of(network.properties, about_time))
        verdicts.push_back({.property = "no_timelock",
                            .pattern = Pattern::NoTimelock,
                            .obstacle = UnknownReason::Unsupported,
                            .reason = "UPPAAL has no query for `no timelock`; use `--engine timed`",
                            .declared = false});
    return verdicts;
}

}  // namespace grafverif
