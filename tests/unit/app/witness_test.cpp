// SPDX-License-Identifier: MIT
// Tests the certificates of PDR: witness circuits, and the proofs of the conditions that they satisfy.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cadical.hpp>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <span>
#include <sstream>

#include "check/pdr/check.hpp"
#include "check/pdr/refutation.hpp"
#include "emit/certificate/certificate.hpp"
#include "pipeline/certificate/certificate.hpp"
#include "support/random_system.hpp"
#include "support/read_aiger.hpp"
#include "support/test_size.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

/// Clauses of two consecutive states of a circuit.
class Steps {
public:
    explicit Steps(const AigerFile& file) : file_(file) {
        solver_.add(-1);
        solver_.add(0);
        for (const int step : {0, 1})
            for (const AigerFile::And& gate : file.ands) {
                const int out = of(gate.out, step), left = of(gate.left, step), right = of(gate.right, step);
                for (const std::vector<int>& clause :
                     std::vector<std::vector<int>>{{-out, left}, {-out, right}, {out, -left, -right}}) {
                    for (const int literal : clause) solver_.add(literal);
                    solver_.add(0);
                }
            }
        for (const AigerFile::Latch& latch : file.latches) {
            const int now = of(latch.next, 0), next = of(latch.literal, 1);
            for (const int literal : {-now, next, 0, now, -next, 0}) solver_.add(literal);
        }
    }
    int of(std::uint32_t literal, int step) const {
        const int variable =
            literal < 2 ? 1 : static_cast<int>(literal / 2 + 1 + file_.most * static_cast<unsigned>(step));
        return literal % 2 != 0 ? -variable : variable;
    }
    bool possible(const std::vector<int>& literals) {
        for (const int literal : literals) solver_.assume(literal);
        return solver_.solve() == 10;
    }

private:
    const AigerFile& file_;
    CaDiCaL::Solver solver_ = {};
};

/// Returns the condition of Certifaiger that the witness violates, or an empty string.
std::string flaw(const std::string& model_text, const std::string& witness_text) {
    const AigerFile model = read_aiger(model_text), witness = read_aiger(witness_text);
    if (!model.error_text.empty() || !witness.error_text.empty()) return "syntax";
    if (model.inputs != witness.inputs || model.latches.size() != witness.latches.size()) return "interface";
    if (!std::ranges::equal(model.ands, std::span(witness.ands).first(std::min(model.ands.size(), witness.ands.size())),
                            [](const auto& a, const auto& b) { return a.left == b.left && a.right == b.right; }))
        return "gates";
    for (std::size_t i = 0; i < model.latches.size(); ++i)
        if (model.latches[i].next != witness.latches[i].next) return "transition";
    Steps steps(witness);
    std::vector<int> initial;
    for (const AigerFile::Latch& latch : witness.latches) initial.push_back(-steps.of(latch.literal, 0));
    const int bad = steps.of(witness.bads.at(0), 0), later = steps.of(witness.bads.at(0), 1);
    initial.push_back(bad);
    if (steps.possible(initial)) return "initial";
    if (steps.possible({-bad, steps.of(model.bads.at(0), 0)})) return "property";
    if (steps.possible({-bad, later})) return "induction";
    return {};
}

using ClauseList = std::vector<std::vector<int>>;

/// Returns the clauses of a condition of the witness, as docs/how-to/certificates.md defines them.
ClauseList expected_clauses(const AigerFile& model, const AigerFile& witness, const std::string& condition) {
    const auto of = [&](std::uint32_t literal, int step) {
        const int variable =
            literal < 2 ? 1 : 1 + static_cast<int>(literal / 2) + static_cast<int>(witness.most) * step;
        return literal % 2 != 0 ? -variable : variable;
    };
    ClauseList clauses{{-1}};
    for (int step = 0; step < (condition == "step" ? 2 : 1); ++step)
        for (const AigerFile::And& gate : witness.ands) {
            const int out = of(gate.out, step), left = of(gate.left, step), right = of(gate.right, step);
            clauses.insert(clauses.end(), {{-out, left}, {-out, right}, {out, -left, -right}});
        }
    const std::uint32_t bad = witness.bads.at(0);
    for (const AigerFile::Latch& latch : witness.latches) {
        if (condition == "initial") clauses.push_back({-of(latch.literal, 0)});
        if (condition != "step") continue;
        const int now = of(latch.next, 0), next = of(latch.literal, 1);
        clauses.insert(clauses.end(), {{-now, next}, {now, -next}});
    }
    if (condition != "initial") clauses.push_back({-of(bad, 0)});
    clauses.push_back({condition == "safe" ? of(model.bads.at(0), 0) : of(bad, condition == "step" ? 1 : 0)});
    return clauses;
}

