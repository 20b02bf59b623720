// SPDX-License-Identifier: MIT
// Builds the observer automata. Each automaton implements the formula that the table in docs/reference/properties.md
// defines for its pattern. A randomized test compares the automata with the formulas.
#include "compose/observer.hpp"

#include <fmt/format.h>

#include <utility>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

using Location = Id<Network::Location>;

class Observer {
public:
    Observer(Exprs& exprs, const ObserverTerms& terms, std::int64_t duration)
        : exprs_(exprs), terms_(terms), duration_(duration) {}

    ObserverMade made = {};

    /// `p` returns an operand of the property; `no` returns the negation of a term.
    Id<Expr> p(std::size_t number = 0) const { return terms_.operands[number]; }
    Id<Expr> no(Id<Expr> term) { return exprs_.negation(term); }
    Id<Expr> both(Id<Expr> left, Id<Expr> right) { return exprs_.conjunction(left, right); }
    Id<Expr> either(Id<Expr> left, Id<Expr> right) { return exprs_.disjunction(left, right); }
    Id<Expr> always() { return exprs_.constant(true); }

    Location location(std::string name) {
        rest_.push_back(exprs_.constant(true));
        return made.automaton.locations.add({std::move(name), {}, {}});
    }
    Location failed() {
        const Location location = this->location("failed");
        made.pending.push_back(location);
        return location;
    }
    Id<Network::Clock> clock() {
        clock_ = made.automaton.clocks.add({"t"});
        return clock_;
    }

    /// Adds an edge to `to` that is taken when the observer reads a state in which `when` is true. Earlier edges from
    /// `from` have priority if their conditions are also true in this state.
    void sees(Location from, Id<Expr> when, Location to, bool resets = false) {
        const Id<Expr> rest = rest_[from.index];
        rest_[from.index] = both(rest, no(when));
        look(from, to, both(terms_.considered, both(rest, when)), resets);
    }
    /// Adds an edge to `to` that can be taken at any time in a state in which `when` is true, if the clock constraint
    /// holds.
    void times(Location from, Id<Expr> when, Op relation, Location to) {
        made.automaton.edges.add({.from = from,
                                  .to = to,
                                  .guard = both(terms_.considered, when),
                                  .constraint = {{clock_, relation, exprs_.integer(duration_)}}});
    }
    /// Adds an edge to `to` that can be taken when the clock exceeds the duration, in every state of the network. The
    /// guard does not test the current state, because only states that the observer has already read are relevant.
    void expires(Location from, Location to) {
        made.automaton.edges.add({.from = from,
                                  .to = to,
                                  .guard = always(),
                                  .constraint = {{clock_, Op::Greater, exprs_.integer(duration_)}}});
    }

    /// Completes the automaton: for all other cases, adds edges that read the state and do not change the location.
    ObserverMade whole(Location initial) {
        for (const Location at : made.automaton.locations.ids())
            look(at, at, either(no(terms_.considered), rest_[at.index]), false);
        made.automaton.initial = initial;
        return std::move(made);
    }

private:
    void look(Location from, Location to, Id<Expr> when, bool resets) {
        Network::Edge edge{.from = from, .to = to, .urgent = true, .guard = both(terms_.active, when)};
        edge.assignments.push_back({terms_.look, terms_.next});
        if (resets) edge.resets.push_back(clock_);
        made.automaton.edges.add(std::move(edge));
    }

    Exprs& exprs_;
    const ObserverTerms& terms_;
    std::int64_t duration_;
    Id<Network::Clock> clock_ = {};
    /// For each location: condition under which none of its edges that have already been added can be taken.
    std::vector<Id<Expr>> rest_ = {};
};

// -- durations --------------------------------------------------------------------------------------------------------

/// Locations and terms of a scope, for observers of durations and counts. If a violation counts only in a scope that
/// closes, the location `spoilt` represents a violation in a scope that is still open.
struct Scoped {
    Location out = {};     ///< location outside the scope; for `before`: after the scope
    Location failed = {};  ///< location reached by a violation inside the scope
    Id<Expr> opens = {}, closes = {};
};

