// SPDX-License-Identifier: MIT
#include "syntax/language/format.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "support/overloaded.hpp"
#include "syntax/language/format_items.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

namespace {

// The output lines of the formatter, with the comments and blank lines between elements. A comment is written before
// the first element that follows the comment in the source.

class Page {
public:
    explicit Page(const tree::File& file) : file_(&file) {}

    /// Prepares the output of the element that begins at `begin` in the source: writes the comments before the element.
    /// Also writes a blank line before the element if the source has a blank line there or if `apart` is true.
    void before(std::uint32_t begin, bool apart = false);
    /// Writes the comments that begin before `end` on separate lines. The caller uses this function for comments inside
    /// an element that is printed as a unit.
    void within(std::uint32_t end);
    void line(std::string text);
    /// Appends to the current line the end-of-line comments that begin before `limit`. Later comments belong to the
    /// next element.
    void trailing_comments(std::uint32_t limit);
    /// Writes the remaining comments up to `end`, the end of a block or of the file.
    void remaining(std::uint32_t end);

    void indent() {
        ++depth_;
        fresh_ = true;
    }
    void outdent() {
        --depth_;
        fresh_ = false;
    }
    std::size_t column() const { return 4 * depth_; }
    bool has_comment_before(std::uint32_t end) const;

    void write(std::ostream& out) const;

private:
    struct Line {
        std::string text = {};
        std::string comment = {};
    };

    void own_line(const tree::Comment& comment);
    bool gap_at(std::uint32_t position) const;

    const tree::File* file_;
    std::vector<Line> lines_ = {};
    std::size_t next_ = 0;  ///< index of the next comment
    std::size_t depth_ = 0;
    bool fresh_ = true;  ///< true at the start of a block or file: no blank line is written
};

bool Page::gap_at(std::uint32_t position) const { return std::ranges::binary_search(file_->gaps, position); }

void Page::before(std::uint32_t begin, bool apart) {
    bool commented = false;
    for (; has_comment_before(begin); ++next_) {
        const tree::Comment& comment = file_->comments[next_];
        if (!fresh_ && ((apart && !commented) || gap_at(comment.where.begin))) lines_.emplace_back();
        own_line(comment);
        commented = true;
    }
    if (!fresh_ && ((apart && !commented) || gap_at(begin))) lines_.emplace_back();
    fresh_ = false;
}

void Page::within(std::uint32_t end) {
    for (; has_comment_before(end); ++next_) own_line(file_->comments[next_]);
}

void Page::line(std::string text) {
    lines_.push_back({text.empty() ? text : std::string(column(), ' ') + text, {}});
    fresh_ = false;
}

void Page::trailing_comments(std::uint32_t limit) {
    for (; has_comment_before(limit); ++next_) {
        const tree::Comment& comment = file_->comments[next_];
        if (comment.own_line || comment.text.find('\n') != std::string::npos) return;
        std::string& trailing = lines_.back().comment;
        if (trailing.starts_with("//")) return;
        if (!trailing.empty()) trailing += ' ';
        trailing += comment.text;
    }
}

void Page::remaining(std::uint32_t end) {
    for (; has_comment_before(end); ++next_) {
        const tree::Comment& comment = file_->comments[next_];
        if (!fresh_ && gap_at(comment.where.begin)) lines_.emplace_back();
        own_line(comment);
    }
}

bool Page::has_comment_before(std::uint32_t end) const {
    return next_ < file_->comments.size() && file_->comments[next_].where.begin < end;
}

void Page::own_line(const tree::Comment& comment) {
    lines_.push_back({std::string(column(), ' ') + comment.text, {}});
    fresh_ = false;
}

/// Writes the lines to `out`, and aligns the end-of-line comments of adjacent lines.
void Page::write(std::ostream& out) const {
    for (std::size_t from = 0; from < lines_.size();) {
        std::size_t to = from, width = 0;
        while (to < lines_.size() && !lines_[to].comment.empty()) width = std::max(width, lines_[to++].text.size());
        to = std::max(to, from + 1);
        for (; from < to; ++from) {
            const auto& [text, comment] = lines_[from];
            out << text;
            if (!comment.empty()) out << std::string(width - text.size() + 2, ' ') << comment;
            out << '\n';
        }
    }
}

constexpr std::uint32_t end_of_file = std::numeric_limits<std::uint32_t>::max();

template <class... Items>
Span where_of(const std::variant<Items...>& item) {
    return std::visit([](const auto& written) { return written.where; }, item);
}

class Formatter {
public:
    explicit Formatter(const tree::File& file) : file_(file), page_(file) {}

