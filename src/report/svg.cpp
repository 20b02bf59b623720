// SPDX-License-Identifier: MIT
// Draws the timing diagram of a run. From top to bottom, the diagram consists of the title, the strips of columns, and
// the foot. A strip consists of a header and the rows in groups; the header contains slanted labels, the numbers of the
// events, and the times. All lengths are in pixels. The constant `character` is the assumed width of a character.
#include "report/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <vector>

#include "report/table.hpp"
#include "support/xml_text.hpp"

namespace grafverif {

namespace {

constexpr std::size_t character = 7, column_width = 36, row_height = 26, margin = 16;
constexpr std::size_t longest_label = 56, longest_name = 32;
constexpr std::size_t longest_strip = 40;            // maximum number of columns in a strip
constexpr std::size_t wave_high = 5, wave_low = 20;  // vertical positions of the values true and false within a row
/// Labels are drawn at an angle of 60 degrees. Each character extends a label upwards and to the right by these
/// lengths, in hundredths of a pixel.
constexpr std::size_t rise_per_hundred = 87 * character, run_per_hundred = 50 * character;

/// One row of the diagram: the name of a signal or step, and its value in each column.
struct SignalRow {
    std::string name = {};
    bool boolean = true;
    std::vector<std::int64_t> values = {};
};
struct Group {
    std::string title = {};
    std::string style = {};
    std::vector<SignalRow> rows = {};
};

std::string shortened(std::string text, std::size_t length) {
    if (text.size() > length) text = text.substr(0, length - 1) + "\u2026";
    return text;
}

/// The columns of the diagram: for each displayed row of the run in the selected range of events, the state after this
/// row.
using Columns = std::vector<const ChartRun::State*>;

Group group(std::string title, const Columns& columns, const ChartRun& run, ChartRun::Role role) {
    Group group{title, title, {}};
    for (const Id<ChartRun::Signal> id : signals_of(run, role)) {
        SignalRow row{run.signals[id].name, run.signals[id].type.boolean, {}};
        for (const ChartRun::State* state : columns) row.values.push_back(state->values[id.index]);
        group.rows.push_back(std::move(row));
    }
    return group;
}

Group steps(const ChartRun& run, const Columns& columns) {
    Group group{"steps", "steps", {}};
    for (const ChartRun::Step& step : run.steps)
        group.rows.push_back({step.short_name, true, std::vector<std::int64_t>(columns.size(), 0)});
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (const Id<ChartRun::Step> active : columns[i]->situation) group.rows[active.index].values[i] = 1;
    return group;
}

class Drawing {
public:
    Drawing(const ChartRun& run, std::string_view title, EventRange range) : run_(run), title_(title) {
        const std::vector<std::size_t> shown = shown_rows(run);
        const std::size_t last = shown.empty() ? 0 : shown.size() - 1;
        for (std::size_t number = std::min(range.from, last); number < shown.size() && number <= range.to; ++number) {
            const std::size_t index = shown[number];
            if (run.loop_from && index >= *run.loop_from && !loop_from_) loop_from_ = columns_.size();
            columns_.push_back(&run.after(run.rows[index]));
            events_.push_back(number);
            const std::string cleared = cleared_text(run, run.rows[index]);
            labels_.push_back(
                shortened(happening(run, index) + (cleared.empty() ? "" : ": " + cleared), longest_label));
        }
        groups_ = {group("inputs", columns_, run, ChartRun::Role::Input),
                   group("outputs", columns_, run, ChartRun::Role::Output),
                   group("internals", columns_, run, ChartRun::Role::Internal),
                   group("plant", columns_, run, ChartRun::Role::Plant), steps(run, columns_)};
        foot_.push_back(
            "Columns are events; the width of a column is not a duration. A time is shown only if it differs from the "
            "previous time.");
        if (columns_.size() < shown.size() && !columns_.empty())
            foot_.push_back(fmt::format("Events {} to {} of {}.", events_.front(), events_.back(), last));
        drop_idle();
        measure();
    }

