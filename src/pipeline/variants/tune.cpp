// SPDX-License-Identifier: MIT
// Searches a grid of constants in rounds. Each round checks, in parallel, at most one network per open box of the grid:
// the relaxation of the box, a network with all runs of its undecided points. Then the verdicts are transferred to
// points in a fixed order, so that the result does not depend on the number of threads. If the check of a box decided a
// verdict, the next round checks the undecided points of the box; otherwise the box is split. For a box with one point,
// the network of this point is checked.
#include "pipeline/variants/tune.hpp"

#include <algorithm>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <utility>

#include "ir/patterns.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "pipeline/staged_search.hpp"
#include "pipeline/variants/in_parallel.hpp"
#include "pipeline/variants/tune_points.hpp"
#include "pipeline/variants/tune_runs.hpp"
#include "pipeline/variants/variant_search.hpp"
#include "run/retiming.hpp"

namespace grafverif {

namespace {

using Row = Tuning::Row;
using Indices = std::vector<std::size_t>;

/// After this number of successive checks of relaxations without a result, each point of a box is checked separately.
constexpr unsigned most_misses = 2;
/// The transfer of a run to other points ends after this number of failures, plus two for each successful transfer.
constexpr std::size_t most_failures = 32;

/// Data that determine how the verdicts of a row can be transferred to other points.
struct RowKind {
    std::string base = {};   ///< name of the property in the model: `S` for the row `S.X7`
    bool watched = false;    ///< true if the property has an observer
    bool pointwise = false;  ///< true if verdicts can be transferred only between equal networks
};

struct OpenBox {
    GridBox box = {};
    unsigned misses = 0;  ///< number of checks of enclosing boxes without a result since the last check with a result
    bool skip = false;    ///< the check of the enclosing box had no result: split this box before the next check
};

/// A network to check, and the rows and points whose verdicts the check can decide.
struct Job {
    std::size_t of = 0;  ///< index of the box for which the network is checked
    Relaxation relaxation = {};
    bool exact = false;  ///< true: all `points` have the same network, which is the relaxation
    Indices points = {}, rows = {};
    std::vector<Verdict> verdicts = {};
    std::map<std::string, PropertyResult> violations = {};  ///< if `exact`: results with runs, by property
    std::vector<std::string> failures = {};
    std::optional<ClockFacts> facts = {};  ///< facts about the network, computed on demand
};

class Tuner {
public:
    Tuner(const Model& model, Id<ClosedLoop> loop, Id<Source> main, const Sources& sources, const TuneRequest& request,
          Diagnostics& diagnostics)
        : model_(model),
          loop_(loop),
          request_(request),
          diagnostics_(diagnostics),
          points_(model, loop, main, sources, request, tuning_),
          runs_(tuning_, request.runs) {
        tuning_.model = model.loops[loop].name;
        tuning_.constants = request.constants;
        tuning_.reasons = {"not checked"};
        for (const TunedConstant& constant : tuning_.constants) tuning_.points *= constant.size();
    }

    std::optional<Tuning> run() {
        const auto network = network_of(model_, loop_, request_.how, diagnostics_);
        if (!network || !all_known(request_.properties, property_names(*network), diagnostics_)) return {};
        options_ = {.properties = request_.properties, .limits = request_.limits, .jobs = request_.jobs};
        const Report report = check_without_causes(loop_to_check(model_, loop_, *network), options_);
        ++tuning_.checks;
        tuning_.failures = report.failures;
        tuning_.settings = report.settings;
        tuning_.settings.constants.clear();
        add_rows(report, *network);
        search_.emplace(options_, report);
        try {
            if (!points_.read([this] { return stopped(); }, diagnostics_)) return {};
            if (points_.time_unit_ms() > 0) tuning_.settings.time_unit_ms = points_.time_unit_ms();
            note_current(report);
            search();
            runs_.write(points_, tuning_);
        } catch (const std::bad_alloc&) {
            tuning_.reasons.front() = "the memory limit was reached";
        }
        return std::move(tuning_);
    }

private:
    bool stopped() const { return is_over(request_.limits.deadline, request_.limits.stop); }

    // -- rows ------------------------------------------------------------------------------------------------------

