// SPDX-License-Identifier: MIT
#include "page/scans.hpp"

#include <algorithm>

#include "ir/program/interface.hpp"
#include "run/program/controller_replay.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t no_instance = static_cast<std::size_t>(-1);

const char* word(ProgramListing::Role role) {
    switch (role) {
    case ProgramListing::Role::Read: return "read";
    case ProgramListing::Role::Condition: return "condition";
    case ProgramListing::Role::Result: return "result";
    case ProgramListing::Role::Executed: break;
    }
    return "executed";
}

}  // namespace

ProgramScans::ProgramScans(const Chart& interface, const ProgramListing& listing)
    : interface_(interface), program_(*interface.program), listing_(listing), layout_(layout_of(program_)) {
    for (std::size_t k = 0; k < layout_.instances.size(); ++k)
        instances_[{layout_.instances[k].unit.index, layout_.instances[k].frame}] = k;
}

std::size_t ProgramScans::point(std::size_t item, std::size_t frame) {
    const auto instance = instances_.find({listing_.items[item].unit.index, frame});
    const std::size_t key = instance == instances_.end() ? no_instance : instance->second;
    const auto [known, fresh] = known_.try_emplace({item, key}, points_.size());
    if (fresh) {
        points_.push_back({item, key == no_instance ? std::nullopt : std::optional(key)});
        values_.emplace_back();
        before_.emplace_back();
    }
    return known->second;
}

template <class T>
void ProgramScans::add(const std::vector<ScanLog::Evaluation<T>>& evaluations,
                       const std::vector<std::optional<std::size_t>>& items) {
    for (const ScanLog::Evaluation<T>& evaluation : evaluations) {
        const std::optional<std::size_t> item = items[evaluation.id.index];
        if (!item) continue;
        const std::size_t at = point(*item, evaluation.frame);
        Value& value = values_[at];
        if (value.scan != scan_) {
            value = {scan_, 0, 0};
            now_.push_back(at);
        }
        ++value.count;
        value.value = evaluation.value;
    }
}

/// Returns the points whose values in this scan differ from their values in the previous scan, with the new values.
Json ProgramScans::changes() {
    Json changes = Json::array();
    for (const std::size_t at : now_) {
        const Value &now = values_[at], &before = before_[at];
        if (before.scan + 1 == scan_ && before.count == now.count && before.value == now.value) continue;
        Json change = {at, now.value};
        if (now.count > 1) change.push_back(now.count);
        changes.push_back(std::move(change));
    }
    for (const std::size_t at : earlier_)
        if (values_[at].scan != scan_) changes.push_back({at, nullptr});
    for (const std::size_t at : now_) before_[at] = values_[at];
    earlier_ = std::move(now_);
    now_.clear();
    return changes;
}

Json ProgramScans::scans(const ChartRun& run, Id<ChartRun::Controller> controller, std::size_t& remaining) {
    Json list = Json::array();
    scan_ = 0;
    std::ranges::fill(values_, Value());
    std::ranges::fill(before_, Value());
    earlier_.clear();
    const std::size_t known_points = points_.size();
    std::size_t left = remaining;
    bool fits = true;
    replay_scans(run, controller, program_, [&](std::size_t event, const ScanLog& log) {
        ++scan_;
        add(log.nodes, listing_.of_nodes);
        add(log.statements, listing_.of_statements);
        Json changed = changes();
        fits = changed.size() < left;
        if (!fits) return false;
        left -= changed.size() + 1;
        list.push_back({event, std::move(changed)});
        return true;
    });
    if (!fits) {
        points_.resize(known_points);
        values_.resize(known_points);
        before_.resize(known_points);
        std::erase_if(known_, [&](const auto& known) { return known.second >= known_points; });
        return nullptr;
    }
    remaining = left;
    return list;
}

