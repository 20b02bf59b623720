// SPDX-License-Identifier: MIT
// Context of one run of a command. Translates its options into calls of the pipeline, once for all commands; each
// function returns one result, or nothing after adding an error to the job's diagnostics.
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

/// A file to be written, and how to write it.
struct Product {
    OutputFile file = {};
    std::string use = {};
};

struct Reports;

/// One run of a command: options, files read, diagnostics.
struct CommandContext {
    Options options = {};
    Sources sources = {};
    Diagnostics diagnostics = {};
    std::string closing = {};    ///< written to standard output after the diagnostics, so that users read it last
    std::istream* in = nullptr;  ///< standard input, for `-`
    std::vector<InputFile> inputs = {};  ///< of all files of the invocation
    std::vector<Product> products = {};  ///< of a command that writes the results of all its files together
    bool depfile_written = false;
    FileWatcher* watch = nullptr;  ///< notes every file before it is read
    Reports* reports = nullptr;    ///< of all files of the invocation; never null while a command runs
};

/// The colour mode of output written there, according to `--color`.
Colour colour_on(const Screen& screen, const Options& options);

/// Limits of the job's work while the object exists, including Ctrl-C; also shows a progress line on the terminal.
class ResourceLimits {
public:
    ResourceLimits(const Options& options, const Streams& streams);

    const Limits& limits() const { return limits_; }
    bool interrupted() const { return interrupt_.requested(); }
    /// Writes `text`, which consists of complete lines, while the work continues.
    void print(std::string_view text) { line_.interrupt(text); }

private:
    Interrupt interrupt_;
    ProgressLine line_;
    Limits limits_;
};

/// The text of the file at `path`, as a source of the job; `-` is standard input. Only here may it be a pipe: standard
/// input, or an inherited descriptor (`/dev/fd/3`).
std::optional<Id<Source>> read_source(const std::string& path, CommandContext& job);

/// text -> Model
std::optional<Model> read_model(const std::string& path, CommandContext& job);

/// True if the options select a chart alone, or `model` has no loop.
bool is_of_a_chart(const Model& model, const Options& options);
/// The loop or chart that the options name, or the only one.
std::optional<Id<ClosedLoop>> chosen_loop(const Model& model, CommandContext& job);
/// Keeps only the properties that `--property` names, if it names any; false after an error: no such property.
bool keep_requested(ClosedLoop& loop, CommandContext& job);
std::optional<Id<Chart>> chosen_chart(const Model& model, CommandContext& job);

/// The steps of a list such as `3,X5,G1.3`, the value of `option`; a step that does not exist or is ambiguous is an
/// error.
std::vector<Id<Chart::Step>> named_steps(const Chart& chart, std::string_view list, std::string_view option,
                                         CommandContext& job);

ExecutionMode execution_mode(const Model& model, Id<Chart> chart, const CommandContext& job);
ModelOptions model_options(const Options& options);
/// The form selected by `--format`: PLCopen XML unless text is requested.
structured_text::Form structured_text_form(const Options& options);
ConformOptions conform_options(const Options& options, const Limits& limits = {});

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, CommandContext& job);
std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, CommandContext& job);
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop, CommandContext& job);

/// The test of the chart in the table of `--sequence`.
std::optional<TestSequence> test_sequence(const Model& model, Id<Chart> chart, CommandContext& job);

}  // namespace grafverif::app