ClauseList read_dimacs(const std::string& text) {
    std::istringstream in(text);
    std::string p, cnf;
    std::size_t variables = 0, count = 0;
    in >> p >> cnf >> variables >> count;
    ClauseList clauses(1);
    for (int literal = 0; in >> literal;) {
        EXPECT_LE(static_cast<std::size_t>(std::abs(literal)), variables);
        if (literal == 0) clauses.emplace_back();
        else clauses.back().push_back(literal);
    }
    clauses.pop_back();
    EXPECT_EQ(clauses.size(), count);
    return clauses;
}

/// Checks a proof in LRAT, without RAT steps. Returns the reason why it does not refute the clauses, or an empty string.
std::string lrat_flaw(const ClauseList& given, const std::string& proof) {
    std::map<int, std::vector<int>> known;
    for (const std::vector<int>& clause : given) known[static_cast<int>(known.size()) + 1] = clause;
    std::istringstream lines(proof);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        int id = 0, word = 0;
        words >> id;
        if (id <= (known.empty() ? 0 : known.rbegin()->first)) return "id";
        std::vector<int> clause;
        std::set<int> is_true;
        while (words >> word && word != 0) clause.push_back(word);
        for (const int literal : clause) is_true.insert(-literal);
        bool conflict = false;
        while (!conflict && words >> word && word != 0) {
            if (!known.contains(word)) return "unknown hint";
            std::set<int> open;
            for (const int literal : known[word])
                if (!is_true.contains(-literal)) open.insert(literal);
            if (open.size() > 1) return "hint is not unit";
            conflict = open.empty();
            is_true.insert(open.begin(), open.end());
        }
        if (!conflict) return "no conflict";
        if (clause.empty()) return "";
        known[id] = clause;
    }
    return "no empty clause";
}

/// Checks the clauses and proofs of a witness. `read` returns the content of the file with a given
/// ending.
template <class Read>
void expect_proofs(const Read& read) {
    const AigerFile model = read_aiger(read(".model.aag")), witness = read_aiger(read(".witness.aag"));
    for (const std::string condition : {"initial", "step", "safe"}) {
        SCOPED_TRACE(condition);
        ClauseList clauses = read_dimacs(read("." + condition + ".cnf"));
        const std::string proof = read("." + condition + ".lrat");
        EXPECT_EQ(lrat_flaw(clauses, proof), "");
        clauses.pop_back();  // the condition is satisfiable without the property of the witness
        EXPECT_NE(lrat_flaw(clauses, proof), "");
        clauses = read_dimacs(read("." + condition + ".cnf"));
        ClauseList expected = expected_clauses(model, witness, condition);
        for (ClauseList* const list : {&clauses, &expected}) {
            for (std::vector<int>& clause : *list) std::ranges::sort(clause);
            std::ranges::sort(*list);
        }
        EXPECT_TRUE(clauses == expected) << "the clauses are not those of the circuits";
    }
}

