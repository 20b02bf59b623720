// SPDX-License-Identifier: MIT
#include "app/serve/edited_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <climits>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/serve/page_text.hpp"
#include "app/serve/play.hpp"
#include "app/serve/request_json.hpp"
#include "app/system/write_files.hpp"
#include "pipeline/files.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"
#include "syntax/language/readable.hpp"

namespace grafverif::app {

namespace {

using Json = nlohmann::ordered_json;
using edit::OperationKind;
using namespace std::chrono_literals;

constexpr auto edited_poll_interval = 100ms;
constexpr std::size_t most_drawn_steps = 5'000;
/// Maximum size of a recovery file: two texts, in which a byte becomes up to six bytes of JSON.
constexpr std::size_t largest_recovery = 13 * largest_edited;
constexpr std::array<std::pair<std::string_view, OperationKind>, 15> operations = {{
    {"step-after", OperationKind::StepAfter},
    {"step-before", OperationKind::StepBefore},
    {"transition", OperationKind::Transition},
    {"alternative", OperationKind::Alternative},
    {"parallel", OperationKind::Parallel},
    {"jump", OperationKind::Jump},
    {"action", OperationKind::Action},
    {"replace", OperationKind::Replace},
    {"delete", OperationKind::Delete},
    {"rename", OperationKind::Rename},
    {"paste", OperationKind::Paste},
    {"declare", OperationKind::Declare},
    {"partial", OperationKind::Partial},
    {"macro", OperationKind::Macro},
    {"enclosing", OperationKind::Enclosing},
}};

std::string text_in(const Json& json, const char* key) {
    return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string();
}

std::optional<std::uint32_t> number_in(const Json& json, const char* key) {
    if (!json.contains(key) || !json[key].is_number_unsigned() || json[key].get<std::uint64_t>() > largest_edited)
        return {};
    return json[key].get<std::uint32_t>();
}

/// Returns an operation, or an empty result if the request is malformed.
std::optional<edit::Operation> operation_of(const Json& json) {
    const auto known =
        std::ranges::find(operations, text_in(json, "operation"), [](const auto& each) { return each.first; });
    const auto at = number_in(json, "at");
    const std::string text = text_in(json, "text");
    if (known == operations.end() || !at || text.find('\0') != std::string::npos) return {};
    return edit::Operation{known->second, *at, number_in(json, "target"), text};
}

/// Returns the areas of the elements of a drawing by id, as `[x, y, width, height]`: the first box of each element, or
/// its texts if it has no box.
std::map<std::string, Json> areas_of(const Drawing& drawing) {
    std::map<std::string, Json> areas;
    for (const Drawing::Element& element : drawing.elements) {
        if (element.id.empty()) continue;
        int left = INT_MAX, top = INT_MAX, right = 0, bottom = 0;
        const auto include = [&](int x, int y, int width, int height) {
            left = std::min(left, x), top = std::min(top, y);
            right = std::max(right, x + width), bottom = std::max(bottom, y + height);
        };
        if (!element.boxes.empty()) {
            const Drawing::Box& box = element.boxes.front();
            include(box.at.x, box.at.y, box.size.width, box.size.height);
        }
        for (const Drawing::Text& text : element.texts)
            if (element.boxes.empty()) include(text.at.x, text.at.y - text.size, text.width, text.size + 4);
        if (right > left) areas[element.id] = {left, top, right - left, bottom - top};
    }
    return areas;
}

Json diagnostics_json(const lsp::Root& root) {
    Json list = Json::array();
    for (const lsp::LspDiagnostic& each : root.typed) {
        const bool here = each.where.path == root.path;
        const std::string file = std::filesystem::path(each.where.path).filename().string();
        list.push_back({{"line", each.where.range.start.line},
                        {"character", each.where.range.start.character},
                        {"end_line", each.where.range.end.line},
                        {"end_character", each.where.range.end.character},
                        {"file", here ? Json(nullptr) : Json(file)},
                        {"error", each.severity == Severity::Error},
                        {"code", each.code},
                        {"message", printable(each.message)}});
    }
    return list;
}

}  // namespace

std::string edit_obstacle(const std::string& content) {
    if (content.size() > largest_edited) return "the file is larger than 4 MiB; use a text editor";
    Sources sources;
    const Id<Source> source = sources.add({"", content});
    Diagnostics diagnostics;
    const bool is_text = content.find('\0') == std::string::npos &&
                         is_readable({source, 0, static_cast<std::uint32_t>(content.size())}, sources, diagnostics);
    return is_text ? "" : "the file is not text in UTF-8";
}

EditedFile::EditedFile(const Options& options, std::string text)
    : path_(std::filesystem::absolute(options.operands[0])),
      recovery_(path_.parent_path() / ("." + path_.filename().string() + ".unsaved")),
      document_(path_.string(), options.include_folders, text),
      disk_(std::move(text)) {
    restore();
    take_text();
}

// -- the file and the recovery file -----------------------------------------------------------------------------------

void EditedFile::begin(std::function<void()> changing, std::function<void()> changed) {
    changing_ = std::move(changing);
    changed_ = std::move(changed);
    thread_ = std::jthread([this] { watch(); });
}

void EditedFile::end() {
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    wake_.notify_all();
    if (!thread_.joinable()) return;
    thread_.join();
    const std::lock_guard lock(mutex_);
    keep_unsaved();
}

void EditedFile::watch() {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, edited_poll_interval, [this] { return over_; })) {
        const std::uint64_t before = version_;
        try {
            take_changes();
            keep_unsaved();
        } catch (const std::exception&) {
            continue;  // such as exhausted memory; the next iteration tries again
        }
        if (version_ == before) continue;
        lock.unlock();
        changed_();
        lock.lock();
    }
}

