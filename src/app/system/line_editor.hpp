// SPDX-License-Identifier: MIT
// Lines that a person types at a terminal, edited, with those before at hand and words completed by Tab (libedit; a person's
// ~/.editrc is obeyed).
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
    /// What the last word of a line may become; the line up to the cursor.
    using Complete = std::function<std::vector<std::string>(std::string_view line)>;

    /// `last_word`: where the last word of a line begins; `stop`, set by somebody else: the input has ended. Requires that
    /// standard input and output are a terminal.
    LineEditor(std::string prompt, Complete complete, std::size_t (*last_word)(std::string_view),
               const std::atomic<bool>& stop);
    LineEditor(const LineEditor&) = delete;
    LineEditor& operator=(const LineEditor&) = delete;
    ~LineEditor();

    /// Without its end; Ctrl-C gives an empty one. Nothing: the input has ended, by Ctrl-D on an empty line or by `stop`.
    std::optional<std::string> line();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace grafverif::app
