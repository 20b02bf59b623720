// SPDX-License-Identifier: MIT
// Builds a localized network. Processes and variables that this network contains are *kept*; all other variables are
// *free*. A term that reads free variables becomes a term over *choices*, which are Parameter leaves while an edge is
// built. Each maximal subterm that reads only free variables is one choice. The operands of an And or Or that read only
// free variables form one joint choice. The edge is then instantiated for each combination of values of its choices. If
// there are too many combinations, each value of an auxiliary variable is a single choice.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "ir/junction.hpp"
#include "ir/literal.hpp"
#include "ir/network/choices.hpp"
#include "ir/network_fragments.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

/// Flags of a term. Kept: the term reads a kept variable or location. Free: the term reads a free variable or location.
enum : std::uint8_t { Kept = 1, Free = 2 };

/// True for Boolean variables by which a PLC, its timers and its cycles interact. The values of these variables are
/// often large terms.
bool is_auxiliary(const Network::Variable& variable) {
    using enum Network::Role;
    constexpr std::array auxiliary{Flag, TimerPending, Watched, Previous};
    return variable.type.boolean && std::ranges::find(auxiliary, variable.role) != auxiliary.end();
}

class LocalBuilder {
public:
    LocalBuilder(const Network& network, const NetworkFragments& cells, const std::vector<std::uint32_t>& chosen,
                 const std::vector<Id<Expr>>& invariants, const LocalAblations& ablations)
        : whole_(network),
          cells_(cells),
          chosen_(chosen),
          invariants_(invariants),
          ablations_(ablations),
          process_(network.processes.size(), none),
          variable_(network.variables.size(), none),
          copy_(network.exprs, made_.network.exprs, [this](const Expr& node) { return leaf(node); }) {}

    LocalNetwork build(const std::vector<Property>& properties) {
        made_.network.name = whole_.name;
        made_.network.grain = whole_.grain;
        made_.network.time_unit_ms = whole_.time_unit_ms;
        choose_processes();
        choose_variables(properties);
        reads_ = reads(false);
        reads_resting_ = reads(true);
        for (const Id<Expr> invariant : invariants_) free_in_.push_back(free_in(invariant));
        for (const Id<Network::Process> id : whole_.processes.ids())
            if (kept(id)) add_process(id);
        add_rest();
        for (const Network::Controller& controller : whole_.controllers)
            if (kept(controller.process)) add_controller(controller);
        if (whole_.race.valid() && kept(whole_.race)) made_.network.race = here(whole_.race);
        add_properties(properties);
        made_.borders.assign(borders_.begin(), borders_.end());
        made_.tied.assign(tied_.begin(), tied_.end());
        made_.known.assign(known_.begin(), known_.end());
        return std::move(made_);
    }

private:
    static constexpr std::uint32_t none = NetworkFragments::none;

    bool kept(Id<Network::Process> id) const { return process_[id.index] != none; }
    bool kept(Id<Network::Variable> id) const { return variable_[id.index] != none; }
    bool chosen(std::uint32_t cell) const { return std::ranges::binary_search(chosen_, cell); }
    /// True if the variable is free, but its value is fixed whenever time passes.
    bool rests(Id<Network::Variable> id) const {
        const std::uint32_t process = cells_.resting[id.index].process;
        return !kept(id) && process != none && process_[process] == none;
    }
    Id<Network::Variable> variable_of(Id<Expr> leaf) const {
        return {static_cast<std::uint32_t>(whole_.exprs[leaf].value)};
    }

    void choose_processes();
    void choose_variables(const std::vector<Property>& properties);
    std::vector<std::uint8_t> reads(bool resting) const;

    Id<Expr> leaf(const Expr& node);
    Id<Network::Variable> here(Id<Network::Variable> variable) const { return {variable_[variable.index]}; }

    void add_process(Id<Network::Process> id);
    void add_rest();
    void add_edge(const Slots& slots, const Network::Edge& edge, bool of_rest, Network::Template& to);
    void add_copies(const Network::Edge& free, Id<Expr> always, Network::Template& to);
    void add_controller(const Network::Controller& controller);
    void add_properties(const std::vector<Property>& properties);

    void start_edge();
    Id<Expr> over_choices(Id<Expr> term);
    Id<Expr> mixed(Id<Expr> term);
    Id<Expr> choice(std::vector<Id<Expr>> terms, Op op);
    Id<Expr> choice_of_value(Id<Expr> value);
    void read(Id<Network::Variable> variable);
    Network::Edge free_edge(const Slots& slots, const Network::Edge& edge, bool of_rest);
    std::optional<Network::Assignment> assignment(const Network::Assignment& written);
    std::vector<Id<Network::Variable>> free_in(Id<Expr> invariant) const;
    Id<Expr> known_of_choices(const std::vector<std::size_t>& informative);
    Id<Expr> enabled_by_all(Id<Expr> guard);