/// Updates the text and the state after changes of the files on the disk.
void EditedFile::take_changes() {
    if (included_.changed()) {
        changing_();
        document_.refresh();
        take_text();
    }
    if (watcher_.size() != 0 && !watcher_.changed()) return;
    watcher_.clear();
    watcher_.note(path_.string());
    const auto content = read_disk();
    ++version_;
    if (!content || *content == disk_) return;
    if (*content == document_.text() || !modified()) {
        changing_();
        disk_ = *content;
        other_.reset();
        document_.replace(*content);
        take_text();
    } else {
        other_ = *content;
    }
}

/// Reads the file, and updates `missing_` and `unreadable_`. Returns an empty result if the file is missing, or if its
/// content cannot be edited.
std::optional<std::string> EditedFile::read_disk() {
    std::string why;
    auto content = content_of_file(path_, why, largest_edited);
    std::error_code failure;
    missing_ = !content && !std::filesystem::exists(path_, failure) && !failure;
    if (content) why = edit_obstacle(*content);
    unreadable_ = missing_ || why.empty() || content == disk_
                      ? ""
                      : fmt::format("another program has changed the file, and the page cannot show it: {}", why);
    return unreadable_.empty() ? content : std::nullopt;
}

/// Writes the recovery file if there are changes that are not saved; otherwise removes it. Neither writes nor removes a
/// recovery file that another server has written.
void EditedFile::keep_unsaved() {
    if (modified() ? is_kept() : !kept_) return;
    try {
        std::error_code ignored;
        const auto type = std::filesystem::symlink_status(recovery_, ignored).type();
        std::string why;
        const auto content = content_of_file(recovery_, why, largest_recovery);
        const bool is_own = type == std::filesystem::file_type::not_found || type == std::filesystem::file_type::none ||
                            (type == std::filesystem::file_type::regular && content && *content == recovered_);
        if (!is_own && modified())
            throw std::runtime_error(fmt::format("another program has written `{}`", recovery_.filename().string()));
        if (modified()) {
            Kept kept{disk_, document_.text()};
            std::string json = json_text(Json{{"base", kept.base}, {"text", kept.text}}, -1);
            write_files({{.path = recovery_, .content = json, .mode = 0600, .replaces = recovered_}});
            recovered_ = std::move(json);
            kept_ = std::move(kept);
        } else {
            if (is_own) std::filesystem::remove(recovery_);
            kept_.reset();
        }
        if (!not_kept_.empty() || !notice_.empty()) ++version_;
        not_kept_.clear();
        notice_.clear();
    } catch (const std::exception& failure) {
        if (not_kept_ != failure.what()) ++version_;
        not_kept_ = failure.what();
    }
}

/// Restores the changes of an earlier run from the recovery file.
void EditedFile::restore() {
    std::string why;
    const auto content = content_of_file(recovery_, why, largest_recovery);
    if (!content) return;
    recovered_ = *content;
    const Json json = shallow_json(*content, 3);
    const bool is_valid = json.is_object() && json.contains("text") && json["text"].is_string();
    Kept kept{text_in(json, "base"), text_in(json, "text")};
    if (!is_valid || !edit_obstacle(kept.text).empty()) {
        notice_ = fmt::format("`{}` is damaged and was ignored", recovery_.filename().string());
        return;
    }
    kept_ = std::move(kept);
    if (kept_->text == disk_) return;
    document_.replace(kept_->text);
    restored_ = true;
    if (kept_->base != disk_) other_ = disk_;
}

