// SPDX-License-Identifier: MIT
// Checks: decide the properties of one model by an engine and return the results as a report. Only runs that the
// interpreter can replay are reported.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyse/analyse.hpp"
#include "check/localization/localization.hpp"
#include "check/pdr/check.hpp"
#include "check/symbolic/symbolic.hpp"
#include "check/vacuity.hpp"
#include "grafverif/grafverif.hpp"
#include "ir/flat_system.hpp"
#include "pipeline/untimed.hpp"
#include "run/replay.hpp"

namespace grafverif {

/// `the counterexample of P15 does not replay: controller press, evolution 3: ...`
std::string replay_failure(std::string_view what, const Disagreement& disagreement);

/// Names of the properties that can be selected; those that the model cannot express are reported as unknown.
std::vector<std::string> property_names(const Network& network);
std::vector<std::string> property_names(const TransitionSystem& system);

/// True if `known` contains each of `names`; otherwise an error that suggests a similar name.
bool all_known(const std::vector<std::string>& names, const std::vector<std::string>& known, Diagnostics& diagnostics);

/// A closed loop to be checked, with the charts of its controllers, in order.
struct LoopToCheck {
    const Network& network;
    std::vector<const Chart*> charts = {};
    bool disabled_corrections = false;  ///< its runs intentionally differ from those of its charts
    std::function<std::optional<StateProfile::Finest>()> finest = {};  ///< called if states are explained
};
/// `network` is that of `loop`.
LoopToCheck loop_to_check(const Model& model, Id<ClosedLoop> loop, const Network& network);
Report check(const LoopToCheck& loop, const CheckOptions& options);

/// Converts verdicts on an untimed model and their runs to a report. A run of the embedded engine that does not replay
/// is an internal failure; a run of an external program that does not replay is rejected.
class SystemReporter {
public:
    enum class Of { EmbeddedEngine, Program };

    SystemReporter(const SystemToCheck& check, Of of, std::string engine, const CheckOptions& options,
                   const std::vector<Verdict>& verdicts);

    /// Verdicts on probes are omitted.
    void add(Verdict verdict, std::optional<SystemRun> run);
    void add(const SystemFault& fault);
    /// Adds all results of an embedded engine, and the properties that the model cannot express.
    template <class Found>
    void add_all(Found&& found) {
        if (found.fault) add(*found.fault);
        apply_probes(check_.system.properties, found.verdicts);
        for (std::size_t i = 0; i < found.verdicts.size(); ++i)
            add(std::move(found.verdicts[i]), std::move(found.runs[i]));
        add_omitted();
    }
    /// Adds the properties that the system cannot express, in the order of the properties.
    void add_omitted();

    Report report() &&;

private:
    bool replays(const SystemRun& run, const std::string& what);

    const SystemToCheck& check_;
    Of of_;
    const CheckOptions& options_;
    std::vector<std::string> unproven_;
    Report report_ = {};
};

/// The selected properties of the system.
std::vector<std::size_t> selected_properties(const TransitionSystem& system, const std::vector<std::string>& names);
std::vector<std::string> requested_names(const TransitionSystem& system, const std::vector<std::string>& names);

Report check(const SystemToCheck& check, const CheckOptions& options);
std::string words_of(const SymbolicProgress& now);
/// Checks properties about states, by an embedded engine on circuits or a search procedure that replaces it.
struct StateSearch {
    std::string name = "pdr";
    decltype(PdrOptions::reach) reach = {};
    PdrOptions::Method method = PdrOptions::Method::Pdr;
    std::optional<std::size_t> max_steps = {};  ///< of BMC
};
/// BMC; `max_steps`: length of the explored runs, 100 by default.
StateSearch bounded_search(std::optional<std::uint64_t> max_steps);
Report check_states(const SystemToCheck& check, const CheckOptions& options, const StateSearch& search = {});

/// Decides selected properties about single states by localization (check/localization/localization.hpp): the verdicts
/// of the system, without runs. Requires interleaved automata: the system then has the runs of the network that it was
/// derived from, up to a model error, without clocks if time is abstract. Localization gives no verdict if a model
/// error is possible. It has a third of the remaining time, and 20 seconds at most.
std::vector<Verdict> decided_by_cells(const SystemToCheck& check, const CheckOptions& options,
                                      const LocalizationLimits& limits = {.whole = 1U << 15U, .local = 1U << 18U});

/// Checks by the symbolic engine, which localization, PDR and BMC join if it takes long. `alone`: see PortfolioOptions;
/// about a second, but the same number of steps on any machine.
Report check_together(const SystemToCheck& check, const CheckOptions& options, std::uint64_t alone = 50'000'000);

/// Checks the implicit properties of a chart alone by `decide`. Under stability search, the search of `analyse` adds
/// whether the chart becomes stable, which no engine decides. Nothing after an error.
std::optional<Report> check_chart(const Model& model, Id<Chart> chart, const ModelOptions& how,
                                  const CheckOptions& options, Diagnostics& diagnostics,
                                  const std::function<std::optional<Report>(const SystemToCheck& check)>& decide);

/// Adds the implicit properties of a chart alone: each step is reachable (`reachable.X2`).
void query_steps(TransitionSystem& system);

Analysis analysis_of(const Chart& chart, const Equations& equations, AnalyseOptions options, const Limits& limits);

}  // namespace grafverif
