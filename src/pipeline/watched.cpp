// SPDX-License-Identifier: MIT
#include "pipeline/watched.hpp"

#include <map>
#include <ostream>

#include "syntax/print/chart.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// Returns, for each variable whose name in the network differs from its name in the charts, the name in the charts.
std::map<Id<Network::Variable>, std::string> reported_variables(const Network& network) {
    std::map<Id<Network::Variable>, std::string> names;
    for (const Network::Controller& controller : network.controllers) {
        const std::string owner = prefix_of(network, controller);
        for (const auto& step : controller.words.steps) names[step.variable] = owner + step.name.variable();
        for (const auto& internal : controller.words.internals) names[internal.variable] = owner + internal.name;
        for (std::size_t k = 0; k < controller.timers.size(); ++k)
            if (const std::string timer = time_text(network, controller, k); !timer.empty())
                names[controller.words.timers[k].end] = timer;
    }
    return names;
}

std::string term_text(const Network& network, Id<Expr> term) {
    const auto names = reported_variables(network);
    return expr_text(network.exprs, term, chart_spelling, [&](std::ostream& out, const Expr& leaf) {
        if (leaf.op == Op::Variable) {
            const Id<Network::Variable> variable{static_cast<std::uint32_t>(leaf.value)};
            const auto known = names.find(variable);
            out << (known == names.end() ? network.variables[variable].name : known->second);
            return;
        }
        const Network::Process& process = network.processes[{at_process(leaf)}];
        out << process.name << '.' << network.templates[process.automaton].locations[{at_location(leaf)}].name;
    });
}

}  // namespace

std::vector<std::string> operand_texts(const Network& network, const Property& property) {
    std::vector<std::string> texts;
    for (const Id<Expr> operand : property.operands) texts.push_back(term_text(network, operand));
    return texts;
}

}  // namespace grafverif
