// SPDX-License-Identifier: MIT
#include "app/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <new>
#include <optional>
#include <ostream>
#include <sstream>
#include <system_error>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/reports.hpp"
#include "app/system/watchdog.hpp"
#include "support/messages.hpp"
#include "support/messages_system.hpp"
#include "support/printable.hpp"
#include "support/render.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::app {

namespace {

struct Entry {
    CliCommand (*usage)() = nullptr;
    ExitCode (*run)(CommandContext&, const Streams&) = nullptr;
    void (*list)(CommandContext&) = nullptr;  ///< adds a list of the written files to the output
};

constexpr std::array entries = {
    Entry{init_usage, init},
    Entry{build_usage, build, list_products},
    Entry{uppaal_usage, uppaal},
    Entry{nusmv_usage, nusmv},
    Entry{aiger_usage, aiger},
    Entry{pins_usage, pins},
    Entry{btor2_usage, btor2},
    Entry{draw_usage, draw},
    Entry{equations_usage, equations},
    Entry{components_usage, components},
    Entry{fmt_usage, fmt},
    Entry{import_usage, import_chart},
    Entry{check_usage, check},
    Entry{report_usage, report},
    Entry{simulate_usage, simulate},
    Entry{serve_usage, serve},
    Entry{edit_usage, edit},
    Entry{watch_usage, watch},
    Entry{lsp_usage, lsp},
    Entry{mcp_usage, mcp},
    Entry{analyse_usage, analyse},
    Entry{compare_usage, compare},
    Entry{mutate_usage, mutate},
    Entry{supervise_usage, supervise},
    Entry{tune_usage, tune},
    Entry{faults_usage, faults},
    Entry{automaton_usage, automaton},
    Entry{mealy_usage, mealy},
    Entry{testgen_usage, testgen},
    Entry{plc_usage, plc},
    Entry{test_usage, test},
    Entry{replay_usage, replay},
    Entry{monitor_usage, monitor},
    Entry{st_usage, st},
    Entry{c_usage, c},
    Entry{manual_usage, manual},
    Entry{completion_usage, completion},
};

void print_overview(std::ostream& out) {
    out << "grafverif: verifies GRAFCET charts (IEC 60848) in closed loop with models of their plants\n"
           "\n"
           "Usage: grafverif COMMAND [FILE] [options]\n"
           "\n"
           "Commands:\n";
    for (const Entry& entry : entries) out << fmt::format("  {:<12}{}\n", entry.usage().name, entry.usage().summary);
    out << "\n"
           "`grafverif help COMMAND` describes the options of a command, with examples; `grafverif --version` prints "
           "the version.\n"
           "FILE can be `-` for standard input, and an output can be `-` for standard output. Outputs are written "
           "completely or "
           "not at all.\n"
           "Exit codes: 0 success, all verdicts as expected; 1 unexpected verdict or model error; 2 invalid input or "
           "usage; 3 unknown verdict, or stopped by a limit or a signal; 4 internal error.\n";
}

ExitCode usage_error(const Streams& streams, const std::string& error_text, const std::string& help) {
    streams.err << fmt::format("grafverif: error: {}; see `grafverif {}--help`\n", printable(error_text), help);
    return ExitCode::Input;
}

void render(const std::vector<Diagnostic>& shown, const CommandContext& job, const Streams& streams,
            std::ostream& out) {
    if (job.options.diagnostics == DiagnosticFormat::Text)
        render_text(shown, job.sources, colour_on(streams.err_screen, job.options),
                    streams.err_screen.columns == 0 ? usual_columns : streams.err_screen.columns, out);
    else if (!shown.empty()) render_json(shown, job.sources, out);
}

void render_diagnostics(const CommandContext& job, const Streams& streams) {
    std::vector<Diagnostic> shown;
    for (const Diagnostic& diagnostic : job.diagnostics.all())
        if (!job.options.quiet || diagnostic.severity == Severity::Error) shown.push_back(diagnostic);
    render(shown, job, streams, streams.err);
    if (job.options.diagnostics == DiagnosticFormat::Text && job.diagnostics.distinct_errors() > Diagnostics::limit)
        streams.err << fmt::format("and {} more errors\n", job.diagnostics.distinct_errors() - Diagnostics::limit);
}

WatchdogOptions orders(const CommandContext& job, const Streams& streams) {
    const auto rendered = [&](const Diagnostic& diagnostic) {
        std::ostringstream text;
        render({diagnostic}, job, streams, text);
        return std::move(text).str();
    };
    const Options& options = job.options;
    WatchdogOptions orders{.max_memory = options.max_memory};
    if (options.timeout_ms) orders.timeout = std::chrono::milliseconds(*options.timeout_ms);
    orders.timed_out = rendered(messages::timed_out(options.timeout_ms.value_or(0)));
    orders.interrupted = rendered(messages::interrupted());
    orders.out_of_memory = rendered(messages::out_of_memory(options.max_memory));
    return orders;
}

/// True for an error that is caused by a limit of this run, not by the input. With a higher limit, the run may succeed.
bool about_bounds(const Diagnostic& diagnostic) {
    return diagnostic.code == "stopped" || diagnostic.code == "out-of-memory" || diagnostic.code == "threads-refused" ||
           diagnostic.code == "bound-reached";
}

/// Combines the exit code of the command with the exit code that follows from its errors.
ExitCode exit_code(const CommandContext& job, ExitCode code) {
    if (!job.diagnostics.has_errors() || code == ExitCode::Failure) return code;
    const bool only_bounds = std::ranges::all_of(job.diagnostics.all(), [](const Diagnostic& diagnostic) {
        return diagnostic.severity != Severity::Error || about_bounds(diagnostic);
    });
    if (!only_bounds) return ExitCode::Input;
    return code == ExitCode::Verdict ? code : ExitCode::Unknown;
}

/// One invocation of the program: executes a command on each of its files, then writes the combined outputs.
class Invocation {
public:
    Invocation(const Entry& entry, const CliCommand& verb, const Options& options, const Streams& streams)
        : entry_(entry),
          verb_(verb),
          requested_(options),
          streams_(reports_on_output(options) ? with_words_apart(streams) : streams),
          job_{.options = options, .in = &streams.in} {}

