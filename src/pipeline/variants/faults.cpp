// SPDX-License-Identifier: MIT
#include "pipeline/variants/faults.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "check/shares.hpp"
#include "ir/patterns.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "pipeline/variants/fault_detection.hpp"
#include "pipeline/variants/fault_model.hpp"
#include "pipeline/variants/fault_passes.hpp"
#include "pipeline/variants/in_parallel.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

namespace {

/// Returns the preferred name of the property that is proposed for a fault. For the fault `F[1]`, the name is
/// `detects_F_1`, because an index is allowed only in the names of copies.
std::string observer_name(const std::string& fault) {
    std::string name = "detects_";
    for (const char letter : fault)
        if (letter != ']') name += letter == '[' ? '_' : letter;
    return name;
}

using Indices = std::vector<std::size_t>;

/// True if a property with this pattern can be reported as `holds` for a combination only if its verdicts for all
/// subsets are known. Reason: a state or run that violates the property without a fault may satisfy it in the model of
/// the combination, in which this fault may still occur.
bool needs_subsets(Pattern pattern) { return !is_about_existence(pattern) && !is_about_all_states(pattern); }

/// Returns the name in the model of the property of a row.
std::string base_name(const FaultAnalysis::Row& row) { return base_name(row.property, row.pattern); }

/// A combination of faults to check, the rows for which it is checked, and the results.
struct CombinationCheck {
    FaultSet faults = {};
    Indices rows = {};
    std::vector<std::pair<std::size_t, FaultAnalysis::Cut>> violated = {};  ///< violated rows with their results
    std::vector<std::pair<std::size_t, std::string>> unknown = {};  ///< rows with unknown verdicts, and the reasons
    std::vector<ModelErrorTrace> errors = {};
    std::vector<std::string> failures = {};
    double states = 0;  ///< number of states of the model in which the faults may occur at any time; 0 if unknown
    bool done = false;
};

class FaultAnalyzer {
public:
    FaultAnalyzer(const Model& model, Id<ClosedLoop> loop, const FaultsRequest& request, Diagnostics& diagnostics)
        : model_(model), loop_(loop), request_(request), diagnostics_(diagnostics) {}

    std::optional<FaultAnalysis> run() {
        const auto network = network_of(model_, loop_, request_.how, diagnostics_);
        if (!network || !all_known(request_.properties, property_names(*network), diagnostics_)) return {};
        if (!faults_are_valid()) return {};
        analysis_.model = model_.loops[loop_].name;
        analysis_.order = request_.order;
        check_without_faults(*network);
        for (std::size_t size = 1; size <= request_.order; ++size) check_combinations(size);
        if (request_.visible) find_visible(*network);
        analysis_.checks = checks_;
        return std::move(analysis_);
    }

private:
    bool stopped() const { return is_over(request_.limits.deadline, request_.limits.stop); }
    const Table<ClosedLoop::Fault>& faults() const { return model_.loops[loop_].faults; }

    /// Builds the model of each single fault, so that errors in faults are reported before the search. Returns false
    /// after an error.
    bool faults_are_valid() {
        bool valid = true;
        for (const Id<ClosedLoop::Fault> id : faults().ids()) {
            const ClosedLoop::Fault& fault = faults()[id];
            const Model made = with_faults(model_, loop_, {{id, true}});
            Diagnostics found;
            valid = network_of(made, loop_, request_.how, found).has_value() && valid;
            for (const Diagnostic& each : found.all())
                if (each.severity == Severity::Error) diagnostics_.add(each);
            analysis_.faults.push_back({fault.behaviour.name, model_.loops[loop_].instances[fault.of].name,
                                        model_.components[fault.behaviour.component].name, fault.behaviour.origin});
        }
        return valid;
    }

    /// Returns the options of one check. A check may use at most a quarter of the remaining time.
    CheckOptions options(unsigned jobs) const {
        CheckOptions options{.properties = request_.properties, .limits = request_.limits, .jobs = jobs};
        options.limits.deadline = share_of(request_.limits.deadline, 4);
        options.witnesses = false;
        options.limits.progress = {};
        return options;
    }

