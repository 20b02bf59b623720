// SPDX-License-Identifier: MIT
// Machine: the evolutions of equations as Boolean functions. A point is an assignment to the variables that matter:
// what an evolution keeps (steps, stored variables, what is remembered, the ends of timers) and the inputs, which it
// reads. A set of points is a Bdd over the bits `before` an evolution; a rest is a set over the kept ones alone.
//
// A machine is of one cone (see cones.hpp); what is asked about anything outside of it means nothing. A counter may be kept
// up to its thresholds only (see counters.hpp).
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
    /// Everything outlives the machine.
    Machine(const Equations& equations, const AnalyseOptions& options, const Cone& cone, BddSpace& space);

    // -- what it knows of --

    bool covers(Id<Equations::Variable> variable) const { return cone_[variable.index]; }
    bool covers(Id<Expr> term) const { return !term.valid() || inside_[term.index]; }
    bool covers_step(std::size_t step) const { return covers(equations_.steps[step].variable); }
    bool covers_firing(std::size_t firing) const { return covers(equations_.firings[firing].condition); }
    /// Whether it is all of the chart.
    bool whole() const { return whole_; }
    /// Runs of at most so many evolutions count as the chart does.
    std::int64_t exact_evolutions() const { return exact_evolutions_; }

    // -- sets of points --

    /// Points after the first evolution, its inputs kept; without those where it breaks off.
    const Bdd& started() const { return started_; }
    /// The inputs with which the first evolution breaks off.
    const Bdd& breaks_at_first() const { return breaks_at_first_; }
    /// The inputs that are possible.
    const Bdd& possible() const { return possible_; }
    /// Those of `points` whose evolution changes nothing but levels that timers watch.
    Bdd stable(const Bdd& points) const;
    /// Those whose evolution does not break off: no race, no value that does not exist or fit.
    Bdd unbroken(const Bdd& points) const;
    /// The sound ones that are not stable.
    Bdd going_on(const Bdd& points) const;
    /// Those at which no counter goes on above what is kept of it: nothing is lost there.
    Bdd followed(const Bdd& points) const;
    /// What `points`, stable and sound, keep when their instant ends: watched levels are those of its end.
    Bdd settled(const Bdd& points) const { return watches_ ? rest(evolved(points)) : rest(points); }
    bool watches() const { return watches_; }

    /// Where the evolutions of `points` lead, inputs kept. None of them breaks off.
    Bdd evolved(const Bdd& points) const;
    /// What they keep there: rest(evolved(points)), at less cost.
    Bdd evolved_rest(const Bdd& points) const;
    /// The points of `points` whose evolution leads to what `next` keeps.
    Bdd origins(const Bdd& points, const Point& next) const;
    /// All points whose evolution leads to one of `points`, inputs kept; where `points` is a rest, to what it keeps.
    Bdd origins(const Bdd& points) const { return relation_->preimage(points); }
    Bdd with_inputs_of(const Bdd& points, const Point& other) const;
    /// `points` without their inputs.
    Bdd rest(const Bdd& points) const { return exists(points, inputs_); }
    /// What a rest can be after some time, inputs sampled anew.
    Bdd sampled(const Bdd& rest) const;
    /// The rests that can be one of `points` after some time, inputs sampled anew.
    Bdd before_time(const Bdd& points) const;
    /// The states of `rest` that can be `next` after some time.
    Bdd origins_in_time(const Bdd& rest, const Point& next) const;

    // -- conditions on points, over the variables before their evolution --

    Bdd holds(Id<Expr> term);
    const Bdd& active(std::size_t step) const { return value_of_step_[step]; }
    const Bdd& fires(std::size_t firing) const { return fires_[firing]; }
    struct Break {
        Id<Equations::Variable> variable = {};  ///< not valid: of conditions
        Bdd race = {}, out_of_range = {}, no_value = {};
        Bdd first_race = {}, first_out_of_range = {}, first_no_value = {};  ///< in the first evolution, over inputs
        Bdd beyond = {};        ///< where a counter goes on above what is kept apart
        std::int64_t safe = 0;  ///< in so many evolutions it stays in its range all the same
    };
    const std::vector<Break>& all_breaks() const { return all_breaks_; }
    /// Per Equations::conflicts: where it breaks the evolution off.
    const std::vector<Bdd>& conflicts() const { return conflicts_; }
    /// `points`, whatever the ends of timers are.
    Bdd without_ends(const Bdd& points) const;
    /// Where the evolution gives the variable another value, one above what is kept of a counter included.
    Bdd changes(Id<Equations::Variable> variable) const;
    /// Whether the variable is part of points.
    bool matters(Id<Equations::Variable> variable) const { return matters_[variable.index]; }
    /// Where a term over the variables after an evolution has another value than `value`; in a set of points after it.
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
    /// What a kept variable becomes.
    struct Next {
        Id<Equations::Variable> variable = {};
        BddTerm value = {}, first = {};
    };

    void look_inside();
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
    void add_break(Break found);
    Break break_of(const Equations::Stored& stored, const Bdd& obeyed);
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
    std::vector<bool> inside_ = {};  ///< per term: whether it reads the cone alone
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
    bdd::Relation::Quantified kept_gone_ = {},
                              all_gone_ = {};  ///< what evolutions leave behind: what was kept, or that and the inputs
    std::vector<Break> all_breaks_ = {};
    std::vector<Bdd> conflicts_ = {};
    std::vector<Bdd> calm_ = {}, sound_ = {};  ///< conjuncts of what is stable, and of what does not break off
    std::vector<std::uint32_t> input_bits_ = {}, kept_bits_ = {};
    Bdd inputs_ = {};  ///< a set of variables
    Bdd possible_ = {}, started_ = {}, breaks_at_first_ = {};
    std::optional<BddTerms> terms_ = {};
    std::optional<BddTerms> first_terms_ = {};  ///< over initial values: of the first evolution
};

}  // namespace grafverif::analysis
