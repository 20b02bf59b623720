// SPDX-License-Identifier: MIT
// Inbox: a thread-safe queue of messages from the client and results from other threads, in the order of arrival.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace grafverif::rpc {

/// An element of the queue: a message, an error in a message, or a function to call.
struct Item {
    std::shared_ptr<const nlohmann::json> message = {};
    std::string error_text = {};
    bool refused = false;  ///< true if there was not enough memory to store the message
    bool cancelled = false;
    std::function<void()> call = {};
};

class Inbox {
public:
    void put(Item item);
    /// Cancels the request with the id `id` if the request is still in the queue.
    void cancel(const nlohmann::json& id);
    /// Closes the queue: no further items are added.
    void close();
    /// Waits until the queue has less than `most` items or is closed.
    void wait_for_room(std::size_t most);

    /// Returns the next item. Returns nothing if no item arrives within `timeout`, or if the queue is closed
    /// and empty.
    std::optional<Item> take(std::chrono::milliseconds timeout);
    /// True if the queue is closed and empty.
    bool closed() const;
    /// True as soon as the queue is closed, even if it still contains items.
    const std::atomic<bool>& closing() const { return closed_; }

private:
    mutable std::mutex mutex_ = {};
    std::condition_variable wake_ = {};
    std::deque<Item> items_ = {};
    std::atomic<bool> closed_ = false;  ///< changed only while `mutex_` is locked
};

}  // namespace grafverif::rpc