    void add_rows(const Report& report, const Network& network) {
        for (const PropertyResult& answer : report.answers) {
            const Verdict& verdict = answer.verdict;
            RowKind kind{.base = verdict.property};
            if (verdict.pattern == Pattern::ReachableAllSteps) kind.base = kind.base.substr(0, kind.base.find('.'));
            bool at_stable = false;
            for (const Property& property : network.properties) {
                if (property.name != kind.base) continue;
                kind.watched = property.pattern == Pattern::Watched;
                at_stable = property.at_stable;
            }
            const bool timelock = verdict.pattern == Pattern::NoTimelock;
            kind.pointwise = verdict.pattern == Pattern::AlwaysPossible || (timelock && at_stable);
            if (timelock && !at_stable) timelock_ = tuning_.rows.size();
            Row row{.property = verdict.property,
                    .text = answer.text,
                    .expected_violated = verdict.expected_violated,
                    .declared = verdict.declared,
                    .origin = verdict.origin};
            row.current = point_verdict(verdict);
            // A property that the timed engine does not support has the verdict unknown at all points.
            const bool unsupported = verdict.obstacle == UnknownReason::Unsupported;
            row.verdicts.assign(tuning_.points, unsupported ? row.current : PointVerdict{});
            tuning_.rows.push_back(std::move(row));
            kinds_.push_back(std::move(kind));
            open_.push_back(unsupported ? 0 : tuning_.points);
        }
    }

    PointVerdict point_verdict(const Verdict& verdict) {
        if (verdict.outcome != Outcome::Unknown) return {verdict.outcome};
        if (verdict.obstacle == UnknownReason::Stopped) return {};
        const auto known = std::ranges::find(tuning_.reasons, verdict.reason);
        const auto index = static_cast<std::uint32_t>(known - tuning_.reasons.begin());
        if (known == tuning_.reasons.end()) tuning_.reasons.push_back(verdict.reason);
        return {Outcome::Unknown, index};
    }

    bool is_open(std::size_t row, std::size_t point) const {
        return open_[row] > 0 && points_.known(point) && tuning_.rows[row].verdicts[point] == PointVerdict{};
    }

    void decide(std::size_t row, std::size_t point, const PointVerdict& verdict) {
        if (!is_open(row, point) || verdict == PointVerdict{}) return;
        tuning_.rows[row].verdicts[point] = verdict;
        --open_[row];
        ++decided_;
    }

    /// If the current values of the constants are a point of the grid, stores the results of `report` for this point.
    void note_current(const Report& report) {
        Indices indices;
        for (const TunedConstant& constant : tuning_.constants) {
            const auto index = constant.current_index();
            if (!index) return;
            indices.push_back(*index);
        }
        const std::size_t point = tuning_.point(indices);
        if (!points_.known(point)) return;
        Job job = job_at(point);
        take_answers(report, job);
        apply(job);
    }

    /// Returns the network that the job checks.
    Network network_for(const Job& job) const { return network_of(points_.frame(job.points.front()), job.relaxation); }

    // -- transfers -------------------------------------------------------------------------------------------------

    std::size_t agreement(std::size_t row, std::size_t point) { return points_.agreement(point, kinds_[row].base); }

    Network seen_by(std::size_t row, Network network, bool exact) const {
        return grafverif::seen_by(std::move(network), kinds_[row].base, kinds_[row].watched, exact);
    }

    /// Stores a run that violates the property of a row at a point, for the report.
    void note_run(std::size_t row, std::size_t point, const Verdict& verdict, const Run& run, bool exact) {
        if (request_.runs > 0 && verdict.outcome == Outcome::Violated)
            runs_.add(row, point, verdict, run, kinds_[row].base, kinds_[row].watched, exact);
    }

    /// Returns the undecided points that agree with `point` on the property of the row (see TunePoints::agreement).
    Indices open_points(std::size_t row, std::size_t point) {
        Indices found;
        const std::size_t wanted = agreement(row, point);
        for (std::size_t other = 0; other < tuning_.points; ++other)
            if (is_open(row, other) && agreement(row, other) == wanted) found.push_back(other);
        return found;
    }

    void apply(Job& job) {
        tuning_.failures.insert(tuning_.failures.end(), job.failures.begin(), job.failures.end());
        for (const Verdict& verdict : job.verdicts)
            for (const std::size_t row : job.rows)
                if (tuning_.rows[row].property == verdict.property) apply(job, row, verdict);
    }

