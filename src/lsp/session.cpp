// SPDX-License-Identifier: MIT
#include "lsp/session.hpp"

#include <nlohmann/json.hpp>
#include <system_error>

#include "rpc/uri.hpp"

namespace grafverif::lsp {

using rpc::is_id;
using rpc::member;

Session::Session(const Send& send, const ServerEnvironment& surroundings, Later later, const std::atomic<bool>& ending)
    : send_(send), surroundings_(surroundings), workspace_(surroundings.include_folders, surroundings.within, &ending) {
    BackgroundChecker::Callbacks callbacks;
    callbacks.found = [this, later](Found outcome) {
        auto kept = std::make_shared<Found>(std::move(outcome));
        later([this, kept] { found(std::move(*kept)); });
    };
    callbacks.progress = [this, later](std::string words) {
        later([this, words = std::move(words)] { progress(words); });
    };
    prover_ = std::make_unique<BackgroundChecker>(std::move(callbacks), surroundings.response_timeout);
}

void Session::send(const Json& message) { send_(rpc::framed(rpc::text_of(message))); }

void Session::fail(const Json& id, int code, const std::string& message) { send(rpc::failure(id, code, message)); }

void Session::refuse(const std::string& error_text) { fail(nullptr, rpc::parse_error, error_text); }

void Session::take(const Json& message, bool cancelled) {
    const Json& id = member(message, "id");
    const Json& method = member(message, "method");
    if (!method.is_string()) {
        const bool answers = is_id(id) && (message.contains("result") || message.contains("error"));
        if (answers && id == "grafverif/progress/" + std::to_string(token_) && message.contains("result"))
            progress_is_requested();
        if (!answers)
            fail(is_id(id) ? id : Json(), rpc::invalid_request, "the message is neither a request nor a notification");
        return;
    }
    const std::string name = method.get<std::string>();
    const bool request = is_id(id);
    const auto failed = [&](const std::string& why) {
        if (request) return fail(id, rpc::internal_error, why);
        send({{"jsonrpc", "2.0"},
              {"method", "window/showMessage"},
              {"params", {{"type", 1}, {"message", "grafverif: " + name + ": " + why}}}});
    };
    try {
        if (!request) return notified(name, member(message, "params"));
        if (cancelled) return fail(id, request_cancelled, "cancelled");
        send(rpc::response(id, answer(name, member(message, "params"))));
    } catch (const RequestError& refusal) {
        if (request) fail(id, refusal.code, refusal.message);
    } catch (const Json::exception&) {
        if (request) fail(id, rpc::invalid_params, "the parameters of " + name + " do not conform to the protocol");
    } catch (const std::bad_alloc&) {
        failed("out of memory");
    } catch (const std::system_error& failure) {
        failed(failure.what());
    }
}

// -- life cycle -------------------------------------------------------------------------------------------------------

Json Session::initialize(const Json& params) {
    if (member(params, "processId").is_number_integer()) client_ = params["processId"].get<std::int64_t>();
    const Json& folders = member(params, "workspaceFolders");
    for (const Json& folder : folders.is_array() ? folders : Json::array())
        if (member(folder, "uri").is_string())
            workspace_.add_folder(rpc::path_of_uri(folder["uri"].get<std::string>()));
    if (!folders.is_array() && member(params, "rootUri").is_string())
        workspace_.add_folder(rpc::path_of_uri(params["rootUri"].get<std::string>()));
    state_ = State::Running;
    Json capabilities = {
        {"positionEncoding", "utf-16"},
        {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}}},
        {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
        {"workspace", {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}}}},
    };
    capabilities.update(feature_capabilities());
    can_.takes_snippets =
        flag(params, {"capabilities", "textDocument", "completion", "completionItem", "snippetSupport"});
    can_.shows_documents = flag(params, {"capabilities", "window", "showDocument", "support"});
    can_.shows_progress = flag(params, {"capabilities", "window", "workDoneProgress"});
    can_.refreshes_lenses = flag(params, {"capabilities", "workspace", "codeLens", "refreshSupport"});
    return {{"capabilities", std::move(capabilities)},
            {"serverInfo", {{"name", "grafverif"}, {"version", surroundings_.version}}}};
}

void Session::did_open(const Json& params) {
    const Json& document = params.at("textDocument");
    dirty_ = true;
    workspace_.open(document.at("uri").get<std::string>(), document.at("version").get<std::int64_t>(),
                    document.at("text").get_ref<const std::string&>());
}

void Session::did_change(const Json& params) {
    const Json& document = params.at("textDocument");
    dirty_ = true;
    workspace_.change(document.at("uri").get<std::string>(), document.at("version").get<std::int64_t>(),
                      changes_of(params.at("contentChanges")));
}

