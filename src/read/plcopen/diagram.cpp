// SPDX-License-Identifier: MIT
#include "read/plcopen/diagram.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "read/plcopen/values.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "support/wording.hpp"

namespace grafverif {

namespace {

/// The formal parameters of a standard function whose inputs are not interchangeable.
struct Signature {
    std::string_view function = {};
    std::array<std::string_view, 3> inputs = {};
};
constexpr std::array<Signature, 2> signatures = {{{"SEL", {"G", "IN0", "IN1"}}, {"LIMIT", {"MN", "IN", "MX"}}}};

class Diagram : PlcopenValues {
public:
    Diagram(PlcopenReader& reader, const PlcopenNetwork& network, st::Unit& unit,
            const std::unordered_set<std::string>& functions)
        : PlcopenValues(reader, network), unit_(unit), functions_(functions) {
        for (std::size_t i = 0; i < network.elements.size(); ++i) numbers_.emplace(network.elements[i].hash_value(), i);
        for (const st::Variable& variable : unit.variables)
            types_.emplace(st::capitals(reader.file.text(variable.name)),
                           st::capitals(reader.file.text(variable.type.name)));
        marks_.resize(network.elements.size(), Mark::New);
        rungs_.resize(network.elements.size());
        find_rungs();
    }

    st::Block statements() {
        std::vector<std::size_t> order;
        std::size_t numbered = 0;
        for (std::size_t i = 0; i < network_.elements.size(); ++i) {
            const pugi::xml_node node = network_.elements[i];
            if (!is_accepted(node) || !is_statement(node)) continue;
            order.push_back(i);
            if (execution_order(node) > 0) ++numbered;
        }
        ordered_ = numbered > 0;
        if (ordered_ && numbered < order.size()) {
            reader_.refuse(reader_.xml.where(network_.body),
                           "a diagram in which only some elements have an execution order",
                           "give all elements an execution order, or none of them");
            return {};
        }
        const auto key = [&](std::size_t i) {
            const auto [x, y] = position(network_.elements[i]);
            if (ordered_) return std::tuple(execution_order(network_.elements[i]), Top(), y, x, i);
            return std::tuple(std::int64_t{0}, tops_[rungs_[i]], y, x, i);
        };
        std::ranges::sort(order, {}, key);
        for (const std::size_t i : order) execute(i, 0);
        return std::move(block_);
    }

private:
    enum class Mark : std::uint8_t { New, Open, Done };
    using Top = std::tuple<double, double, std::size_t>;  // y, x of a network's uppermost element; least element index

    // -- order --------------------------------------------------------------------------------------------------------

    static std::pair<double, double> position(pugi::xml_node node) {
        const auto number = [at = child(node, "position")](std::string_view name) {
            const double value = attribute(at, name).as_double();
            return std::isfinite(value) ? value : 0;  // NaN cannot be ordered
        };
        return {number("x"), number("y")};
    }

    static std::int64_t execution_order(pugi::xml_node node) {
        return std::int64_t{attribute(node, "executionOrderId").as_llong()};
    }

    std::size_t number(pugi::xml_node node) const { return numbers_.at(node.hash_value()); }

