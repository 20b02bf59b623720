// SPDX-License-Identifier: MIT
#include "pipeline/certificate/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "check/timed/property_queries.hpp"
#include "check/timed/timed.hpp"
#include "compose/observe.hpp"
#include "emit/certificate/certificate.hpp"
#include "ir/probes.hpp"
#include "ir/step_names.hpp"
#include "pipeline/staged_search.hpp"

namespace grafverif {

namespace {

/// Maximum number of states of a certificate, and maximum size of their text, which is built in memory.
constexpr std::uint64_t most_states = 10'000'000;
constexpr std::size_t most_bytes = std::size_t{1} << 30U;

/// Returns the property that `verdict` decides. For a step of `reachable all steps`, this is a `reachable`.
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

/// Creates the certificate of one network in one folder.
class FolderWriter {
public:
    FolderWriter(Network flat, std::string folder, Certificate& certificate)
        : flat_(std::move(flat)), folder_(std::move(folder)), certificate_(certificate) {}

    /// Adds the claims about `reported`, and the lines `more` to the index. A subfolder without claims is not written.
    /// Returns the lines for the index of the folder that contains this folder.
    std::string write(const std::vector<const Verdict*>& reported, TimedOptions options, const std::string& more = {}) {
        std::string states;
        options.covering = false;
        options.profile = ProfileFor::None;
        options.many = {};
        options.max_states = std::min(options.max_states, most_states);
        options.each_state = [&](const NetworkState& state) {
            if (states.size() < most_bytes) certificate::write_state(flat_, state, states);
        };
        const TimedResult result = check_timed(flat_, options);
        std::vector<Property> properties;
        bool needs_states = false;
        for (const Verdict* verdict : reported) {
            const auto found = std::ranges::find(result.verdicts, verdict->property, &Verdict::property);
            std::string reason = found == result.verdicts.end() ? "the complete search does not check the property"
                                                                : obstacle(*verdict, *found, result);
            if (reason.empty() && !found->run && states.size() >= most_bytes)
                reason = "the text of the states is larger than 1 GiB";
            if (!reason.empty()) {
                omitted_.push_back({verdict->property, std::move(reason)});
                continue;
            }
            properties.push_back(decided_property(flat_, *found));
            claims_ += fmt::format("{} {}\n", word(found->outcome), certificate::word_of(found->property));
            if (found->run) claims_ += certificate::run_text(flat_, *found->run);
            else needs_states = true;
            certificate_.summary.certified.push_back(
                {found->property, found->run ? CertificateKind::Run : CertificateKind::States});
        }
        std::string network = certificate::network_text(flat_, properties);
        std::string index = fmt::format("grafverif-certificate 1\nnetwork {}\n", certificate::checksum(network));
        if (needs_states) index += fmt::format("states {}\n", certificate::checksum(states));
        std::string omitted;
        for (const CertificateSummary::Omitted& one : omitted_)
            omitted += fmt::format("omitted {} {}\n", certificate::word_of(one.property), one.reason);
        index += claims_ + omitted + more;
        index += fmt::format("checksum {}\n", certificate::checksum(index));
        certificate_.summary.omitted.insert(certificate_.summary.omitted.end(), omitted_.begin(), omitted_.end());
        if (claims_.empty() && !folder_.empty()) return omitted;
        certificate_.files.push_back({path("network.txt"), std::move(network)});
        if (needs_states) certificate_.files.push_back({path("states.txt"), std::move(states)});
        certificate_.files.push_back({path("certificate.txt"), std::move(index)});
        return "also " + folder_ + '\n';
    }

private:
    std::string path(const std::string& file) const { return folder_.empty() ? file : folder_ + '/' + file; }

    /// Returns the reason why the verdict has no certificate, or an empty string.
    std::string obstacle(const Verdict& reported, const Verdict& found, const TimedResult& result) {
        if (reported.outcome == Outcome::Unknown) return "the verdict is unknown";
        const SearchScope& scope = reported.scope;
        if (reported.pattern == Pattern::NoDeadlock && !(scope.searched.empty() && scope.left_out.empty()))
            return "the verdict applies to each subsystem; pass `--monolithic` to certify it for the complete loop";
        if (certificate::is_too_deep(flat_)) return "a term of the model is too deep";
        if (found.outcome == Outcome::Unknown) return "the complete search does not decide it: " + found.reason;
        if (found.outcome != reported.outcome) {
            certificate_.failures.push_back(
                fmt::format("the complete search finds that `{}` {}, but the check reports {}", found.property,
                            found.outcome == Outcome::Holds ? "holds" : "is violated", word(reported.outcome)));
            return "the complete search contradicts the verdict";
        }
        if (found.run && certificate::units_of(*found.run) > certificate::longest_run) return "its run is too long";
        if (!found.run && (!result.complete || !result.errors.empty())) return "the set of states is incomplete";
        return {};
    }

    Network flat_;
    std::string folder_;
    Certificate& certificate_;
    std::string claims_ = {};
    std::vector<CertificateSummary::Omitted> omitted_ = {};
};

}  // namespace

Certificate certificate_of(const LoopToCheck& loop, const Report& report, const CheckOptions& options) {
    Certificate certificate;
    std::string more;
    const std::vector<Id<Property>> by_observers = watched(loop.network);
    std::vector<const Verdict*> others;
    TimedOptions search = timed_options(loop, options);
    for (const PropertyResult& answer : report.answers) {
        const Verdict& verdict = answer.verdict;
        const auto observed_one = std::ranges::find_if(
            by_observers, [&](Id<Property> id) { return loop.network.properties[id].name == verdict.property; });
        if (observed_one == by_observers.end()) {
            others.push_back(&verdict);
            continue;
        }
        search.properties = {verdict.property};
        search.timelock = false;
        more += FolderWriter(expand(observed(loop.network, {*observed_one})), certificate::word_of(verdict.property),
                             certificate)
                    .write({&verdict}, search);
    }
    search.properties = {};
    search.timelock = true;
    FolderWriter(expand(by_observers.empty() ? loop.network : observed(loop.network, {})), "", certificate)
        .write(others, search, more);
    return certificate;
}

}  // namespace grafverif