void Session::notified(const std::string& method, const Json& params) {
    if (method == "exit") {
        end_requested_ = state_ == State::ShutDown;
        state_ = State::Over;
    }
    if (state_ != State::Running) return;
    if (method == "textDocument/didOpen") return did_open(params);
    if (method == "textDocument/didChange") return did_change(params);
    if (method == "textDocument/didClose") {
        workspace_.close(params.at("textDocument").at("uri").get<std::string>());
        dirty_ = true;
    }
    if (method == "textDocument/didSave") saved();
    if (method == "window/workDoneProgress/cancel") prover_->give_up();
    if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles") dirty_ = true;
    if (method == "workspace/didChangeWorkspaceFolders") {
        for (const Json& folder : params.at("event").at("added"))
            workspace_.add_folder(rpc::path_of_uri(folder.at("uri").get<std::string>()));
        dirty_ = true;
    }
}

Json Session::answer(const std::string& method, const Json& params) {
    if (method == "initialize" && state_ == State::Fresh) return initialize(params);
    if (state_ == State::Fresh)
        throw RequestError{not_initialized, "the server is not initialized; send `initialize` first"};
    if (state_ != State::Running) throw RequestError{rpc::invalid_request, method + " is not allowed after `shutdown`"};
    if (method == "initialize") throw RequestError{rpc::invalid_request, "the server is already initialized"};
    if (method == "shutdown") {
        state_ = State::ShutDown;
        return nullptr;
    }
    using Handler = Json (Session::*)(const Json&);
    static const std::map<std::string, Handler> handlers = {
        {"textDocument/codeAction", &Session::code_actions},
        {"textDocument/completion", &Session::completion},
        {"textDocument/codeLens", &Session::lenses},
        {"workspace/executeCommand", &Session::execute},
        {"textDocument/hover", &Session::hover},
        {"textDocument/definition", &Session::definition},
        {"textDocument/references", &Session::references},
        {"textDocument/documentHighlight", &Session::highlights},
        {"textDocument/prepareRename", &Session::prepare_rename},
        {"textDocument/rename", &Session::rename},
        {"textDocument/documentSymbol", &Session::symbols},
        {"textDocument/foldingRange", &Session::folding},
        {"textDocument/semanticTokens/full", &Session::semantic_tokens},
        {"textDocument/formatting", &Session::formatting},
    };
    if (const auto handler = handlers.find(method); handler != handlers.end()) return (this->*handler->second)(params);
    throw RequestError{rpc::no_such_method, "unsupported method " + method};
}

// -- diagnostics ------------------------------------------------------------------------------------------------------

UriOf Session::uris() const {
    return [this](const std::string& path) { return workspace_.uri_of(path); };
}

std::string Session::document(const Json& params) const {
    const auto uri = params.at("textDocument").at("uri").get<std::string>();
    const OpenText* const open = workspace_.find(uri);
    if (open == nullptr) throw RequestError{request_failed, "`" + uri + "` is not open"};
    return open->path;
}

void Session::settle() {
    if (state_ != State::Running) return;
    try {
        dirty_ = workspace_.refresh() || dirty_;
        if (!dirty_) return;
        for (auto& root : board_.look(workspace_))
            if (root->reading.model) unmade_.push_back(std::move(root));
        prover_->keep([this](const Root& root) { return board_.is_current(root); });
        publish();
        for (; !unmade_.empty(); unmade_.pop_back())
            if (board_.is_current(*unmade_.back())) prover_->submit({unmade_.back(), Task::What::Models, ""});
        dirty_ = false;
    } catch (const std::bad_alloc&) {  // `dirty_` is still true, so that the next call tries again
    } catch (const std::system_error&) {
    }
}

void Session::publish() {
    std::map<std::string, std::string> now;
    for (const auto& [path, diagnostics] : board_.all()) {
        const std::string uri = workspace_.uri_of(path);
        Json params = {{"uri", uri}, {"diagnostics", Json::array()}};
        for (const LspDiagnostic& one : diagnostics) params["diagnostics"].push_back(json_of(one, uris()));
        now[uri] = params.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    for (const OpenText& open : workspace_.open_texts())
        now.try_emplace(open.uri, Json{{"uri", open.uri}, {"diagnostics", Json::array()}}.dump());
    for (const auto& [uri, params] : published_)
        if (!now.contains(uri))
            send_(rpc::framed(Json{{"jsonrpc", "2.0"},
                                   {"method", "textDocument/publishDiagnostics"},
                                   {"params", {{"uri", uri}, {"diagnostics", Json::array()}}}}
                                  .dump()));
    for (const auto& [uri, params] : now) {
        const auto before = published_.find(uri);
        if (before != published_.end() && before->second == params) continue;
        Json parameters = Json::parse(params);
        if (const OpenText* const open = workspace_.find(uri)) parameters["version"] = open->version;
        send({{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", std::move(parameters)}});
    }
    published_ = std::move(now);
}

Json Session::code_actions(const Json& params) {
    const std::string path = document(params);
    const Range requested = range_of(params.at("range"));
    settle();
    Json actions = Json::array();
    const auto all = board_.all();
    const auto here = all.find(path);
    if (here == all.end()) return actions;
    for (const LspDiagnostic& one : here->second)
        if (one.fix && one.where.range.start <= requested.end && requested.start <= one.where.range.end)
            actions.push_back(quick_fix(one, uris()));
    return actions;
}

}  // namespace grafverif::lsp
