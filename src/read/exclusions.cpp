// SPDX-License-Identifier: MIT
#include "grafverif/read/exclusions.hpp"

#include <string_view>

#include "grafverif/support/messages.hpp"

namespace grafverif {

namespace {

struct Field {
    std::string text = {};
    Span where = {};
};

/// Rows of a table in CSV, one after the other.
class CsvTable {
public:
    CsvTable(const Source& source, Id<Source> id) : text_(source.text), id_(id) {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    }

    bool at_end() const { return at_ >= text_.size(); }

    std::vector<Field> row() {
        std::vector<Field> fields{field()};
        while (at_ < text_.size() && text_[at_] == ',') {
            ++at_;
            fields.push_back(field());
        }
        if (at_ < text_.size() && text_[at_] == '\r') ++at_;
        if (at_ < text_.size() && text_[at_] == '\n') ++at_;
        return fields;
    }

private:
    Field field() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
        const std::size_t begin = at_;
        Field made;
        if (at_ < text_.size() && text_[at_] == '"') made.text = quoted();
        std::size_t end = at_;
        for (; at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\r' && text_[at_] != '\n'; ++at_) {
            made.text += text_[at_];
            if (text_[at_] != ' ' && text_[at_] != '\t') end = at_ + 1;
        }
        while (!made.text.empty() && (made.text.back() == ' ' || made.text.back() == '\t')) made.text.pop_back();
        made.where = {id_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        return made;
    }

    std::string quoted() {
        std::string inside;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] != '"') inside += text_[at_];
            else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') inside += text_[at_++];
            else break;
        }
        if (at_ < text_.size()) ++at_;
        return inside;
    }

    std::string_view text_;
    Id<Source> id_;
    std::size_t at_ = 0;
};

/// The Boolean input that `field` names; not valid after an error.
Id<Chart::Variable> input(const Field& field, const Chart& chart, Diagnostics& diagnostics) {
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        const Chart::Variable& variable = chart.variables[id];
        if (variable.name != field.text) continue;
        if (variable.kind == Chart::VariableKind::Input && variable.type.boolean) return id;
    }
    diagnostics.add(messages::not_a_boolean_input(field.where, field.text, chart.name));
    return {};
}

bool is_header(const std::vector<Field>& fields) {
    return fields.size() == 3 && fields[0].text == "variable1" && fields[1].text == "variable2" && fields[2].text == "reason";
}

}  // namespace

std::optional<std::vector<ExclusionRow>> read_exclusions(const Source& source, Id<Source> id, const Chart& chart,
                                                         Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    std::vector<ExclusionRow> rows;
    CsvTable table(source, id);
    bool header = true;
    while (!table.at_end() && !diagnostics.full()) {
        const std::vector<Field> fields = table.row();
        const bool blank = fields.size() == 1 && fields[0].text.empty();
        if (blank || fields[0].text.starts_with('#')) continue;
        if (header) {
            header = false;
            if (is_header(fields)) continue;
            diagnostics.add(messages::bad_exclusion_header(fields[0].where));
            return {};
        }
        if (fields.size() != 3) {
            diagnostics.add(messages::bad_exclusion(fields[0].where, fields.size()));
            continue;
        }
        const auto first = input(fields[0], chart, diagnostics), second = input(fields[1], chart, diagnostics);
        if (first.valid() && first == second) diagnostics.add(messages::excludes_itself(fields[1].where, fields[1].text));
        rows.push_back({first, second, fields[2].text, fields[0].where});
    }
    if (diagnostics.errors() != errors) return {};
    return rows;
}

}  // namespace grafverif
