// SPDX-License-Identifier: MIT
#include "syntax/st/st_tree.hpp"

namespace grafverif::st {

std::string capitals(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return result;
}

Id<Word> File::intern(std::string_view text) {
    const auto [known, fresh] = index.try_emplace(capitals(text));
    if (fresh) known->second = words.add({std::string(text)});
    return known->second;
}

void append(Table<Expr>& exprs, Id<Expr> node, Id<Expr> operand) {
    Expr& parent = exprs[node];
    if (parent.last.valid()) exprs[parent.last].next = operand;
    else parent.first = operand;
    parent.last = operand;
}

std::vector<Id<Expr>> operands(const File& file, Id<Expr> node) {
    std::vector<Id<Expr>> all;
    for (Id<Expr> one = file.exprs[node].first; one.valid(); one = file.exprs[one].next) all.push_back(one);
    return all;
}

}  // namespace grafverif::st
