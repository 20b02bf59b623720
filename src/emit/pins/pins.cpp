// SPDX-License-Identifier: MIT
#include "emit/pins/pins.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <vector>

#include "emit/pins/slots.hpp"
#include "support/printable.hpp"
#include "support/unique_names.hpp"
#include "syntax/print/constants.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::pins {

namespace {

constexpr std::size_t least_slots = 2;  // minimum number of state slots that pins2lts-dist requires

/// Returns the C operator for `op`. Arithmetic operators become functions that detect undefined values. Parentheses
/// avoid compiler warnings.
Spelling spelling(Op op) {
    switch (op) {
    case Op::Not: return {"!", uppaal_spelling(op).precedence, "(", ")"};
    case Op::Negate: return {"", 0, "negated(", ")"};
    case Op::Plus: return {",", 0, "sum(", ")"};
    case Op::Minus: return {",", 0, "difference(", ")"};
    case Op::Times: return {",", 0, "product(", ")"};
    case Op::Divide: return {",", 0, "quotient(", ")"};
    case Op::Modulo: return {",", 0, "remainder_of(", ")"};
    default: return uppaal_spelling(op);
    }
}

/// Returns `text`, in which `_` replaces the characters that are not allowed in a C string or comment.
std::string harmless(std::string_view text) {
    std::string result;
    for (const char character : printable(text)) {
        const bool plain = character >= ' ' && character <= '~' && character != '"' && character != '\\' &&
                           character != '*' && character != '?';
        result += plain ? character : '_';
    }
    return result;
}

class Writer {
public:
    Writer(const Network& network, std::ostream& out) : network_(network), slots_(network), out_(out) {
        for (const Id<Network::Process> process : network.processes.ids())
            for (const Id<Network::Edge> edge : slots_.automaton(process).edges.ids())
                if (!is_false(network.exprs, slots_.automaton(process).edges[edge].guard))
                    groups_.push_back({process, edge});
        UniqueNames names;
        const auto add = [&](const std::string& name, const std::string& suffix, Id<Expr> term, const Property& of) {
            labels_.push_back({names.fresh(identifier(name + suffix)), term, &of});
        };
        for (const Property& property : network.properties) add_labels(property, add);
    }

    void write() {
        write_head();
        write_moves();
        write_time();
        write_next();
        write_labels();
        write_model();
    }

private:
    struct Group {
        Id<Network::Process> process = {};
        Id<Network::Edge> edge = {};
    };
    struct Label {
        std::string name = {};
        Id<Expr> term = {};
        const Property* of = nullptr;
    };

    template <class Add>
    void add_labels(const Property& property, const Add& add) {
        Exprs& exprs = terms_;
        const auto& operands = property.operands;
        const auto settled = [&](Id<Expr> term) {
            return property.at_stable ? exprs.conjunction(network_.settled, term) : term;
        };
        switch (property.pattern) {
        case Pattern::Always: add(property.name, "", settled(exprs.negation(operands[0])), property); break;
        case Pattern::Never:
        case Pattern::Reachable: add(property.name, "", settled(operands[0]), property); break;
        case Pattern::ExactlyOneOf: {
            std::vector<Id<Expr>> alone;
            for (const Id<Expr> chosen : operands) {
                std::vector<Id<Expr>> terms;
                for (const Id<Expr> other : operands) terms.push_back(other == chosen ? other : exprs.negation(other));
                alone.push_back(exprs.conjunction(terms));
            }
            add(property.name, "", settled(exprs.negation(exprs.disjunction(alone))), property);
            break;
        }
        case Pattern::LeadsTo:
            add(property.name, "_p", settled(operands[0]), property);
            add(property.name, "_q", settled(operands[1]), property);
            break;
        case Pattern::Inevitable:
        case Pattern::AlwaysPossible: add(property.name, "_p", settled(operands[0]), property); break;
        case Pattern::ReachableAllSteps:
        case Pattern::NoDeadlock:
        case Pattern::NoTimelock:
        case Pattern::Watched:
        case Pattern::RawUppaal:
        case Pattern::RawCtl:
        case Pattern::RawLtl: break;
        }
    }