Scoped scoped(Observer& of, Sentence::Scope scope, std::size_t operands) {
    Scoped made{of.location("outside"), of.failed(), of.p(operands), of.p(operands)};
    const bool pair = scope == Sentence::Scope::Between || scope == Sentence::Scope::AfterUntil;
    if (pair) made.closes = of.p(operands + 1), made.opens = of.both(made.opens, of.no(made.closes));
    if (scope != Sentence::Scope::Before && scope != Sentence::Scope::Between) return made;
    const Location spoilt = of.location("spoilt");
    of.sees(spoilt, made.closes, made.failed);
    made.failed = spoilt;
    return made;
}

/// Builds the observer of `p leads to q within d`, that is, of AG (p -> AF<=d q).
ObserverMade within(Observer of, Sentence::Scope scope) {
    const Id<Expr> q = of.p(1), demand = of.both(of.p(0), of.no(q));
    const Location idle = of.location("idle"), due = of.location("due");
    of.clock();
    if (scope == Sentence::Scope::Globally) {
        const Location failed = of.failed();
        of.sees(idle, demand, due, true);
        of.sees(due, q, idle);
        of.expires(due, failed);
        return of.whole(idle);
    }
    const Scoped in = scoped(of, scope, 2);
    if (scope != Sentence::Scope::Before) {
        of.sees(in.out, of.both(in.opens, demand), due, true);
        of.sees(in.out, in.opens, idle);
    }
    if (scope != Sentence::Scope::After) {
        of.sees(idle, in.closes, in.out);
        of.sees(due, in.closes, of.made.pending.front());
    }
    of.sees(idle, demand, due, true);
    of.sees(due, q, idle);
    of.expires(due, in.failed);
    return of.whole(scope == Sentence::Scope::Before ? idle : in.out);
}

/// Builds the observer of `p at least every d`: a state with p follows within d after power-on, after the scope opens,
/// and after each state with p.
ObserverMade recurs(Observer of, Id<Expr> p, Sentence::Scope scope) {
    const Location due = of.location("due"), there = of.location("there");
    of.clock();
    if (scope == Sentence::Scope::Globally) {
        const Location failed = of.failed();
        of.sees(due, p, there);
        of.sees(there, of.no(p), due, true);
        of.expires(due, failed);
        return of.whole(due);
    }
    const Scoped in = scoped(of, scope, 1);
    if (scope != Sentence::Scope::Before) {
        of.sees(in.out, of.both(in.opens, p), there);
        of.sees(in.out, in.opens, due, true);
    }
    if (scope != Sentence::Scope::After) {
        of.sees(due, in.closes, in.out);
        of.sees(there, in.closes, in.out);
    }
    of.sees(due, p, there);
    of.sees(there, of.no(p), due, true);
    of.expires(due, in.failed);
    return of.whole(scope == Sentence::Scope::Before ? due : in.out);
}

/// Builds the observer of `p holds for d`: whenever p becomes false, p has held for at least d.
ObserverMade holds_for(Observer of) {
    const Location off = of.location("off"), on = of.location("on"), failed = of.failed();
    of.clock();
    of.sees(off, of.p(), on, true);
    of.sees(on, of.no(of.p()), off);
    of.times(on, of.no(of.p()), Op::Less, failed);
    return of.whole(off);
}

/// Builds the observer of `p holds at most d`.
ObserverMade holds_at_most(Observer of, Sentence::Scope scope) {
    if (scope != Sentence::Scope::Globally) return recurs(of, of.no(of.p()), scope);
    const Location off = of.location("off"), on = of.location("on"), failed = of.failed();
    of.clock();
    of.sees(off, of.p(), on, true);
    of.sees(on, of.no(of.p()), off);
    of.expires(on, failed);
    return of.whole(off);
}

/// Builds the observer of `q at most d since p`: in each state with q, p holds, or has held at most d before.
ObserverMade since(Observer of) {
    const Id<Expr> q = of.p(0), p = of.p(1);
    const Location before = of.location("before"), during = of.location("during"), after = of.location("after"),
                   failed = of.failed();
    of.clock();
    of.sees(before, p, during);
    of.sees(before, q, failed);
    of.sees(during, of.no(p), after, true);
    of.sees(after, p, during);
    of.times(after, of.both(q, of.no(p)), Op::Greater, failed);
    return of.whole(before);
}

