// SPDX-License-Identifier: MIT
// NameCopier: copies names and terms of a chart, component or loop. In the copy, values replace index variables and
// constants, and variables replace ports (inputs and outputs of an instantiated chart). The copier counts the elements
// of the copies, because their number is limited. `expand` uses the copier for declarations.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/messages.hpp"
#include "syntax/resolve/expand.hpp"

namespace grafverif {

class NameCopier {
public:
    using Op = tree::Op;

    explicit NameCopier(Expansion& expansion)
        : words(expansion.copy.words),
          expansion_(expansion),
          copy_(expansion.copy),
          size_(expansion.copied == nullptr ? own_size_ : *expansion.copied) {
        frame.file = &expansion.file;
        frame.record = expansion.record;
        copy_.source = expansion.file.source;
    }

    struct Index {
        tree::Name name = {};
        Span where = {};  ///< position of the replication
        std::int64_t value = 0;
    };
    /// The replacement of a name in a chart: a variable (Op::Name) or the value of a constant.
    struct Value {
        Op op = Op::Name;
        std::int64_t value = 0;
        Id<tree::Word> word = {};
        Span where = {};           ///< position of the declaration or of the argument
        Id<tree::Expr> term = {};  ///< a step variable such as `line.X1`
    };
    /// The declarations that are copied, and the replacements of their names.
    struct Frame {
        const tree::File* file = nullptr;
        std::vector<Index> indices = {};
        Recorder record = {};
        ChartInstance* instance = nullptr;  ///< null outside of instances
        std::string_view chart = {};        ///< in an instance: the name of its chart
        bool partial = false;               ///< true if the instance is a partial chart
        std::map<std::string, Value, std::less<>> values = {};
        std::set<std::string, std::less<>> bound = {};  ///< variables that are bound to ports

        /// The internal variables of the chart, by name without indices. The position of a variable with indices is
        /// empty.
        std::map<std::string, Span, std::less<>> own = {};
        std::vector<tree::Variables> ports = {};   ///< result for a partial chart: its ports
        std::vector<std::string> parameters = {};  ///< the names of ports and constants
        std::vector<Diagnostic> errors = {};       ///< errors in the arguments
    };
    void count_in_copy(std::uint64_t elements = 1) {
        if (!frame.indices.empty() || frame.instance != nullptr) count(counted_at({}), elements);
    }
    void count_text(std::size_t bytes) { count_in_copy(bytes / 64); }

    /// Treatment of an empty range (the upper bound is one less than the lower bound).
    enum class Empty { IsError, IsAllowed };

    /// Calls `body` for each value of the index variable.
    template <class Body>
    void repeat(const tree::Replication& written, Empty empty, const Body& body) {
        declare(written.index, written.where);
        const auto bounds = bounds_of(written, empty);
        if (!bounds) return;
        for (std::int64_t value = bounds->low;; ++value) {
            frame.indices.push_back({written.index, written.where, value});
            body();
            frame.indices.pop_back();
            if (value == bounds->high || too_large) return;
        }
    }

    /// Returns the word of a name with the values of its indices, such as `B[3]`.
    Id<tree::Word> indexed(Id<tree::Word> word, Id<tree::Expr> index) {
        count_text(frame.file->text(word).size());
        if (!index.valid()) return words.intern(frame.file->text(word));
        std::string text(frame.file->text(word));
        for (; index.valid(); index = frame.file->exprs[index].next) {
            const auto value = value_of(index, "the index of `" + std::string(frame.file->text(word)) + '`');
            text += '[' + (value ? std::to_string(*value) : "?") + ']';
        }
        return words.intern(text);
    }

    Id<tree::Expr> copied(Id<tree::Expr> written) {
        tree::Expr node = frame.file->exprs[written];
        count_in_copy();
        Id<tree::Expr> operand = std::exchange(node.first, {});
        node.last = node.next = {};
        if (node.op == Op::All || node.op == Op::Any) {
            node.op = node.op == Op::All ? Op::And : Op::Or;
            return junction(node, written);
        }
        if (const auto value = value_of_index(frame.file->exprs[written])) {
            node.op = Op::Number;
            node.value = *value;
            return copy_.exprs.add(node);
        }
        const bool owned = node.op == Op::Member || node.op == Op::In;
        const Id<tree::Expr> owner = owned ? owner_of(operand, node.op) : Id<tree::Expr>{};
        if (owned || node.op == Op::Name) {
            node.word = indexed(node.word, owned ? frame.file->exprs[operand].next : operand);
            operand = {};
        }
        if (node.op == Op::Name) {
            const auto bound = frame.values.find(copy_.words[node.word].text);
            if (bound != frame.values.end() && bound->second.term.valid()) return copy_of(bound->second.term);
            if (bound == frame.values.end() && is_step_of_partial(node)) return step_of_partial(node);
            substitute(node);
        }
        const Id<tree::Expr> id = copy_.exprs.add(node);
        if (owned) append(copy_.exprs, id, owner);
        for (; operand.valid(); operand = frame.file->exprs[operand].next) append(copy_.exprs, id, copied(operand));
        return id;
    }

