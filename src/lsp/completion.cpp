// SPDX-License-Identifier: MIT
#include "lsp/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <set>

#include "grafverif/ir/finding.hpp"
#include "lsp/library.hpp"
#include "lsp/program_completion.hpp"
#include "lsp/scan.hpp"
#include "support/overloaded.hpp"

namespace grafverif::lsp {

namespace {

using Words = std::vector<std::string>;

bool contains_word(const Words& words, std::string_view word) { return std::ranges::find(words, word) != words.end(); }

}  // namespace

ProposalKind kind_of(DeclarationKind kind) {
    switch (kind) {
    case DeclarationKind::Chart:
    case DeclarationKind::Loop:
    case DeclarationKind::Partial: return ProposalKind::Module;
    case DeclarationKind::Component:
    case DeclarationKind::Unit:
    case DeclarationKind::DataType: return ProposalKind::Class;
    case DeclarationKind::Input:
    case DeclarationKind::Output:
    case DeclarationKind::Internal:
    case DeclarationKind::Own:
    case DeclarationKind::Clock:
    case DeclarationKind::Instance:
    case DeclarationKind::PlantVariable: return ProposalKind::Variable;
    case DeclarationKind::Step: return ProposalKind::Event;
    case DeclarationKind::Transition:
    case DeclarationKind::Action: return ProposalKind::Function;
    case DeclarationKind::InputParameter:
    case DeclarationKind::OutputParameter: return ProposalKind::Field;
    case DeclarationKind::Constant: return ProposalKind::Constant;
    case DeclarationKind::Location:
    case DeclarationKind::EnumerationValue: return ProposalKind::EnumMember;
    case DeclarationKind::Property:
    case DeclarationKind::Fault:
    case DeclarationKind::Observer: return ProposalKind::Property;
    }
    unreachable();
}

namespace {

class Proposer {
public:
    Proposer(const Names& names, IncompleteDeclaration half) : names_(names), half_(std::move(half)) {}

    std::vector<Proposal> all() {
        if (!half_.in_text) propose();
        return std::move(found_);
    }

private:
    using List = std::vector<const Declaration*>;

    const std::string& last() const {
        static const std::string none;
        return half_.words.empty() ? none : half_.words.back();
    }
    bool has(std::string_view word) const { return contains_word(half_.words, word); }

    void keywords(std::initializer_list<const char*> words) {
        for (const char* const word : words) add({word, ProposalKind::Keyword, "", "", ""});
    }
    void add(Proposal proposal) {
        if (seen_.insert(proposal.label).second) found_.push_back(std::move(proposal));
    }
    void element(const Declaration& element, std::string_view prefix = "") {
        add({std::string(prefix) + element.name, kind_of(element.kind), declaration_text(element),
             comment_of(*element.file, element.whole), ""});
    }
    /// Proposes the elements of `owner` that have one of the `kinds`. If `owner` is null, proposes nothing.
    void parts(const Declaration* owner, std::initializer_list<DeclarationKind> kinds, std::string_view prefix = "") {
        for (const Declaration* const part : owner == nullptr ? List() : names_.parts(owner))
            if (std::ranges::find(kinds, part->kind) != kinds.end()) element(*part, prefix);
    }
    /// Proposes the steps of the partial chart `partial` of `chart`. If `chart` has no such partial chart, proposes the
    /// steps of `chart`.
    void steps(const Declaration* chart, std::string_view partial, std::string_view prefix) {
        const Declaration* const found = names_.part(chart, partial, {DeclarationKind::Partial});
        parts(found == nullptr ? chart : found, {DeclarationKind::Step}, prefix);
    }
    void all_steps(const Declaration* chart, std::string_view prefix) {
        parts(chart, {DeclarationKind::Step}, prefix);
        for (const Declaration* const part : chart == nullptr ? List() : names_.parts(chart))
            if (part->kind == DeclarationKind::Partial) parts(part, {DeclarationKind::Step}, prefix);
    }
    List controllers() const { return names_.referred(owner_, DeclarationKind::Chart); }

