// SPDX-License-Identifier: MIT
#include "check/vacuity.hpp"

#include <algorithm>
#include <utility>

#include "ir/patterns.hpp"

namespace grafverif {

namespace {

/// Evaluates the vacuity probes of the property of `verdict`. Requires that this property holds. If a probe is
/// violated, marks the verdict as vacuous.
void apply_probes(const Table<Property>& properties, const std::vector<Verdict>& verdicts, Verdict& verdict) {
    std::string undecided;
    for (const Verdict& probe : verdicts) {
        if (!probe.about.valid() || probed_by(properties[probe.about]) != verdict.property) continue;
        if (probe.outcome == Outcome::Violated) {
            verdict.vacuous = true;
            verdict.notes.push_back(properties[probe.about].text);
            return;
        }
        if (probe.outcome == Outcome::Unknown) undecided = probe.reason;
    }
    if (!undecided.empty()) verdict.notes.push_back("vacuity is unknown: " + undecided);
}

}  // namespace

void apply_probes(const Table<Property>& properties, std::vector<Verdict>& verdicts) {
    if (std::ranges::none_of(properties, is_probe)) return;
    for (Verdict& verdict : verdicts)
        if (verdict.outcome == Outcome::Holds && verdict.about.valid() && !is_probe(properties[verdict.about]))
            apply_probes(properties, verdicts, verdict);
}

void add_external_probes(Exprs& exprs, Table<Property>& properties, bool settled) {
    std::vector<Property> probes;
    const auto add = [&](const Property& property, const char* kind, Id<Expr> term, const char* never) {
        probes.push_back(probe_of(property, kind, term, never));
        probes.back().at_stable = property.at_stable;
    };
    for (const Property& property : properties) {
        if (is_declared_response(property)) add(property, "premise", property.operands[0], "the premise is never true");
        if (settled && property.at_stable && is_about_all_states(property.pattern))
            add(property, "settled", exprs.constant(true), "no state is quiescent");
    }
    for (Property& probe : probes) properties.add(std::move(probe));
}

}  // namespace grafverif
