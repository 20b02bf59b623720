// SPDX-License-Identifier: MIT
// Session: what a client has said so far, and the answers to it. Lives on one thread.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>

#include "lsp/board.hpp"
#include "lsp/server.hpp"
#include "lsp/shapes.hpp"
#include "lsp/workspace.hpp"

namespace grafverif::lsp {

class Session {
public:
    Session(const Send& send, const Surroundings& surroundings)
        : send_(send), surroundings_(surroundings), workspace_(surroundings.include_folders) {}

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

    /// The path of the document that `params` name; refuses one that is not open.
    std::string document(const Json& params) const;
    UriOf uris() const;

    const Send& send_;
    const Surroundings& surroundings_;
    State state_ = State::Fresh;
    bool asked_to_end_ = false;
    std::optional<std::int64_t> client_ = {};

    Workspace workspace_;
    Board board_ = {};
    bool dirty_ = false;                                 ///< some text has changed since the last look
    std::map<std::string, std::string> published_ = {};  ///< by address: what the client was told last
};

}  // namespace grafverif::lsp