    /// Determines the network of each element, and the position of each network.
    void find_rungs() {
        std::vector<std::size_t> parents(network_.elements.size());
        std::iota(parents.begin(), parents.end(), std::size_t{0});
        const auto root = [&](std::size_t i) {
            while (parents[i] != i) i = parents[i] = parents[parents[i]];
            return i;
        };
        const auto join = [&](std::size_t i, pugi::xml_node point) {
            for (const pugi::xml_node& in : children(point, "connectionPointIn"))
                for (const pugi::xml_node& line : children(in, "connection")) {
                    const pugi::xml_node source = network_.find(value(line, "refLocalId"));
                    if (source && !is(source, "leftPowerRail") && !is(network_.elements[i], "rightPowerRail"))
                        parents[root(i)] = root(number(source));
                }
        };
        std::unordered_map<std::string, std::size_t> connectors;
        for (std::size_t i = 0; i < network_.elements.size(); ++i)
            if (is(network_.elements[i], "connector")) connectors.emplace(value(network_.elements[i], "name"), i);
        for (std::size_t i = 0; i < network_.elements.size(); ++i) {
            join(i, network_.elements[i]);
            const auto connector = connectors.find(value(network_.elements[i], "name"));
            if (is(network_.elements[i], "continuation") && connector != connectors.end())
                parents[root(i)] = root(connector->second);
            for (const std::string_view list : {"inputVariables", "inOutVariables"})
                for (const pugi::xml_node& pin : children(child(network_.elements[i], list), "variable")) join(i, pin);
        }
        tops_.resize(network_.elements.size(), {1e300, 1e300, network_.elements.size()});
        for (std::size_t i = 0; i < network_.elements.size(); ++i) {
            rungs_[i] = root(i);
            const auto [x, y] = position(network_.elements[i]);
            auto& [top, left, first] = tops_[rungs_[i]];
            if (std::pair(y, x) < std::pair(top, left)) std::tie(top, left) = std::pair(y, x);
            first = std::min(first, i);
        }
    }

    // -- elements -----------------------------------------------------------------------------------------------------

    /// True if the element has an effect and is supported. Reports an unsupported element.
    bool is_accepted(pugi::xml_node node) {
        const std::string_view kind = local_name(node.name());
        for (const std::string_view known : {"inVariable", "outVariable", "inOutVariable", "contact", "coil", "block",
                                             "connector", "continuation", "leftPowerRail", "rightPowerRail"})
            if (kind == known) return true;
        const bool is_remark = kind == "comment" || (kind == "vendorElement" && !child(node, "connectionPointIn"));
        if (!is_remark)
            reader_.refuse(reader_.xml.where(node), "a `" + std::string(kind) + "` in a diagram",
                           "write this network in Structured Text");
        return false;
    }

    static bool is_statement(pugi::xml_node node) {
        if (is(node, "coil") || is(node, "outVariable")) return true;
        if (is(node, "inOutVariable")) return is_connected(node);
        return is(node, "block") && !value(node, "instanceName").empty();
    }

    /// Adds the statement that represents an element. First adds the calls whose outputs the element reads.
    void execute(std::size_t i, std::size_t depth) {
        if (marks_[i] != Mark::New) return;
        const pugi::xml_node node = network_.elements[i];
        if (depth > deepest) {
            reader_.refuse(reader_.xml.where(node), "a chain of more than " + std::to_string(deepest) + " calls",
                           "assign an intermediate result to a variable");
            marks_[i] = Mark::Done;
            return;
        }
        marks_[i] = Mark::Open;
        const std::size_t outer = std::exchange(calls_, depth + 1);
        const std::size_t rung = std::exchange(rung_, rungs_[i]);
        const std::size_t current = std::exchange(current_, i);
        if (is(node, "block")) call(node);
        else if (is(node, "coil")) coil(node);
        else assign(node);
        current_ = current;
        rung_ = rung;
        calls_ = outer;
        marks_[i] = Mark::Done;
    }

    void add(st::Statement statement, pugi::xml_node node) {
        statement.where = reader_.xml.where(node);
        block_.push_back(reader_.file.statements.add(std::move(statement)));
    }

    /// Adds the statement `IF condition THEN statement END_IF`.
    void add_if(Id<st::Expr> condition, st::Statement statement, pugi::xml_node node) {
        const Span where = reader_.xml.where(node);
        statement.where = where;
        st::Branch branch{{condition}, {reader_.file.statements.add(std::move(statement))}, where};
        add({.kind = st::StatementKind::If, .branches = {std::move(branch)}}, node);
    }

    void assign(pugi::xml_node node) {
        const Id<st::Expr> from = passes_on(node) ? wired(node, 0, "this variable") : Id<st::Expr>{};
        const Id<st::Expr> flow = negated(node, from, is(node, "outVariable") ? "negated" : "negatedIn");
        const Id<st::Expr> to = reader_.expression(reader_.xml.text(child(node, "expression")));
        store(to, flow, node);
    }

