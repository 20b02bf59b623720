// SPDX-License-Identifier: MIT
// The pipeline: the only place where the verbs of the house meet, in order. Each function runs the arrows up to one
// noun and returns it, or nothing after adding an error to the job's diagnostics.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "app/system/interrupt.hpp"
#include "app/options.hpp"
#include "app/program.hpp"
#include "check/external/verifyta.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/location_automaton.hpp"
#include "grafverif/ir/mealy.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif::app {

/// A file that was read, and what tells it from others (see file_identity).
struct InputFile {
    std::string path = {}, identity = {};
};

/// One run of a verb: what was asked, what was read, what is wrong with it.
struct Job {
    Options options = {};
    Sources sources = {};
    Diagnostics diagnostics = {};
    std::string closing = {};   ///< goes to standard output after the diagnostics, so that a person reads it last
    std::istream* in = nullptr;   ///< standard input, for `-`
    std::vector<InputFile> inputs = {};
};

/// The text of the file at `path`, as a source of the job; `-` is standard input. Only here may it be a pipe: of
/// standard input, or of a descriptor handed to us (`/dev/fd/3`).
std::optional<Id<Source>> read_source(const std::string& path, Job& job);

/// text -> Model
std::optional<Model> read_model(const std::string& path, Job& job);

/// The loop or chart that the options name, or the only one there is.
std::optional<Id<ClosedLoop>> chosen_loop(const Model& model, Job& job);
std::optional<Id<Chart>> chosen_chart(const Model& model, Job& job);

/// How `chart` is executed, whatever a verb makes of it without its loop: as the options say, or else as every loop that
/// runs it says, or else with stability search.
ExecutionMode execution_mode(const Model& model, Id<Chart> chart, const Job& job);

/// Chart -> Equations
std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, Job& job);

/// The test of the chart in the table of `--sequence`.
std::optional<TestSequence> test_sequence(const Model& model, Id<Chart> chart, Job& job);
/// Equations -> LocationAutomaton -> MealyMachine -> TestSequence, with progress on a terminal. `partial`: what was found
/// until a limit, the deadline or Ctrl-C ends the search will do.
std::optional<LocationAutomaton> automaton_of(const Model& model, Id<Chart> chart, Job& job, const Streams& streams,
                                              const Interrupt& interrupt, bool partial = false);
std::optional<MealyMachine> mealy_of(const Model& model, Id<Chart> chart, Job& job, const Streams& streams,
                                     const Interrupt& interrupt);
std::optional<TestSequence> test_of(const Model& model, Id<Chart> chart, const MealyMachine& machine, Job& job);

/// ClosedLoop -> plant -> Network
std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, Job& job);

/// ClosedLoop -> TransitionSystem, by the options of untimed models: of the controllers alone, or with plant automata.
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop, Job& job);

/// Equations -> TransitionSystem of a lone chart, in its execution_mode.
TransitionSystem controller_of(const Model& model, Id<Chart> chart, const Equations& equations, const Job& job);

/// Equations, TestSequence -> Structured Text in the form of `--format`. Empty after an error.
std::string structured_text_controller(const Equations& equations, ExecutionMode mode, Job& job);
std::string structured_text_test(const TestSequence& test, const Job& job);

/// Network -> UPPAAL project and its queries; TransitionSystem -> NuSMV model. Warn of properties left out.
struct UppaalProject {
    std::string project = {};
    std::string queries = {};
};
UppaalProject uppaal_project(const Network& network, Job& job);

/// Network -> UPPAAL project and what to ask of it, a formula per verdict.
struct UppaalQuestions {
    std::string project = {};
    std::vector<ExternalQuestion> questions = {};
};
UppaalQuestions uppaal_questions(const Network& network);

std::string nusmv_model(const TransitionSystem& system, Job& job);

}  // namespace grafverif::app