std::string EditedFile::save() {
    const std::string conflict = "another program has changed the file; choose which version to keep";
    if (other_) return conflict;
    if (document_.text().size() > largest_edited) return "the text is larger than 4 MiB; shorten it before you save";
    const auto content = read_disk();
    if (!unreadable_.empty()) return "the file was not saved: " + unreadable_;
    if (content && *content != disk_) {
        other_ = *content;
        return conflict;
    }
    try {
        write_files({{.path = path_, .content = document_.text(), .replaces = disk_}});
    } catch (const std::system_error& failure) {
        watcher_.clear();  // another program may have changed the file
        return fmt::format("the file was not saved: {}", failure.what());
    }
    disk_ = document_.text();
    missing_ = restored_ = false;
    watcher_.clear();  // the file is read again, because another program may have changed it in the meantime
    keep_unsaved();
    return {};
}

/// Returns the text of the steps that the request names, to be copied.
std::string EditedFile::copy(const nlohmann::ordered_json& request) {
    std::vector<std::uint32_t> at;
    if (request.contains("steps") && request["steps"].is_array())
        for (const Json& each : request["steps"])
            if (each.is_number_unsigned() && each.get<std::uint64_t>() <= largest_edited) at.push_back(each);
    const edit::Copy copy = number_in(request, "version") == text_version_
                                ? document_.copied(at)
                                : edit::Copy{"the text has changed in the meantime; copy again", {}};
    return json_text(Json{{"problem", printable(copy.obstacle)}, {"text", page_text(copy.text)}}, -1);
}

/// Returns the proposals for completion at a position of the text, between `before` and `after`. Reads only immutable
/// members, without the lock.
std::string EditedFile::completion(const nlohmann::ordered_json& request) const {
    const std::string before = text_in(request, "before"), text = before + text_in(request, "after");
    Json list = Json::array();
    if (edit_obstacle(text).empty())
        for (const lsp::Proposal& each : document_.proposals(text, before.size()))
            list.push_back({{"label", printable(each.label)},
                            {"detail", printable(each.detail)},
                            {"documentation", page_text(each.documentation)},
                            {"snippet", printable(each.snippet)},
                            {"keyword", each.kind == lsp::ProposalKind::Keyword}});
    return json_text(Json{{"problem", ""}, {"proposals", std::move(list)}}, -1);
}

/// Replaces the text as the user has typed it on the page.
std::string EditedFile::type(const nlohmann::ordered_json& request) {
    if (!request.contains("text") || !request["text"].is_string()) return "malformed request; the text is missing";
    const std::string text = text_of_page(text_in(request, "text"), document_.text());
    if (text.size() > largest_edited) return "the text is larger than 4 MiB";
    if (text.find('\0') != std::string::npos) return "the text contains the character U+0000";
    document_.type(text);
    return {};
}

std::string EditedFile::notice() const {
    if (!unreadable_.empty()) return unreadable_;
    if (not_kept_.empty()) return notice_;
    return "the recovery file cannot be written, so save the file before the server ends: " + not_kept_;
}

/// Ends a conflict with another program: keeps the text of the page or of the file.
std::string EditedFile::resolve(const std::string& choice) {
    if (!other_) return "the file has no other version";
    if (choice != "page" && choice != "file") return "the choice must be `page` or `file`";
    disk_ = *std::exchange(other_, std::nullopt);
    if (choice == "file") document_.replace(disk_);
    return {};
}

std::string EditedFile::unsaved() const {
    const std::lock_guard lock(mutex_);
    return modified() && is_kept() ? recovery_.string() : std::string();
}

std::string EditedFile::loss() const {
    const std::lock_guard lock(mutex_);
    return modified() && !is_kept() ? not_kept_ : std::string();
}

std::string EditedFile::text() const {
    const std::lock_guard lock(mutex_);
    return document_.text();
}

// -- requests of a page -----------------------------------------------------------------------------------------------

void EditedFile::take_text() {
    ++version_;
    ++text_version_;
    included_.clear();
    for (const auto& [path, content] : document_.reading().inputs)
        if (path != path_.string() && !path.starts_with('<')) included_.note(path);
}

bool EditedFile::handles(const std::string& path) {
    constexpr std::array paths = {"/edit", "/text", "/undo", "/redo", "/save", "/resolve", "/copy", "/completion"};
    return std::ranges::find(paths, path) != paths.end();
}