    std::string text(Id<Expr> term, const char* state) const {
        const LeafPrinter leaf = [&](std::ostream& out, const Expr& node) {
            if (node.op == Op::At) {
                const auto slot = slots_.locations[at_process(node)];
                if (slot) fmt::print(out, "({}[{}] == {})", state, *slot, at_location(node));
                else out << 1;
                return;
            }
            const auto index = static_cast<std::uint32_t>(node.value);
            if (slots_.variables[index]) fmt::print(out, "{}[{}]", state, *slots_.variables[index]);
            else out << network_.variables[{index}].initial;
        };
        return expr_text(terms_, term, spelling, leaf);
    }

    std::string name_of(const Group& group) const {
        const Network::Template& automaton = slots_.automaton(group.process);
        const Network::Edge& edge = automaton.edges[group.edge];
        return harmless(network_.processes[group.process].name + ": " + automaton.locations[edge.from].name + " -> " +
                        automaton.locations[edge.to].name);
    }

    void write_head();
    void write_moves();
    void write_move(std::size_t index, const Group& group);
    void write_time();
    void write_next();
    void write_labels();
    void write_model();
    void write_matrix(const char* name, const std::vector<SlotSet>& rows);

    const Network& network_;
    Exprs terms_ = network_.exprs;
    Slots slots_;
    std::ostream& out_;
    std::vector<Group> groups_ = {};
    std::vector<Label> labels_ = {};
};

void Writer::write_head() {
    fmt::print(out_, R"(/* {} as a model of LTSmin, by its partitioned next-state interface. One unit of time is {} ms.
 *
 * Build and search:
 *     cc -std=gnu11 -O2 -shared -fPIC -o model.so THIS_FILE
 *     pins2lts-mc model.so                  explores all states.
 *     pins2lts-sym --saturation=sat model.so
 *     pins2lts-mc --invariant='!P' model.so       checks the label P
 *
 * Each label is 1 in the states that violate its property (for `reachable`: that satisfy it); `NAME_p` and `NAME_q` are the
 * operands of a property of runs. `breaks_off` is 1 if a move takes a value out of its range or divides by zero. Such a
 * move has no successor here, so verdicts are valid only if no state has this label.
)",
               harmless(network_.name), network_.time_unit_ms);
    if (!network_.constants.empty()) fmt::print(out_, " * Constants: {}.\n *\n", constants_text(network_.constants));
    for (const Label& label : labels_) fmt::print(out_, " *     {}: {}\n", label.name, harmless(label.of->name));
    out_ << " */\n"
            "#include <limits.h>\n#include <stdbool.h>\n#include <stdint.h>\n#include <stdlib.h>\n#include "
            "<string.h>\n\n"
            "#include <ltsmin/pins.h>\n#include <ltsmin/pins-util.h>\n#include <ltsmin/dlopen-api.h>\n\n";
    fmt::print(out_, "char pins_plugin_name[] = \"{}\";\n\n", harmless(network_.name));
    fmt::print(out_, "enum {{ SLOTS = {}, SCRATCH = {}, GROUPS = {}, LABELS = {} }};\n\n",
               std::max(slots_.names.size(), least_slots), slots_.scratch, groups_.size() + 1, labels_.size() + 1);
    out_ << R"(/* Set if a term has no value, or a value leaves its range. */
static __thread bool broken;

static inline int64_t sum(int64_t a, int64_t b) { int64_t r; broken |= __builtin_add_overflow(a, b, &r); return r; }
static inline int64_t difference(int64_t a, int64_t b) { int64_t r; broken |= __builtin_sub_overflow(a, b, &r); return r; }
static inline int64_t product(int64_t a, int64_t b) { int64_t r; broken |= __builtin_mul_overflow(a, b, &r); return r; }
static inline int64_t negated(int64_t a) { return difference(0, a); }
static inline bool divides(int64_t a, int64_t b) { const bool does = b != 0 && (a != INT64_MIN || b != -1); broken |= !does; return does; }
static inline int64_t quotient(int64_t a, int64_t b) { return divides(a, b) ? a / b : 0; }
static inline int64_t remainder_of(int64_t a, int64_t b) { return divides(a, b) ? a % b : 0; }
static inline int within(int64_t value, int64_t low, int64_t high) {
    const bool outside = value < low || value > high;
    broken |= outside;
    return outside ? (int)low : (int)value;
}
static inline int capped(int value, int cap) { return value < cap ? value : cap; }

)";
}

