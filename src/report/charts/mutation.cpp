// SPDX-License-Identifier: MIT
#include "report/charts/mutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "support/json_text.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

using Fate = MutantFate::Kind;

/// Maximum number of undecided properties of a mutant that are listed by name.
constexpr std::size_t most_listed = 3;

/// Number of mutants that were detected, and number of mutants that count. Refused and equivalent mutants do not count.
struct Score {
    std::size_t noticed = 0, judged = 0;
};

std::size_t count_of(const Mutation& mutation, Fate kind) {
    return static_cast<std::size_t>(std::ranges::count_if(
        mutation.fates, [&](const std::optional<MutantFate>& fate) { return fate && fate->kind == kind; }));
}
std::size_t not_checked(const Mutation& mutation) {
    return static_cast<std::size_t>(
        std::ranges::count_if(mutation.fates, [](const std::optional<MutantFate>& fate) { return !fate.has_value(); }));
}

Score of_specification(const Mutation& mutation) {
    const std::size_t noticed = count_of(mutation, Fate::Noticed);
    return {noticed, noticed + count_of(mutation, Fate::Unnoticed)};
}

/// Returns the score of the test sequence. Only mutants that are known to differ from the original count.
Score of_tests(const Mutation& mutation) {
    Score score;
    for (const auto& fate : mutation.fates) {
        if (!fate || !fate->caught || fate->kind == Fate::Refused || fate->kind == Fate::Equivalent) continue;
        if (!*fate->caught && fate->scans == 0 && fate->kind == Fate::Unknown) continue;
        ++score.judged;
        score.noticed += *fate->caught ? 1U : 0U;
    }
    return score;
}

std::size_t notices(const Mutation& mutation, const std::string& property) {
    return static_cast<std::size_t>(std::ranges::count_if(mutation.fates, [&](const std::optional<MutantFate>& fate) {
        return fate && std::ranges::find(fate->noticed_by, property) != fate->noticed_by.end();
    }));
}

bool is_vacuous(const Mutation& mutation, const std::string& property) {
    return std::ranges::find(mutation.vacuous, property) != mutation.vacuous.end();
}

std::string percent(const Score& score) {
    return score.judged == 0 ? "" : fmt::format(", {} %", 100 * score.noticed / score.judged);
}

std::size_t line_of(const Mutant& mutant, const Sources& sources) {
    return sources.contains(mutant.where.source) ? place(sources[mutant.where.source].text, mutant.where.begin).line
                                                 : 0;
}

void print_scores(const Mutation& mutation, std::ostream& out) {
    const char* const yet = not_checked(mutation) > 0 ? " so far" : "";
    const Score specified = of_specification(mutation), tested = of_tests(mutation);
    // A run that was stopped early has not yet determined the properties.
    if (mutation.properties.empty() && not_checked(mutation) == 0)
        out << "no properties: no closed loop contains this chart\n";
    else
        out << fmt::format("the specification detects {} of {}{}{}\n", specified.noticed, specified.judged,
                           percent(specified), yet);
    if (mutation.test_steps)
        out << fmt::format("the test sequence ({} steps) detects {} of {}{}{}\n", *mutation.test_steps, tested.noticed,
                           tested.judged, percent(tested), yet);
    else if (!mutation.no_test.empty()) out << fmt::format("no test sequence [{}]\n", mutation.no_test);
    for (const std::string& property : mutation.properties)
        out << fmt::format("  {} detects {}{}{}\n", printable(property), notices(mutation, property), yet,
                           is_vacuous(mutation, property) ? "; holds vacuously" : "");
    std::string undecided;
    for (const std::string& property : mutation.undecided)
        undecided += (undecided.empty() ? "" : ", ") + printable(property);
    if (!undecided.empty()) out << fmt::format("not considered, undecided for the original: {}\n", undecided);
}

void print_mutant(const Mutation& mutation, std::size_t index, const Sources& sources, std::ostream& out) {
    const Mutant& mutant = mutation.mutants[index];
    const MutantFate& fate = *mutation.fates[index];
    out << fmt::format("  {:03} {}, {}, line {}", index + 1, mutant.kind, printable(mutant.subject),
                       line_of(mutant, sources));
    if (!fate.reason.empty()) out << ": " << printable(fate.reason);
    if (fate.undecided.size() > most_listed) out << fmt::format(", {} properties undecided", fate.undecided.size());
    else
        for (const std::string& property : fate.undecided) out << ", " << printable(property) << " undecided";
    for (const std::string& property : fate.vacuous) out << ", " << printable(property) << " holds vacuously";
    if (fate.caught) out << (*fate.caught ? "; detected by the test sequence" : "; not detected by the test sequence");
    out << fmt::format("\n      {}\n  now {}\n", printable(mutant.before), printable(mutant.after));
}

void print_those(const Mutation& mutation, Fate kind, const char* title, const Sources& sources, std::ostream& out) {
    bool first = true;
    for (std::size_t k = 0; k < mutation.fates.size(); ++k) {
        if (!mutation.fates[k] || mutation.fates[k]->kind != kind) continue;
        if (first) out << title << '\n';
        first = false;
        print_mutant(mutation, k, sources, out);
    }
}

nlohmann::ordered_json mutant_json(const Mutant& mutant, const std::optional<MutantFate>& fate,
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
    if (!fate) return object;
    object["fate"] = word(fate->kind);
    object["reason"] = text_or_null(fate->reason);
    object["noticed_by"] = fate->noticed_by;
    object["undecided"] = fate->undecided;
    object["vacuous"] = fate->vacuous;
    if (fate->caught) object["caught"] = *fate->caught;
    if (fate->scans > 0) object["scans"] = fate->scans;
    return object;
}

}  // namespace

void print_mutation(const Mutation& mutation, const Sources& sources, std::ostream& out) {
    out << fmt::format("`{}`{}: {} mutants", printable(mutation.chart),
                       mutation.file.empty() ? "" : " of " + printable(mutation.file), mutation.mutants.size());
    if (mutation.possible > mutation.mutants.size()) out << fmt::format(", of {} possible", mutation.possible);
    out << '\n';
    const auto counted = [&](Fate kind, const char* words) {
        if (const std::size_t count = count_of(mutation, kind)) out << fmt::format("{:>5} {}\n", count, words);
    };
    counted(Fate::Equivalent, "equivalent: proved to have the same outputs");
    counted(Fate::Noticed, "killed by a property");
    counted(Fate::Unnoticed, "survived: different outputs, but killed by no property");
    counted(Fate::Refused, "invalid: rejected as input");
    counted(Fate::Unknown, "undecided");
    if (const std::size_t count = not_checked(mutation))
        out << fmt::format("{:>5} not checked: stopped early\n", count);
    print_scores(mutation, out);
    print_those(mutation, Fate::Unnoticed, "survived:", sources, out);
    print_those(mutation, Fate::Unknown, "undecided:", sources, out);
    print_those(mutation, Fate::Refused, "invalid:", sources, out);
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
    for (const Fate kind : {Fate::Equivalent, Fate::Noticed, Fate::Unnoticed, Fate::Refused, Fate::Unknown})
        object["counts"][std::string(word(kind))] = count_of(mutation, kind);
    object["counts"]["not_judged"] = not_checked(mutation);
    object["specification"] = {{"notices", specified.noticed}, {"of", specified.judged}};
    object["tests"] = {{"catch", tested.noticed}, {"of", tested.judged}};
    object["mutants"] = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < mutation.mutants.size(); ++k)
        object["mutants"].push_back(mutant_json(mutation.mutants[k], mutation.fates[k], sources));
    return json_text(object);
}

}  // namespace grafverif
