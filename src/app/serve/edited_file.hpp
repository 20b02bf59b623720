// SPDX-License-Identifier: MIT
// EditedFile: the file of `edit`, as a document in memory and as the version on the disk.
//
// Only a request to save writes the file. If another program has changed the file since it was read, the file is not
// written until the user has chosen a version. Changes that are not saved are also kept in a recovery file in the same
// folder, which the next start reads, so that they survive the end of the server. The recovery file is removed when the
// file is saved.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <thread>

#include "app/options.hpp"
#include "edit/document.hpp"
#include "pipeline/file_watcher.hpp"

namespace grafverif::app {

/// Maximum size of a file that can be edited, in bytes.
inline constexpr std::size_t largest_edited = std::size_t{4} << 20U;

/// Returns the reason why a page cannot edit a file with this content, or an empty string.
std::string edit_obstacle(const std::string& content);

class EditedFile {
public:
    /// `text` is the content of the file, the first operand in `options`.
    EditedFile(const Options& options, std::string text);
    ~EditedFile() { end(); }
    EditedFile(const EditedFile&) = delete;
    EditedFile& operator=(const EditedFile&) = delete;

    /// Starts a thread that watches the file and writes the recovery file. After the start,
    /// `changing` is called before each change of the text, and `changed` after the change. Calls
    /// of `text` wait while a change is incomplete.
    void begin(std::function<void()> changing, std::function<void()> changed);
    /// Ends the thread, and writes the recovery file a last time.
    void end();

    /// True if `respond` handles requests with this path, such as `/edit`.
    static bool handles(const std::string& path);
    /// Executes a request of a page. `body` and the response are JSON (docs/how-to/edit.md).
    std::string respond(const std::string& path, const std::string& body);
    /// Returns the state as JSON if it is newer than `known`.
    std::optional<std::string> newer(std::uint64_t known);

    std::string text() const;
    /// Returns the path of the recovery file if it contains changes that are not saved; otherwise an empty string.
    std::string unsaved() const;
    /// If the recovery file does not contain all changes that are not saved, returns the reason; otherwise, returns an
    /// empty string.
    std::string loss() const;

private:
    /// Changes that are in the recovery file: the text, and the content of the file when it was last read or written.
    struct Kept {
        std::string base = {}, text = {};
    };

    void watch();
    void take_changes();
    std::optional<std::string> read_disk();
    void keep_unsaved();
    void restore();
    void take_text();
    bool modified() const { return document_.text() != disk_; }
    bool is_kept() const { return kept_ && kept_->text == document_.text() && kept_->base == disk_; }
    std::string notice() const;
    std::string type(const nlohmann::ordered_json& request);
    std::string copy(const nlohmann::ordered_json& request);
    std::string completion(const nlohmann::ordered_json& request) const;
    std::string save();
    std::string resolve(const std::string& choice);
    const std::string& drawings();
    std::string state();

    std::filesystem::path path_, recovery_;
    std::function<void()> changing_ = [] {}, changed_ = [] {};

    mutable std::mutex mutex_ = {};
    edit::Document document_;
    std::string disk_;                       ///< content of the file when it was last read or written
    std::optional<std::string> other_ = {};  ///< content that another program has written, until the user has chosen
    bool missing_ = false;                   ///< true if the file was deleted
    bool restored_ = false;                  ///< true if the text was read from the recovery file
    std::string unreadable_ = {};            ///< reason why the content of the file cannot be shown
    std::string notice_ = {};                ///< a problem of the recovery file at the start
    std::string not_kept_ = {};              ///< reason why the recovery file could not be written
    std::optional<Kept> kept_ = {};          ///< changes that this server keeps in the recovery file
    std::string recovered_ = {};             ///< content of the recovery file that this server has read or written
    std::uint64_t version_ = 1, text_version_ = 1;
    std::shared_ptr<const lsp::Root> drawn_ = nullptr;
    std::string drawings_ = "[]";  ///< drawings of `drawn_` as JSON
    FileWatcher watcher_ = {}, included_ = {};

    std::condition_variable wake_ = {};
    bool over_ = false;
    std::jthread thread_ = {};
};

}  // namespace grafverif::app
