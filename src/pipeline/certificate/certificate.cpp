// SPDX-License-Identifier: MIT
#include "pipeline/certificate/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>

#include "check/timed/property_queries.hpp"
#include "check/timed/timed.hpp"
#include "compose/observe.hpp"
#include "emit/certificate/certificate.hpp"
#include "ir/network_run.hpp"
#include "ir/patterns.hpp"
#include "ir/probes.hpp"
#include "ir/step_names.hpp"
#include "pipeline/certificate/fragment_proofs.hpp"
#include "pipeline/staged_search.hpp"
#include "run/retiming.hpp"

namespace grafverif {

namespace {

/// Maximum number of states of a certificate, and of all values of these states, which are stored in memory; maximum
/// size of a run. `most_explored` is the limit of `grafverif-certify` for the states that are reachable from the last
/// state of a run: the number of states, multiplied by the number of their values plus 16.
constexpr std::uint64_t most_states = 10'000'000;
constexpr std::size_t most_values = std::size_t{1} << 27U, most_bytes = std::size_t{1} << 26U;
constexpr std::size_t most_explored = 200'000'000;

/// Returns the name of the folder for a property. File systems limit the length of a name.
std::string folder_of(const std::string& property) {
    const std::string word = certificate::word_of(property);
    return word.size() <= 200 ? word : "property_" + certificate::checksum(property);
}

/// Returns the property that `verdict` decides. For a verdict on one step of a property `reachable all steps`, returns
/// a property `reachable` of this step.
Property decided_property(const Network& flat, const Verdict& verdict) {
    Property property = verdict.about.valid() ? flat.properties[verdict.about] : timed::undeclared_timelock(flat);
    if (property.pattern == Pattern::ReachableAllSteps) {
        property.pattern = Pattern::Reachable;
        std::erase_if(property.operands, [&](Id<Expr> operand) {
            const Id<Network::Variable> step{static_cast<std::uint32_t>(flat.exprs[operand].value)};
            return property.name + "." + step_variable_name(flat, step) != verdict.property;
        });
    }
    property.name = verdict.property;
    return property;
}

/// Returns the property that `verdict` decides, for a verdict on a network in which the properties may have other ids.
/// Requires that `flat` declares the property.
Property reported_property(const Network& flat, Verdict verdict) {
    for (const Id<Property> id : flat.properties.ids()) {
        const Property& property = flat.properties[id];
        const bool is_of_step =
            property.pattern == Pattern::ReachableAllSteps && verdict.property.starts_with(property.name + '.');
        if (property.name == verdict.property || is_of_step) verdict.about = id;
    }
    return decided_property(flat, verdict);
}

/// Creates the certificate of one network in one folder.
class FolderWriter {
public:
    FolderWriter(Network flat, std::string folder, Certificate& certificate)
        : flat_(std::move(flat)),
          unwritable_(certificate::obstacle(flat_)),
          folder_(std::move(folder)),
          certificate_(certificate) {}

    /// Proves `reported` by fragments, subsystems and runs. Only verdicts of localization and of input abstraction are
    /// proved by fragments.
    void begin(const std::vector<const Verdict*>& reported, TimedOptions options) {
        options_ = std::move(options);
        limits_.deadline = options_.deadline;
        limits_.stop = options_.stop;
        limits_.states = std::min(options_.max_states, limits_.states);
        const auto is_separate = [](const Verdict* one) { return one->scope.cells || one->abstraction.has_value(); };
        std::vector<const Verdict*> separate, others;
        std::ranges::partition_copy(reported, std::back_inserter(separate), std::back_inserter(others), is_separate);
        for (const Verdict* verdict : prove_by_fragments(separate)) others.push_back(verdict);
        std::erase_if(others, [&](const Verdict* verdict) { return prove_by_subsystems(*verdict); });
        for (const Verdict* verdict : others) {
            if (verdict->outcome == Outcome::Unknown) omit(*verdict, "the verdict is unknown");
            else if (!unwritable_.empty()) omit(*verdict, unwritable_);
            else if (std::optional<std::string> run = proving_run(*verdict)) by_runs_.emplace_back(verdict, *run);
            else open_.push_back(verdict);
        }
    }

    /// Proves all other verdicts by a complete search. Adds the claims and the lines `more` to the index. A subfolder
    /// without claims is not written. Returns the lines for the index of the folder that contains this folder.
    std::string finish(const std::string& more = {}) {
        if (!open_.empty()) prove_completely(open_, options_);
        for (const auto& [verdict, run] : by_runs_)
            claim(reported_property(flat_, *verdict), verdict->outcome, CertificateKind::Run, run);
        return written(more);
    }

private:
    std::string path(const std::string& file) const { return folder_.empty() ? file : folder_ + '/' + file; }