    /// Checks the properties of `options` for the network, in several passes (fault_passes.hpp).
    Report report_on(const Model& model, const Network& network, CheckOptions options, bool timelock,
                     double expected = 0) const {
        ++checks_;
        return check_in_passes(loop_to_check(model, loop_, network), std::move(options), request_, timelock, expected);
    }

    /// Returns the expected number of states of the model in which the faults of a combination may occur at any time.
    /// The estimate assumes that each fault multiplies the number of states by the same factor as in the loop without
    /// other faults. The result is 0 if the number of states without faults or with a single fault is unknown.
    double expected_states(const FaultSet& faults) const {
        if (faults.size() < 2 || states_without_faults_ <= 0) return 0;
        double states = states_without_faults_;
        for (const std::size_t fault : faults)
            states *= fault < states_.size() ? states_[fault] / states_without_faults_ : 0;
        return states;
    }

    /// True if the user requested the property of the row. Every check decides `no timelock`, even if it is not
    /// requested.
    bool is_requested(const FaultAnalysis::Row& row) const {
        const std::vector<std::string>& names = request_.properties;
        return names.empty() || std::ranges::find(names, row.property) != names.end() ||
               std::ranges::find(names, base_name(row)) != names.end();
    }

    void check_without_faults(const Network& network) {
        Report report = report_on(model_, network, options(request_.jobs), true);
        analysis_.settings = report.settings;
        states_without_faults_ = states_of(report);
        analysis_.failures = std::move(report.failures);
        for (ModelErrorTrace& each : report.error_traces) analysis_.errors.push_back({{}, std::move(each)});
        for (const PropertyResult& result : report.answers) {
            const Verdict& verdict = result.verdict;
            FaultAnalysis::Row row{verdict.property, result.text,     verdict.pattern,          verdict.declared,
                                   verdict.origin,   verdict.outcome, verdict.expected_violated};
            for (const Property& property : network.properties)
                if (property.name == base_name(row)) row.pattern = property.pattern;
            row.declared = row.declared && is_requested(row);
            analysis_.rows.push_back(std::move(row));
        }
    }

    // -- combinations ---------------------------------------------------------------------------------------------

    /// Calls `visit` for each combination of `size` faults of different instances, in lexicographic order.
    template <class Visit>
    void each_combination(std::size_t size, FaultSet& chosen, const Visit& visit) const {
        if (chosen.size() == size) return visit(chosen);
        for (std::size_t next = chosen.empty() ? 0 : chosen.back() + 1; next < faults().size(); ++next) {
            if (std::ranges::any_of(chosen, [&](std::size_t each) { return instance(each) == instance(next); }))
                continue;
            chosen.push_back(next);
            each_combination(size, chosen, visit);
            chosen.pop_back();
        }
    }

    Id<ClosedLoop::Instance> instance(std::size_t fault) const {
        return faults()[Id<ClosedLoop::Fault>{static_cast<std::uint32_t>(fault)}].of;
    }

    /// True if the combination must be checked for the property of the row.
    static bool is_open(const FaultAnalysis::Row& row, const FaultSet& faults) {
        if (row.without_faults != Outcome::Holds) return false;
        return is_about_existence(row.pattern) || violating_subset(row, faults) == nullptr;
    }

    void check_combinations(std::size_t size) {
        std::vector<CombinationCheck> jobs;
        FaultSet chosen;
        each_combination(size, chosen, [&](const FaultSet& faults) {
            ++analysis_.combinations;
            CombinationCheck job{.faults = faults};
            for (std::size_t k = 0; k < analysis_.rows.size(); ++k)
                if (is_open(analysis_.rows[k], faults)) job.rows.push_back(k);
            if (!job.rows.empty()) jobs.push_back(std::move(job));
        });
        std::size_t done = 0;
        std::mutex mutex;  // protects `done` and calls of the callback
        in_parallel(
            jobs.size(), request_.jobs, [this] { return stopped(); },
            [&](std::size_t k) {
                check(jobs[k], jobs.size() > 1 ? 1 : request_.jobs);
                const std::lock_guard lock(mutex);
                ++done;
                if (!request_.limits.progress) return;
                request_.limits.progress({[&] {
                    return std::to_string(done) + " of " + std::to_string(jobs.size()) + " combinations of " +
                           std::to_string(size) + " faults";
                }});
            });
        if (size == 1) states_.resize(faults().size());
        for (CombinationCheck& job : jobs) {
            if (size == 1) states_[job.faults.front()] = job.states;
            apply(job);
        }
    }

