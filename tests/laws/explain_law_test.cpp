// SPDX-License-Identifier: MIT
// Laws of what is said about counterexamples.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "check/timed/timed.hpp"
#include "explain/settling.hpp"
#include "grafverif/grafverif.hpp"
#include "run/project.hpp"
#include "support/law_size.hpp"
#include "support/random_loop.hpp"

namespace grafverif {
namespace {

/// The network of a random loop; nothing where its charts cannot be derived.
std::optional<Network> network_for(const Model& model, const ModelOptions& how = {}) {
    Diagnostics diagnostics;
    return network_of(model, {0}, how, diagnostics);
}

TimedResult searched(const Network& network) {
    TimedOptions options;
    options.max_states = 20'000;
    return check_timed(network, options);
}

/// The other route: the search of `analyse`, on the equations of the chart alone. It knows nothing of inputs that change in
/// the midst of an instant, hence the atomic grain.
TEST(ExplainLaw, AChartThatIsSaidNeverToSettleIsTotallyUnstableToTheSearchOfAnalyse) {
    int unstable = 0;
    for (int seed = 1; seed <= law_size(120); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        const auto network = network_for(model, {ExecutionMode::StabilitySearch, Grain::Atomic});
        if (!network) continue;
        for (const Verdict& verdict : searched(*network).verdicts) {
            if (verdict.pattern != Pattern::NoTimelock || verdict.outcome != Outcome::Violated) continue;
            const std::string words = unsettled_words(project(*network, verdict.run.value()));
            for (const ClosedLoop::Controller& controller : model.loops[{0}].controllers) {
                if (words.find('`' + controller.name + '`') == std::string::npos) continue;
                Diagnostics diagnostics;
                const auto analysis =
                    analysis_of(model, controller.chart, ExecutionMode::StabilitySearch, {}, diagnostics);
                ASSERT_TRUE(analysis);
                const auto says = [](const auto& each) { return each.code == "total-instability"; };
                EXPECT_TRUE(std::ranges::any_of(analysis->findings, says) || std::ranges::any_of(analysis->open, says))
                    << words;
                ++unstable;
            }
        }
    }
    EXPECT_GT(unstable, 0);
}

}  // namespace
}  // namespace grafverif