    const Network& whole_;
    const NetworkFragments& cells_;
    const std::vector<std::uint32_t>& chosen_;
    const std::vector<Id<Expr>>& invariants_;
    LocalAblations ablations_;
    LocalNetwork made_ = {};
    std::vector<std::uint32_t> process_ = {};   // maps processes of the complete network to processes of the result
    std::vector<std::uint32_t> variable_ = {};  // maps variables of the complete network to variables of the result
    std::vector<std::uint8_t> reads_ = {};      // flags of each term of the complete network

    // Flags of each term for states in which time passes; variables that have a fixed value in these states are not
    // free.
    std::vector<std::uint8_t> reads_resting_ = {};
    std::set<std::uint32_t> borders_ = {}, tied_ = {};
    std::vector<std::vector<Id<Network::Variable>>> free_in_ = {};  // free variables that each invariant reads
    std::set<std::size_t> known_ = {};
    TermCopier copy_;

    // The state of the construction of the current edge.
    Choices choices_{whole_, made_.network.exprs};
    std::map<Id<Network::Variable>, std::size_t> written_ = {};  // number of the last write to each free variable
    std::size_t writes_ = 0;  // current number of writes to free variables and of joint choices
    bool loose_ = false;      // true if the current term is the value of a flag or belongs to `rest`
    bool at_rest_ = false;    // true if the current term is evaluated in states in which time passes
    bool joint_ = false;      // true if an auxiliary variable whose value reads free variables is a single choice
    using Copy = std::tuple<bool, Id<Expr>, std::vector<Id<Expr>>>;
    std::set<Copy> copies_ = {};  // copies of the edge that were already added
};

/// Selects the processes to keep: the processes of the chosen fragments, and each PLC with variables in a chosen
/// fragment.
void LocalBuilder::choose_processes() {
    std::uint32_t count = 0;
    for (const Id<Network::Process> id : whole_.processes.ids()) {
        bool keep = cells_.of_process[id.index] != none && chosen(cells_.of_process[id.index]);
        if (cells_.of_process[id.index] == none)
            for (const Id<Network::Variable> variable : Slots(whole_, id).written())
                keep =
                    keep || (cells_.of_variable[variable.index] != none && chosen(cells_.of_variable[variable.index]));
        if (keep) process_[id.index] = count++;
    }
}

/// Selects the variables to keep. Candidates are the variables of the chosen fragments and the variables without a
/// fragment. A candidate is kept if a kept process or a property reads it, if it is an integer (it may leave its
/// range), or if it is `race`.
void LocalBuilder::choose_variables(const std::vector<Property>& properties) {
    std::vector<std::vector<Id<Expr>>> values(whole_.variables.size());  // for each variable: assigned values
    std::vector<Id<Network::Variable>> todo;
    std::vector<bool> needed(whole_.variables.size(), false);
    const auto need = [&](Id<Network::Variable> variable) {
        const std::uint32_t cell = cells_.of_variable[variable.index];
        if (needed[variable.index] || (cell != none && !chosen(cell))) return;
        needed[variable.index] = true;
        todo.push_back(variable);
    };
    const auto need_all = [&](Id<Expr> term) {
        for (const Id<Expr> leaf : leaves(whole_.exprs, term))
            if (whole_.exprs[leaf].op == Op::Variable) need(variable_of(leaf));
    };
    for (const Id<Network::Process> id : whole_.processes.ids()) {
        const Slots slots(whole_, id);
        for (const Network::Edge& edge : slots.automaton.edges) {
            if (kept(id)) need_all(edge.guard);
            for (const Network::Assignment& assignment : slots.assignments(edge)) {
                const Id<Network::Variable> target = variable_of(assignment.target);
                if (!kept(id) && target != whole_.race) continue;
                values[target.index].push_back(assignment.value);
                if (target == whole_.race || !whole_.variables[target].type.boolean) need(target);
            }
        }
    }
    bool settled = false;
    for (const Property& property : properties) {
        settled = settled || property.at_stable;
        for (const Id<Expr> operand : property.operands) need_all(operand);
    }
    if (settled && whole_.settled.valid()) need_all(whole_.settled);
    for (; !todo.empty();) {
        const Id<Network::Variable> variable = todo.back();
        todo.pop_back();
        for (const Id<Expr> value : values[variable.index]) need_all(value);
    }
    for (const Id<Network::Variable> id : whole_.variables.ids())
        if (needed[id.index]) variable_[id.index] = made_.network.variables.add(whole_.variables[id]).index;
}

