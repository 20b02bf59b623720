// SPDX-License-Identifier: MIT
#include "report/charts/mutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "support/json_text.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

using ResultKind = MutantResult::Kind;

/// If a mutant has at most this number of undecided properties, their names are printed; otherwise, only their number
/// is printed.
constexpr std::size_t most_listed = 3;

/// A mutation score. `noticed`: number of detected mutants. `decided`: number of mutants that the score includes;
/// rejected and equivalent mutants are excluded.
struct Score {
    std::size_t noticed = 0, decided = 0;
};

std::size_t count_of(const Mutation& mutation, ResultKind kind) {
    return static_cast<std::size_t>(
        std::ranges::count_if(mutation.results, [&](const std::optional<MutantResult>& mutant_result) {
            return mutant_result && mutant_result->kind == kind;
        }));
}
std::size_t not_checked(const Mutation& mutation) {
    return static_cast<std::size_t>(std::ranges::count_if(
        mutation.results, [](const std::optional<MutantResult>& mutant_result) { return !mutant_result.has_value(); }));
}

Score of_specification(const Mutation& mutation) {
    const std::size_t noticed = count_of(mutation, ResultKind::Noticed);
    return {noticed, noticed + count_of(mutation, ResultKind::Unnoticed)};
}

/// Returns the score of the test sequence. The score includes only mutants whose outputs are known to differ from the
/// outputs of the original.
Score of_tests(const Mutation& mutation) {
    Score score;
    for (const auto& mutant_result : mutation.results) {
        if (!mutant_result || !mutant_result->caught || mutant_result->kind == ResultKind::Refused ||
            mutant_result->kind == ResultKind::Equivalent)
            continue;
        if (!*mutant_result->caught && mutant_result->scans == 0 && mutant_result->kind == ResultKind::Unknown)
            continue;
        ++score.decided;
        score.noticed += *mutant_result->caught ? 1U : 0U;
    }
    return score;
}

std::size_t notices(const Mutation& mutation, const std::string& property) {
    return static_cast<std::size_t>(
        std::ranges::count_if(mutation.results, [&](const std::optional<MutantResult>& mutant_result) {
            return mutant_result &&
                   std::ranges::find(mutant_result->noticed_by, property) != mutant_result->noticed_by.end();
        }));
}

bool is_vacuous(const Mutation& mutation, const std::string& property) {
    return std::ranges::find(mutation.vacuous, property) != mutation.vacuous.end();
}

/// Returns the rounded percentage of detected mutants. The result is 100 % only if all mutants were detected, and 0 %
/// only if no mutant was detected.
std::string percent(const Score& score) {
    if (score.decided == 0) return "";
    const std::size_t rounded = (200 * score.noticed + score.decided) / (2 * score.decided);
    const std::size_t least = score.noticed > 0 ? 1 : 0, most = score.noticed < score.decided ? 99 : 100;
    return fmt::format(", {} %", std::clamp(rounded, least, most));
}

std::size_t line_of(const Mutant& mutant, const Sources& sources) {
    return sources.contains(mutant.where.source) ? place(sources[mutant.where.source].text, mutant.where.begin).line
                                                 : 0;
}

void print_scores(const Mutation& mutation, std::ostream& out) {
    const char* const yet = not_checked(mutation) > 0 ? " so far" : "";
    const Score specified = of_specification(mutation), tested = of_tests(mutation);
    // If `mutate` was stopped early, the list of properties may be empty although a closed loop contains the chart.
    if (mutation.properties.empty() && not_checked(mutation) == 0)
        out << "no properties: no closed loop contains this chart\n";
    else
        out << fmt::format("the specification detects {} of {} mutants{}{}\n", specified.noticed, specified.decided,
                           percent(specified), yet);
    if (mutation.test_steps)
        out << fmt::format("the test sequence ({} steps) detects {} of {} mutants{}{}\n", *mutation.test_steps,
                           tested.noticed, tested.decided, percent(tested), yet);
    else if (!mutation.no_test.empty()) out << fmt::format("no test sequence [{}]\n", mutation.no_test);
    for (const std::string& property : mutation.properties)
        out << fmt::format("  {} detects {}{}{}\n", printable(property), notices(mutation, property), yet,
                           is_vacuous(mutation, property) ? "; holds vacuously" : "");
    std::string undecided;
    for (const std::string& property : mutation.undecided)
        undecided += (undecided.empty() ? "" : ", ") + printable(property);
    if (!undecided.empty())
        out << fmt::format("properties ignored, because their verdicts on the original chart are unknown: {}\n",
                           undecided);
}