TEST(Certificate, WitnessCircuitsOfPdrAreInductive) {
    const std::string tanks = (root / "samples/tanks/tanks.grafcet").string();
    const Folder folder;
    const Result result = grafverif(
        {"check", tanks, "--untimed", "--plant", "automata", "--engine", "pdr", "--certificate", folder.file("tanks")});
    EXPECT_NE(result.out.find("check it with Certifaiger"), std::string::npos) << result.out << result.err;
    int witnesses = 0, damages = 0, rejected = 0;
    std::mt19937 random(1);
    for (const auto& entry : fs::directory_iterator(folder.file("tanks"))) {
        const std::string name = entry.path().filename().string(), ending = ".model.aag";
        if (!name.ends_with(ending)) continue;
        const std::string base = "tanks/" + name.substr(0, name.size() - ending.size());
        if (fs::exists(folder.file(base + ".cex"))) continue;  // the verdict has a run, not a proof
        const std::string model = folder.read(base + ending), witness = folder.read(base + ".witness.aag");
        EXPECT_EQ(flaw(model, witness), "") << name;
        expect_proofs([&](const std::string& end) { return folder.read(base + end); });
        ++witnesses;
        for (int k = 0; k < 20; ++k) {  // a literal of an additional gate, or of the property, is inverted
            std::vector<std::string> lines;
            std::istringstream in(witness);
            for (std::string line; std::getline(in, line);) lines.push_back(line);
            const AigerFile file = read_aiger(witness);
            const std::size_t bad = 1 + file.inputs.size() + file.latches.size();
            const std::size_t own = file.ands.size() - read_aiger(model).ands.size();
            const std::size_t at = k == 0 || own == 0 ? bad : bad + file.ands.size() - random() % own;
            const std::size_t space = lines[at].rfind(' ') + 1;
            lines[at] = lines[at].substr(0, space) + std::to_string(std::stoul(lines[at].substr(space)) ^ 1U);
            std::string changed;
            for (const std::string& line : lines) changed += line + '\n';
            ++damages;
            const bool is_rejected = !flaw(model, changed).empty();
            EXPECT_TRUE(is_rejected || k != 0) << "the property is inverted";
            rejected += is_rejected ? 1 : 0;
        }
    }
    EXPECT_EQ(witnesses, 3);
    EXPECT_GT(rejected, damages / 2);
}

/// Returns the reason why the witness of a run does not show that `bad` of the model is true in the last state, or an
/// empty string. Reads the format of AIGER witnesses and simulates the circuit by the specification alone.
std::string run_flaw(const std::string& model_text, const std::string& witness) {
    const AigerFile model = read_aiger(model_text);
    if (!model.error_text.empty()) return "model";
    std::istringstream in(witness);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    if (lines.size() < 5 || lines[0] != "1" || lines[1] != "b0" || lines.back() != ".") return "syntax";
    if (lines[2] != std::string(model.latches.size(), '0')) return "initial state";
    std::vector<std::vector<bool>> inputs;
    for (const std::string& line : std::span(lines).subspan(3, lines.size() - 4)) {
        if (line.size() != model.inputs.size() || line.find_first_not_of("01") != std::string::npos) return "inputs";
        std::vector<bool>& state = inputs.emplace_back();
        for (const char value : line) state.push_back(value == '1');
    }
    return aiger_value(aiger_run(model, inputs).back(), model.bads.at(0)) ? "" : "not bad";
}

/// Every untimed engine writes a run or a witness circuit for each verdict about states.
TEST(Certificate, EachUntimedEngineCertifiesVerdictsAboutStates) {
    const Folder folder;
    const std::string loop = folder.write(
        "loop.grafcet",
        "grafcet lamp { input ON; output LAMP; initial step 0; step 1 { LAMP; } transition on: 0 -> 1 when ON; "
        "transition off: 1 -> 0 when !ON; }\n"
        "closed_loop room { controller lamp; environment a = free(OUT = ON); property dark: never LAMP;\n"
        "property lit: reachable LAMP; property one: exactly one of {X0, X1}; property ends: inevitable LAMP; }\n");
    int damaged = 0, rejected = 0;
    for (const std::string engine : {"auto", "symbolic", "pdr", "bmc"}) {
        SCOPED_TRACE(engine);
        const Result result =
            grafverif({"check", loop, "--untimed", "--engine", engine, "--certificate", folder.file(engine)});
        for (const std::string name : {"dark", "lit"}) {
            const std::string model = folder.read(engine + "/" + name + ".model.aag");
            const std::string run = folder.read(engine + "/" + name + ".cex");
            EXPECT_EQ(run_flaw(model, run), "") << result.out << result.err;
            for (std::size_t k = 0; k < run.size(); ++k) {
                std::string changed = run;
                if (run[k] == '\n') changed.erase(k, 1);
                else changed[k] = run[k] == '1' ? '0' : '1';
                ++damaged;
                rejected += run_flaw(model, changed).empty() ? 0 : 1;
            }
        }
        EXPECT_NE(result.out.find("\n  run: dark, lit\n"), std::string::npos) << result.out;
        if (engine == "bmc") {  // BMC decides no invariant
            EXPECT_NE(result.out.find("one is not certified: the verdict is unknown"), std::string::npos) << result.out;
            continue;
        }
        EXPECT_EQ(flaw(folder.read(engine + "/one.model.aag"), folder.read(engine + "/one.witness.aag")), "");
    }
    EXPECT_GT(rejected, damaged / 2);
}