    /// Checks the models of a combination: first the model in which all faults occur at any time, then models in which
    /// some faults are present from power-on. Bit k of `present` is set if fault k of the combination is present from
    /// power-on.
    void check(CombinationCheck& job, unsigned jobs) const {
        const std::size_t all = (std::size_t{1} << job.faults.size()) - 1;
        for (std::size_t present = 0; present <= all && !stopped(); ++present) {
            Indices rows;
            for (const std::size_t row : job.rows)
                if (needs(analysis_.rows[row].pattern, present, all) && !is_violated(job, row)) rows.push_back(row);
            if (!rows.empty()) check(job, rows, present, jobs);
        }
        job.done = !stopped();
    }

    /// True if a property with this pattern must be checked in the model in which the faults `present` are present from
    /// power-on. `all` is the set of all faults of the combination.
    static bool needs(Pattern pattern, std::size_t present, std::size_t all) {
        if (is_about_existence(pattern)) return present == all;
        return present == 0 || pattern == Pattern::Inevitable || pattern == Pattern::Watched;
    }

    static bool is_violated(const CombinationCheck& job, std::size_t row) {
        return std::ranges::any_of(job.violated, [&](const auto& each) { return each.first == row; });
    }

    std::vector<ActiveFault> active(const FaultSet& faults, std::size_t present) const {
        std::vector<ActiveFault> list;
        for (std::size_t k = 0; k < faults.size(); ++k)
            list.push_back({{static_cast<std::uint32_t>(faults[k])}, (present >> k & 1U) != 0});
        return list;
    }

    void check(CombinationCheck& job, const Indices& rows, std::size_t present, unsigned jobs) const {
        const Model made = with_faults(model_, loop_, active(job.faults, present));
        Diagnostics found;
        const auto network = network_of(made, loop_, request_.how, found);
        if (!network) return fail(job, rows, found);
        CheckOptions how = options(jobs);
        how.properties.clear();
        for (const std::size_t row : rows)
            if (const std::string name = base_name(analysis_.rows[row]);
                std::ranges::find(how.properties, name) == how.properties.end())
                how.properties.push_back(name);
        const bool timelock = std::ranges::any_of(
            rows, [&](std::size_t row) { return analysis_.rows[row].pattern == Pattern::NoTimelock; });
        Report report = report_on(made, *network, how, timelock, present == 0 ? expected_states(job.faults) : 0);
        if (present == 0) job.states = states_of(report);
        std::ranges::move(report.failures, std::back_inserter(job.failures));
        add_errors(std::move(report.error_traces), job.errors);
        for (PropertyResult& result : report.answers)
            for (const std::size_t row : rows)
                if (analysis_.rows[row].property == result.verdict.property) {
                    note(job, row, present, std::move(result));
                    break;
                }
    }

    /// Handles an error in the model of a combination: sets the verdicts to unknown. Errors are possible although the
    /// model of each single fault is valid: for example, the combination may need another time unit.
    static void fail(CombinationCheck& job, const Indices& rows, const Diagnostics& found) {
        const auto error = std::ranges::find(found.all(), Severity::Error, &Diagnostic::severity);
        for (const std::size_t row : rows)
            job.unknown.emplace_back(row, error == found.all().end() ? "" : error->message);
    }

    static void note(CombinationCheck& job, std::size_t row, std::size_t present, PropertyResult result) {
        if (result.verdict.outcome == Outcome::Unknown)
            return void(job.unknown.emplace_back(row, result.verdict.reason));
        if (result.verdict.outcome == Outcome::Holds) return;
        FaultSet from_power_on;
        for (std::size_t k = 0; k < job.faults.size(); ++k)
            if ((present >> k & 1U) != 0) from_power_on.push_back(job.faults[k]);
        job.violated.push_back({row, {job.faults, std::move(from_power_on), std::move(result)}});
    }

