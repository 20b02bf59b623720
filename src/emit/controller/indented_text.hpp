// SPDX-License-Identifier: MIT
// IndentedText: base of the printers of controllers, which writes lines with the indentation of nested statements.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>

namespace grafverif::controller {

class IndentedText {
protected:
    template <class... Arguments>
    void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
        text_ += std::string(4 * depth_, ' ') + fmt::format(text, std::forward<Arguments>(arguments)...) + '\n';
    }
    /// Writes the first line of a statement that contains other statements.
    void begin(const std::string& head) {
        line("{}", head);
        ++depth_;
    }
    /// Writes the line that ends a statement with nested statements, or that ends one of its branches.
    void end(const char* word) {
        --depth_;
        line("{}", word);
    }

    std::string text_ = {};
    std::size_t depth_ = 0;
};

}  // namespace grafverif::controller
