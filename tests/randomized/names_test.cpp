// SPDX-License-Identifier: MIT
// Randomized tests of the recorded references of names. If every recorded occurrence of a declared name is replaced by
// a new name, the text has the same model except for this name. Every name in a text is recorded.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "lsp/scan.hpp"
#include "pipeline/components.hpp"
#include "read/text.hpp"
#include "support/damage.hpp"
#include "support/print_model.hpp"
#include "support/random_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

struct Read {
    Sources sources = {};
    Diagnostics diagnostics = {};
    References references = {};
    std::optional<Model> model = {};
};

Read read(const std::string& text, const std::string& path, bool recorded = true) {
    Read result;
    const Id<Source> file = result.sources.add({path, text});
    ReadContext context;
    context.library = library();
    if (recorded) context.references = &result.references;
    context.load = [](const std::string& included, std::string&) -> std::optional<std::string> {
        std::ifstream in(included, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    result.model = read_text(file, result.sources, context, result.diagnostics);
    return result;
}

std::string with_errors(const Read& read) {
    std::ostringstream out;
    render_text(read.diagnostics.all(), read.sources, Colour::Plain, out);
    return out.str() + read.sources.begin()->text;
}

/// Returns all names of a model in the order of its tables, and removes them from the model. Texts that contain names
/// are removed, too.
std::vector<std::string> names_taken_from(Model& model) {
    std::vector<std::string> names;
    const auto take = [&](std::string& name) { names.push_back(std::exchange(name, {})); };
    const auto take_all = [&](auto& table) {
        for (auto& each : table) take(each.name);
    };
    for (Chart& chart : model.charts) {
        take(chart.name);
        take_all(chart.variables);
        take_all(chart.steps);
        take_all(chart.partial_charts);
        take_all(chart.transitions);
        for (Chart::Acceptance& accepted : chart.accepted) accepted.subject.clear();
    }
    for (Component& component : model.components) {
        take(component.name);
        take_all(component.parameters);
        take_all(component.variables);
        take_all(component.clocks);
        take_all(component.locations);
    }
    for (ClosedLoop& loop : model.loops) {
        take(loop.name);
        take_all(loop.constants);
        take_all(loop.controllers);
        take_all(loop.shared);
        take_all(loop.instances);
        take_all(loop.properties);
        take_all(loop.observers);
        for (ClosedLoop::Observer& observer : loop.observers) take_all(observer.locations);
        for (ClosedLoop::Fault& fault : loop.faults) take(fault.behaviour.name);
        for (ClosedLoop::Constraint& constraint : loop.constraints) constraint.name.clear();
    }
    return names;
}

using Site = std::pair<std::uint32_t, std::uint32_t>;  ///< source and offset
Site site(Span where) { return {where.source.index, where.begin}; }

/// Returns the positions of all occurrences of the name that is declared at `declaration`.
std::set<Site> occurrences(const References& references, Span declaration, std::string_view name) {
    std::set<Site> declared = {site(declaration)};
    for (std::size_t before = 0; before != declared.size();) {
        before = declared.size();
        for (const auto& [one, other] : references.shared)
            if (declared.contains(site(one)) || declared.contains(site(other)))
                declared.insert(site(one)), declared.insert(site(other));
    }
    std::set<Site> found = declared;
    for (const References::Reference& each : references.references)
        if (declared.contains(site(each.declaration))) found.insert(site(last_name(each.where, name)));
    return found;
}

/// Renames one declaration of the text, and compares the models. Returns false if the declaration cannot be renamed,
/// because another file or a formula of another language contains its name.
bool rename_keeps_the_model(const Read& before, const References::Declaration& declaration) {
    const std::string fresh = "fresh_name";
    const Source& source = *before.sources.begin();
    const std::set<Site> sites = occurrences(before.references, declaration.where, declaration.name);
    if (std::ranges::any_of(sites, [](const Site& each) { return each.first != 0; })) return false;
    for (const ClosedLoop& loop : before.model->loops)
        for (const Property& property : loop.properties)
            if (property.raw.find(declaration.name) != std::string::npos) return false;
    std::string text = source.text;
    for (auto each = sites.rbegin(); each != sites.rend(); ++each) {
        EXPECT_EQ(text.substr(each->second, declaration.name.size()), declaration.name);
        text.replace(each->second, declaration.name.size(), fresh);
    }
    Read after = read(text, source.name);
    EXPECT_TRUE(after.model) << declaration.name << '\n' << with_errors(after);
    if (!after.model) return true;
    Model old_model = *before.model, new_model = *after.model;
    const std::vector<std::string> old_names = names_taken_from(old_model), new_names = names_taken_from(new_model);
    EXPECT_TRUE(old_model == new_model) << declaration.name << '\n' << text;
    EXPECT_EQ(old_names.size(), new_names.size());
    bool renamed = source.text.substr(declaration.where.end, 4) == " in ";  // the model has no index variables
    for (std::size_t k = 0; k < std::min(old_names.size(), new_names.size()); ++k) {
        if (old_names[k] == new_names[k]) continue;
        EXPECT_EQ(without_indices(old_names[k]), declaration.name);
        EXPECT_EQ(without_indices(new_names[k]), fresh);
        renamed = true;
    }
    EXPECT_TRUE(renamed) << declaration.name << '\n' << text;
    return true;
}

/// Checks that each name in the first source is a keyword or recorded.
void expect_all_names_recorded(const Read& read) {
    const std::string& text = read.sources.begin()->text;
    std::vector<Span> recorded;
    for (const References::Declaration& each : read.references.declarations) recorded.push_back(each.where);
    for (const References::Reference& each : read.references.references) recorded.push_back(each.where);
    std::erase_if(recorded, [](Span where) { return where.source.index != 0; });
    const std::set<std::string_view> words = {"stability_search", "every_cycle", "phased",    "atomic",
                                              "interleaved",      "synchronous", "sequenced", "INIT"};
    bool in_code = false;  // in the code of `accept CODE SUBJECT "reason"`
    std::size_t end = 0;
    for (const lsp::Word& word : lsp::words_of(text)) {
        const std::string_view name = std::string_view(text).substr(word.begin, word.end - word.begin);
        in_code = name == "accept" || (in_code && (end == word.begin || word.begin - end == 1));
        const bool first = in_code && end != word.begin;
        end = word.end;
        if (in_code && (first || text[word.begin - 1] == '-')) continue;
        if (word.kind != lsp::Word::Kind::Name || lsp::is_keyword(name) || words.contains(name)) continue;
        const bool known = std::ranges::any_of(
            recorded, [&](Span where) { return where.begin <= word.begin && word.begin < where.end; });
        EXPECT_TRUE(known) << name << " at " << place(text, word.begin).line << '\n' << text;
    }
}

/// Checks that all positions are in the texts and that every declaration is recorded. Returns the number of references.
std::size_t checked_record(const Read& read) {
    std::set<Site> declared;
    const auto check = [&](Span where) {
        ASSERT_LT(where.source.index, read.sources.size());
        ASSERT_LE(where.begin, where.end);
        ASSERT_LE(where.end, read.sources[where.source].text.size());
    };
    for (const References::Declaration& each : read.references.declarations) {
        check(each.where), check(each.whole);
        declared.insert(site(each.where));
    }
    for (const References::Declaration& each : read.references.declarations)
        EXPECT_TRUE(!each.owner.source.valid() || declared.contains(site(each.owner))) << each.name;
    for (const References::Reference& each : read.references.references) {
        check(each.where);
        EXPECT_TRUE(declared.contains(site(each.declaration)));
    }
    return read.references.references.size();
}

TEST(RandomizedNames, RenamingByRecordedReferencesKeepsTheModel) {
    int renamed = 0;
    for (int seed = 1; seed <= test_size(60); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        std::ostringstream text;
        print(text, random_loop_asked(random, 6));
        const Read before = read(text.str(), "random.grafcet");
        if (!before.model) continue;  // some random charts contain steps that are never active
        SCOPED_TRACE(fmt::format("seed {}", seed));
        expect_all_names_recorded(before);
        for (int k = 0; k < 4; ++k) {
            const auto& all = before.references.declarations;
            const auto at =
                static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(all.size()) - 1));
            renamed += rename_keeps_the_model(before, all[at]) ? 1 : 0;
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(renamed, 60);
}

/// Returns the paths of all texts below a folder of the repository.
std::vector<std::string> texts_below(const std::string& folder) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GRAFVERIF_SOURCE_DIR "/" + folder))
        if (entry.path().extension() == ".grafcet") paths.push_back(entry.path().string());
    std::ranges::sort(paths);
    return paths;
}

