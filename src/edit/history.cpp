// SPDX-License-Identifier: MIT
#include "edit/history.hpp"

namespace grafverif::edit {

/// True if the edits extend the last editing step: both insert text without line ends, and the new text directly
/// follows the previous text.
bool History::continues(const std::vector<TextEdit>& edits) const {
    if (done_ == 0 || done_ != steps_.size() || !steps_.back().typed || edits.size() != 1) return false;
    const TextEdit &last = steps_.back().forward.front(), &next = edits.front();
    return next.begin == next.end && next.begin == last.begin + last.replacement.size() &&
           next.replacement.find('\n') == std::string::npos && last.replacement.find('\n') == std::string::npos;
}

void History::apply(const std::vector<TextEdit>& edits, bool typed) {
    if (edits.empty()) return;
    if (typed && continues(edits)) {
        Step& last = steps_.back();
        last.forward.front().replacement += edits.front().replacement;
        last.backward.front().end += static_cast<std::uint32_t>(edits.front().replacement.size());
    } else {
        steps_.resize(done_);
        steps_.push_back({edits, inverse(text_, edits), typed && edits.size() == 1});
        ++done_;
    }
    text_ = applied(text_, edits);
}

std::uint32_t History::undo() {
    const Step& step = steps_[--done_];
    text_ = applied(text_, step.backward);
    return step.forward.front().begin;
}

std::uint32_t History::redo() {
    const Step& step = steps_[done_++];
    text_ = applied(text_, step.forward);
    return step.forward.front().begin;
}

}  // namespace grafverif::edit
