// SPDX-License-Identifier: MIT
// Engines at work: each decides the properties of one model and returns what it found. No run is told that does not replay
// on the rules.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyse/analyse.hpp"
#include "check/cells/cells.hpp"
#include "check/pdr/check.hpp"
#include "check/vacuity.hpp"
#include "grafverif/grafverif.hpp"
#include "ir/flat_system.hpp"
#include "pipeline/untimed.hpp"
#include "run/replay.hpp"

namespace grafverif {

/// `the counterexample of P15 does not replay: controller press, evolution 3: ...`
std::string replay_failure(std::string_view what, const Disagreement& disagreement);

/// What a check can be asked for by name; those that the model cannot be asked are answered too, as unknown.
std::vector<std::string> property_names(const Network& network);
std::vector<std::string> property_names(const TransitionSystem& system);

/// Whether each of `names` asks for one of `known`; else an error that names what it may have meant.
bool all_known(const std::vector<std::string>& names, const std::vector<std::string>& known, Diagnostics& diagnostics);

/// A closed loop to be checked, with the charts of its controllers, in order.
struct LoopToCheck {
    const Network& network;
    std::vector<const Chart*> charts = {};
    bool cures_left_out = false;  ///< its runs are not those of its charts, which is the point
    std::function<std::optional<StateProfile::Finest>()> finest = {};  ///< asked where states are explained
};
/// `network` is that of `loop`.
LoopToCheck loop_to_check(const Model& model, Id<ClosedLoop> loop, const Network& network);
Report check(const LoopToCheck& loop, const CheckOptions& options);

/// Turns verdicts on an untimed model and their runs into a report. A run of the embedded engine that does not replay is
/// a failure of ours; a program whose run does not replay is not believed.
class SystemReporter {
public:
    enum class Of { EmbeddedEngine, Program };

    SystemReporter(const SystemToCheck& check, Of of, std::string engine, const CheckOptions& options,
                   const std::vector<Verdict>& verdicts);

    /// A verdict on a probe is left out.
    void add(Verdict verdict, std::optional<SystemRun> run);
    void add(const SystemFault& fault);
    /// All that an embedded engine found, and what cannot be asked.
    template <class Found>
    void add_all(Found&& found) {
        if (found.fault) add(*found.fault);
        apply_probes(check_.system.properties, found.verdicts);
        for (std::size_t i = 0; i < found.verdicts.size(); ++i)
            add(std::move(found.verdicts[i]), std::move(found.runs[i]));
        add_omitted();
    }
    /// What cannot be asked of the system, each in its place among the properties.
    void add_omitted();

    Report report() && { return std::move(report_); }

private:
    bool replays(const SystemRun& run, const std::string& what);

    const SystemToCheck& check_;
    Of of_;
    const CheckOptions& options_;
    std::vector<std::string> unproven_;
    Report report_ = {};
};

/// Those of the system's properties that are asked for.
std::vector<std::size_t> asked_properties(const TransitionSystem& system, const std::vector<std::string>& names);
std::vector<std::string> names_asked(const TransitionSystem& system, const std::vector<std::string>& names);

Report check(const SystemToCheck& check, const CheckOptions& options);
/// The same of what is about states, by an embedded engine on circuits or by who searches in its place.
struct StateSearch {
    std::string name = "pdr";
    decltype(PdrOptions::reach) reach = {};
    PdrOptions::Method method = PdrOptions::Method::Pdr;
    std::optional<std::size_t> max_steps = {};  ///< of BMC
};
/// BMC; `max_steps`: of the runs looked at, 100 unless said.
StateSearch bounded_search(std::optional<std::uint64_t> max_steps);
Report check_states(const SystemToCheck& check, const CheckOptions& options, const StateSearch& search = {});

/// Of what is asked about single states, what cells decide (check/cells/cells.hpp): the verdicts of the system, without runs.
/// Where its automata take turns the system has the runs of the network that it was made of, clocks having no say where time is
/// abstract, up to where that breaks off; and cells tell nothing where something may break off. They have a third of the time
/// that there is, and 20 seconds at most.
std::vector<Verdict> decided_by_cells(const SystemToCheck& check, const CheckOptions& options,
                                      const CellLimits& limits = {.whole = 1U << 15U, .local = 1U << 18U});

/// The same by the embedded engines beside each other, of what cells do not decide.
Report check_together(const SystemToCheck& check, const CheckOptions& options);

/// Has `decide` answer what a chart alone is asked; under stability search the search of `analyse` adds whether it stabilises,
/// which no engine is asked. Nothing after an error.
std::optional<Report> check_chart(const Model& model, Id<Chart> chart, const ModelOptions& how,
                                  const CheckOptions& options, Diagnostics& diagnostics,
                                  const std::function<std::optional<Report>(const SystemToCheck& check)>& decide);

/// Adds what a chart alone is asked: that each of its steps can be reached (`reachable.X2`).
void ask_for_steps(TransitionSystem& system);

Analysis analysis_of(const Chart& chart, const Equations& equations, AnalyseOptions options, const Limits& limits);

}  // namespace grafverif
