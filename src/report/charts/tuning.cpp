// SPDX-License-Identifier: MIT
#include "report/charts/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <ostream>
#include <set>
#include <utility>

#include "report/json_place.hpp"
#include "report/settings_text.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"
#include "syntax/print/constants.hpp"

namespace grafverif {

namespace {

using Row = Tuning::Row;
using Indices = std::vector<std::size_t>;
using Json = nlohmann::ordered_json;

char symbol(const PointVerdict& verdict) {
    if (verdict.outcome == Outcome::Unknown) return '?';
    return verdict.outcome == Outcome::Holds ? '+' : '-';
}

void print_boxes(const Tuning& tuning, const Row& row, std::ostream& out) {
    std::vector<std::vector<std::string>> lines;
    std::vector<std::size_t> widths(tuning.constants.size());
    const auto add = [&](std::vector<std::string> cells) {
        for (std::size_t k = 0; k < widths.size(); ++k) widths[k] = std::max(widths[k], columns_of(cells[k]));
        lines.push_back(std::move(cells));
    };
    std::vector<std::string> heading;
    for (const TunedConstant& constant : tuning.constants) heading.push_back(printable(constant.name));
    heading.emplace_back("verdict");
    add(std::move(heading));
    for (const GridBox& box : boxes_of(tuning, row)) {
        std::vector<std::string> cells;
        for (std::size_t k = 0; k < tuning.constants.size(); ++k)
            cells.push_back(range_text(tuning.constants[k], box.first[k], box.last[k]));
        cells.push_back(verdict_text(tuning, row.verdicts[tuning.point(box.first)]));
        add(std::move(cells));
    }
    for (const std::vector<std::string>& cells : lines) {
        out << "    ";
        for (std::size_t k = 0; k < widths.size(); ++k) out << padded(cells[k], widths[k]) << "  ";
        out << cells.back() << '\n';
    }
}

/// Prints the map of a property: one line per value of the first constant, and one column per value of the second
/// constant. The point with the current values is in brackets.
void print_map(const Tuning& tuning, const Row& row, std::ostream& out) {
    const TunedConstant &down = tuning.constants[0], &across = tuning.constants[1];
    const auto here_down = down.current_index(), here_across = across.current_index();
    std::size_t width = columns_of(printable(down.name));
    for (std::size_t k = 0; k < down.size(); ++k) width = std::max(width, value_text(down, down.value(k)).size());
    out << fmt::format("    {}  {} = {}\n", padded(printable(down.name), width), printable(across.name),
                       range_text(across, 0, across.size() - 1));
    for (std::size_t line = 0; line < down.size(); ++line) {
        std::string text = fmt::format("    {:>{}} ", value_text(down, down.value(line)), width);
        for (std::size_t column = 0; column <= across.size(); ++column) {
            const bool is_line = here_down == line && here_across.has_value();
            text += is_line && here_across == column ? '[' : is_line && *here_across + 1 == column ? ']' : ' ';
            if (column < across.size()) text += symbol(row.verdicts[tuning.point({line, column})]);
        }
        out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
    }
}

/// Prints the reasons of the unknown verdicts of a map. The map itself has only one character per point.
void print_reasons(const Tuning& tuning, const Row& row, std::ostream& out) {
    std::set<std::uint32_t> reasons;
    for (const PointVerdict& each : row.verdicts)
        if (each.outcome == Outcome::Unknown) reasons.insert(each.reason);
    for (const std::uint32_t reason : reasons)
        out << fmt::format("    unknown: {}\n", printable(tuning.reasons[reason]));
}

void print_row(const Tuning& tuning, const Row& row, bool map, std::ostream& out) {
    out << fmt::format("\n{}{}: ", printable(row.property), row.text.empty() ? "" : " \"" + printable(row.text) + '"');
    if (is_uniform(row)) {
        const std::string all = tuning.points == 1 ? "the point" : fmt::format("all {} points", tuning.points);
        out << fmt::format("{} at {}", word(row.verdicts.front().outcome), all);
        if (row.verdicts.front().outcome == Outcome::Unknown)
            out << ": " << printable(tuning.reasons[row.verdicts.front().reason]);
        out << '\n';
    } else {
        const auto holds = std::ranges::count(row.verdicts, Outcome::Holds, &PointVerdict::outcome);
        out << fmt::format("holds at {} of {} points\n", holds, tuning.points);
        if (map) {
            print_map(tuning, row, out);
            print_reasons(tuning, row, out);
        } else {
            print_boxes(tuning, row, out);
        }
    }
    for (const std::string& sentence : margin_sentences(tuning, row)) out << "    " << sentence << '\n';
}

}  // namespace

std::string value_text(const TunedConstant& constant, std::int64_t value) {
    return value_text(NamedConstant{.name = constant.name, .kind = constant.kind, .value = value});
}

std::string grid_text(const TunedConstant& constant) {
    return fmt::format("{} = {} in steps of {}; current value {}", printable(constant.name),
                       range_text(constant, 0, constant.size() - 1), value_text(constant, constant.step),
                       value_text(constant, constant.current));
}

std::string range_text(const TunedConstant& constant, std::size_t first, std::size_t last) {
    const std::string low = value_text(constant, constant.value(first));
    return first == last ? low : low + ".." + value_text(constant, constant.value(last));
}

bool is_uniform(const Row& row) {
    return std::ranges::all_of(row.verdicts, [&](const PointVerdict& each) { return each == row.verdicts.front(); });
}

std::string verdict_text(const Tuning& tuning, const PointVerdict& verdict) {
    const std::string text(word(verdict.outcome));
    return verdict.outcome == Outcome::Unknown ? text + ": " + printable(tuning.reasons[verdict.reason]) : text;
}

bool is_shown(const Tuning& tuning, const Row& row) {
    return row.declared || std::ranges::any_of(row.verdicts, [&](const PointVerdict& each) {
               return each.outcome == Outcome::Violated ||
                      (tuning.model_error && each.outcome == Outcome::Unknown && each.reason > 0);
           });
}

std::vector<std::string> margin_sentences(const Tuning& tuning, const Row& row) {
    std::vector<std::string> sentences;
    for (const Margin& margin : margins_of(tuning, row)) {
        const TunedConstant& constant = tuning.constants[margin.constant];
        sentences.push_back(fmt::format("{} at {} = {}, {} {} the current value {}", word(margin.verdict.outcome),
                                        printable(constant.name), value_text(constant, margin.value),
                                        value_text(constant, margin.distance), margin.up ? "above" : "below",
                                        value_text(constant, constant.current)));
    }
    return sentences;
}

std::string point_text(const Tuning& tuning, std::size_t point) {
    const Indices indices = tuning.indices(point);
    std::string text;
    for (std::size_t k = 0; k < indices.size(); ++k)
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", tuning.constants[k].name,
                            value_text(tuning.constants[k], tuning.constants[k].value(indices[k])));
    return text;
}