    void store(Id<st::Expr> to, Id<st::Expr> from, pugi::xml_node node) {
        if (!to.valid() || !from.valid()) return;
        add({.kind = st::StatementKind::Assign, .target = to, .value = from}, node);
        write(to);
    }

    void coil(pugi::xml_node node) {
        Id<st::Expr> flow = wired(node, 0, "this coil");
        const Id<st::Expr> to = operand(node);
        if (!flow.valid() || !to.valid()) return;
        if (is_marked(node, "edge")) flow = edge_of(node, flow);
        const std::string storage = value(node, "storage");
        if (!is_marked(node, "storage")) return store(to, negated(node, flow), node);
        const bool sets = storage == "set";
        if ((!sets && storage != "reset") || reader_.flag(node, "negated")) {
            reader_.refuse(reader_.xml.where(node, "storage"), "the `storage` of this coil",
                           "write `set` or `reset`, and do not negate the coil");
            return;
        }
        const Id<st::Expr> state = reader_.make(sets ? st::Op::True : st::Op::False, {}, reader_.xml.where(node));
        add_if(flow, {.kind = st::StatementKind::Assign, .target = to, .value = state}, node);
        write(to);
    }

    // -- instances ----------------------------------------------------------------------------------------------------

    Id<st::Expr> named(const std::string& name, Span where) {
        const Id<st::Expr> id = reader_.make(st::Op::Name, {}, where);
        reader_.node(id).word = reader_.file.intern(name);
        return id;
    }

    Id<st::Expr> with_word(st::Op op, Id<st::Expr> operand, const std::string& word, Span where) {
        const Id<st::Expr> id = reader_.make(op, {operand}, where);
        reader_.node(id).word = reader_.file.intern(word);
        return id;
    }

    void call(pugi::xml_node node) {
        const Span where = reader_.xml.where(node, "instanceName");
        const std::string name = value(node, "instanceName");
        std::vector<Id<st::Expr>> parts = {named(name, where)};
        Id<st::Expr> enable;
        bool complete = true;
        for (const pugi::xml_node& each : children(child(node, "inputVariables"), "variable")) {
            if (!is_connected(each)) continue;  // an unconnected input keeps its value
            const std::string formal = value(each, "formalParameter");
            const Id<st::Expr> one = pin(each, 0);
            if (!one.valid()) complete = false;
            else if (st::capitals(formal) == "EN") enable = one;
            else parts.push_back(with_word(st::Op::Argument, one, formal, reader_.xml.where(each, "formalParameter")));
        }
        for (const pugi::xml_node& each : children(child(node, "inOutVariables"), "variable"))
            if (is_connected(each))
                reader_.refuse(reader_.xml.where(each), "a variable passed by reference in a diagram",
                               "use an input and an output of the block");
        check_type(node, name);
        if (!complete) return;
        st::Statement call{.kind = st::StatementKind::Call, .value = reader_.make(st::Op::Call, parts, where)};
        if (enable.valid()) add_if(enable, std::move(call), node);
        else add(std::move(call), node);
        written_[rung_].insert(st::capitals(name));
    }

    /// Reports a block whose type differs from the declared type of its instance.
    void check_type(pugi::xml_node node, const std::string& name) {
        const std::string type = st::capitals(value(node, "typeName"));
        if (const auto declared = types_.find(st::capitals(name)); declared != types_.end() && declared->second != type)
            reader_.diagnostics().add(messages::program_type_mismatch(
                reader_.xml.where(node, "typeName"), "the block of the instance `" + messages::clipped(name) + '`',
                '`' + messages::clipped(declared->second) + "`, the declared type of the instance",
                '`' + messages::clipped(type) + '`'));
    }

