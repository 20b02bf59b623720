// SPDX-License-Identifier: MIT
// BTOR2 reader and simulator for the exported subset, based on the specification alone. The reader
// is the reference for exported files.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace grafverif {

class Btor2File {
public:
    explicit Btor2File(const std::string& text);

    const std::string& error_text() const { return complaint_; }
    /// Returns the names of the bad-state properties, in order.
    const std::vector<std::string>& bads() const { return bads_; }
    /// Evaluates the current state with the inputs that `input` returns by name, and then executes one step. Returns,
    /// for each bad-state property, true if it was true in this state.
    std::vector<bool> step(const std::function<std::int64_t(const std::string&)>& input);

private:
    struct Line {
        std::uint64_t number = 0;
        std::string op = {};
        unsigned width = 0;
        std::vector<std::int64_t> arguments = {};
        std::string name = {};
    };

    std::int64_t value(const Line& line, const std::function<std::int64_t(const std::string&)>& input) const;

    std::vector<Line> lines_ = {};
    std::vector<std::string> bads_ = {};
    std::map<std::uint64_t, unsigned> sorts_ = {}, widths_ = {};
    std::map<std::uint64_t, std::int64_t> states_ = {}, values_ = {};  ///< the values, as signed numbers of their width
    std::string complaint_ = {};
};

}  // namespace grafverif
