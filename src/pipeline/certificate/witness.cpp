// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

#include "check/pdr/check.hpp"
#include "check/pdr/refutation.hpp"
#include "emit/aiger/aiger.hpp"
#include "emit/certificate/certificate.hpp"
#include "pipeline/certificate/certificate.hpp"
#include "pipeline/models.hpp"

namespace grafverif {

namespace {

/// The witness circuit of an invariant, and the conditions that the invariant satisfies. The clauses of a condition are
/// unsatisfiable if and only if the condition is satisfied. The AIGER files determine the clauses: variable 1 of the
/// clauses is false, and variable 1 + v + kM represents variable v of the witness in step k. M is the greatest variable
/// of the witness.
class Witness {
public:
    Witness(const std::string& property, const Circuit& circuit, pdr::Literal bad, const std::vector<pdr::Cube>& cubes)
        : circuit_(circuit), bad_(bad), outside_(bad) {
        for (const pdr::Cube& cube : cubes) {
            pdr::Literal inside = Gates::yes;
            for (const pdr::Literal literal : cube) inside = circuit_.gates.both(inside, literal);
            outside_ = circuit_.gates.either(outside_, inside);
        }
        model_ = written(circuit, property, bad).text;
        witness_ = written(circuit_, property, outside_);
        for (const pdr::Literal literal : witness_.literals) most_ = std::max(most_, static_cast<int>(literal / 2));
    }

    const std::string& model() const { return model_; }
    const std::string& text() const { return witness_.text; }

    /// Returns the clauses for the condition that all initial states are in the invariant.
    pdr::Clauses initial() const {
        pdr::Clauses made = steps(1);
        for (const Circuit::Latch& latch : circuit_.latches) made.list.push_back({-of(2 * latch.node, 0)});
        made.list.push_back({of(outside_, 0)});
        return made;
    }
    /// Returns the clauses for the condition that no step leaves the invariant.
    pdr::Clauses step() const {
        pdr::Clauses made = steps(2);
        for (const Circuit::Latch& latch : circuit_.latches) {
            const int now = of(latch.next, 0), next = of(2 * latch.node, 1);
            made.list.push_back({-now, next});
            made.list.push_back({now, -next});
        }
        made.list.push_back({-of(outside_, 0)});
        made.list.push_back({of(outside_, 1)});
        return made;
    }
    /// Returns the clauses for the condition that each state of the invariant satisfies the property.
    pdr::Clauses safe() const {
        pdr::Clauses made = steps(1);
        made.list.push_back({-of(outside_, 0)});
        made.list.push_back({of(bad_, 0)});
        return made;
    }

private:
    static aiger::AigerText written(const Circuit& circuit, const std::string& property, pdr::Literal bad) {
        return aiger::written(circuit, {{property, bad, {}}}, aiger::Form::Ascii, aiger::Extent::Whole);
    }

    int of(pdr::Literal literal, int step) const {
        const pdr::Literal in_file = witness_.literals[node_of(literal)] ^ (literal & 1U);
        const int variable = in_file < 2 ? 1 : 1 + static_cast<int>(in_file / 2) + most_ * step;
        return (in_file & 1U) != 0 ? -variable : variable;
    }

    /// Returns the clauses that define the gates of the witness in `count` consecutive steps.
    pdr::Clauses steps(int count) const {
        pdr::Clauses made{1 + most_ * count, {{-1}}};
        for (int step = 0; step < count; ++step)
            for (std::uint32_t node = 1; node < circuit_.gates.size(); ++node) {
                if (!circuit_.gates.is_gate(node)) continue;
                const Gates::Node gate = circuit_.gates[node];
                const int out = of(2 * node, step), left = of(gate.left, step), right = of(gate.right, step);
                for (std::vector<int> clause : {std::vector{-out, left}, {-out, right}, {out, -left, -right}})
                    made.list.push_back(std::move(clause));
            }
        return made;
    }

