// SPDX-License-Identifier: MIT
// Diagnostics: problems of the input, as data. Each stage adds to the sink that it receives; one renderer converts them
// to text, one to JSON. The texts of all messages are in support/messages.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/support/source.hpp"

namespace grafverif {

enum class Severity { Error, Warning, Note };

/// A fix that a program can apply: `replacement` replaces the text of the span.
struct Fix {
    Span where = {};
    std::string replacement = {};
};

struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code = {};     ///< stable kebab-case word, shown in brackets
    Span where = {};           ///< no valid source: concerns the input in general
    std::string message = {};  ///< lower case, names in backticks, no full stop; the problem, then `; ` and the remedy
    std::vector<Diagnostic> notes = {};
    std::optional<Fix> fix = {};  ///< if the remedy is unambiguous
};

/// The sink: errors and warnings in the order of their discovery. After `limit` errors it keeps counting but stores no
/// more, so that a hostile input uses bounded memory.
class Diagnostics {
public:
    static constexpr std::size_t limit = 50;

    void add(Diagnostic diagnostic);

    bool has_errors() const { return errors_ != 0; }
    std::size_t errors() const { return errors_; }
    const std::vector<Diagnostic>& all() const { return stored_; }
    /// True if errors beyond `limit` were dropped; a reader may then stop early.
    bool full() const { return errors_ >= limit; }

private:
    std::vector<Diagnostic> stored_ = {};
    std::size_t errors_ = 0;
};

enum class Colour { Plain, Ansi };

/// `file:line:col: error: message [code]`, the source line and a caret, for each diagnostic, sorted by source and
/// position; the source line is clipped at 100 columns around the caret.
void render_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources, Colour colour, std::ostream& out);

/// The same as a JSON array of `{"file","line","column","end_line","end_column","severity","code","message","notes"}`.
void render_json(const std::vector<Diagnostic>& diagnostics, const Sources& sources, std::ostream& out);

}  // namespace grafverif
