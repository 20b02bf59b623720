// SPDX-License-Identifier: MIT
// Options of all commands. Every command accepts a subset of these options.
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
#include "emit/structured_text/structured_text.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/drawing.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "report/svg.hpp"

namespace grafverif::app {

enum class Format { Text, Json, JsonLines, Latex, Xml, Sarif, Dot, Svg, Csv };
enum class DiagnosticFormat { Text, Json };
enum class ColourChoice { Auto, Always, Never };
/// Cycle time of controllers with a task cycle. `Both` selects the task cycle, and adds a note to
/// each verdict that differs if the cycle time is zero.
enum class CycleTime { Task, Zero, Both };
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
};  ///< Embedded and Auto select Timed for timed models, and check_together for untimed models

/// Elements to which `supervise` adds conditions.
enum class Held { Both, Transitions, Outputs };
/// Program that reads a depfile.
enum class DepfileReader { Make, Ninja, CMake };
/// Defines how time passes for a controller that is driven line by line: by `wait` lines, or in real time.
enum class Clock { Simulated, Real };

/// Options of `tune`.
struct TuneOptions {
    std::vector<std::string> ranges = {};  ///< values of --over: `NAME=LOW..HIGH` or `NAME=LOW..HIGH:STEP`
    bool every_point = false;              ///< true: check each point separately
};

/// Options of `faults`.
struct FaultsOptions {
    std::uint64_t order = 1;  ///< maximum number of faults of a combination
};

/// Options of `st`.
struct StOptions {
    /// Maximum number of evolutions in one cycle under stability search; less than 2^32. Empty
    /// selects 1000 or, with `prove`, the first number tried that is sufficient.
    std::optional<std::uint64_t> max_evolutions = {};
    structured_text::Dialect dialect = structured_text::Dialect::Iec;
    bool prove = false;  ///< prove that the program is equivalent to the chart before it is written
};

struct Options {
    std::vector<std::string> operands = {};  ///< operands: FILE, or NAME for `components`
    std::optional<std::string> output = {};  ///< value of -o
    std::optional<std::string> name = {};    ///< name of the files that `build` writes
    bool create = false;                     ///< true: create missing output folders
    std::optional<std::string> depfile = {}, depfile_target = {};
    std::optional<DepfileReader> depfile_reader = {};  ///< reader of the depfile; default: Make
    bool all = false;                                  ///< true: process all loops or charts of a file
    std::optional<std::string> loop = {};
    std::optional<std::string> chart = {};
    std::optional<std::string> other_chart = {};      ///< chart of OTHER (`--other-chart` of `compare`)
    bool all_modes = false;                           ///< true: compare in each execution mode
    std::optional<std::string> from_situation = {};   ///< initial steps for `compare`, separated by commas
    std::optional<std::uint64_t> resolution_ms = {};  ///< `--resolution` of `compare` and `st`
    bool settled = false;                             ///< `compare`: compare outputs after repeated scans
    bool imported_charts = false;                     ///< true: use the charts that `import` creates from programs
    std::vector<std::string> renamings = {},
                             ignored_outputs = {};  ///< `--map` of `compare` and `replay`; `--ignore` of `compare`
    std::string stop_output = {};                   ///< `--stop-output` of `compare`
    std::optional<ExecutionMode> mode = {};
    std::optional<Grain> grain = {};
    CycleTime cycle = CycleTime::Task;
    ScheduleOptions untimed = {};             ///< options of untimed models; the member `mode` is not used
    std::optional<PlantApproach> plant = {};  ///< value of `--plant`, the plant of untimed models
    Target target = Target::Both;
    std::optional<bool> binary = {};  ///< option of `aiger`; if empty, the name of the output determines the form
    Clock clock = Clock::Simulated;
    Format format = Format::Text;  ///< output format; Csv is only for `testgen`
    TestCover cover = TestCover::Transitions;
    bool one_cycle_each = false;  ///< true for `--hold one`
    bool minimise = false;
    bool counts = false;  ///< true: print no tables
    DiagnosticFormat diagnostics = DiagnosticFormat::Text;
    ColourChoice colour = ColourChoice::Auto;
    bool in_place = false;
    bool check = false;
    bool quiet = false;
    bool lossy = false;                             ///< true: omit constructs of other formats that cannot be imported
    std::vector<std::string> include_folders = {};  ///< values of -I
    std::vector<std::string> within = {};           ///< values of --within: folders to which reading is restricted
    std::map<std::string, std::string> constants = {};  ///< values of --set: constants of loops by name
    bool verbose = false;
    bool stats = false;
    bool why = false;  ///< true: `check` explains the proofs
    TuneOptions tune = {};
    FaultsOptions faults = {};
    StOptions st = {};
    bool help = false;

