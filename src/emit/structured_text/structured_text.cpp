// SPDX-License-Identifier: MIT
// Writes a controller in Structured Text: its declarations and its body.
#include "emit/structured_text/structured_text.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "emit/structured_text/body.hpp"
#include "emit/structured_text/unit.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"

namespace grafverif::structured_text {

namespace {

using controller::Cell;
using controller::Code;
using controller::Timer;
using controller::Word;

const char* type_word(Word word) {
    switch (word) {
    case Word::Bool: return "BOOL";
    case Word::Int16: return "INT";
    case Word::Int32: return "DINT";
    case Word::Unsigned32: return "UDINT";
    }
    unreachable();
}

std::string initial_text(const Cell& cell) {
    if (!cell.initialized) return {};
    if (cell.word == Word::Bool) return cell.initial != 0 ? "TRUE" : "FALSE";
    return std::to_string(cell.initial);
}

std::vector<UnitVariable> variables_of(const Code& code, const DialectRow& dialect) {
    std::vector<UnitVariable> made;
    for (const auto& declaration : code.declarations) {
        if (const auto* id = std::get_if<Id<Timer>>(&declaration)) {
            const Timer& timer = code.timers[*id];
            const std::string_view type = timer.off_delay ? dialect.off_delay : dialect.on_delay;
            made.push_back({Section::Local, timer.name, std::string(type), true, "", ""});
            continue;
        }
        const Cell& cell = code.cells[std::get<Id<Cell>>(declaration)];
        made.push_back({cell.section, cell.name, type_word(cell.word), false, initial_text(cell), cell.comment});
    }
    return made;
}

}  // namespace

bool expressible(const Equations& equations, Diagnostics& diagnostics) {
    return controller::expressible(equations, messages::not_in_structured_text, diagnostics);
}

void emit(const Equations& equations, const Options& options, std::ostream& out) {
    const DialectRow& dialect = row_of(options.dialect);
    const Code code = controller::code_of(equations, {options.mode, options.max_evolutions}, Target::StructuredText,
                                          dialect.reserved);
    print({false, code.name, code.comment, variables_of(code, dialect), body_of(code, dialect)}, options.form, dialect,
          out);
}

}  // namespace grafverif::structured_text
