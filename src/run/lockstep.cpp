// SPDX-License-Identifier: MIT
#include "run/lockstep.hpp"

#include <algorithm>
#include <utility>

#include "run/scanner.hpp"

namespace grafverif {

std::vector<Comparison::Variable> plugs(const Chart& chart, Chart::VariableKind kind) {
    std::vector<Comparison::Variable> found;
    for (const Id<Chart::Variable> id : variables_of_kind(chart, kind))
        found.push_back({chart.variables[id].name, chart.variables[id].type});
    return found;
}

namespace {

/// Returns, for each input or output of `chart`, the index of the variable with the same name in `first`.
std::vector<std::size_t> places(const Chart& chart, const Chart& first, Chart::VariableKind kind) {
    const std::vector<Comparison::Variable> known = plugs(first, kind);
    std::vector<std::size_t> found;
    for (const Comparison::Variable& plug : plugs(chart, kind))
        found.push_back(
            static_cast<std::size_t>(std::ranges::find(known, plug.name, &Comparison::Variable::name) - known.begin()));
    return found;
}

}  // namespace

Lockstep::Lockstep(const Chart& a, const Chart& b, ExecutionMode mode) : charts_{&a, &b}, mode_(mode) {
    for (const std::size_t k : {0U, 1U}) {
        inputs_[k] = places(*charts_[k], a, Chart::VariableKind::Input);
        outputs_[k] = places(*charts_[k], a, Chart::VariableKind::Output);
    }
}

std::array<std::vector<Comparison::ScanOutputs>, 2> Lockstep::answers(
    const std::vector<Comparison::Scan>& scans) const {
    std::array<Scanner, 2> runs{Scanner(*charts_[0], mode_), Scanner(*charts_[1], mode_)};
    std::array<std::vector<Comparison::ScanOutputs>, 2> result;
    for (const Comparison::Scan& scan : scans) {
        bool stopped = false;
        for (const std::size_t k : {0U, 1U}) {
            std::vector<std::int64_t> inputs;
            for (const std::size_t place : inputs_[k]) inputs.push_back(scan.inputs[place]);
            runs[k].wait(scan.wait_ms);
            Comparison::ScanOutputs answer;
            answer.stop = runs[k].scan(inputs);
            answer.situation = situation_text(*charts_[k], runs[k].state().situation);
            const std::vector<std::int64_t> outputs = runs[k].outputs();
            answer.outputs.resize(outputs.size());
            for (std::size_t plug = 0; plug < outputs.size(); ++plug) answer.outputs[outputs_[k][plug]] = outputs[plug];
            stopped = stopped || !answer.stop.empty();
            result[k].push_back(std::move(answer));
        }
        if (stopped) break;
    }
    return result;
}

std::optional<std::size_t> Lockstep::difference(const std::vector<Comparison::Scan>& scans) const {
    const auto [of_a, of_b] = answers(scans);
    for (std::size_t scan = 0; scan < of_a.size(); ++scan)
        if (!of_a[scan].same(of_b[scan])) return scan;
    return {};
}

/// True if the constraints of both charts are satisfied by the inputs.
bool Lockstep::possible(const Comparison::Scan& scan) const {
    for (const std::size_t k : {0U, 1U}) {
        std::vector<std::int64_t> values(charts_[k]->variables.size());
        const std::vector<Id<Chart::Variable>> inputs = variables_of_kind(*charts_[k], Chart::VariableKind::Input);
        for (std::size_t plug = 0; plug < inputs.size(); ++plug)
            values[inputs[plug].index] = scan.inputs[inputs_[k][plug]];
        for (const Chart::Constraint& constraint : charts_[k]->constraints)
            if (evaluate(charts_[k]->exprs, constraint.condition, [&](const Expr& leaf) {
                    return values[static_cast<std::size_t>(leaf.value)];
                }).value_or(0) == 0)
                return false;
    }
    return true;
}

std::vector<Comparison::Scan> Lockstep::simplified(std::vector<Comparison::Scan> scans,
                                                   const std::vector<std::int64_t>& times) const {
    const std::size_t last = scans.size() - 1;
    const auto attempt = [&](Comparison::Scan& scan, std::int64_t& place, std::int64_t value) {
        const std::int64_t before = std::exchange(place, value);
        const bool good = value == before || (possible(scan) && difference(scans) == last);
        if (!good) place = before;
        return good;
    };
    for (Comparison::Scan& scan : scans) {
        if (attempt(scan, scan.wait_ms, 0)) continue;
        for (const std::int64_t time : times)
            if (time >= scan.wait_ms || attempt(scan, scan.wait_ms, time)) break;
    }
    const std::vector<Comparison::Variable> inputs = plugs(*charts_[0], Chart::VariableKind::Input);
    for (std::size_t scan = 0; scan < scans.size(); ++scan)
        for (std::size_t input = 0; input < scans[scan].inputs.size(); ++input) {
            const Type type = inputs[input].type;
            const std::int64_t usual = std::clamp(std::int64_t{0}, type.low, type.high);
            attempt(scans[scan], scans[scan].inputs[input], scan == 0 ? usual : scans[scan - 1].inputs[input]);
        }
    return scans;
}

}  // namespace grafverif
