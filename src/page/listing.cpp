// SPDX-License-Identifier: MIT
#include "page/listing.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "syntax/print/program.hpp"

namespace grafverif {

namespace {

using Role = ProgramListing::Role;
using StatementKind = Program::Statement::Kind;

class ListingMaker {
public:
    ListingMaker(const Program& program, const Sources& sources)
        : program_(program), source_(program.units[program.main].origin.source) {
        const std::string_view text = sources[source_].text;
        const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
        printed_ = first < text.size() && text[first] == '<';
        listing_.of_statements.resize(program.statements.size());
        listing_.of_nodes.resize(program.nodes.size());
        if (!printed_) add_lines(text);
    }

    ProgramListing make() && {
        for (const Program::Unit& unit : program_.units)
            for (const Program::Sequence& sequence : unit.sequences)
                for (const Program::Sequence::Transition& transition : sequence.transitions)
                    tests_.emplace(transition.test.index, &transition);
        for (const Id<Program::Unit> id : program_.units.ids()) {
            const Program::Unit& unit = program_.units[id];
            if (unit.origin.source != source_ || unit.kind == Program::Unit::Kind::Structure) continue;
            unit_ = unit.owner.valid() ? unit.owner : id;
            print(heading(unit));
            ++depth_;
            add(unit.body);
            --depth_;
        }
        return std::move(listing_);
    }

private:
    void add_lines(std::string_view text) {
        for (std::size_t begin = 0; begin <= text.size();) {
            listing_.begins.push_back(static_cast<std::uint32_t>(begin));
            listing_.lines.emplace_back(line_at(text, listing_.begins.back()));
            const std::size_t end = text.find('\n', begin);
            if (end == std::string_view::npos) break;
            begin = end + 1;
        }
        if (listing_.lines.size() > 1 && listing_.lines.back().empty()) listing_.lines.pop_back();
    }

    std::string heading(const Program::Unit& unit) const {
        switch (unit.kind) {
        case Program::Unit::Kind::Program: return "PROGRAM " + unit.name;
        case Program::Unit::Kind::FunctionBlock: return "FUNCTION_BLOCK " + unit.name;
        case Program::Unit::Kind::Function: return "FUNCTION " + unit.name;
        case Program::Unit::Kind::Action: return "ACTION " + program_.units[unit_].name + "." + unit.name;
        case Program::Unit::Kind::Globals:
        case Program::Unit::Kind::Structure: break;
        }
        return unit.name;
    }

    /// Adds a printed line. Has no effect if the listing consists of the lines of the source.
    void print(const std::string& text) {
        if (printed_) listing_.lines.push_back(std::string(2 * depth_, ' ') + text);
    }
    /// Sets the current line: the line of `origin` in the source or, if the listing is printed, a new line with the
    /// text `printed`.
    void begin(Span origin, const std::string& printed) {
        print(printed);
        line_ = line_of(listing_, origin).value_or(static_cast<std::uint32_t>(listing_.lines.size() - 1));
    }

    std::string text(Id<Program::Node> term) const { return term_text(program_, unit_, term); }
    std::string name(const Program::Place& place) const { return place_text(program_, unit_, place); }

    std::size_t item(Role role, std::string name, Id<Program::Type> type) {
        listing_.items.push_back({role, line_, std::move(name), type, unit_});
        return listing_.items.size() - 1;
    }

    void add(const Program::Body& body) {
        for (const Id<Program::Statement> id : body) add(id);
    }

    void add(Id<Program::Statement> id) {
        const Program::Statement& statement = program_.statements[id];
        if (const auto test = tests_.find(id.index); test != tests_.end()) {
            begin(program_.nodes[statement.value].origin, "TRANSITION FROM " + steps(test->second->from) + " TO " +
                                                              steps(test->second->to) + " := " + text(statement.value) +
                                                              ";");
            add_reads(statement.value);
            listing_.of_statements[id.index] = item(Role::Condition, "", statement.type);
            return;
        }
        if (statement.generated) {
            for (const Program::Arm& arm : statement.arms) add(arm.body);
            return;
        }
        switch (statement.kind) {
        case StatementKind::Assign: {
            std::string target = name(statement.place);
            begin(statement.origin, statement_text(program_, unit_, statement) + ";");
            add_reads(statement.place);
            add_reads(statement.value);
            listing_.of_statements[id.index] = item(Role::Result, std::move(target), statement.type);
            return;
        }
        case StatementKind::Invoke:
        case StatementKind::Exit:
        case StatementKind::Return:
            begin(statement.origin, statement_text(program_, unit_, statement) + ";");
            listing_.of_statements[id.index] = item(Role::Executed, "", {});
            return;
        case StatementKind::If:
        case StatementKind::Case: return add_branches(statement);
        case StatementKind::For:
        case StatementKind::While:
        case StatementKind::Repeat: return add_loop(id);
        case StatementKind::Check: return;
        }
    }

