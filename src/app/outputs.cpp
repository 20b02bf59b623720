// SPDX-License-Identifier: MIT
#include "app/outputs.hpp"

#include <unistd.h>

#include <ostream>

#include "app/depfile.hpp"
#include "app/system/guard.hpp"
#include "pipeline/files.hpp"
#include "support/messages.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

std::vector<std::string> outputs_of(const Options& options) {
    std::vector<std::string> paths;
    for (const std::optional<std::string>* one :
         {&options.output, &options.junit, &options.sarif, &options.trace_vcd, &options.trace_svg, &options.depfile})
        if (*one) paths.push_back(**one);
    return paths;
}

bool differ(const std::vector<std::string>& paths, Job& job) {
    for (std::size_t k = 1; k < paths.size(); ++k)
        for (std::size_t i = 0; i < k; ++i) {
            const std::string identity = file_identity(paths[k]);
            if (paths[k] == "-" || identity.empty() || identity != file_identity(paths[i])) continue;
            job.diagnostics.add(messages::output_twice(paths[i], paths[k]));
            return false;
        }
    return true;
}

bool is_no_input(const std::string& path, Job& job) {
    const std::string identity = path == "-" ? "" : file_identity(path);
    for (const InputFile& input : job.inputs) {
        if (identity.empty() || identity != input.identity) continue;
        job.diagnostics.add(messages::output_is_input(path, input.path));
        return false;
    }
    return true;
}

/// The stream that `path` names; nothing: a file.
std::ostream* stream_at(const std::filesystem::path& path, const Streams& streams) {
    if (path == "-") return &streams.out;
    const auto own = own_descriptor(path);
    return own == STDOUT_FILENO ? &streams.out : own == STDERR_FILENO ? &streams.err : nullptr;
}

}  // namespace

bool outputs_differ(Job& job) { return differ(outputs_of(job.options), job); }

bool folders_are_there(bool folder, Job& job) {
    if (job.options.create) return true;
    for (const std::string& path : outputs_of(job.options)) {
        const std::filesystem::path file(path);
        const bool is_folder = folder && job.options.output == path;
        const std::filesystem::path needed = is_folder ? file : file.parent_path();
        std::error_code failure;
        if (path == "-" || needed.empty() || std::filesystem::exists(needed, failure)) continue;
        job.diagnostics.add(messages::missing_folder(path, needed.string()));
        return false;
    }
    return true;
}

bool note_input(const std::string& path, Job& job) {
    job.inputs.push_back({path, file_identity(path == "-" ? "/dev/stdin" : path)});
    bool fine = true;
    for (const std::string& output : outputs_of(job.options)) fine = is_no_input(output, job) && fine;
    return fine;
}

bool write_outputs(const std::vector<OutputFile>& files, Job& job, const Streams& streams) {
    work_is_done();
    std::vector<std::string> paths;
    std::vector<OutputFile> others;
    for (const OutputFile& file : files) {
        paths.push_back(file.path.string());
        if (!is_no_input(paths.back(), job)) return false;
        if (stream_at(file.path, streams) == nullptr) others.push_back(file);
    }
    if (!differ(paths, job)) return false;
    if (const auto depfile = depfile_of(others, job)) others.insert(others.begin(), *depfile);
    if (job.diagnostics.has_errors() && job.options.depfile) return false;
    write_files(others);
    for (const OutputFile& file : files)
        if (std::ostream* const stream = stream_at(file.path, streams)) {
            const bool terminal = (stream == &streams.out ? streams.out_screen : streams.err_screen).terminal;
            *stream << (terminal ? printable_lines(file.content) : file.content);
        }
    return true;
}

}  // namespace grafverif::app
