// SPDX-License-Identifier: MIT
#include "lsp/server.hpp"

#include <atomic>
#include <new>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>

#include "lsp/inbox.hpp"
#include "lsp/session.hpp"
#include "support/memory_reserve.hpp"

namespace grafverif::lsp {

void Inbox::put(Item item) {
    const std::lock_guard hold(door_);
    items_.push_back(std::move(item));
    wake_.notify_all();
}

void Inbox::cancel(const Json& id) {
    const std::lock_guard hold(door_);
    for (Item& item : items_)
        if (item.message != nullptr && item.message->is_object() && item.message->contains("method") &&
            item.message->value("id", Json()) == id)
            item.cancelled = true;
}

void Inbox::close() {
    const std::lock_guard hold(door_);
    closed_ = true;
    wake_.notify_all();
}

std::optional<Item> Inbox::take(std::chrono::milliseconds timeout) {
    std::unique_lock hold(door_);
    wake_.wait_for(hold, timeout, [this] { return closed_ || !items_.empty(); });
    if (items_.empty()) return {};
    Item item = std::move(items_.front());
    items_.pop_front();
    return item;
}

bool Inbox::closed() const {
    const std::lock_guard hold(door_);
    return closed_ && items_.empty();
}

namespace {

using namespace std::chrono_literals;

/// Interval at which the client process and the files are polled.
constexpr auto check_interval = 250ms;

std::string method_of(const Json& message) {
    if (!message.is_object()) return {};
    const auto method = message.find("method");
    return method != message.end() && method->is_string() ? method->get<std::string>() : std::string();
}

Item item_of(Framed framed) {
    if (!framed.error_text.empty()) return {.error_text = std::move(framed.error_text)};
    if (nests_too_deep(framed.body)) return {.error_text = "the message nests too deeply"};
    Json message = Json::parse(framed.body, nullptr, false);
    if (message.is_discarded()) return {.error_text = "the message is not valid JSON"};
    return {.message = std::make_shared<const Json>(std::move(message))};
}

void put(Item item, Inbox& inbox) {
    const std::string method = item.message != nullptr ? method_of(*item.message) : std::string();
    if (method == "$/cancelRequest" && item.message->contains("params") && (*item.message)["params"].is_object())
        inbox.cancel((*item.message)["params"].value("id", Json()));
    else inbox.put(std::move(item));
}

/// Puts the next message, or its error, into the inbox. Returns false after the last message.
bool receive_next(Framing& framing, Inbox& inbox) {
    Item item;
    bool last = false;
    try {
        auto framed = framing.next();
        if (!framed) return false;
        item = item_of(std::move(*framed));
        last = item.message != nullptr && method_of(*item.message) == "exit";
    } catch (const std::bad_alloc&) {
        item = {};
        item.refused = true;
    }
    const ReserveUse use(true);
    put(std::move(item), inbox);
    return !last;
}

/// Receives messages until the end of the stream, or until the client sends `exit`.
void receive_all(const Receive& receive, Inbox& inbox, std::atomic<bool>& ending) {
    try {
        Framing framing(receive);
        for (bool more = true; more;) {
            try {
                more = receive_next(framing, inbox);
            } catch (const std::bad_alloc&) {  // not even the reserved memory is sufficient for the message
            }
        }
    } catch (const std::bad_alloc&) {  // the buffer for receiving could not be allocated
    } catch (const std::system_error&) {
    }
    ending = true;
    inbox.close();
}

/// A thread that receives messages. The destructor joins it, also after an exception.
class Receiver {
public:
    Receiver(const Receive& receive, Inbox& inbox, std::atomic<bool>& ending, const std::function<void()>& hang_up)
        : hang_up_(hang_up), thread_([&] { receive_all(receive, inbox, ending); }) {}
    ~Receiver() {
        if (hang_up_) hang_up_();
        thread_.join();
    }
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

private:
    const std::function<void()>& hang_up_;
    std::thread thread_;
};

}  // namespace

Ending converse(const Receive& receive, const Send& send, const ServerEnvironment& surroundings) {
    Inbox inbox;
    std::atomic<bool> ending = false;
    Session session(
        send, surroundings, [&](std::function<void()> call) { inbox.put({.call = std::move(call)}); }, ending);
    const Receiver receiver(receive, inbox, ending, surroundings.hang_up);
    bool disconnected = false;
    while (!session.over() && !disconnected) {
        if (surroundings.keep_memory_back) surroundings.keep_memory_back();
        try {
            const ReserveUse use(true);  // the report of a failure may use the reserved memory
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
        } catch (const std::bad_alloc&) {  // no response, because it also needs memory
        } catch (const std::system_error&) {
        }
    }
    if (disconnected) return Ending::Gone;
    return session.end_requested() ? Ending::Requested : Ending::Unrequested;
}

}  // namespace grafverif::lsp