    // -- cursor positions ---------------------------------------------------------------------------------------------

    void propose() {
        if (half_.blocks.empty()) return in_file();
        const Words& top = half_.blocks.front();
        const Words& inner = half_.blocks.back();
        if (top.size() < 2 || inner.size() < 2) return;
        for (const Words& block : half_.blocks)
            if (block.size() > 1 && (block[0] == "partial" || block[0] == "expansion")) partial_ = block[1];
        if (top[0] == "grafcet") {
            owner_ = names_.find(DeclarationKind::Chart, top[1]);
            if (in_index_or_range()) return index_or_range();
            if (contains_word(inner, "force")) return steps(owner_, inner[1], ""), keywords({"INIT"});
            return contains_word(inner, "step") ? in_actions() : in_chart();
        }
        if (top[0] == "component") {
            owner_ = names_.find(DeclarationKind::Component, top[1]);
            return in_index_or_range() ? index_or_range() : in_component();
        }
        if (top[0] != "closed_loop") return;
        owner_ = names_.find(DeclarationKind::Loop, top[1]);
        if (in_index_or_range()) return index_or_range();
        if (inner[0] == "observer") return in_observer(inner[1]);
        if (contains_word(inner, "of")) return term();
        in_loop();
    }

    bool in_index_or_range() const { return has("[") || (!half_.words.empty() && half_.words[0] == "for"); }
    void index_or_range() {
        if (has("[") || half_.words.size() > 2) parts(owner_, {DeclarationKind::Constant});
        else if (half_.words.size() == 2) keywords({"in"});
    }

    void in_file() {
        if (half_.words.empty()) return keywords({"grafcet", "component", "closed_loop", "program", "include"});
        if ((half_.words[0] != "component" && half_.words[0] != "grafcet") || !has("(")) return;
        if (last() == "(" || last() == ";") return keywords({"input", "output"});
        if (last() == ":") keywords({"bool", "int", "duration"});
    }

    void in_chart() {
        const Words& words = half_.words;
        if (words.empty())
            return keywords({"input", "output", "internal", "initial step", "step", "macro step", "enclosing step",
                             "entry step", "exit step", "linked step", "transition", "partial", "expansion",
                             "constraint", "accept", "for"});
        if (words[0] == "constraint") return term();
        if (words[0] == "partial" && chart_instance()) return;
        if (words[0] == "accept" && words.size() == 1)
            for (const FindingKind& kind : finding_kinds())
                add({std::string(kind.code), ProposalKind::Constant, "", std::string(kind.meaning), ""});
        if (words[0] == "input" || words[0] == "output" || words[0] == "internal") return typed();
        if (last() == "expands" || last() == "encloses") return parts(owner_, {DeclarationKind::Partial});
        if (words[0] == "transition") return links([this] { steps(owner_, partial_, ""); });
        if (is_keyword(last()) && last() != "step") keywords({"step"});
        else if (has("macro") && last() != "step") keywords({"expands"});
        else if (has("enclosing") && last() != "step") keywords({"encloses"});
    }

    void typed() {
        if (last() == ":") keywords({"bool", "int"});
        if (last() == "=") keywords({"true", "false"});
    }

    /// Proposes continuations of an incomplete edge or transition `[NAME:] FROM -> TO when TERM do TARGET := TERM`.
    template <class Ends>
    void links(Ends ends) {
        if (has("do")) return assignments();
        if (has("when")) return term(), keywords({"do"});
        if (last() == "->" || last() == ":" || last() == "," || half_.words.size() == 1) return ends();
        if (has("->")) keywords({"when", "do"});
    }

    void assignments() {
        if (last() == "do" || last() == "," || last() == "with")
            return parts(owner_, {DeclarationKind::Output, DeclarationKind::Internal, DeclarationKind::OutputParameter,
                                  DeclarationKind::Own, DeclarationKind::Clock});
        if (has(":=")) term();
    }

