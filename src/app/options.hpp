// SPDX-License-Identifier: MIT
// The command line of every command: one set of options, from which each command selects the ones it accepts.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compose/compose.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/drawing.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "report/svg.hpp"

namespace grafverif::app {

enum class Format { Text, Json, JsonLines, Latex, Xml, Sarif, Dot, Svg, Csv };
enum class DiagnosticFormat { Text, Json };
enum class ColourChoice { Auto, Always, Never };
enum class Target { Both, Uppaal, Nusmv };
enum class Engine {
    Embedded,
    Auto,
    Timed,
    Verifyta,
    Symbolic,
    Pdr,
    Bmc,
    Abc,
    Hwmcc,
    Nusmv,
    Nuxmv
};  ///< Embedded: Timed, for untimed models Symbolic; Auto: Timed, for untimed models several in parallel
/// What `supervise` may disable.
enum class Held { Both, Transitions, Outputs };
/// The program that reads a depfile.
enum class DepfileReader { Make, Ninja, CMake };
/// How time passes for a controller that runs line by line: by `wait` lines, or in real time.
enum class Clock { Simulated, Real };

struct Options {
    std::vector<std::string> operands = {};  ///< FILE, or NAME for `components`
    std::optional<std::string> output = {};  ///< -o
    std::optional<std::string> name = {};    ///< of the files of `build`
    bool create = false;                     ///< create missing output folders
    std::optional<std::string> depfile = {}, depfile_target = {};
    std::optional<DepfileReader> depfile_reader = {};  ///< Make by default
    bool all = false;                                  ///< every loop, or chart, of a file
    std::optional<std::string> loop = {};
    std::optional<std::string> chart = {};
    std::optional<std::string> other_chart = {};      ///< of `compare`
    bool all_modes = false;                           ///< of `compare`
    std::optional<std::string> from_situation = {};   ///< of `compare`: names of steps, with commas
    std::optional<std::uint64_t> resolution_ms = {};  ///< of `compare`
    std::optional<ExecutionMode> mode = {};
    std::optional<Grain> grain = {};
    ScheduleOptions untimed = {};             ///< of untimed models; its mode is the one above
    std::optional<PlantApproach> plant = {};  ///< of untimed models, as requested
    Target target = Target::Both;
    std::optional<bool> binary = {};  ///< of `aiger`; empty: according to the name of the output
    Clock clock = Clock::Simulated;
    Format format = Format::Text;  ///< of `testgen`: Csv
    TestCover cover = TestCover::Transitions;
    bool one_cycle_each = false;  ///< `--hold one`
    bool minimise = false;
    bool counts = false;  ///< no tables
    DiagnosticFormat diagnostics = DiagnosticFormat::Text;
    ColourChoice colour = ColourChoice::Auto;
    bool in_place = false;
    bool check = false;
    bool quiet = false;
    bool lossy = false;                                 ///< omit constructs that cannot be imported from another format
    std::vector<std::string> include_folders = {};      ///< -I
    std::map<std::string, std::string> constants = {};  ///< --set: values of constants of loops
    bool verbose = false;
    bool stats = false;
    bool why = false;  ///< of `check`
    bool help = false;