    void print(std::ostream& out) {
        text(margin, margin + wave_low, "heading", title_);
        std::size_t y = margin + 2 * row_height;
        const std::size_t strips = std::max<std::size_t>((columns_.size() + longest_strip - 1) / longest_strip, 1);
        const std::size_t length = (columns_.size() + strips - 1) / strips;
        for (std::size_t k = 0; k < strips; ++k)
            y = draw_strip(k * length, std::min((k + 1) * length, columns_.size()), y);
        for (const std::string& line : foot_) text(margin, y += row_height, "foot", line);
        out << fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n", width_,
            y + margin);
        out << style << fmt::format("<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", width_, y + margin);
        out << ground_ << body_ << "</svg>\n";
    }

private:
    static constexpr const char* style =
        "<style>\n"
        "text { font: 12px sans-serif; fill: #222 }\n"
        ".heading { font-size: 15px; font-weight: bold }\n"
        ".title { font-weight: bold; fill: #555 }\n"
        ".foot { fill: #777 }\n"
        ".time { font-size: 11px; fill: #555 }\n"
        ".moment { font-size: 11px; fill: #555 }\n"
        ".number { font-size: 10px; fill: #555; text-anchor: middle }\n"
        ".value { font-size: 11px; text-anchor: middle }\n"
        ".paper { fill: #fff }\n"
        ".loop { fill: #fff3d6 }\n"
        ".rule { stroke: #ddd }\n"
        ".wave { fill: none; stroke-width: 1.5 }\n"
        ".inputs { stroke: #1f6fb2 } .outputs { stroke: #b2401f } .internals { stroke: #7a3fa0 }\n"
        ".plant { stroke: #2e8b57 } .steps { stroke: #444 }\n"
        ".fill-inputs { fill: #d8e8f5 } .fill-outputs { fill: #f7ddd4 } .fill-internals { fill: #eadcf2 }\n"
        ".fill-plant { fill: #dcefe4 } .fill-steps { fill: #e2e2e2 }\n"
        "</style>\n";

    void drop_idle() {
        std::string idle;
        for (Group& group : groups_) {
            const auto is_idle = [](const SignalRow& row) {
                return std::ranges::all_of(row.values, [](std::int64_t v) { return v == 0; });
            };
            for (const SignalRow& row : group.rows)
                if (is_idle(row))
                    idle += (idle.empty() ? "" : ", ") + (group.title == "steps" ? "step " + row.name : row.name);
            std::erase_if(group.rows, is_idle);
        }
        if (!idle.empty()) foot_.push_back("0 throughout: " + idle);
    }

    void measure() {
        std::size_t name = 10;
        for (const Group& group : groups_)
            for (const SignalRow& row : group.rows) name = std::max(name, std::min(row.name.size(), longest_name));
        left_ = margin + name * character + margin;
        const std::size_t strips = std::max<std::size_t>((columns_.size() + longest_strip - 1) / longest_strip, 1);
        const std::size_t length = (columns_.size() + strips - 1) / strips;
        width_ = x(length);
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            label_ = std::max(label_, labels_[i].size());
            width_ = std::max(width_, x(i % length) + column_width / 2 + labels_[i].size() * run_per_hundred / 100);
        }
        width_ = std::max(width_ + margin, margin * 2 + title_.size() * (character + 2));
        wrap_foot();
    }

    void wrap_foot() {
        std::vector<std::string> lines;
        for (const std::string& line : foot_)
            for (std::string& part : wrapped(line, (width_ - 2 * margin) / character)) lines.push_back(std::move(part));
        foot_ = std::move(lines);
    }

    /// Returns the x position of a column of the current strip.
    std::size_t x(std::size_t column) const { return left_ + (column - first_) * column_width; }

