// SPDX-License-Identifier: MIT
#include "rpc/inbox.hpp"

#include <nlohmann/json.hpp>

namespace grafverif::rpc {

void Inbox::put(Item item) {
    const std::lock_guard hold(mutex_);
    items_.push_back(std::move(item));
    wake_.notify_all();
}

void Inbox::cancel(const nlohmann::json& id) {
    const std::lock_guard hold(mutex_);
    for (Item& item : items_)
        if (item.message != nullptr && item.message->is_object() && item.message->contains("method") &&
            item.message->value("id", nlohmann::json()) == id)
            item.cancelled = true;
}

void Inbox::close() {
    const std::lock_guard hold(mutex_);
    closed_ = true;
    wake_.notify_all();
}

void Inbox::wait_for_room(std::size_t most) {
    std::unique_lock hold(mutex_);
    wake_.wait(hold, [&] { return closed_ || items_.size() < most; });
}

std::optional<Item> Inbox::take(std::chrono::milliseconds timeout) {
    std::unique_lock hold(mutex_);
    wake_.wait_for(hold, timeout, [this] { return closed_ || !items_.empty(); });
    if (items_.empty()) return {};
    Item item = std::move(items_.front());
    items_.pop_front();
    wake_.notify_all();
    return item;
}

bool Inbox::closed() const {
    const std::lock_guard hold(mutex_);
    return closed_ && items_.empty();
}

}  // namespace grafverif::rpc
