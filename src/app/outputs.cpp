// SPDX-License-Identifier: MIT
#include "app/outputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ostream>

#include "app/depfile.hpp"
#include "app/system/watchdog.hpp"
#include "pipeline/files.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

std::vector<std::string> outputs_of(const Options& options) {
    std::vector<std::string> paths;
    for (const NamedPath& one : named_paths(options))
        if (one.use != PathUse::Read) paths.push_back(one.path);
    return paths;
}

bool differ(const std::vector<std::string>& paths, CommandContext& job) {
    for (std::size_t k = 1; k < paths.size(); ++k)
        for (std::size_t i = 0; i < k; ++i) {
            const std::string identity = file_identity(paths[k]);
            if (paths[k] == "-" || identity.empty() || identity != file_identity(paths[i])) continue;
            job.diagnostics.add(messages::output_twice(paths[i], paths[k]));
            return false;
        }
    return true;
}

bool is_no_input(const std::string& path, CommandContext& job) {
    const std::string identity = path == "-" ? "" : file_identity(path);
    for (const InputFile& input : job.inputs) {
        if (identity.empty() || identity != input.identity) continue;
        job.diagnostics.add(messages::output_is_input(path, input.path));
        return false;
    }
    return true;
}

/// Returns the extension of `path` if it denotes a picture or document format that the command does not write;
/// otherwise an empty string. `drawing` is true for `draw`, which writes SVG but not HTML. `page` is true for `report`
/// and `--report`, which write HTML but not SVG.
std::string foreign_format(const std::filesystem::path& path, bool drawing, bool page) {
    constexpr std::array<std::string_view, 13> never = {"png",  "jpg", "jpeg", "gif", "webp", "bmp", "tif",
                                                        "tiff", "pdf", "ps",   "eps", "emf",  "docx"};
    std::string ending = path.extension().string();
    if (ending.empty()) return {};
    ending.erase(0, 1);
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const bool known =
        std::ranges::find(never, ending) != never.end() || (drawing && ending == "html") || (page && ending == "svg");
    return known ? ending : std::string();
}

/// A standard stream and the properties of its terminal.
struct OutputStream {
    std::ostream* stream = nullptr;
    bool terminal = false;
};

/// Returns the output stream that `path` names. The stream is null if `path` names a file.
OutputStream outlet_of(const std::filesystem::path& path, const Streams& streams) {
    if (names_output(path.string()))
        return streams.documents != nullptr ? OutputStream{streams.documents, streams.documents_screen.terminal}
                                            : OutputStream{&streams.out, streams.out_screen.terminal};
    if (own_descriptor(path) == STDERR_FILENO) return {&streams.err, streams.err_screen.terminal};
    return {};
}

}  // namespace

bool names_input(const std::string& path) { return path == "-" || own_descriptor(path) == STDIN_FILENO; }

bool names_output(const std::string& path) { return path == "-" || own_descriptor(path) == STDOUT_FILENO; }

bool reports_on_output(const Options& options) {
    return std::ranges::any_of(named_paths(options), [](const NamedPath& one) {
        return one.use == PathUse::Written && one.option != "output" && names_output(one.path);
    });
}

bool writes_files(const Options& options) {
    return std::ranges::any_of(outputs_of(options), [](const std::string& path) { return !names_output(path); });
}

bool outputs_differ(CommandContext& job) { return differ(outputs_of(job.options), job); }

bool formats_are_written(std::string_view verb, CommandContext& job) {
    bool fine = true;
    const auto check = [&](const std::optional<std::string>& path, bool drawing, bool page) {
        const std::string format = path ? foreign_format(*path, drawing, page) : std::string();
        if (format.empty()) return;
        const std::string stem = std::filesystem::path(*path).replace_extension().string();
        const bool converts = format == "png" || format == "pdf" || format == "ps" || format == "eps";
        std::string_view written = "text";
        std::string how = "choose another name";
        if (drawing) {
            written = "SVG";
            how = fmt::format("write `{}.svg`", stem);
            if (converts) how += fmt::format(" and convert it: `rsvg-convert -f {1} -o {0}.{1} {0}.svg`", stem, format);
        } else if (page) {
            written = "HTML";
            how = fmt::format("write `{}.html`", stem);
            if (format == "pdf")
                how += fmt::format(" and print it: `chromium --headless --print-to-pdf={0}.pdf {0}.html`", stem);
        }
        std::string named = format;
        for (char& c : named) c = static_cast<char>(c - 'a' + 'A');
        job.diagnostics.add(messages::other_format(*path, named, written, how));
        fine = false;
    };
    check(job.options.output, verb == "draw", verb == "report");
    check(job.options.trace_svg, true, false);
    check(job.options.page, false, true);
    return fine;
}

bool folders_are_there(bool folder, CommandContext& job) {
    if (job.options.create) return true;
    for (const auto& [option, path, use] : named_paths(job.options)) {
        if (use == PathUse::Read) continue;
        std::filesystem::path file(path);
        // Handles a path that ends in a slash: `DIR/`.
        if (use == PathUse::WrittenFolder && !file.has_filename()) file = file.parent_path();
        const bool is_folder = folder && option == "output";
        const std::filesystem::path needed = is_folder ? file : file.parent_path();
        std::error_code failure;
        if (path == "-" || needed.empty() || std::filesystem::exists(needed, failure)) continue;
        job.diagnostics.add(messages::missing_folder(path, needed.string()));
        return false;
    }
    return true;
}

bool note_input(const std::string& path, CommandContext& job) {
    job.inputs.push_back({path, file_identity(path == "-" ? "/dev/stdin" : path)});
    bool fine = true;
    for (const std::string& output : outputs_of(job.options)) fine = is_no_input(output, job) && fine;
    return fine;
}

bool write_outputs(const std::vector<OutputFile>& files, CommandContext& job, const Streams& streams) {
    work_is_done();
    std::vector<std::string> paths;
    std::vector<OutputFile> others;
    for (const OutputFile& file : files) {
        paths.push_back(file.path.string());
        if (!is_no_input(paths.back(), job)) return false;
        if (outlet_of(file.path, streams).stream == nullptr) others.push_back(file);
    }
    if (!differ(paths, job)) return false;
    std::vector<OutputFile> streamed = files;
    if (auto depfile = depfile_of(others, job)) {
        const bool is_file = outlet_of(depfile->path, streams).stream == nullptr;
        std::vector<OutputFile>& all = is_file ? others : streamed;
        all.insert(all.begin(), std::move(*depfile));
    }
    if (job.diagnostics.has_errors() && job.options.depfile) return false;
    write_files(others);
    for (const OutputFile& file : streamed)
        if (const OutputStream outlet = outlet_of(file.path, streams); outlet.stream != nullptr)
            *outlet.stream << (outlet.terminal ? printable_lines(file.content) : file.content);
    return true;
}

}  // namespace grafverif::app