/// Returns the flags (Kept, Free) of each term. Requires that operands precede their terms.
std::vector<std::uint8_t> LocalBuilder::reads(bool resting) const {
    std::vector<std::uint8_t> all(whole_.exprs.size(), 0);
    for (std::uint32_t index = 0; index < all.size(); ++index) {
        const Expr& node = whole_.exprs[Id<Expr>{index}];
        const Id<Network::Variable> variable{static_cast<std::uint32_t>(node.value)};
        if (node.op == Op::At) all[index] = process_[at_process(node)] != none ? Kept : Free;
        if (node.op == Op::Variable && !(resting && rests(variable))) all[index] = kept(variable) ? Kept : Free;
        for (const Id<Expr> operand : whole_.exprs.operands(Id<Expr>{index})) all[index] |= all[operand.index];
    }
    return all;
}

/// Translates a leaf that refers to a kept process or a kept variable.
Id<Expr> LocalBuilder::leaf(const Expr& node) {
    Exprs& exprs = made_.network.exprs;
    if (node.op == Op::At) return exprs.at(process_[at_process(node)], at_location(node));
    return exprs.leaf(Op::Variable, variable_[static_cast<std::size_t>(node.value)]);
}

void LocalBuilder::start_edge() {
    choices_.clear();
    written_.clear();
    writes_ = 0;
}

Id<Expr> LocalBuilder::over_choices(Id<Expr> term) {
    const std::uint8_t read = at_rest_ ? reads_resting_[term.index] : reads_[term.index];
    if (!at_rest_ && (read & Free) == 0) return copy_(term);
    if (read == Free && whole_.exprs[term].op != Op::Not) return choice({term}, Op::And);
    return mixed(term);
}

Id<Expr> LocalBuilder::mixed(Id<Expr> term) {
    const Expr node = whole_.exprs[term];
    Exprs& exprs = made_.network.exprs;
    if (node.op == Op::Variable) {
        const Id<Network::Variable> variable{static_cast<std::uint32_t>(node.value)};
        return kept(variable) ? leaf(node) : exprs.constant(cells_.resting[variable.index].value);
    }
    if (node.count == 0) return copy_(term);
    const bool junction = node.op == Op::And || node.op == Op::Or;
    std::vector<Id<Expr>> operands, free;
    for (const Id<Expr> operand : whole_.exprs.operands(term)) {
        const std::uint8_t read = at_rest_ ? reads_resting_[operand.index] : reads_[operand.index];
        if (junction && read == Free) free.push_back(operand);
        else operands.push_back(over_choices(operand));
    }
    if (free.size() == 1) operands.push_back(over_choices(free.front()));
    else if (!free.empty()) operands.push_back(choice(std::move(free), node.op));
    return exprs.apply(node.op, operands);
}

Id<Expr> LocalBuilder::choice(std::vector<Id<Expr>> terms, Op op) {
    std::size_t writes = 0;
    for (const Id<Expr> term : terms)
        for (const Id<Expr> leaf : leaves(whole_.exprs, term)) {
            const Id<Network::Variable> variable = variable_of(leaf);
            if (const auto written = written_.find(variable); written != written_.end())
                writes = std::max(writes, written->second);
            read(variable);
        }
    return choices_.leaf(std::move(terms), op, writes);
}

/// Returns a choice of the value of a term. The term may read kept variables, which other assignments of the edge may
/// change; therefore, the choice is independent of all other choices.
Id<Expr> LocalBuilder::choice_of_value(Id<Expr> value) {
    for (const Id<Expr> leaf : leaves(whole_.exprs, value)) read(variable_of(leaf));
    return choices_.leaf({value}, Op::And, ++writes_);
}

/// Records the fragment that a choice reads.
void LocalBuilder::read(Id<Network::Variable> variable) {
    const std::uint32_t cell = cells_.of_variable[variable.index];
    if (cell == none || chosen(cell)) return;
    tied_.insert(cell);
    if (!loose_) borders_.insert(cell);
}