std::string EditedFile::respond(const std::string& path, const std::string& body) {
    const Json json = shallow_json(body, 3);
    if (!json.is_object()) return json_text(Json{{"problem", "malformed request; send a JSON object"}}, -1);
    const bool trial = path == "/edit" && json.contains("trial") && json["trial"] == true;
    if (path == "/completion") return completion(json);
    std::unique_lock lock(mutex_);
    if (path == "/copy") return copy(json);
    if (!trial && path != "/save") changing_();
    edit::Change change;
    const std::string before = document_.text();
    if (number_in(json, "version") != text_version_)
        change.obstacle = "the text has changed in the meantime, for example in another window";
    else if (path == "/edit") {
        auto operation = operation_of(json);
        if (operation) operation->text = with_line_ends(operation->text, document_.text());
        if (operation) change = document_.perform(*operation, trial);
        else change.obstacle = "malformed request; the operation or its element is missing";
    } else if (path == "/text") change.obstacle = type(json);
    else if (path == "/undo") change.selected = document_.undo();
    else if (path == "/redo") change.selected = document_.redo();
    else if (path == "/save") change.obstacle = save();
    else if (path == "/resolve") change.obstacle = resolve(text_in(json, "keep"));
    const Json head = {{"problem", printable(change.obstacle)}, {"diagnostics", change.diagnostics}};
    std::string response = json_text(head, -1);
    if (trial) return response;
    if (document_.text() != before) take_text();
    else ++version_;
    response.pop_back();
    if (change.selected)
        response += fmt::format(",\"selected\":{}", PagePositions(document_.text()).of(*change.selected));
    response += ",\"state\":" + state() + '}';
    lock.unlock();
    changed_();
    return response;
}

std::optional<std::string> EditedFile::newer(std::uint64_t known) {
    const std::lock_guard lock(mutex_);
    return version_ == known ? std::nullopt : std::optional(state());
}

/// Returns the drawings of the last text without errors, with their elements.
const std::string& EditedFile::drawings() {
    const auto drawn = document_.drawn();
    if (drawn == drawn_ || drawn == nullptr) return drawings_;
    drawn_ = drawn;
    const Model& model = *drawn->reading.model;
    const PagePositions positions(drawn->reading.sources.begin()->text);
    Json list = Json::array();
    for (const Id<Chart> id : model.charts.ids()) {
        const Chart& chart = model.charts[id];
        if (chart.program) continue;
        const std::string prefix = drawing_prefix(id);
        const bool is_drawn = chart.steps.size() <= most_drawn_steps;
        const Drawing drawing = is_drawn ? document_.drawing(id, prefix) : Drawing();
        const std::map<std::string, Json> areas = areas_of(drawing);
        const auto area = [&](const std::string& element) {
            const auto found = areas.find(element);
            return found == areas.end() ? Json(nullptr) : found->second;
        };
        Json elements = Json::array();
        for (const edit::DrawnElement& each : document_.elements(id, prefix))
            elements.push_back({{"id", each.id},
                                {"area", area(each.id)},
                                {"condition", each.condition},
                                {"condition_area", area(each.condition)},
                                {"kind", each.kind},
                                {"name", each.name},
                                {"text", each.text},
                                {"at", each.where.begin},
                                {"begin", positions.of(each.where.begin)},
                                {"end", positions.of(each.where.end)},
                                {"part", {positions.of(each.part.begin), positions.of(each.part.end)}}});
        list.push_back({{"name", chart.name},
                        {"svg", is_drawn ? Json(svg_of(drawing)) : Json(nullptr)},
                        {"elements", std::move(elements)}});
    }
    return drawings_ = json_text(list, -1);
}

std::string EditedFile::state() {
    const lsp::Root& root = document_.reading();
    const bool readable = document_.drawn().get() == &root;
    Json json = {{"version", version_},
                 {"text_version", text_version_},
                 {"file", path_.filename().string()},
                 {"text", page_text(document_.text())},
                 {"modified", modified()},
                 {"read_only", !missing_ && ::access(path_.c_str(), W_OK) != 0},
                 {"missing", missing_},
                 {"restored", restored_ && modified()},
                 {"notice", printable(notice())},
                 {"other", other_ ? Json(page_text(*other_)) : Json(nullptr)},
                 {"can_undo", document_.can_undo()},
                 {"can_redo", document_.can_redo()},
                 {"readable", readable},
                 {"diagnostics", diagnostics_json(root)}};
    std::string text = json_text(json, -1);
    text.pop_back();
    return text += ",\"charts\":" + drawings() + '}';
}

}  // namespace grafverif::app
