// SPDX-License-Identifier: MIT
// Certificates of timed checks: files from which `grafverif-certify` checks verdicts without the engines
// (docs/how-to/certificates.md).
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
    using Omitted = CertificateSummary::Omitted;
    std::vector<File> files = {};
    std::vector<std::string> certified = {};  ///< names of the properties whose verdicts the files prove
    std::vector<CertificateKind> kinds = {};  ///< for each element of `certified`
    std::vector<Omitted> omitted = {};
    std::vector<std::string> failures = {};  ///< internal errors: verdicts that the repeated search contradicts
};

/// Adds the certificate of an invariant that PDR has found: the circuit with the property `bad`, and its witness
/// circuit as in Certifaiger (Yu, Froleyks, Biere, Heljanko 2023: "Towards compositional hardware model checking
/// certification"), both as AIGER. The witness has the same inputs, latches and gates; its `bad` is also true in all
/// states outside of the invariant. Therefore the property of the witness is inductive and implies the property of the
/// model. The certificate proves three conditions: the invariant contains all initial states (`initial`), no step
/// leaves the invariant (`step`), and the invariant implies the property (`safe`). For each condition, it contains
/// clauses (DIMACS) that are satisfiable only if the condition is violated, and their refutation (LRAT). If a limit is
/// reached, the property is omitted.
void add_witness(const std::string& property, const Circuit& circuit, pdr::Literal bad,
                 const std::vector<pdr::Cube>& cubes, const pdr::SolverLimits& limits, Certificate& certificate);

/// Searches the complete loop again, without decomposition, abstraction and subsumption of states, and creates the
/// certificate of the verdicts in `report`, which `check` returned for the same loop. A verdict that this search does
/// not decide within the limits of `options` is omitted.
Certificate certificate_of(const LoopToCheck& loop, const Report& report, const CheckOptions& options);

}  // namespace grafverif
