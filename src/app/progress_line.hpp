// SPDX-License-Identifier: MIT
// Progress line: one line on the terminal, which is overwritten until the work ends.
#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <string_view>

namespace grafverif::app {

class ProgressLine {
public:
    ProgressLine(std::ostream& err, bool shown) : err_(err), shown_(shown) {}
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine() { erase(); }

    /// Shows the result of `text()`, at most five times a second.
    template <class Text>
    void show(const Text& text) {
        const auto now = std::chrono::steady_clock::now();
        if (!shown_ || now - last_ < std::chrono::milliseconds(200)) return;
        last_ = now;
        erase();
        const std::string line = text();
        width_ = line.size();
        err_ << line << std::flush;
    }

    /// Prints `text`, which consists of complete lines, above the progress line.
    void interrupt(std::string_view text) {
        erase();
        err_ << text << std::flush;
    }

private:
    void erase() {
        if (width_ != 0) err_ << '\r' << std::string(width_, ' ') << '\r' << std::flush;
        width_ = 0;
    }

    std::ostream& err_;
    bool shown_;
    std::size_t width_ = 0;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace grafverif::app