void print_mutant(const Mutation& mutation, std::size_t index, const Sources& sources, std::ostream& out) {
    const Mutant& mutant = mutation.mutants[index];
    const MutantResult& mutant_result = *mutation.results[index];
    out << fmt::format("  {:03} {}, {}, line {}", index + 1, mutant.kind, printable(mutant.subject),
                       line_of(mutant, sources));
    if (!mutant_result.reason.empty()) out << ": " << printable(mutant_result.reason);
    if (mutant_result.undecided.size() > most_listed)
        out << fmt::format(", {} properties undecided", mutant_result.undecided.size());
    else
        for (const std::string& property : mutant_result.undecided) out << ", " << printable(property) << " undecided";
    for (const std::string& property : mutant_result.vacuous) out << ", " << printable(property) << " holds vacuously";
    if (mutant_result.caught)
        out << (*mutant_result.caught ? "; detected by the test sequence" : "; not detected by the test sequence");
    out << fmt::format("\n      {}\n  now {}\n", printable(mutant.before), printable(mutant.after));
}

void print_those(const Mutation& mutation, ResultKind kind, const char* title, const Sources& sources,
                 std::ostream& out) {
    bool first = true;
    for (std::size_t k = 0; k < mutation.results.size(); ++k) {
        if (!mutation.results[k] || mutation.results[k]->kind != kind) continue;
        if (first) out << title << '\n';
        first = false;
        print_mutant(mutation, k, sources, out);
    }
}

nlohmann::ordered_json mutant_json(const Mutant& mutant, const std::optional<MutantResult>& mutant_result,
                                   const Sources& sources) {
    nlohmann::ordered_json object = {
        {"kind", mutant.kind}, {"subject", mutant.subject}, {"file", nullptr}, {"line", nullptr}};
    if (sources.contains(mutant.where.source)) {
        object["file"] = sources[mutant.where.source].name;
        object["line"] = line_of(mutant, sources);
    }
    object["before"] = mutant.before;
    object["after"] = mutant.after;
    for (const char* key : {"fate", "reason", "noticed_by", "undecided", "vacuous", "caught", "scans"})
        object[key] = nullptr;
    if (!mutant_result) return object;
    object["fate"] = word(mutant_result->kind);
    object["reason"] = text_or_null(mutant_result->reason);
    object["noticed_by"] = mutant_result->noticed_by;
    object["undecided"] = mutant_result->undecided;
    object["vacuous"] = mutant_result->vacuous;
    if (mutant_result->caught) object["caught"] = *mutant_result->caught;
    if (mutant_result->scans > 0) object["scans"] = mutant_result->scans;
    return object;
}

}  // namespace

void print_mutation(const Mutation& mutation, const Sources& sources, std::ostream& out) {
    out << fmt::format("`{}`{}: {} mutants", printable(mutation.chart),
                       mutation.file.empty() ? "" : " of " + printable(mutation.file), mutation.mutants.size());
    if (mutation.possible > mutation.mutants.size()) out << fmt::format(", of {} possible", mutation.possible);
    out << '\n';
    const auto counted = [&](ResultKind kind, const char* words) {
        if (const std::size_t count = count_of(mutation, kind)) out << fmt::format("{:>5} {}\n", count, words);
    };
    counted(ResultKind::Equivalent, "equivalent: proved to have the outputs of the original");
    counted(ResultKind::Noticed, "killed by a property");
    counted(ResultKind::Unnoticed, "survived: different outputs, but killed by no property");
    counted(ResultKind::Refused, "invalid: rejected as input");
    counted(ResultKind::Unknown, "undecided");
    if (const std::size_t count = not_checked(mutation))
        out << fmt::format("{:>5} not checked: stopped early\n", count);
    print_scores(mutation, out);
    print_those(mutation, ResultKind::Unnoticed, "survived:", sources, out);
    print_those(mutation, ResultKind::Unknown, "undecided:", sources, out);
    print_those(mutation, ResultKind::Refused, "invalid:", sources, out);
}

std::string mutation_json(const Mutation& mutation, const Sources& sources) {
    const Score specified = of_specification(mutation), tested = of_tests(mutation);
    nlohmann::ordered_json object = {{"chart", mutation.chart}, {"possible", mutation.possible}};
    object["properties"] = nlohmann::ordered_json::array();
    for (const std::string& property : mutation.properties)
        object["properties"].push_back({{"name", property},
                                        {"notices", notices(mutation, property)},
                                        {"vacuous", is_vacuous(mutation, property)}});
    object["undecided_properties"] = mutation.undecided;
    object["test_steps"] = nullptr;
    if (mutation.test_steps) object["test_steps"] = *mutation.test_steps;
    object["no_test"] = text_or_null(mutation.no_test);
    for (const ResultKind kind :
         {ResultKind::Equivalent, ResultKind::Noticed, ResultKind::Unnoticed, ResultKind::Refused, ResultKind::Unknown})
        object["counts"][std::string(word(kind))] = count_of(mutation, kind);
    object["counts"]["not_judged"] = not_checked(mutation);
    object["specification"] = {{"notices", specified.noticed}, {"of", specified.decided}};
    object["tests"] = {{"catch", tested.noticed}, {"of", tested.decided}};
    object["mutants"] = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < mutation.mutants.size(); ++k)
        object["mutants"].push_back(mutant_json(mutation.mutants[k], mutation.results[k], sources));
    return json_text(object);
}

}  // namespace grafverif