    std::vector<std::string> properties = {};       ///< option of `check`: names of properties; all if empty
    std::optional<std::string> property_file = {};  ///< for `check` of PLC programs: YAML file of the properties
    std::string marked = {};                        ///< condition that `supervise` keeps reachable

    /// Option of `supervise`: the elements to which conditions are added.
    Held held = Held::Both;
    Engine engine = Engine::Embedded;
    bool whole = false;               ///< true: do not decide independent subsystems or fragments separately
    unsigned jobs = 0;                ///< number of threads; 0 selects one per core
    std::string engine_command = {};  ///< shell command that Engine::Hwmcc executes
    bool check_untimed = false;       ///< true: check untimed models
    Ablations without = {};           ///< corrections of the method that are disabled
    std::vector<std::string> disabled_corrections = {};  ///< names of the corrections in `without`
    std::optional<std::uint64_t> max_states = {};
    std::optional<std::uint64_t> max_steps = {};   ///< maximum length of a trace for Engine::Bmc
    std::optional<std::uint64_t> max_memory = {};  ///< memory limit in bytes
    std::optional<std::uint64_t> timeout_ms = {};  ///< time limit in milliseconds; at most a hundred years
    std::optional<std::chrono::steady_clock::time_point> deadline = {};  ///< the time limit as a point in time
    std::optional<std::string> junit = {}, sarif = {};
    bool list = false;                                           ///< true: `check` only lists the properties
    std::optional<std::string> state_file = {}, survivors = {};  ///< output of `mutate`: results, undetected mutants

    /// Options of `mutate`: maximum number of mutants; time limit for each mutant in milliseconds.
    std::optional<std::uint64_t> limit = {}, mutant_timeout_ms = {};
    std::uint64_t seed = 1;  ///< seed of `mutate` for the selection of mutants
    std::string date = {};   ///< date that the HTML report of `report` shows
    std::optional<std::string> trace_vcd = {}, trace_svg = {};
    std::optional<std::string> certificate = {};  ///< folder in which `check` writes a certificate
    EventRange events = {};                       ///< range of events that the timing diagram shows
    std::string against = {};                     ///< option of `test`: the command that runs the controller under test

    /// File with the table of a test; if empty, `test` generates the test from the chart.
    std::optional<std::string> sequence = {};
    /// Time limit in milliseconds: for one response (`test`), one check (`serve`, `edit` and `lsp`) or one call
    /// (`mcp`).
    std::optional<std::uint64_t> response_timeout_ms = {};
    bool stop_on_failure = false, keep_going = false;  ///< options of `test`: stop or continue after a failure
    std::optional<std::string> open_psa = {};          ///< fault tree that `faults` writes
    std::optional<std::string> page = {};              ///< HTML report of `check`, `faults`, `replay` and `tune`
    std::optional<std::string> log = {};               ///< recording that `replay` checks
    std::optional<std::uint64_t> jitter_ms = {};       ///< maximum time error of a recording (`--jitter`)
    std::vector<std::string> skews = {};               ///< clock offsets of a recording (`--skew`)
    std::optional<std::string> script = {};            ///< script file of `simulate`
    std::optional<std::string> exclusions = {};        ///< CSV table of exclusive inputs, for `analyse`
    std::optional<std::uint64_t> random_seed = {};
    std::uint64_t steps = 100;   ///< number of steps of a random walk
    std::string situation = {};  ///< active steps in the drawing of `draw`, separated by commas
    std::uint64_t columns = 0;   ///< number of columns of `draw`; 0 selects as many as fit on a page
    Notation notation = Notation::Iec;
    std::uint64_t port = 0;  ///< port of `serve` and `edit`; 0 selects any free port
    bool open = false;       ///< true: `serve` and `edit` open a browser
    bool stdio = false;      ///< option of `lsp` without effect: the server always uses standard input and output
};