    /// Returns the word of the variable that replaces `word`; if no variable replaces it, returns `word`. A name in an
    /// instance never denotes a variable outside of the instance: `A[LAST]` is unknown if the chart does not declare
    /// it, even if an `A[3]` is bound to a port.
    Id<tree::Word> variable_for(Id<tree::Word> word) {
        const std::string_view name = copy_.words[word].text;
        const auto known = frame.values.find(name);
        if (known != frame.values.end()) return known->second.op == Op::Name ? known->second.word : word;
        return frame.partial || frame.bound.contains(name) ? own_variable(word) : word;
    }

    /// Returns the qualified name of an internal variable of the instance, such as `Head.N`.
    Id<tree::Word> own_variable(Id<tree::Word> word) {
        return words.intern(frame.instance->name + '.' + std::string(copy_.words[word].text));
    }

    void repeat_term(Id<tree::Expr> written, Empty empty, std::vector<Id<tree::Expr>>& operands) {
        const tree::Expr& node = frame.file->exprs[written];
        repeat(replication(*frame.file, node), empty, [&] { operands.push_back(copied(node.last)); });
    }

    Frame frame = {};
    tree::Words words;
    bool too_large = false;  ///< true if the error that the copies are too large has been reported

private:
    struct Bounds {
        std::int64_t low = 0, high = 0;
    };

    // -- replications -------------------------------------------------------------------------------------------------

    /// Counts elements of the copies. Returns false if the copies are too large; reports this error only once.
    bool count(Span where, std::uint64_t elements) {
        if (too_large) return false;
        if (elements <= largest_expansion - size_) return size_ += elements, true;
        too_large = true;
        const InCopy outside(expansion_.diagnostics, copy_, 0);
        expansion_.diagnostics.add(messages::expansion_too_large(where, largest_expansion));
        return false;
    }

    /// Returns the position of the outermost instance or replication; outside of copies, returns `where`.
    Span counted_at(Span where) const {
        if (frame.instance != nullptr) return frame.instance->where;
        return frame.indices.empty() ? where : frame.indices.front().where;
    }
    void declare(tree::Name index, Span where) {
        const std::string_view name = frame.file->text(index);
        frame.record.declare(DeclarationKind::Constant, name, index.where, where, expansion_.owner);
        const InCopy outside(expansion_.diagnostics, copy_, 0);
        for (const Index& outer : frame.indices)
            if (outer.name.word == index.word)
                expansion_.diagnostics.add(
                    messages::duplicate_name(index.where, "index variable", name, outer.name.where));
        if (frame.instance == nullptr) expansion_.indices.try_emplace(std::string(name), index.where);
    }

    /// Returns the bounds of a range, or nullopt if the range is empty or after an error. If the resolution continues
    /// after errors, returns a range with one value instead, so that the names in this copy are recorded.
    std::optional<Bounds> bounds_of(const tree::Replication& written, Empty empty) {
        const std::string user = "the range of `" + std::string(frame.file->text(written.index)) + '`';
        const auto low = value_of(written.range.low, user), high = value_of(written.range.high, user);
        if (low && high && *low <= *high) {
            const std::uint64_t steps = static_cast<std::uint64_t>(*high) - static_cast<std::uint64_t>(*low);
            if (count(counted_at(written.where), std::min(steps, largest_expansion) + 1)) return Bounds{*low, *high};
        } else if (low && high && (empty == Empty::IsError || *high != *low - 1)) {
            expansion_.diagnostics.add(
                messages::empty_replication(written.where, frame.file->text(written.index), *low, *high));
        }
        if (!frame.record.beyond_errors()) return {};
        return Bounds{low.value_or(1), low.value_or(1)};
    }