std::vector<GridBox> boxes_of(const Tuning& tuning, const Row& row) {
    std::vector<GridBox> boxes;
    std::vector<bool> covered(tuning.points);
    for (std::size_t point = 0; point < tuning.points; ++point) {
        if (covered[point]) continue;
        const Indices start = tuning.indices(point);
        GridBox box{start, start};
        for (std::size_t k = start.size(); k-- > 0;)
            while (box.last[k] + 1 < tuning.constants[k].size()) {
                GridBox slice = box;
                slice.first[k] = slice.last[k] = box.last[k] + 1;
                bool same = true;
                for_each_point(slice, [&](const Indices& at) {
                    const std::size_t other = tuning.point(at);
                    same = same && !covered[other] && row.verdicts[other] == row.verdicts[point];
                });
                if (!same) break;
                ++box.last[k];
            }
        for_each_point(box, [&](const Indices& at) { covered[tuning.point(at)] = true; });
        boxes.push_back(std::move(box));
    }
    return boxes;
}

std::vector<Margin> margins_of(const Tuning& tuning, const Row& row) {
    std::vector<Margin> margins;
    for (std::size_t k = 0; k < tuning.constants.size(); ++k) {
        const TunedConstant& constant = tuning.constants[k];
        Indices at;
        for (std::size_t other = 0; other < tuning.constants.size(); ++other)
            at.push_back(other == k ? 0 : tuning.constants[other].current_index().value_or(SIZE_MAX));
        if (std::ranges::find(at, SIZE_MAX) != at.end()) continue;
        std::optional<Margin> down, up;
        for (at[k] = 0; at[k] < constant.size(); ++at[k]) {
            const std::int64_t value = constant.value(at[k]);
            const PointVerdict& verdict = row.verdicts[tuning.point(at)];
            if (value == constant.current || verdict.outcome == row.current.outcome) continue;
            const Margin margin{k, value > constant.current, value, std::abs(value - constant.current), verdict};
            if (!margin.up) down = margin;
            else if (!up) up = margin;
        }
        for (const auto& margin : {down, up})
            if (margin) margins.push_back(*margin);
    }
    return margins;
}