    std::vector<std::string> properties = {};       ///< of `check`; empty: all
    std::optional<std::string> property_file = {};  ///< of `check`: the operands are PLC programs
    std::string marked = {};                        ///< of `supervise`: a term
    Held held = Held::Both;                         ///< of `supervise`: the elements that get conditions
    Engine engine = Engine::Embedded;
    bool whole = false;               ///< no independent subsystem and no fragment is decided separately
    unsigned jobs = 0;                ///< threads; 0: one per core
    std::string engine_command = {};  ///< of Engine::Hwmcc
    bool check_untimed = false;       ///< --untimed, or an engine without time
    Ablations without = {};           ///< corrections of the method that are disabled
    std::vector<std::string> disabled_corrections = {};  ///< their names
    std::optional<std::uint64_t> max_states = {};
    std::optional<std::uint64_t> max_steps = {};                         ///< of Engine::Bmc
    std::optional<std::uint64_t> max_memory = {};                        ///< bytes
    std::optional<std::uint64_t> timeout_ms = {};                        ///< a hundred years at most
    std::optional<std::chrono::steady_clock::time_point> deadline = {};  ///< the same limit as a point in time
    std::optional<std::string> junit = {}, sarif = {};
    bool list = false;                                           ///< of `check`: list its properties
    std::optional<std::string> state_file = {}, survivors = {};  ///< of `mutate`
    std::optional<std::uint64_t> limit = {},
                                 mutant_timeout_ms = {};  ///< of `mutate`: number of mutants; time limit of each
    std::uint64_t seed = 1;                               ///< of `mutate`
    std::string date = {};                                ///< of `report`: the date shown
    std::optional<std::string> trace_vcd = {}, trace_svg = {};
    EventRange events = {};                    ///< of the trace as a timing diagram
    std::string against = {};                  ///< of `test`: the command that runs the controller under test
    std::optional<std::string> sequence = {};  ///< of `test`: the table to run; empty: generated from the chart
    std::optional<std::uint64_t> response_timeout_ms =
        {};                                            ///< of `test`: limit for one response; of `serve`: for one check
    bool stop_on_failure = false, keep_going = false;  ///< of `test`
    std::uint64_t max_evolutions = 1000;               ///< of `st`; in 32 bits
    std::optional<std::string> script = {};            ///< of `simulate`
    std::optional<std::string> exclusions = {};        ///< of `analyse`
    std::optional<std::uint64_t> random_seed = {};
    std::uint64_t steps = 100;   ///< of a random walk
    std::string situation = {};  ///< of `draw`: names of steps, with commas
    std::uint64_t columns = 0;   ///< of `draw`; 0: as many as fit on a page
    Notation notation = Notation::Iec;
    std::uint64_t port = 0;  ///< of `serve`; 0: any that is free
    bool open = false;       ///< of `serve`: open a browser
    bool stdio = false;      ///< of `lsp`: no effect, it always uses standard input and output
};

/// How a run uses the file that an option names; docs/reference/files.md states the rules of each use.
enum class PathUse { Read, Written, Updated, WrittenFolder };

struct PathOption {
    std::string_view name = {};
    std::optional<std::string> Options::*place = nullptr;
    PathUse use = PathUse::Written;
};

/// Every option that names a file or folder, except `--include`. `--output` of `build` is a folder.
inline constexpr std::array path_options = {
    PathOption{"output", &Options::output, PathUse::Written},
    PathOption{"junit", &Options::junit, PathUse::Written},
    PathOption{"sarif", &Options::sarif, PathUse::Written},
    PathOption{"trace-vcd", &Options::trace_vcd, PathUse::Written},
    PathOption{"trace-svg", &Options::trace_svg, PathUse::Written},
    PathOption{"depfile", &Options::depfile, PathUse::Written},
    PathOption{"state", &Options::state_file, PathUse::Updated},
    PathOption{"survivors", &Options::survivors, PathUse::WrittenFolder},
    PathOption{"script", &Options::script, PathUse::Read},
    PathOption{"sequence", &Options::sequence, PathUse::Read},
    PathOption{"exclusions", &Options::exclusions, PathUse::Read},
    PathOption{"properties", &Options::property_file, PathUse::Read},
};

struct NamedPath {
    std::string_view option = {};
    std::string path = {};
    PathUse use = PathUse::Written;
};
/// The paths that `options` name, in the order of the list.
std::vector<NamedPath> named_paths(const Options& options);

/// The groups of options that a command may accept, in addition to those that all commands accept. File: commands that
/// read a file; Timeout: commands without another time limit; Writes: commands that may write files; Command: a command
/// that runs another command, to which all following arguments belong.
enum class OptionGroup {
    Always,
    File,
    Timeout,
    Writes,
    All,
    Output,
    OutputDirectory,
    Loop,
    Constants,
    Chart,
    Mode,
    Grain,
    Untimed,
    Target,
    Questions,
    Format,
    FormatLatex,
    FormatAiger,
    InPlace,
    Search,
    Verdicts,
    Traces,
    Walk,
    Verbose,
    Stats,
    Ablations,
    Clock,
    Bench,
    Sequence,
    FormatXml,
    MaxEvolutions,
    Analysis,
    FormatDiagram,
    FormatTest,
    Cover,
    Supervision,
    Minimise,
    Limits,
    Date,
    Drawing,
    Compare,
    Mutants,
    Serve,
    Lsp,
    Command
};

/// Operand count of a command that processes several files sequentially.
inline constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

struct CliCommand {
    std::string name = {};
    std::string operand = {};  ///< as shown in the usage line: `FILE`, `FILE...`, `[NAME]`
    std::size_t least_operands = 1, most_operands = 1;
    std::string summary = {};      ///< one line, for the list of commands
    std::string description = {};  ///< for --help
    std::vector<std::string> examples = {};
    std::vector<OptionGroup> accepts = {};
};

/// A deprecated name of an option, as passed, and the current one.
struct FormerName {
    std::string former = {}, name = {};
};

/// The options in `arguments` (without the command's name), or an error message.
struct ParsedOptions {
    std::optional<Options> options = {};
    std::string error_text = {};
    std::vector<FormerName> former_names = {};  ///< in the order of the arguments
};
ParsedOptions parse_options(const CliCommand& verb, std::span<const std::string> arguments);

/// True if the command accepts the options of the group.
bool accepts(const CliCommand& verb, OptionGroup what);

/// The table entry of an option of a command, for help, manual pages and completion.
struct OptionText {
    std::string name = {};    ///< without dashes: `output`
    std::string letter = {};  ///< `o`, or empty
    std::string value = {};   ///< placeholder of its value: `FILE`, `text|json`; empty: it has none
    std::string help = {};
};
/// The visible options of a command, in the order of --help.
std::vector<OptionText> option_texts(const CliCommand& verb);

/// `grafverif COMMAND --help`.
void print_help(const CliCommand& verb, std::ostream& out);

}  // namespace grafverif::app
