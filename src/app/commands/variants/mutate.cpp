// SPDX-License-Identifier: MIT
// `mutate`: mutation testing of a chart. The command determines which mutants are equivalent, which violate a property,
// and which the test sequence detects. Several threads check mutants. Results are stored in a file, so that a stopped
// run can be continued.
#include "pipeline/variants/mutate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <random>
#include <sstream>
#include <system_error>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "app/system/write_files.hpp"
#include "check/shares.hpp"
#include "compare/mutants.hpp"
#include "draw/changes.hpp"
#include "pipeline/files.hpp"
#include "pipeline/variants/in_parallel.hpp"
#include "read/formats.hpp"
#include "report/charts/mutation.hpp"
#include "support/json_text.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::app {

namespace {

using Kind = MutantResult::Kind;

// -- results of a previous run --

std::uint64_t hashed(std::uint64_t hash, const std::string& text) {
    for (const char byte : text + '\0') hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
    return hash;
}

/// Returns the FNV-1a hash of all data, except the mutant and the limits, on which a result depends: the version of
/// grafverif, the files that were read, including library components, and the options. For limits, see StateFile.
std::uint64_t hash_of_query(const CommandContext& job) {
    std::uint64_t hash = hashed(14695981039346656037U, GRAFVERIF_VERSION);
    for (const Source& source : job.sources) hash = hashed(hash, source.text);
    const std::string mode(job.options.mode ? word(*job.options.mode) : "");
    for (const std::string& part :
         {mode, job.options.chart.value_or(""), std::string(job.options.lossy ? "lossy" : "")})
        hash = hashed(hash, part);
    for (const auto& [name, value] : job.options.constants) hash = hashed(hash, name + '=' + value);
    return hash;
}

nlohmann::ordered_json stored(const std::string& key, const std::string& bounds, const MutantResult& mutant_result) {
    return {{"key", key},
            {"bounds", bounds},
            {"fate", word(mutant_result.kind)},
            {"reason", mutant_result.reason},
            {"noticed_by", mutant_result.noticed_by},
            {"undecided", mutant_result.undecided},
            {"vacuous", mutant_result.vacuous},
            {"caught",
             mutant_result.caught ? nlohmann::ordered_json(*mutant_result.caught) : nlohmann::ordered_json(nullptr)},
            {"scans", mutant_result.scans}};
}

/// True if other limits may lead to another result.
bool depends_on_bounds(const MutantResult& mutant_result) {
    return mutant_result.kind == Kind::Unknown || !mutant_result.undecided.empty();
}

/// Reads the result that `line` stores. Returns nothing if the line does not contain a result, or if the result depends
/// on limits other than `bounds`.
std::optional<std::pair<std::string, MutantResult>> restored(const std::string& line, const std::string& bounds) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object()) return {};
    try {
        MutantResult mutant_result;
        const auto kinds = {Kind::Refused, Kind::Equivalent, Kind::Noticed, Kind::Unnoticed, Kind::Unknown};
        const auto kind =
            std::ranges::find(kinds, json.at("fate").get<std::string>(), [](Kind each) { return word(each); });
        if (kind == kinds.end()) return {};
        mutant_result.kind = *kind;
        mutant_result.reason = json.at("reason");
        mutant_result.noticed_by = json.at("noticed_by");
        mutant_result.undecided = json.at("undecided");
        mutant_result.vacuous = json.at("vacuous");
        if (!json.at("caught").is_null()) mutant_result.caught = json.at("caught").get<bool>();
        mutant_result.scans = json.at("scans");
        if (depends_on_bounds(mutant_result) && json.at("bounds") != bounds) return {};
        return std::pair(json.at("key").get<std::string>(), std::move(mutant_result));
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

std::chrono::milliseconds each_of(const Options& options) {
    return std::chrono::milliseconds(options.mutant_timeout_ms.value_or(60'000));
}

/// The results of a previous run and of this run. write_files replaces the state file at the start,
/// so that an unwritable file is rejected before mutants are checked. During the run, write_files
/// replaces the file at most once per second, and finally at the end.
class StateFile {
public:
    explicit StateFile(const Options& options)
        : path_(options.state_file),
          bounds_(fmt::format("{} ms, {} bytes", each_of(options).count(), options.max_memory.value_or(0))) {}

    /// Opens the file. Returns false after an error: the file cannot be read, or is not a state file. Throws
    /// std::system_error if the file cannot be written.
    bool open(Diagnostics& diagnostics) {
        if (!path_) return true;
        std::string why;
        const bool is_there = !identity_of_existing(*path_).empty();
        const auto text = is_there ? content_of_file(*path_, why) : std::optional(std::string());
        if (!text) return diagnostics.add(messages::cannot_read(*path_, why)), false;
        std::istringstream lines(*text);
        for (std::string line; std::getline(lines, line);) {
            if (line.empty()) continue;
            if (!std::string_view(line).starts_with(line_begin.substr(0, line.size())))
                return diagnostics.add(messages::no_state_file(*path_)), false;
            if (auto known = restored(line, bounds_)) known_.insert_or_assign(known->first, std::move(known->second));
            text_ += line + '\n';
        }
        save();
        return true;
    }
    std::optional<MutantResult> known(const std::string& key) const {
        const auto found = known_.find(key);
        return found == known_.end() ? std::nullopt : std::optional(found->second);
    }
    void add(const std::string& key, const MutantResult& mutant_result) {
        if (!path_) return;
        text_ += json_text(stored(key, bounds_, mutant_result), -1) + '\n';
        saved_ = false;
        if (std::chrono::steady_clock::now() < next_save_) return;
        try {
            save();
        } catch (const std::system_error&) {
            // If saving also fails at the end of the run, the error is reported at that time.
            next_save_ = std::chrono::steady_clock::now() + between_saves;
        }
    }
    /// Saves the results. Throws std::system_error if the file cannot be written.
    void save() {
        if (!path_ || saved_) return;
        write_files({{*path_, text_}});
        saved_ = true;
        next_save_ = std::chrono::steady_clock::now() + between_saves;
    }

private:
    static constexpr std::string_view line_begin = R"({"key":)";
    static constexpr std::chrono::seconds between_saves{1};

    std::optional<std::string> path_;
    std::string bounds_;  ///< limits for the work on each mutant
    std::map<std::string, MutantResult> known_ = {};
    std::string text_ = {};
    bool saved_ = false;
    std::chrono::steady_clock::time_point next_save_ = {};
};

// -- a run ------------------------------------------------------------------------------------------------------------

/// Selects a random sample of `most` mutants according to `seed`. The order of the mutants is unchanged.
void sample(std::vector<Mutant>& all, std::uint64_t most, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random() % k]);
    order.resize(std::min<std::size_t>(order.size(), most));
    std::ranges::sort(order);
    std::vector<Mutant> chosen;
    for (const std::size_t k : order) chosen.push_back(std::move(all[k]));
    all = std::move(chosen);
}

/// Checks all mutants in parallel. If the run is stopped, the results of unchecked mutants are empty.
class MutantChecks {
public:
    MutantChecks(const MutantChecker& bench, Mutation& mutation, StateFile& state, const CommandContext& job,
                 const Limits& limits)
        : bench_(bench),
          mutation_(mutation),
          question_(hash_of_query(job)),
          options_(job.options),
          limits_(limits),
          state_(state),
          left_(mutation.mutants.size()) {
        // The hash includes the properties of the original that have their expected verdicts, because the time limit
        // determines which properties are decided.
        for (const std::string& property : bench.properties()) question_ = hashed(question_, property);
    }

    /// Checks every mutant. With a time limit, each mutant has a share of the time; mutants that are undecided at the
    /// end of their share are checked again with the remaining time.
    void run() {
        jobs_ = thread_count(options_.jobs);
        run_once();
        is_last_ = true;
        left_ = provisional_.size();
        if (left_ > 0) run_once();
        for (auto& [index, mutant_result] : provisional_)
            if (!mutation_.results[index]) mutation_.results[index] = std::move(mutant_result);
    }

private:
    /// Maximum number of equal shares of the time that one mutant may use. Most mutants need less than one share. A
    /// mutant that needs many shares must not use the time of all other mutants.
    static constexpr std::size_t most_shares = 8;

    bool stopped() const { return is_over(limits_.deadline, limits_.stop); }

    void run_once() {
        in_parallel(
            mutation_.mutants.size(), jobs_, [this] { return stopped(); },
            [this](std::size_t k) {
                if (!mutation_.results[k]) check_mutant(k);
            });
    }

    void check_mutant(std::size_t index) {
        const std::string key = fmt::format("{:016x}", hashed(question_, mutation_.mutants[index].text));
        std::optional<MutantResult> mutant_result = state_.known(key);
        if (!mutant_result) {
            Limits limits = limits_;
            limits.progress = {};
            const auto end = std::chrono::steady_clock::now() + each_of(options_);
            const std::size_t left = left_ > 0 ? left_-- : 1;
            const Deadline share = share_of(limits_.deadline, (left + most_shares * jobs_ - 1) / (most_shares * jobs_));
            limits.deadline = share ? std::min(*share, end) : end;
            mutant_result = bench_.result_of(mutation_.mutants[index], limits);
            if (mutant_result->kind == Kind::Unknown && stopped()) return;
            const std::lock_guard lock(mutex_);
            if (mutant_result->kind == Kind::Unknown && share && *share < end) {
                if (!is_last_) provisional_.emplace(index, std::move(*mutant_result));
                return;
            }
            if (mutant_result->failures.empty()) state_.add(key, *mutant_result);
        }
        const std::lock_guard lock(mutex_);
        mutation_.results[index] = std::move(*mutant_result);
        ++done_;
        if (limits_.progress)
            limits_.progress(
                {[this] { return fmt::format("{} of {} mutants checked", done_, mutation_.mutants.size()); }});
    }

    const MutantChecker& bench_;
    Mutation& mutation_;
    std::uint64_t question_;
    const Options& options_;
    const Limits& limits_;
    StateFile& state_;
    std::mutex mutex_ = {};
    std::atomic<std::size_t> left_ = 0;  ///< number of mutants that share the remaining time
    unsigned jobs_ = 1;
    bool is_last_ = false;
    /// Results of mutants that are undecided at the end of their share of the time.
    std::map<std::size_t, MutantResult> provisional_ = {};
    std::size_t done_ = 0;
};

/// Writes the text and the drawing of the original, and the text of each mutant that no property
/// detects. For each undetected mutant, a drawing of the original and a drawing of the mutant mark
/// the elements that the other drawing does not contain. Returns false after an error.
bool write_survivors(const Mutation& mutation, const MutantChecker& bench, const Model& model, Id<Chart> chart,
                     const std::string& original, CommandContext& job, const Streams& streams) {
    if (!job.options.survivors) return true;
    const std::string folder = *job.options.survivors + "/";
    const Drawing drawn = drawing_of(model, chart);
    std::vector<OutputFile> files{{folder + "original.grafcet", original}, {folder + "original.svg", svg_of(drawn)}};
    for (std::size_t k = 0; k < mutation.mutants.size(); ++k) {
        if (!mutation.results[k] || mutation.results[k]->kind != Kind::Unnoticed) continue;
        const std::string name = fmt::format("{}{:03}-{}", folder, k + 1, mutation.mutants[k].kind);
        Diagnostics none;  // remains without errors, because the model of the mutant was read before
        const std::optional<Model> reading = bench.model_of(mutation.mutants[k], none);
        const auto mutated = reading ? find_chart(*reading, mutation.chart) : std::nullopt;
        files.push_back({name + ".grafcet", mutation.mutants[k].text});
        if (!mutated) continue;
        Drawing before = drawn, after = drawing_of(*reading, *mutated);
        draw::mark_changes(before, after);
        draw::mark_changes(after, drawn);
        files.push_back({name + ".before.svg", svg_of(before)});
        files.push_back({name + ".svg", svg_of(after)});
    }
    return write_outputs(files, job, streams);
}

ExitCode exit_code(const Mutation& mutation, bool stopped) {
    bool open = stopped, survives = false;
    for (const auto& mutant_result : mutation.results) {
        if (mutant_result && !mutant_result->failures.empty()) return ExitCode::Failure;
        open = open || !mutant_result || mutant_result->kind == Kind::Unknown;
        survives = survives || (mutant_result && mutant_result->kind == Kind::Unnoticed);
    }
    return survives ? ExitCode::Verdict : open ? ExitCode::Unknown : ExitCode::Done;
}

}  // namespace

