// SPDX-License-Identifier: MIT
#include "pipeline/recording/recorded_properties.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <variant>

#include "ir/patterns.hpp"

namespace grafverif {

namespace {

constexpr std::size_t no_column = static_cast<std::size_t>(-1);

/// Returns, for each symbol of the loop, the column of the recording with the values of this symbol, or `no_column` if
/// no column records the symbol.
std::vector<std::size_t> columns_of(const ClosedLoop& loop, const std::vector<std::string>& names) {
    std::vector<std::size_t> columns;
    for (const ClosedLoop::Symbol& symbol : loop.symbols) {
        const auto* const shared = std::get_if<ClosedLoop::SharedSymbol>(&symbol);
        const auto found = shared == nullptr ? names.end() : std::ranges::find(names, loop.shared[shared->shared].name);
        columns.push_back(found == names.end() ? no_column : static_cast<std::size_t>(found - names.begin()));
    }
    return columns;
}

bool is_state_property(const Property& property) {
    return is_about_all_states(property.pattern) && !property.at_stable && !property.expected_violated;
}

}  // namespace

RecordedProperties::RecordedProperties(const Model& model, const std::vector<std::string>& names,
                                       RecordingTolerance tolerance)
    : tolerance_(std::move(tolerance)), values_(names.size()) {
    for (const ClosedLoop& loop : model.loops) {
        const std::vector<std::size_t> columns = columns_of(loop, names);
        for (const Id<Property> id : loop.properties.ids()) {
            const Property& property = loop.properties[id];
            if (!is_state_property(property)) continue;
            Checked checked{&loop, id, columns, std::vector<bool>(names.size())};
            bool recorded = true;
            for (const Id<Expr> operand : property.operands)
                for (const Id<Expr> leaf : leaves(loop.exprs, operand)) {
                    const Expr& node = loop.exprs[leaf];
                    const bool is_variable = node.op == Op::Variable;
                    if (!is_variable && (node.op == Op::True || node.op == Op::False || node.op == Op::Integer))
                        continue;
                    const std::size_t column = is_variable ? columns[static_cast<std::size_t>(node.value)] : no_column;
                    recorded = recorded && column != no_column;
                    if (column != no_column) checked.reads[column] = true;
                }
            if (!recorded) continue;
            checked.least_us = least_us(checked.reads);
            checked_.push_back(std::move(checked));
            results_.push_back({.name = property.name, .loop = loop.name});
        }
    }
}

void RecordedProperties::set(std::size_t column, std::int64_t value, std::int64_t time_us, std::uint64_t line) {
    if (values_[column] == value) return;
    values_[column] = value;
    for (Checked& checked : checked_) {
        if (!checked.reads[column]) continue;
        checked.since_us = time_us;
        checked.line = line;
        checked.pending = true;
    }
}

void RecordedProperties::pass(std::int64_t time_us) {
    for (std::size_t k = 0; k < checked_.size(); ++k) {
        Checked& checked = checked_[k];
        if (!checked.pending || time_us - checked.since_us <= checked.least_us) continue;
        checked.pending = false;
        if (results_[k].violated || holds(checked)) continue;
        results_[k].violated = true;
        results_[k].time_us = checked.since_us;
        results_[k].line = checked.line;
    }
}

std::int64_t RecordedProperties::least_us(const std::vector<bool>& reads) const {
    std::vector<std::size_t> clocks;
    for (std::size_t column = 0; column < reads.size(); ++column)
        if (reads[column] && std::ranges::find(clocks, tolerance_.clock_of[column]) == clocks.end())
            clocks.push_back(tolerance_.clock_of[column]);
    std::vector<std::int64_t> bounds = {0, 0};
    for (const std::size_t clock : clocks) bounds.push_back(clock == 0 ? 0 : tolerance_.clocks_us[clock - 1]);
    std::ranges::sort(bounds, std::greater());
    return 4 * tolerance_.jitter_us + (clocks.size() > 1 ? bounds[0] + bounds[1] : 0);
}

bool RecordedProperties::holds(const Checked& checked) const {
    for (std::size_t column = 0; column < values_.size(); ++column)
        if (checked.reads[column] && !values_[column]) return true;
    const Property& property = checked.loop->properties[checked.property];
    std::size_t count = 0;
    for (const Id<Expr> operand : property.operands) {
        const auto value = evaluate(checked.loop->exprs, operand, [&](const Expr& leaf) {
            return *values_[checked.column_of[static_cast<std::size_t>(leaf.value)]];
        });
        if (!value) return true;  // an undefined value is a model error, not a violation
        if (*value != 0) ++count;
    }
    if (property.pattern == Pattern::Never) return count == 0;
    return count == 1;
}

}  // namespace grafverif
