// SPDX-License-Identifier: MIT
// Assigns new positions to the elements of an imported tree, in the order in which they are printed. A comment contains
// the position in the imported file of the element that it describes. If the tree does not contain this element, the
// comment is placed at the head of the file.
#include <map>
#include <utility>

#include "read/formats.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

class Layout {
public:
    explicit Layout(tree::File& file) : file_(file) {
        // Reserves positions for the comments at the head of the file.
        position_ += static_cast<std::uint32_t>(file.comments.size());
        for (tree::Comment& comment : file.comments) hung_[comment.where.begin].push_back(std::move(comment));
        file.comments.clear();
        file.gaps.clear();
    }

    void run() {
        for (tree::Declaration& declaration : file_.declarations) {
            auto* chart = std::get_if<tree::Chart>(&declaration);
            if (chart == nullptr) continue;
            begin(chart->where, false);
            items(chart->items);
            end(chart->where);
        }
        std::vector<tree::Comment> dropped;
        for (auto& [where, comments] : hung_)
            for (tree::Comment& comment : comments) dropped.push_back(std::move(comment));
        for (std::uint32_t at = 0; at < dropped.size(); ++at) {
            dropped[at].own_line = true;
            dropped[at].where = {{}, at, at + 1};
        }
        file_.comments.insert(file_.comments.begin(), dropped.begin(), dropped.end());
    }

private:
    Span next() { return {{}, std::exchange(position_, position_ + 2), position_ - 1}; }

    /// Assigns a position to the element that begins at `where`, and to the comments before and after this element.
    void begin(Span& where, bool gap) {
        std::vector<tree::Comment> trailing;
        const auto hung = hung_.extract(where.begin);
        if (!hung.empty()) {
            for (tree::Comment& comment : hung.mapped()) {
                if (!comment.own_line) {
                    trailing.push_back(std::move(comment));
                    continue;
                }
                comment.where = next();
                if (std::exchange(gap, false)) file_.gaps.push_back(comment.where.begin);
                file_.comments.push_back(std::move(comment));
            }
        }
        where = next();
        if (gap) file_.gaps.push_back(where.begin);
        for (tree::Comment& comment : trailing) {
            comment.where = next();
            file_.comments.push_back(std::move(comment));
        }
    }

    void end(Span& where) { where.end = std::exchange(position_, position_ + 2); }

    void items(std::vector<tree::ChartItem>& all) {
        std::size_t last = std::variant_npos;
        for (tree::ChartItem& item : all) {
            const bool gap =
                last != std::variant_npos && (last != item.index() || std::holds_alternative<tree::Partial>(item));
            last = item.index();
            std::visit(overloaded{
                           [&](auto& plain) { begin(plain.where, gap); },
                           [&](tree::Step& step) {
                               begin(step.where, gap);
                               for (tree::Action& action : step.actions)
                                   std::visit([this](auto& one) { begin(one.where, false); }, action);
                               end(step.where);
                           },
                           [&](tree::Partial& partial) {
                               begin(partial.where, gap);
                               // The recursion depth is one, because partial charts cannot be nested.
                               items(partial.items);
                               end(partial.where);
                           },
                       },
                       item);
        }
    }

    tree::File& file_;
    std::map<std::uint32_t, std::vector<tree::Comment>> hung_ = {};
    std::uint32_t position_ = 1;
};

}  // namespace

tree::File laid_out(tree::File file) {
    Layout(file).run();
    return file;
}

}  // namespace grafverif