    /// Adds an instance of R_TRIG or F_TRIG that detects an edge of `clock`. Returns the output of the instance.
    Id<st::Expr> edge_of(pugi::xml_node node, Id<st::Expr> clock) {
        const std::string edge = value(node, "edge");
        const Span where = reader_.xml.where(node, "edge");
        if (edge != "rising" && edge != "falling") {
            reader_.refuse(where, "this value of `edge`", "write `rising` or `falling`");
            return {};
        }
        const std::string name = "edge@" + value(node, "localId") + "@" + std::to_string(unit_.variables.size());
        st::Variable instance;
        instance.name = reader_.name(name, where);
        instance.type.name = reader_.name(edge == "rising" ? "R_TRIG" : "F_TRIG", where);
        instance.where = where;
        unit_.variables.push_back(std::move(instance));
        const Id<st::Expr> argument = with_word(st::Op::Argument, clock, "CLK", where);
        add({.kind = st::StatementKind::Call,
             .value = reader_.make(st::Op::Call, {named(name, where), argument}, where)},
            node);
        edges_.emplace(node.hash_value(), name);
        return with_word(st::Op::Member, named(name, where), "Q", where);
    }

    Id<st::Expr> other_element(pugi::xml_node node, std::size_t depth) override {
        if (is(node, "coil")) return wired(node, depth, "this coil");  // a coil has the value of its incoming line
        if (is(node, "outVariable")) return wired(node, depth, "this variable");
        if (is(node, "contact") && !is_marked(node, "storage")) return edge_contact(node, depth);
        reader_.refuse(reader_.xml.where(node),
                       "a `" + std::string(local_name(node.name())) + "` as the source of a connection",
                       "write this network in Structured Text");
        return {};
    }

    Id<st::Expr> edge_contact(pugi::xml_node node, std::size_t depth) {
        if (reader_.flag(node, "negated")) {
            reader_.refuse(reader_.xml.where(node, "negated"), "a negated contact with an edge",
                           "assign the negated value to a variable, and use a contact of this variable");
            return {};
        }
        const Span where = reader_.xml.where(node);
        Id<st::Expr> own;
        if (const auto known = edges_.find(node.hash_value()); known != edges_.end()) {
            own = with_word(st::Op::Member, named(known->second, where), "Q", where);
        } else {
            const Id<st::Expr> term = operand(node);
            if (!term.valid()) return {};
            is_read(term);
            own = edge_of(node, term);
        }
        const Id<st::Expr> before = wired(node, depth, "this contact");
        return own.valid() && before.valid() ? reader_.make(st::Op::And, {before, own}, where) : Id<st::Expr>{};
    }

    Id<st::Expr> other_block(pugi::xml_node node, const std::string& output, std::size_t depth) override {
        if (value(node, "instanceName").empty()) return function(node, output, depth);
        if (!ordered_ && number(node) != current_) {
            if (marks_[number(node)] == Mark::Open)
                return unsupported(node, "a cycle of calls without an execution order");
            execute(number(node), calls_);
        }
        std::string formal = output;
        pugi::xml_node from;
        for (const pugi::xml_node& each : children(child(node, "outputVariables"), "variable")) {
            const std::string name = value(each, "formalParameter");
            if (from || (formal.empty() ? st::capitals(name) == "ENO" : st::capitals(name) != st::capitals(formal)))
                continue;
            from = each;
            formal = name;
        }
        if (!from) return unsupported(node, "a connection to an output that this block does not have");
        if (!passes_on(from)) return {};
        if (st::capitals(formal) == "ENO") {
            for (const pugi::xml_node& each : children(child(node, "inputVariables"), "variable"))
                if (st::capitals(value(each, "formalParameter")) == "EN" && is_connected(each))
                    return negated(from, pin(each, depth));
            return negated(from, reader_.make(st::Op::True, {}, reader_.xml.where(from)));
        }
        const Span where = reader_.xml.where(node, "instanceName");
        return negated(from, with_word(st::Op::Member, named(value(node, "instanceName"), where), formal, where));
    }

