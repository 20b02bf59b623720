// SPDX-License-Identifier: MIT
#include "syntax/language/tree.hpp"

#include <functional>

namespace grafverif::tree {

Span where(const Declaration& declaration) {
    return std::visit([](const auto& written) { return written.where; }, declaration);
}

Id<Word> Words::intern(std::string_view text) {
    if (slots_.size() <= 2 * hashes_.size()) grow();
    const std::size_t hash = std::hash<std::string_view>{}(text);
    for (std::size_t at = hash & (slots_.size() - 1);; at = (at + 1) & (slots_.size() - 1)) {
        if (slots_[at] == 0) {
            const Id<Word> word = words_->add({std::string(text)});
            hashes_.push_back(hash);
            slots_[at] = word.index + 1;
            return word;
        }
        const Id<Word> known{slots_[at] - 1};
        if (hashes_[known.index] == hash && (*words_)[known].text == text) return known;
    }
}

void Words::grow() {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), 0);
    for (std::uint32_t index = 0; index < hashes_.size(); ++index) {
        std::size_t at = hashes_[index] & (slots_.size() - 1);
        while (slots_[at] != 0) at = (at + 1) & (slots_.size() - 1);
        slots_[at] = index + 1;
    }
}

Replication replication(const File& file, const Expr& node) {
    const Expr& index = file.exprs[node.first];
    const Id<Expr> low = index.next, high = file.exprs[low].next;
    return {
        {index.word, index.where}, {low, high}, {index.where.source, index.where.begin, file.exprs[high].where.end}};
}

void append(Table<Expr>& exprs, Id<Expr> node, Id<Expr> operand) {
    Expr& parent = exprs[node];
    if (parent.last.valid()) exprs[parent.last].next = operand;
    else parent.first = operand;
    parent.last = operand;
}

}  // namespace grafverif::tree
