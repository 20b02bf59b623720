// SPDX-License-Identifier: MIT
// listing_of: determines the statements of a PLC program as lines of text, and the values in each line.
//
// The lines are the lines of the source file. The statements of a program in PLCopen XML are printed in Structured
// Text, in the order of the bodies of its units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/support/source.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

struct ProgramListing {
    enum class Role : std::uint8_t {
        Read,       ///< a variable that the line reads
        Condition,  ///< a condition of a branch, loop or transition, or the selector of CASE
        Result,     ///< an assigned variable
        Executed,   ///< a statement that computes no value
    };
    /// A value in a line. The values of a line are in the order of their evaluation.
    struct Item {
        Role role = Role::Read;
        std::uint32_t line = 0;  ///< line number, counted from 0
        std::string name = {};   ///< name of the variable; empty for the roles Condition and Executed
        Id<Program::Type> type = {};
        Id<Program::Unit> unit = {};  ///< the unit that owns the frame of the statement
    };

    std::vector<std::string> lines = {};
    std::vector<std::uint32_t> begins = {};  ///< offset of each line in the source file; empty if the lines are printed
    std::vector<Item> items = {};
    /// For each statement (`of_statements`) and each node (`of_nodes`) of the program: the index of its item, or
    /// nothing if there is no item for it.
    std::vector<std::optional<std::size_t>> of_statements = {}, of_nodes = {};
};

ProgramListing listing_of(const Program& program, const Sources& sources);

/// Returns the line of a position in the source file, or nothing if the lines are printed.
std::optional<std::uint32_t> line_of(const ProgramListing& listing, Span where);

}  // namespace grafverif