ExitCode mutate(CommandContext& job, const Streams& streams) {
    const std::string& path = job.options.operands[0];
    const auto model = read_model(path, job);
    auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    if (chart && !model->charts[*chart].instance_of.empty())  // an instance has the text of its chart
        chart = find_chart(*model, model->charts[*chart].instance_of);
    if (!chart || !equations_of(*model, *chart, job)) return ExitCode::Input;
    const Id<Source> main = *job.sources.ids().begin(), source = model->charts[*chart].origin.source;
    const FileFormat format = format_of(job.sources[source].text);
    const bool is_native = format == FileFormat::Grafcet || format == FileFormat::Unknown;
    const tree::File file = is_native ? parse_file(source, job.sources, job.diagnostics)
                                      : laid_out(read_any(source, job.sources, {job.options.lossy}, job.diagnostics));
    const std::string original = job.sources[source].text;
    Mutation mutation{.chart = model->charts[*chart].name};
    if (source != main) mutation.file = job.sources[source].name;
    mutation.mutants = mutants(file, mutation.chart);
    mutation.possible = mutation.mutants.size();
    sample(mutation.mutants, job.options.limit.value_or(mutation.possible), job.options.seed);
    mutation.results.resize(mutation.mutants.size());
    const ReadOptions read = read_options(job.options);
    MutantChecker bench(*model, *chart, main, job.sources, read, job.options.mode);
    StateFile state(job.options);
    if (!state.open(job.diagnostics)) return ExitCode::Input;
    const ResourceLimits bounds(job.options, streams);
    bool stopped = !bench.prepare(bounds.limits());
    if (!stopped) MutantChecks(bench, mutation, state, job, bounds.limits()).run();
    stopped = stopped || bounds.interrupted();
    mutation.properties = bench.properties();
    mutation.vacuous = bench.vacuous();
    mutation.undecided = bench.undecided();
    mutation.test_steps = bench.test_steps();
    mutation.no_test = bench.no_test();
    work_is_done();
    try {
        state.save();
    } catch (const std::system_error& failure) {
        job.diagnostics.add(messages::io_error(failure.what()));  // the command continues and prints the results
    }
    if (!write_survivors(mutation, bench, *model, *chart, original, job, streams)) return ExitCode::Input;
    std::ostringstream out;
    if (job.options.format == Format::Json) out << mutation_json(mutation, job.sources) << '\n';
    else print_mutation(mutation, job.sources, out);
    deliver(std::move(out).str(), job, streams);
    for (const auto& mutant_result : mutation.results)
        if (mutant_result) print_failures(mutant_result->failures, streams);
    return exit_code(mutation, stopped);
}

CliCommand mutate_usage() {
    return {
        "mutate",
        "FILE",
        1,
        1,
        "mutate a chart, and report which mutants its properties and tests detect",
        "Changes a chart of FILE by one plausible mistake at a time, for example a negated term, a wrong successor,\n"
        "another duration or a missing action (docs/how-to/mutate.md lists all mistakes). For each mutant, decides\n"
        "whether it is equivalent to the chart (see `compare`). Then checks the mutant against the properties of the\n"
        "closed loops that contain the chart (see `check`), and executes the test sequence of the chart (see\n"
        "`testgen`) on the mutant. Mutants that no property detects are printed as differences of the text;\n"
        "--survivors also writes drawings of these mutants.\n"
        "Exit code 1: a mutant is detected by no property; 3: incomplete (--mutant-timeout, --timeout, Ctrl-C).",
        {"grafverif mutate samples/oven_door/oven_door.grafcet",
         "grafverif mutate station.grafcet --chart press --limit 50 --seed 7 --state press.mutants --survivors press",
         "grafverif mutate station.grafcet --mutant-timeout 10s --format json -o mutants.json"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::Constants, OptionGroup::Mutants, OptionGroup::Mode,
         OptionGroup::Format}};
}

}  // namespace grafverif::app
