// SPDX-License-Identifier: MIT
// What is told about places of texts: diagnostics as the editor shows them, with their places in its units.
#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "lsp/text.hpp"

namespace grafverif::lsp {

struct Place {
    std::string path = {};
    Range range = {};
    auto operator<=>(const Place&) const = default;
};

struct Related {
    Place where = {};
    std::string message = {};
    auto operator<=>(const Related&) const = default;
};

/// Replaces what stands at the place.
struct Edit {
    Place where = {};
    std::string replacement = {};
    auto operator<=>(const Edit&) const = default;
};

struct Told {
    Place where = {};
    Severity severity = Severity::Error;
    std::string code = {}, message = {};
    std::vector<Related> related = {};
    std::optional<Edit> fix = {};
    auto operator<=>(const Told&) const = default;
};

/// Where spans of `sources` are; what has no place is at the beginning of `main`.
class Places {
public:
    /// `shown`: what a file is called here, of what its source is.
    Places(const Sources& sources, const std::string& main,
           const std::function<std::string(const std::string& path)>& shown);

    Place of(Span where) const;

private:
    std::string main_;
    std::vector<Text> texts_ = {};         ///< per source
    std::vector<std::string> paths_ = {};  ///< likewise
};

/// What the diagnostics say. A note without a place is put behind the message.
std::vector<Told> told(const Diagnostics& diagnostics, const Places& places);

}  // namespace grafverif::lsp