void print_tuning(const Tuning& tuning, std::ostream& out) {
    out << fmt::format("{}: {} points, {} models checked\n{}\n", printable(tuning.model), tuning.points, tuning.checks,
                       shared_settings({tuning.model, tuning.settings}, {}).shared);
    for (const TunedConstant& constant : tuning.constants) out << grid_text(constant) << '\n';
    const bool map = tuning.constants.size() == 2 && tuning.constants[0].size() <= tallest_map &&
                     tuning.constants[1].size() <= widest_map;
    bool any_map = false;
    for (const Row& row : tuning.rows) {
        if (!is_shown(tuning, row)) continue;
        any_map = any_map || (map && !is_uniform(row));
        print_row(tuning, row, map, out);
    }
    if (any_map) out << "\n+ holds, - violated, ? unknown; the current values are in brackets\n";
}

namespace {

Json value_json(const TunedConstant& constant, std::int64_t value) {
    if (constant.kind == NamedConstant::Kind::Integer) return value;
    return value_text(constant, value);
}

Json row_json(const Tuning& tuning, const Row& row, const Sources& sources) {
    Json made = {{"name", row.property}, {"text", text_or_null(row.text)}};
    add_place(made, file_place(sources, row.origin));
    made["declared"] = row.declared;
    made["expected"] = row.expected_violated ? "violated" : "holds";
    made["current"] = word(row.current.outcome);
    made["boxes"] = Json::array();
    for (const GridBox& box : boxes_of(tuning, row)) {
        const PointVerdict& verdict = row.verdicts[tuning.point(box.first)];
        Json ranges = Json::object();
        std::size_t points = 1;
        for (std::size_t k = 0; k < tuning.constants.size(); ++k) {
            const TunedConstant& constant = tuning.constants[k];
            points *= box.last[k] - box.first[k] + 1;
            ranges[constant.name] = {value_json(constant, constant.value(box.first[k])),
                                     value_json(constant, constant.value(box.last[k]))};
        }
        const bool unknown = verdict.outcome == Outcome::Unknown;
        made["boxes"].push_back({{"constants", std::move(ranges)},
                                 {"points", points},
                                 {"verdict", word(verdict.outcome)},
                                 {"reason", unknown ? Json(tuning.reasons[verdict.reason]) : Json(nullptr)}});
    }
    made["margins"] = Json::array();
    for (const Margin& margin : margins_of(tuning, row)) {
        const TunedConstant& constant = tuning.constants[margin.constant];
        made["margins"].push_back({{"constant", constant.name},
                                   {"direction", margin.up ? "up" : "down"},
                                   {"value", value_json(constant, margin.value)},
                                   {"distance", value_json(constant, margin.distance)},
                                   {"verdict", word(margin.verdict.outcome)}});
    }
    return made;
}

}  // namespace

std::string tuning_json(const Tuning& tuning, const Sources& sources) {
    Json object = {{"model", tuning.model},
                   {"engine", tuning.settings.engine},
                   {"mode", tuning.settings.mode},
                   {"grain", tuning.settings.grain},
                   {"time_unit", seconds_text(tuning.settings.time_unit_ms)}};
    object["constants"] = Json::array();
    for (const TunedConstant& constant : tuning.constants)
        object["constants"].push_back({{"name", constant.name},
                                       {"low", value_json(constant, constant.low)},
                                       {"high", value_json(constant, constant.high)},
                                       {"step", value_json(constant, constant.step)},
                                       {"current", value_json(constant, constant.current)}});
    object["points"] = tuning.points;
    object["checks"] = tuning.checks;
    object["transferred"] = tuning.transferred;
    object["properties"] = Json::array();
    for (const Row& row : tuning.rows) object["properties"].push_back(row_json(tuning, row, sources));
    return json_text(object);
}

}  // namespace grafverif
