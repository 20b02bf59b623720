// SPDX-License-Identifier: MIT
#include "support/read_btor2.hpp"

#include <sstream>

namespace grafverif {

namespace {

/// Returns the last `width` bits of a number as a signed number. The values of wider sorts must fit 64 bits, as they do
/// in all tests.
std::int64_t cut(std::int64_t value, unsigned width) {
    if (width >= 64) return value;
    const unsigned unused = 64 - width;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << unused) >> unused;
}

}  // namespace

Btor2File::Btor2File(const std::string& text) {
    std::istringstream in(text);
    for (std::string row; std::getline(in, row);) {
        if (row.starts_with(';')) continue;
        std::istringstream words(row);
        Line line;
        words >> line.number >> line.op;
        if (line.op == "sort") {
            std::string kind;
            words >> kind >> sorts_[line.number];
            if (kind != "bitvec" || sorts_[line.number] > 128) complaint_ = "unsupported sort: " + row;
            continue;
        }
        if (line.op != "bad") {
            std::uint64_t sort = 0;
            words >> sort;
            if (!sorts_.contains(sort)) complaint_ = "unknown sort: " + row;
            line.width = sorts_[sort];
        }
        for (std::string word; words >> word;) {
            const bool number = word.find_first_not_of("-0123456789") == std::string::npos;
            if (number && line.op != "input" && line.op != "state") line.arguments.push_back(std::stoll(word));
            else line.name = word;
        }
        const std::size_t read = line.op == "constd"                       ? 0
                                 : line.op == "sext" || line.op == "slice" ? 1
                                                                           : line.arguments.size();
        for (std::size_t i = 0; i < read; ++i)
            if (!widths_.contains(static_cast<std::uint64_t>(line.arguments[i])))
                complaint_ = "a line is used before its definition: " + row;
        if (line.op == "bad") bads_.push_back(line.name);
        if (line.op == "init" && line.arguments[0] < line.arguments[1])
            complaint_ = "the initial value has a greater number than the state: " + row;
        widths_[line.number] = line.op == "bad" ? 1 : line.width;
        lines_.push_back(std::move(line));
    }
}

std::int64_t Btor2File::value(const Line& line, const std::function<std::int64_t(const std::string&)>& input) const {
    const auto at = [&](std::size_t i) { return values_.at(static_cast<std::uint64_t>(line.arguments[i])); };
    if (line.op == "constd") return line.arguments[0];
    if (line.op == "input") return input(line.name);
    if (line.op == "state") return states_.contains(line.number) ? states_.at(line.number) : 0;
    if (line.op == "not") return ~at(0);
    if (line.op == "and") return at(0) & at(1);
    if (line.op == "or") return at(0) | at(1);
    if (line.op == "ite") return at(0) != 0 ? at(1) : at(2);
    if (line.op == "sext") return at(0);
    if (line.op == "slice") return at(0) >> line.arguments[2];
    if (line.op == "eq") return at(0) == at(1);
    if (line.op == "neq") return at(0) != at(1);
    if (line.op == "slt") return at(0) < at(1);
    if (line.op == "slte") return at(0) <= at(1);
    if (line.op == "sgt") return at(0) > at(1);
    if (line.op == "sgte") return at(0) >= at(1);
    if (line.op == "add") return at(0) + at(1);
    if (line.op == "sub") return at(0) - at(1);
    if (line.op == "mul") return at(0) * at(1);
    if (line.op == "sdiv") return at(1) == 0 ? -1 : at(0) / at(1);
    if (line.op == "srem") return at(1) == 0 ? at(0) : at(0) % at(1);
    return 0;
}

std::vector<bool> Btor2File::step(const std::function<std::int64_t(const std::string&)>& input) {
    std::vector<bool> bad;
    std::map<std::uint64_t, std::int64_t> next;
    const bool first = values_.empty();
    for (const Line& line : lines_) {
        const auto argument = [&](std::size_t i) { return static_cast<std::uint64_t>(line.arguments[i]); };
        if (line.op == "bad") bad.push_back(values_.at(argument(0)) != 0);
        else if (line.op == "next") next[argument(0)] = values_.at(argument(1));
        else if (line.op == "init") {
            if (first) values_[argument(0)] = values_.at(argument(1));
        } else {
            values_[line.number] = cut(value(line, input), line.width);
        }
    }
    states_ = std::move(next);
    return bad;
}

}  // namespace grafverif
