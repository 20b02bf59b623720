// SPDX-License-Identifier: MIT
// Randomized test: operations on the drawings of random charts. An operation is rejected with a reason, or its result has
// these properties: the text has no errors; its steps and links follow from the definition of the operation on the links
// of the chart; all comments are kept; undo restores the text byte for byte. Each default run executes 1,000 operations;
// GRAFVERIF_TEST_SIZE=10 executes 10,000.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "edit/document.hpp"
#include "pipeline/chart_text.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif::edit {
namespace {

using Names = std::set<std::string>;

struct Link {
    Names from = {}, to = {};
    auto operator<=>(const Link&) const = default;
};

/// The steps and links of a chart, and the texts of its conditions.
struct Graph {
    Names steps = {};
    std::vector<Link> links = {};  ///< in the order of the elements of the drawing
    std::multiset<std::string> conditions = {};
};

Graph graph_of(Document& document) {
    const Chart& chart = *document.drawn()->reading.model->charts.begin();
    Graph graph;
    const auto name = [&](Id<Chart::Step> step) { return step_variable(chart, step); };
    for (const auto step : chart.steps.ids()) graph.steps.insert(name(step));
    for (const Chart::Transition& transition : chart.transitions) {
        Link& link = graph.links.emplace_back();
        for (const auto step : transition.from) link.from.insert(name(step));
        for (const auto step : transition.to) link.to.insert(name(step));
    }
    for (const DrawnElement& element : document.elements(Id<Chart>{0}, ""))
        if (element.kind == "transition") graph.conditions.insert(element.text);
    return graph;
}

std::multiset<Link> sorted(const std::vector<Link>& links) { return {links.begin(), links.end()}; }

void replace(Names& names, const std::string& name, const std::string& by) {
    if (names.erase(name) != 0) names.insert(by);
}

/// Returns the expected links after an operation, which adds the step `fresh` or no step.
std::multiset<Link> expected_links(const Graph& before, OperationKind kind, const std::string& step,
                                   std::size_t transition, const std::string& fresh, const std::string& target) {
    std::vector<Link> links = before.links;
    const auto first_from = [&] {
        return static_cast<std::size_t>(
            std::ranges::find_if(links, [&](const Link& link) { return link.from.contains(step); }) - links.begin());
    };
    const auto alternative = [&](std::size_t to) {
        const Link link = links[to];
        links.push_back({link.from, {fresh}});
        links.push_back({{fresh}, link.to});
    };
    const bool of_step = !step.empty();
    switch (kind) {
    case OperationKind::StepAfter:
        if (of_step) {
            for (Link& link : links) replace(link.from, step, fresh);
            links.push_back({{step}, {fresh}});
        } else {
            links.push_back({{fresh}, links[transition].to});
            links[transition].to = {fresh};
        }
        break;
    case OperationKind::StepBefore:
        if (of_step) {
            for (Link& link : links) replace(link.to, step, fresh);
            links.push_back({{fresh}, {step}});
        } else {
            links.push_back({links[transition].from, {fresh}});
            links[transition].from = {fresh};
        }
        break;
    case OperationKind::Transition:
        if (of_step) links.push_back({{step}, {fresh}});
        else alternative(transition);
        break;
    case OperationKind::Alternative:
        if (!of_step) alternative(transition);
        else if (first_from() < links.size()) alternative(first_from());
        else links.push_back({{step}, {fresh}});
        break;
    case OperationKind::Parallel:
        for (Link& link : links) {
            const bool of_link = of_step;
            if (of_link && link.from.contains(step)) link.from.insert(fresh);
            if (of_link && link.to.contains(step)) link.to.insert(fresh);
        }
        break;
    case OperationKind::Jump:
        if (of_step) links.push_back({{step}, {target}});
        else links[transition].to = {target};
        break;
    default: break;
    }
    return sorted(links);
}

bool includes(const auto& all, const auto& part) { return std::ranges::includes(all, part); }

std::string with_comments(const std::string& text, Random& random, int& comments) {
    std::string commented;
    std::size_t line = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if (c == '\n') line = k;
        const std::string_view before = std::string_view(text).substr(line, k - line);
        const bool is_in_list = c == ',' && before.find("transition") < k && before.find(" when ") >= k;
        if (is_in_list && chance(random, 30)) commented += " /* comment " + std::to_string(++comments) + ". */";
        if (c == '\n' && chance(random, 30)) commented += "  // comment " + std::to_string(++comments) + '.';
        if (c == '\n' && chance(random, 10)) commented += "\n/* comment " + std::to_string(++comments) + ". */";
        commented += c;
    }
    return commented;
}

