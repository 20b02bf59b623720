// SPDX-License-Identifier: MIT
#include "rpc/receiver.hpp"

#include <new>
#include <system_error>
#include <utility>

#include "rpc/message.hpp"
#include "support/memory_reserve.hpp"

namespace grafverif::rpc {

Receiver::Receiver(Callbacks callbacks, Inbox& inbox)
    : callbacks_(std::move(callbacks)), inbox_(inbox), thread_([this] { receive_all(); }) {}

Receiver::~Receiver() {
    inbox_.close();
    if (callbacks_.hang_up) callbacks_.hang_up();
    thread_.join();
}

/// Puts the next message, or its error, into the inbox. Returns false after the last message.
bool Receiver::receive_next() const {
    Item item;
    try {
        auto framed = callbacks_.next();
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
void Receiver::receive_all() const {
    try {
        for (bool more = true; more;) {
            try {
                more = receive_next();
            } catch (const std::bad_alloc&) {  // even the reserved memory is not sufficient for the message
            }
        }
    } catch (const std::system_error&) {
    }
    inbox_.close();
}

}  // namespace grafverif::rpc
