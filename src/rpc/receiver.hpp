// SPDX-License-Identifier: MIT
// Receiver: a thread that receives messages and puts them into an inbox, so that a message can cancel the work on an
// earlier one.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <thread>

#include "rpc/framing.hpp"
#include "rpc/inbox.hpp"

namespace grafverif::rpc {

/// Returns the next message, as Framing::next.
using NextMessage = std::function<std::optional<Framed>()>;

class Receiver {
public:
    struct Callbacks {
        std::function<NextMessage()> begin = {};  ///< starts to receive; called once
        /// Puts an item into the inbox. Returns false after the last message.
        std::function<bool(Item item)> put = {};
        std::function<void()> hang_up = {};  ///< ends the wait for bytes; may be empty
    };
    /// The thread calls `begin` and `put`. At the end of the stream, it sets `ending` and closes the inbox.
    Receiver(Callbacks callbacks, Inbox& inbox, std::atomic<bool>& ending);
    /// Joins the thread.
    ~Receiver();
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

private:
    void receive_all(Inbox& inbox, std::atomic<bool>& ending) const;
    bool receive_next(const NextMessage& next) const;

    Callbacks callbacks_;
    std::thread thread_;
};

}  // namespace grafverif::rpc
