// SPDX-License-Identifier: MIT
#include "mcp/server.hpp"

#include <memory>
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
constexpr std::chrono::milliseconds tick{50};

rpc::Receiver::Callbacks receiver_callbacks(const rpc::Receive& receive, rpc::Inbox& inbox,
                                            const std::function<void()>& hang_up) {
    const auto begin = [&receive]() -> rpc::NextMessage {
        return [framing = std::make_shared<rpc::LineFraming>(receive, largest_message)] { return framing->next(); };
    };
    const auto put = [&inbox](rpc::Item item) {
        inbox.put(std::move(item));
        inbox.wait_for_room(most_messages);
        return true;
    };
    return {begin, put, hang_up};
}

/// Closes the inbox at the end of the scope, so that the receiver no longer waits.
struct Closing {
    rpc::Inbox& inbox;
    ~Closing() { inbox.close(); }
};

}  // namespace

void converse(const rpc::Receive& receive, const Send& send, const ServerEnvironment& environment) {
    rpc::Inbox inbox;
    std::atomic<bool> ending = false;
    Session session(send, environment, [&](std::function<void()> call) { inbox.put({.call = std::move(call)}); });
    const rpc::Receiver receiver(receiver_callbacks(receive, inbox, environment.hang_up), inbox, ending);
    const Closing closing{inbox};
    // At the end of the stream, the requests that were received are still handled; calls that wait are cancelled.
    while (!session.disconnected()) {
        if (environment.keep_memory_back) environment.keep_memory_back();
        try {
            const ReserveUse use(true);  // the report of a failure may use the reserved memory
            const auto item = inbox.take(tick);
            if (item && item->call) item->call();
            else if (item && item->message != nullptr) session.take(*item->message);
            else if (item)
                session.refuse(item->refused ? "there is not enough memory for the message" : item->error_text);
            else if (inbox.closed()) break;
            session.report_progress();
        } catch (const std::bad_alloc&) {  // no response, because it also needs memory
        } catch (const std::system_error&) {
        }
    }
}

}  // namespace grafverif::mcp
