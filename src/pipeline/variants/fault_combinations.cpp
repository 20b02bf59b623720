// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "pipeline/variants/faults.hpp"
#include "support/messages_choice.hpp"
#include "support/messages_fault.hpp"

namespace grafverif {

std::uint64_t combination_count(const ClosedLoop& loop, std::size_t order) {
    std::vector<std::uint64_t> per_instance(loop.instances.size());
    for (const ClosedLoop::Fault& fault : loop.faults) ++per_instance[fault.of.index];
    // Entry k is the number of combinations of k faults of the instances that the loop has visited. A value above the
    // limit is replaced by the limit plus one.
    std::vector<std::uint64_t> counts(std::min<std::size_t>(order, loop.instances.size()) + 1);
    counts[0] = 1;
    for (const std::uint64_t faults : per_instance)
        for (std::size_t k = counts.size(); k-- > 1;)
            counts[k] = std::min(counts[k] + counts[k - 1] * faults, most_combinations + 1);
    std::uint64_t sum = 0;
    for (std::size_t k = 1; k < counts.size(); ++k) sum = std::min(sum + counts[k], most_combinations + 1);
    return sum;
}

bool faults_can_be_combined(const ClosedLoop& loop, std::uint64_t order, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    if (loop.faults.empty()) diagnostics.add(messages::no_faults(loop.origin, loop.name));
    if (order < 1 || order > most_faults)
        diagnostics.add(messages::bad_values({}, fmt::format("`--order {}` is not in 1..{}", order, most_faults),
                                             "use a number in this range"));
    else if (combination_count(loop, order) > most_combinations)
        diagnostics.add(messages::bad_values(loop.origin,
                                             fmt::format("the faults of `{}` have more than {} combinations of at most "
                                                         "{} faults",
                                                         loop.name, most_combinations, order),
                                             "reduce `--order`, or declare fewer faults"));
    return diagnostics.errors() == errors;
}

}  // namespace grafverif
