// SPDX-License-Identifier: MIT
#include "syntax/resolve/expand.hpp"

#include <algorithm>
#include <ranges>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/messages.hpp"

namespace grafverif {

namespace {

class Copier {
public:
    explicit Copier(Expansion& expansion)
        : expansion_(expansion),
          file_(expansion.file),
          copy_(expansion.copy),
          words_(copy_.words),
          size_(expansion.copied == nullptr ? own_size_ : *expansion.copied) {
        copy_.source = file_.source;
    }

    template <class Declaration>
    Declaration expanded(Declaration written) {
        part(written.name);
        if constexpr (requires { written.parameters; }) part(written.parameters);
        written.items = items(written.items);
        return written;
    }

private:
    using Op = tree::Op;

    struct Index {
        tree::Name name = {};
        Span where = {};  ///< position of the replication
        std::int64_t value = 0;
    };
    struct Bounds {
        std::int64_t low = 0, high = 0;
    };

    // -- replications -------------------------------------------------------------------------------------------------

    /// Counts elements of the copies. Returns false if the result is too large, which is reported once.
    bool count(Span where, std::uint64_t elements) {
        if (too_large_) return false;
        if (elements <= largest_expansion - size_) return size_ += elements, true;
        too_large_ = true;
        const InCopy outside(expansion_.diagnostics, copy_, 0);
        expansion_.diagnostics.add(messages::expansion_too_large(where, largest_expansion));
        return false;
    }

    void count_in_copy(std::uint64_t elements = 1) {
        if (!indices_.empty()) count(indices_.front().where, elements);
    }
    void count_text(std::size_t bytes) { count_in_copy(bytes / 64); }

    /// What follows from a range whose upper bound is one less than the lower bound.
    enum class Empty { IsError, IsAllowed };

    /// Calls `body` for each value of the index variable.
    template <class Body>
    void repeat(const tree::Replication& written, Empty empty, const Body& body) {
        declare(written.index, written.where);
        const auto bounds = bounds_of(written, empty);
        if (!bounds) return;
        for (std::int64_t value = bounds->low;; ++value) {
            indices_.push_back({written.index, written.where, value});
            body();
            indices_.pop_back();
            if (value == bounds->high || too_large_) return;
        }
    }

    void declare(tree::Name index, Span where) {
        const std::string_view name = file_.text(index);
        expansion_.record.declare(DeclarationKind::Constant, name, index.where, where, expansion_.owner);
        const InCopy outside(expansion_.diagnostics, copy_, 0);
        for (const Index& outer : indices_)
            if (outer.name.word == index.word)
                expansion_.diagnostics.add(
                    messages::duplicate_name(index.where, "index variable", name, outer.name.where));
        expansion_.indices.try_emplace(std::string(name), index.where);
    }

    /// Returns the range; nothing if it is empty or after an error. Beyond errors, there is one copy instead, whose
    /// names are recorded.
    std::optional<Bounds> bounds_of(const tree::Replication& written, Empty empty) {
        const std::string user = "the range of `" + std::string(file_.text(written.index)) + '`';
        const auto low = value_of(written.range.low, user), high = value_of(written.range.high, user);
        if (low && high && *low <= *high) {
            const std::uint64_t steps = static_cast<std::uint64_t>(*high) - static_cast<std::uint64_t>(*low);
            const Span where = indices_.empty() ? written.where : indices_.front().where;
            if (count(where, std::min(steps, largest_expansion) + 1)) return Bounds{*low, *high};
        } else if (low && high && (empty == Empty::IsError || *high != *low - 1)) {
            expansion_.diagnostics.add(
                messages::empty_replication(written.where, file_.text(written.index), *low, *high));
        }
        if (!expansion_.record.beyond_errors()) return {};
        return Bounds{low.value_or(1), low.value_or(1)};
    }

    /// Returns the value of a range bound or an index; empty after an error.
    std::optional<std::int64_t> value_of(Id<tree::Expr> written, std::string_view user) {
        const Id<tree::Expr> term = copied(written);
        if (copy_.exprs[term].op == Op::Number) return copy_.exprs[term].value;
        return expansion_.constant_terms(user).constant(term, TermKind::Integer, user);
    }

