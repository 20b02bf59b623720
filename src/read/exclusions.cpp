// SPDX-License-Identifier: MIT
#include "read/exclusions.hpp"

#include "read/csv.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

/// Returns the Boolean input with the name in `field`, or an invalid id after an error.
Id<Chart::Variable> input(const CsvField& field, const Chart& chart, Diagnostics& diagnostics) {
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        const Chart::Variable& variable = chart.variables[id];
        if (variable.name != field.text) continue;
        if (variable.kind == Chart::VariableKind::Input && variable.type.boolean) return id;
    }
    diagnostics.add(messages::not_a_boolean_input(field.where, field.text, chart.name));
    return {};
}

bool is_header(const CsvRow& fields) {
    return fields.size() == 3 && fields[0].text == "variable1" && fields[1].text == "variable2" &&
           fields[2].text == "reason";
}

}  // namespace

std::optional<std::vector<ExclusionRow>> read_exclusions(Id<Source> file, const Sources& sources, const Chart& chart,
                                                         Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    std::vector<ExclusionRow> rows;
    CsvRows table(file, sources, '#', diagnostics);
    CsvRow fields;
    if (table.next(fields) && !is_header(fields)) {
        diagnostics.add(messages::bad_exclusion_header(fields[0].where));
        return {};
    }
    while (!diagnostics.full() && table.next(fields)) {
        if (fields.size() != 3) {
            diagnostics.add(messages::bad_exclusion(fields[0].where, fields.size()));
            continue;
        }
        const auto first = input(fields[0], chart, diagnostics), second = input(fields[1], chart, diagnostics);
        if (first.valid() && first == second)
            diagnostics.add(messages::excludes_itself(fields[1].where, fields[1].text));
        rows.push_back({first, second, fields[2].text, fields[0].where});
    }
    if (diagnostics.errors() != errors) return {};
    return rows;
}

}  // namespace grafverif
