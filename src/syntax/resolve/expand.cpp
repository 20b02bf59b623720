// SPDX-License-Identifier: MIT
#include "syntax/resolve/expand.hpp"

#include <algorithm>
#include <ranges>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/messages.hpp"
#include "syntax/resolve/name_copier.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

class Copier {
public:
    explicit Copier(Expansion& expansion) : expansion_(expansion), copy_(expansion.copy), terms_(expansion) {}

    template <class Declaration>
    Declaration expanded(Declaration written) {
        part(written.name);
        if constexpr (requires { written.parameters; }) part(written.parameters);
        written.items = items(written.items);
        return written;
    }

    tree::Chart expanded(tree::Chart written) {
        ChartInstance* const instance = expansion_.instance;
        const std::string_view name = expansion_.file.text(written.name);
        const auto copy = [&] { written.items = chart_items(written); };
        if (instance == nullptr) {
            copy();
        } else {
            NameCopier::Frame frame{&expansion_.file, {}, expansion_.record.silent(), instance, name};
            internals(expansion_.file, written.items, frame.own);
            check_internals(frame);
            in_instance(std::move(frame), copy);
        }
        written.name = {terms_.words.intern(instance == nullptr ? name : instance->name), written.name.where};
        written.parameters.clear();
        if (instance != nullptr) {
            instance->too_large = terms_.too_large;
            expansion_.incomplete = expansion_.incomplete || instance->wrong;
        }
        return written;
    }

private:
    using Op = tree::Op;

    // -- declarations -------------------------------------------------------------------------------------------------

    template <class Item>
    std::vector<Item> items(const std::vector<Item>& written) {
        std::vector<Item> result;
        add(written, result);
        return result;
    }

    template <class Item>
    void add(const std::vector<Item>& written, std::vector<Item>& result) {
        for (const Item& item : written)
            std::visit([&](const auto& declaration) { add_one(declaration, result); }, item);
    }

    /// Adds a copy of a declaration of variables. In an instance, the ports (inputs and outputs) of the chart are bound
    /// to variables. If the instance is a partial chart, the ports are not declared; if it is a controller, they are
    /// declared with the names of the bound variables.
    void add_one(const tree::Variables& written, std::vector<tree::ChartItem>& result) {
        terms_.count_in_copy();
        tree::Variables declaration = written;
        const bool ports = terms_.frame.instance != nullptr && written.kind != tree::VariableKind::Internal;
        for (tree::Variable& each : declaration.variables) {
            part(each);
            if (ports) bind(each);
            else if (terms_.frame.partial) each.name.word = terms_.own_variable(each.name.word);
        }
        if (ports && terms_.frame.partial) terms_.frame.ports.push_back(std::move(declaration));
        else result.emplace_back(std::move(declaration));
    }

    /// Replaces the name of a port by the name of the bound variable. A bound step variable becomes the value of the
    /// port.
    void bind(tree::Variable& declaration) {
        tree::Name& port = declaration.name;
        ChartInstance& instance = *terms_.frame.instance;
        const std::string& name = terms_.frame.parameters.emplace_back(copy_.text(port));
        const auto given = instance.arguments.find(name);
        if (given == instance.arguments.end()) {
            terms_.frame.errors.push_back(
                messages::missing_argument(instance.chart_where, terms_.frame.chart, name, "NAME"));
            return;
        }
        given->second.used = true;
        instance.record.refer(given->second.parameter, port.where);
        port.where = given->second.where;
        if (given->second.is_term)
            terms_.frame.errors.push_back(messages::port_not_a_variable(given->second.where, name));
        port.word = terms_.words.intern(given->second.variable);
        if (given->second.term.valid()) declaration.value = given->second.term;
    }

    /// Resolves the constants of a chart. In the following declarations, their values replace their names.
    void constants(const std::vector<tree::Variables>& parameters) {
        for (const tree::Variables& group : parameters) {
            if (group.kind != tree::VariableKind::Constant) continue;
            for (tree::Variable variable : group.variables) {
                part(variable);
                constant(variable);
            }
        }
    }