    void apply(Job& job, std::size_t row, const Verdict& verdict) {
        const std::size_t first = job.points.front();
        // An unknown verdict on a relaxation implies nothing for the points.
        const PointVerdict made =
            job.exact || verdict.outcome != Outcome::Unknown ? point_verdict(verdict) : PointVerdict{};
        tuning_.model_error = tuning_.model_error || (job.exact && verdict.obstacle == UnknownReason::Faulty);
        std::size_t equal = 0;
        for (const std::size_t point : request_.every_point ? job.points : open_points(row, first))
            if (job.relaxation.is_exactly(points_.constants(point))) {
                if (verdict.run) note_run(row, point, verdict, *verdict.run, job.exact);
                else if (const auto found = job.violations.find(verdict.property); found != job.violations.end())
                    runs_.add(row, point, found->second);
                decide(row, point, made);
                ++equal;
            }
        if (equal > 1 && made != PointVerdict{}) tuning_.transferred += equal - 1;
        if (request_.every_point || kinds_[row].pointwise || verdict.outcome == Outcome::Unknown) return;
        if (verdict.run) transfer_run(job, row, verdict);
        else transfer_proof(job, row, verdict);
    }

    void transfer_run(const Job& job, std::size_t row, const Verdict& verdict) {
        const Indices candidates = nearest_points(job, row);
        if (candidates.empty()) return;
        const Retiming retiming(seen_by(row, network_for(job), job.exact), *verdict.run);
        std::size_t found = 0, failed = 0;
        for (const std::size_t point : candidates) {
            if (stopped() || failed > most_failures + 2 * found) return;
            const Network member = seen_by(row, points_.network(point), job.exact);
            const std::optional<Run> run = retiming.fit(member);
            if (!run || !decides(member, *run, verdict.pattern)) {
                ++failed;
                continue;
            }
            note_run(row, point, verdict, *run, job.exact);
            decide(row, point, {verdict.outcome});
            ++tuning_.transferred;
            ++found;
        }
    }

    /// Returns the undecided points that agree with the points of the job on the property of the row. If the job
    /// checked the network of a point, the points nearest to this point come first.
    Indices nearest_points(const Job& job, std::size_t row) {
        std::size_t start = job.points.back();
        for (const std::size_t point : job.points)
            if (job.relaxation.is_exactly(points_.constants(point))) start = point;
        const Indices from = tuning_.indices(start);
        Indices points = open_points(row, start);
        std::ranges::stable_sort(points, {}, [&](std::size_t point) {
            const Indices at = tuning_.indices(point);
            std::size_t distance = 0;
            for (std::size_t k = 0; k < at.size(); ++k) distance += std::max(at[k], from[k]) - std::min(at[k], from[k]);
            return distance;
        });
        return points;
    }

    void transfer_proof(Job& job, std::size_t row, const Verdict& verdict) {
        for (const std::size_t point : job.points) {
            if (!is_open(row, point) || !is_shared(job, row, verdict, point)) continue;
            decide(row, point, {verdict.outcome});
            ++tuning_.transferred;
        }
    }

    const ClockFacts& facts_of(Job& job) const { return job.facts ? *job.facts : job.facts.emplace(network_for(job)); }

    /// True if the verdict on the relaxation is also the verdict at `point` (docs/explanation/parameters.md).
    bool is_shared(Job& job, std::size_t row, const Verdict& verdict, std::size_t point) {
        const Pattern pattern = verdict.pattern;
        if (is_about_existence(pattern)) return verdict.outcome == Outcome::Violated;
        if (verdict.outcome != Outcome::Holds) return false;
        if (is_about_all_states(pattern)) return true;
        if (pattern == Pattern::NoTimelock)
            return !verdict.abstraction && !verdict.scope.cells &&
                   points_.facts(point).releases_bounds_of(facts_of(job));
        const bool time_passes =
            timelock_ && tuning_.rows[*timelock_].verdicts[point].outcome == Outcome::Holds && !kinds_[row].watched;
        if (is_liveness(pattern)) return time_passes;
        return pattern == Pattern::NoDeadlock && time_passes && points_.facts(point).keeps_edges_of(facts_of(job));
    }

    // -- search ----------------------------------------------------------------------------------------------------

