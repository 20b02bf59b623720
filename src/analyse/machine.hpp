// SPDX-License-Identifier: MIT
// Machine: the evolutions of equations as Boolean functions. A point is an assignment to the variables that matter:
// those that an evolution keeps (steps, stored variables, remembered values, timer outputs) and the inputs, which it
// reads. A set of points is a Bdd over the bits `before` an evolution; a rest is a set over the kept variables alone.
//
// A machine represents one cone (see cones.hpp); its functions are undefined for elements outside the cone. A counter
// may be represented up to its thresholds only (see counters.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyse/analyse.hpp"
#include "analyse/cones.hpp"
#include "analyse/counters.hpp"
#include "bdd/relation.hpp"
#include "bdd/terms.hpp"

namespace grafverif::analysis {

/// An assignment to the bits of a space.
using Point = std::vector<bool>;

class Machine {
public:
    /// All arguments must outlive the machine.
    Machine(const Equations& equations, const AnalyseOptions& options, const Cone& cone, BddSpace& space);

    // -- extent of the machine --

    bool covers(Id<Equations::Variable> variable) const { return cone_[variable.index]; }
    bool covers(Id<Expr> term) const { return !term.valid() || inside_[term.index]; }
    bool covers_step(std::size_t step) const { return covers(equations_.steps[step].variable); }
    bool covers_firing(std::size_t firing) const { return covers(equations_.firings[firing].condition); }
    /// True if the cone is the complete chart.
    bool whole() const { return whole_; }
    /// In runs with at most this number of evolutions, counters are exact.
    std::int64_t exact_evolutions() const { return exact_evolutions_; }

    // -- sets of points --

    /// Points after the first evolution, with its inputs; without those at which it aborts.
    const Bdd& started() const { return started_; }
    /// The inputs with which the first evolution aborts.
    const Bdd& breaks_at_first() const { return breaks_at_first_; }
    /// The possible inputs.
    const Bdd& possible() const { return possible_; }
    /// Those of `points` whose evolution changes at most levels that timers watch.
    Bdd stable(const Bdd& points) const;
    /// Those whose evolution does not abort: no race, no value that is undefined or out of range.
    Bdd unbroken(const Bdd& points) const;
    /// Those that are sound and not stable.
    Bdd going_on(const Bdd& points) const;
    /// Those at which no counter exceeds its represented values, so that the abstraction is exact there.
    Bdd followed(const Bdd& points) const;
    /// The rests of `points`, which must be stable and sound, at the end of their instant: watched levels have their
    /// final values.
    Bdd settled(const Bdd& points) const { return watches_ ? rest(evolved(points)) : rest(points); }
    bool watches() const { return watches_; }

    /// The successors of `points` by one evolution, with their inputs. Requires that none of them aborts.
    Bdd evolved(const Bdd& points) const;
    /// The rests of these successors: rest(evolved(points)), at lower cost.
    Bdd evolved_rest(const Bdd& points) const;
    /// Those of `points` whose evolution leads to the rest of `next`.
    Bdd origins(const Bdd& points, const Point& next) const;
    /// All points whose evolution leads to one of `points`, with the same inputs; if `points` is a rest, to a point
    /// with it.
    Bdd origins(const Bdd& points) const { return relation_->preimage(points); }
    Bdd with_inputs_of(const Bdd& points, const Point& other) const;
    /// `points` without their inputs.
    Bdd rest(const Bdd& points) const { return exists(points, inputs_); }
    /// The points that a rest can become after some time, with newly sampled inputs.
    Bdd sampled(const Bdd& rest) const;
    /// The rests that can become one of `points` after some time, with newly sampled inputs.
    Bdd before_time(const Bdd& points) const;
    /// The states of `rest` that can become `next` after some time.
    Bdd origins_in_time(const Bdd& rest, const Point& next) const;

    // -- conditions on points, over the variables before their evolution --

