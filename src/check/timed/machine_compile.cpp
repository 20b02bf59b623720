// SPDX-License-Identifier: MIT
// Compiles a Network to a Machine. The compilation is performed once before each search.
#include <algorithm>
#include <utility>

#include "check/timed/machine.hpp"

namespace grafverif::timed {

namespace {

/// Compiles the test that a clock is in the interval `wanted`. The stored value of the clock never exceeds `cap`.
std::uint32_t within(Compiler& compiler, const Field& field, const Interval& wanted, std::int64_t cap,
                     std::uint32_t yes, std::uint32_t no) {
    const std::int64_t low = std::max<std::int64_t>(wanted.low, 0);
    const std::int64_t high = std::min(wanted.high, std::max<std::int64_t>(cap, 0));
    if (low > high) return no;
    if (low == 0 && high >= cap) return yes;
    return compiler.emit(field_within(field, low, high, yes, no));
}

}  // namespace

Machine::Machine(const Network& network, std::vector<InputChoice> choices, const VariableSet& unread)
    : network_(network),
      choices_(std::move(choices)),
      clocks_(analyse_clocks(network)),
      layout_(layout_of(network, clocks_, choices_, unread)),
      compiler_(network_, layout_, program_) {
    if (!choices_.empty()) program_.below = choices_.size();
    for (std::size_t i = 0; i < choices_.size(); ++i)
        if (choices_[i].until_delay) until_delay_.push_back(layout_.choices[i]);
    for (const InputChoice& choice : choices_) {
        rests_.emplace_back();
        if (choice.stable.valid())
            rests_.back() =
                Rest{layout_.variables[choice.stable.index], layout_.locations[choice.plc.index], choice.waiting.index};
    }
    for (const Id<Network::Process> process : network.processes.ids()) compile(process);
}

void Machine::compile(Id<Network::Process> process) {
    const Network::Template& automaton = network_.templates[network_.processes[process].automaton];
    compiler_.choose_nothing();
    for (std::size_t i = 0; i < choices_.size(); ++i)
        if (choices_[i].plc == process) compiler_.choose(choices_[i], i);
    const Field& field = layout_.locations[process.index];
    places_.push_back({field.mask(), static_cast<std::uint32_t>(rows_.size()), field.word, field.shift});
    std::vector<std::vector<Id<Network::Edge>>> leaving(automaton.locations.size());
    for (const Id<Network::Edge> edge : automaton.edges.ids())
        leaving[automaton.edges[edge].from.index].push_back(edge);
    for (const Id<Network::Location> location : automaton.locations.ids()) {
        Row row;
        compile_ticks(process, location, row);
        row.first = static_cast<std::uint32_t>(edges_.size());
        for (const Id<Network::Edge> edge : leaving[location.index])
            if (!is_false(network_.exprs, automaton.edges[edge].guard)) edges_.push_back(compile_edge(process, edge));
        row.last = static_cast<std::uint32_t>(edges_.size());
        rows_.push_back(row);
    }
    compiler_.choose_nothing();
}

void Machine::add_sets(Id<Network::Process> process, Id<Network::Edge> edge, Edge& compiled) {
    compiled.first_set = static_cast<std::uint32_t>(sets_.size());
    for (std::uint32_t i = 0; i < choices_.size(); ++i) {
        const InputChoice& choice = choices_[i];
        if (choice.plc != process) continue;
        sets_.push_back({.choice = i,
                         .all = ~Word{0} >> (64 - choice.valuations.size()),
                         .widened = std::ranges::find(choice.widened, edge) != choice.widened.end()});
    }
    compiled.last_set = static_cast<std::uint32_t>(sets_.size());
}

void Machine::compile_ticks(Id<Network::Process> process, Id<Network::Location> location, Row& row) {
    const Network::Template& automaton = network_.templates[network_.processes[process].automaton];
    const auto& invariant = automaton.locations[location].invariant;
    const std::vector<Interval> allowed = admitted(network_, invariant, automaton.clocks.size());
    row.first_tick = static_cast<std::uint32_t>(ticks_.size());
    for (std::uint32_t clock = 0; clock < automaton.clocks.size(); ++clock) {
        const std::int64_t cap = clocks_[process.index].cap[location.index][clock];
        if (cap == ProcessClocks::dead) continue;
        timed_ = true;
        const Field& field = layout_.clocks[process.index][clock];
        const std::int64_t greatest = allowed[clock].high >= Interval::unbounded
                                          ? Interval::unbounded
                                          : std::max<std::int64_t>(allowed[clock].high, 0);
        ticks_.push_back({field.mask(), static_cast<Word>(greatest), static_cast<Word>(cap), field.word, field.shift});
    }
    row.last_tick = static_cast<std::uint32_t>(ticks_.size());
    for (std::size_t bound = 0; bound < std::min<std::size_t>(invariant.size(), 64); ++bound) {
        row.bounds |= Word{1} << bound;
        if (admitted(network_, invariant[bound]).high >= 1) row.late |= Word{1} << bound;
    }
}

Machine::Edge Machine::compile_edge(Id<Network::Process> process, Id<Network::Edge> id) {
    const Network::Template& automaton = network_.templates[network_.processes[process].automaton];
    const Network::Edge& edge = automaton.edges[id];
    Edge compiled;
    compiled.process = process.index;
    compiled.index = id.index;
    compiled.urgent = edge.urgent;
    compile_guard(edge.guard, compiled);
    // The invariant of the target location reads only clocks. Therefore the code can test this invariant, for the clock
    // values after the resets, before it executes the effect of the edge.
    const std::vector<Interval> wanted = admitted(network_, edge.constraint, automaton.clocks.size());
    const std::vector<Interval> after =
        admitted(network_, automaton.locations[edge.to].invariant, automaton.clocks.size());
    for (std::uint32_t clock = 0; clock < automaton.clocks.size(); ++clock) {
        const bool reset = resets(edge, {clock});
        if (reset && !after[clock].contains(0)) compiled.clocks = Program::no;
        const Interval both{wanted[clock].low,
                            reset ? wanted[clock].high : std::min(wanted[clock].high, after[clock].high)};
        compiled.clocks = within(compiler_, layout_.clocks[process.index][clock], both,
                                 clocks_[process.index].cap[edge.from.index][clock], compiled.clocks, Program::no);
    }
    compiled.effect = compile_effect(process, edge);
    add_sets(process, id, compiled);
    const EdgeTiming timing = timing_of(network_, clocks_[process.index], automaton, edge);
    compiled.covers = timing.covers;
    compiled.frees = timing.frees;
    compiled.always = timing.always;
    return compiled;
}

/// Compiles a guard. If some conjuncts of the guard test bits of one word, one test for all these bits is stored in the
/// edge; the remaining conjuncts are compiled to code.
void Machine::compile_guard(Id<Expr> guard, Edge& compiled) {
    const auto alone = [&](Id<Expr> term) {
        const auto bits = compiler_.literal(term);
        if (bits) {
            compiled.word = bits->word;
            compiled.mask = bits->mask;
            compiled.value = bits->value;
        }
        return bits.has_value();
    };
    if (is_true(network_.exprs, guard) || alone(guard)) return;
    compiled.guard = compiler_.condition(guard, Program::yes, Program::no);
    const Instruction& first = program_.code[compiled.guard];
    if (first.op != Opcode::Test || first.no != Program::no) return;
    compiled.word = first.word;
    compiled.mask = first.mask;
    compiled.value = first.value;
    compiled.guard = first.yes;
}

std::uint32_t Machine::compile_effect(Id<Network::Process> process, const Network::Edge& edge) {
    const Network::Template& automaton = network_.templates[network_.processes[process].automaton];
    const auto& caps = clocks_[process.index].cap;
    std::uint32_t next = Program::yes;
    std::vector<Instruction> patches;
    const auto patch = [&](const Field& field, std::int64_t value) {
        if (field.width == 0) return;
        auto known = std::ranges::find(patches, field.word, &Instruction::word);
        if (known == patches.end())
            known = patches.insert(known, {.mask = ~Word{0}, .word = field.word, .op = Opcode::Patch});
        known->mask &= ~field.mask();
        known->value |= field.placed(value);
    };
    if (edge.from != edge.to) patch(layout_.locations[process.index], edge.to.index);
    for (std::uint32_t clock = 0; clock < automaton.clocks.size(); ++clock) {
        const Field& field = layout_.clocks[process.index][clock];
        const std::int64_t source = caps[edge.from.index][clock];
        const std::int64_t target = caps[edge.to.index][clock];
        if (source == ProcessClocks::dead) continue;
        if (resets(edge, {clock}) || target == ProcessClocks::dead) patch(field, 0);
        else if (target < source)
            next = compiler_.emit({.mask = field.mask(),
                                   .value = static_cast<Word>(target),
                                   .yes = next,
                                   .word = field.word,
                                   .shift = field.shift,
                                   .op = Opcode::Cap});
    }
    for (Instruction& instruction : patches) {
        instruction.yes = next;
        next = compiler_.emit(instruction);
    }
    const auto assign = [&](const std::vector<Network::Assignment>& assignments) {
        for (auto it = assignments.rbegin(); it != assignments.rend(); ++it)
            next =
                compiler_.assignment({static_cast<std::uint32_t>(network_.exprs[it->target].value)}, it->value, next);
    };
    for (auto call = edge.calls.rbegin(); call != edge.calls.rend(); ++call)
        assign(automaton.procedures[*call].assignments);
    assign(edge.assignments);
    return next;
}

}  // namespace grafverif::timed
