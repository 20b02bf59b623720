// SPDX-License-Identifier: MIT
#include "app/serve/file_checker.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "page/data.hpp"
#include "page/terms.hpp"
#include "pipeline/check.hpp"
#include "pipeline/file_watcher.hpp"
#include "pipeline/models.hpp"
#include "pipeline/program/check.hpp"
#include "report/report.hpp"
#include "support/json_text.hpp"
#include "support/messages.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

constexpr auto file_poll_interval = 50ms, progress_interval = 250ms;
/// Maximum time for which a file is missing while a program replaces it.
constexpr auto absence = 100ms;

bool is_in_a_loop(const Model& model, Id<Chart> chart) {
    return std::ranges::any_of(model.loops, [&](const ClosedLoop& loop) {
        return std::ranges::any_of(loop.controllers, [&](const auto& controller) { return controller.chart == chart; });
    });
}

/// Returns a result as JSON. `text` is the property as in the file; `claim` is its formula, if known. All texts are
/// untrusted.
Json json_of(const PropertyResult& answer, const std::string& claim) {
    const Verdict& verdict = answer.verdict;
    Json notes = Json::array();
    for (const std::string& note : verdict.notes) notes.push_back(printable(note));
    return {{"name", verdict.property},
            {"text", printable(answer.text)},
            {"claim", printable(claim)},
            {"verdict", word(verdict.outcome)},
            {"expected", verdict.expected_violated ? "violated" : "holds"},
            {"as_expected", as_expected(verdict)},
            {"vacuous", verdict.vacuous},
            {"declared", verdict.declared},
            {"has_trace", answer.trace && can_be_played(*answer.trace)},
            {"reason", printable(verdict.reason)},
            {"notes", std::move(notes)}};
}

PropertyResult no_result(const Property& property) {
    PropertyResult answer{.text = property.text};
    answer.verdict.property = property.name;
    answer.verdict.expected_violated = property.expected_violated;
    answer.verdict.reason = "the property is omitted from this model";
    return answer;
}

}  // namespace

class FileChecker::Work {
public:
    Work(const Options& options, std::function<void()> changed, std::function<std::string()> text)
        : options_(options), changed_(std::move(changed)), text_(std::move(text)) {
        worker_ = std::jthread([this] { work(); });
        try {
            watcher_ = std::jthread([this] { watch(); });
        } catch (...) {
            end();
            throw;
        }
    }

    ~Work() { end(); }

    std::optional<std::string> newer(std::uint64_t known) const {
        const std::lock_guard hold(mutex_);
        return version_ == known ? std::nullopt : std::optional(state_);
    }

    std::shared_ptr<const CheckedFile> checked_file() const {
        const std::lock_guard hold(mutex_);
        return piece_;
    }

    void refresh() {
        const std::lock_guard hold(mutex_);
        stale_ = true;
        wake_.notify_all();
    }

private:
    /// The check of one model, with the verdicts that are known so far.
    struct Proof {
        std::string kind = "chart";  ///< `chart`, `program` or `loop`
        std::uint32_t place = 0;     ///< index of the loop or chart in the model
        std::string name = {}, state = "waiting", progress = {};
        Json properties = Json::array(), error_traces = Json::array();

        bool is_loop() const { return kind == "loop"; }
        Json json() const {
            return {{"kind", kind},
                    {"name", name},
                    {"state", state},
                    {"progress", progress},
                    {"properties", properties},
                    {"errors", error_traces}};
        }
    };

    void end() {
        {
            const std::lock_guard hold(mutex_);
            over_ = stale_ = true;
        }
        wake_.notify_all();
    }

    // One thread polls the files for changes.

    void watch() {
        while (sleep(file_poll_interval)) {
            const std::lock_guard hold(watching_);
            if (watch_.changed()) refresh();
        }
    }

    /// Waits for `time`. Returns false if the checker must end.
    bool sleep(std::chrono::milliseconds time) {
        std::unique_lock hold(mutex_);
        return !wake_.wait_for(hold, time, [this] { return over_.load(); });
    }

    // Another thread reads the files and checks their models. If a file changes, the thread starts again.

    void work() {
        while (!over_) {
            keep_memory_back();
            try {
                read();
                for (Proof& proof : proofs_)
                    if (!stale_ && !over_ && proof.state == "waiting") prove(proof);
            } catch (const std::bad_alloc&) {
                give_up("out of memory");
            } catch (const std::system_error& failure) {
                give_up(failure.what());
            }
            std::unique_lock hold(mutex_);
            wake_.wait(hold, [this] { return stale_ || over_; });
        }
    }

