// SPDX-License-Identifier: MIT
// Ways: where runs lead from sets of points and where they come from, over all points that a search has found; and the
// regions in which they end: sets of points none of which a run leaves, each reached from each other one.
//
// An evolution that breaks off leads nowhere, so its point would be a region by itself: regions are looked for among the
// points from which no run breaks off.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyse/search.hpp"

namespace grafverif::analysis {

class Ways {
public:
    /// Requires that the search is done. Both outlive the ways.
    Ways(const Machine& machine, ExecutionMode mode, const Search& search);

    const Bdd& reached() const { return reached_; }
    /// The points at which an instant ends: stable, or in every_cycle mode all; their evolution does not break off.
    const Bdd& ends() const { return ends_; }
    /// Where one evolution, or time and new inputs after it, leads from `points`.
    Bdd after(const Bdd& points) const;
    /// From where it leads to `points`.
    Bdd before(const Bdd& points) const;
    /// The points that runs through `points` come through, these included.
    Bdd from(const Bdd& points) const { return rings_from(points).back(); }
    /// The points from which runs lead to `points`, these included.
    Bdd to(const Bdd& points) const;
    /// At most `most` regions in which runs from `among` end; no run leaves `among`. Fewer: these are all.
    std::vector<Bdd> regions(Bdd among, std::size_t most) const;
    /// Those of `within`, which no run enters again, from which a run stays in it and comes through `often` again and again.
    Bdd recurring(Bdd within, const Bdd& often) const;

private:
    /// The only region in which runs from `among` end, where all that comes after the first instant is in it.
    std::optional<Bdd> home(const Bdd& among) const;
    template <class Step>
    Bdd instant_of(Bdd fresh, Bdd& all, const Step& step) const;
    /// What is new from instant to instant, and all of it together.
    std::vector<Bdd> rings_from(const Bdd& points) const;

    const Machine& machine_;
    ExecutionMode mode_;
    Bdd reached_, first_, going_on_, ends_;
    const std::vector<Bdd>& found_;  ///< reached points, the nearest first
};

}  // namespace grafverif::analysis