    /// Returns the value of a bound of a range, or of an index; empty after an error.
    std::optional<std::int64_t> value_of(Id<tree::Expr> written, std::string_view user) {
        const Id<tree::Expr> term = copied(written);
        if (copy_.exprs[term].op == Op::Number) return copy_.exprs[term].value;
        return expansion_.constant_terms(user).constant(term, TermKind::Integer, user);
    }

    /// Returns the value of the index variable that `node` denotes; empty if `node` does not denote an index variable.
    std::optional<std::int64_t> value_of_index(const tree::Expr& node) {
        if (node.op != Op::Name || node.first.valid()) return {};
        for (const Index& index : frame.indices) {
            if (index.name.word != node.word) continue;
            frame.record.refer(node.where, index.name.where);
            return index.value;
        }
        return {};
    }

    /// Copies the owner in `owner.name` or `owner in name`. Reports an error if the owner is an index variable, because
    /// an index variable is an integer.
    Id<tree::Expr> owner_of(Id<tree::Expr> written, Op op) {
        tree::Expr node = frame.file->exprs[written];
        if (!value_of_index(node) && node.op == Op::Name && frame.instance != nullptr) {
            count_in_copy();
            const bool is_chart = frame.partial && frame.file->text(node.word) == frame.chart;
            node.word = is_chart ? words.intern(frame.instance->name) : indexed(node.word, node.first);
            node.first = node.last = node.next = {};
            return copy_.exprs.add(node);
        }
        if (!value_of_index(node)) return copied(written);
        expansion_.diagnostics.add(messages::type_mismatch(node.where, op == Op::In ? "`in`" : "`.`",
                                                           "the name of an instance, an observer or a chart",
                                                           "an integer"));
        count_in_copy();
        count_text(frame.file->text(node.word).size());
        node.word = words.intern(frame.file->text(node.word));
        node.first = node.last = node.next = {};
        return copy_.exprs.add(node);
    }

    // -- names and terms ----------------------------------------------------------------------------------------------

    /// Returns a copy of a step variable such as `line.X1`, which is already a term of the result.
    Id<tree::Expr> copy_of(Id<tree::Expr> member) {
        tree::Expr node = copy_.exprs[member], owner = copy_.exprs[node.first];
        node.next = owner.next = {};
        const Id<tree::Expr> first = copy_.exprs.add(owner);
        node.first = node.last = first;
        count_in_copy();
        return copy_.exprs.add(node);
    }

    /// True for a step variable in the chart of an instance that is a partial chart.
    bool is_step_of_partial(const tree::Expr& node) const {
        const std::string_view name = copy_.words[node.word].text;
        return frame.partial && name.size() > 1 && name[0] == 'X' && !frame.own.contains(without_indices(name));
    }

    /// Returns the qualified step variable, such as `Head.X1` in the instance `Head`, because `X1` alone could denote a
    /// step of another partial chart.
    Id<tree::Expr> step_of_partial(tree::Expr node) {
        tree::Expr owner = node;
        owner.word = words.intern(frame.instance->name);
        node.op = Op::Member;
        const Id<tree::Expr> id = copy_.exprs.add(node);
        append(copy_.exprs, id, copy_.exprs.add(owner));
        count_in_copy();
        return id;
    }

    /// Replaces a name in `node` that denotes a port, a constant or an internal variable.
    void substitute(tree::Expr& node) {
        const auto known = frame.values.find(copy_.words[node.word].text);
        if (known == frame.values.end() || known->second.op == Op::Name) {
            node.word = variable_for(node.word);
            return;
        }
        frame.record.refer(node.where, known->second.where);
        node.op = known->second.op;
        node.value = known->second.value;
        node.word = {};
    }

    /// Expands `all` or `any` to a conjunction or disjunction. `node` has the operator of the result. Without operands,
    /// the result is a constant.
    Id<tree::Expr> junction(tree::Expr node, Id<tree::Expr> written) {
        std::vector<Id<tree::Expr>> operands;
        repeat_term(written, Empty::IsAllowed, operands);
        if (operands.size() == 1) return operands.front();
        if (operands.empty()) node.op = node.op == Op::And ? Op::True : Op::False;
        const Id<tree::Expr> id = copy_.exprs.add(node);
        for (const Id<tree::Expr> operand : operands) append(copy_.exprs, id, operand);
        return id;
    }

    Expansion& expansion_;
    tree::File& copy_;
    std::uint64_t own_size_ = 0;
    std::uint64_t& size_;  ///< number of elements of the copies
};

}  // namespace grafverif
