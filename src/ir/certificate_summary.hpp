// SPDX-License-Identifier: MIT
// CertificateSummary: the verdicts that a certificate proves (docs/how-to/certificates.md).
#pragma once

#include <string>
#include <vector>

namespace grafverif {

struct CertificateSummary {
    /// A verdict that the certificate does not prove, with the reason.
    struct Omitted {
        std::string property = {}, reason = {};
    };
    std::string folder = {};                  ///< the folder of the files
    std::vector<std::string> certified = {};  ///< names of the properties whose verdicts the files prove
    std::vector<Omitted> omitted = {};
};

}  // namespace grafverif
