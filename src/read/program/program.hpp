// SPDX-License-Identifier: MIT
// read_program: reads Structured Text of IEC 61131-3 (programs, function blocks, functions, types, a configuration) to
// a Program. Names are resolved without regard to case, and types are checked. A construct that Program does not
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

/// A program together with its names, which permits reading further expressions over its variables.
class ProgramText {
public:
    ProgramText();
    ProgramText(ProgramText&&) noexcept;
    ProgramText& operator=(ProgramText&&) noexcept;
    ~ProgramText();

    const Program& program() const;
    /// Reads a Boolean expression over the variables of the program, with the operators of Structured Text or of C. The
    /// expression is added to the nodes of the program. The result is empty after an error.
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

/// Reads a program; empty after at least one error. The source of the standard function blocks is added to `sources`.
/// The declarations and references are added to `record`, also those of a text with errors.
std::optional<ProgramText> read_program(Id<Source> source, Sources& sources, Diagnostics& diagnostics,
                                        const Recorder& record = {});

}  // namespace grafverif
