// SPDX-License-Identifier: MIT
// LivePage: a file as a page on this machine (docs/serve.md), made anew with every change of the file, with the reports and
// simulations that are asked of it.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "app/options.hpp"

namespace grafverif::app {

class LivePage {
public:
    /// The first operand is the file. Throws std::system_error where the port is in use, or there is none.
    explicit LivePage(const Options& options);
    ~LivePage();
    LivePage(const LivePage&) = delete;
    LivePage& operator=(const LivePage&) = delete;

    /// With the token that it asks for.
    std::string address() const;
    /// Serves until `stop` is set.
    void run(const std::atomic<bool>& stop);

private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace grafverif::app