    /// Returns the value of an index variable; empty if `node` is not the name of one.
    std::optional<std::int64_t> value_of_index(const tree::Expr& node) {
        if (node.op != Op::Name || node.first.valid()) return {};
        for (const Index& index : indices_) {
            if (index.name.word != node.word) continue;
            expansion_.record.refer(node.where, index.name.where);
            return index.value;
        }
        return {};
    }

    /// Copies the owner in `owner.name` or `owner in name`. An index variable is an integer, which owns nothing.
    Id<tree::Expr> owner_of(Id<tree::Expr> written, Op op) {
        tree::Expr node = file_.exprs[written];
        if (!value_of_index(node)) return copied(written);
        expansion_.diagnostics.add(messages::type_mismatch(node.where, op == Op::In ? "`in`" : "`.`",
                                                           "the name of an instance, an observer or a chart",
                                                           "an integer"));
        count_in_copy();
        count_text(file_.text(node.word).size());
        node.word = words_.intern(file_.text(node.word));
        node.first = node.last = node.next = {};
        return copy_.exprs.add(node);
    }

    // -- names and terms ----------------------------------------------------------------------------------------------

    /// Returns the word of a name with its indices: `B[3]`.
    Id<tree::Word> indexed(Id<tree::Word> word, Id<tree::Expr> index) {
        count_text(file_.text(word).size());
        if (!index.valid()) return words_.intern(file_.text(word));
        std::string text(file_.text(word));
        for (; index.valid(); index = file_.exprs[index].next) {
            const auto value = value_of(index, "the index of `" + std::string(file_.text(word)) + '`');
            text += '[' + (value ? std::to_string(*value) : "?") + ']';
        }
        return words_.intern(text);
    }

    Id<tree::Expr> copied(Id<tree::Expr> written) {
        tree::Expr node = file_.exprs[written];
        count_in_copy();
        Id<tree::Expr> operand = std::exchange(node.first, {});
        node.last = node.next = {};
        if (node.op == Op::All || node.op == Op::Any) {
            node.op = node.op == Op::All ? Op::And : Op::Or;
            return junction(node, written);
        }
        if (const auto value = value_of_index(file_.exprs[written])) {
            node.op = Op::Number;
            node.value = *value;
            return copy_.exprs.add(node);
        }
        const bool owned = node.op == Op::Member || node.op == Op::In;
        const Id<tree::Expr> owner = owned ? owner_of(operand, node.op) : Id<tree::Expr>{};
        if (owned || node.op == Op::Name) {
            node.word = indexed(node.word, owned ? file_.exprs[operand].next : operand);
            operand = {};
        }
        const Id<tree::Expr> id = copy_.exprs.add(node);
        if (owned) append(copy_.exprs, id, owner);
        for (; operand.valid(); operand = file_.exprs[operand].next) append(copy_.exprs, id, copied(operand));
        return id;
    }

    /// Returns the conjunction or disjunction `node` of the terms of `all` or `any`. Without terms, it is a constant.
    Id<tree::Expr> junction(tree::Expr node, Id<tree::Expr> written) {
        std::vector<Id<tree::Expr>> operands;
        repeat_term(written, Empty::IsAllowed, operands);
        if (operands.size() == 1) return operands.front();
        if (operands.empty()) node.op = node.op == Op::And ? Op::True : Op::False;
        const Id<tree::Expr> id = copy_.exprs.add(node);
        for (const Id<tree::Expr> operand : operands) append(copy_.exprs, id, operand);
        return id;
    }

    void repeat_term(Id<tree::Expr> written, Empty empty, std::vector<Id<tree::Expr>>& operands) {
        const tree::Expr& node = file_.exprs[written];
        repeat(replication(file_, node), empty, [&] { operands.push_back(copied(node.last)); });
    }

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

    template <class Declaration, class Item>
    void add_one(const Declaration& written, std::vector<Item>& result) {
        if constexpr (requires { written.replication; }) {
            const std::uint32_t outer = copy_number_;
            const std::size_t outer_bytes = index_bytes_;
            index_bytes_ += file_.text(written.replication.index).size();
            repeat(written.replication, Empty::IsError, [&] {
                count_text(index_bytes_);
                copy_.copies.push_back({words_.intern(file_.text(written.replication.index)), indices_.back().value,
                                        written.replication.where, outer});
                copy_number_ = static_cast<std::uint32_t>(copy_.copies.size());
                const InCopy copy(expansion_.diagnostics, copy_, copy_number_);
                add(written.items, result);
            });
            copy_number_ = outer;
            index_bytes_ = outer_bytes;
        } else {
            count_in_copy();
            Declaration declaration = written;
            part(declaration);
            if constexpr (std::is_same_v<Declaration, tree::Variables>)
                if (expansion_.constants) expansion_.constants(declaration);
            result.push_back(std::move(declaration));
        }
    }

