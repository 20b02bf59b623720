// SPDX-License-Identifier: MIT
#include "app/depfile.hpp"

#include <algorithm>

#include "pipeline/files.hpp"
#include "support/messages.hpp"

namespace grafverif::app {

std::string make_name(std::string_view name) {
    std::string text;
    std::size_t backslashes = 0;  // just before
    for (const char c : name) {
        if (c == ' ' || c == '\t' || c == '#' || c == ':') text.append(backslashes + 1, '\\');
        if (c == '$') text += '$';
        text += c;
        backslashes = c == '\\' ? backslashes + 1 : 0;
    }
    return text.append(backslashes, '\\');
}

std::string depfile_text(const std::vector<std::string>& results, const std::vector<std::string>& files) {
    std::string text;
    for (const std::string& result : results) text += (text.empty() ? "" : " ") + make_name(result);
    text += ':';
    for (const std::string& file : files) text += " \\\n  " + make_name(file);
    text += '\n';
    for (const std::string& file : files)
        if (std::ranges::find(results, file) == results.end()) text += '\n' + make_name(file) + ":\n";
    return text;
}

std::optional<OutputFile> depfile_of(const std::vector<OutputFile>& made, Job& job) {
    if (!job.options.depfile || job.depfile_written) return {};
    std::vector<std::string> results, files;
    if (job.options.depfile_target) results = {*job.options.depfile_target};
    else
        for (const OutputFile& file : made) results.push_back(file.path.string());
    if (results.empty()) return {};
    for (const InputFile& input : job.inputs)
        if (input.path != "-" && !own_descriptor(input.path) && std::ranges::find(files, input.path) == files.end())
            files.push_back(input.path);
    for (const std::vector<std::string>* names : {&results, &files})
        for (const std::string& name : *names) {
            if (name.find_first_of("\n\r") == std::string::npos) continue;
            job.diagnostics.add(messages::not_in_depfile(name));
            return {};
        }
    job.depfile_written = true;
    return OutputFile{*job.options.depfile, depfile_text(results, files)};
}

}  // namespace grafverif::app
