// SPDX-License-Identifier: MIT
// Binds the public API to Python: functions that take texts and return JSON and drawings. The package `grafverif`
// converts their results to objects. Long computations run in a separate thread without the interpreter lock, so that
// Ctrl-C interrupts them.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "report_page.hpp"
#include "variants.hpp"

namespace py = pybind11;

namespace grafverif::python {
namespace {

/// Executes `work(stop)` and waits until it returns. Ctrl-C sets `stop`; the function then throws KeyboardInterrupt.
template <class Work>
auto run_interruptibly(Work work) -> decltype(work(std::declval<const std::atomic<bool>&>())) {
    std::optional<decltype(work(std::declval<const std::atomic<bool>&>()))> result;
    std::exception_ptr failure;
    std::atomic<bool> stop = false;
    std::mutex mutex;
    std::condition_variable ended;
    bool done = false, interrupted = false;
    std::thread worker([&] {
        try {
            result.emplace(work(stop));
        } catch (...) {
            failure = std::current_exception();
        }
        const std::scoped_lock lock(mutex);
        done = true;
        ended.notify_one();
    });
    for (bool over = false; !over;) {
        {
            const py::gil_scoped_release others_run;
            std::unique_lock lock(mutex);
            over = ended.wait_for(lock, std::chrono::milliseconds(50), [&] { return done; });
        }
        if (!interrupted && PyErr_CheckSignals() != 0) stop = interrupted = true;
    }
    worker.join();
    if (interrupted) throw py::error_already_set();
    if (failure) std::rethrow_exception(failure);
    return std::move(*result);
}

/// Returns each diagnostic as (severity, code, message, file, line, column).
py::list listed(const std::vector<Diagnostic>& diagnostics, const Sources& sources) {
    py::list result;
    for (const Diagnostic& each : diagnostics) {
        const char* const severity = each.severity == Severity::Error     ? "error"
                                     : each.severity == Severity::Warning ? "warning"
                                                                          : "note";
        if (!sources.contains(each.where.source)) {
            result.append(py::make_tuple(severity, each.code, each.message, py::none(), py::none(), py::none()));
            continue;
        }
        const Source& source = sources[each.where.source];
        const Place at = place(source.text, each.where.begin);
        result.append(py::make_tuple(severity, each.code, each.message, source.name, at.line, at.column));
    }
    return result;
}

struct Bounds {
    std::optional<double> timeout = {};  ///< time limit in seconds
    std::optional<std::uint64_t> memory = {}, states = {};

    Limits limits(const std::atomic<bool>& stop) const {
        Limits result;
        result.states = states;
        result.memory = memory;
        result.stop = &stop;
        constexpr double longest = 1e9;
        if (timeout)
            result.deadline =
                std::chrono::steady_clock::now() +
                std::chrono::milliseconds(static_cast<std::int64_t>(1000 * std::min(std::max(*timeout, 0.0), longest)));
        return result;
    }
};

std::optional<ExecutionMode> mode_of(const std::optional<std::string>& word) {
    if (!word) return {};
    for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle})
        if (*word == grafverif::word(mode)) return mode;
    throw py::value_error("mode is `stability-search` or `every-cycle`, not `" + *word + "`");
}

/// Returns the value that `words` assigns to `requested`. Raises ValueError for any other text.
template <class Value>
Value chosen(const std::string& requested, const char* what,
             std::initializer_list<std::pair<const char*, Value>> words) {
    std::string all;
    for (const auto& [word, value] : words) {
        if (requested == word) return value;
        all += (all.empty() ? "`" : ", `") + std::string(word) + "`";
    }
    throw py::value_error(std::string(what) + " is one of " + all + ", not `" + requested + "`");
}

/// Options for creating a model.
struct How {
    std::optional<std::string> mode = {}, grain = {}, plant = {}, schedule = {}, time = {};
    bool fairness = false;