void Writer::write_moves() {
    for (std::size_t i = 0; i < groups_.size(); ++i) write_move(i, groups_[i]);
}

void Writer::write_move(std::size_t index, const Group& group) {
    const Network::Template& automaton = slots_.automaton(group.process);
    const Network::Edge& edge = automaton.edges[group.edge];
    const auto& caps = slots_.caps[group.process.index].cap;
    const auto& clocks = slots_.clocks[group.process.index];
    fmt::print(out_, "/* {} */\nstatic bool may_{}(const int *s) {{\n    (void)s;\n", name_of(group), index);
    if (const auto slot = slots_.locations[group.process.index])
        fmt::print(out_, "    if (s[{}] != {}) return false;\n", *slot, edge.from.index);
    const std::vector<ClockInterval> tested = slots_.tested(group.process, edge);
    for (std::size_t clock = 0; clock < clocks.size(); ++clock) {
        const std::int64_t cap = std::max<std::int64_t>(caps[edge.from.index][clock], 0);
        const std::int64_t low = std::max<std::int64_t>(tested[clock].low, 0), high = std::min(tested[clock].high, cap);
        if (low > high) out_ << "    return false;\n";
        else if (low == 0 && high == cap) continue;
        else fmt::print(out_, "    if (s[{0}] < {1} || s[{0}] > {2}) return false;\n", *clocks[clock], low, high);
    }
    fmt::print(out_, "    return {};\n}}\n\n", text(edge.guard, "s"));

    fmt::print(out_, "static void move_{}(int *s) {{\n    (void)s;\n", index);
    for (const Network::Assignment& assignment : slots_.effect(group.process, edge)) {
        const auto target = static_cast<std::uint32_t>(network_.exprs[assignment.target].value);
        const Type& type = network_.variables[{target}].type;
        const std::string value = fmt::format("within({}, {}, {})", text(assignment.value, "s"), type.low, type.high);
        if (const auto slot = slots_.variables[target]) fmt::print(out_, "    s[{}] = {};\n", *slot, value);
        else fmt::print(out_, "    (void){};\n", value);
    }
    if (const auto slot = slots_.locations[group.process.index]; slot && edge.from != edge.to)
        fmt::print(out_, "    s[{}] = {};\n", *slot, edge.to.index);
    for (std::uint32_t clock = 0; clock < clocks.size(); ++clock) {
        const std::int64_t from = caps[edge.from.index][clock], to = caps[edge.to.index][clock];
        if (!clocks[clock] || from == ProcessClocks::dead) continue;
        const bool reset = resets(edge, {clock});
        if (reset || to == ProcessClocks::dead) fmt::print(out_, "    s[{}] = 0;\n", *clocks[clock]);
        else if (to < from) fmt::print(out_, "    s[{0}] = capped(s[{0}], {1});\n", *clocks[clock], to);
    }
    out_ << "}\n\n";
}

