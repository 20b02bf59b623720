// SPDX-License-Identifier: MIT
// An editor with a folder of files, which sends requests at marked positions.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "unit/lsp/client.hpp"

namespace grafverif::lsp {

// `@` marks the cursor in a text and is removed.
struct Marked {
    std::string text = {};
    Json position = {};
};
inline Marked marked(std::string text) {
    const std::size_t at = text.find('@');
    text.erase(at, 1);
    const Position position = Text(text).position(at);
    return {text, {{"line", position.line}, {"character", position.character}}};
}

class TextEditor {
public:
    /// Writes `files`, which are pairs of a name and a text, into the folder of the workspace.
    explicit TextEditor(const std::vector<std::pair<std::string, std::string>>& files) {
        for (const auto& [name, text] : files) folder.write(name, text);
        client.begin({{"textDocument", {{"completion", {{"completionItem", {{"snippetSupport", true}}}}}}}},
                     folder.path());
    }
    void open(const std::string& name, const std::string& text) { client.open(folder.uri(name), text); }
    /// Sends a request at the cursor in `text`, which becomes the content of `name`.
    Json at(const std::string& method, const std::string& name, const std::string& text, Json more = Json::object()) {
        const Marked here = marked(text);
        open(name, here.text);
        more["textDocument"] = {{"uri", folder.uri(name)}};
        more["position"] = here.position;
        return client.result(method, more);
    }
    Json of(const std::string& method, const std::string& name) {
        return client.result(method, {{"textDocument", {{"uri", folder.uri(name)}}}});
    }
    /// Returns the reason why the name at the cursor cannot be replaced by `fresh`, or `none`.
    std::string obstacle(const std::string& name, const std::string& text, const char* fresh) {
        const Marked here = marked(text);
        open(name, here.text);
        const Json answer = client.answer(client.send_request(
            "textDocument/rename",
            {{"textDocument", {{"uri", folder.uri(name)}}}, {"position", here.position}, {"newName", fresh}}));
        return answer.contains("error") ? answer["error"]["message"].get<std::string>() : "none";
    }
    std::vector<std::string> labels(const std::string& name, const std::string& text) {
        std::vector<std::string> found;
        const Json all = at("textDocument/completion", name, text);
        for (const Json& item : all["items"]) found.push_back(item["label"]);
        return found;
    }

    Folder folder;
    Client client;
};

inline std::string with(std::string text, const std::string& what, const std::string& replacement) {
    return text.replace(text.find(what), what.size(), replacement);
}

inline bool holds(const std::vector<std::string>& labels, const char* label) {
    return std::ranges::find(labels, label) != labels.end();
}

/// Applies edits, which are sorted by position, to a text.
inline std::string edited(std::string text, const Json& edits) {
    for (auto each = edits.rbegin(); each != edits.rend(); ++each) {
        const auto at = [&](const char* end) {
            return Position{(*each)["range"][end]["line"], (*each)["range"][end]["character"]};
        };
        text = changed(Text(text), {Range{at("start"), at("end")}, (*each)["newText"]});
    }
    return text;
}

}  // namespace grafverif::lsp