    ModelOptions options() const {
        ModelOptions result;
        result.mode = mode_of(mode);
        if (grain)
            result.grain = chosen<Grain>(*grain, "grain", {{"phased", Grain::Phased}, {"atomic", Grain::Atomic}});
        if (plant)
            result.untimed.plant = chosen<PlantApproach>(*plant, "plant",
                                                         {{"none", PlantApproach::None},
                                                          {"constraints", PlantApproach::Constraints},
                                                          {"automata", PlantApproach::Automata}});
        if (schedule)
            result.untimed.schedule = chosen<Schedule>(*schedule, "schedule",
                                                       {{"interleaved", Schedule::Interleaved},
                                                        {"synchronous", Schedule::Synchronous},
                                                        {"sequenced", Schedule::Sequenced}});
        if (time)
            result.untimed.time = chosen<TimeModel>(
                *time, "time", {{"abstract", TimeModel::Abstract}, {"discrete", TimeModel::Discrete}});
        result.untimed.fairness = fairness;
        return result;
    }
};

/// Throws the errors in the model, with positions, as a Python exception.
[[noreturn]] void refuse(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream text;
    render_text(diagnostics.all(), sources, Colour::Plain, text);
    const py::object error = py::module_::import("grafverif").attr("GrafverifError");
    PyErr_SetObject(error.ptr(), error(text.str(), listed(diagnostics.all(), sources)).ptr());
    throw py::error_already_set();
}

/// A report, and the loop or chart to which it refers.
struct Checked {
    Report report;
    Sources sources;
    std::shared_ptr<const ParseResult> reading = {};
    Id<ClosedLoop> loop = {};
    Id<Chart> chart = {};
    std::optional<ExecutionMode> mode = {};
    std::optional<CertificateFiles> certificate = {};  ///< set if a certificate is requested
};

/// A simulator. Its methods keep the interpreter lock, because other Python threads may use the same simulator.
struct Moved {
    Simulator simulator;
};

/// Issues warnings and notes as Python warnings.
void warn(std::span<const Diagnostic> diagnostics) {
    for (const Diagnostic& each : diagnostics)
        if (PyErr_WarnEx(PyExc_UserWarning, (each.message + " [" + each.code + "]").c_str(), 2) != 0)
            throw py::error_already_set();
}

/// A recording. Its methods keep the interpreter lock, because other Python threads may use the same recording.
class Samples {
public:
    explicit Samples(std::unique_ptr<Recording> recording) : recording_(std::move(recording)) {}

    bool add(const std::string& line) {
        const bool is_open = recording_->add(line);
        report_diagnostics();
        return is_open;
    }
    Shown finish() {
        auto shown = recording_->finish();
        report_diagnostics();
        if (!shown) throw py::value_error("the recording is already finished");
        return std::move(*shown);
    }
    void report_diagnostics() {
        const Diagnostics& all = recording_->diagnostics();
        if (all.has_errors()) refuse(all, recording_->sources());
        const std::size_t known = std::exchange(reported_, all.all().size());
        warn(std::span(all.all()).subspan(known));
    }

private:
    std::unique_ptr<Recording> recording_;
    std::size_t reported_ = 0;  ///< number of diagnostics that were issued
};

class File {
    std::shared_ptr<const ParseResult> reading_;
    ReadOptions options_;

    const Model& model() const { return *reading_->model; }

    /// Returns the result of `make`. Errors are thrown as a Python exception, and warnings are issued as Python
    /// warnings.
    template <class Make>
    auto made(Make make) const {
        Diagnostics diagnostics;
        auto result = run_interruptibly([&](const std::atomic<bool>& stop) { return make(stop, diagnostics); });
        if (!result) refuse(diagnostics, reading_->sources);
        warn(diagnostics.all());
        return std::move(*result);
    }

public:
    static File read(const std::string& path, const ReadOptions& options) {
        return File(run_interruptibly([&](const std::atomic<bool>&) { return read_file(path, options); }), options);
    }
    static File parse(const std::string& text, const std::string& name, const ReadOptions& options) {
        return File(run_interruptibly([&](const std::atomic<bool>&) { return read_string(text, name, options); }),
                    options);
    }