    void omit(const Verdict& verdict, std::string reason) { omitted_.push_back({verdict.property, std::move(reason)}); }
    void claim(const Property& property, Outcome outcome, CertificateKind kind, const std::string& run = {}) {
        properties_.push_back(property);
        claims_ += fmt::format("{} {}\n{}", word(outcome), certificate::word_of(property.name), run);
        certificate_.summary.certified.push_back({property.name, kind});
    }
    /// Adds a set of states in a subfolder; `keyword` is `states`, `bounds` or `subsystem`.
    void add_states(std::string_view keyword, const std::string& subfolder, const FragmentStates& found) {
        std::string text = certificate::states_text(found.states);
        claims_ += fmt::format("{} {} {}\n", keyword, certificate::checksum(text), subfolder);
        certificate_.files.push_back({path(subfolder + "/states.txt"), std::move(text)});
    }

    /// Returns the lines of the run of the verdict, if this run alone proves the verdict. The result is empty if the
    /// verdict has no such run: then a complete search is needed.
    std::optional<std::string> proving_run(const Verdict& verdict) const {
        const Property property = reported_property(flat_, verdict);
        const Outcome outcome = property.pattern == Pattern::Reachable ? Outcome::Holds : Outcome::Violated;
        if (!verdict.run || verdict.outcome != outcome) return {};
        if (timed::about_race(flat_, property)) return run_before_race(*verdict.run);
        if (ends_with_race(*verdict.run) || !decides(flat_, *verdict.run, property.pattern)) return {};
        const std::vector<NetworkState> states = replay(flat_, *verdict.run).value();
        const bool is_proved = is_liveness(property.pattern) ? avoids(property, states, verdict.run->loop)
                                                             : ends_with_decision(property, states.back());
        return is_proved ? certificate::run_text(flat_, *verdict.run, most_bytes) : std::nullopt;
    }

    /// Returns the lines of a run to the state before a race. The edge that causes the race has no successor.
    std::optional<std::string> run_before_race(Run run) const {
        if (run.moves.empty() || !ends_with_race(run)) return {};
        run.moves.pop_back();
        return ends_with_race(run) ? std::nullopt : certificate::run_text(flat_, run, most_bytes);
    }

    /// False if the property has `at stable` and the state is not quiescent.
    bool concerns(const Property& property, const NetworkState& state) const {
        return !property.at_stable || value(flat_, state, flat_.settled) == 1;
    }

    /// True if the property concerns the state, and the term has a value other than 0.
    bool holds(const Property& property, Id<Expr> term, const NetworkState& state) const {
        return concerns(property, state) && value(flat_, state, term).value_or(0) != 0;
    }

    /// True if the state violates a property about single states (for `reachable`: satisfies it).
    bool ends_with_decision(const Property& property, const NetworkState& state) const {
        const std::vector<Id<Expr>>& operands = property.operands;
        const auto is_true = [&](Id<Expr> term) { return holds(property, term, state); };
        switch (property.pattern) {
        case Pattern::Always: return concerns(property, state) && value(flat_, state, operands[0]) == 0;
        case Pattern::Never:
        case Pattern::Reachable: return is_true(operands[0]);
        case Pattern::ExactlyOneOf: return concerns(property, state) && std::ranges::count_if(operands, is_true) != 1;
        default: return false;
        }
    }

    /// True if the run with these states violates an `inevitable` or a `leads to`: no state has q, or no state from a
    /// state with p on. `loop` is the index of the state that equals the last state.
    bool avoids(const Property& property, const std::vector<NetworkState>& states,
                const std::optional<std::size_t>& loop) const {
        const Id<Expr> q = property.operands.back();
        std::size_t first = states.size();  // no state from this state on has q
        while (first > 0 && !holds(property, q, states[first - 1])) --first;
        if (property.pattern == Pattern::Inevitable) return first == 0;
        if (loop && first > *loop) return false;
        return std::any_of(states.begin() + static_cast<std::ptrdiff_t>(first), states.end(),
                           [&](const NetworkState& state) { return holds(property, property.operands[0], state); });
    }

