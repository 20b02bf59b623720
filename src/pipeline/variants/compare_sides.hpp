// SPDX-License-Identifier: MIT
// CompareSide: one of two sides of a comparison (a chart or a PLC program), with its inputs and outputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "ir/program/scan.hpp"
#include "read/program/program.hpp"
#include "run/lockstep.hpp"
#include "schedule/product.hpp"

namespace grafverif {

struct CompareSide {
    struct Plug {
        std::string name = {};
        Type type = {};
        const Program::Type* program_type = nullptr;  ///< nullptr in a chart
        std::size_t own = 0;                          ///< chart: index among inputs or outputs; program: cell
        Id<Equations::Variable> variable = {};
        Span origin = {};
    };

    std::string name = {};
    std::string label = {};  ///< name in messages; set by match_sides
    Span origin = {};
    std::optional<Chart> chart = {};
    std::optional<Equations> chart_equations = {};
    std::optional<ProgramText> text = {};  ///< of a program
    std::optional<Scan> scan = {};         ///< of a program
    Id<Expr> stop = {};                    ///< only for a program: the program stops if this term is true
    std::optional<std::size_t> stop_cell = {};
    std::vector<Plug> inputs = {}, outputs = {};
    std::vector<Plug> unsupported = {};  ///< outputs of a program whose types are not supported, such as REAL

    bool is_program() const { return scan.has_value(); }
    const Program& program() const { return text->program(); }
    Equations& equations() { return scan ? scan->equations : *chart_equations; }
    const Equations& equations() const { return scan ? scan->equations : *chart_equations; }
    /// Returns this side as an argument for the product. This object must outlive the result.
    ProductSide product() const { return {&equations(), scan ? &*scan : nullptr, stop}; }
};

/// True if the source contains a PLC program in Structured Text or PLCopen XML.
bool contains_program(Id<Source> source, Sources& sources);

CompareSide side_of_chart(Chart chart, Equations equations);
/// Reads a PLC program. The result is empty after an error.
std::optional<CompareSide> side_of_program(Id<Source> source, Sources& sources, Diagnostics& diagnostics);

/// Returns the side for the replay in lockstep. `side` must outlive the result. `sources` is required only for
/// programs.
LockstepSide lockstep_side(const CompareSide& side, bool settles, const Sources* sources);

}  // namespace grafverif
