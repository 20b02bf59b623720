// SPDX-License-Identifier: MIT
// proved_structured_text: writes a chart as Structured Text, reads the text as a PLC program, and compares this program
// with the chart.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "emit/structured_text/structured_text.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif {

/// Last value that is tried for the maximum number of evolutions if ProofOptions::max_evolutions is empty.
inline constexpr std::uint32_t most_proved_evolutions = 128;

struct ProofOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    structured_text::Form form = structured_text::Form::PlcopenXml;
    structured_text::Dialect dialect = structured_text::Dialect::Iec;  ///< Iec or Codesys, which grafverif can read

    /// Maximum number of evolutions per cycle. If this member is empty, the numbers 8, 16, ..., most_proved_evolutions
    /// are tried. The search ends at the first number for which the program completes every cycle that the chart
    /// completes.
    std::optional<std::uint32_t> max_evolutions = {};
    /// The time between two scans is a multiple of this value; if empty, a multiple of 1 ms.
    std::optional<std::int64_t> resolution_ms = {};
    Limits limits = {};
};

struct ProvedText {
    std::string text = {};
    std::uint32_t max_evolutions = 0;  ///< the maximum number of evolutions in `text`

    /// The chart (a) and the program (b); `text` is proved if and only if the comparison is Equal.
    Comparison comparison = {};
};

/// Returns Structured Text for the chart, and the result of the comparison of exactly this text with the chart. The
/// program stops in the scan in which its output FAULT is not zero. The function adds the text to `sources`, because
/// diagnostics can refer to it. The result is empty after an error: the chart cannot be expressed, or the text cannot
/// be read as a program or compared.
std::optional<ProvedText> proved_structured_text(const Model& model, Id<Chart> chart, const ProofOptions& options,
                                                 Sources& sources, Diagnostics& diagnostics);

/// Compares a Structured Text with the chart that it implements. `equations` are the equations of the chart; they
/// determine the names in the text. With a resolution, the result is Equal only if all durations of the program are
/// multiples of the resolution.
std::optional<Comparison> compare_with_text(const Model& model, Id<Chart> chart, const Equations& equations,
                                            const std::string& text, const ProofOptions& options, Sources& sources,
                                            Diagnostics& diagnostics);

}  // namespace grafverif
