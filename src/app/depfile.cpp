// SPDX-License-Identifier: MIT
#include "app/depfile.hpp"

#include <algorithm>
#include <utility>

#include "pipeline/files.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"

namespace grafverif::app {

namespace {

/// Rules by which a reader of depfiles parses file names. A backslash must precede each character in `escaped`. Each
/// backslash before a character in `doubling` must be doubled. A name cannot contain a character in `never`, begin with
/// a character in `never_first`, or end with a character in `never_last`.
struct Rules {
    std::string_view escaped, doubling, never, never_first, never_last;
};

constexpr Rules rules_of(DepfileSide side, DepfileReader reader) {
    const bool result = side == DepfileSide::Result;
    switch (reader) {
    // The rules of Make also exclude or escape the characters by which Make denotes patterns, order-only prerequisites,
    // wildcards, grouped targets and archives. Make keeps a backslash before a wildcard.
    case DepfileReader::Make:
        return result ? Rules{" #:%", " #:%", "*?[\t;=", "~", "&)"} : Rules{" \t#:|", " \t#:|", "*?[;=", "~", " \t\\)"};
    case DepfileReader::Ninja: return {" #:", " ", "\t\"&'*;<>?^`|", "", ":\\"};
    case DepfileReader::CMake: return {" #", "", "\t\\", "~", ":"};
    }
    unreachable();
}

constexpr std::string_view word(DepfileReader reader) {
    return reader == DepfileReader::Make ? "Make" : reader == DepfileReader::Ninja ? "Ninja" : "CMake";
}

bool can_express(std::string_view name, const Rules& rules) {
    const auto control = [](unsigned char c) { return (c < ' ' && c != '\t') || c == 0x7f; };
    return !name.empty() && std::ranges::none_of(name, control) && name.find_first_of(rules.never) == name.npos &&
           rules.never_first.find(name.front()) == name.npos && rules.never_last.find(name.back()) == name.npos;
}

}  // namespace

std::optional<std::string> depfile_name(std::string_view name, DepfileSide side, DepfileReader reader) {
    const Rules rules = rules_of(side, reader);
    if (!can_express(name, rules)) return {};
    std::string text;
    std::size_t backslashes = 0;  // number of backslashes directly before the character
    for (const char c : name) {
        if (rules.escaped.find(c) != rules.escaped.npos)
            text.append(rules.doubling.find(c) != rules.doubling.npos ? backslashes + 1 : 1, '\\');
        // After a backslash, Ninja treats `$` as a literal character.
        if (c == '$' && !(reader == DepfileReader::Ninja && backslashes > 0)) text += '$';
        text += c;
        backslashes = c == '\\' ? backslashes + 1 : 0;
    }
    return text.append(backslashes, '\\');
}

std::string depfile_text(const std::vector<std::string>& results, const std::vector<std::string>& files,
                         DepfileReader reader) {
    std::string text;
    for (const std::string& result : results)
        text += (text.empty() ? "" : " ") + depfile_name(result, DepfileSide::Result, reader).value();
    text += ':';
    for (const std::string& file : files) text += " \\\n  " + depfile_name(file, DepfileSide::File, reader).value();
    text += '\n';
    for (const std::string& file : files)
        if (std::ranges::find(results, file) == results.end())
            if (const auto rule = depfile_name(file, DepfileSide::Result, reader)) text += '\n' + *rule + ":\n";
    return text;
}

std::optional<OutputFile> depfile_of(const std::vector<OutputFile>& made, CommandContext& job) {
    if (!job.options.depfile || job.depfile_written) return {};
    std::vector<std::string> results, files;
    if (job.options.depfile_target) results = {*job.options.depfile_target};
    else
        for (const OutputFile& file : made) results.push_back(file.path.string());
    if (results.empty()) return {};
    for (const InputFile& input : job.inputs)
        if (input.path != "-" && !own_descriptor(input.path) && std::ranges::find(files, input.path) == files.end())
            files.push_back(input.path);
    const DepfileReader reader = job.options.depfile_reader.value_or(DepfileReader::Make);
    for (const auto& [names, side] : {std::pair{&results, DepfileSide::Result}, std::pair{&files, DepfileSide::File}})
        for (const std::string& name : *names) {
            if (depfile_name(name, side, reader)) continue;
            job.diagnostics.add(messages::not_in_depfile(name, word(reader)));
            return {};
        }
    job.depfile_written = true;
    return OutputFile{*job.options.depfile, depfile_text(results, files, reader)};
}

}  // namespace grafverif::app