/// Translates an assignment. The result is empty if the assignment does not write a kept variable. Races on omitted
/// variables may be assumed not to occur, because a race ends the run.
std::optional<Network::Assignment> LocalBuilder::assignment(const Network::Assignment& written) {
    const Id<Network::Variable> target = variable_of(written.target);
    if (!kept(target)) {
        written_[target] = ++writes_;
        return {};
    }
    const bool of_rest = std::exchange(loose_, loose_ || whole_.variables[target].role == Network::Role::Flag);
    Network::Assignment made{copy_(written.target), {}};
    if (target == whole_.race) {
        std::vector<Id<Expr>> reasons;
        for (const Id<Expr> reason : operands_of(whole_.exprs, written.value, Op::Or))
            if (reads_[reason.index] != Free) reasons.push_back(over_choices(reason));
        made.value = made_.network.exprs.disjunction(reasons);
    } else if (joint_ && is_auxiliary(whole_.variables[target]) && reads_[written.value.index] == (Kept | Free)) {
        made.value = choice_of_value(written.value);
    } else {
        made.value = over_choices(written.value);
    }
    loose_ = of_rest;
    return made.value == made.target ? std::nullopt : std::optional(made);
}

/// Returns the condition under which the guard holds for all values of the choices.
Id<Expr> LocalBuilder::enabled_by_all(Id<Expr> guard) {
    std::vector<Id<Expr>> all;
    choices_.begin();
    do all.push_back(choices_.chosen(guard));
    while (choices_.next());
    Exprs& exprs = made_.network.exprs;
    return ablations_.urgent_where_possible ? exprs.disjunction(all) : exprs.conjunction(all);
}

/// Returns the guard and the assignments of an edge over choices.
Network::Edge LocalBuilder::free_edge(const Slots& slots, const Network::Edge& edge, bool of_rest) {
    start_edge();
    loose_ = of_rest;
    Network::Edge free{.from = {0}, .to = {0}, .guard = over_choices(edge.guard)};
    for (const Network::Assignment& written : slots.assignments(edge))
        if (auto made = assignment(written)) free.assignments.push_back(*made);
    return free;
}

void LocalBuilder::add_edge(const Slots& slots, const Network::Edge& edge, bool of_rest, Network::Template& to) {
    Id<Expr> always = made_.network.exprs.constant(false);
    if (edge.urgent && !of_rest) {
        start_edge();
        at_rest_ = true;
        const Id<Expr> guard = over_choices(edge.guard);
        at_rest_ = false;
        if (!choices_.few()) return void(made_.made = false);
        always = enabled_by_all(guard);
    }
    Network::Edge free = free_edge(slots, edge, of_rest);
    if (ablations_.joint || !choices_.few()) {
        joint_ = true;
        free = free_edge(slots, edge, of_rest);
        joint_ = false;
    }
    if (of_rest && free.assignments.empty()) return;
    if (!choices_.few()) return void(made_.made = false);
    if (!of_rest) {
        free.from = edge.from;
        free.to = edge.to;
        free.resets = edge.resets;
        for (Network::ClockConstraint constraint : edge.constraint) {
            constraint.bound = copy_(constraint.bound);
            free.constraint.push_back(constraint);
        }
    }
    free.origin = edge.origin;
    add_copies(free, always, to);
}

void LocalBuilder::add_copies(const Network::Edge& free, Id<Expr> always, Network::Template& to) {
    Exprs& exprs = made_.network.exprs;
    std::vector<std::size_t> informative;
    for (std::size_t i = 0; i < invariants_.size(); ++i)
        if (choices_.report_of(free_in_[i])) informative.push_back(i);
    choices_.begin();
    do {
        if (ablations_.steady && !choices_.as_at_first()) continue;
        Network::Edge copy = free;
        for (Network::Assignment& assignment : copy.assignments) assignment.value = choices_.chosen(assignment.value);
        std::erase_if(copy.assignments, [](const auto& assignment) { return assignment.target == assignment.value; });
        std::vector<Id<Expr>> effect;
        for (const Network::Assignment& assignment : copy.assignments) {
            effect.push_back(assignment.target);
            effect.push_back(assignment.value);
        }
        const auto add = [&](Id<Expr> guard, bool urgent) {
            if (is_false(exprs, guard) || !copies_.emplace(urgent, guard, effect).second) return;
            copy.guard = guard;
            copy.urgent = urgent;
            to.edges.add(copy);
        };
        const Id<Expr> guard = exprs.conjunction(choices_.chosen(free.guard), known_of_choices(informative));
        add(exprs.conjunction(always, guard), true);
        if (guard != always) add(guard, false);
    } while (choices_.next());
}

/// Returns the omitted variables that the invariant reads.
std::vector<Id<Network::Variable>> LocalBuilder::free_in(Id<Expr> invariant) const {
    std::vector<Id<Network::Variable>> free;
    for (const Id<Expr> leaf : leaves(whole_.exprs, invariant))
        if ((reads_[leaf.index] & Free) != 0) free.push_back(variable_of(leaf));
    return free;
}

