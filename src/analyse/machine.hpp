// SPDX-License-Identifier: MIT
// Machine: the evolutions of equations as Boolean functions. A point is an assignment to the variables that matter:
// what an evolution keeps (steps, stored variables, what is remembered, the ends of timers) and the inputs, which it
// reads. A set of points is a Bdd over the bits `before` an evolution; a rest is a set over the kept ones alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyse/memory.hpp"
#include "grafverif/analyse/analyse.hpp"
#include "grafverif/bdd/terms.hpp"

namespace grafverif::analysis {

/// An assignment to the bits of a space.
using Point = std::vector<bool>;

class Machine {
public:
    /// Everything outlives the machine.
    Machine(const Equations& equations, const AnalyseOptions& options, BddSpace& space);

    // -- sets of points --

    /// Points after the first evolution, its inputs kept; without those where it breaks off.
    const Bdd& started() const { return started_; }
    /// The inputs with which the first evolution breaks off.
    const Bdd& breaks_at_first() const { return breaks_at_first_; }
    /// The inputs that are possible.
    const Bdd& possible() const { return possible_; }
    /// Points whose evolution changes nothing.
    const Bdd& stable() const { return stable_; }
    /// Points whose evolution breaks off: a race, a value that does not exist or fit.
    const Bdd& breaks() const { return breaks_; }

    /// Where the evolutions of `points` lead, inputs kept. None of them breaks off.
    Bdd evolved(const Bdd& points) const;
    /// The points of `points` whose evolution leads to what `next` keeps.
    Bdd origins(const Bdd& points, const Point& next) const;
    Bdd with_inputs_of(const Bdd& points, const Point& other) const;
    /// `points` without their inputs.
    Bdd rest(const Bdd& points) const { return exists(points, inputs_); }
    /// What a rest can be after some time, inputs sampled anew.
    Bdd sampled(const Bdd& rest) const;
    /// The states of `rest` that can be `next` after some time.
    Bdd origins_in_time(const Bdd& rest, const Point& next) const;

    // -- conditions on points, over the variables before their evolution --

    Bdd holds(Id<Expr> term);
    Bdd active(std::size_t step) const { return value_of_step_[step]; }
    Bdd fires(std::size_t firing) const { return fires_[firing]; }
    Bdd fires(Id<Equations::Variable> firing) const;
    struct Break {
        Id<Equations::Variable> variable = {};   ///< not valid: of conditions
        Bdd race = {}, out_of_range = {}, no_value = {};
        Bdd first_race = {}, first_out_of_range = {}, first_no_value = {};   ///< in the first evolution, over inputs
    };
    const std::vector<Break>& all_breaks() const { return all_breaks_; }
    /// Per Equations::conflicts: where it breaks the evolution off.
    const std::vector<Bdd>& conflicts() const { return conflicts_; }
    /// `points`, whatever the ends of timers are.
    Bdd without_ends(const Bdd& points) const;
    /// Whether the variable is part of points.
    bool matters(Id<Equations::Variable> variable) const { return matters_[variable.index]; }
    /// Where a term over the variables after an evolution has another value than `value`; in a set of points after it.
    Bdd differs(Id<Expr> term, std::int64_t value);
    Bdd differs_at_first(Id<Expr> term, std::int64_t value);

    // -- single points --

    Point pick(const Bdd& points) const;
    Bdd only(const Point& point) const;
    std::int64_t value(const Point& point, Id<Equations::Variable> variable) const;
    const std::vector<Clock>& clocks() const { return clocks_; }

private:
    struct Part {
        Bdd relation = {};
        Bdd ended = {};   ///< kept variables that no later part reads
    };
    struct KeptBit {
        std::uint32_t before = 0;
        Bdd next = {}, first = {};   ///< the bit after an evolution; after the first one, over inputs
    };
    /// What a kept variable becomes.
    struct Next {
        Id<Equations::Variable> variable = {};
        BddTerm value = {}, first = {};
    };

    void add_words(const AnalyseOptions& options);
    void restrict_inputs(const AnalyseOptions& options);
    void add_firings();
    void add_steps();
    void add_stored();
    void add_remembered();
    void add_timers();
    void add_break(Break found);
    void keep(Next next);
    void add_parts();
    void start();
    BddTerm word_term(Id<Equations::Variable> variable) const;
    BddTerm before(const Expr& leaf) const;
    BddTerm initially(const Expr& leaf) const;
    Bdd allowed_ends(const Bdd& points) const;

    const Equations& equations_;
    BddSpace& space_;
    std::vector<Clock> clocks_;
    std::vector<bool> matters_ = {};
    std::vector<BddWord> words_ = {};                       ///< per variable that matters
    std::vector<std::optional<std::size_t>> firing_of_ = {};   ///< per variable: index of the firing condition
    std::vector<Bdd> fires_ = {}, value_of_step_ = {};
    std::vector<Next> nexts_ = {};
    std::vector<KeptBit> kept_ = {};
    std::vector<Part> parts_ = {};
    std::vector<Break> all_breaks_ = {};
    std::vector<Bdd> conflicts_ = {};
    Bdd inputs_ = {}, kept_set_ = {}, unread_ = {};         ///< sets of variables; unread: kept ones that no part reads
    Bdd possible_ = {}, stable_ = {}, breaks_ = {}, started_ = {}, breaks_at_first_ = {};
    std::optional<BddTerms> terms_ = {};
    std::optional<BddTerms> first_terms_ = {};   ///< over initial values: of the first evolution
    std::optional<BddRenaming> to_before_ = {};
};

}  // namespace grafverif::analysis