    void constant(const tree::Variable& written) {
        const std::string name(copy_.text(written.name));
        terms_.frame.record.declare(DeclarationKind::Constant, name, written.name.where, written.where,
                                    expansion_.owner);
        const auto declared = declared_constant(copy_, written, expansion_.diagnostics, expansion_.constant_terms);
        if (const auto known = terms_.frame.values.find(name);
            known != terms_.frame.values.end() && known->second.op != Op::Name)
            expansion_.diagnostics.add(
                messages::duplicate_name(written.name.where, "constant", name, known->second.where));
        std::int64_t value = declared ? declared->value : 1;
        const TermKind kind = declared ? declared->kind : TermKind::Integer;
        if (terms_.frame.instance != nullptr && declared) value = value_given(name, written, *declared);
        const Op truth = value != 0 ? Op::True : Op::False;
        const Op op = kind == TermKind::Boolean ? truth : kind == TermKind::Integer ? Op::Number : Op::Duration;
        terms_.frame.values.insert_or_assign(name, NameCopier::Value{op, value, {}, written.name.where});
    }

    /// Returns the value of a constant in an instance: the argument or, without an argument, the declared value.
    std::int64_t value_given(const std::string& name, const tree::Variable& written, const DeclaredConstant& declared) {
        ChartInstance& instance = *terms_.frame.instance;
        terms_.frame.parameters.push_back(name);
        const auto given = instance.arguments.find(name);
        if (given == instance.arguments.end()) return declared.value;
        ChartInstance::Argument& argument = given->second;
        argument.used = true;
        instance.record.refer(argument.parameter, written.name.where);
        if (argument.kind == TermKind::Wrong) return declared.value;  // already reported
        if (argument.kind != declared.kind) {
            terms_.frame.errors.push_back(messages::type_mismatch(argument.where, '`' + name + '`',
                                                                  described(declared.kind), described(argument.kind)));
            return declared.value;
        }
        if (!declared.contains(argument.value))
            terms_.frame.errors.push_back(
                messages::out_of_range(argument.where, name, argument.value, declared.low, declared.high));
        instance.has_defaults = instance.has_defaults && argument.value == declared.value;
        return argument.value;
    }

    /// Returns the copied declarations of a chart, including its ports.
    std::vector<tree::ChartItem> chart_items(const tree::Chart& written) {
        constants(written.parameters);
        std::vector<tree::ChartItem> result;
        for (const tree::Variables& group : written.parameters)
            if (group.kind != tree::VariableKind::Constant) add_one(group, result);
        add(written.items, result);
        return result;
    }

    /// Calls `copy`, which copies the chart of an instance with `frame`. Then reports the errors in the arguments of
    /// the instance.
    template <class Copy>
    void in_instance(NameCopier::Frame frame, const Copy& copy) {
        const ChartInstance& instance = *frame.instance;
        const std::uint32_t outer = copy_number_;
        copy_.copies.push_back({terms_.words.intern(instance.name), 0, instance.where, outer, true, true});
        copy_number_ = static_cast<std::uint32_t>(copy_.copies.size());
        for (const auto& [port, argument] : instance.arguments)
            if (!argument.variable.empty()) {
                frame.values.emplace(port, NameCopier::Value{Op::Name, 0, terms_.words.intern(argument.variable),
                                                             argument.where, argument.term});
                frame.bound.insert(argument.variable);
            }
        std::swap(terms_.frame, frame);
        {
            const InCopy context(expansion_.diagnostics, copy_, copy_number_);
            copy();
        }
        copy_number_ = outer;
        std::swap(terms_.frame, frame);
        for (Diagnostic& error : frame.errors) expansion_.diagnostics.add(std::move(error));
        for (const auto& [name, argument] : instance.arguments)
            if (!argument.used && !terms_.too_large)
                expansion_.diagnostics.add(messages::unknown(
                    argument.parameter, "parameter", name,
                    expansion_.diagnostics.full() ? std::string() : nearest_of(name, frame.parameters)));
    }

