// SPDX-License-Identifier: MIT
#include "syntax/page.hpp"

#include <algorithm>
#include <ostream>

namespace grafverif {

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

void Page::behind(std::uint32_t limit) {
    for (; has_comment_before(limit); ++next_) {
        const tree::Comment& comment = file_->comments[next_];
        if (comment.own_line || comment.text.find('\n') != std::string::npos) return;
        std::string& behind = lines_.back().comment;
        if (behind.starts_with("//")) return;
        if (!behind.empty()) behind += ' ';
        behind += comment.text;
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

/// Comments behind neighbouring lines stand in one column.
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

}  // namespace grafverif