    void run(std::ostream& out) {
        for (std::size_t i = 0; i < file_.declarations.size(); ++i) {
            const tree::Declaration& declaration = file_.declarations[i];
            const Span where = tree::where(declaration);
            // Successive includes form a group without blank lines; successive programs also form a group.
            const bool in_group = i > 0 && declaration.index() == file_.declarations[i - 1].index() &&
                                  (std::holds_alternative<tree::Include>(declaration) ||
                                   std::holds_alternative<tree::PlcProgram>(declaration));
            page_.before(where.begin, i > 0 && !in_group);
            const std::uint32_t limit =
                i + 1 < file_.declarations.size() ? tree::where(file_.declarations[i + 1]).begin : end_of_file;
            std::visit(
                overloaded{
                    [&](const tree::Include& written) { one_line(written.where, "include \"" + written.path + "\";"); },
                    [&](const tree::Chart& chart) {
                        block(chart.parameters.empty()
                                  ? "grafcet " + text(chart.name)
                                  : head_with_parameters(file_, "grafcet", chart.name, chart.parameters),
                              chart.items, where);
                    },
                    [&](const tree::Component& component) {
                        block(head_with_parameters(file_, "component", component.name, component.parameters),
                              component.items, where);
                    },
                    [&](const tree::ClosedLoop& loop) { block("closed_loop " + text(loop.name), loop.items, where); },
                    [&](const tree::PlcProgram& written) {
                        one_line(written.where, "program " + text(written.name) + " = \"" + written.path + "\";");
                    },
                },
                declaration);
            page_.trailing_comments(limit);
        }
        page_.remaining(end_of_file);
        page_.write(out);
    }

private:
    std::string text(tree::Name name) const { return formatted(file_, name); }

    void one_line(Span where, const std::string& text) { lines(where, {text}); }

    void lines(Span where, const std::vector<std::string>& texts) {
        page_.within(where.end);
        for (const std::string& text : texts) page_.line(text);
    }

    /// Prints a block. The comments that begin before `head_limit` are placed after the first line; by default, these
    /// are the comments before the first element.
    template <class Items>
    void block(const std::string& head, const Items& items, Span where, std::optional<std::uint32_t> head_limit = {}) {
        std::istringstream heads(head);
        std::string line, next;
        std::getline(heads, line);
        for (; std::getline(heads, next); line = next) page_.line(line);
        if (items.empty() && !page_.has_comment_before(where.end)) {
            page_.line(line + " {}");
            return;
        }
        page_.line(line + " {");
        page_.trailing_comments(head_limit ? *head_limit : items.empty() ? where.end : where_of(items.front()).begin);
        page_.indent();
        for (std::size_t i = 0; i < items.size(); ++i) {
            page_.before(where_of(items[i]).begin);
            const std::uint32_t limit = i + 1 < items.size() ? where_of(items[i + 1]).begin : where.end;
            limit_ = limit;
            std::visit([this](const auto& written) { this->item(written); }, items[i]);
            page_.trailing_comments(limit);
        }
        page_.remaining(where.end);
        page_.outdent();
        page_.line("}");
    }

    template <class Item>
    void item(const Item& written) {
        lines(written.where, item_lines(file_, written, page_.column()));
    }

    void item(const tree::Partial& partial) {
        if (partial.chart.valid()) return lines(partial.where, instance_lines(file_, partial, page_.column()));
        const bool expansion = partial.kind == tree::PartialKind::Expansion;
        block((expansion ? "expansion " : "partial ") + text(partial.name), partial.items, partial.where);
    }

    template <class Replicated>
    requires requires(const Replicated& written) { written.replication; }
    void item(const Replicated& written) {
        block("for " + formatted(file_, written.replication), written.items, written.where);
    }

    void item(const tree::Observer& observer) {
        block("observer " + text(observer.name), observer.items, observer.where);
    }

    void item(const tree::Step& step) {
        const std::string head = step_head(file_, step);
        const bool commented = page_.has_comment_before(step.where.end);
        if (step.actions.empty() && !commented) return page_.line(head + ";");
        if (!commented) {
            const auto line = step_in_one_line(file_, step, page_.column());
            if (line) return page_.line(*line);
            // The step contains no comment, so a comment after the step applies to the complete step.
            return block(head, step.actions, step.where, limit_);
        }
        block(head, step.actions, step.where);
    }

    const tree::File& file_;
    Page page_;
    std::uint32_t limit_ = 0;  ///< begin of the element after the current element of a block, or end of the block
};

}  // namespace

void format(const tree::File& file, std::ostream& out) { Formatter(file).run(out); }

std::string formatted(const tree::File& file) {
    std::ostringstream out;
    format(file, out);
    return std::move(out).str();
}

}  // namespace grafverif
