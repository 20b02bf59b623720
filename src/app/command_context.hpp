// SPDX-License-Identifier: MIT
// Context of one execution of a command. The functions of this file translate the options to calls of the pipeline for
// all commands. A function that returns an empty optional has added an error to the diagnostics of the context.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/options.hpp"
#include "app/program.hpp"
#include "app/progress_line.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/write_files.hpp"
#include "emit/structured_text/structured_text.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif {
class FileWatcher;
}

namespace grafverif::app {

/// A file that was read, and its identity (see file_identity).
struct InputFile {
    std::string path = {}, identity = {};
};

/// A file to be written, and the description of its content in the list of written files.
struct Product {
    OutputFile file = {};
    std::string use = {};
};

struct Reports;

/// One execution of a command: options, files read, diagnostics.
struct CommandContext {
    Options options = {};
    Sources sources = {};
    Diagnostics diagnostics = {};
    std::string closing = {};    ///< text printed to standard output after the diagnostics, so that users read it last
    std::istream* in = nullptr;  ///< standard input, used for `-`
    std::vector<InputFile> inputs = {};  ///< input files of the complete invocation
    std::vector<Product> products = {};  ///< outputs of a command that writes the results of all input files as one set
    bool depfile_written = false;
    FileWatcher* watch = nullptr;  ///< records every file before it is read

    /// Report files of the invocation, which cover all its input files; never null during the execution of a command.
    Reports* reports = nullptr;
};

/// Returns the colour mode of output to `screen`, according to `--color`.
Colour colour_on(const Screen& screen, const Options& options);

/// Prints internal errors, one line each.
void print_failures(const std::vector<std::string>& failures, const Streams& streams);

/// While an object exists, the limits of time and memory and Ctrl-C apply to the command, and a progress line is shown
/// on the terminal.
class ResourceLimits {
public:
    ResourceLimits(const Options& options, const Streams& streams);

    const Limits& limits() const { return limits_; }
    bool interrupted() const { return interrupt_.requested(); }
    /// Prints `text`, which consists of complete lines, while the work continues.
    void print(std::string_view text) { line_.interrupt(text); }

private:
    Interrupt interrupt_;
    ProgressLine line_;
    Limits limits_;
};

/// Returns the text of the file at `path` as a source of the context; `-` is standard input. The file may be a pipe:
/// standard input, or an inherited descriptor (`/dev/fd/3`). No other function that reads files accepts a pipe.
std::optional<Id<Source>> read_source(const std::string& path, CommandContext& job);

/// Sets the cycle times of all controllers to zero.
void remove_task_cycles(Model& model);
/// Reads and parses the file at `path`, and returns its Model.
std::optional<Model> read_model(const std::string& path, CommandContext& job);
/// Parses `file`, which read_source returned for `path`, and returns its Model.
std::optional<Model> read_model(Id<Source> file, const std::string& path, CommandContext& job);

/// True if the options select a chart without a loop, or `model` has no loop.
bool is_of_a_chart(const Model& model, const Options& options);
/// Returns the loop that the options select; by default, the only loop of the model.
std::optional<Id<ClosedLoop>> chosen_loop(const Model& model, CommandContext& job);
/// If `--property` is given, keeps only the properties that it names. Returns false after an error: `--property` names
/// a property that does not exist.
bool keep_requested(ClosedLoop& loop, CommandContext& job);
/// Returns the chart that the options select; by default, the only chart of the model.
std::optional<Id<Chart>> chosen_chart(const Model& model, CommandContext& job);

/// Returns the steps of a list such as `3,X5,G1.3`, which is the value of `option`. A step that does not exist or is
/// ambiguous is an error.
std::vector<Id<Chart::Step>> named_steps(const Chart& chart, std::string_view list, std::string_view option,
                                         CommandContext& job);

ExecutionMode execution_mode(const Model& model, Id<Chart> chart, const CommandContext& job);
/// Returns the options with which commands read variants of the model again.
ReadOptions read_options(const Options& options);
ModelOptions model_options(const Options& options);
/// Returns the options of the models of `loop`. The result differs from model_options(options) if the loop has a task
/// cycle: an untimed model of such a loop has plant automata unless `--plant` is present.
ModelOptions model_options(const Options& options, const ClosedLoop& loop);
/// Returns the output format selected by `--format`; the default is PLCopen XML.
structured_text::Form structured_text_form(const Options& options);
ConformOptions conform_options(const Options& options, const Limits& limits = {});

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, CommandContext& job);
std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, CommandContext& job);
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop, CommandContext& job);

/// Reads the table given by `--sequence`, which contains a test of the chart.
std::optional<TestSequence> test_sequence(const Model& model, Id<Chart> chart, CommandContext& job);

}  // namespace grafverif::app