    void read() {
        auto piece = std::make_shared<CheckedFile>();
        const std::string& path = options_.operands[0];
        {
            const std::lock_guard hold(watching_);
            watch_.clear();
            begin();
            std::string why;
            auto text = main_text(path, why);
            if (text) read(path, std::move(*text), *piece);
            else piece->reading.diagnostics.add(messages::cannot_read(path, why));
        }
        if (stale_ && !piece->reading.model) return;  // reading was interrupted; the changed files are read next
        if (piece->reading.model) make_networks(*piece);
        proofs_ = proofs_of(*piece);
        take_up(std::move(piece));
    }

    std::optional<std::string> main_text(const std::string& path, std::string& why) {
        if (text_) return text_();
        watch_.note(path);
        auto text = content_of_file(path, why);
        if (!text) std::this_thread::sleep_for(absence);
        if (!text) text = content_of_file(path, why);
        return text;
    }

    void begin() {
        const std::lock_guard hold(mutex_);
        stale_ = over_.load();  // stays true if the destructor has set `over_`
    }

    void read(const std::string& path, std::string text, CheckedFile& piece) {
        ParseResult& reading = piece.reading;
        const Id<Source> file = reading.sources.add({path, std::move(text)});
        if (options_.property_file) return read_with_properties(file, piece);
        const Reach reach(path, options_.include_folders);
        ReadContext context = context_of(reach, options_.include_folders, false);
        context.constants.insert(options_.constants.begin(), options_.constants.end());
        context.stop = &stale_;
        context.identity = [this](const std::string& included) {
            watch_.note(included);  // also notes missing files, which may be created later
            return identity_of_existing(included);
        };
        reading.model = read_text(file, reading.sources, context, reading.diagnostics);
    }

    /// Reads a PLC program and its property file.
    void read_with_properties(Id<Source> file, CheckedFile& piece) {
        ParseResult& reading = piece.reading;
        const std::string& path = *options_.property_file;
        std::string why;
        watch_.note(path);
        auto text = content_of_file(path, why);
        if (!text) return reading.diagnostics.add(messages::cannot_read(path, why));
        properties_ = reading.sources.add({path, std::move(*text)});
        auto program = read_program_model(file, properties_, reading.sources, reading.diagnostics);
        if (program) reading.model = std::move(*program);
    }

    void make_networks(CheckedFile& piece) const {
        const Model& model = *piece.reading.model;
        for (const Id<ClosedLoop> loop : model.loops.ids())
            piece.networks.push_back(
                network_of(model, loop, ModelOptions{options_.mode, options_.grain, {}}, piece.reading.diagnostics));
        for (const Id<Chart> chart : model.charts.ids()) {
            Diagnostics already_reported;
            const bool is_silent = is_in_a_loop(model, chart) || model.charts[chart].program;
            Diagnostics& diagnostics = is_silent ? already_reported : piece.reading.diagnostics;
            piece.runs.push_back(equations_of(model, chart, diagnostics).has_value());
        }
    }

    /// Returns one entry for each model to check. A model that was rejected has the state `refused`.
    std::vector<Proof> proofs_of(const CheckedFile& piece) const {
        std::vector<Proof> proofs;
        const bool with_properties = options_.property_file.has_value();
        if (!piece.reading.model) return proofs;
        const Model& model = *piece.reading.model;
        const auto begun = [](bool accepted) { return accepted ? "waiting" : "refused"; };
        for (const Id<ClosedLoop> loop : model.loops.ids())
            proofs.push_back({.kind = "loop",
                              .place = loop.index,
                              .name = model.loops[loop].name,
                              .state = begun(piece.networks[loop.index].has_value())});
        for (const Id<Chart> chart : model.charts.ids())
            if (!is_in_a_loop(model, chart))
                proofs.push_back({.kind = model.charts[chart].program ? "program" : "chart",
                                  .place = chart.index,
                                  .name = model.charts[chart].name,
                                  .state = begun(piece.runs[chart.index] || with_properties)});
        return proofs;
    }

    void prove(Proof& proof) {
        proof.state = "running";
        publish();
        auto reported_at = std::chrono::steady_clock::now();
        CheckOptions options{.witnesses = false, .limits = {options_.max_states, options_.max_memory, {}, &stale_, {}}};
        if (options_.response_timeout_ms)
            options.limits.deadline = reported_at + std::chrono::milliseconds(*options_.response_timeout_ms);
        options.limits.progress = [&](const Progress& now) {
            if (std::chrono::steady_clock::now() - reported_at < progress_interval) return;
            reported_at = std::chrono::steady_clock::now();
            proof.progress = now.words();
            publish();
        };
        const std::optional<Report> report = report_on(proof, options);
        if (stale_) return;
        proof.state = report ? "done" : "refused";
        proof.progress.clear();
        if (report) store_result(*report, proof);
        publish();
    }