    Circuit circuit_;
    pdr::Literal bad_, outside_;
    std::string model_ = {};
    aiger::AigerText witness_ = {};
    int most_ = 0;
};

}  // namespace

void add_witness(const std::string& property, const Circuit& circuit, pdr::Literal bad,
                 const std::vector<pdr::Cube>& cubes, const pdr::SolverLimits& limits, Certificate& certificate) {
    const Witness witness(property, circuit, bad, cubes);
    const std::string name = certificate::word_of(property);
    std::vector<Certificate::File> files{{name + ".model.aag", witness.model()},
                                         {name + ".witness.aag", witness.text()}};
    try {
        pdr::LimitMonitor watch(limits);
        for (const auto& [condition, clauses] :
             {std::pair{"initial", witness.initial()}, std::pair{"step", witness.step()},
              std::pair{"safe", witness.safe()}}) {
            std::optional<std::string> proof = pdr::refutation(clauses, watch);
            if (!proof) {
                certificate.failures.push_back("the invariant of `" + property + "` is wrong");
                return;
            }
            files.push_back({name + '.' + condition + ".cnf", pdr::dimacs(clauses)});
            files.push_back({name + '.' + condition + ".lrat", std::move(*proof)});
        }
    } catch (const pdr::Exhausted&) {
        certificate.summary.omitted.push_back({property, "a limit ended the proof of its invariant"});
        return;
    } catch (const std::logic_error& flaw) {
        certificate.summary.omitted.push_back(
            {property, std::string("the solver's proof is not accepted: ") + flaw.what()});
        return;
    }
    certificate.files.insert(certificate.files.end(), files.begin(), files.end());
    certificate.summary.certified.push_back({property, CertificateKind::WitnessCircuit});
}

void add_run(const std::string& property, const Circuit& circuit, pdr::Literal bad,
             const std::vector<std::vector<bool>>& inputs, Certificate& certificate) {
    Circuit whole = circuit;
    // Without inputs, each line of the witness would be empty, so the number of states would be unclear.
    if (whole.inputs.empty()) whole.inputs.push_back({node_of(whole.gates.source()), "none"});
    aiger::AigerText model = aiger::written(whole, {{property, bad, {}}}, aiger::Form::Ascii, aiger::Extent::Whole);
    std::string run = "1\nb0\n" + std::string(model.latches.size(), '0') + '\n';
    for (const std::vector<bool>& state : inputs) {
        for (const std::size_t input : model.inputs) run += input < state.size() && state[input] ? '1' : '0';
        run += '\n';
    }
    const std::string name = certificate::word_of(property);
    certificate.files.push_back({name + ".model.aag", std::move(model.text)});
    certificate.files.push_back({name + ".cex", run + ".\n"});
    certificate.summary.certified.push_back({property, CertificateKind::Run});
}

void certify_again(const SystemToCheck& check, const Report& report, const CheckOptions& options,
                   Certificate& certificate) {
    CertificateSummary& summary = certificate.summary;
    PdrOptions search;
    for (const PropertyResult& answer : report.answers)
        if (const std::string& name = answer.verdict.property;
            answer.verdict.outcome != Outcome::Unknown && !summary.contains(name) &&
            std::ranges::find(check.system.properties, name, &Property::name) != check.system.properties.end())
            search.properties.push_back(name);
    set_limits(search, options.limits);
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    search.deadline = std::min(search.deadline.value_or(end), end);
    search.method = PdrOptions::Method::Alternating;
    const pdr::SolverLimits limits{search.max_memory, search.deadline, search.stop};
    search.proved = [&](const auto&... invariant) { add_witness(invariant..., limits, certificate); };
    search.shown = [&](const auto&... run) { add_run(run..., certificate); };
    PdrResult found;
    if (!search.properties.empty()) found = check_pdr(check.system, search);
    for (const PropertyResult& answer : report.answers) {
        const Verdict& verdict = answer.verdict;
        const auto again = std::ranges::find(found.verdicts, verdict.property, &Verdict::property);
        if (again != found.verdicts.end() && again->outcome != Outcome::Unknown && again->outcome != verdict.outcome)
            certificate.failures.push_back("PDR and BMC contradict the verdict on `" + verdict.property + "`");
        if (summary.contains(verdict.property)) continue;
        summary.omitted.push_back({verdict.property, verdict.outcome == Outcome::Unknown
                                                         ? "the verdict is unknown"
                                                         : "neither an invariant nor a run proves the verdict"});
    }
}

}  // namespace grafverif
