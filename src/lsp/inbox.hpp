// SPDX-License-Identifier: MIT
// Inbox: queue of messages of the client and results of other threads, in order.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace grafverif::lsp {

/// A message, an error in one, or a function to call.
struct Item {
    std::shared_ptr<const nlohmann::json> message = {};
    std::string error_text = {};
    bool refused = false;  ///< there was no memory for the message
    bool cancelled = false;
    std::function<void()> call = {};
};

class Inbox {
public:
    void put(Item item);
    /// Cancels the request with that id, given as JSON, if it is still queued.
    void cancel(const nlohmann::json& id);
    /// Closes the queue: no further items are added.
    void close();

    /// The next item; nothing if none arrives within `patience`, or the queue is closed.
    std::optional<Item> take(std::chrono::milliseconds patience);
    bool closed() const;

private:
    mutable std::mutex door_ = {};
    std::condition_variable wake_ = {};
    std::deque<Item> items_ = {};
    bool closed_ = false;
};

}  // namespace grafverif::lsp