constexpr OperationKind kinds[] = {OperationKind::StepAfter,   OperationKind::StepBefore, OperationKind::Transition,
                                   OperationKind::Alternative, OperationKind::Parallel,   OperationKind::Jump,
                                   OperationKind::Action,      OperationKind::Replace,    OperationKind::Delete,
                                   OperationKind::Rename,      OperationKind::Paste,      OperationKind::Declare,
                                   OperationKind::Partial,     OperationKind::Macro,      OperationKind::Enclosing};

class Editor {
public:
    Editor(Document& document, Random& random, std::map<std::string, int>& counts)
        : document_(document), random_(random), counts_(counts) {}

    void edit(int comments) {
        const std::vector<DrawnElement> elements = document_.elements(Id<Chart>{0}, "");
        const auto any = [&] {
            return elements[static_cast<std::size_t>(
                random_number(random_, 0, static_cast<std::int64_t>(elements.size()) - 1))];
        };
        const DrawnElement element = any(), other = any();
        Operation operation{kinds[random_number(random_, 0, std::ssize(kinds) - 1)], element.where.begin,
                            other.where.begin, other.text};
        if (operation.kind == OperationKind::Action) {
            DrawnElement action = other;
            for (int k = 0; k < 5 && action.kind != "action"; ++k) action = any();
            operation.text = action.text;
        }
        if (operation.kind == OperationKind::Rename)
            operation.text = chance(random_, 50) ? "N" + std::to_string(random_number(random_, 0, 99)) : other.name;
        const std::string number = std::to_string(random_number(random_, 0, 99));
        if (operation.kind == OperationKind::Partial || operation.kind == OperationKind::Enclosing)
            operation.text = "G" + number;
        if (operation.kind == OperationKind::Declare)
            operation.text = (chance(random_, 50) ? "input V" : "internal V") + number;
        const std::vector<DrawnElement> steps =
            operation.kind == OperationKind::Paste ? some_steps(elements) : elements;
        if (operation.kind == OperationKind::Paste) operation.text = copy_of(steps);
        std::vector<std::string> originals;
        for (const DrawnElement& step : steps)
            if (operation.kind == OperationKind::Paste) originals.push_back(variable_of(drawn_chart(), step));
        const std::string selected = element.kind == "step" ? variable_of(drawn_chart(), element) : "";
        if (chance(random_, 5)) operation.text = "} ; (";
        const std::string before = document_.text();
        const Graph graph = graph_of(document_);
        const Change change = document_.perform(operation);
        const std::string kind = std::to_string(static_cast<int>(operation.kind));
        ++counts_[kind + (change.obstacle.empty() ? " done" : " rejected")];
        if (!change.obstacle.empty()) {
            ASSERT_EQ(document_.text(), before) << change.obstacle;
            return;
        }
        const std::string after = document_.text();
        ASSERT_NE(after, before);
        Document fresh("/nowhere/fresh.grafcet", {}, after);
        ASSERT_FALSE(fresh.reading().reading.diagnostics.has_errors()) << fresh.reading().reading.diagnostics_text();
        const Chart &ours = *document_.drawn()->reading.model->charts.begin(),
                    &theirs = *fresh.drawn()->reading.model->charts.begin();
        ASSERT_EQ(ours, theirs) << "the drawn chart is not the chart of the text";
        ASSERT_EQ(document_.drawing(Id<Chart>{0}, "").elements, drawing_of(fresh).elements)
            << "the drawing is not that of the text";
        for (int k = 1; operation.kind != OperationKind::Delete && k <= comments; ++k) {
            const std::string comment = "comment " + std::to_string(k) + '.';
            const bool before_has = before.find(comment) != std::string::npos;
            ASSERT_EQ(after.find(comment) != std::string::npos, before_has) << comment;
        }
        if (operation.kind == OperationKind::Paste) check_copy(graph, originals, selected, element);
        else if (operation.kind > OperationKind::Rename) check_parts(graph, operation.kind, selected, element, change);
        else check_links(graph, graph_of(document_), operation.kind, element, other);
        const bool selects = !change.selected || Elements(tree_of(after)).at(*change.selected) != nullptr;
        ASSERT_TRUE(selects) << "the selected position is not an element";
        document_.undo();
        ASSERT_EQ(document_.text(), before);
        document_.redo();
        ASSERT_EQ(document_.text(), after);
    }

private:
    static Drawing drawing_of(Document& document) {
        const ParseResult& reading = document.drawn()->reading;
        return grafverif::drawing_of(*reading.model, Id<Chart>{0}, {}, reading.sources);
    }

