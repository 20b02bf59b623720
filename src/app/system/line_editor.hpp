// SPDX-License-Identifier: MIT
// LineEditor: reads lines from a terminal with editing, history, and completion of words by Tab (libedit, including the
// user's ~/.editrc).
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif::app {

class LineEditor {
public:
    /// Returns candidates for the last word of a line, given the line up to the cursor.
    using Complete = std::function<std::vector<std::string>(std::string_view line)>;

    /// `last_word` returns the position of the last word of a line. `stop` is a cancellation flag, which ends the
    /// input. Requires that standard input and output are a terminal.
    LineEditor(std::string prompt, Complete complete, std::size_t (*last_word)(std::string_view),
               const std::atomic<bool>& stop);
    LineEditor(const LineEditor&) = delete;
    LineEditor& operator=(const LineEditor&) = delete;
    ~LineEditor();

    /// Returns a line without its terminator; after Ctrl-C, an empty line. The result is empty at the end of input,
    /// which Ctrl-D or `stop` causes.
    std::optional<std::string> line();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace grafverif::app
