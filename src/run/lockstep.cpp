// SPDX-License-Identifier: MIT
#include "run/lockstep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "run/scanner.hpp"

namespace grafverif {

namespace {

constexpr std::size_t most_repetitions = 100'000;  ///< maximum number of repetitions of a scan of a program

/// Executes one of the two controllers.
class Runner {
public:
    Runner(const LockstepSide& side, ExecutionMode mode) : side_(side) {
        if (side.chart != nullptr) chart_.emplace(*side.chart, mode);
        else program_.emplace(*side.program);
    }

    Comparison::ScanOutputs scan(const Comparison::Scan& scan) {
        std::vector<std::int64_t> inputs;
        for (const std::size_t place : side_.inputs) inputs.push_back(scan.inputs[place]);
        return chart_ ? scan_chart(inputs, scan.wait_ms) : scan_program(inputs, scan.wait_ms);
    }

private:
    Comparison::ScanOutputs scan_chart(const std::vector<std::int64_t>& inputs, std::int64_t wait_ms) {
        chart_->wait(wait_ms);
        Comparison::ScanOutputs answer;
        answer.stop = chart_->scan(inputs);
        answer.situation = situation_text(*side_.chart, chart_->state().situation);
        const std::vector<std::int64_t> outputs = chart_->outputs();
        for (const std::size_t own : side_.outputs) answer.outputs.push_back(outputs[own]);
        return answer;
    }

    Comparison::ScanOutputs scan_program(const std::vector<std::int64_t>& inputs, std::int64_t wait_ms) {
        Comparison::ScanOutputs answer;
        program_->scan(inputs, wait_ms);
        if (!program_->fault() && side_.settled) answer.stop = repeat(inputs);
        for (const std::size_t cell : side_.outputs) answer.outputs.push_back(program_->cells()[cell]);
        answer.run_time_fault = program_->fault().has_value();
        if (program_->fault()) answer.stop = side_.fault_text(*program_->fault());
        else if (is_stopped())
            answer.stop = fmt::format("the output `{}` is not zero", program_->layout().cells[*side_.stop].name);
        return answer;
    }

    bool is_stopped() const { return side_.stop && program_->cells()[*side_.stop] != 0; }

    /// Repeats the scan until the observed cells no longer change. If they never stop changing, returns the reason,
    /// otherwise an empty string.
    std::string repeat(const std::vector<std::int64_t>& inputs) {
        std::set<std::vector<std::int64_t>> seen;
        std::vector<std::int64_t> before = settling_values();
        for (std::size_t count = 0; count < most_repetitions && !is_stopped(); ++count) {
            if (!seen.insert(before).second)
                return "with these inputs, the program repeats its states forever [total-instability]";
            program_->scan(inputs, 0);
            std::vector<std::int64_t> after = settling_values();
            if (program_->fault() || after == before) return {};
            before = std::move(after);
        }
        if (is_stopped()) return {};
        return fmt::format("the program still changes its state after {} scans [total-instability]", most_repetitions);
    }
    std::vector<std::int64_t> settling_values() const {
        std::vector<std::int64_t> values;
        for (const std::size_t cell : *side_.settled) values.push_back(program_->cells()[cell]);
        return values;
    }

    const LockstepSide& side_;
    std::optional<Scanner> chart_ = {};
    std::optional<ProgramRun> program_ = {};
};

}  // namespace

std::array<std::vector<Comparison::ScanOutputs>, 2> Lockstep::answers(
    const std::vector<Comparison::Scan>& scans) const {
    std::array<Runner, 2> runs{Runner(sides_[0], mode_), Runner(sides_[1], mode_)};
    std::array<std::vector<Comparison::ScanOutputs>, 2> result;
    for (const Comparison::Scan& scan : scans) {
        bool stopped = false;
        for (const std::size_t k : {0U, 1U}) {
            result[k].push_back(runs[k].scan(scan));
            stopped = stopped || !result[k].back().stop.empty();
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

/// True if the inputs satisfy the constraints of both charts.
bool Lockstep::possible(const Comparison::Scan& scan) const {
    for (const LockstepSide& side : sides_) {
        if (side.chart == nullptr) continue;
        std::vector<std::int64_t> values(side.chart->variables.size());
        const std::vector<Id<Chart::Variable>> inputs = variables_of_kind(*side.chart, Chart::VariableKind::Input);
        for (std::size_t plug = 0; plug < inputs.size(); ++plug)
            values[inputs[plug].index] = scan.inputs[side.inputs[plug]];
        for (const Chart::Constraint& constraint : side.chart->constraints)
            if (evaluate(side.chart->exprs, constraint.condition, [&](const Expr& leaf) {
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
        if (times.empty()) break;
        if (attempt(scan, scan.wait_ms, 0)) continue;
        for (const std::int64_t time : times)
            if (time >= scan.wait_ms || attempt(scan, scan.wait_ms, time)) break;
    }
    for (std::size_t scan = 0; scan < scans.size(); ++scan)
        for (std::size_t input = 0; input < scans[scan].inputs.size(); ++input) {
            const Type type = inputs_[input].type;
            const std::int64_t usual = std::clamp(std::int64_t{0}, type.low, type.high);
            attempt(scans[scan], scans[scan].inputs[input], scan == 0 ? usual : scans[scan - 1].inputs[input]);
        }
    return scans;
}

}  // namespace grafverif
