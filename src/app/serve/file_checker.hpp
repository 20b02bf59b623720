// SPDX-License-Identifier: MIT
// Checks a file, and checks it again when it or an included file changes. The results are diagnostics, drawn charts,
// and properties, which are decided model by model. Clients query the newest state. A save discards the verdicts of the
// previous state.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/options.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif::app {

/// A parsed file and the models derived from this file; immutable.
struct CheckedFile {
    ParseResult reading = {};
    std::vector<std::optional<Network>> networks = {};  ///< network of each closed loop; empty if the loop was rejected
    std::vector<bool> runs = {};                        ///< for each chart: true if it can be simulated without a loop
    std::uint64_t number = 0;                           ///< consecutive number of the parse
};

class FileChecker {
public:
    /// Another thread calls `changed` after every change of the state. All arguments must outlive the object. If `text`
    /// is given, the file is not read from the disk: `text` returns its content, and the caller reports changes by
    /// `refresh`.
    FileChecker(const Options& options, std::function<void()> changed, std::function<std::string()> text = {});
    ~FileChecker();
    FileChecker(const FileChecker&) = delete;
    FileChecker& operator=(const FileChecker&) = delete;

    /// Returns the state as JSON (docs/how-to/serve.md) if it is newer than `known`.
    std::optional<std::string> newer(std::uint64_t known) const;
    /// Returns the result of the last parse.
    std::shared_ptr<const CheckedFile> checked_file() const;
    /// Checks the file again. Thread-safe.
    void refresh();

private:
    class Work;
    std::unique_ptr<Work> work_;
};

}  // namespace grafverif::app
