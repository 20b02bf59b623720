// SPDX-License-Identifier: MIT
// Check functions: decide the properties of one model with an engine and return the results as a report. A run is
// reported only if the interpreter can replay it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyse/analyse.hpp"
#include "check/inputs/inputs.hpp"
#include "check/localization/localization.hpp"
#include "check/pdr/check.hpp"
#include "check/symbolic/symbolic.hpp"
#include "check/vacuity.hpp"
#include "grafverif/grafverif.hpp"
#include "ir/flat_system.hpp"
#include "pipeline/untimed.hpp"
#include "run/replay.hpp"

namespace grafverif {

/// Returns a message such as `WHAT fails the replay under the rules of IEC 60848: controller press, evolution 3: ...
/// (move 7)`. `what` names the trace.
std::string replay_failure(std::string_view what, const Disagreement& disagreement);

/// Returns the names of the properties that a user can select. The names include properties that the model cannot
/// express; their verdict is unknown.
std::vector<std::string> property_names(const Network& network);
std::vector<std::string> property_names(const TransitionSystem& system);

/// True if `known` contains each of `names`. For each name that `known` does not contain, adds an error that suggests a
/// similar name.
bool all_known(const std::vector<std::string>& names, const std::vector<std::string>& known, Diagnostics& diagnostics);

/// A closed loop to check, with the charts of its controllers in the order of the controllers.
struct LoopToCheck {
    const Network& network;
    std::vector<const Chart*> charts = {};
    bool disabled_corrections = false;  ///< true if runs of the network intentionally differ from runs of its charts

    /// Returns the declared duration that determines the time unit; called only for a state profile.
    std::function<std::optional<StateProfile::Finest>()> finest = {};
    StateProver prove = {};  ///< decides properties in abstractions of `network`; may be empty
};
/// Returns the loop to check. `network` is the network of `loop`.
LoopToCheck loop_to_check(const Model& model, Id<ClosedLoop> loop, const Network& network);
Report check(const LoopToCheck& loop, const CheckOptions& options);

/// Converts verdicts on an untimed model and their runs to a report. A run of an embedded engine that does not replay
/// is an internal failure. A run of an external program that does not replay is rejected.
class SystemReporter {
public:
    enum class Of { EmbeddedEngine, Program };

    SystemReporter(const SystemToCheck& check, Of of, std::string engine, const CheckOptions& options,
                   const std::vector<Verdict>& verdicts);

    /// Adds a verdict; verdicts on probes are omitted.
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
    /// Adds the properties that the system cannot express, so that the results are in the order of declaration.
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

/// Returns the indices of the selected properties of the system.
std::vector<std::size_t> selected_properties(const TransitionSystem& system, const std::vector<std::string>& names);
std::vector<std::string> requested_names(const TransitionSystem& system, const std::vector<std::string>& names);

Report check(const SystemToCheck& check, const CheckOptions& options);
std::string words_of(const SymbolicProgress& now);
/// Options for checking properties about states, with an embedded engine on circuits (PDR or BMC) or with an external
/// search procedure (`reach`).
struct StateSearch {
    std::string name = "pdr";
    decltype(PdrOptions::reach) reach = {};
    PdrOptions::Method method = PdrOptions::Method::Pdr;
    std::optional<std::size_t> max_steps = {};  ///< maximum length of a run in BMC
    decltype(PdrOptions::proved) proved = {};
    decltype(PdrOptions::shown) shown = {};
};
/// Returns the options of a BMC search. `max_steps` is the maximum length of the explored runs, 100 by default.
StateSearch bounded_search(std::optional<std::uint64_t> max_steps);
Report check_states(const SystemToCheck& check, const CheckOptions& options, const StateSearch& search = {});

/// Decides selected properties about single states by localization (check/localization/localization.hpp) and input
/// abstraction (check/inputs/inputs.hpp). Returns verdicts on the system, without runs. Requires interleaved automata:
/// only then does the system have the same runs, up to a model error, as the network from which it was derived. If time
/// is abstract, the system has the runs of the network without clocks. If a model error is possible, no verdict is
/// returned. The search takes at most a third of the remaining time, and at most 20 seconds.
std::vector<Verdict> decided_by_abstractions(const SystemToCheck& check, const CheckOptions& options,
                                             const LocalizationLimits& limits = {.whole = 1U << 15U,
                                                                                 .local = 1U << 18U});

/// Checks with the symbolic engine, and also with localization, input abstraction, PDR and BMC if the symbolic engine
/// needs a long time. The symbolic engine first runs alone for `alone` steps of decision-diagram operations (see
/// PortfolioOptions); the default takes about a second.
Report check_together(const SystemToCheck& check, const CheckOptions& options, std::uint64_t alone = 50'000'000);

/// Checks the implicit properties of a chart that is not in a loop. `decide` checks the reachability of the steps.
/// Under stability search, the exploration of `analyse` decides whether the chart becomes stable, because no engine
/// checks this property. The result is empty after an error.
std::optional<Report> check_chart(const Model& model, Id<Chart> chart, const ModelOptions& how,
                                  const CheckOptions& options, Diagnostics& diagnostics,
                                  const std::function<std::optional<Report>(const SystemToCheck& check)>& decide);

/// Adds the implicit properties of a chart that is not in a loop: each step is reachable (for example, `reachable.X2`).
void query_steps(TransitionSystem& system);

Analysis analysis_of(const Chart& chart, const Equations& equations, AnalyseOptions options, const Limits& limits);

}  // namespace grafverif