TEST(RandomizedNames, RenamingInSamplesKeepsTheModel) {
    Random random(1);
    int renamed = 0;
    for (const std::string& path : texts_below("samples")) {
        std::ifstream in(path, std::ios::binary);
        const Read before = read(std::string(std::istreambuf_iterator<char>(in), {}), path);
        SCOPED_TRACE(path);
        ASSERT_TRUE(before.model) << with_errors(before);
        checked_record(before);
        expect_all_names_recorded(before);
        std::vector<References::Declaration> all = before.references.declarations;
        std::erase_if(all, [](const References::Declaration& each) { return each.where.source.index != 0; });
        std::ranges::shuffle(all, random);
        if (all.size() > 12) all.resize(12);
        for (const References::Declaration& each : all) renamed += rename_keeps_the_model(before, each) ? 1 : 0;
    }
    EXPECT_GT(renamed, 60);
}

TEST(RandomizedNames, RecordOfARejectedTextIsConsistentAndKeepsItsDiagnostics) {
    std::size_t references = 0;
    for (const std::string& path : texts_below("tests/diagnostics")) {
        SCOPED_TRACE(path);
        std::ifstream in(path, std::ios::binary);
        const std::string text(std::istreambuf_iterator<char>(in), {});
        const Read recorded = read(text, path);
        references += checked_record(recorded);
        EXPECT_EQ(with_errors(recorded), with_errors(read(text, path, false)));
    }
    EXPECT_GT(references, 2'000U);
}

TEST(RandomizedNames, RecordOfADamagedTextIsConsistent) {
    const Damage damage{.likely = "{}()[];,.=:<>-&|!\"X1 \n"};
    std::mt19937 random(1);
    std::size_t references = 0;
    for (const std::string& path : texts_below("samples")) {
        std::ifstream in(path, std::ios::binary);
        const std::string text(std::istreambuf_iterator<char>(in), {});
        for (int k = 0; k < test_size(40); ++k) {
            const Read record = read(damaged(text, damage, random), path);
            references += checked_record(record);
            ASSERT_FALSE(HasFailure()) << record.sources.begin()->text;
        }
    }
    EXPECT_GT(references, 10'000U);
}

}  // namespace
}  // namespace grafverif
