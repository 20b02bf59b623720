// SPDX-License-Identifier: MIT
// Certificates of random networks and closed loops. `grafverif-certify` must accept each
// certificate. The program must reject each certificate of another model, and each damaged
// certificate with wrong checksums. The program may accept a damaged certificate with correct
// checksums only if all its claims are true: the test compares them with the verdicts of the timed
// engine.
#include "emit/certificate/certificate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "check/localization/localization.hpp"
#include "check/timed/property_queries.hpp"
#include "compose/observe.hpp"
#include "ir/patterns.hpp"
#include "pipeline/certificate/certificate.hpp"
#include "pipeline/certificate/fragment.hpp"
#include "support/damage.hpp"
#include "support/random_loop.hpp"
#include "support/random_network.hpp"
#include "support/random_subsystems.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"

// The checker is a program of one source file. The tests call its function in their own process.
#define main certify_main
#include "certify/certify.cpp"
#undef main

namespace grafverif {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

enum class Checked { Accepted, Rejected, Malformed };

/// A temporary folder with the files of a certificate.
class CertificateFolder {
public:
    CertificateFolder() {
        std::string pattern = (fs::temp_directory_path() / "grafverif-certificate-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    CertificateFolder(const CertificateFolder&) = delete;
    CertificateFolder& operator=(const CertificateFolder&) = delete;
    ~CertificateFolder() { fs::remove_all(folder_); }

    Checked check(const Files& files) {
        fs::remove_all(folder_);
        for (const auto& [name, content] : files) {
            fs::create_directories((folder_ / name).parent_path());
            std::ofstream(folder_ / name, std::ios::binary) << content;
        }
        text.clear();
        try {
            text = certify::check(folder_);
            return Checked::Accepted;
        } catch (const certify::Rejected& rejected) {
            text = rejected.what();
            return Checked::Rejected;
        } catch (const std::runtime_error& malformed) {
            text = malformed.what();
            return Checked::Malformed;
        }
    }

    std::string text = {};  ///< the text of the last result

private:
    fs::path folder_ = {};
};

/// Returns the network without properties that have several verdicts, need an observer, or are formulas for external
/// tools.
Network with_single_verdicts(Network network) {
    for (const Property& property : std::exchange(network.properties, {}))
        if (property.pattern != Pattern::ReachableAllSteps && property.pattern < Pattern::Watched)
            network.properties.add(property);
    return network;
}

Report report_of(const Network& network) {
    Report report;
    const auto add = [&](const TimedResult& result) {
        for (const Verdict& verdict : result.verdicts) report.answers.push_back({.verdict = verdict});
    };
    for (const Id<Property> id : watched(network))
        add(check_timed(observed(network, {id}), {.properties = {network.properties[id].name}, .timelock = false}));
    add(check_timed(watched(network).empty() ? network : observed(network, {})));
    return report;
}

Files files_of(const Certificate& certificate) {
    Files files;
    for (const Certificate::File& file : certificate.files) files[file.path] = file.content;
    return files;
}

/// Writes the correct checksums into the index of the certificate.
void forge_checksums(Files& files) {
    std::istringstream lines(files["certificate.txt"]);
    std::string index;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind, sum, folder;
        words >> kind >> sum >> folder;
        if (kind == "checksum") continue;
        if (kind == "network") line = "network " + certificate::checksum(files["network.txt"]);
        if (kind == "states" || kind == "bounds" || kind == "subsystem") {
            const auto file = files.find((folder.empty() ? "" : folder + '/') + "states.txt");
            if (file != files.end())
                line = kind + ' ' + certificate::checksum(file->second) + (folder.empty() ? "" : ' ' + folder);
        }
        index += line + '\n';
    }
    files["certificate.txt"] = index + "checksum " + certificate::checksum(index) + '\n';
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

/// Returns the verdicts that an accepted certificate shows.
std::map<std::string, std::string> accepted_claims(const std::string& text) {
    std::map<std::string, std::string> claims;
    for (const std::string& line : lines_of(text)) {
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) continue;
        const std::string verdict = line.substr(colon + 2, line.find(',') - colon - 2);
        const std::string name = line.substr(0, colon);
        if (verdict == "holds" || verdict == "violated") claims[name.substr(name.rfind('/') + 1)] = verdict;
    }
    return claims;
}

/// Checks that no accepted claim contradicts a verdict of the engine.
void expect_true(const std::string& text, const Report& truth) {
    const auto claims = accepted_claims(text);
    for (const PropertyResult& answer : truth.answers) {
        const auto claim = claims.find(certificate::word_of(answer.verdict.property));
        if (claim == claims.end() || answer.verdict.outcome == Outcome::Unknown) continue;
        EXPECT_EQ(claim->second, word(answer.verdict.outcome)) << claim->first;
    }
}

/// Returns the report of localization or, for `by_parts`, of separate searches of subsystems.
Report separate_report(const Network& network, bool by_parts) {
    Report report;
    const TimedResult result = by_parts
                                   ? check_timed_by_parts(network, {})
                                   : check_timed_by_cells(network, {}, {.whole = 4, .local = 5000}, {}, check_timed);
    for (const Verdict& verdict : result.verdicts) report.answers.push_back({.verdict = verdict});
    return report;
}

/// Selects abstractions for half of the verdicts: random levels of the processes except PLCs. The verdicts are then
/// proved by fragments, if possible.
void select_abstractions(const Network& network, Report& report, Random& random) {
    for (PropertyResult& answer : report.answers) {
        if (random_number(random, 0, 1) == 0) continue;
        InputsAbstracted& levels = answer.verdict.abstraction.emplace();
        for (const Network::Process& process : network.processes) {
            const bool is_instance =
                process.kind == Network::ProcessKind::Plant || process.kind == Network::ProcessKind::Environment;
            const std::int64_t level = random_number(random, is_instance ? 0 : 2, 3);
            if (level < 2) levels.chosen.push_back(process.name);
            if (level == 2 && process.kind != Network::ProcessKind::Controller) levels.untimed.push_back(process.name);
        }
    }
}

std::optional<Network> random_model(std::uint64_t seed) {
    Random random(seed);
    if (seed % 5 == 0) {
        Network network = random_cells(random, 2);
        query_subsystems(network, random);
        return network;
    }
    if (seed % 3 == 0) return random_network(random);
    if (seed % 3 == 1) {
        Network network = random_parts(random, 2);
        query_subsystems(network, random);
        return network;
    }
    try {
        return composed_loop(random_loop_asked(random, 8), {.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased})
            .network;
    } catch (const std::invalid_argument&) {
        return {};  // compose rejects this loop
    }
}

/// A random model, the verdicts of the engine, and its certificate.
struct Case {
    Network network = {};
    Report report = {};
    Certificate certificate = {};
    Files files = {};
};

std::optional<Case> random_case(std::uint64_t seed, bool single) {
    std::optional<Network> network = random_model(seed);
    if (!network) return {};
    Case made{single ? with_single_verdicts(std::move(*network)) : std::move(*network)};
    if (check_timed(made.network, {.max_states = single ? 400U : 20'000U, .covering = false}).states >=
        (single ? 400U : 20'000U))
        return {};
    made.report = report_of(made.network);
    // Verdicts of fragments and of subsystems must be those of the complete network.
    Report separate = seed % 5 == 0 || seed % 3 == 1 ? separate_report(made.network, seed % 5 != 0) : made.report;
    Random random(seed);
    if (seed % 5 != 0 && seed % 3 == 2) select_abstractions(made.network, separate, random);
    made.certificate = certificate_of({made.network}, separate, {});
    made.files = files_of(made.certificate);
    return made;
}

TEST(RandomizedCertificate, CertificatesOfRandomModelsAreAccepted) {
    CertificateFolder folder;
    std::map<std::string, int> shown;
    std::map<CertificateKind, int> kinds;
    std::map<std::string, int> keywords;  // first words of the lines of certificate.txt
    int models = 0, open = 0;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(150)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::optional<Case> one = random_case(seed, false);
        if (!one) continue;
        ++models;
        EXPECT_TRUE(one->certificate.failures.empty());
        for (const CertificateSummary::Certified& certified : one->certificate.summary.certified)
            ++kinds[certified.kind];
        ASSERT_EQ(folder.check(one->files), Checked::Accepted) << folder.text;
        for (const auto& [name, content] : one->files) {
            const std::vector<std::string> lines = lines_of(content);
            if (name.ends_with("certificate.txt"))
                for (const std::string& line : lines) ++keywords[line.substr(0, line.find(' '))];
            const auto unknown = [](const std::string& line) { return std::ranges::count(line, '*'); };
            if (name.ends_with("states.txt") && std::ranges::min(lines, {}, unknown) != lines.back() &&
                unknown(std::ranges::min(lines, {}, unknown)) != unknown(std::ranges::max(lines, {}, unknown)))
                ++open;  // some states have an open variable
        }
        const auto claims = accepted_claims(folder.text);
        EXPECT_EQ(claims.size(), one->certificate.summary.certified.size());
        expect_true(folder.text, one->report);
        for (const std::string& line : lines_of(folder.text))
            if (const std::size_t comma = line.find(", "); comma != std::string::npos)
                ++shown[line.substr(line.find(": ") + 2)];
    }
    EXPECT_GT(models, test_size(150) / 3);
    EXPECT_GT(shown["holds, proved by the states"], models);
    EXPECT_GT(shown["violated, shown by a run"], models);
    EXPECT_GT(shown["holds, shown by a run"], 0);
    EXPECT_GT(shown["violated, proved by the states"], 0);
    EXPECT_GT(kinds[CertificateKind::Fragment], test_size(150) / 10);
    EXPECT_GT(kinds[CertificateKind::Subsystems], 0);
    EXPECT_GT(keywords["bounds"], 0);
    EXPECT_GT(keywords["step"], 0);
    EXPECT_GT(open, 0);
}

/// Returns the certificate with a change that alters its meaning, and with correct checksums. `changes_states` becomes
/// true if a state of the set was removed or changed.
Files with_other_meaning(const Files& files, std::mt19937& random, bool& changes_states) {
    Files changed = files;
    changes_states = false;
    const auto pick = [&](std::size_t count) { return count == 0 ? 0 : random() % count; };
    std::vector<std::string> sets = {""};
    for (const auto& [name, content] : files)
        if (name.ends_with("states.txt")) sets.push_back(name);
    const std::string& set = sets[sets.size() > 1 ? 1 + pick(sets.size() - 1) : 0];
    std::vector<std::string> states = set.empty() ? std::vector<std::string>() : lines_of(changed[set]);
    std::vector<std::string> index = lines_of(changed["certificate.txt"]);
    index.pop_back();  // the checksum
    const std::size_t line = 2 + pick(index.size() - 2);
    const std::size_t kind = random() % 4;
    if (!states.empty() && kind < 2) {
        const std::size_t state = pick(states.size());
        changes_states = true;
        if (kind == 0) {
            states.erase(states.begin() + static_cast<std::ptrdiff_t>(state));
        } else {
            std::string& text = states[state];
            const std::size_t digit = text.find_first_of("0123456789*", pick(text.size() - 1));
            const char before = text[digit] == '*' ? '0' : text[digit];
            text[digit] = static_cast<char>('0' + (before - '0' + 1 + static_cast<char>(pick(9))) % 10);
        }
        changed[set] = joined(states);
    } else if (kind == 2) {
        if (index[line].starts_with("holds ")) index[line].replace(0, 5, "violated");
        else if (index[line].starts_with("violated ")) index[line].replace(0, 8, "holds");
        else index.erase(index.begin() + static_cast<std::ptrdiff_t>(line));
        changed["certificate.txt"] = joined(index);
    } else {
        index[line] = damaged(index[line], {.likely = "0123456789", .most_changes = 1, .longest_piece = 5}, random);
        changed["certificate.txt"] = joined(index);
    }
    forge_checksums(changed);
    return changed;
}

TEST(RandomizedCertificate, DamagedCertificatesAreRejected) {
    CertificateFolder folder;
    const int most = test_size(10'000);
    int damages = 0, accepted = 0, forged = 0, lost_states = 0;
    for (std::uint64_t seed = 1; damages < most && seed < 100'000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::optional<Case> one = random_case(seed, true);
        if (!one || one->certificate.summary.certified.empty()) continue;
        std::mt19937 random(static_cast<std::uint32_t>(seed));
        for (int k = 0; k < 100 && damages < most; ++k) {
            Files files = one->files;
            if (k % 2 == 0) {  // the checksums are not adapted: each change is rejected
                auto file = std::next(files.begin(), static_cast<std::ptrdiff_t>(random() % files.size()));
                file->second = random() % 4 == 0 ? file->second.substr(0, random() % file->second.size())
                                                 : damaged(file->second, {.likely = "0123456789 ()\n$"}, random);
                if (file->second == one->files.at(file->first)) continue;
                ++damages;
                EXPECT_NE(folder.check(files), Checked::Accepted) << file->first;
                continue;
            }
            bool loses_state = false;
            files = with_other_meaning(one->files, random, loses_state);
            if (files == one->files) continue;
            ++damages;
            ++forged;
            lost_states += loses_state ? 1 : 0;
            if (folder.check(files) != Checked::Accepted) continue;
            ++accepted;
            EXPECT_FALSE(loses_state);
            expect_true(folder.text, one->report);
        }
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_EQ(damages, most);
    EXPECT_GT(lost_states, most / 10);
    EXPECT_LT(accepted, forged / 2);
    RecordProperty("accepted", accepted);
    RecordProperty("forged", forged);
}

TEST(RandomizedCertificate, DamagedFilesWithCorrectChecksumsAreHandled) {
    CertificateFolder folder;
    std::map<Checked, int> results;
    int damages = 0;
    for (std::uint64_t seed = 1; damages < test_size(3000) && seed < 100'000; ++seed) {
        const std::optional<Case> one = random_case(seed, true);
        if (!one || one->certificate.summary.certified.empty()) continue;
        std::mt19937 random(static_cast<std::uint32_t>(seed));
        for (int k = 0; k < 100; ++k, ++damages) {
            Files files = one->files;
            std::string& text = files[k % 3 == 0 ? "certificate.txt" : "network.txt"];
            text = damaged(text, {.likely = "0123456789 ()\n$", .most_changes = 2}, random);
            forge_checksums(files);
            ++results[folder.check(files)];
        }
    }
    EXPECT_GT(results[Checked::Malformed], damages / 4);
    EXPECT_GT(results[Checked::Rejected], 0);
}

/// Changes one element of the network, which usually changes its states.
void mutate(Network& network, Random& random) {
    const auto pick = [&](auto& table) {
        return static_cast<std::uint32_t>(random_number(random, 0, static_cast<std::int64_t>(table.size()) - 1));
    };
    Network::Template& automaton = network.templates[{pick(network.templates)}];
    if (automaton.edges.empty() || network.variables.empty()) return;
    Network::Edge& edge = automaton.edges[{pick(automaton.edges)}];
    switch (random_number(random, 0, 5)) {
    case 0: edge.guard = network.exprs.negation(edge.guard); break;
    case 1:
        for (Network::ClockConstraint& one : edge.constraint)
            one.bound = network.exprs.integer(random_number(random, 0, 4));
        break;
    case 2: edge.resets.clear(); break;
    case 3:
        if (!edge.assignments.empty()) edge.assignments.pop_back();
        else edge.calls.clear();
        break;
    case 4: edge.to = {pick(automaton.locations)}; break;
    default: {
        Network::Variable& variable = network.variables[{pick(network.variables)}];
        variable.initial = random_number(random, variable.type.low, variable.type.high);
    }
    }
}

TEST(RandomizedCertificate, CertificatesOfOtherModelsProveOnlyTrueClaims) {
    CertificateFolder folder;
    int compared = 0, rejected = 0;
    for (std::uint64_t seed = 1; compared < test_size(1000) && seed < 100'000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::optional<Case> one = random_case(seed, true);
        if (!one || one->certificate.summary.certified.empty()) continue;
        Random random(seed);
        for (int k = 0; k < 10; ++k) {
            Network other = one->network;
            mutate(other, random);
            if (!verify(other).empty() || other == one->network) continue;
            const Network flat = expand(other);
            std::vector<Property> properties;
            for (const CertificateSummary::Certified& certified : one->certificate.summary.certified) {
                const auto found = std::ranges::find(flat.properties, certified.property, &Property::name);
                properties.push_back(found == flat.properties.end() ? timed::undeclared_timelock(flat) : *found);
            }
            Files files = one->files;
            files["network.txt"] = certificate::network_text(flat, properties);
            if (files == one->files) continue;
            ++compared;
            EXPECT_NE(folder.check(files), Checked::Accepted) << "the checksum is wrong";
            forge_checksums(files);
            if (folder.check(files) != Checked::Accepted) ++rejected;
            else expect_true(folder.text, report_of(other));
        }
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_GT(rejected, compared / 3);
}

/// The premises of a fragment; `without_premise` returns a network that violates one premise.
enum class Broken { OmittedProcessesMove, EdgesCanWait, GuardsCanHold, ValuesChange, ClocksPass, count };

Network without_premise(Network network, const FragmentContent& content, Broken premise) {
    for (const Id<Network::Process> id : network.processes.ids()) {
        Network::Template& automaton = network.templates[network.processes[id].automaton];
        const bool kept = content.locations[id.index];
        if (!kept && premise == Broken::OmittedProcessesMove) automaton.edges = {};
        for (Network::Edge& edge : automaton.edges) {
            if (premise == Broken::EdgesCanWait && edge.constraint.empty()) edge.urgent = true;
            if (premise == Broken::GuardsCanHold && !kept) edge.guard = network.exprs.constant(false);
            if (premise == Broken::ValuesChange && !kept) edge.assignments.clear(), edge.calls.clear();
        }
        if (premise == Broken::ClocksPass)
            for (Network::Location& location : automaton.locations)
                for (const Id<Network::Clock> clock : automaton.clocks.ids())
                    location.invariant.push_back({clock, Op::LessEqual, network.exprs.integer(1)});
    }
    return network;
}

/// A set of fragment states that ignores a premise is closed in a network that violates this
/// premise. The program must not accept a false claim that such a set would prove for the original
/// network.
TEST(RandomizedCertificate, FragmentsThatIgnoreAPremiseProveNoFalseClaim) {
    CertificateFolder folder;
    std::map<int, int> rejected, accepted;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(1000)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Network network = random_cells(random, 2);
        query_subsystems(network, random);
        const Network flat = expand(with_single_verdicts(std::move(network)));
        const TimedResult truth = check_timed(flat, {.max_states = 20'000, .covering = false});
        const NetworkFragments cells = cells_of(flat);
        for (const Id<Property> id : flat.properties.ids()) {
            const Property& property = flat.properties[id];
            const auto verdict = std::ranges::find(truth.verdicts, property.name, &Verdict::property);
            if (!is_about_single_states(property.pattern) || verdict->outcome == Outcome::Unknown) continue;
            const std::vector<std::uint32_t> read = cells_read(flat, cells, property);
            if (read.empty()) continue;
            FragmentContent content = complete_content(flat);
            for (const Id<Network::Process> process : flat.processes.ids())
                content.locations[process.index] = content.clocks[process.index] =
                    std::ranges::find(read, cells.of_process[process.index]) != read.end();
            for (const Id<Network::Variable> variable : flat.variables.ids())
                content.variables[variable.index] =
                    variable != flat.race && std::ranges::find(read, cells.of_variable[variable.index]) != read.end();
            for (int k = 0; k < static_cast<int>(Broken::count); ++k) {
                const Network other = without_premise(flat, content, static_cast<Broken>(k));
                const auto found = fragment_states(other, content, {}, &property, {.states = 2000});
                if (!found) continue;
                Files files;
                files["network.txt"] = certificate::network_text(flat, {property});
                files["f/states.txt"] = certificate::states_text(found->states);
                const bool reachable = property.pattern == Pattern::Reachable;
                files["certificate.txt"] = "grafverif-certificate 2\nnetwork 0\nstates 0 f\n" +
                                           std::string(reachable ? "violated " : "holds ") +
                                           certificate::word_of(property.name) + '\n';
                forge_checksums(files);
                if (folder.check(files) != Checked::Accepted) {
                    ++rejected[k];
                    continue;
                }
                ++accepted[k];
                EXPECT_EQ(verdict->outcome, reachable ? Outcome::Violated : Outcome::Holds)
                    << property.name << ", premise " << k;
            }
        }
    }
    for (int k = 0; k < static_cast<int>(Broken::count); ++k) EXPECT_GT(rejected[k], 0) << "premise " << k;
    RecordProperty("accepted", accepted[0]);
}

}  // namespace
}  // namespace grafverif