    void text(std::size_t x, std::size_t y, std::string_view kind, std::string_view words) {
        body_ += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">", kind, x, y);
        escape_xml(words, body_);
        body_ += "</text>\n";
    }

    /// Draws a strip with the columns [first, end), starting at `y`. Returns the y position of its lower end.
    std::size_t draw_strip(std::size_t first, std::size_t end, std::size_t y) {
        first_ = first;
        end_ = end;
        const std::size_t top = y + label_ * rise_per_hundred / 100 + 2 * row_height;
        std::size_t bottom = top;
        for (const Group& group : groups_)
            if (!group.rows.empty()) bottom += row_height * (1 + group.rows.size());
        draw_loop(top, bottom);
        draw_header(top, bottom);
        y = top;
        for (const Group& group : groups_) {
            if (group.rows.empty()) continue;
            text(margin, y + wave_low, "title", group.title);
            y += row_height;
            for (const SignalRow& each : group.rows) {
                draw(each, group.style, y);
                y += row_height;
            }
        }
        return bottom + (end == columns_.size() ? 0 : row_height);
    }

    void draw_header(std::size_t top, std::size_t bottom) {
        text(margin, top - row_height - 8, "time", "event");
        text(margin, top - 8, "time", run_.timed ? "time" : "step");
        for (std::size_t i = first_; i < end_; ++i) {
            const std::size_t at = x(i) + column_width / 2, y = top - 2 * row_height - 4;
            body_ += fmt::format("<text class=\"event\" transform=\"translate({},{}) rotate(-60)\">", at, y);
            escape_xml(labels_[i], body_);
            body_ += "</text>\n";
            text(at, top - row_height - 8, "number", std::to_string(events_[i]));
            if (i > 0 && columns_[i]->time_ms == columns_[i - 1]->time_ms) continue;
            ground_ += fmt::format("<line class=\"rule\" x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\"/>\n", x(i),
                                   top - row_height, bottom);
            text(x(i) + 3, top - 8, "moment", event_text(run_, *columns_[i]));
        }
    }

    void draw_loop(std::size_t top, std::size_t bottom) {
        if (!loop_from_ || *loop_from_ >= end_) return;
        const std::size_t from = x(std::max(*loop_from_, first_));
        ground_ += fmt::format(
            "<rect class=\"loop\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>repeated "
            "forever</title></rect>\n",
            from, top - row_height, x(end_) - from, bottom - top + row_height);
    }

    void draw(const SignalRow& each, const std::string& kind, std::size_t y) {
        text(margin, y + wave_low - 3, "name", shortened(each.name, longest_name));
        for (std::size_t begin = first_; begin < end_;) {
            std::size_t end = begin + 1;
            while (end < end_ && each.values[end] == each.values[begin]) ++end;
            if (each.boolean) draw_level(begin, end, each.values[begin] != 0, begin > first_, kind, y);
            else draw_value(begin, end, each.values[begin], kind, y);
            begin = end;
        }
    }

    /// Draws a segment of the waveform of a Boolean signal. If `slope` is true, also draws the edge from the previous
    /// segment.
    void draw_level(std::size_t begin, std::size_t end, bool high, bool slope, const std::string& kind, std::size_t y) {
        const std::size_t level = y + (high ? wave_high : wave_low);
        if (high)
            body_ += fmt::format("<rect class=\"fill-{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", kind,
                                 x(begin), level, x(end) - x(begin), wave_low - wave_high);
        const std::string from = slope ? fmt::format("M{} {}V{}", x(begin), y + (high ? wave_low : wave_high), level)
                                       : fmt::format("M{} {}", x(begin), level);
        body_ += fmt::format("<path class=\"wave {}\" d=\"{}H{}\"/>\n", kind, from, x(end));
    }

    /// Draws the value of an integer signal as a box with slanted ends.
    void draw_value(std::size_t begin, std::size_t end, std::int64_t value, const std::string& kind, std::size_t y) {
        const std::size_t high = y + wave_high, low = y + wave_low, middle = (high + low) / 2, slant = 4;
        body_ += fmt::format("<path class=\"wave {} fill-{}\" d=\"M{} {}L{} {}H{}L{} {}L{} {}H{}Z\"/>\n", kind, kind,
                             x(begin), middle, x(begin) + slant, high, x(end) - slant, x(end), middle, x(end) - slant,
                             low, x(begin) + slant);
        text((x(begin) + x(end)) / 2, low - 4, "value", std::to_string(value));
    }

    const ChartRun& run_;
    std::string title_;
    Columns columns_ = {};
    std::optional<std::size_t> loop_from_ = {};  ///< index of the first column that is repeated forever
    std::vector<Group> groups_ = {};
    std::vector<std::string> labels_ = {}, foot_ = {};
    std::vector<std::size_t> events_ = {};          ///< for each column, the number of its event
    std::size_t left_ = 0, width_ = 0, label_ = 4;  ///< label_ is the number of characters of the longest label
    std::size_t first_ = 0, end_ = 0;               ///< the current strip contains the columns [first_, end_)
    std::string ground_ = {};                       ///< SVG elements of the background, which are drawn first
    std::string body_ = {};
};

}  // namespace

void print_svg(const ChartRun& run, std::string_view title, EventRange range, std::ostream& out) {
    Drawing(run, title, range).print(out);
}

}  // namespace grafverif