    void in_actions() {
        if (half_.words.empty())
            return parts(owner_, {DeclarationKind::Output, DeclarationKind::Internal}), keywords({"force"});
        if (half_.words[0] == "force") {
            if (half_.words.size() == 1) parts(owner_, {DeclarationKind::Partial});
            return;
        }
        if (last() == "on") return keywords({"activation", "deactivation", "event"});
        if (has(":=")) {
            term();
            if (last() != ":=") keywords({"on"});
        } else if (has("if") || has("after") || has("for")) {
            term();
            keywords({"after", "for"});
        } else keywords({"if", "after", "for"});
    }

    void in_component() {
        if (half_.words.empty())
            return keywords(
                {"initial location", "location", "urgent", "timed", "variable", "clock", "constraint", "for"});
        const std::string& first = half_.words[0];
        if (first == "urgent" || first == "timed") return links([this] { parts(owner_, {DeclarationKind::Location}); });
        if (first == "variable") return typed();
        if (first == "constraint" || has("invariant")) return term(), keywords({"with"});
        if (has("with")) return assignments();
        if (first == "initial" && half_.words.size() == 1) return keywords({"location"});
        if (has("location") && last() != "location") keywords({"invariant", "with"});
    }

    void in_observer(const std::string& name) {
        const auto locations = [&] {
            parts(names_.part(owner_, name, {DeclarationKind::Observer}), {DeclarationKind::Location});
        };
        if (half_.words.empty()) return keywords({"location", "initial location"}), locations();
        if (half_.words[0] != "location" && half_.words[0] != "initial") links(locations);
    }

    void in_loop() {
        const Words& words = half_.words;
        if (words.empty())
            return keywords({"controller", "plant", "environment", "property", "constraint", "constant", "grain",
                             "time unit", "schedule", "observer", "fault", "for"});
        const std::string& first = words[0];
        if (first == "controller" && !chart_instance()) {
            if (has("with")) return keywords({"stability_search", "every_cycle"});
            if (has("every")) return parts(owner_, {DeclarationKind::Constant}), keywords({"with"});
            if (words.size() > 1) return keywords({"every", "with"});
            for (const Declaration* const chart : names_.all(DeclarationKind::Chart)) element(*chart);
        }
        if (first == "constant") return constants();
        if (first == "grain") keywords({"phased", "atomic"});
        if (first == "schedule") keywords({"interleaved", "synchronous", "sequenced"});
        if (first == "time") return words.size() == 1 ? keywords({"unit"}) : parts(owner_, {DeclarationKind::Constant});
        if (first == "constraint") term();
        if (first == "plant" || first == "environment") instance(3);
        if (first == "fault") fault();
        if (first == "property") property();
    }

    /// Proposes continuations of `controller NAME = CHART(...` and `partial NAME = CHART(...`. Returns false at all
    /// other positions.
    bool chart_instance() {
        const Words& words = half_.words;
        const auto is = std::ranges::find(words, "=");
        if (is == words.end() || has(")")) return false;
        if (std::next(is) == words.end()) {
            for (const Declaration* const chart : names_.all(DeclarationKind::Chart)) element(*chart);
        } else if (last() == "(" || last() == ",") {
            const Declaration* const chart = names_.find(DeclarationKind::Chart, *std::next(is));
            for (const Declaration* const part : chart == nullptr ? List() : names_.parts(chart))
                if (is_port(*part) && !contains_word(words, part->name))
                    add({part->name, kind_of(part->kind), declaration_text(*part), comment_of(*part->file, part->whole),
                         part->name + " = $1"});
        } else if (last() == "=") {
            if (owner_ != nullptr && owner_->kind == DeclarationKind::Loop) shared();
            parts(owner_, {DeclarationKind::Input, DeclarationKind::Output, DeclarationKind::Internal,
                           DeclarationKind::Partial, DeclarationKind::Constant, DeclarationKind::Instance});
        }
        return true;
    }
    static bool is_port(const Declaration& part) {
        return part.kind == DeclarationKind::Input || part.kind == DeclarationKind::Output ||
               part.kind == DeclarationKind::Constant;
    }