// -- counts -----------------------------------------------------------------------------------------------------------

/// Builds the observer of `p at most count times`: counts the states with p that are the first state of the scope or
/// follow a state without p. If several states could open the scope, the count starts in the first of them, because
/// this count is at least as large as a count that starts later.
ObserverMade occurrences(Observer of, Sentence::Scope scope, std::int64_t count) {
    using enum Sentence::Scope;
    const Id<Expr> p = of.p();
    const Scoped in = scope == Globally ? Scoped{{}, of.failed(), {}, {}} : scoped(of, scope, 1);
    Location off = of.location("off_0");
    const Location first = off;
    for (std::int64_t seen = 1;; ++seen) {
        if (scope != Globally && scope != After) of.sees(off, in.closes, in.out);
        if (seen > count) break;
        const Location on = of.location(fmt::format("on_{}", seen)), next = of.location(fmt::format("off_{}", seen));
        if (seen == 1 && scope != Globally && scope != Before) {
            of.sees(in.out, of.both(in.opens, p), on);
            of.sees(in.out, in.opens, off);
        }
        of.sees(off, p, on);
        if (scope != Globally && scope != After) of.sees(on, in.closes, in.out);
        of.sees(on, of.no(p), next);
        off = next;
    }
    of.sees(off, p, in.failed);
    return of.whole(scope == Globally || scope == Before ? first : in.out);
}

// -- scopes: r opens a scope, s closes it -----------------------------------------------------------------------------

/// Builds the observer of `never p` in a scope.
ObserverMade absence(Observer of, Id<Expr> p, Sentence::Scope scope) {
    const Id<Expr> r = of.p(1);
    const Location in = of.location("inside"), out = of.location("outside"), failed = of.failed();
    if (scope == Sentence::Scope::Before) {
        const Location spoilt = of.location("spoilt");
        of.sees(in, r, out);
        of.sees(in, p, spoilt);
        of.sees(spoilt, r, failed);
        return of.whole(in);
    }
    if (scope == Sentence::Scope::After) {
        of.sees(out, of.both(r, p), failed);
        of.sees(out, r, in);
        of.sees(in, p, failed);
        return of.whole(out);
    }
    const Id<Expr> s = of.p(2), opens = of.both(r, of.no(s));
    const bool closed = scope == Sentence::Scope::Between;
    const Location spoilt = closed ? of.location("spoilt") : failed;
    of.sees(out, of.both(opens, p), spoilt);
    of.sees(out, opens, in);
    of.sees(in, s, out);
    of.sees(in, p, spoilt);
    if (closed) of.sees(spoilt, s, failed);
    return of.whole(out);
}

/// Builds the observer of `inevitable p` in a scope.
ObserverMade existence(Observer of, Sentence::Scope scope) {
    const Id<Expr> p = of.p(0), r = of.p(1);
    const Location idle = of.location("idle"), due = of.location("due");
    if (scope == Sentence::Scope::Before) {
        const Location failed = of.failed();
        of.sees(due, r, failed);
        of.sees(due, p, idle);
        return of.whole(due);
    }
    if (scope == Sentence::Scope::After) {
        const Location done = of.location("done");
        of.sees(idle, of.both(r, p), done);
        of.sees(idle, r, due);
        of.sees(due, p, done);
        of.made.pending = {due};
        of.made.settled = {done};
        return of.whole(idle);
    }
    const Id<Expr> s = of.p(2);
    const Location failed = of.failed();
    of.sees(idle, of.both(of.both(r, of.no(s)), of.no(p)), due);
    of.sees(due, s, failed);
    of.sees(due, p, idle);
    if (scope == Sentence::Scope::AfterUntil) {
        of.made.pending.push_back(due);
        of.made.settled = {idle};
    }
    return of.whole(idle);
}

