// SPDX-License-Identifier: MIT
#include "rpc/receiver.hpp"

#include <new>
#include <system_error>
#include <utility>

#include "rpc/message.hpp"
#include "support/memory_reserve.hpp"

namespace grafverif::rpc {

Receiver::Receiver(Callbacks callbacks, Inbox& inbox, std::atomic<bool>& ending)
    : callbacks_(std::move(callbacks)), thread_([this, &inbox, &ending] { receive_all(inbox, ending); }) {}

Receiver::~Receiver() {
    if (callbacks_.hang_up) callbacks_.hang_up();
    thread_.join();
}

/// Puts the next message, or its error, into the inbox. Returns false after the last message.
bool Receiver::receive_next(const NextMessage& next) const {
    Item item;
    try {
        auto framed = next();
        if (!framed) return false;
        item = item_of(std::move(*framed));
    } catch (const std::bad_alloc&) {
        item = {};
        item.refused = true;
    }
    const ReserveUse use(true);
    return callbacks_.put(std::move(item));
}

/// Receives messages until the end of the stream, or until `put` returns false.
void Receiver::receive_all(Inbox& inbox, std::atomic<bool>& ending) const {
    try {
        const NextMessage next = callbacks_.begin();
        for (bool more = true; more;) {
            try {
                more = receive_next(next);
            } catch (const std::bad_alloc&) {  // not even the reserved memory is sufficient for the message
            }
        }
    } catch (const std::bad_alloc&) {  // the buffer for receiving could not be allocated
    } catch (const std::system_error&) {
    }
    ending = true;
    inbox.close();
}

}  // namespace grafverif::rpc