Json ProgramScans::format_json(Id<Program::Type> type) const {
    if (!type.valid()) return nullptr;
    const Program::Type& of = program_.types[type];
    if (of.kind == Program::Type::Kind::Boolean) return "boolean";
    if (of.kind == Program::Type::Kind::Time) return "time";
    if (of.kind == Program::Type::Kind::Enumeration) return of.values;
    return nullptr;
}

/// Returns the line and the instance of each step of the chart.
Json ProgramScans::steps_json() const {
    Json list = Json::array();
    for (const std::size_t cell : step_cells(layout_)) {
        const auto line = line_of(listing_, layout_.cells[cell].origin);
        std::size_t owner = 0;
        for (std::size_t k = 0; k < layout_.instances.size(); ++k) {
            const ProgramInstance& instance = layout_.instances[k];
            const bool contains = cell >= instance.frame && cell < instance.frame + program_.units[instance.unit].size;
            if (contains && !program_.units[instance.unit].sequences.empty()) owner = k;
        }
        list.push_back({{"line", line ? Json(*line) : Json(nullptr)}, {"instance", owner}});
    }
    return list;
}

Json ProgramScans::json() const {
    Json points = Json::array(), instances = Json::array(), units = Json::array(), code = Json::array();
    for (const Point& point : points_) {
        const ProgramListing::Item& item = listing_.items[point.item];
        points.push_back({{"line", item.line},
                          {"order", point.item},
                          {"instance", point.instance ? Json(*point.instance) : Json(nullptr)},
                          {"role", word(item.role)},
                          {"name", item.name},
                          {"format", format_json(item.type)}});
    }
    for (const ProgramInstance& instance : layout_.instances)
        instances.push_back({{"name", instance.name}, {"unit", instance.unit.index}});
    for (const Program::Unit& unit : program_.units) units.push_back(unit.name);
    for (const ProgramListing::Item& item : listing_.items)
        if (code.empty() || code.back()[0] != item.line) code.push_back({item.line, item.unit.index});
    Json transitions = Json::array();
    for (const SequenceTest& test : sequence_tests(program_, layout_))
        transitions.push_back(listing_.items[*listing_.of_statements[test.statement.index]].line);
    return {{"units", std::move(units)}, {"instances", std::move(instances)},     {"code", std::move(code)},
            {"steps", steps_json()},     {"transitions", std::move(transitions)}, {"points", std::move(points)}};
}

void add_cleared_transitions(ChartRun& run, Id<ChartRun::Controller> controller, const Chart& drawn) {
    const std::vector<SequenceTest> tests = sequence_tests(*drawn.program, layout_of(*drawn.program));
    if (tests.empty() || run.moments.empty()) return;
    std::vector<Id<ChartRun::Transition>> added;
    for (const Chart::Transition& transition : drawn.transitions)
        added.push_back(run.transitions.add({transition.name}));
    std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> places;
    for (std::size_t k = 0; k < tests.size(); ++k) places[{tests[k].statement.index, tests[k].frame}] = k;
    std::vector<std::vector<Id<ChartRun::Transition>>> cleared(run.moments.size());
    replay_scans(run, controller, *drawn.program, [&](std::size_t event, const ScanLog& log) {
        for (const ScanLog::Evaluation<Program::Statement>& each : log.statements)
            if (const auto test = places.find({each.id.index, each.frame}); test != places.end() && each.value != 0)
                cleared[event].push_back(added[test->second]);
        return true;
    });
    run.controllers[controller].transitions = std::move(added);
    for (std::size_t event = 0; event < run.moments.size(); ++event)
        for (ChartRun::Act& act : run.moments[event].acts)
            if (act.controller == controller && act.evolves) act.fired = cleared[event];
    std::size_t from = 0;
    for (ChartRun::Row& row : run.rows) {
        for (std::size_t event = from; event <= row.moment; ++event)
            if (!cleared[event].empty()) row.fired.push_back(cleared[event]);
        from = row.moment + 1;
    }
}

}  // namespace grafverif
