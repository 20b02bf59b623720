// SPDX-License-Identifier: MIT
// Receiver: a thread that receives messages and puts them into an inbox, so that a message can cancel the work on an
// earlier message.
#pragma once

#include <functional>
#include <optional>
#include <thread>

#include "rpc/framing.hpp"
#include "rpc/inbox.hpp"

namespace grafverif::rpc {

/// Returns the next message, in the same way as Framing::next.
using NextMessage = std::function<std::optional<Framed>()>;

class Receiver {
public:
    struct Callbacks {
        NextMessage next = {};
        /// Puts an item into the inbox. Returns false after the last message.
        std::function<bool(Item item)> put = {};
        std::function<void()> hang_up = {};  ///< ends the wait for bytes; may be empty
    };
    /// The thread calls `next` and `put`. At the end of the stream, the thread closes the inbox.
    Receiver(Callbacks callbacks, Inbox& inbox);
    /// Closes the inbox, so that the thread no longer waits, and joins the thread.
    ~Receiver();
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

private:
    void receive_all() const;
    bool receive_next() const;

    Callbacks callbacks_;
    Inbox& inbox_;
    std::thread thread_;
};

}  // namespace grafverif::rpc