void Writer::write_time() {
    out_ << "/* True if an urgent edge can be taken, so time cannot pass. */\nstatic bool urgent(const int *s) {\n    "
            "(void)s;\n "
            "   bool "
            "is;\n    (void)is;\n";
    for (std::size_t i = 0; i < groups_.size(); ++i)
        if (slots_.automaton(groups_[i].process).edges[groups_[i].edge].urgent)
            fmt::print(out_, "    broken = false;\n    is = may_{}(s);\n    if (is && !broken) return true;\n", i);
    out_ << "    return false;\n}\n\n/* Lets one unit of time pass. False if time cannot pass. */\nstatic bool "
            "pass(int *s) {\n    (void)s;\n";
    for (const Id<Network::Process> id : network_.processes.ids()) {
        const Network::Template& automaton = slots_.automaton(id);
        const auto& clocks = slots_.clocks[id.index];
        for (const Id<Network::Location> location : automaton.locations.ids()) {
            const auto allowed = admitted(network_, automaton.locations[location].invariant, clocks.size());
            std::string ticks;
            for (std::size_t clock = 0; clock < clocks.size(); ++clock) {
                const std::int64_t cap = slots_.caps[id.index].cap[location.index][clock];
                if (cap == ProcessClocks::dead) continue;
                const bool bounded = allowed[clock].high < ClockInterval::unbounded;
                const std::int64_t greatest = std::max<std::int64_t>(allowed[clock].high, 0);
                if (!clocks[clock]) {
                    if (bounded && greatest == 0) ticks += "        return false;\n";
                    continue;
                }
                if (bounded) ticks += fmt::format("        if (s[{}] >= {}) return false;\n", *clocks[clock], greatest);
                ticks += fmt::format("        if (s[{0}] < {1}) ++s[{0}];\n", *clocks[clock], cap);
            }
            if (ticks.empty()) continue;
            if (const auto slot = slots_.locations[id.index])
                fmt::print(out_, "    if (s[{}] == {}) {{\n{}    }}\n", *slot, location.index, ticks);
            else fmt::print(out_, "    {{\n{}    }}\n", ticks);
        }
    }
    out_ << "    return true;\n}\n\n";
}

void Writer::write_next() {
    out_ << "typedef bool (*may_t)(const int *);\ntypedef void (*move_t)(int *);\nstatic const may_t may[] = {";
    for (std::size_t i = 0; i < groups_.size(); ++i) fmt::print(out_, "{}may_{},", i % 8 == 0 ? "\n    " : " ", i);
    out_ << "\n    0};\nstatic const move_t move[] = {";
    for (std::size_t i = 0; i < groups_.size(); ++i) fmt::print(out_, "{}move_{},", i % 8 == 0 ? "\n    " : " ", i);
    const std::string race = network_.race.valid() && slots_.variables[network_.race.index]
                                 ? fmt::format("    if (src[{}] != 0) return 0; /* a race of stored actions */\n",
                                               *slots_.variables[network_.race.index])
                                 : "";
    fmt::print(out_, R"(
    0}};

/* Writes the successor of `src` by a group into `next`. False if the group cannot move or has a model error. */
static bool step(int group, const int *src, int *next) {{
    memcpy(next, src, SLOTS * sizeof(int));
    memset(next + SLOTS, 0, SCRATCH * sizeof(int));
    if (group == GROUPS - 1) return !urgent(src) && pass(next);
    broken = false;
    if (!may[group](src) || broken) return false;
    move[group](next);
    return !broken;
}}

static int next_state(model_t model, int group, int *src, TransitionCB callback, void *context) {{
    (void)model;
{}    int next[SLOTS + SCRATCH + 1];
    if (!step(group, src, next)) return 0;
    int label[1] = {{group}};
    transition_info_t info = GB_TI(label, group);
    callback(context, &info, next, NULL);
    return 1;
}}

)",
               race);
}

