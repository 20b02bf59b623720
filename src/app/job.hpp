// SPDX-License-Identifier: MIT
// Job: one run of a verb. What its options ask of the pipeline is said here, once for all verbs; each function gives one
// noun, or nothing after adding an error to the job's diagnostics.
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
class Watch;
}

namespace grafverif::app {

/// A file that was read, and what tells it from others (see file_identity).
struct InputFile {
    std::string path = {}, identity = {};
};

/// A file to be written, and what to do with it.
struct Product {
    OutputFile file = {};
    std::string use = {};
};

struct Reports;

/// One run of a verb: what was asked, what was read, what is wrong with it.
struct Job {
    Options options = {};
    Sources sources = {};
    Diagnostics diagnostics = {};
    std::string closing = {};    ///< goes to standard output after the diagnostics, so that a person reads it last
    std::istream* in = nullptr;  ///< standard input, for `-`
    std::vector<InputFile> inputs = {};  ///< of all files of the call
    std::vector<Product> products = {};  ///< of a verb that writes what it made of all its files at once
    bool depfile_written = false;
    Watch* watch = nullptr;      ///< is told of every file before it is read
    Reports* reports = nullptr;  ///< of all files of the call; never null while a verb runs
};

/// Of what is written there, as `--color` says.
Colour colour_on(const Screen& screen, const Options& options);

/// While it exists: what bounds the work of the job, Ctrl-C included, and a line on the terminal that tells how far it is.
class Bounds {
public:
    Bounds(const Options& options, const Streams& streams);

    const Limits& limits() const { return limits_; }
    bool interrupted() const { return interrupt_.asked(); }
    /// Writes `text`, whole lines, while the work goes on.
    void tell(std::string_view text) { line_.interrupt(text); }

private:
    Interrupt interrupt_;
    ProgressLine line_;
    Limits limits_;
};

/// The text of the file at `path`, as a source of the job; `-` is standard input. Only here may it be a pipe: of
/// standard input, or of a descriptor handed to us (`/dev/fd/3`).
std::optional<Id<Source>> read_source(const std::string& path, Job& job);

/// text -> Model
std::optional<Model> read_model(const std::string& path, Job& job);

/// Whether the options, or `model` for want of a loop, ask for a chart alone.
bool is_of_a_chart(const Model& model, const Options& options);
/// The loop or chart that the options name, or the only one there is.
std::optional<Id<ClosedLoop>> chosen_loop(const Model& model, Job& job);
/// Leaves the properties that `--property` names, if it names any; false after an error: the loop has no such property.
bool keep_asked(ClosedLoop& loop, Job& job);
std::optional<Id<Chart>> chosen_chart(const Model& model, Job& job);

/// The steps of a list such as `3,X5,G1.3`, the value of `option`; one that is not there, or could be several, is an error.
std::vector<Id<Chart::Step>> named_steps(const Chart& chart, std::string_view list, std::string_view option, Job& job);

ExecutionMode execution_mode(const Model& model, Id<Chart> chart, const Job& job);
ModelOptions model_options(const Options& options);
/// Of `--format`: PLCopen XML unless text is asked for.
structured_text::Form structured_text_form(const Options& options);
ConformOptions conform_options(const Options& options, const Limits& limits = {});

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, Job& job);
std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, Job& job);
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop, Job& job);

/// The test of the chart in the table of `--sequence`.
std::optional<TestSequence> test_sequence(const Model& model, Id<Chart> chart, Job& job);

}  // namespace grafverif::app
