// SPDX-License-Identifier: MIT
// Converts diagnostics for the editor. Positions are in the units of the editor: lines and UTF-16 code units.
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

/// An edit that replaces the text at the position `where`.
struct Edit {
    Place where = {};
    std::string replacement = {};
    auto operator<=>(const Edit&) const = default;
};

struct LspDiagnostic {
    Place where = {};
    Severity severity = Severity::Error;
    std::string code = {}, message = {};
    std::vector<Related> related = {};
    std::optional<Edit> fix = {};
    std::string page = {};  ///< address of the documentation of the code; may be empty
    auto operator<=>(const LspDiagnostic&) const = default;
};

/// Maps spans of `sources` to positions in the editor. A span without position is mapped to the beginning of `main`.
class Places {
public:
    /// `shown` maps the name of a source to the path that the editor displays.
    Places(const Sources& sources, const std::string& main,
           const std::function<std::string(const std::string& path)>& shown);

    Place of(Span where) const;

private:
    std::string main_;
    std::vector<Text> texts_ = {};         ///< text of each source
    std::vector<std::string> paths_ = {};  ///< path of each source
};

/// Converts diagnostics for the editor. A note without position is appended to the message.
std::vector<LspDiagnostic> lsp_diagnostics(const Diagnostics& diagnostics, const Places& places);

}  // namespace grafverif::lsp
