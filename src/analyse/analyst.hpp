// SPDX-License-Identifier: MIT
// Analyst: asks the questions of an analysis, one function per code. What can happen is found in whatever part of the
// points was reached; what never happens is told only if all were.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analyse/evidence.hpp"
#include "analyse/machine.hpp"
#include "analyse/search.hpp"

namespace grafverif::analysis {

class Analyst {
public:
    Analyst(const Chart& chart, const Equations& equations, const AnalyseOptions& options, Machine& machine,
            const Search& search, bool complete, Analysis& result)
        : chart_(chart), equations_(equations), options_(options), machine_(machine), search_(search),
          complete_(complete), result_(result) {}

    void ask();

private:
    using Step = Id<Chart::Step>;
    using Transition = Id<Chart::Transition>;

    // What can happen (analyst.cpp).
    void instability();
    void broken_off();
    void broken_off(const Machine::Break& each);
    void lost_values();
    void lost_value(const Equations::Stored& stored, bool value);
    void branches_together();
    void reactivated_steps();
    void forcing();
    // What never happens (analyst_never.cpp).
    void dead_steps();
    void dead_transitions();
    void immediate_transitions();
    void transient_steps();
    void silent_outputs();

    bool searching() const { return options_.mode == ExecutionMode::StabilitySearch; }
    bool seen(const Bdd& points) const { return !(search_.reached() & points).is_false(); }
    bool ever_active(Step step) const;
    Bdd enabled(Transition transition) const;
    Bdd all_active(const std::vector<Step>& steps) const;
    std::string step_name(Step step) const { return step_variable(chart_, step); }
    std::string steps_text(const std::vector<Step>& steps) const;
    const std::string& name(Transition transition) const { return chart_.transitions[transition].name; }

    Finding finding(std::string_view code, std::string subject, std::string message, Span origin) const;
    /// Shows the finding by a shortest way to `goal`, and keeps it; what the rules do not confirm is a failure.
    Evidence& show(Finding& finding, const Bdd& goal, const Demand& demand, std::string shows);
    Evidence& show(Finding& finding, const std::optional<Way>& way, const Demand& demand, std::string shows);
    void keep(Finding finding) { result_.findings.push_back(std::move(finding)); }

    /// The way to the first of `points`, and on along them.
    std::optional<Way> way_along(const std::vector<Point>& points) const;

    const Chart& chart_;
    const Equations& equations_;
    const AnalyseOptions& options_;
    Machine& machine_;
    const Search& search_;
    bool complete_;
    Analysis& result_;
    Evidence last_ = {};   ///< what the last finding was shown by
};

}  // namespace grafverif::analysis
