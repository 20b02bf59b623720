// SPDX-License-Identifier: MIT
// CertificateSummary: the verdicts that a certificate proves, and the type of each proof (docs/how-to/certificates.md).
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

/// The type of the object that proves a verdict. Fragment, Subsystems: states of a fragment, or of each independent
/// subsystem, of the network. WitnessCircuit: the circuit of an inductive invariant of an untimed model.
enum class CertificateKind : std::uint8_t { States, Fragment, Subsystems, Run, WitnessCircuit };

constexpr std::string_view word(CertificateKind kind) {
    switch (kind) {
    case CertificateKind::States: return "set of states";
    case CertificateKind::Fragment: return "set of states of a fragment";
    case CertificateKind::Subsystems: return "sets of states of subsystems";
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
    /// A property whose verdict the files prove.
    struct Certified {
        std::string property = {};
        CertificateKind kind = CertificateKind::States;
    };
    std::string folder = {};  ///< the folder that contains the files of the certificate
    std::vector<Certified> certified = {};
    std::vector<Omitted> omitted = {};

    /// True if `property` is certified or omitted.
    bool contains(std::string_view property) const {
        return std::ranges::find(certified, property, &Certified::property) != certified.end() ||
               std::ranges::find(omitted, property, &Omitted::property) != omitted.end();
    }
};

}  // namespace grafverif
