// SPDX-License-Identifier: MIT
// Session: what a client has said so far, and the answers to it. Lives on one thread.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>

#include "lsp/board.hpp"
#include "lsp/names.hpp"
#include "lsp/prover.hpp"
#include "lsp/server.hpp"
#include "lsp/shapes.hpp"
#include "lsp/workspace.hpp"

namespace grafverif::lsp {

class Session {
public:
    /// `later` has something called on the thread of the session, from any thread.
    using Later = std::function<void(std::function<void()>)>;
    /// `ending`: the client has said that it ends, or is gone.
    Session(const Send& send, const Surroundings& surroundings, Later later, const std::atomic<bool>& ending);

    /// Answers a message, if it asks for an answer.
    void take(const Json& message, bool cancelled);
    /// Answers what is no message.
    void refuse(const std::string& complaint);
    /// Tells what is wrong with the texts, where they have changed.
    void settle();

    bool over() const { return state_ == State::Over; }
    bool asked_to_end() const { return asked_to_end_; }
    std::optional<std::int64_t> client() const { return client_; }

private:
    enum class State { Fresh, Running, ShutDown, Over };
    struct Refusal {
        int code = 0;
        std::string message = {};
    };

    void notified(const std::string& method, const Json& params);
    Json answer(const std::string& method, const Json& params);
    void send(const Json& message);
    void fail(const Json& id, int code, const std::string& message);

    Json initialize(const Json& params);
    void did_open(const Json& params);
    void did_change(const Json& params);
    void publish();

    Json code_actions(const Json& params);

    // features.cpp
    struct Pointed {
        std::shared_ptr<const Parsed> file = {};
        const Names* names = nullptr;
        std::string key = {};  ///< of what is pointed at; empty: nothing
        Span where = {};
        std::uint32_t skipped = 0;
    };
    static Json feature_capabilities();
    std::shared_ptr<const Parsed> parsed(const Json& params);
    const Names& names(const Parsed& file);
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
    std::string verdict_words(const Thing& thing) const;

    // proofs.cpp
    void saved();
    void prove(const std::string& path, const std::string& only);
    void found(Found outcome);
    void progress(const std::string& words);
    void progress_is_wanted();
    Json lenses(const Json& params);
    Json execute(const Json& params);
    Json show_verdict(const std::string& path, const std::string& loop, const std::string& property);
    Json draw(const std::string& path, const std::string& chart);
    Json simulate(const std::string& path);
    /// Shows what stands at an address, if the client can; else says so.
    Json show(const std::string& uri, bool elsewhere, const std::string& words);
    const Shown* shown(const std::string& path, const std::string& key) const;
    void ask_client(const std::string& id, const std::string& method, const Json& params);

    /// The path of the document that `params` name; refuses one that is not open.
    std::string document(const Json& params) const;
    UriOf uris() const;

    const Send& send_;
    const Surroundings& surroundings_;
    State state_ = State::Fresh;
    bool asked_to_end_ = false;
    std::optional<std::int64_t> client_ = {};

    // JSON-RPC 2.0 section 5.1, LSP 3.17 "ErrorCodes".
    static constexpr int parse_error = -32700, invalid_request = -32600, no_such_method = -32601,
                         invalid_params = -32602, internal_error = -32603, not_initialized = -32002,
                         request_failed = -32803, request_cancelled = -32800;

    Workspace workspace_;
    std::unique_ptr<const Names> names_ = {};
    Board board_ = {};
    bool dirty_ = false;  ///< some text has changed since the last look, or the client does not know yet what is known
    std::vector<std::shared_ptr<const Root>> unmade_ = {};  ///< roots whose models are not asked for yet
    std::map<std::string, std::string> published_ = {};     ///< by address: what the client was told last

    struct Client {
        bool takes_snippets = false, shows_documents = false, shows_progress = false, refreshes_lenses = false;
    };
    Client can_ = {};
    struct Verdicts {
        std::uint64_t number = 0;  ///< of the reading they are of
        std::map<std::string, Shown> by_key = {};
    };
    std::map<std::string, Verdicts> verdicts_ = {};  ///< by path of the root
    enum class Telling { Nothing, Asked, Going };
    Telling telling_ = Telling::Nothing;  ///< of progress, to the client
    std::uint64_t token_ = 0;
    std::unique_ptr<Prover> prover_;  ///< last: it ends first
};

}  // namespace grafverif::lsp
