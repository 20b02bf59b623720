// SPDX-License-Identifier: MIT
// LivePage: serves a file as a page on this computer. The page of `serve` is updated after every change of the file,
// and provides reports and simulations on request (docs/how-to/serve.md). The page of `edit` also changes the file
// (docs/how-to/edit.md).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "app/options.hpp"

namespace grafverif::app {

class LivePage {
public:
    /// The first operand in `options` is the file. If `edited` is given, it is the content of the file, which the page
    /// can change. Throws std::system_error if no port can be opened.
    explicit LivePage(const Options& options, std::optional<std::string> edited = {});
    ~LivePage();
    LivePage(const LivePage&) = delete;
    LivePage& operator=(const LivePage&) = delete;

    /// Returns the address, which includes the token.
    std::string address() const;
    /// Serves until `stop` is set.
    void run(const std::atomic<bool>& stop);
    /// Returns the path of the recovery file if the page has changes that are not saved; otherwise an empty string.
    std::string unsaved() const;
    /// If the recovery file does not contain all changes that are not saved, returns the reason; otherwise, returns an
    /// empty string.
    std::string loss() const;

private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace grafverif::app
