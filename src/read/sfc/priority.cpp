// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "read/sfc/parts.hpp"
#include "support/messages.hpp"
#include "syntax/language/format.hpp"

namespace grafverif {

namespace {

/// Returns the conjuncts of a condition as text.
std::vector<std::string> conjuncts(const Draft& draft, Id<tree::Expr> condition) {
    if (draft[condition].op != tree::Op::And) return {formatted(draft.file(), condition)};
    std::vector<std::string> all;
    for (const Id<tree::Expr> one : draft.operands(condition)) all.push_back(formatted(draft.file(), one));
    return all;
}

std::string negated(const std::string& text) { return text.starts_with('!') ? text.substr(1) : '!' + text; }

/// True if two conditions are syntactically exclusive: one condition has a conjunct `a` and the other condition has the
/// conjunct `!a`, or the condition `one` has the conjunct `false`.
bool exclusive(const std::vector<std::string>& one, const std::vector<std::string>& other) {
    return std::ranges::any_of(one, [&](const std::string& text) {
        return text == "false" || std::ranges::find(other, negated(text)) != other.end();
    });
}

}  // namespace

void exclude_by_priority(Sfc& sfc, std::vector<SfcBranch>& branches) {
    std::unordered_map<Id<st::Word>, std::vector<std::size_t>> following;
    std::vector<Id<st::Word>> order;
    for (std::size_t i = 0; i < branches.size(); ++i)
        for (const st::Name& from : branches[i].written->from) {
            auto& list = following[from.word];
            if (list.empty()) order.push_back(from.word);
            list.push_back(i);
        }
    std::vector<Id<tree::Expr>> original;
    std::vector<std::vector<std::string>> parts;
    for (const SfcBranch& branch : branches) {
        original.push_back(sfc.draft.copy(branch.condition));
        parts.push_back(conjuncts(sfc.draft, branch.condition));
    }
    std::unordered_set<std::uint64_t> done;
    for (const Id<st::Word> step : order) {
        std::vector<std::size_t>& list = following[step];
        std::ranges::stable_sort(list, {}, [&](std::size_t i) {
            const std::int64_t priority = branches[i].written->priority;
            // Transitions without a priority are ordered after transitions with a priority.
            return priority > 0 ? priority : std::int64_t{1} << 40U;
        });
        bool changed = false;
        for (std::size_t low = 1; low < list.size(); ++low) {
            for (std::size_t high = 0; high < low; ++high) {
                const std::size_t i = list[low], j = list[high];
                if (exclusive(parts[i], parts[j]) || exclusive(parts[j], parts[i])) continue;
                if (!done.insert((static_cast<std::uint64_t>(i) << 32U) | j).second) continue;
                Id<tree::Expr> blocked = sfc.draft.copy(original[j]);
                for (const st::Name& from : branches[j].written->from) {
                    const bool shared = std::ranges::any_of(branches[i].written->from,
                                                            [&](const st::Name& own) { return own.word == from.word; });
                    if (!shared && sfc.steps.contains(from.word))
                        blocked =
                            both(sfc.draft, blocked, sfc.draft.variable('X' + sfc.steps.at(from.word), from.where));
                }
                branches[i].condition = both(sfc.draft, branches[i].condition, opposite(sfc.draft, blocked));
                if (!branches[i].condition.valid())
                    branches[i].condition = sfc.draft.constant(false, branches[i].written->where);
                changed = true;
            }
        }
        if (changed) {
            const std::string name = sfc.steps.contains(step) ? sfc.steps.at(step) : std::string(sfc.file.text(step));
            sfc.diagnostics().add(
                messages::explicit_priority(branches[list.front()].written->where, name, list.size()));
        }
    }
}

}  // namespace grafverif
