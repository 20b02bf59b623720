// SPDX-License-Identifier: MIT
// Diagnostics: problems of the input, as data. Each stage appends its problems to a Diagnostics object. `render_text`
// and `render_json` convert diagnostics to text and JSON. The texts of all messages are in support/messages.
#pragma once

#include <cstddef>
#include <functional>
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
    std::string code = {};  ///< stable kebab-case code, printed in brackets

    /// Position of the problem; if `where.source` is invalid, the diagnostic concerns the complete input.
    Span where = {};
    /// The problem, followed by `; ` and the remedy. The text is in lower case, with names in backticks and without a
    /// full stop.
    std::string message = {};
    std::vector<Diagnostic> notes = {};
    std::optional<Fix> fix = {};  ///< present if the remedy is unambiguous
};

/// Collects errors and warnings in the order of their discovery. Stores at most 2 * `limit` diagnostics, and none after
/// more than `limit` distinct errors, so that malicious input uses bounded memory. `errors` counts all errors.
class Diagnostics {
public:
    static constexpr std::size_t limit = 50;
    using Context = std::function<Diagnostic()>;

    /// Adds a diagnostic. A diagnostic with the code, position and text of a stored diagnostic is
    /// counted but not stored. In further copies of a replicated declaration, a diagnostic is not
    /// stored if one with its code and position is already stored.
    void add(Diagnostic diagnostic);
    /// Sets the function that returns a note for each following diagnostic, such as the copy of a replicated
    /// declaration. An empty function adds no note. Returns the previous function.
    Context set_context(Context note);

    bool has_errors() const { return errors_ != 0; }
    std::size_t errors() const { return errors_; }
    /// Number of errors that are not repetitions of stored diagnostics.
    std::size_t distinct_errors() const { return errors_ - repeated_; }
    const std::vector<Diagnostic>& all() const { return stored_; }
    /// True if at least `limit` distinct errors, or many repetitions, were added. Few further errors, or none, are
    /// stored; therefore the caller may stop early or omit suggestions.
    bool full() const { return distinct_errors() >= limit || repeated_ >= 20 * limit; }

private:
    std::vector<Diagnostic> stored_ = {};
    Context context_ = {};
    std::size_t errors_ = 0, repeated_ = 0;
};

enum class Colour { Plain, Ansi };

/// Renders each diagnostic as `file:line:col: error: message [code]` with its source line and a caret, sorted by source
/// and position. A source line with more than 100 columns is shortened to the 100 columns around the caret.
void render_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources, Colour colour, std::ostream& out);

/// Renders diagnostics as a JSON array of
/// `{"file","line","column","end_line","end_column","severity","code","message","notes"}`.
void render_json(const std::vector<Diagnostic>& diagnostics, const Sources& sources, std::ostream& out);

}  // namespace grafverif
