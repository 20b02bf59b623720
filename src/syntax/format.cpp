// SPDX-License-Identifier: MIT
#include "grafverif/syntax/format.hpp"

#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "grafverif/support/overloaded.hpp"
#include "syntax/format_items.hpp"
#include "syntax/page.hpp"

namespace grafverif {

namespace {

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
            const bool include = std::holds_alternative<tree::Include>(declaration);
            const bool after_include = i > 0 && std::holds_alternative<tree::Include>(file_.declarations[i - 1]);
            page_.before(where.begin, i > 0 && !(include && after_include));
            const std::uint32_t limit =
                i + 1 < file_.declarations.size() ? tree::where(file_.declarations[i + 1]).begin : end_of_file;
            std::visit(
                overloaded{
                    [&](const tree::Include& written) { one_line(written.where, "include \"" + written.path + "\";"); },
                    [&](const tree::Chart& chart) { block("grafcet " + text(chart.name), chart.items, where); },
                    [&](const tree::Component& component) {
                        block(component_head(file_, component), component.items, where);
                    },
                    [&](const tree::ClosedLoop& loop) { block("closed_loop " + text(loop.name), loop.items, where); },
                },
                declaration);
            page_.behind(limit);
        }
        page_.remaining(end_of_file);
        page_.write(out);
    }

private:
    std::string text(tree::Name name) const { return std::string(file_.text(name)); }

    void one_line(Span where, const std::string& text) { lines(where, {text}); }

    void lines(Span where, const std::vector<std::string>& texts) {
        page_.within(where.end);
        for (const std::string& text : texts) page_.line(text);
    }

    template <class Items>
    void block(const std::string& head, const Items& items, Span where) {
        std::istringstream heads(head);
        std::string line, next;
        std::getline(heads, line);
        for (; std::getline(heads, next); line = next) page_.line(line);
        if (items.empty() && !page_.has_comment_before(where.end)) {
            page_.line(line + " {}");
            return;
        }
        page_.line(line + " {");
        page_.behind(items.empty() ? where.end : where_of(items.front()).begin);
        page_.indent();
        for (std::size_t i = 0; i < items.size(); ++i) {
            page_.before(where_of(items[i]).begin);
            std::visit([this](const auto& written) { this->item(written); }, items[i]);
            page_.behind(i + 1 < items.size() ? where_of(items[i + 1]).begin : where.end);
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
        const bool expansion = partial.kind == tree::PartialKind::Expansion;
        block((expansion ? "expansion " : "partial ") + text(partial.name), partial.items, partial.where);
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
        }
        block(head, step.actions, step.where);
    }

    const tree::File& file_;
    Page page_;
};

}  // namespace

void format(const tree::File& file, std::ostream& out) { Formatter(file).run(out); }

std::string formatted(const tree::File& file) {
    std::ostringstream out;
    format(file, out);
    return std::move(out).str();
}

}  // namespace grafverif