    Bdd holds(Id<Expr> term);
    const Bdd& active(std::size_t step) const { return value_of_step_[step]; }
    const Bdd& fires(std::size_t firing) const { return fires_[firing]; }
    struct FaultCondition {
        Id<Equations::Variable> variable = {};  ///< not valid for conditions
        Bdd race = {}, out_of_range = {}, no_value = {};
        Bdd first_race = {}, first_out_of_range = {}, first_no_value = {};  ///< for the first evolution, over inputs
        Bdd beyond = {};        ///< the points at which a counter exceeds its represented values
        std::int64_t safe = 0;  ///< number of evolutions in which it stays in its range nevertheless
    };
    const std::vector<FaultCondition>& all_breaks() const { return all_breaks_; }
    /// Per Equations::conflicts: the points at which it aborts the evolution.
    const std::vector<Bdd>& conflicts() const { return conflicts_; }
    /// `points` with arbitrary timer outputs.
    Bdd without_ends(const Bdd& points) const;
    /// The points at which the evolution changes the variable, including a counter that exceeds its represented values.
    Bdd changes(Id<Equations::Variable> variable) const;
    /// True if the variable is part of points.
    bool matters(Id<Equations::Variable> variable) const { return matters_[variable.index]; }
    /// The points after an evolution at which a term over the variables has a value other than `value`.
    Bdd differs(Id<Expr> term, std::int64_t value);
    Bdd differs_at_first(Id<Expr> term, std::int64_t value);

    // -- single points --

    Point pick(const Bdd& points) const;
    Bdd only(const Point& point) const;
    std::int64_t value(const Point& point, Id<Equations::Variable> variable) const;
    const std::vector<Equations::Timer>& clocks() const { return clocks_; }

private:
    struct KeptBit {
        std::uint32_t before = 0;
        Bdd next = {}, first = {};  ///< the bit after an evolution; after the first one, over inputs
    };
    /// The next value of a kept variable.
    struct Next {
        Id<Equations::Variable> variable = {};
        BddTerm value = {}, first = {};
    };

    void search_inside();
    void choose_counters(const AnalyseOptions& options);
    void add_words(const AnalyseOptions& options);
    void add_word_bits(const std::vector<Id<Equations::Variable>>& together);
    void restrict_inputs(const AnalyseOptions& options);
    void add_firings();
    void add_steps();
    void add_stored();
    void add_unwritten();
    void add_remembered();
    void add_timers();
    void add_break(FaultCondition found);
    FaultCondition break_of(const Equations::Stored& stored, const Bdd& obeyed);
    void add_stability();
    void keep(Next next);
    void relate();
    void start();
    BddTerm word_term(Id<Equations::Variable> variable) const;
    BddTerm before(const Expr& leaf) const;
    BddTerm initially(const Expr& leaf) const;
    Bdd allowed_ends(const Bdd& points) const;

    const Equations& equations_;
    BddSpace& space_;
    Cone cone_;
    bool whole_ = true, watches_ = false;
    std::vector<bool> inside_ = {};  ///< per term: true if it reads only variables of the cone
    std::vector<Equations::Timer> clocks_;
    std::vector<bool> matters_ = {};
    std::vector<std::optional<Counter>> counters_ = {};
    std::int64_t exact_evolutions_ = 0;
    std::vector<BddWord> words_ = {};                         ///< per variable that matters
    std::vector<std::optional<std::size_t>> firing_of_ = {};  ///< per variable: index of the firing condition
    std::vector<Bdd> fires_ = {}, value_of_step_ = {};
    std::vector<Next> nexts_ = {};
    std::vector<KeptBit> kept_ = {};
    std::optional<bdd::Relation> relation_ = {};
    bdd::Relation::Quantified kept_gone_ = {}, all_gone_ = {};  ///< kept variables, or these and the inputs
    std::vector<FaultCondition> all_breaks_ = {};
    std::vector<Bdd> conflicts_ = {};
    std::vector<Bdd> calm_ = {}, sound_ = {};  ///< conjuncts of stability, and of not aborting
    std::vector<std::uint32_t> input_bits_ = {}, kept_bits_ = {};
    Bdd inputs_ = {};  ///< a set of variables
    Bdd possible_ = {}, started_ = {}, breaks_at_first_ = {};
    std::optional<BddTerms> terms_ = {};
    std::optional<BddTerms> first_terms_ = {};  ///< over initial values: for the first evolution
};

}  // namespace grafverif::analysis
