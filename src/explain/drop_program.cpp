// SPDX-License-Identifier: MIT
// Removes elements of PLC programs (see ablation.hpp).
#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "explain/ablation.hpp"
#include "syntax/print/program.hpp"

namespace grafverif {

namespace {

using Statement = Program::Statement;

constexpr std::size_t longest_name = 60;  ///< maximum number of bytes of the text of a statement in its name

class Elements {
public:
    explicit Elements(const Program& program) : program_(program) {}

    std::vector<ProgramElement> all() && {
        for (const Program::Unit& unit : program_.units)
            for (const Program::Sequence& sequence : unit.sequences)
                for (const Program::Sequence::Transition& transition : sequence.transitions)
                    transitions_.emplace(transition.test, &transition);
        const Id<Source> source = program_.units[program_.main].origin.source;
        for (const Id<Program::Unit> id : program_.units.ids()) {
            const Program::Unit& unit = program_.units[id];
            if (unit.origin.source != source) continue;  // the unit is a standard function block
            unit_ = unit.owner.valid() ? unit.owner : id;
            add(unit.body);
        }
        return std::move(found_);
    }

private:
    std::string steps(const std::vector<std::uint32_t>& cells) const {
        std::string names;
        for (const std::uint32_t cell : cells) {
            const std::string active = place_text(program_, unit_, {false, cell, {}});
            names += (names.empty() ? "" : ", ") + active.substr(0, active.rfind('.'));
        }
        return cells.size() == 1 ? names : "(" + names + ")";
    }

    /// Returns the name of a statement, which is its text. The exception is a statement that assigns the output Q of
    /// the action control of a Boolean action, such as `run := action run.Q`: it has the name of the action.
    std::string name_of(const Statement& statement) const {
        constexpr std::string_view control = ":= action ", output = ".Q";
        std::string text = statement_text(program_, unit_, statement);
        if (const std::size_t at = text.find(control); at != std::string::npos && text.ends_with(output))
            return text.substr(at + 3, text.size() - at - 3 - output.size());
        return text.size() > longest_name ? text.substr(0, longest_name) + "..." : text;
    }

    void add(const Program::Body& body) {
        bool follows = false;  // true if the last element of `found_` is the preceding statement of `body`
        for (const Id<Statement> id : body) {
            const Statement& statement = program_.statements[id];
            if (const auto test = transitions_.find(id); test != transitions_.end()) {
                const auto& [name, from, to, tested] = *test->second;
                found_.push_back({true,
                                  name.empty() ? steps(from) + " -> " + steps(to) : name,
                                  program_.nodes[statement.value].origin,
                                  {id}});
                follows = false;
                continue;
            }
            for (const Program::Arm& arm : statement.arms) add(arm.body);
            const bool simple = statement.kind == Statement::Kind::Assign ||
                                statement.kind == Statement::Kind::Invoke || statement.kind == Statement::Kind::Exit ||
                                statement.kind == Statement::Kind::Return;
            if (!simple || statement.generated) {
                follows = false;
                continue;
            }
            const Span last = follows ? found_.back().origin : Span{};
            if (follows && last.begin == statement.origin.begin && last.end == statement.origin.end) {
                found_.back().statements.push_back(id);
                continue;
            }
            found_.push_back({false, name_of(statement), statement.origin, {id}});
            follows = true;
        }
    }

    const Program& program_;
    Id<Program::Unit> unit_ = {};
    std::map<Id<Statement>, const Program::Sequence::Transition*> transitions_ = {};
    std::vector<ProgramElement> found_ = {};
};

}  // namespace

std::vector<ProgramElement> elements_of(const Program& program) { return Elements(program).all(); }

void drop_element(Program& program, const ProgramElement& element) {
    if (element.transition) {
        Statement& test = program.statements[element.statements.front()];
        test.value = program.nodes.add({.op = Program::Op::Constant, .type = test.type, .origin = element.origin});
        return;
    }
    const auto drop = [&](Program::Body& body) {
        std::erase_if(body, [&](Id<Statement> id) {
            return std::ranges::find(element.statements, id) != element.statements.end();
        });
    };
    for (Program::Unit& unit : program.units) drop(unit.body);
    for (Statement& statement : program.statements)
        for (Program::Arm& arm : statement.arms) drop(arm.body);
}

}  // namespace grafverif
