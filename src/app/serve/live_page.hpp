// SPDX-License-Identifier: MIT
// LivePage: serves a file as a page on this computer (docs/how-to/serve.md). The page is updated after every change of
// the file, and provides reports and simulations on request.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "app/options.hpp"

namespace grafverif::app {

class LivePage {
public:
    /// The first operand in `options` is the file. Throws std::system_error if no port can be opened.
    explicit LivePage(const Options& options);
    ~LivePage();
    LivePage(const LivePage&) = delete;
    LivePage& operator=(const LivePage&) = delete;

    /// Returns the address, which includes the token.
    std::string address() const;
    /// Serves until `stop` is set.
    void run(const std::atomic<bool>& stop);

private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace grafverif::app