    void search() {
        GridBox all;
        for (const TunedConstant& constant : tuning_.constants) {
            all.first.push_back(0);
            all.last.push_back(constant.size() - 1);
        }
        std::vector<OpenBox> boxes{{all}};
        while (!boxes.empty() && !stopped()) {
            std::vector<Job> jobs;
            for (std::size_t k = 0; k < boxes.size(); ++k)
                if (shrink(boxes[k].box))
                    if (auto job = job_of(boxes[k])) {
                        job->of = k;
                        jobs.push_back(std::move(*job));
                    }
            check(jobs);
            std::vector<OpenBox> next;
            auto job = jobs.begin();
            for (std::size_t k = 0; k < boxes.size(); ++k) {
                const bool checked = job != jobs.end() && job->of == k;
                const std::size_t before = decided_;
                const bool last = checked && is_point(boxes[k].box);
                if (checked) apply(*job++);
                if (last || !shrink(boxes[k].box)) continue;  // after a stopped check, the verdict remains unknown
                if (decided_ > before || is_point(boxes[k].box)) next.push_back({boxes[k].box});
                else split(boxes[k], checked, next);
            }
            boxes = std::move(next);
        }
    }

    static bool is_point(const GridBox& box) { return box.first == box.last; }

    Indices open_rows(std::size_t point) const {
        Indices rows;
        for (std::size_t row = 0; row < kinds_.size(); ++row)
            if (is_open(row, point)) rows.push_back(row);
        return rows;
    }

    /// Calls `visit` for each point of a box.
    template <class Visit>
    void each_point(const GridBox& box, const Visit& visit) const {
        for_each_point(box, [&](const Indices& at) { visit(tuning_.point(at), at); });
    }

    /// Reduces a box to its undecided points. Returns false if all points of the box are decided.
    bool shrink(GridBox& box) const {
        std::optional<GridBox> made;
        each_point(box, [&](std::size_t point, const Indices& at) {
            if (open_rows(point).empty()) return;
            if (!made) made = GridBox{at, at};
            for (std::size_t k = 0; k < at.size(); ++k) {
                made->first[k] = std::min(made->first[k], at[k]);
                made->last[k] = std::max(made->last[k], at[k]);
            }
        });
        if (made) box = *made;
        return made.has_value();
    }

    Job job_at(std::size_t point) const {
        return {.relaxation = {points_.constants(point), points_.constants(point)},
                .exact = true,
                .points = {point},
                .rows = open_rows(point)};
    }

    /// Returns the next check for a box, or nullopt if the box must be split first.
    std::optional<Job> job_of(const OpenBox& open) {
        if (is_point(open.box)) return job_at(tuning_.point(open.box.first));
        if (request_.every_point || open.skip) return {};
        std::map<std::size_t, Indices> by_row;  // for each row: its undecided points
        std::set<std::size_t> all;
        each_point(open.box, [&](std::size_t point, const Indices&) {
            for (const std::size_t row : open_rows(point))
                if (!kinds_[row].pointwise) {
                    by_row[row].push_back(point);
                    all.insert(point);
                }
        });
        if (all.size() < 3) return {};  // for one or two points, a relaxation saves at most one check
        std::erase_if(by_row, [&](const auto& row) {
            return std::ranges::any_of(all, [&](std::size_t point) {
                return agreement(row.first, point) != agreement(row.first, *all.begin());
            });
        });
        if (by_row.empty()) return {};
        Job job;
        std::set<std::size_t> points;
        for (const auto& [row, open_there] : by_row) {
            job.rows.push_back(row);
            points.insert(open_there.begin(), open_there.end());
        }
        std::vector<const ClockConstants*> members;
        for (const std::size_t point : points) members.push_back(&points_.constants(point));
        job.points.assign(points.begin(), points.end());
        job.relaxation = relaxation_of(points_.frame(job.points.front()), members);
        job.exact = std::ranges::all_of(members, [&](const auto* one) { return job.relaxation.is_exactly(*one); });
        Indices& tried = tried_[{&points_.frame(job.points.front()), job.relaxation}];
        if (std::ranges::includes(tried, job.rows)) return {};
        tried = job.rows;
        return job;
    }

    void split(const OpenBox& open, bool checked, std::vector<OpenBox>& next) {
        const GridBox& box = open.box;
        const unsigned misses = open.misses + (checked ? 1U : 0U);
        if (request_.every_point || misses >= most_misses || only_pointwise(box)) {
            each_point(box, [&](std::size_t point, const Indices& at) {
                if (!open_rows(point).empty()) next.push_back({{at, at}});
            });
            return;
        }
        const std::size_t k = points_.axis_of(box);
        const std::size_t middle = (box.first[k] + box.last[k]) / 2;
        OpenBox lower{box, misses, checked}, upper{box, misses, checked};
        lower.box.last[k] = middle;
        upper.box.first[k] = middle + 1;
        next.push_back(std::move(lower));
        next.push_back(std::move(upper));
    }

