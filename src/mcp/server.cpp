// SPDX-License-Identifier: MIT
#include "mcp/server.hpp"

#include <new>
#include <nlohmann/json.hpp>
#include <system_error>

#include "mcp/session.hpp"
#include "rpc/inbox.hpp"
#include "rpc/receiver.hpp"
#include "support/memory_reserve.hpp"

namespace grafverif::mcp {

namespace {

/// Interval at which progress is reported.
constexpr std::chrono::milliseconds tick{250};

}  // namespace

void converse(const rpc::Receive& receive, const Send& send, const ServerEnvironment& environment) {
    rpc::Inbox inbox;
    Session session(send, environment, [&](std::function<void()> call) { inbox.put({.call = std::move(call)}); });
    rpc::LineFraming framing(receive, largest_message);
    const auto put = [&](rpc::Item item) {
        inbox.put(std::move(item));
        inbox.wait_for_room(most_messages);
        return true;
    };
    const rpc::Receiver receiver({[&] { return framing.next(); }, put, environment.hang_up}, inbox);
    // After the end of the stream, requests that were received before are still handled; waiting calls are cancelled.
    while (!session.disconnected()) {
        if (environment.keep_memory_back) environment.keep_memory_back();
        try {
            const ReserveUse use(true);  // allocations for the report of a failure may use the reserved memory
            const auto item = inbox.take(tick);
            if (item && item->call) item->call();
            else if (item && item->message != nullptr) session.take(*item->message);
            else if (item)
                session.refuse(item->refused ? "there is not enough memory for the message" : item->error_text);
            else if (inbox.closed()) break;
            session.report_progress();
        } catch (const std::bad_alloc&) {  // no error response is sent, because it would also need memory
        } catch (const std::system_error&) {
        }
    }
}

}  // namespace grafverif::mcp
