// SPDX-License-Identifier: MIT
#include "syntax/print/chart.hpp"

#include <ostream>

namespace grafverif {

namespace {

std::string time_condition_text(const Chart& chart, const Chart::TimeCondition& time) {
    return time_text(chart, time, [&chart](Id<Expr> term) { return term_text(chart, term); });
}

}  // namespace

LeafPrinter leaf_printer(const Chart& chart) {
    return [&chart](std::ostream& out, const Expr& leaf) {
        const auto index = static_cast<std::uint32_t>(leaf.value);
        if (leaf.op == Op::Variable) out << chart.variables[{index}].name;
        else if (leaf.op == Op::Step) out << step_variable(chart, {index});
        else if (leaf.op == Op::Timed) out << time_condition_text(chart, chart.time_conditions[{index}]);
    };
}

std::string term_text(const Chart& chart, Id<Expr> term) {
    return expr_text(chart.exprs, term, chart_spelling, leaf_printer(chart));
}

std::string time_text(const Chart& chart, const Chart::TimeCondition& time,
                      const std::function<std::string(Id<Expr>)>& text) {
    const Op op = chart.exprs[time.watched].op;
    const bool single = op == Op::Variable || op == Op::Step;
    return time_text(time.rise_ms, single ? text(time.watched) : '(' + text(time.watched) + ')', time.fall_ms);
}

std::string time_text(std::int64_t rise_ms, const std::string& watched, std::int64_t fall_ms) {
    return (rise_ms > 0 ? duration_text(rise_ms) + '/' : "") + watched +
           (fall_ms > 0 ? '/' + duration_text(fall_ms) : "");
}

std::string time_text(const Chart& chart, const ClosedLoop::TimeSymbol& symbol) {
    if (symbol.condition.valid()) return time_condition_text(chart, chart.time_conditions[symbol.condition]);
    return time_text(symbol.rise_ms, step_variable(chart, symbol.step), 0);
}

std::string prefix_of(const Network& network, const Network::Controller& controller) {
    return network.controllers.size() > 1 ? controller.words.name + '.' : "";
}

std::string time_text(const Network& network, const Network::Controller& controller, std::size_t timer) {
    if (timer >= controller.words.timers.size()) return "";  // a subnetwork lacks the names of timers
    const auto& times = controller.words.timers[timer];
    if (times.watched.empty()) return "";
    return time_text(times.rise_ms, prefix_of(network, controller) + times.watched, times.fall_ms);
}

std::vector<std::string> display_names(const Network& network) {
    std::vector<std::string> names;
    for (const Network::Process& process : network.processes) names.push_back(process.name);
    for (const Network::Controller& controller : network.controllers)
        for (std::size_t k = 0; k < controller.timers.size(); ++k) {
            const Id<Network::Process> process = controller.timers[k].process;
            const std::string timer_text = time_text(network, controller, k);
            if (process.valid() && !timer_text.empty()) names[process.index] = timer_text;
        }
    return names;
}

}  // namespace grafverif
