// SPDX-License-Identifier: MIT
// Inbox: what waits to be done, in order: messages of the client, and what other threads have found out.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace grafverif::lsp {

/// A message, or what is wrong with it, or something to be called.
struct Item {
    std::shared_ptr<const nlohmann::json> message = {};
    std::string complaint = {};
    bool cancelled = false;
    std::function<void()> call = {};
};

class Inbox {
public:
    void put(Item item);
    /// The request of that number, as JSON, is not to be done if it still waits.
    void cancel(const nlohmann::json& id);
    /// There will be no more.
    void close();

    /// The next item; nothing where there is none within `patience`, or ever.
    std::optional<Item> take(std::chrono::milliseconds patience);
    bool closed() const;

private:
    mutable std::mutex door_ = {};
    std::condition_variable wake_ = {};
    std::deque<Item> items_ = {};
    bool closed_ = false;
};

}  // namespace grafverif::lsp