    void add_one(const tree::Partial& written, std::vector<tree::ChartItem>& result) {
        terms_.count_in_copy();
        if (terms_.too_large) return;
        if (terms_.frame.partial) {
            terms_.frame.errors.push_back(
                messages::partial_in_partial(terms_.frame.instance->chart_where, terms_.frame.chart));
            return;
        }
        tree::Partial partial = written;
        part(partial);
        if (partial.chart.valid()) instantiate(written.chart, partial, result);
        else result.emplace_back(std::move(partial));
    }

    /// Copies the declarations of a chart to a partial chart that is an instance.
    void instantiate(tree::Name chart_name, tree::Partial& partial, std::vector<tree::ChartItem>& result) {
        const WrittenCharts none;
        const WrittenCharts& charts = expansion_.charts == nullptr ? none : *expansion_.charts;
        const WrittenCharts::Entry* const chart = charts.find(*terms_.frame.file, chart_name, expansion_.diagnostics);
        std::optional<ChartInstance> instance;
        if (chart != nullptr) {
            terms_.frame.record.refer(chart_name.where, chart->chart->name.where);
            instance =
                read_arguments({copy_, expansion_.diagnostics, expansion_.constant_terms}, partial.arguments, *chart);
        }
        expansion_.incomplete = expansion_.incomplete || !instance || instance->wrong;
        if (!instance) return;
        instance->name = copy_.text(partial.name);
        instance->where = partial.name.where;
        instance->chart_where = chart_name.where;
        instance->record = terms_.frame.record;
        NameCopier::Frame frame{
            chart->file, {}, terms_.frame.record.silent(), &*instance, chart->file->text(chart->chart->name), true};
        internals(*chart->file, chart->chart->items, frame.own);
        std::vector<tree::ChartItem> copies;
        in_instance(std::move(frame), [&] {
            copies = chart_items(*chart->chart);
            partial.ports = std::move(terms_.frame.ports);
        });
        for (tree::ChartItem& item : copies) {
            const bool inside =
                std::holds_alternative<tree::Step>(item) || std::holds_alternative<tree::Transition>(item);
            (inside ? partial.items : result).push_back(std::move(item));
        }
        result.emplace_back(std::move(partial));
    }

    /// Adds the names and positions of the internal variables in `items` to `names`.
    static void internals(const tree::File& file, const std::vector<tree::ChartItem>& items,
                          std::map<std::string, Span, std::less<>>& names) {
        for (const tree::ChartItem& item : items) {
            if (const auto* copies = std::get_if<tree::ReplicatedChartItems>(&item))
                internals(file, copies->items, names);
            const auto* group = std::get_if<tree::Variables>(&item);
            if (group == nullptr || group->kind != tree::VariableKind::Internal) continue;
            for (const tree::Variable& each : group->variables)
                names.emplace(file.text(each.name), each.name.index.valid() ? Span{} : each.name.where);
        }
    }

    /// Reports each variable of a closed loop that is bound to a controller with an internal variable of the same name.
    /// Without this error, name resolution would report the declaration and each use of the variable.
    void check_internals(const NameCopier::Frame& frame) {
        for (const auto& [port, argument] : frame.instance->arguments)
            if (const auto own = frame.own.find(argument.variable);
                own != frame.own.end() && own->second.source.valid())
                expansion_.diagnostics.add(
                    messages::duplicate_name(argument.where, "variable", argument.variable, own->second));
    }