    /// Proposes continuations of an incomplete declaration `fault NAME of INSTANCE: COMPONENT(...)`.
    void fault() {
        if (half_.words.size() == 2) keywords({"of"});
        if (half_.words.size() == 3) parts(owner_, {DeclarationKind::Instance});
        if (half_.words.size() == 5) components();
        instance(5);
    }

    /// Proposes continuations of an incomplete instance. `component` is the index of the word that names its component.
    void instance(std::size_t component) {
        const Words& words = half_.words;
        if (words.size() <= component) {
            if (last() == "=") components();
            return;
        }
        const Declaration* const own = names_.find(DeclarationKind::Component, words[component]);
        const Names& where = own != nullptr ? names_ : library_names();
        const Declaration* const whole =
            own != nullptr ? own : where.find(DeclarationKind::Component, words[component]);
        if (last() == "initially") {
            for (const Declaration* const part : whole == nullptr ? List() : where.parts(whole))
                if (part->kind == DeclarationKind::Location) element(*part);
            return;
        }
        if (last() == ")") return keywords({"initially"});
        if (!has("(") || has(")")) return;
        if (last() == "(" || last() == ",") return parameters(where, whole);
        if (last() == "=") {
            const Declaration* const parameter = where.part(whole, words[words.size() - 2]);
            if (parameter != nullptr && parameter->kind == DeclarationKind::Constant) return constant();
            shared();
            if (parameter != nullptr && parameter->kind == DeclarationKind::InputParameter)
                parts(owner_, {DeclarationKind::Constant});
        } else if (is_operator(last())) {  // the cursor is in a term that is bound to an input
            shared();
            parts(owner_, {DeclarationKind::Constant});
        }
    }

    /// Proposes continuations of an incomplete declaration of constants: `constant N: int LOW..HIGH = VALUE, ...`.
    void constants() {
        const auto of = std::ranges::find(half_.words.rbegin(), half_.words.rend(), ",").base();
        const Words one(of, half_.words.end());
        if (last() == ":") return keywords({"bool", "int", "duration"});
        if (last() == "int" || last() == "..") return parts(owner_, {DeclarationKind::Constant});
        if (contains_word(one, "=")) constant();
    }

    /// Proposes the terms that the value of a constant may contain.
    void constant() {
        parts(owner_, {DeclarationKind::Constant});
        keywords({"true", "false"});
    }
    static bool is_operator(std::string_view word) {
        return contains_word({"and", "or", "not", "&&", "||", "!", "=>", "implies", "=="}, word);
    }

    void parameters(const Names& where, const Declaration* component) {
        for (const Declaration* const part : component == nullptr ? List() : where.parts(component)) {
            if (!is_parameter(*part) || contains_word(half_.words, part->name)) continue;
            add({part->name, kind_of(part->kind), declaration_text(*part),
                 parameter_comment(*component->file, component->whole, part->name), part->name + " = $1"});
        }
    }

    void components() {
        for (const Names* const names : {&names_, &library_names()})
            for (const Declaration* const component : names->all(DeclarationKind::Component)) {
                std::string snippet;
                int place = 0;
                for (const Declaration* const part : parameters_in_order(*names, component)) {
                    if (part->kind == DeclarationKind::Constant &&
                        part->file->bytes(part->whole).find('=') != std::string_view::npos)
                        continue;
                    snippet += fmt::format("{}{} = ${}", place == 0 ? "" : ", ", part->name, place + 1);
                    ++place;
                }
                add({component->name, ProposalKind::Class, declaration_text(*component),
                     comment_of(*component->file, component->whole), fmt::format("{}({})", component->name, snippet)});
            }
    }