    /// Returns the verdicts that fragments do not prove.
    std::vector<const Verdict*> prove_by_fragments(const std::vector<const Verdict*>& verdicts) {
        if (verdicts.empty() || !unwritable_.empty()) return verdicts;
        FragmentProofs proofs(flat_, limits_);
        std::vector<const Verdict*> open, proved;
        for (const Verdict* verdict : verdicts)
            (proofs.prove(*verdict, reported_property(flat_, *verdict)) ? proved : open).push_back(verdict);
        if (!proofs.exclude_errors()) return verdicts;
        std::size_t number = 0;
        for (const FragmentStates& bound : proofs.bounds())
            add_states("bounds", fmt::format("bounds-{}", ++number), bound);
        for (const FragmentProofs::Proof& proof : proofs.proofs()) {
            if (proof.content.step > 1) claims_ += fmt::format("step {}\n", proof.content.step);
            for (const Id<Network::Process> process : proof.content.reacting)
                claims_ += fmt::format("reacts {}\n", certificate::word_of(flat_.processes[process].name));
            const std::string word = proof.properties.empty() ? "errors" : folder_of(proof.properties.front().name);
            add_states("states", fmt::format("{}-{}", word, ++number), proof.found);
            for (const Property& property : proof.properties) {
                const bool is_violated = property.pattern == Pattern::Reachable;
                claim(property, is_violated ? Outcome::Violated : Outcome::Holds, CertificateKind::Fragment);
            }
        }
        return open;
    }

    /// Proves a `no deadlock` that holds for each independent subsystem.
    bool prove_by_subsystems(const Verdict& verdict) {
        const bool is_separate = !verdict.scope.searched.empty() || !verdict.scope.left_out.empty();
        if (verdict.pattern != Pattern::NoDeadlock || !is_separate || !unwritable_.empty()) return false;
        if (verdict.outcome == Outcome::Unknown) return false;
        const Property property = reported_property(flat_, verdict);
        std::optional<std::vector<FragmentStates>> parts;
        if (verdict.outcome == Outcome::Holds && !property.at_stable)
            parts = FragmentProofs(flat_, limits_).subsystems();
        if (!parts) {
            omit(verdict,
                 "the verdict applies to each subsystem; pass `--monolithic` to certify it for the complete loop");
            return true;
        }
        for (std::size_t i = 0; i < parts->size(); ++i)
            add_states("subsystem", fmt::format("{}-part-{}", folder_of(property.name), i + 1), (*parts)[i]);
        claim(property, Outcome::Holds, CertificateKind::Subsystems);
        return true;
    }

    void prove_completely(const std::vector<const Verdict*>& reported, TimedOptions options) {
        std::vector<std::vector<std::int64_t>> states;
        std::size_t values = 0;
        options.covering = false;
        options.profile = ProfileFor::None;
        options.many = {};
        options.max_states = std::min(options.max_states, most_states);
        options.each_state = [&](const NetworkState& state) {
            if (values < most_values) states.push_back(certificate::state_values(flat_, state));
            if (!states.empty()) values += states.back().size();
        };
        const TimedResult result = check_timed(flat_, options);
        std::vector<std::pair<const Verdict*, std::string>> runs;
        std::vector<const Verdict*> by_states;
        for (const Verdict* verdict : reported) {
            const auto found = std::ranges::find(result.verdicts, verdict->property, &Verdict::property);
            std::string reason = found == result.verdicts.end() ? "the complete search does not check the property"
                                                                : obstacle(*verdict, *found, result);
            std::optional<std::string> run;
            const bool explores = found != result.verdicts.end() && found->run &&
                                  (found->pattern == Pattern::AlwaysPossible || found->pattern == Pattern::NoTimelock);
            if (reason.empty() &&
                (explores ? values + 16 * states.size() > most_explored : !found->run && values >= most_values))
                reason = "the set of states is too large";
            if (reason.empty() && found->run) {
                const bool shows_race = timed::about_race(flat_, decided_property(flat_, *found));
                if (ends_with_race(*found->run) && !shows_race)
                    reason = "the run that proves the verdict ends with a race";
                else if (!(run = shows_race ? run_before_race(*found->run)
                                            : certificate::run_text(flat_, *found->run, most_bytes)))
                    reason = "the run that proves the verdict is too long";
            }
            if (!reason.empty()) omit(*verdict, std::move(reason));
            else if (run) runs.emplace_back(&*found, std::move(*run));
            else by_states.push_back(&*found);
        }
        if (!by_states.empty()) {
            std::string text = certificate::states_text(std::move(states));
            claims_ += fmt::format("states {}\n", certificate::checksum(text));
            certificate_.files.push_back({path("states.txt"), std::move(text)});
        }
        for (const Verdict* verdict : by_states)
            claim(decided_property(flat_, *verdict), verdict->outcome, CertificateKind::States);
        for (const auto& [verdict, run] : runs)
            claim(decided_property(flat_, *verdict), verdict->outcome, CertificateKind::Run, run);
    }

