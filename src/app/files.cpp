// SPDX-License-Identifier: MIT
#include "app/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace grafverif::app {

namespace fs = std::filesystem;

std::optional<std::string> read_file(const fs::path& path, std::string& why) {
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (!fs::exists(status)) return why = "no such file", std::nullopt;
    if (fs::is_directory(status)) return why = "it is a directory", std::nullopt;

    std::ifstream file(path, std::ios::binary);
    if (!file) return why = std::generic_category().message(errno), std::nullopt;
    std::string content;
    std::string block(std::size_t{1} << 20U, '\0');
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
        content.append(block, 0, static_cast<std::size_t>(file.gcount()));
        if (content.size() > largest_input) return why = fmt::format("larger than {} MiB", largest_input >> 20U), std::nullopt;
    }
    if (file.bad()) return why = "reading failed", std::nullopt;
    return content;
}

namespace {

/// Folders and temporary files made so far; taken back unless everything went well.
class Undo {
public:
    Undo() = default;
    Undo(const Undo&) = delete;
    Undo& operator=(const Undo&) = delete;
    ~Undo() {
        std::error_code ignored;
        for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);
    }
    void remember(const fs::path& made) { made_.push_back(made); }
    void forget() { made_.clear(); }

private:
    std::vector<fs::path> made_ = {};
};

void make_folder(const fs::path& folder, Undo& undo) {
    if (folder.empty() || fs::is_directory(folder)) return;
    make_folder(folder.parent_path(), undo);
    if (fs::create_directory(folder)) undo.remember(folder);
}

void write_file(const fs::path& path, const std::string& content) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) throw fs::filesystem_error("cannot write", path, std::error_code(errno != 0 ? errno : EIO, std::generic_category()));
}

}  // namespace

void write_files(const std::vector<OutputFile>& files) {
    struct Draft {
        fs::path place = {};    ///< the file itself, links followed
        fs::path beside = {};   ///< empty: a special file (a pipe, /dev/stdout), which is written, not replaced
    };
    Undo undo;
    std::vector<Draft> drafts;
    for (const OutputFile& file : files) {
        make_folder(file.path.parent_path(), undo);
        const fs::file_status status = fs::status(file.path);
        if (fs::is_directory(status))
            throw fs::filesystem_error("cannot write", file.path, std::make_error_code(std::errc::is_a_directory));
        Draft draft{file.path, {}};
        if (!fs::exists(status) || fs::is_regular_file(status)) {
            if (fs::is_symlink(file.path)) draft.place = fs::weakly_canonical(file.path);
            draft.beside = draft.place;
            draft.beside += fmt::format(".{}.part", ::getpid());
            undo.remember(draft.beside);
            write_file(draft.beside, file.content);
            if (fs::exists(status)) fs::permissions(draft.beside, status.permissions());
        }
        drafts.push_back(std::move(draft));
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (drafts[i].beside.empty()) write_file(drafts[i].place, files[i].content);
        else fs::rename(drafts[i].beside, drafts[i].place);
    }
    undo.forget();
}

}  // namespace grafverif::app