void Writer::write_labels() {
    out_ << R"(/* 1 if some move has a model error. */
static int has_error(const int *s) {
    int next[SLOTS + SCRATCH + 1];
    for (int group = 0; group < GROUPS - 1; ++group) {
        if (!step(group, s, next) && broken) return 1;
    }
    return 0;
}

static int state_label(model_t model, int label, int *s) {
    (void)model;
    (void)s;
    switch (label) {
)";
    for (std::size_t i = 0; i < labels_.size(); ++i)
        fmt::print(out_, "    case {}: return {};\n", i, text(labels_[i].term, "s"));
    out_ << "    default: return has_error(s);\n    }\n}\n\n";
}

void Writer::write_matrix(const char* name, const std::vector<SlotSet>& rows) {
    fmt::print(out_, "/* For each row: its slots, then -1. */\nstatic const int {}[] = {{\n", name);
    for (const SlotSet& row : rows) {
        out_ << "    ";
        for (const Slot slot : row) out_ << slot << ", ";
        out_ << "-1,\n";
    }
    out_ << "    -1};\n\n";
}

void Writer::write_model() {
    std::vector<SlotSet> reads, writes, tested;
    for (const Group& group : groups_) {
        Reach found = reach(slots_, group.process, slots_.automaton(group.process).edges[group.edge]);
        reads.push_back(std::move(found.reads));
        writes.push_back(std::move(found.writes));
    }
    SlotSet all;
    for (Slot slot = 0; slot < slots_.names.size(); ++slot) all.insert(slot);
    Reach time = reach_of_time(slots_);
    reads.push_back(std::move(time.reads));
    writes.push_back(std::move(time.writes));
    for (const Label& label : labels_) tested.push_back(slots_.read_by(terms_, label.term));
    tested.push_back(std::move(all));
    write_matrix("reads", reads);
    write_matrix("writes", writes);
    write_matrix("tested", tested);
    const auto list = [&](const char* name, const auto& each) {
        fmt::print(out_, "static const char *const {}[] = {{\n", name);
        each();
        out_ << "    0};\n\n";
    };
    list("slot_names", [&] {
        for (const std::string& name : slots_.names) fmt::print(out_, "    \"{}\",\n", name);
        for (std::size_t slot = slots_.names.size(); slot < least_slots; ++slot)
            fmt::print(out_, "    \"nothing_{}\",\n", slot);
    });
    list("label_names", [&] {
        for (const Label& label : labels_) fmt::print(out_, "    \"{}\",\n", label.name);
        out_ << "    \"breaks_off\",\n";
    });
    list("move_names", [&] {
        UniqueNames unique;  // names must be unique, because LTSmin numbers chunks by value
        for (const Group& group : groups_) fmt::print(out_, "    \"{}\",\n", unique.fresh(name_of(group)));
        out_ << "    \"time passes\",\n";
    });
    out_ << "static const int initial[SLOTS] = {";
    for (const std::int64_t value : slots_.initial) out_ << value << ", ";
    out_ << R"(};

static matrix_t *matrix(int rows, const int *entry) {
    matrix_t *m = malloc(sizeof *m);
    dm_create(m, rows, SLOTS);
    for (int row = 0; row < rows; ++row, ++entry)
        for (; *entry >= 0; ++entry) dm_set(m, row, *entry);
    return m;
}

void pins_model_init(model_t model) {
    lts_type_t type = lts_type_create();
    int is_new;
    const int number = lts_type_put_type(type, "int", LTStypeSInt32, &is_new);
    const int truth = lts_type_put_type(type, "bool", LTStypeBool, &is_new);
    const int name = lts_type_put_type(type, "move", LTStypeEnum, &is_new);
    lts_type_set_state_length(type, SLOTS);
    for (int slot = 0; slot < SLOTS; ++slot) {
        lts_type_set_state_name(type, slot, slot_names[slot]);
        lts_type_set_state_typeno(type, slot, number);
    }
    lts_type_set_edge_label_count(type, 1);
    lts_type_set_edge_label_name(type, 0, "move");
    lts_type_set_edge_label_typeno(type, 0, name);
    lts_type_set_state_label_count(type, LABELS);
    for (int label = 0; label < LABELS; ++label) {
        lts_type_set_state_label_name(type, label, label_names[label]);
        lts_type_set_state_label_typeno(type, label, truth);
    }
    lts_type_validate(type);
    GBsetLTStype(model, type);
    for (int group = 0; group < GROUPS; ++group)
        pins_chunk_put_at(model, name, chunk_str((char *)move_names[group]), group);

    matrix_t *const read = matrix(GROUPS, reads), *const write = matrix(GROUPS, writes);
    matrix_t *const both = matrix(GROUPS, reads);
    const int *entry = writes;
    for (int group = 0; group < GROUPS; ++group, ++entry)
        for (; *entry >= 0; ++entry) dm_set(both, group, *entry);
    GBsetDMInfo(model, both);
    GBsetDMInfoRead(model, read);
    GBsetDMInfoMayWrite(model, write);
    GBsetDMInfoMustWrite(model, write);
    GBsetStateLabelInfo(model, matrix(LABELS, tested));
    int state[SLOTS];
    memcpy(state, initial, sizeof state);
    GBsetInitialState(model, state);
    GBsetNextStateLong(model, next_state);
    GBsetStateLabelLong(model, state_label);
}
)";
}

}  // namespace

void emit(const Network& network, std::ostream& out) {
    const Network flat = expand(network);
    Writer(flat, out).write();
}

}  // namespace grafverif::pins