TEST(Certificate, RunsOfRandomSystemsReachTheirStates) {
    int runs = 0, other_models = 0, rejected = 0;
    std::string previous;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(100)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TransitionSystem system = random_system(random);
        ask_more(system, random);
        for (const PdrOptions::Method method : {PdrOptions::Method::Pdr, PdrOptions::Method::Bmc}) {
            Certificate certificate;
            PdrOptions options;
            options.method = method;
            options.max_steps = 20;
            options.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
            options.shown = [&](const auto&... run) { add_run(run..., certificate); };
            check_pdr(system, options);
            for (const CertificateSummary::Certified& one : certificate.summary.certified) {
                const auto read = [&](const std::string& end) {
                    return std::ranges::find(certificate.files, certificate::word_of(one.property) + end,
                                             &Certificate::File::path)
                        ->content;
                };
                EXPECT_EQ(run_flaw(read(".model.aag"), read(".cex")), "") << one.property;
                ++runs;
                if (!previous.empty()) {
                    ++other_models;
                    rejected += run_flaw(previous, read(".cex")).empty() ? 0 : 1;
                }
                previous = read(".model.aag");
            }
        }
    }
    EXPECT_GT(runs, test_size(100));
    EXPECT_GT(rejected, other_models / 3);
}

TEST(Certificate, WitnessCircuitsOfRandomSystemsAreInductive) {
    int witnesses = 0;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(100)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TransitionSystem system = random_system(random);
        ask_more(system, random);
        Certificate certificate;
        PdrOptions options;
        options.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
        options.proved = [&](const auto&... invariant) { add_witness(invariant..., {}, certificate); };
        check_pdr(system, options);
        for (const CertificateSummary::Certified& certified : certificate.summary.certified) {
            const std::string& property = certified.property;
            ++witnesses;
            const auto read = [&](const std::string& end) {
                return std::ranges::find(certificate.files, certificate::word_of(property) + end,
                                         &Certificate::File::path)
                    ->content;
            };
            EXPECT_EQ(flaw(read(".model.aag"), read(".witness.aag")), "");
            expect_proofs(read);
        }
        EXPECT_TRUE(certificate.failures.empty());
    }
    EXPECT_GT(witnesses, test_size(100) / 2);
}

/// Random clauses near the threshold of satisfiability: the solver derives clauses that are not given.
TEST(Refutation, ProofsOfRandomClausesAreValid) {
    std::mt19937 random(1);
    int refuted = 0, derived = 0;
    for (int round = 0; round < test_size(200); ++round) {
        const int variables = 4 + round % 25;
        pdr::Clauses clauses{variables, {}};
        for (int k = 0; k < variables * 5; ++k) {
            std::vector<int>& clause = clauses.list.emplace_back();
            for (int i = 0; i < 3; ++i) {
                const int variable = 1 + static_cast<int>(random() % static_cast<unsigned>(variables));
                clause.push_back(random() % 2 == 0 ? variable : -variable);
            }
        }
        if (round % 10 == 0) clauses.list.emplace_back();  // the empty clause
        EXPECT_EQ(read_dimacs(pdr::dimacs(clauses)), clauses.list);
        pdr::LimitMonitor watch({});
        const auto proof = pdr::refutation(clauses, watch);
        CaDiCaL::Solver solver;
        for (const std::vector<int>& clause : clauses.list) {
            for (const int literal : clause) solver.add(literal);
            solver.add(0);
        }
        EXPECT_EQ(proof.has_value(), solver.solve() == 20);
        if (!proof) continue;
        ++refuted;
        derived += static_cast<int>(std::ranges::count(*proof, '\n')) - 1;
        EXPECT_EQ(lrat_flaw(clauses.list, *proof), "") << pdr::dimacs(clauses) << *proof;
    }
    EXPECT_GT(refuted, test_size(200) / 3);
    EXPECT_GT(derived, refuted);
}

TEST(Refutation, ObeysLimits) {
    const std::atomic<bool> stop = true;
    pdr::LimitMonitor watch({.stop = &stop});
    EXPECT_THROW(pdr::refutation({2, {{1, 2}, {1, -2}, {-1, 2}, {-1, -2}}}, watch), pdr::Exhausted);
}

}  // namespace
}  // namespace grafverif::app