    std::string steps(const std::vector<std::uint32_t>& cells) const {
        std::string names;
        for (const std::uint32_t cell : cells) {
            const std::string active = name({false, cell, {}});
            names += (names.empty() ? "" : ", ") + active.substr(0, active.rfind('.'));
        }
        return cells.size() == 1 ? names : "(" + names + ")";
    }

    void add_branches(const Program::Statement& statement) {
        if (statement.kind == StatementKind::Case) {
            begin(program_.nodes[statement.value].origin, "CASE " + text(statement.value) + " OF");
            add_condition(statement.value);
        }
        for (const Program::Arm& arm : statement.arms) {
            if (arm.condition.valid()) {
                const bool first = &arm == &statement.arms.front();
                begin(program_.nodes[arm.condition].origin, (first ? "IF " : "ELSIF ") + text(arm.condition) + " THEN");
                add_condition(arm.condition);
            } else print(arm.labels.empty() ? "ELSE" : labels(arm));
            ++depth_;
            add(arm.body);
            --depth_;
        }
        print(statement.kind == StatementKind::Case ? "END_CASE;" : "END_IF;");
    }

    static std::string labels(const Program::Arm& arm) {
        std::string text;
        for (const auto& [first, last] : arm.labels)
            text +=
                (text.empty() ? "" : ", ") + std::to_string(first) + (first == last ? "" : ".." + std::to_string(last));
        return text + ":";
    }

    void add_loop(Id<Program::Statement> id) {
        const Program::Statement& statement = program_.statements[id];
        const auto body = [&] {
            ++depth_;
            add(statement.arms.front().body);
            --depth_;
        };
        if (statement.kind == StatementKind::Repeat) {
            print("REPEAT");
            body();
            begin(program_.nodes[statement.value].origin, "UNTIL " + text(statement.value) + " END_REPEAT;");
            return add_condition(statement.value);
        }
        if (statement.kind == StatementKind::While) {
            begin(program_.nodes[statement.value].origin, "WHILE " + text(statement.value) + " DO");
            add_condition(statement.value);
            body();
            return print("END_WHILE;");
        }
        std::string variable = name(statement.place);
        begin(statement.origin, "FOR " + variable + " := " + text(statement.value) + " TO " + text(statement.last) +
                                    " BY " + std::to_string(statement.step) + " DO");
        add_reads(statement.value);
        add_reads(statement.last);
        listing_.of_statements[id.index] = item(Role::Result, std::move(variable), statement.type);
        body();
        print("END_FOR;");
    }

    /// Adds a condition and the variables that it reads. A condition that consists only of a variable is not added,
    /// because the interpreter records it as a read variable.
    void add_condition(Id<Program::Node> id) {
        add_reads(id);
        const Program::Node& node = program_.nodes[id];
        if (node.op != Program::Op::Read) listing_.of_nodes[id.index] = item(Role::Condition, "", node.type);
    }

    void add_reads(const Program::Place& place) {
        for (const Program::Index& index : place.indices) add_reads(index.value);
    }
    void add_reads(Id<Program::Node> id) {
        const Program::Node& node = program_.nodes[id];
        add_reads(node.place);
        for (const Id<Program::Node> operand : node.operands) add_reads(operand);
        if (node.op != Program::Op::Read) return;
        std::string variable = name(node.place);
        if (!is_generated_name(variable))
            listing_.of_nodes[id.index] = item(Role::Read, std::move(variable), node.type);
    }

    const Program& program_;
    Id<Source> source_;
    Id<Program::Unit> unit_ = {};  ///< the unit that owns the frame of the current body

    /// Transition of each statement that tests a transition condition.
    std::map<std::uint32_t, const Program::Sequence::Transition*> tests_ = {};
    bool printed_ = false;
    std::uint32_t line_ = 0;
    std::size_t depth_ = 0;
    ProgramListing listing_ = {};
};

}  // namespace

std::optional<std::uint32_t> line_of(const ProgramListing& listing, Span where) {
    if (listing.begins.empty()) return {};
    const auto next = std::ranges::upper_bound(listing.begins, where.begin);
    return static_cast<std::uint32_t>(next - listing.begins.begin() - 1);
}

ProgramListing listing_of(const Program& program, const Sources& sources) {
    return ListingMaker(program, sources).make();
}

}  // namespace grafverif