/// Returns the constraints that the given invariants impose on kept variables before the edge, under the current values
/// of the choices.
Id<Expr> LocalBuilder::known_of_choices(const std::vector<std::size_t>& informative) {
    Exprs& exprs = made_.network.exprs;
    std::vector<Id<Expr>> all;
    for (const std::size_t i : informative) {
        const std::optional<std::vector<Choices::Values>> possible = choices_.possible_before(free_in_[i]);
        if (!possible) continue;
        std::vector<Id<Expr>> cases;
        for (const Choices::Values& values : *possible)
            cases.push_back(translate(whole_.exprs, invariants_[i], exprs, [&](const Expr& node) {
                const auto at = values.find({static_cast<std::uint32_t>(node.value)});
                if (node.op != Op::Variable || at == values.end()) return leaf(node);
                return literal(exprs, whole_.variables[at->first].type, at->second);
            }));
        all.push_back(exprs.disjunction(cases));
        if (!is_true(exprs, all.back())) known_.insert(i);
    }
    return exprs.conjunction(all);
}

void LocalBuilder::add_process(Id<Network::Process> id) {
    const Slots slots(whole_, id);
    Network::Template automaton{.name = slots.automaton.name,
                                .clocks = slots.automaton.clocks,
                                .locations = slots.automaton.locations,
                                .initial = slots.automaton.initial,
                                .origin = slots.automaton.origin};
    for (Network::Location& location : automaton.locations)
        for (Network::ClockConstraint& bound : location.invariant) bound.bound = copy_(bound.bound);
    for (const Network::Edge& edge : slots.automaton.edges) {
        copies_.clear();
        add_edge(slots, edge, false, automaton);
    }
    Network::Process process = slots.process;
    process.automaton = made_.network.templates.add(std::move(automaton));
    made_.network.processes.add(std::move(process));
}

/// Adds the process `rest` for the writes of omitted processes to kept variables. The writes can occur at any time,
/// because the clocks and locations of omitted processes are ignored.
void LocalBuilder::add_rest() {
    Network::Template rest{.name = "rest", .initial = {0}};
    rest.locations.add({.name = "any"});
    copies_.clear();
    for (const Id<Network::Process> id : whole_.processes.ids()) {
        if (kept(id) || ablations_.silent) continue;
        const Slots slots(whole_, id);
        for (const Network::Edge& edge : slots.automaton.edges) add_edge(slots, edge, true, rest);
    }
    if (rest.edges.empty()) return;
    const Id<Network::Template> automaton = made_.network.templates.add(std::move(rest));
    made_.network.processes.add({.name = "rest", .automaton = automaton, .initial = {0}});
}

/// Adds the controller with its process, waiting location, flag `stable`, name and kept timers. State statistics use
/// these data to name the controller, to count its timers with it, and to recognise states within a cycle.
void LocalBuilder::add_controller(const Network::Controller& controller) {
    if (!kept(controller.stable)) return;
    Network::Controller made{.process = {process_[controller.process.index]},
                             .waiting = controller.waiting,
                             .stable = here(controller.stable)};
    made.words.name = controller.words.name;
    for (const Network::Timer& timer : controller.timers)
        if (kept(timer.process)) made.timers.push_back({.process = {process_[timer.process.index]}});
    made_.network.controllers.add(std::move(made));
}

/// Translates the properties; `settled` keeps its conjuncts over kept variables.
void LocalBuilder::add_properties(const std::vector<Property>& properties) {
    std::vector<Id<Expr>> settled;
    if (whole_.settled.valid()) {
        for (const Id<Expr> conjunct : operands_of(whole_.exprs, whole_.settled, Op::And))
            if ((reads_[conjunct.index] & Free) == 0) settled.push_back(copy_(conjunct));
        made_.network.settled = made_.network.exprs.conjunction(settled);
    }
    for (Property property : properties) {
        for (Id<Expr>& operand : property.operands) operand = copy_(operand);
        made_.network.properties.add(std::move(property));
    }
}

}  // namespace

LocalNetwork localized(const Network& network, const NetworkFragments& cells, const std::vector<std::uint32_t>& chosen,
                       const std::vector<Property>& properties, const std::vector<Id<Expr>>& invariants,
                       const LocalAblations& ablations) {
    return LocalBuilder(network, cells, chosen, invariants, ablations).build(properties);
}

}  // namespace grafverif