    const tree::File& tree_of(const std::string& text) {
        workspace_ = std::make_unique<lsp::Workspace>(std::vector<std::string>());
        workspace_->open("file:///x.grafcet", 0, text);
        parsed_ = workspace_->parsed("/x.grafcet");
        return parsed_->tree;
    }

    void check_links(const Graph& before, const Graph& after, OperationKind kind, const DrawnElement& element,
                     const DrawnElement& other) {
        const Chart& chart = *document_.drawn()->reading.model->charts.begin();
        if (element.kind == "action" || kind == OperationKind::Rename) return;
        Names added, removed;
        std::ranges::set_difference(after.steps, before.steps, std::inserter(added, added.end()));
        std::ranges::set_difference(before.steps, after.steps, std::inserter(removed, removed.end()));
        const std::string fresh = added.empty() ? "" : *added.begin();
        if (kind == OperationKind::Delete) {
            ASSERT_TRUE(added.empty());
            ASSERT_EQ(removed.size(), element.kind == "step" ? 1U : 0U);
            ASSERT_TRUE(includes(before.conditions, after.conditions));
            std::multiset<Link> others;
            for (const Link& link : before.links)
                if (!removed.empty() && !link.from.contains(*removed.begin()) && !link.to.contains(*removed.begin()))
                    others.insert(link);
            ASSERT_TRUE(includes(sorted(after.links), others));
            return;
        }
        if (kind == OperationKind::Replace) {
            ASSERT_EQ(sorted(before.links), sorted(after.links));
            return;
        }
        ASSERT_TRUE(includes(after.conditions, before.conditions)) << "conditions are kept";
        ASSERT_TRUE(removed.empty());
        if (kind == OperationKind::Parallel && element.kind == "transition") return;
        const auto variable = [&](const DrawnElement& drawn) {
            return drawn.kind == "step" ? variable_of(chart, drawn) : std::string();
        };
        ASSERT_EQ(sorted(after.links),
                  expected_links(before, kind, variable(element), transition_of(element), fresh, variable(other)));
    }

    const Chart& drawn_chart() { return *document_.drawn()->reading.model->charts.begin(); }

    /// Returns between one and four steps, each once.
    std::vector<DrawnElement> some_steps(const std::vector<DrawnElement>& elements) {
        std::vector<DrawnElement> steps;
        const auto first = static_cast<std::size_t>(random_number(random_, 0, std::ssize(elements) - 1));
        for (std::size_t k = 0; k < elements.size() && steps.size() < 4; ++k) {
            const DrawnElement& each = elements[(first + k) % elements.size()];
            if (each.kind == "step" && (steps.empty() || chance(random_, 50))) steps.push_back(each);
        }
        return steps;
    }
    std::string copy_of(const std::vector<DrawnElement>& steps) {
        std::vector<std::uint32_t> at;
        for (const DrawnElement& step : steps) at.push_back(step.where.begin);
        return document_.copied(at).text;
    }