    template <class Declaration, class Item>
    void add_one(const Declaration& written, std::vector<Item>& result) {
        if constexpr (requires { written.replication; }) {
            const std::uint32_t outer = copy_number_;
            const std::size_t outer_bytes = index_bytes_;
            index_bytes_ += terms_.frame.file->text(written.replication.index).size();
            terms_.repeat(written.replication, NameCopier::Empty::IsError, [&] {
                terms_.count_text(index_bytes_);
                copy_.copies.push_back({terms_.words.intern(terms_.frame.file->text(written.replication.index)),
                                        terms_.frame.indices.back().value, written.replication.where, outer, false,
                                        terms_.frame.instance != nullptr});
                copy_number_ = static_cast<std::uint32_t>(copy_.copies.size());
                const InCopy copy(expansion_.diagnostics, copy_, copy_number_);
                add(written.items, result);
            });
            copy_number_ = outer;
            index_bytes_ = outer_bytes;
        } else {
            terms_.count_in_copy();
            Declaration declaration = written;
            part(declaration);
            if constexpr (std::is_same_v<Declaration, tree::Variables>)
                if (expansion_.constants) expansion_.constants(declaration);
            result.push_back(std::move(declaration));
        }
    }

    // Each function `part` replaces the names and terms in a part of a declaration by the names and terms of the copy.

    template <class... Parts>
    void parts(Parts&... each) {
        (part(each), ...);
    }

    void part(tree::Name& name) {
        if (!name.valid()) return;
        terms_.count_in_copy();
        name = {terms_.indexed(name.word, name.index), name.where, {}, copy_number_};
    }
    void part(Id<tree::Expr>& term) {
        if (term.valid()) term = terms_.copied(term);
    }
    void part(std::vector<Id<tree::Expr>>& terms) {
        std::vector<Id<tree::Expr>> result;
        for (const Id<tree::Expr> term : terms)
            if (terms_.frame.file->exprs[term].op == Op::Each)
                terms_.repeat_term(term, NameCopier::Empty::IsError, result);
            else result.push_back(terms_.copied(term));
        terms = std::move(result);
    }
    template <class Part>
    void part(std::vector<Part>& list) {
        for (Part& each : list) part(each);
    }
    template <class... Alternatives>
    void part(std::variant<Alternatives...>& either) {
        std::visit([this](auto& written) { this->part(written); }, either);
    }
    void part(std::optional<tree::Range>& range) {
        if (range) parts(range->low, range->high);
    }

    void part(tree::Variable& written) { parts(written.name, written.range, written.value); }
    void part(tree::Variables& written) { part(written.variables); }
    void part(tree::Constraint& written) {
        part(written.condition);
        written.copy = copy_number_;
    }
    void part_of_variable(tree::Name& name) {
        part(name);
        if (name.valid()) name.word = terms_.variable_for(name.word);
    }
    void part(tree::Assignment& written) {
        part_of_variable(written.target);
        part(written.value);
    }
    void part(tree::Accept& written) {
        terms_.count_text(written.code.size() + written.subject.size() + written.reason.size());
        if (terms_.frame.instance == nullptr || (written.subject.empty() && !terms_.frame.partial)) return;
        written.subject_where = {};  // only the resolution of the chart itself records names
        const auto bound = terms_.frame.values.find(written.subject);
        // The subject of each of the following codes is a transition, not a variable.
        const bool variable = !written.code.starts_with("transition-") && written.code != "comes-once" &&
                              written.code != "branches-together";
        if (variable && bound != terms_.frame.values.end() && bound->second.op == Op::Name)
            written.subject = copy_.words[bound->second.word].text;
        else if (terms_.frame.partial) written.subject = terms_.frame.instance->name + '.' + written.subject;
    }

    void part(tree::ContinuousAction& written) {
        part_of_variable(written.output);
        parts(written.condition, written.delay, written.limit);
    }
    void part(tree::StoredAction& written) { parts(written.assignment, written.event); }
    void part(tree::ForcingOrder& written) { parts(written.chart, written.steps); }
    void part(tree::Step& written) { parts(written.name, written.contents, written.actions); }
    void part(tree::Transition& written) {
        parts(written.name, written.from, written.to, written.condition, written.assignments);
        if (terms_.frame.partial && written.name.valid())
            written.name.word =
                terms_.words.intern(terms_.frame.instance->name + '.' + std::string(copy_.text(written.name)));
    }
    void part(tree::Partial& written) {
        parts(written.name, written.chart, written.arguments);
        written.items = items(written.items);
    }