    static bool is_parameter(const Declaration& part) {
        return part.kind == DeclarationKind::InputParameter || part.kind == DeclarationKind::OutputParameter ||
               part.kind == DeclarationKind::Constant;
    }

    static List parameters_in_order(const Names& names, const Declaration* component) {
        List found = names.parts(component);
        std::erase_if(found, [](const Declaration* part) { return !is_parameter(*part); });
        std::ranges::sort(found, {}, [](const Declaration* part) { return part->where.begin; });
        return found;
    }

    void property() {
        if (!has(":")) {
            if (half_.words.size() > 1) keywords({"expected violated"});
            return;
        }
        term();
        if (last() == ":")
            return keywords({"always", "never", "reachable", "reachable all steps", "inevitable", "always possible",
                             "no deadlock", "no timelock", "exactly one of", "ctl", "ltl", "uppaal"});
        keywords({"leads to", "at stable", "implies", "in", "within", "precedes", "holds for", "holds at most",
                  "at most", "since", "times", "at least every", "before", "after", "between", "until"});
    }

    // -- names in terms -----------------------------------------------------------------------------------------------

    void shared() {
        for (const Declaration* const chart : controllers())
            parts(chart, {DeclarationKind::Input, DeclarationKind::Output});
        parts(owner_, {DeclarationKind::PlantVariable});
    }

    void term() {
        if (owner_ == nullptr) return;
        if (last() == ".") return member();
        if (owner_->kind == DeclarationKind::Chart) {
            parts(owner_, {DeclarationKind::Input, DeclarationKind::Output, DeclarationKind::Internal,
                           DeclarationKind::Partial, DeclarationKind::Constant});
            steps(owner_, partial_, "X");
            all_steps(owner_, "X");
            keywords({"rise", "fall"});
        } else if (owner_->kind == DeclarationKind::Loop) {
            shared();
            for (const Declaration* const chart : controllers()) {
                parts(chart, {DeclarationKind::Internal});
                all_steps(chart, "X");
            }
            parts(owner_, {DeclarationKind::Instance, DeclarationKind::Observer, DeclarationKind::Constant});
        } else {
            parts(owner_, {DeclarationKind::InputParameter, DeclarationKind::OutputParameter, DeclarationKind::Constant,
                           DeclarationKind::Own, DeclarationKind::Clock});
        }
        keywords({"and", "or", "not", "true", "false", "all", "any"});
    }

    void member() {
        if (half_.words.size() < 2) return;
        const std::string& before = half_.words[half_.words.size() - 2];
        if (owner_->kind == DeclarationKind::Chart) return steps(owner_, before, "X");
        const Declaration* const part =
            names_.part(owner_, before, {DeclarationKind::Instance, DeclarationKind::Observer});
        parts(part, {DeclarationKind::Location});  // `part` is an observer
        for (const Declaration* const component : names_.referred(part, DeclarationKind::Component))
            return parts(component, {DeclarationKind::Location});
        for (const Declaration* const chart : names_.referred(part, DeclarationKind::Chart))
            return all_steps(chart, "X"), parts(chart, {DeclarationKind::Internal});
        for (const Declaration* const chart : controllers()) {
            if (chart->name == before)
                all_steps(chart, "X"), parts(chart, {DeclarationKind::Internal, DeclarationKind::Partial});
            else parts(names_.part(chart, before, {DeclarationKind::Partial}), {DeclarationKind::Step}, "X");
        }
    }

    const Names& names_;
    IncompleteDeclaration half_;
    const Declaration* owner_ = nullptr;  ///< the chart, component or loop that contains the cursor
    std::string partial_ = {};
    std::vector<Proposal> found_ = {};
    std::set<std::string> seen_ = {};
};

}  // namespace

std::vector<Proposal> proposals(const Names& names, const Parsed& file, std::size_t cursor) {
    if (file.language == TextLanguage::StructuredText) return program_proposals(names, file, cursor);
    return Proposer(names, half_at(file.text->bytes(), cursor)).all();
}

}  // namespace grafverif::lsp