    /// Checks the links of pasted steps. The copies of `originals` are the new steps in the order of the text.
    void check_copy(const Graph& before, const std::vector<std::string>& originals, const std::string& selected,
                    const DrawnElement& element) {
        const Graph after = graph_of(document_);
        std::vector<std::pair<std::uint32_t, std::string>> added;
        for (const DrawnElement& each : document_.elements(Id<Chart>{0}, ""))
            if (each.kind == "step")
                if (const std::string name = variable_of(drawn_chart(), each); !before.steps.contains(name))
                    added.emplace_back(each.where.begin, name);
        std::ranges::sort(added);
        ASSERT_EQ(added.size(), originals.size());
        ASSERT_TRUE(includes(after.steps, before.steps));
        std::map<std::string, std::string> copies;
        for (std::size_t k = 0; k < added.size(); ++k) copies[originals[k]] = added[k].second;
        const auto copied = [&](const Names& names) {
            Names list;
            for (const std::string& name : names)
                if (copies.contains(name)) list.insert(copies[name]);
            return list;
        };
        const Link* target = nullptr;
        if (selected.empty()) target = &before.links[transition_of(element)];
        for (const Link& link : before.links)
            if (target == nullptr && link.from.contains(selected)) target = &link;
        std::multiset<Link> rest = sorted(after.links);
        const auto take = [&](const Link& link) {
            ASSERT_TRUE(rest.contains(link));
            rest.erase(rest.find(link));
        };
        for (const Link& link : before.links) take(link);
        for (const Link& link : before.links) {
            const Link copy{copied(link.from), copied(link.to)};
            const bool leaves = copy.to.empty() && !link.to.empty();
            if (copy.from.empty() || (leaves && target == nullptr)) continue;
            take({copy.from, leaves ? target->to : copy.to});
        }
        ASSERT_EQ(rest.size(), 1U) << "one transition leads to the copied steps";
        ASSERT_EQ(rest.begin()->from, target == nullptr ? Names{selected} : target->from);
        Names reached = rest.begin()->to, all;
        for (const auto& [at, name] : added) all.insert(name);
        for (std::size_t k = 0; k < added.size(); ++k)
            for (const Link& link : after.links)
                if (std::ranges::any_of(link.from, [&](const std::string& name) { return reached.contains(name); }))
                    for (const std::string& name : link.to)
                        if (all.contains(name)) reached.insert(name);
        ASSERT_EQ(reached, all) << "links lead to all copied steps";
    }

    /// Checks the operations that declare variables and partial charts.
    void check_parts(const Graph& before, OperationKind kind, const std::string& selected, const DrawnElement& element,
                     const Change& change) {
        const Graph after = graph_of(document_);
        ASSERT_TRUE(includes(after.steps, before.steps));
        Names added;
        std::ranges::set_difference(after.steps, before.steps, std::inserter(added, added.end()));
        ASSERT_TRUE(includes(after.conditions, before.conditions));
        if (kind == OperationKind::Declare || kind == OperationKind::Partial) {
            ASSERT_EQ(sorted(after.links), sorted(before.links));
            ASSERT_EQ(added.size(), kind == OperationKind::Partial ? 1U : 0U);
            return;
        }
        std::string fresh;
        for (const DrawnElement& each : document_.elements(Id<Chart>{0}, ""))
            if (each.where.begin == *change.selected && each.kind == "step") fresh = variable_of(drawn_chart(), each);
        ASSERT_TRUE(added.contains(fresh));
        added.erase(fresh);
        std::multiset<Link> links = sorted(after.links);
        std::erase_if(links, [&](const Link& link) {
            return includes(added, link.from) && includes(added, link.to) && !link.from.empty();
        });
        ASSERT_EQ(links, expected_links(before, OperationKind::StepAfter, selected,
                                        selected.empty() ? transition_of(element) : 0, fresh, ""));
        ASSERT_LE(added.size(), kind == OperationKind::Macro ? 2U : 1U);
    }