    void part(tree::Clocks& written) { part(written.names); }
    void part(tree::Location& written) { parts(written.name, written.invariant, written.values); }
    void part(tree::Edge& written) { parts(written.from, written.to, written.condition, written.assignments); }

    void part(tree::Controller& written) {
        parts(written.chart, written.instance, written.arguments, written.cycle.least, written.cycle.most);
        part(written.options);
    }
    void part(tree::Grain& written) { part(written.name); }
    void part(tree::TimeUnit& written) { part(written.duration); }
    void part(tree::Schedule& written) { part(written.name); }
    void part(tree::Argument& written) { parts(written.parameter, written.value); }
    void part(tree::Instance& written) { parts(written.name, written.component, written.arguments, written.initial); }
    void part(tree::Fault& written) { parts(written.of, written.behaviour); }
    void part(tree::Property& written) {
        terms_.count_text(written.text.size() + written.raw.size());
        parts(written.name, written.operands, written.bound);
    }
    void part(tree::ObserverEdge& written) { parts(written.from, written.to, written.condition, written.assignments); }
    void part(tree::Observer& written) { parts(written.name, written.items); }

    Expansion& expansion_;
    tree::File& copy_;
    NameCopier terms_;
    std::uint32_t copy_number_ = 0;  ///< number of the current copy; 0 outside of all copies
    std::size_t index_bytes_ = 0;    ///< total length of the names of the index variables around the current copy
};

}  // namespace

tree::Chart expanded(Expansion& expansion, const tree::Chart& written) { return Copier(expansion).expanded(written); }

tree::Component expanded(Expansion& expansion, const tree::Component& written) {
    return Copier(expansion).expanded(written);
}

tree::ClosedLoop expanded(Expansion& expansion, const tree::ClosedLoop& written) {
    return Copier(expansion).expanded(written);
}

void check_indices(const Expansion& expansion, const std::function<std::optional<Span>(std::string_view)>& declared) {
    for (const auto& [name, where] : expansion.indices)
        if (const auto other = declared(name)) expansion.diagnostics.add(messages::index_hides(where, name, *other));
}

namespace {

/// Returns the values of the index variables of a copy as text, from the outermost to the innermost, such as `i = 1, k
/// = 3`. The list excludes the index variables of the enclosing copy with the number `outer`; 0 excludes none.
std::string values_of(const tree::File& file, std::uint32_t copy, std::uint32_t outer) {
    std::vector<const tree::Copy*> chain;
    for (; copy > outer; copy = chain.back()->outer) chain.push_back(&file.copies[copy - 1]);
    std::string values;
    for (const tree::Copy* each : chain | std::views::reverse) {
        if (!values.empty()) values += ", ";
        values += std::string(file.text(each->index)) + " = " + std::to_string(each->value);
    }
    return values;
}

}  // namespace

Diagnostic duplicate(tree::Name name, std::string_view kind, std::string_view text, Span first) {
    const bool same = first.source == name.where.source && first.begin == name.where.begin;
    return name.copy > 0 && same ? messages::declared_in_copies(name.where, kind, text)
                                 : messages::duplicate_name(name.where, kind, text, first);
}

InCopy::InCopy(Diagnostics& diagnostics, const tree::File& file, tree::Name name)
    : InCopy(diagnostics, file, name.copy) {}

InCopy::InCopy(Diagnostics& diagnostics, const tree::File& file, std::uint32_t copy) : diagnostics_(&diagnostics) {
    Diagnostics::Context note;
    if (copy > 0)
        note = [&file, copy] {
            std::uint32_t instance = copy;
            while (instance > 0 && !file.copies[instance - 1].is_instance) instance = file.copies[instance - 1].outer;
            const std::string values = values_of(file, copy, instance);
            if (instance == 0) return messages::in_copy(file.copies[copy - 1].where, values);
            const tree::Copy& of = file.copies[instance - 1];
            return messages::in_instance(of.where, file.text(of.index), values);
        };
    outer_ = diagnostics.set_context(std::move(note));
}

InCopy::~InCopy() { diagnostics_->set_context(std::move(outer_)); }

}  // namespace grafverif