    void apply(CombinationCheck& job) {
        std::ranges::move(job.failures, std::back_inserter(analysis_.failures));
        for (ModelErrorTrace& each : job.errors)
            if (!has_error(job.faults, each)) analysis_.errors.push_back({job.faults, std::move(each)});
        for (auto& [index, cut] : job.violated) {
            FaultAnalysis::Row& row = analysis_.rows[index];
            if (violating_subset(row, job.faults) != nullptr) continue;
            cut.unknown_subsets = unknown_subsets(row, job.faults);
            row.minimal.push_back(std::move(cut));
        }
        for (const std::size_t index : job.rows) apply(job, index);
    }

    /// True if the analysis already contains this model error for a subset of the combination.
    bool has_error(const FaultSet& faults, const ModelErrorTrace& error) const {
        return std::ranges::any_of(analysis_.errors, [&](const FaultAnalysis::Error& each) {
            return each.trace.code == error.code && each.trace.message == error.message &&
                   std::ranges::includes(faults, each.faults);
        });
    }

    static const FaultAnalysis::Cut* violating_subset(const FaultAnalysis::Row& row, const FaultSet& faults) {
        for (const FaultAnalysis::Cut& cut : row.minimal)
            if (std::ranges::includes(faults, cut.faults)) return &cut;
        return nullptr;
    }

    static std::vector<FaultSet> unknown_subsets(const FaultAnalysis::Row& row, const FaultSet& faults) {
        std::vector<FaultSet> subsets;
        for (const FaultAnalysis::Open& open : row.open)
            if (std::ranges::includes(faults, open.faults)) subsets.push_back(open.faults);
        return subsets;
    }

    /// Stores the result for a row that the combination does not violate: the verdict is unknown, or the combination
    /// satisfies the property although a subset of its faults violates it.
    void apply(const CombinationCheck& job, std::size_t index) {
        FaultAnalysis::Row& row = analysis_.rows[index];
        if (is_violated(job, index)) return;
        const auto unknown = std::ranges::find(job.unknown, index, [](const auto& each) { return each.first; });
        const FaultAnalysis::Cut* const subset = violating_subset(row, job.faults);
        if (!job.done || unknown != job.unknown.end()) {
            if (subset == nullptr)
                row.open.push_back({job.faults, unknown == job.unknown.end() ? "" : unknown->second});
        } else if (subset != nullptr) {
            row.non_monotone.push_back({subset->faults, job.faults});
        } else if (needs_subsets(row.pattern) && !unknown_subsets(row, job.faults).empty()) {
            row.open.push_back({job.faults, "the verdict for a subset of these faults is unknown"});
        }
    }

    // -- visible effects ------------------------------------------------------------------------------------------

    /// Replaces the properties of a network by one property for each step, output and proposed property: it is true in
    /// some reachable state.
    static void query_visible(Network& network) {
        network.properties = {};
        for (const ControllerSignal& each : controller_signals(network, false))
            network.properties.add({.name = each.name,
                                    .pattern = Pattern::Reachable,
                                    .operands = {network.exprs.leaf(Op::Variable, each.variable.index)}});
    }

    /// The steps, outputs and proposed properties that are true in some reachable state (`yes`) and in no reachable
    /// state (`no`).
    struct Reached {
        std::set<std::string> yes = {}, no = {};
        bool complete = true;
    };

    Reached reached(const Model& model, Network network, unsigned jobs) const {
        query_visible(network);
        CheckOptions how = options(jobs);
        how.properties = {};
        Reached found;
        for (const PropertyResult& result : report_on(model, network, how, false).answers) {
            if (result.verdict.pattern != Pattern::Reachable) continue;
            if (result.verdict.outcome == Outcome::Holds) found.yes.insert(result.verdict.property);
            else if (result.verdict.outcome == Outcome::Violated) found.no.insert(result.verdict.property);
            else found.complete = false;
        }
        return found;
    }

