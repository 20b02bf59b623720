// SPDX-License-Identifier: MIT
#include "ir/program/scan.hpp"

namespace grafverif {

std::vector<bool> variables_read(const Scan& scan, std::vector<Id<Expr>> roots) {
    const Exprs& from = scan.equations.exprs;
    std::vector<Id<Expr>> next(scan.equations.variables.size());
    for (const Equations::Stored& stored : scan.equations.stored) next[stored.variable.index] = stored.next;
    std::vector<bool> seen(from.size()), read(next.size());
    while (!roots.empty()) {
        const Id<Expr> term = roots.back();
        roots.pop_back();
        if (seen[term.index]) continue;
        seen[term.index] = true;
        for (const Id<Expr> operand : from.operands(term)) roots.push_back(operand);
        if (from[term].op != Op::Variable) continue;
        const auto variable = static_cast<std::size_t>(from[term].value);
        read[variable] = true;
        if (next[variable].valid()) roots.push_back(next[variable]);
    }
    return read;
}

}  // namespace grafverif
