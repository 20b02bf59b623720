// SPDX-License-Identifier: MIT
// CertificateSummary: the verdicts that a certificate proves, and the type of each proof (docs/how-to/certificates.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

/// Type of a proof of a verdict. States: an inductive set of states. Run: one run. WitnessCircuit: the circuit of an
/// inductive invariant of an untimed model.
enum class CertificateKind : std::uint8_t { States, Run, WitnessCircuit };

constexpr std::string_view word(CertificateKind kind) {
    switch (kind) {
    case CertificateKind::States: return "set of states";
    case CertificateKind::Run: return "run";
    case CertificateKind::WitnessCircuit: break;
    }
    return "witness circuit";
}

struct CertificateSummary {
    /// A verdict that the certificate does not prove, with the reason.
    struct Omitted {
        std::string property = {}, reason = {};
    };
    std::string folder = {};                  ///< folder that contains the files of the certificate
    std::vector<std::string> certified = {};  ///< names of the properties whose verdicts the files prove
    std::vector<CertificateKind> kinds = {};  ///< type of proof for each element of `certified`
    std::vector<Omitted> omitted = {};
};

}  // namespace grafverif