    ExitCode run() {
        std::optional<Watchdog> guard;
        job_.reports = &reports_;
        attempt([&] {
            if (streams_.alone) guard.emplace(orders(job_, streams_));
            if (streams_.alone && writes_files(requested_)) std::signal(SIGPIPE, SIG_IGN);
            return begin();
        });
        if (failed_) return close(), print_messages(), code_;
        const std::vector<std::vector<std::string>> rounds = rounds_of();
        for (const std::vector<std::string>& operands : rounds) {
            begin_round(operands);
            attempt([&] { return entry_.run(job_, streams_); });
            attempt([&] { return note_diagnostics(job_, streams_), ExitCode::Done; });
            if (&operands == &rounds.back()) close();
            print_messages();
        }
        return code_;
    }

private:
    /// Returns the streams for messages. If a report uses standard output, messages are written to standard error.
    static Streams with_words_apart(const Streams& streams) {
        Streams apart{streams.in, streams.err, streams.err, streams.alone, streams.err_screen, streams.err_screen};
        apart.documents = &streams.out;
        apart.documents_screen = streams.out_screen;
        return apart;
    }

    /// Returns the operands of each execution of the command.
    std::vector<std::vector<std::string>> rounds_of() const {
        if (verb_.most_operands != any_number) return {requested_.operands};
        std::vector<std::vector<std::string>> rounds;
        for (const std::string& file : requested_.operands) rounds.push_back({file});
        return rounds;
    }

    void begin_round(const std::vector<std::string>& operands) {
        job_.options = requested_;
        job_.options.operands = operands;
        job_.sources = {};
        job_.diagnostics = {};
        job_.closing.clear();
    }

    /// Executes `work`, and reports std::bad_alloc and std::system_error as diagnostics.
    template <class Work>
    ExitCode attempt(const Work& work) {
        ExitCode code = ExitCode::Done;
        try {
            code = work();
        } catch (const std::bad_alloc&) {
            job_.diagnostics.add(messages::out_of_memory(job_.options.max_memory));
        } catch (const std::system_error& failure) {
            const bool memory = failure.code() == std::errc::not_enough_memory;
            const bool thread = failure.code() == std::errc::resource_unavailable_try_again;
            job_.diagnostics.add(memory   ? messages::out_of_memory(job_.options.max_memory)
                                 : thread ? messages::threads_refused()
                                          : messages::io_error(failure.what()));
        }
        code = exit_code(job_, code);
        failed_ = failed_ || job_.diagnostics.has_errors();
        code_ = worse(code_, code);
        return code;
    }

