// SPDX-License-Identifier: MIT
// Certificates of checks: files from which other programs check verdicts without the engines
// (docs/how-to/certificates.md). `grafverif-certify` checks timed verdicts; programs for AIGER check untimed verdicts.
#pragma once

#include <string>
#include <vector>

#include "ir/certificate_summary.hpp"
#include "pipeline/check.hpp"

namespace grafverif {

struct Certificate {
    struct File {
        std::string path = {};  ///< path relative to the folder of the certificate
        std::string content = {};
    };
    CertificateSummary summary = {};
    std::vector<File> files = {};
    std::vector<std::string> failures = {};  ///< internal errors: verdicts of `report` that this search contradicts
};

/// Adds the certificate of an invariant that PDR has found: the circuit with the property `bad`, and its witness
/// circuit as in Certifaiger (Yu, Froleyks, Biere, Heljanko 2023: "Towards compositional hardware model checking
/// certification"), both as AIGER. The witness has the same inputs, latches and gates; its `bad` is also true in all
/// states outside of the invariant. Therefore the property of the witness is inductive and implies the property of the
/// model. The certificate proves three conditions: the invariant contains all initial states (`initial`), no step
/// leaves the invariant (`step`), and the invariant implies the property (`safe`). For each condition, the certificate
/// contains clauses (DIMACS) that are satisfiable only if the condition is violated, and their refutation (LRAT). If a
/// limit is reached, the property is omitted.
void add_witness(const std::string& property, const Circuit& circuit, pdr::Literal bad,
                 const std::vector<pdr::Cube>& cubes, const pdr::SolverLimits& limits, Certificate& certificate);

/// Adds the certificate of a run of the circuit to a state in which `bad` is true: the circuit as AIGER, and the run as
/// AIGER witness. `inputs` are the values of the inputs in each state.
void add_run(const std::string& property, const Circuit& circuit, pdr::Literal bad,
             const std::vector<std::vector<bool>>& inputs, Certificate& certificate);

/// Adds certificates of the verdicts in `report` about single states that `certificate` does not contain. PDR and BMC
/// decide these properties again, for at most a minute. All other verdicts are omitted.
void certify_again(const SystemToCheck& check, const Report& report, const CheckOptions& options,
                   Certificate& certificate);

/// Searches the complete loop again, without decomposition, abstractions and covering, and creates the certificate of
/// the verdicts in `report`, which `check` returned for the same loop. A verdict that this search does not decide
/// within the limits of `options` is omitted.
Certificate certificate_of(const LoopToCheck& loop, const Report& report, const CheckOptions& options);

}  // namespace grafverif