    std::string written(const std::string& more) {
        std::string network = certificate::network_text(flat_, properties_), omitted;
        for (const CertificateSummary::Omitted& one : omitted_)
            omitted += fmt::format("omitted {} {}\n", certificate::word_of(one.property), one.reason);
        certificate_.summary.omitted.insert(certificate_.summary.omitted.end(), omitted_.begin(), omitted_.end());
        if (claims_.empty() && !folder_.empty()) return omitted;
        std::string index = fmt::format("grafverif-certificate 2\nnetwork {}\n", certificate::checksum(network));
        index += claims_ + omitted + more;
        index += fmt::format("checksum {}\n", certificate::checksum(index));
        certificate_.files.push_back({path("network.txt"), std::move(network)});
        certificate_.files.push_back({path("certificate.txt"), std::move(index)});
        return "also " + folder_ + '\n';
    }

    bool ends_with_race(const Run& run) const {
        const std::optional<std::vector<NetworkState>> states = replay(flat_, run);
        return !states || (flat_.race.valid() &&
                           states->back().variables[flat_.race.index] != flat_.variables[flat_.race].initial);
    }

    /// Returns the reason why the complete search does not certify a verdict, or an empty string.
    std::string obstacle(const Verdict& reported, const Verdict& found, const TimedResult& result) {
        if (found.outcome == Outcome::Unknown)
            return "the complete search does not decide the property: " + found.reason;
        if (found.outcome != reported.outcome) {
            certificate_.failures.push_back(
                fmt::format("the complete search finds that `{}` {}, but the check reports {}", found.property,
                            found.outcome == Outcome::Holds ? "holds" : "is violated", word(reported.outcome)));
            return "the complete search contradicts the verdict";
        }
        if (!found.run && (!result.complete || !result.errors.empty())) return "the set of states is incomplete";
        return {};
    }

    Network flat_;
    const std::string unwritable_;  ///< the reason why the format cannot represent the network; empty if it can
    std::string folder_;
    Certificate& certificate_;
    TimedOptions options_ = {};
    FragmentLimits limits_ = {};
    std::vector<const Verdict*> open_ = {};  ///< verdicts that need a complete search
    std::vector<std::pair<const Verdict*, std::string>> by_runs_ = {};
    std::string claims_ = {};
    std::vector<Property> properties_ = {};
    std::vector<CertificateSummary::Omitted> omitted_ = {};
};

}  // namespace

Certificate certificate_of(const LoopToCheck& loop, const Report& report, const CheckOptions& options) {
    Certificate certificate;
    const std::vector<Id<Property>> by_observers = watched(loop.network);
    std::vector<const Verdict*> others;
    std::vector<std::pair<Id<Property>, const Verdict*>> with_observers;
    for (const PropertyResult& answer : report.answers) {
        const auto found = std::ranges::find_if(
            by_observers, [&](Id<Property> id) { return loop.network.properties[id].name == answer.verdict.property; });
        if (found == by_observers.end()) others.push_back(&answer.verdict);
        else with_observers.emplace_back(*found, &answer.verdict);
    }
    // Complete searches come last, because they may use all of the time.
    TimedOptions search = timed_options(loop, options);
    search.properties = {};
    search.timelock = true;
    FolderWriter complete(expand(by_observers.empty() ? loop.network : observed(loop.network, {})), "", certificate);
    complete.begin(others, search);
    std::deque<FolderWriter> subfolders;
    for (const auto& [id, verdict] : with_observers) {
        search.properties = {verdict->property};
        search.timelock = false;
        subfolders.emplace_back(expand(observed(loop.network, {id})), folder_of(verdict->property), certificate);
        subfolders.back().begin({verdict}, search);
    }
    std::string more;
    for (FolderWriter& subfolder : subfolders) more += subfolder.finish();
    complete.finish(more);
    std::ranges::stable_sort(certificate.summary.certified, {}, [&](const CertificateSummary::Certified& one) {
        return std::ranges::find(report.answers, one.property,
                                 [](const PropertyResult& answer) { return answer.verdict.property; });
    });
    return certificate;
}

}  // namespace grafverif
