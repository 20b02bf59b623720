// SPDX-License-Identifier: MIT
// A line on the terminal, written over until the work ends.
#pragma once

#include <ostream>
#include <string>

namespace grafverif::app {

class ProgressLine {
public:
    ProgressLine(std::ostream& err, bool shown) : err_(err), shown_(shown) {}
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine() { erase(); }

    void show(const std::string& line) {
        if (!shown_) return;
        erase();
        width_ = line.size();
        err_ << line << std::flush;
    }

private:
    void erase() {
        if (width_ != 0) err_ << '\r' << std::string(width_, ' ') << '\r' << std::flush;
        width_ = 0;
    }

    std::ostream& err_;
    bool shown_;
    std::size_t width_ = 0;
};

}  // namespace grafverif::app