    /// Adds a call of a function of the project or of the standard.
    Id<st::Expr> function(pugi::xml_node node, const std::string& output, std::size_t depth) {
        const std::string type = st::capitals(value(node, "typeName"));
        const bool of_project = functions_.contains(type);
        const Span where = reader_.xml.where(node, "typeName");
        std::vector<Id<st::Expr>> parts = {named(value(node, "typeName"), where)};
        const auto* const signature = std::ranges::find(signatures, type, &Signature::function);
        std::size_t index = 0;
        for (const pugi::xml_node& each : children(child(node, "inputVariables"), "variable")) {
            const std::string formal = value(each, "formalParameter");
            const bool connected = is_connected(each);
            if (st::capitals(formal) == "EN") {
                if (connected) return unsupported(node, "a function with a separate enable condition");
                continue;
            }
            if (signature != signatures.end() && !of_project &&
                (index >= 3 || st::capitals(formal) != signature->inputs[index]))
                return unsupported(node, "the input `" + formal + "` of the function `" + type + "`");
            ++index;
            const Id<st::Expr> one = pin(each, depth);
            if (!one.valid()) return {};
            parts.push_back(of_project ? with_word(st::Op::Argument, one, formal, where) : one);
        }
        if (st::capitals(output) == "ENO") return unsupported(node, "the output `ENO` of a function");
        for (const pugi::xml_node& each : children(child(node, "outputVariables"), "variable")) {
            const std::string formal = value(each, "formalParameter");
            if (st::capitals(formal) == "ENO" || (!output.empty() && formal != output)) continue;
            if (!formal.empty() && st::capitals(formal) != "OUT" && st::capitals(formal) != type)
                return unsupported(node, "a function output other than the result");
            return passes_on(each) ? negated(each, reader_.make(st::Op::Call, parts, where)) : Id<st::Expr>{};
        }
        return unsupported(node, "a connection to an output that this block does not have");
    }

    // -- variables ----------------------------------------------------------------------------------------------------

    /// Returns the names of the variables in a term, in capital letters.
    std::vector<std::string> variables(Id<st::Expr> term) const {
        std::vector<std::string> found;
        std::vector<Id<st::Expr>> open = {term};
        while (!open.empty()) {
            const Id<st::Expr> id = open.back();
            open.pop_back();
            if (reader_.file.exprs[id].op == st::Op::Name)
                found.push_back(st::capitals(reader_.file.text(reader_.file.exprs[id].word)));
            for (const Id<st::Expr> each : st::operands(reader_.file, id)) open.push_back(each);
        }
        return found;
    }

    void write(Id<st::Expr> to) {
        for (std::string& name : variables(to)) written_[rung_].insert(std::move(name));
    }

    void is_read(Id<st::Expr> term) override {
        if (ordered_) return;
        const auto written = written_.find(rung_);
        if (written == written_.end()) return;
        for (const std::string& name : variables(term))
            if (written->second.contains(name))
                return reader_.refuse(reader_.file.exprs[term].where,
                                      "a variable that one network first assigns and then reads",
                                      "use a network for each assignment, or give the elements an execution order");
    }

    st::Unit& unit_;
    const std::unordered_set<std::string>& functions_;
    std::unordered_map<std::size_t, std::size_t> numbers_ = {};  // for each node: index of the element
    // Type of each variable. The key is the name in capital letters.
    std::unordered_map<std::string, std::string> types_ = {};
    std::vector<Mark> marks_ = {};
    std::vector<std::size_t> rungs_ = {};  // for each element: its network
    std::vector<Top> tops_ = {};
    // For each network: the variables that its elements have assigned so far.
    std::unordered_map<std::size_t, std::unordered_set<std::string>> written_ = {};
    std::unordered_map<std::size_t, std::string> edges_ = {};  // R_TRIG or F_TRIG of each contact or coil
    bool ordered_ = false;
    std::size_t rung_ = 0, calls_ = 0, current_ = 0;
    st::Block block_ = {};
};

}  // namespace

st::Block statements_of(PlcopenReader& reader, st::Unit& unit, pugi::xml_node diagram,
                        const std::unordered_set<std::string>& functions) {
    const PlcopenNetwork network = network_of(reader, diagram);
    return Diagram(reader, network, unit, functions).statements();
}

}  // namespace grafverif