    // Each function `part` replaces the names and terms of a part of a declaration by those of the copy.

    template <class... Parts>
    void parts(Parts&... each) {
        (part(each), ...);
    }

    void part(tree::Name& name) {
        if (!name.valid()) return;
        count_in_copy();
        name = {indexed(name.word, name.index), name.where, {}, copy_number_};
    }
    void part(Id<tree::Expr>& term) {
        if (term.valid()) term = copied(term);
    }
    void part(std::vector<Id<tree::Expr>>& terms) {
        std::vector<Id<tree::Expr>> result;
        for (const Id<tree::Expr> term : terms)
            if (file_.exprs[term].op == Op::Each) repeat_term(term, Empty::IsError, result);
            else result.push_back(copied(term));
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
    void part(tree::Assignment& written) { parts(written.target, written.value); }
    void part(tree::Accept& written) {
        count_text(written.code.size() + written.subject.size() + written.reason.size());
    }

    void part(tree::ContinuousAction& written) {
        parts(written.output, written.condition, written.delay, written.limit);
    }
    void part(tree::StoredAction& written) { parts(written.assignment, written.event); }
    void part(tree::ForcingOrder& written) { parts(written.chart, written.steps); }
    void part(tree::Step& written) { parts(written.name, written.contents, written.actions); }
    void part(tree::Transition& written) {
        parts(written.name, written.from, written.to, written.condition, written.assignments);
    }
    void part(tree::Partial& written) {
        part(written.name);
        written.items = items(written.items);
    }

    void part(tree::Clocks& written) { part(written.names); }
    void part(tree::Location& written) { parts(written.name, written.invariant, written.values); }
    void part(tree::Edge& written) { parts(written.from, written.to, written.condition, written.assignments); }

    void part(tree::Controller& written) {
        parts(written.chart, written.cycle.least, written.cycle.most, written.options);
    }
    void part(tree::Grain& written) { part(written.name); }
    void part(tree::TimeUnit& written) { part(written.duration); }
    void part(tree::Schedule& written) { part(written.name); }
    void part(tree::Argument& written) { parts(written.parameter, written.value); }
    void part(tree::Instance& written) { parts(written.name, written.component, written.arguments, written.initial); }
    void part(tree::Fault& written) { parts(written.of, written.behaviour); }
    void part(tree::Property& written) {
        count_text(written.text.size() + written.raw.size());
        parts(written.name, written.operands, written.bound);
    }
    void part(tree::ObserverEdge& written) { parts(written.from, written.to, written.condition, written.assignments); }
    void part(tree::Observer& written) { parts(written.name, written.items); }

    Expansion& expansion_;
    const tree::File& file_;
    tree::File& copy_;
    tree::Words words_;
    std::vector<Index> indices_ = {};  ///< index variables of the enclosing replications
    std::uint32_t copy_number_ = 0;    ///< number of the current copy; 0 outside of replications
    std::size_t index_bytes_ = 0;      ///< length of the names in `indices_`, which the note on a copy lists
    std::uint64_t own_size_ = 0;
    std::uint64_t& size_;  ///< number of elements of the copies
    bool too_large_ = false;
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

/// Returns the values of the index variables of a copy, from the outermost to the innermost: `i = 1, k = 3`.
std::string values_of(const tree::File& file, std::uint32_t copy) {
    std::vector<const tree::Copy*> chain;
    for (; copy > 0; copy = chain.back()->outer) chain.push_back(&file.copies[copy - 1]);
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
        note = [&file, copy] { return messages::in_copy(file.copies[copy - 1].where, values_of(file, copy)); };
    outer_ = diagnostics.set_context(std::move(note));
}

InCopy::~InCopy() { diagnostics_->set_context(std::move(outer_)); }

}  // namespace grafverif