    std::vector<std::string> charts() const { return names(model().charts); }
    std::vector<std::string> loops() const { return names(model().loops); }
    py::list warnings() const { return listed(reading_->diagnostics.all(), reading_->sources); }
    std::vector<std::string> properties(const std::string& loop) const {
        return names(model().loops[loop_of(loop)].properties);
    }

    Checked check(const std::string& loop, const How& how, const CheckOptions& requested, const Bounds& bounds,
                  bool untimed, bool certificate) const {
        const ModelOptions options = how.options();
        const Id<ClosedLoop> id = loop_of(loop);
        std::optional<CertificateFiles> files;
        Report report = made([&](const std::atomic<bool>& stop, Diagnostics& diagnostics) {
            CheckOptions check = requested;
            check.limits = bounds.limits(stop);
            auto found = untimed ? check_untimed(model(), id, options, check, diagnostics)
                                 : grafverif::check(model(), id, options, check, diagnostics);
            if (found && certificate) files = certify(model(), id, options, check, *found);
            return found;
        });
        return {std::move(report), reading_->sources, reading_, id, {}, options.mode, std::move(files)};
    }
    Checked check_chart(const std::string& chart, const How& how, const Bounds& bounds) const {
        const ModelOptions options = how.options();
        const Id<Chart> id = chart_of(chart);
        Report report = made([&](const std::atomic<bool>& stop, Diagnostics& diagnostics) {
            CheckOptions check;
            check.limits = bounds.limits(stop);
            return check_untimed(model(), id, options, check, diagnostics);
        });
        return {std::move(report), reading_->sources, reading_, {}, id, options.mode};
    }
    std::pair<std::string, std::string> analyse(const std::string& chart, const How& how, const Bounds& bounds) const {
        const auto mode = mode_of(how.mode);
        const Id<Chart> id = chart_of(chart);
        const Analysis found = made([&](const std::atomic<bool>& stop, Diagnostics& diagnostics) {
            return analysis_of(model(), id, mode, bounds.limits(stop), diagnostics);
        });
        return {text_of(found, reading_->sources), json_of(found, reading_->sources)};
    }
    Shown tune(const std::string& loop, const How& how, const std::vector<std::string>& over,
               const std::vector<std::string>& properties, const Bounds& bounds, bool every_point) const {
        const ModelOptions options = how.options();
        const Id<ClosedLoop> id = loop_of(loop);
        return made([&](const std::atomic<bool>& stop, Diagnostics& diagnostics) {
            return python::tune(*reading_, id, over, properties, options, options_, every_point, bounds.limits(stop),
                                diagnostics);
        });
    }
    Shown faults(const std::string& loop, const How& how, std::uint64_t order,
                 const std::vector<std::string>& properties, const Bounds& bounds) const {
        const ModelOptions options = how.options();
        const Id<ClosedLoop> id = loop_of(loop);
        return made([&](const std::atomic<bool>& stop, Diagnostics& diagnostics) {
            return python::faults(*reading_, id, order, properties, options, bounds.limits(stop), diagnostics);
        });
    }
    std::unique_ptr<Samples> recording(const std::vector<std::string>& charts, const How& how, std::int64_t jitter_ms,
                                       const Recording::Skew& skew_us, const std::map<std::string, std::string>& map,
                                       bool stop_early) const {
        if (jitter_ms < 0) throw py::value_error("jitter is in seconds, 0 or more");
        for (const auto& [columns, bound_us] : skew_us)
            if (bound_us < 0 || bound_us > 86'400'000'000 || columns.empty())
                throw py::value_error("skew maps names to seconds between 0 and 86400");
        std::vector<Id<Chart>> ids;
        for (const std::string& chart : charts) ids.push_back(chart_of(chart));
        auto made = std::make_unique<Samples>(std::make_unique<Recording>(
            reading_, ids, mode_of(how.mode), jitter_ms, skew_us,
            std::vector<std::pair<std::string, std::string>>(map.begin(), map.end()), stop_early));
        made->report_diagnostics();
        return made;
    }
    std::string draw(const std::string& chart, const std::string& notation) const {
        DrawOptions options;
        options.notation = chosen<Notation>(notation, "notation", {{"iec", Notation::Iec}, {"text", Notation::Text}});
        const Id<Chart> id = chart_of(chart);
        return run_interruptibly([&](const std::atomic<bool>&) { return svg_of(drawing_of(model(), id, options)); });
    }
    /// Returns the automaton as text, JSON and SVG.
    std::tuple<std::string, std::string, std::string> automaton(const std::string& chart, const How& how,
                                                                const Bounds& bounds) const {
        const Id<Chart> id = chart_of(chart);
        ConformOptions options;
        options.mode = mode_of(how.mode);
        return shown(made([&](const std::atomic<bool>& stop, Diagnostics& diagnostics) {
            options.limits = bounds.limits(stop);
            return automaton_of(model(), id, options, diagnostics);
        }));
    }
    std::tuple<std::string, std::string, std::string> mealy(const std::string& chart, const How& how,
                                                            const Bounds& bounds, bool minimise) const {
        const Id<Chart> id = chart_of(chart);
        ConformOptions options;
        options.mode = mode_of(how.mode);
        options.minimise = minimise;
        return shown(made([&](const std::atomic<bool>& stop, Diagnostics& diagnostics) {
            options.limits = bounds.limits(stop);
            return mealy_of(model(), id, options, diagnostics);
        }));
    }
    std::string test_sequence(const std::string& chart, const How& how, const Bounds& bounds, const std::string& cover,
                              bool one_cycle_each) const {
        const Id<Chart> id = chart_of(chart);
        ConformOptions options;
        options.mode = mode_of(how.mode);
        options.one_cycle_each = one_cycle_each;
        options.cover = chosen<TestCover>(cover, "cover",
                                          {{"transitions", TestCover::Transitions},
                                           {"evolutions", TestCover::Evolutions},
                                           {"locations", TestCover::Locations}});
        return json_of(made([&](const std::atomic<bool>& stop, Diagnostics& diagnostics) {
            options.limits = bounds.limits(stop);
            return test_of(model(), id, options, diagnostics);
        }));
    }
    Moved simulate_loop(const std::string& loop, const How& how) const {
        const ModelOptions options = how.options();
        const Id<ClosedLoop> id = loop_of(loop);
        return {made([&](const std::atomic<bool>&, Diagnostics& diagnostics) {
            return simulator_of(model(), id, options, diagnostics);
        })};
    }
    Moved simulate_chart(const std::string& chart, const How& how) const {
        const auto mode = mode_of(how.mode);
        const Id<Chart> id = chart_of(chart);
        return {made([&](const std::atomic<bool>&, Diagnostics& diagnostics) {
            return simulator_of(model(), id, mode, diagnostics);
        })};
    }
    std::string uppaal(const std::string& loop, const How& how) const {
        const ModelOptions options = how.options();
        const Id<ClosedLoop> id = loop_of(loop);
        return made([&](const std::atomic<bool>&, Diagnostics& diagnostics) -> std::optional<std::string> {
            const auto network = network_of(model(), id, options, diagnostics);
            if (!network) return {};
            UppaalProject made = uppaal_project(*network, diagnostics);
            return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(made.project));
        });
    }
    std::string nusmv(const std::string& loop, const How& how) const {
        const ModelOptions options = how.options();
        const Id<ClosedLoop> id = loop_of(loop);
        return made([&](const std::atomic<bool>&, Diagnostics& diagnostics) -> std::optional<std::string> {
            const auto system = transition_system_of(model(), id, options, diagnostics);
            if (!system) return {};
            std::string made = nusmv_model(*system, diagnostics);
            return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(made));
        });
    }
    std::string structured_text(const std::string& chart, const How& how, bool plcopen_xml) const {
        const auto requested = mode_of(how.mode);
        const Id<Chart> id = chart_of(chart);
        return made([&](const std::atomic<bool>&, Diagnostics& diagnostics) -> std::optional<std::string> {
            const auto equations = equations_of(model(), id, diagnostics);
            if (!equations) return {};
            return structured_text_of(*equations, execution_mode(model(), id, requested), diagnostics, plcopen_xml);
        });
    }

