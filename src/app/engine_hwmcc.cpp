// SPDX-License-Identifier: MIT
// Runs an external model checker that reads AIGER: ABC from the PATH, or the command given by `--engine-command`.
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/engines.hpp"
#include "app/system/process.hpp"
#include "check/external/hwmcc.hpp"
#include "emit/aiger/aiger.hpp"
#include "pipeline/files.hpp"
#include "support/messages.hpp"

namespace grafverif::app {

namespace {

constexpr const char *model_file = "model.aig", *witness_file = "witness", *invariant_file = "invariant.pla";

[[noreturn]] void no_result(const ProgramResult& program_result) {
    const bool stopped =
        program_result.end == ProgramResult::End::TimedOut || program_result.end == ProgramResult::End::Stopped;
    throw Undecided{stopped ? UnknownReason::Stopped : UnknownReason::Failed, hwmcc::failure_of(program_result)};
}

[[noreturn]] void disbelieve(const std::string& why) {
    throw Undecided{UnknownReason::Disagrees, std::string(word(UnknownReason::Disagrees)) + ": " + why};
}

/// One call of an external program, with its files in a separate temporary folder.
class HwmccQuery {
public:
    HwmccQuery(const Circuit& circuit, Gates::Literal bad, const pdr::LimitMonitor& watch,
               const std::atomic<bool>* stop)
        : circuit_(hwmcc::with_numbers(circuit)), watch_(watch), stop_(stop) {
        aiger::AigerText written =
            aiger::written(circuit_, {{"b0", bad, {}}}, aiger::Form::Binary, aiger::Extent::Cone);
        numbering_ = {std::move(written.inputs), std::move(written.latches)};
        folder_.write(model_file, written.text);
    }

    ProgramResult run(const std::vector<std::string>& arguments) const {
        return run_program(arguments, "", {.deadline = watch_.deadline(), .stop = stop_, .folder = folder_.path()});
    }
    /// Returns the content of a file that the program wrote, or an empty string if the program wrote no such file.
    std::string left(const char* name) const {
        std::string why;
        return content_of_file(folder_.path() / name, why).value_or("");
    }
    /// Returns the run that a witness describes. The run is not validated yet.
    pdr::PdrAnswer reached(const std::string& witness) const {
        auto inputs = hwmcc::read_witness(circuit_, numbering_, witness);
        if (!inputs) disbelieve("the program printed no trace for its verdict");
        return {.reached = true, .inputs = std::move(*inputs)};
    }
    const Circuit& circuit() const { return circuit_; }
    const pdr::LimitMonitor& watch() const { return watch_; }

private:
    Circuit circuit_;
    const pdr::LimitMonitor& watch_;
    const std::atomic<bool>* stop_ = nullptr;
    hwmcc::Numbering numbering_ = {};
    TemporaryFolder folder_ = TemporaryFolder();
};

/// Runs ABC: `bmc3` searches for short counterexamples during a tenth of the remaining time; then `pdr` decides the
/// property.
pdr::PdrAnswer query_abc(const std::string& program, const HwmccQuery& question) {
    using Seconds = std::chrono::duration<double>;
    const auto deadline = question.watch().deadline();
    const double left = deadline ? Seconds(*deadline - std::chrono::steady_clock::now()).count() : 20;
    const int near = std::clamp(static_cast<int>(left / 10), 1, 60);
    const std::string read = std::string("read_aiger ") + model_file + "; ";
    const std::string write_trace = std::string("; write_cex -a ") + witness_file;
    const ProgramResult bounded =
        question.run({program, "-q", read + "bmc3 -F 70 -T " + std::to_string(near) + write_trace});
    if (bounded.end != ProgramResult::End::Exited) no_result(bounded);
    if (const std::string witness = question.left(witness_file); !witness.empty())
        return question.reached(hwmcc::witness_of_abc(witness));
    const ProgramResult program_result =
        question.run({program, "-q", read + "pdr -d -I " + invariant_file + write_trace});
    if (program_result.end != ProgramResult::End::Exited) no_result(program_result);
    if (const std::string witness = question.left(witness_file); !witness.empty())
        return question.reached(hwmcc::witness_of_abc(witness));
    const std::string text = question.left(invariant_file);
    if (text.empty()) no_result(program_result);
    auto invariant = hwmcc::read_invariant(question.circuit(), text);
    if (!invariant) disbelieve("the program printed no invariant for its verdict");
    return {.invariant = std::move(*invariant)};
}

pdr::PdrAnswer query_command(const std::string& command, const HwmccQuery& question) {
    const ProgramResult program_result = question.run({"/bin/sh", "-c", command + " " + model_file});
    if (program_result.end != ProgramResult::End::Exited) no_result(program_result);
    const std::optional<bool> reached = hwmcc::witness_result(program_result.out);
    if (!reached) no_result(program_result);
    if (*reached) return question.reached(program_result.out);
    throw Undecided{UnknownReason::Unchecked,
                    "unchecked: the program reports that no run reaches the target state, but prints no certificate to "
                    "check"};
}

}  // namespace

std::optional<Report> check_by_abc(const SystemToCheck& check, const CheckOptions& options, Diagnostics& diagnostics) {
    auto path = find_program("berkeley-abc");
    if (!path) path = find_program("abc");
    if (!path) {
        diagnostics.add(messages::missing_program("berkeley-abc", "--engine pdr"));
        return {};
    }
    return check_states(check, options, {"abc", search_by_abc(path->string(), options.limits.stop)});
}

decltype(PdrOptions::reach) search_by_abc(std::string program, const std::atomic<bool>* stop) {
    return [program = std::move(program), stop](const Circuit& circuit, Gates::Literal bad, pdr::LimitMonitor& watch) {
        return query_abc(program, HwmccQuery(circuit, bad, watch, stop));
    };
}

std::optional<Report> check_by_command(const SystemToCheck& check, const std::string& command,
                                       const CheckOptions& options) {
    return check_states(check, options,
                        {command, [&](const Circuit& circuit, Gates::Literal bad, pdr::LimitMonitor& watch) {
                             return query_command(command, HwmccQuery(circuit, bad, watch, options.limits.stop));
                         }});
}

}  // namespace grafverif::app