/// Defines how a command uses the file that an option names. docs/reference/files.md states the rules for each use.
enum class PathUse { Read, Written, Updated, WrittenFolder };

struct PathOption {
    std::string_view name = {};
    std::optional<std::string> Options::*place = nullptr;
    PathUse use = PathUse::Written;
};

/// Every option that names a file or folder, except `--include` and `--within`. For `build`, `--output` names a folder.
inline constexpr std::array path_options = {
    PathOption{"output", &Options::output, PathUse::Written},
    PathOption{"junit", &Options::junit, PathUse::Written},
    PathOption{"sarif", &Options::sarif, PathUse::Written},
    PathOption{"trace-vcd", &Options::trace_vcd, PathUse::Written},
    PathOption{"trace-svg", &Options::trace_svg, PathUse::Written},
    PathOption{"openpsa", &Options::open_psa, PathUse::Written},
    PathOption{"report", &Options::page, PathUse::Written},
    PathOption{"depfile", &Options::depfile, PathUse::Written},
    PathOption{"state", &Options::state_file, PathUse::Updated},
    PathOption{"survivors", &Options::survivors, PathUse::WrittenFolder},
    PathOption{"certificate", &Options::certificate, PathUse::WrittenFolder},
    PathOption{"script", &Options::script, PathUse::Read},
    PathOption{"sequence", &Options::sequence, PathUse::Read},
    PathOption{"log", &Options::log, PathUse::Read},
    PathOption{"exclusions", &Options::exclusions, PathUse::Read},
    PathOption{"properties", &Options::property_file, PathUse::Read},
};

struct NamedPath {
    std::string_view option = {};
    std::string path = {};
    PathUse use = PathUse::Written;
};
/// Returns the paths that `options` contain, in the order of `path_options`.
std::vector<NamedPath> named_paths(const Options& options);

/// The groups of options that a command may accept, in addition to those that all commands accept. File: commands that
/// read a file; Timeout: commands without another time limit; Writes: commands that may write files; Command: commands
/// that run another command and pass all arguments after its name to it.
enum class OptionGroup {
    Always,
    File,
    Within,
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
    Cycle,
    CycleBoth,
    Untimed,
    Target,
    Questions,
    Format,
    FormatLatex,
    FormatAiger,
    InPlace,
    Search,
    Verdicts,
    ProgramProperties,
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
    StructuredText,
    Analysis,
    FormatDiagram,
    FormatTest,
    Cover,
    Supervision,
    Tuning,
    Faults,
    Minimise,
    Limits,
    Date,
    Drawing,
    Compare,
    Log,
    Recording,
    Mutants,
    Serve,
    Lsp,
    Mcp,
    Command
};

/// Maximum number of operands of a command that processes any number of files sequentially.
inline constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

struct CliCommand {
    std::string name = {};
    std::string operand = {};  ///< operand in the usage line: `FILE`, `FILE...`, `[NAME]`
    std::size_t least_operands = 1, most_operands = 1;
    std::string summary = {};      ///< one line for the list of commands
    std::string description = {};  ///< text that the help of the command shows
    std::vector<std::string> examples = {};
    std::vector<OptionGroup> accepts = {};
};

/// A deprecated name of an option, as it was passed, and the current name.
struct FormerName {
    std::string former = {}, name = {};
};

/// The result of parsing the arguments after the command's name: the options, or an error message.
struct ParsedOptions {
    std::optional<Options> options = {};
    std::string error_text = {};
    std::vector<FormerName> former_names = {};  ///< former names in the order of the arguments
};
ParsedOptions parse_options(const CliCommand& verb, std::span<const std::string> arguments);

/// True if the command accepts the options of the group.
bool accepts(const CliCommand& verb, OptionGroup what);

/// The table entry of an option of a command, for help, manual pages and completion.
struct OptionText {
    std::string name = {};    ///< name without dashes: `output`
    std::string letter = {};  ///< letter such as `o`; may be empty
    std::string value = {};   ///< placeholder of its value: `FILE`, `text|json`; empty if the option has no value
    std::string help = {};
};
/// Returns the visible options of a command, in the order of --help.
std::vector<OptionText> option_texts(const CliCommand& verb);

/// Prints the text of `grafverif COMMAND --help`.
void print_help(const CliCommand& verb, std::ostream& out);

}  // namespace grafverif::app