    void find_visible(const Network& network) {
        if (stopped()) return;
        const Reached normal = reached(model_, network, request_.jobs);
        const FaultDetection detection(network, request_.limits, request_.first_states);
        UniqueNames taken;
        for (const Property& property : model_.loops[loop_].properties) taken.take(property.name);
        std::vector<std::string> names;
        for (const FaultAnalysis::Fault& fault : analysis_.faults)
            names.push_back(taken.fresh(observer_name(fault.name)));
        in_parallel(
            analysis_.faults.size(), request_.jobs, [this] { return stopped(); },
            [&](std::size_t k) {
                analysis_.faults[k].visible = visible(k, normal);
                if (analysis_.faults[k].visible.decided) detect(k, names[k], detection);
            });
    }

    FaultAnalysis::Visible visible(std::size_t fault, const Reached& normal) const {
        FaultAnalysis::Visible visible;
        Diagnostics found;
        const Model any = with_faults(model_, loop_, active({fault}, 0));
        const Model begun = with_faults(model_, loop_, active({fault}, 1));
        const auto any_network = network_of(any, loop_, request_.how, found);
        auto begun_network = network_of(begun, loop_, request_.how, found);
        if (!any_network || !begun_network) return visible;
        const Reached at_any_time = reached(any, *any_network, 1), from_power_on = reached(begun, *begun_network, 1);
        std::ranges::set_intersection(at_any_time.yes, normal.no, std::back_inserter(visible.newly_true));
        std::ranges::set_intersection(from_power_on.no, normal.yes, std::back_inserter(visible.never_true));
        visible.decided = normal.complete && at_any_time.complete && from_power_on.complete;
        if (!visible.newly_true.empty()) visible.always_shown = shown(begun, *begun_network, visible.newly_true);
        return visible;
    }

    /// Decides if at least one of the elements `names` becomes true in every run.
    Outcome shown(const Model& model, Network& network, const std::vector<std::string>& names) const {
        network.properties = {};
        network.properties.add(
            {.name = "shown", .pattern = Pattern::Inevitable, .operands = {any_of_signals(network, names)}});
        CheckOptions how = options(1);
        how.properties = {"shown"};
        for (const PropertyResult& result : report_on(model, network, how, false).answers)
            if (result.verdict.property == "shown") return result.verdict.outcome;
        return Outcome::Unknown;
    }

    /// Decides if every run with fault `k` makes one of the newly true elements true, and determines the longest time
    /// to this event. If this is not the case, searches for a property with the name `name` that reveals the fault.
    void detect(std::size_t k, const std::string& name, const FaultDetection& detection) {
        FaultAnalysis::Fault& fault = analysis_.faults[k];
        Diagnostics found;
        const Model model = with_faults(model_, loop_, {{.fault = {static_cast<std::uint32_t>(k)}, .announced = true}});
        const auto faulty = network_of(model, loop_, request_.how, found);
        if (!faulty || stopped()) return;
        const auto decide = [&](const Network& network) {
            CheckOptions how = options(1);
            how.properties = property_names(network);
            std::vector<Verdict> verdicts;
            for (PropertyResult& result : report_on(model, network, how, false).answers)
                verdicts.push_back(std::move(result.verdict));
            return verdicts;
        };
        FaultAnalysis::Visible& visible = fault.visible;
        if (!visible.newly_true.empty()) {
            const auto shown = detection.detected(*faulty, fault.instance, visible.newly_true, decide);
            visible.detected = shown.in_every_run;
            visible.within_ms = shown.within_ms;
        }
        if (visible.detected == Outcome::Holds || stopped()) return;
        auto proposed = detection.observer(name, *faulty, fault.instance, decide);
        visible.observer = std::move(proposed.observer);
        visible.observer_limit = std::move(proposed.limit);
    }

    const Model& model_;
    Id<ClosedLoop> loop_;
    const FaultsRequest& request_;
    Diagnostics& diagnostics_;
    FaultAnalysis analysis_ = {};
    double states_without_faults_ = 0;
    std::vector<double> states_ = {};  ///< for each fault: number of states with only this fault
    mutable std::atomic<std::size_t> checks_ = 0;
};

}  // namespace

std::optional<FaultAnalysis> analysed_faults(const Model& model, Id<ClosedLoop> loop, const FaultsRequest& request,
                                             Diagnostics& diagnostics) {
    return FaultAnalyzer(model, loop, request, diagnostics).run();
}

}  // namespace grafverif
