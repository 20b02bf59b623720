// SPDX-License-Identifier: MIT
// Machine: the evolutions of equations as Boolean functions. A point is an assignment to the relevant variables: the
// kept variables, which are stored between evolutions (steps, stored variables, remembered values, timer outputs), and
// the inputs. A set of points is a Bdd over the bits `before` an evolution. A *rest* is a set of assignments to the
// kept variables only, without inputs.
//
// A machine represents one cone of influence (see cones.hpp). The functions of the machine must not be called for
// variables outside of the cone. A counter may be represented only up to its thresholds (see counters.hpp).
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

/// An assignment to all bits of the BddSpace of a machine.
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
    /// True if the cone contains the complete chart.
    bool whole() const { return whole_; }
    /// Returns the maximum number of evolutions of a run for which counters are exact.
    std::int64_t exact_evolutions() const { return exact_evolutions_; }

    // -- sets of points --

    /// Returns the points after a first evolution that does not abort. The points contain the
    /// inputs of the first evolution.
    const Bdd& started() const { return started_; }
    /// Returns the inputs with which the first evolution aborts.
    const Bdd& breaks_at_first() const { return breaks_at_first_; }
    /// Returns the possible inputs: the inputs that satisfy the ranges and constraints.
    const Bdd& possible() const { return possible_; }
    /// Returns the points in `points` that are stable: their evolution changes nothing except levels that timers watch.
    Bdd stable(const Bdd& points) const;
    /// Returns the points in `points` whose evolution does not abort: it has no race, and no value that is undefined or
    /// out of range.
    Bdd unbroken(const Bdd& points) const;
    /// Returns the points in `points` that are not stable and whose evolution does not abort.
    Bdd transient(const Bdd& points) const;
    /// Returns the points in `points` at which no counter exceeds its represented values, so that the abstraction of
    /// counters is exact.
    Bdd followed(const Bdd& points) const;
    /// Returns the rest (set of kept values) of `points` at the end of their instant, with the final values of
    /// watched levels and previous values. Requires that the points are stable and that their evolutions do not abort.
    Bdd settled(const Bdd& points) const { return remembers_ ? rest(evolved(points)) : rest(points); }
    /// True if a stable evolution may change a kept value: a watched level or a previous value.
    bool remembers() const { return remembers_; }

    /// Returns the successors of `points` after one evolution, with unchanged inputs. Requires that no evolution from
    /// `points` aborts.
    Bdd evolved(const Bdd& points) const;
    /// Returns rest(evolved(points)) at lower cost.
    Bdd evolved_rest(const Bdd& points) const;
    /// Returns the points in `points` whose evolution leads to the kept values of `next`.
    Bdd origins(const Bdd& points, const Point& next) const;
    /// Returns all points whose evolution leads to a point of `points` with the same inputs. `points` may also be a
    /// rest; then the inputs after the evolution are arbitrary.
    Bdd origins(const Bdd& points) const { return relation_->preimage(points); }
    Bdd with_inputs_of(const Bdd& points, const Point& other) const;
    /// Returns `points` without their inputs.
    Bdd rest(const Bdd& points) const { return exists(points, inputs_); }
    /// Returns the points that can follow the assignments of `rest` after some time, with newly sampled inputs.
    Bdd sampled(const Bdd& rest) const;
    /// Returns the assignments to kept variables from which one of `points` is reached after some
    /// time, with newly sampled inputs.
    Bdd before_time(const Bdd& points) const;
    /// Returns the assignments of `rest` from which the point `next` is reached after some time.
    Bdd origins_in_time(const Bdd& rest, const Point& next) const;

    // -- conditions on points, over the variables before their evolution --

    Bdd holds(Id<Expr> term);
    const Bdd& active(std::size_t step) const { return value_of_step_[step]; }
    const Bdd& fires(std::size_t firing) const { return fires_[firing]; }
    struct FaultCondition {
        /// Variable whose new value has the fault; invalid for faults in conditions.
        Id<Equations::Variable> variable = {};
        Bdd race = {}, out_of_range = {}, no_value = {};
        /// Faults in the first evolution, as sets of inputs.
        Bdd first_race = {}, first_out_of_range = {}, first_no_value = {};
        Bdd beyond = {};        ///< points at which the counter exceeds its represented values
        std::int64_t safe = 0;  ///< number of evolutions in which the counter remains in its range
    };
    const std::vector<FaultCondition>& all_breaks() const { return all_breaks_; }
    /// Returns, for each element of Equations::conflicts, the points at which this conflict of forcing orders aborts
    /// the evolution.
    const std::vector<Bdd>& conflicts() const { return conflicts_; }
    /// Returns the set of points that differ from a point in `points` at most in timer outputs.
    Bdd without_ends(const Bdd& points) const;
    /// Returns the points from which an evolution changes the variable. A counter that exceeds its represented values
    /// is assumed to change.
    Bdd changes(Id<Equations::Variable> variable) const;
    /// True if the points of this machine assign a value to the variable.
    bool matters(Id<Equations::Variable> variable) const { return matters_[variable.index]; }
    /// Returns the points after an evolution at which a term over the variables has a value other than `value`.
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
        /// The value of the bit after an evolution (`next`), and its value after the first evolution as a function of
        /// the inputs (`first`).
        Bdd next = {}, first = {};
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
    bool whole_ = true, remembers_ = false;
    std::vector<bool> inside_ = {};  ///< for each term: true if it reads only variables of the cone
    std::vector<Equations::Timer> clocks_;
    std::vector<bool> matters_ = {};
    std::vector<std::optional<Counter>> counters_ = {};
    std::int64_t exact_evolutions_ = 0;
    std::vector<BddWord> words_ = {};                         ///< bits of each variable that points contain
    std::vector<std::optional<std::size_t>> firing_of_ = {};  ///< index of the firing condition of each variable
    std::vector<Bdd> fires_ = {}, value_of_step_ = {};
    std::vector<Next> nexts_ = {};
    std::vector<KeptBit> kept_ = {};
    std::optional<bdd::Relation> relation_ = {};
    /// The variables to quantify: only the kept variables (`kept_quantified_`), or the kept variables and the inputs
    /// (`all_quantified_`).
    bdd::Relation::Quantified kept_quantified_ = {}, all_quantified_ = {};
    std::vector<FaultCondition> all_breaks_ = {};
    std::vector<Bdd> conflicts_ = {};
    /// `calm_`: the conjuncts of the stability condition. `sound_`: the conjuncts of the condition that an evolution
    /// does not abort.
    std::vector<Bdd> calm_ = {}, sound_ = {};
    std::vector<std::uint32_t> input_bits_ = {}, kept_bits_ = {};
    Bdd inputs_ = {};  ///< set of the input variables, for quantification
    Bdd possible_ = {}, started_ = {}, breaks_at_first_ = {};
    std::optional<BddTerms> terms_ = {};
    std::optional<BddTerms> first_terms_ = {};  ///< terms over initial values, for the first evolution
};

}  // namespace grafverif::analysis