    std::optional<Report> report_on(const Proof& proof, const CheckOptions& options) const {
        const Model& model = *checked_file_->reading.model;
        if (proof.is_loop())
            return check(loop_to_check(model, {proof.place}, *checked_file_->networks[proof.place]), options);
        Diagnostics already_reported;
        if (options_.property_file) {
            Sources sources = checked_file_->reading.sources;
            auto checked = check_program({0}, properties_, sources, options, already_reported);
            return checked ? std::optional(std::move(checked->report)) : std::nullopt;
        }
        return check_untimed(model, Id<Chart>{proof.place}, {options_.mode, options_.grain, {}}, options,
                             already_reported);
    }

    void store_result(const Report& report, Proof& proof) const {
        const Model& model = *checked_file_->reading.model;
        const Id<ClosedLoop> loop = proof.is_loop() ? Id<ClosedLoop>{proof.place} : Id<ClosedLoop>{};
        const auto add_result = [&](PropertyResult answer) {
            std::string& reason = answer.verdict.reason;
            reason = with_who_stopped(std::move(reason), false, {.timeout_ms = options_.response_timeout_ms});
            proof.properties.push_back(json_of(
                answer, expectation_text(model, loop, answer.verdict.property, checked_file_->reading.sources)));
        };
        for (const PropertyResult& answer : report.answers) add_result(answer);
        if (loop.valid())
            for (const Property& property : model.loops[loop].properties)
                if (!has_result(report, property)) add_result(no_result(property));
        for (const ModelErrorTrace& breakdown : report.error_traces)
            proof.error_traces.push_back({{"code", breakdown.code}, {"message", printable(breakdown.message)}});
        for (const std::string& failure : report.failures)
            proof.error_traces.push_back({{"code", "internal-failure"}, {"message", printable(failure)}});
    }

    void give_up(const std::string& why) {
        proofs_.clear();
        auto piece = std::make_shared<CheckedFile>();
        piece->reading.diagnostics.add(messages::io_error(why));
        take_up(std::move(piece));
    }

    void take_up(std::shared_ptr<CheckedFile> piece) {
        piece->number = ++readings_;
        checked_file_ = std::move(piece);
        publish();
    }

    void publish() {
        const CheckedFile& piece = *checked_file_;
        Json models = Json::array(), charts = Json::array();
        for (const Proof& proof : proofs_) models.push_back(proof.json());
        if (piece.reading.model)
            for (const Id<Chart> id : piece.reading.model->charts.ids()) {
                const Chart& chart = piece.reading.model->charts[id];
                charts.push_back({{"name", chart.name},
                                  {"runs", static_cast<bool>(piece.runs[id.index])},
                                  {"steps", chart.steps.size()}});
            }
        Json state = {{"version", 0},
                      {"reading", piece.number},
                      {"file", options_.operands[0]},
                      {"readable", piece.reading.model.has_value()},
                      {"errors", piece.reading.diagnostics.errors()},
                      {"diagnostics", piece.reading.diagnostics_text()},
                      {"charts", std::move(charts)},
                      {"models", std::move(models)}};
        {
            const std::lock_guard hold(mutex_);
            state["version"] = ++version_;
            state_ = json_text(state, -1);
            piece_ = checked_file_;
        }
        changed_();
    }

    const Options& options_;
    std::function<void()> changed_;
    std::function<std::string()> text_;

    std::mutex watching_ = {};  ///< locked before `mutex_` if a thread locks both mutexes
    FileWatcher watch_ = {};

    mutable std::mutex mutex_ = {};
    std::condition_variable wake_ = {};
    std::atomic<bool> over_ = false, stale_ = false;
    std::uint64_t version_ = 0;
    std::string state_ = {};
    std::shared_ptr<const CheckedFile> piece_ = std::make_shared<CheckedFile>();

    // Only the thread that reads and checks uses the following members.
    std::shared_ptr<const CheckedFile> checked_file_ = piece_;
    std::vector<Proof> proofs_ = {};
    Id<Source> properties_ = {};  ///< the property file of a PLC program
    std::uint64_t readings_ = 0;

    std::jthread worker_ = {}, watcher_ = {};  ///< declared last, because the threads use all members above
};

FileChecker::FileChecker(const Options& options, std::function<void()> changed, std::function<std::string()> text)
    : work_(std::make_unique<Work>(options, std::move(changed), std::move(text))) {}
FileChecker::~FileChecker() = default;
std::optional<std::string> FileChecker::newer(std::uint64_t known) const { return work_->newer(known); }
std::shared_ptr<const CheckedFile> FileChecker::checked_file() const { return work_->checked_file(); }
void FileChecker::refresh() { work_->refresh(); }

}  // namespace grafverif::app