    /// Returns the step variable of a drawn step, whose id contains the names of its partial chart and of the step.
    std::string variable_of(const Chart& chart, const DrawnElement& drawn) {
        const ElementIds ids = element_ids(chart);
        for (const auto step : chart.steps.ids())
            if (ids.steps[step.index] == drawn.id) return step_variable(chart, step);
        return {};
    }

    /// Returns the index of the transition before the operation.
    std::size_t transition_of(const DrawnElement& drawn) {
        Document before("/nowhere/before.grafcet", {}, text_before());
        const ElementIds ids = element_ids(*before.drawn()->reading.model->charts.begin());
        return static_cast<std::size_t>(std::ranges::find(ids.transitions, drawn.id) - ids.transitions.begin());
    }
    std::string text_before() {
        document_.undo();
        std::string text = document_.text();
        document_.redo();
        return text;
    }

    Document& document_;
    Random& random_;
    std::map<std::string, int>& counts_;
    std::unique_ptr<lsp::Workspace> workspace_ = nullptr;
    std::shared_ptr<const lsp::Parsed> parsed_ = nullptr;
};

TEST(RandomizedEdit, OperationsAreCorrectOrRejectedAndCanBeUndone) {
    std::map<std::string, int> counts;
    int edited = 0;
    for (std::uint64_t seed = 1; edited < test_size(1000); ++seed) {
        Random random(seed);
        int comments = 0;
        const std::string text = with_comments(chart_text(random_chart(random)), random, comments);
        Document document("/nowhere/chart.grafcet", {}, text);
        if (document.drawn() == nullptr) continue;
        std::vector<std::string> texts = {text};
        Editor editor(document, random, counts);
        for (int k = 0; k < 20; ++k, ++edited) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", edit " + std::to_string(k));
            editor.edit(comments);
            if (::testing::Test::HasFatalFailure()) {
                std::cout << texts.back() << "\n=>\n" << document.text();
                return;
            }
            if (document.text() != texts.back()) texts.push_back(document.text());
        }
        for (; !texts.empty(); texts.pop_back(), document.undo()) ASSERT_EQ(document.text(), texts.back());
    }
    for (const auto& [kind, count] : counts) RecordProperty(kind, count);
    for (const char* kind :
         {"0 done", "1 done", "2 done", "3 done", "4 done", "5 done", "6 done", "7 done", "8 done", "8 rejected",
          "9 done", "10 done", "10 rejected", "11 done", "12 done", "13 done", "14 done"})
        EXPECT_GT(counts[kind], 5) << kind;
}

TEST(RandomizedEdit, TypedTextIsUndoneByteForByte) {
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(20)); ++seed) {
        Random random(seed);
        int comments = 0;
        const std::string text = with_comments(chart_text(random_chart(random)), random, comments);
        Document document("/nowhere/chart.grafcet", {}, text);
        std::string typed = text;
        for (int k = 0; k < 20; ++k) {
            const auto at = static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(typed.size())));
            if (chance(random, 50)) typed.insert(at, chance(random, 50) ? "step \u00e4\u2191 {" : "x");
            else typed.erase(at, static_cast<std::size_t>(random_number(random, 1, 30)));
            document.type(typed);
            ASSERT_EQ(document.text(), typed) << seed;
            document.reading();
        }
        while (document.can_undo()) document.undo();
        ASSERT_EQ(document.text(), text) << seed;
        while (document.can_redo()) document.redo();
        ASSERT_EQ(document.text(), typed) << seed;
    }
}

}  // namespace
}  // namespace grafverif::edit