private:
    File(ParseResult reading, const ReadOptions& options)
        : reading_(std::make_shared<const ParseResult>(std::move(reading))), options_(options) {
        if (!reading_->model) refuse(reading_->diagnostics, reading_->sources);
    }

    template <class Things>
    static std::vector<std::string> names(const Things& things) {
        std::vector<std::string> result;
        for (const auto& thing : things) result.push_back(thing.name);
        return result;
    }

    Id<ClosedLoop> loop_of(const std::string& name) const {
        if (const auto found = find_loop(model(), name)) return *found;
        throw py::key_error("unknown closed loop `" + name + "`");
    }
    Id<Chart> chart_of(const std::string& name) const {
        if (const auto found = find_chart(model(), name)) return *found;
        throw py::key_error("unknown chart `" + name + "`");
    }

    template <class Machine>
    static std::tuple<std::string, std::string, std::string> shown(const Machine& machine) {
        return {text_of(machine), json_of(machine), svg_of(machine)};
    }
};

std::string html_of(const Checked& checked, const std::string& date, const Bounds& bounds) {
    Diagnostics diagnostics;
    auto page = run_interruptibly([&](const std::atomic<bool>& stop) {
        return report_page(*checked.reading, checked.loop, checked.chart, checked.report, checked.mode, date,
                           bounds.limits(stop), diagnostics);
    });
    if (!page) refuse(diagnostics, checked.reading->sources);
    return std::move(*page);
}

