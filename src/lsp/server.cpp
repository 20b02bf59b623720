// SPDX-License-Identifier: MIT
#include "lsp/server.hpp"

#include <new>
#include <nlohmann/json.hpp>
#include <system_error>

#include "lsp/session.hpp"
#include "rpc/message.hpp"
#include "rpc/receiver.hpp"
#include "support/memory_reserve.hpp"

namespace grafverif::lsp {

namespace {

using namespace std::chrono_literals;

/// Interval at which the client process and the files are polled.
constexpr auto check_interval = 250ms;

/// Puts a message into the inbox, or cancels a request. Returns false after the last message.
bool put(rpc::Item item, rpc::Inbox& inbox) {
    const std::string method = item.message != nullptr ? rpc::method_of(*item.message) : std::string();
    if (method == "$/cancelRequest") inbox.cancel(rpc::member(rpc::member(*item.message, "params"), "id"));
    else inbox.put(std::move(item));
    return method != "exit";
}

}  // namespace

Ending converse(const Receive& receive, const Send& send, const ServerEnvironment& surroundings) {
    rpc::Inbox inbox;
    Session session(
        send, surroundings, [&](std::function<void()> call) { inbox.put({.call = std::move(call)}); }, inbox.closing());
    rpc::Framing framing(receive);
    const rpc::Receiver receiver({[&] { return framing.next(); },
                                  [&](rpc::Item item) { return put(std::move(item), inbox); }, surroundings.hang_up},
                                 inbox);
    bool disconnected = false;
    while (!session.over() && !disconnected) {
        if (surroundings.keep_memory_back) surroundings.keep_memory_back();
        try {
            const ReserveUse use(true);  // allocations for the report of a failure may use the reserved memory
            auto item = inbox.take(0ms);
            if (!item) {
                session.settle();
                item = inbox.take(check_interval);
            }
            if (item && item->call) item->call();
            else if (item && item->message != nullptr) session.take(*item->message, item->cancelled);
            else if (item)
                session.refuse(item->refused ? "there is not enough memory for the message" : item->error_text);
            else if (inbox.closed()) disconnected = true;
            else if (session.client() && surroundings.is_alive)
                disconnected = !surroundings.is_alive(*session.client());
        } catch (const std::bad_alloc&) {  // no error response is sent, because it would also need memory
        } catch (const std::system_error&) {
        }
    }
    if (disconnected) return Ending::Gone;
    return session.end_requested() ? Ending::Requested : Ending::Unrequested;
}

}  // namespace grafverif::lsp
