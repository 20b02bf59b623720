// SPDX-License-Identifier: MIT
// read_program: reads Structured Text of IEC 61131-3 (programs, function blocks, functions, types, a configuration) to
// a Program. Names are resolved without regard to case, and types are checked. A construct that a Program cannot
// represent exactly is an error. All errors of a file are reported together.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "ir/program/program.hpp"
#include "syntax/resolve/references.hpp"
#include "syntax/st/parse_st.hpp"

namespace grafverif {

/// A program together with its symbol tables, so that further expressions over its variables can be read.
class ProgramText {
public:
    ProgramText();
    ProgramText(ProgramText&&) noexcept;
    ProgramText& operator=(ProgramText&&) noexcept;
    ~ProgramText();

    const Program& program() const;
    /// Reads a Boolean expression over the variables of the program, with the operators of Structured Text or of C. The
    /// nodes of the expression are added to the program. The result is empty after an error.
    std::optional<Id<Program::Node>> condition(const st::Text& text, const Sources& sources, Diagnostics& diagnostics);

    struct Inside;

private:
    friend std::optional<ProgramText> read_program(Id<Source> source, Sources& sources, Diagnostics& diagnostics,
                                                   const Recorder& record);
    std::unique_ptr<Inside> inside_;
};

/// Name of the source of the standard function blocks.
inline constexpr std::string_view standard_blocks_path = "<library>/standard_blocks.st";
/// Returns the text of the standard function blocks.
std::string_view standard_blocks_text();

/// Reads a program. The result is empty after at least one error. Adds the source of the standard function blocks to
/// `sources`. Adds the declarations and references to `record`, even if the text has errors.
std::optional<ProgramText> read_program(Id<Source> source, Sources& sources, Diagnostics& diagnostics,
                                        const Recorder& record = {});

}  // namespace grafverif
