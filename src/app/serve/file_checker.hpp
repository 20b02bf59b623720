// SPDX-License-Identifier: MIT
// Checks a file and checks it again when it or an included file changes: diagnostics, drawn charts, and
// properties, decided model by model. Clients query the newest state; a save discards the verdicts of the previous
// state.
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

/// A parsed file and the models derived from it; immutable.
struct CheckedFile {
    ParseResult reading = {};
    std::vector<std::optional<Network>> networks = {};  ///< per closed loop; empty: it was rejected
    std::vector<bool> runs = {};                        ///< per chart: true if it can be simulated alone
    std::uint64_t number = 0;                           ///< of the parse
};

class FileChecker {
public:
    /// `changed` is called after every change, from another thread. All arguments must outlive the bench.
    FileChecker(const Options& options, std::function<void()> changed);
    ~FileChecker();
    FileChecker(const FileChecker&) = delete;
    FileChecker& operator=(const FileChecker&) = delete;

    /// The state as JSON (docs/how-to/serve.md), if it is newer than `known`.
    std::optional<std::string> newer(std::uint64_t known) const;
    /// The result of the last parse.
    std::shared_ptr<const CheckedFile> workpiece() const;

private:
    class Work;
    std::unique_ptr<Work> work_;
};

}  // namespace grafverif::app
