// SPDX-License-Identifier: MIT
// Session: the state of one client, and the handlers of its messages. Only one thread may use a session.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>

#include "lsp/background_checker.hpp"
#include "lsp/diagnostic_store.hpp"
#include "lsp/names.hpp"
#include "lsp/server.hpp"
#include "lsp/shapes.hpp"
#include "lsp/workspace.hpp"
#include "rpc/message.hpp"

namespace grafverif::lsp {

class Session {
public:
    /// Schedules a call in the thread of the session. Any thread may call this function.
    using Later = std::function<void(std::function<void()>)>;
    /// `ending` is set when the client has sent `exit` or has disappeared.
    Session(const Send& send, const ServerEnvironment& surroundings, Later later, const std::atomic<bool>& ending);

    /// Handles a message. If the message is a request, sends a response.
    void take(const Json& message, bool cancelled);
    /// Sends an error response to invalid input.
    void refuse(const std::string& error_text);
    /// Publishes the diagnostics of changed texts.
    void settle();

    bool over() const { return state_ == State::Over; }
    bool end_requested() const { return end_requested_; }
    std::optional<std::int64_t> client() const { return client_; }

private:
    enum class State { Fresh, Running, ShutDown, Over };
    using RequestError = rpc::RequestError;

    void notified(const std::string& method, const Json& params);
    Json answer(const std::string& method, const Json& params);
    void send(const Json& message);
    void fail(const Json& id, int code, const std::string& message);

    Json initialize(const Json& params);
    void did_open(const Json& params);
    void did_change(const Json& params);
    void publish();

    Json code_actions(const Json& params);

    // The following members are defined in features.cpp.
    struct Pointed {
        std::shared_ptr<const Parsed> file = {};
        const Names* names = nullptr;
        const Declaration* element = nullptr;  ///< the element at the position, or null
        Span where = {};                       ///< position of the element's name; includes the `X` of a step variable
    };
    static Json feature_capabilities();
    std::shared_ptr<const Parsed> parsed(const Json& params);
    const Names& names(const std::string& path);
    Pointed pointed(const Json& params);
    Json place_json(const Parsed& file, Span where) const;
    Json hover(const Json& params);
    Json definition(const Json& params);
    Json references(const Json& params);
    Json highlights(const Json& params);
    Json prepare_rename(const Json& params);
    Json rename(const Json& params);
    Json symbols(const Json& params);
    Json folding(const Json& params);
    Json semantic_tokens(const Json& params);
    Json completion(const Json& params);
    Json formatting(const Json& params);
    std::string verdict_text(const Declaration& element) const;

    // The following members are defined in proofs.cpp.
    void saved();
    void prove(const std::string& path, const std::string& only);
    void found(Found outcome);
    void progress(const std::string& words);
    void progress_is_requested();
    Json lenses(const Json& params);
    Json execute(const Json& params);
    Json show_verdict(const std::string& path, const std::string& loop, const std::string& property);
    Json draw(const std::string& path, const std::string& chart);
    Json simulate(const std::string& path);
    /// Shows the document at the address `uri` if the client can show documents; otherwise, shows the message `words`.
    Json show(const std::string& uri, bool elsewhere, const std::string& words);
    const VerdictDetails* shown(const std::string& path, const std::string& key) const;
    void request_client(const std::string& id, const std::string& method, const Json& params);

    /// Returns the path of the document in `params`. Throws RequestError if the document is not open.
    std::string document(const Json& params) const;
    UriOf uris() const;

    const Send& send_;
    const ServerEnvironment& surroundings_;
    State state_ = State::Fresh;
    bool end_requested_ = false;
    std::optional<std::int64_t> client_ = {};

    /// Error codes of LSP 3.17 ("ErrorCodes").
    static constexpr int not_initialized = -32002, request_failed = -32803, request_cancelled = -32800;

    Workspace workspace_;
    DiagnosticStore board_ = {};
    std::vector<std::shared_ptr<const Root>> named_ = {};  ///< the roots from which `names_` was built
    std::unique_ptr<const Names> names_ = {};
    bool dirty_ = false;  ///< true if a text has changed, or the current diagnostics have not been sent to the client
    std::vector<std::shared_ptr<const Root>> unmade_ = {};  ///< roots whose models have not been requested yet
    std::map<std::string, std::string> published_ = {};     ///< the last published diagnostics for each address

    struct Client {
        bool takes_snippets = false, shows_documents = false, shows_progress = false, refreshes_lenses = false;
    };
    Client can_ = {};
    struct Verdicts {
        std::uint64_t number = 0;  ///< number of the parse to which the verdicts belong
        std::map<std::string, VerdictDetails> by_key = {};
    };
    std::map<std::string, Verdicts> verdicts_ = {};  ///< verdicts by path of the root
    enum class ProgressState { Nothing, Requested, Going };
    ProgressState progress_state_ = ProgressState::Nothing;  ///< state of the progress report to the client
    std::uint64_t token_ = 0;
    std::unique_ptr<BackgroundChecker> prover_;  ///< declared last, so that it is destroyed first
};

}  // namespace grafverif::lsp