    ExitCode begin() {
        if (!outputs_differ(job_) || !formats_are_written(verb_.name, job_)) return reported_ = false, ExitCode::Input;
        begin_reports(accepts(verb_, OptionGroup::Analysis) || accepts(verb_, OptionGroup::Date), job_);
        if (folders_are_there(accepts(verb_, OptionGroup::OutputDirectory), job_)) return ExitCode::Done;
        note_diagnostics(job_, streams_);
        return ExitCode::Input;
    }

    /// Writes the reports in any case, and the results of all files if there was no error.
    void close() {
        job_.options.operands = requested_.operands;
        if (reported_)
            attempt([&] { return write_reports(failed_, job_, streams_) ? ExitCode::Done : ExitCode::Input; });
        attempt([&] { return finish(); });
    }

    ExitCode finish() {
        if (failed_) return ExitCode::Done;
        std::vector<OutputFile> files;
        for (const Product& product : job_.products) files.push_back(product.file);
        if (!files.empty() || (job_.options.depfile && !job_.depfile_written))
            if (!write_outputs(files, job_, streams_)) return ExitCode::Input;
        if (entry_.list != nullptr) entry_.list(job_);
        return ExitCode::Done;
    }

    void print_messages() {
        render_diagnostics(job_, streams_);
        streams_.out << job_.closing << std::flush;
    }

    const Entry& entry_;
    const CliCommand& verb_;
    const Options& requested_;
    const Streams streams_;
    CommandContext job_;
    Reports reports_ = {};
    ExitCode code_ = ExitCode::Done;
    bool failed_ = false;
    bool reported_ = true;  ///< false if the options name invalid outputs; reports are then not written
};

ExitCode run_verb(const Entry& entry, std::span<const std::string> arguments, const Streams& streams) {
    const CliCommand verb = entry.usage();
    ParsedOptions parsed = parse_options(verb, arguments);
    if (!parsed.options) return usage_error(streams, parsed.error_text, verb.name + " ");
    if (parsed.options->help) {
        print_help(verb, streams.out);
        return ExitCode::Done;
    }
    Options& options = *parsed.options;
    std::vector<Diagnostic> warnings;
    for (const FormerName& used : parsed.former_names)
        warnings.push_back(messages::deprecated_option(used.former, used.name));
    if (!options.quiet) render(warnings, CommandContext{.options = options}, streams, streams.err);
    if (options.timeout_ms)
        options.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(*options.timeout_ms);
    return Invocation(entry, verb, options, streams).run();
}

}  // namespace

std::vector<CliCommand> all_commands() {
    std::vector<CliCommand> verbs;
    for (const Entry& entry : entries) verbs.push_back(entry.usage());
    return verbs;
}

std::string unknown_command(const std::string& name) {
    std::vector<std::string> names;
    for (const Entry& entry : entries) names.push_back(entry.usage().name);
    return unknown_name_text("command", name, names);
}

ExitCode worse(ExitCode one, ExitCode other) {
    for (const ExitCode code : {ExitCode::Failure, ExitCode::Input, ExitCode::Verdict, ExitCode::Unknown})
        if (code == one || code == other) return code;
    return ExitCode::Done;
}

ExitCode run(std::span<const std::string> arguments, const Streams& streams) {
    if (arguments.empty()) return usage_error(streams, "missing command", "");
    const std::string& name = arguments.front();
    const bool is_help = name == "--help" || name == "-h" || name == "help";
    if (is_help && arguments.size() == 1) {
        print_overview(streams.out);
        return ExitCode::Done;
    }
    if (name == "--version") {
        streams.out << "grafverif " GRAFVERIF_VERSION "\n";
        return ExitCode::Done;
    }
    // For `help check` and `--help check`, the command is the second argument.
    const std::string& verb = is_help ? arguments[1] : name;
    for (const Entry& entry : entries) {
        if (entry.usage().name == verb && is_help) return print_help(entry.usage(), streams.out), ExitCode::Done;
        if (entry.usage().name == verb) return run_verb(entry, arguments.subspan(1), streams);
    }
    if (verb.starts_with('-'))
        return usage_error(streams,
                           fmt::format("expected a command before `{}`; write options after the command", verb), "");
    return usage_error(streams, unknown_command(verb), "");
}

void deliver(const std::string& content, CommandContext& job, const Streams& streams) {
    write_outputs({{job.options.output.value_or("-"), content}}, job, streams);
}

}  // namespace grafverif::app