    bool only_pointwise(const GridBox& box) const {
        bool only = true;
        each_point(box, [&](std::size_t point, const Indices&) {
            for (const std::size_t row : open_rows(point)) only = only && kinds_[row].pointwise;
        });
        return only;
    }

    void check(std::vector<Job>& jobs) {
        options_.jobs = jobs.size() > 1 ? 1 : request_.jobs;
        in_parallel(
            jobs.size(), request_.jobs, [this] { return stopped(); }, [&](std::size_t k) { check(jobs[k]); });
        for (const Job& job : jobs) tuning_.checks += job.verdicts.empty() ? 0U : 1U;
        if (!request_.limits.progress) return;
        std::size_t open = 0;
        for (const std::size_t count : open_) open += count;
        request_.limits.progress({[this, open] {
            return std::to_string(tuning_.checks) + " checks, " + std::to_string(open) + " verdicts open";
        }});
    }

    /// Checks the network of a job. A relaxation may have many more states than any point; its check is limited.
    void check(Job& job) {
        const Network network = network_for(job);
        if (job.exact) return check_as_declared(network, job);
        if (!verify(network).empty()) return;  // invalid: an urgent edge may violate a relaxed invariant
        job.verdicts =
            (*search_)(network, names_of(job.rows), search_->efforts().back(), share_of(request_.limits.deadline, 4));
        // The verdict on `no timelock` is transferred first, because the transfer of other verdicts depends on it.
        std::ranges::stable_partition(job.verdicts,
                                      [](const Verdict& verdict) { return verdict.pattern == Pattern::NoTimelock; });
    }

    /// Checks the network of a point as `check` does: `no timelock` remains undeclared if the loop does not declare it.
    void check_as_declared(Network network, Job& job) const {
        if (timelock_ && !tuning_.rows[*timelock_].declared)
            for (const Property& property : std::exchange(network.properties, {}))
                if (property.name != kinds_[*timelock_].base) network.properties.add(property);
        CheckOptions options = options_;
        options.properties = names_of(job.rows);
        options.limits.progress = {};
        const LoopToCheck loop{network, points_.charts(job.points.front())};
        Report report = check_without_causes(loop, options);
        take_answers(report, job);
        job.failures = std::move(report.failures);
    }

    /// Copies the results of the check of a point's network from `report` to `job`.
    void take_answers(const Report& report, Job& job) const {
        for (const PropertyResult& answer : report.answers) {
            job.verdicts.push_back(answer.verdict);
            if (request_.runs > 0 && answer.trace && answer.verdict.outcome == Outcome::Violated)
                job.violations.emplace(answer.verdict.property, answer);
        }
    }

    std::vector<std::string> names_of(const Indices& rows) const {
        std::vector<std::string> names;
        for (const std::size_t row : rows)
            if (std::ranges::find(names, kinds_[row].base) == names.end()) names.push_back(kinds_[row].base);
        return names;
    }

    const Model& model_;
    Id<ClosedLoop> loop_;
    const TuneRequest& request_;
    Diagnostics& diagnostics_;
    Tuning tuning_ = {};
    TunePoints points_;
    TuneRuns runs_;
    std::vector<RowKind> kinds_ = {};
    std::vector<std::size_t> open_ = {};  ///< for each row: number of undecided points
    std::size_t decided_ = 0;             ///< number of decided verdicts
    std::optional<std::size_t> timelock_ = {};
    CheckOptions options_ = {};
    std::optional<VariantSearch> search_ = {};  ///< the search that checks relaxations
    /// For each relaxation: the rows for which it was checked.
    std::map<std::pair<const Network*, Relaxation>, Indices> tried_ = {};
};

}  // namespace

std::optional<Tuning> tuned(const Model& model, Id<ClosedLoop> loop, Id<Source> main, const Sources& sources,
                            const TuneRequest& request, Diagnostics& diagnostics) {
    return Tuner(model, loop, main, sources, request, diagnostics).run();
}

}  // namespace grafverif