/// Builds the observer of `p leads to q` in a scope.
ObserverMade response(Observer of, Sentence::Scope scope) {
    const Id<Expr> p = of.p(0), q = of.p(1), r = of.p(2), demand = of.both(p, of.no(q));
    const Location out = of.location("outside"), in = of.location("inside"), due = of.location("due");
    if (scope == Sentence::Scope::Before) {
        const Location failed = of.failed();
        of.sees(in, r, out);
        of.sees(in, demand, due);
        of.sees(due, r, failed);
        of.sees(due, q, in);
        return of.whole(in);
    }
    if (scope == Sentence::Scope::After) {
        of.sees(out, of.both(r, demand), due);
        of.sees(out, r, in);
        of.sees(in, demand, due);
        of.sees(due, q, in);
        of.made.pending = {due};
        of.made.settled = {in};
        return of.whole(out);
    }
    const Id<Expr> s = of.p(3), opens = of.both(r, of.no(s));
    const Location failed = of.failed();
    of.sees(out, of.both(opens, demand), due);
    of.sees(out, opens, in);
    of.sees(in, s, out);
    of.sees(in, demand, due);
    of.sees(due, s, failed);
    of.sees(due, q, in);
    if (scope == Sentence::Scope::AfterUntil) {
        of.made.pending.push_back(due);
        of.made.settled = {in};
    }
    return of.whole(out);
}

/// Builds the observer of `p precedes q` in a scope.
ObserverMade precedence(Observer of, Sentence::Scope scope) {
    const Id<Expr> p = of.p(0), q = of.p(1);
    const Location open = of.location("inside"), done = of.location("done"), failed = of.failed();
    if (scope == Sentence::Scope::Globally) {
        of.sees(open, p, done);
        of.sees(open, q, failed);
        return of.whole(open);
    }
    const Id<Expr> r = of.p(2);
    if (scope == Sentence::Scope::Before) {
        const Location spoilt = of.location("spoilt");
        of.sees(open, of.either(p, r), done);
        of.sees(open, q, spoilt);
        of.sees(spoilt, r, failed);
        return of.whole(open);
    }
    const Location out = of.location("outside");
    const auto begins = [&](Location from, Id<Expr> when, Location spoilt) {
        of.sees(from, of.both(when, p), done);
        of.sees(from, of.both(when, q), spoilt);
        of.sees(from, when, open);
    };
    if (scope == Sentence::Scope::After) {
        begins(out, r, failed);
        of.sees(open, p, done);
        of.sees(open, q, failed);
        return of.whole(out);
    }
    const Id<Expr> s = of.p(3);
    const bool closed = scope == Sentence::Scope::Between;
    const Location spoilt = closed ? of.location("spoilt") : failed;
    begins(out, of.both(r, of.no(s)), spoilt);
    of.sees(open, s, out);
    of.sees(open, p, done);
    of.sees(open, q, spoilt);
    of.sees(done, s, out);
    begins(done, r, spoilt);
    if (closed) of.sees(spoilt, s, failed);
    return of.whole(out);
}

}  // namespace

ObserverMade observer_of(Exprs& exprs, const Sentence& watch, const ObserverTerms& terms, std::int64_t duration) {
    Observer of(exprs, terms, duration);
    switch (watch.kind) {
    case Sentence::Kind::Absence: return absence(of, of.p(), watch.scope);
    case Sentence::Kind::Universality: return absence(of, of.no(of.p()), watch.scope);
    case Sentence::Kind::Existence: return existence(of, watch.scope);
    case Sentence::Kind::Response: return watch.duration_ms > 0 ? within(of, watch.scope) : response(of, watch.scope);
    case Sentence::Kind::Precedence: return precedence(of, watch.scope);
    case Sentence::Kind::HoldsFor: return holds_for(of);
    case Sentence::Kind::HoldsAtMost: return holds_at_most(of, watch.scope);
    case Sentence::Kind::Since: return since(of);
    case Sentence::Kind::Recurrence: return recurs(of, of.p(), watch.scope);
    case Sentence::Kind::Occurrences: return occurrences(of, watch.scope, watch.count);
    }
    unreachable();
}

}  // namespace grafverif