const ChartRun& run_of(const Checked& checked, std::size_t answer) {
    const auto& trace = checked.report.answers.at(answer).trace;
    if (!trace) throw py::key_error("the verdict has no trace");
    return *trace;
}

/// Disables `__new__` of a class: it would create an object without a value, and the methods of such an object would
/// crash.
void forbid_new(py::handle type) {
    reinterpret_cast<PyTypeObject*>(type.ptr())->tp_new = [](PyTypeObject* of, PyObject*, PyObject*) -> PyObject* {
        PyErr_Format(PyExc_TypeError, "cannot create '%.100s' instances directly", of->tp_name);
        return nullptr;
    };
}

}  // namespace

PYBIND11_MODULE(_core, module) {
    module.doc() = "Extension module of grafverif; use the package `grafverif`, which wraps its results in objects.";
    module.attr("__version__") = GRAFVERIF_VERSION;
    module.attr("most_faults") = most_faults_of_combination();
    forbid_new(py::class_<How>(module, "_How"));
    module.def(
        "How",
        [](std::optional<std::string> mode, std::optional<std::string> grain, std::optional<std::string> plant,
           std::optional<std::string> schedule, std::optional<std::string> time, bool fairness) {
            How how{std::move(mode),     std::move(grain), std::move(plant),
                    std::move(schedule), std::move(time),  fairness};
            how.options();  // throws ValueError if an option is invalid
            return how;
        },
        py::kw_only(), py::arg("mode") = py::none(), py::arg("grain") = py::none(), py::arg("plant") = py::none(),
        py::arg("schedule") = py::none(), py::arg("time") = py::none(), py::arg("fairness") = false);
    forbid_new(py::class_<Bounds>(module, "_Bounds"));
    module.def(
        "Bounds",
        [](std::optional<double> timeout, std::optional<std::uint64_t> memory, std::optional<std::uint64_t> states) {
            if (timeout && !(*timeout >= 0)) throw py::value_error("timeout is in seconds, 0 or more");
            return Bounds{timeout, memory, states};
        },
        py::kw_only(), py::arg("timeout") = py::none(), py::arg("memory") = py::none(), py::arg("states") = py::none());
    py::class_<Checked> report_class(module, "Report");
    forbid_new(report_class);
    report_class.def_property_readonly("certificate", [](const Checked& checked) -> py::object {
        if (!checked.certificate) return py::none();
        const CertificateFiles& all = *checked.certificate;
        return py::make_tuple(all.files, all.certified, all.omitted);
    });
    report_class.def("text", [](const Checked& checked) { return text_of(checked.report, checked.sources); })
        .def("json", [](const Checked& checked) { return json_of(checked.report, checked.sources); })
        .def(
            "trace_text", [](const Checked& checked, std::size_t answer) { return text_of(run_of(checked, answer)); },
            py::arg("answer"))
        .def(
            "trace_svg",
            [](const Checked& checked, std::size_t answer) {
                return svg_of(run_of(checked, answer), checked.report.answers.at(answer).verdict.property);
            },
            py::arg("answer"))
        .def("html", &html_of, py::arg("date"), py::arg("bounds"));
    py::class_<Moved> simulator(module, "Simulator");
    forbid_new(simulator);
    simulator.def("execute", [](Moved& moved, const std::string& command) { return moved.simulator.execute(command); })
        .def("problem", [](const Moved& moved) { return moved.simulator.problem(); })
        .def("choices",
             [](const Moved& moved) {
                 std::vector<std::pair<std::string, std::string>> result;
                 for (const Choice& each : moved.simulator.choices()) result.emplace_back(each.command, each.words);
                 return result;
             })
        .def("json", [](const Moved& moved) { return json_of(moved.simulator.run()); })
        .def("text", [](const Moved& moved) { return text_of(moved.simulator.run()); })
        .def("svg", [](const Moved& moved) { return svg_of(moved.simulator.run(), moved.simulator.run().name); })
        .def("what_if_row", [](const Moved& moved) { return moved.simulator.what_if_row(); })
        .def("disagreement", [](const Moved& moved) { return moved.simulator.disagreement(); });
    py::class_<Samples> samples(module, "Samples");
    forbid_new(samples);
    samples.def("add", &Samples::add).def("finish", &Samples::finish);
    py::class_<File> file_class(module, "File");
    forbid_new(file_class);
    file_class
        .def_static(
            "read",
            [](const std::string& path, std::vector<std::string> folders, bool lossy,
               std::map<std::string, std::string> constants) {
                return File::read(path, {std::move(folders), lossy, std::move(constants), {}});
            },
            py::arg("path"), py::arg("include"), py::arg("lossy"), py::arg("constants"))
        .def_static(
            "parse",
            [](const std::string& text, const std::string& name, std::vector<std::string> folders, bool lossy,
               std::map<std::string, std::string> constants) {
                return File::parse(text, name, {std::move(folders), lossy, std::move(constants), {}});
            },
            py::arg("text"), py::arg("name"), py::arg("include"), py::arg("lossy"), py::arg("constants"))
        .def("charts", &File::charts)
        .def("loops", &File::loops)
        .def("properties", &File::properties)
        .def("warnings", &File::warnings)
        .def("check",
             [](const File& file, const std::string& loop, const How& how, std::vector<std::string> properties,
                const Bounds& bounds, bool whole, bool untimed, bool certificate) {
                 CheckOptions options;
                 options.properties = std::move(properties);
                 options.whole = whole;
                 return file.check(loop, how, options, bounds, untimed, certificate);
             })
        .def("check_chart", &File::check_chart)
        .def("analyse", &File::analyse)
        .def("tune", &File::tune)
        .def("faults", &File::faults)
        .def("recording", &File::recording)
        .def("draw", &File::draw)
        .def("automaton", &File::automaton)
        .def("mealy", &File::mealy)
        .def("test_sequence", &File::test_sequence)
        .def("simulate_loop", &File::simulate_loop)
        .def("simulate_chart", &File::simulate_chart)
        .def("uppaal", &File::uppaal)
        .def("nusmv", &File::nusmv)
        .def("structured_text", &File::structured_text);
}

}  // namespace grafverif::python
