// SPDX-License-Identifier: MIT
#include "support/read_aiger.hpp"

#include <sstream>
#include <stdexcept>

namespace grafverif {

namespace {

class Reader {
public:
    explicit Reader(const std::string& text) : in_(text) {}

    AigerFile file() {
        try {
            header();
            body();
        } catch (const std::exception& failure) {
            file_.error_text = failure.what();
        }
        return std::move(file_);
    }

private:
    std::uint32_t number() {
        std::uint32_t value = 0;
        if (!(in_ >> value)) throw std::runtime_error("a number is missing");
        return value;
    }
    std::uint32_t literal() {
        const std::uint32_t value = number();
        if (value / 2 > file_.most) throw std::runtime_error("a literal exceeds the maximum");
        return value;
    }

    void header() {
        std::string line;
        std::getline(in_, line);
        std::istringstream words(line);
        std::string form;
        words >> form;
        if (form != "aag" && form != "aig") throw std::runtime_error("not an AIGER file");
        binary_ = form == "aig";
        for (std::uint32_t count = 0; words >> count;) counts_.push_back(count);
        if (counts_.size() < 5 || counts_.size() > 9) throw std::runtime_error("the header has another length");
        counts_.resize(9);
        file_.most = counts_[0];
        if (binary_ && counts_[0] != counts_[1] + counts_[2] + counts_[4])
            throw std::runtime_error("M differs from I + L + A");
    }

    void body() {
        for (std::uint32_t i = 0; i < counts_[1]; ++i) file_.inputs.push_back(binary_ ? 2 * (i + 1) : literal());
        for (std::uint32_t i = 0; i < counts_[2]; ++i) {
            const std::uint32_t out = binary_ ? 2 * (counts_[1] + i + 1) : literal();
            file_.latches.push_back({out, literal()});
        }
        for (std::uint32_t i = 0; i < counts_[3]; ++i) literal();
        for (std::uint32_t i = 0; i < counts_[5]; ++i) file_.bads.push_back(literal());
        for (std::uint32_t i = 0; i < counts_[6]; ++i) literal();
        for (std::uint32_t i = 0; i < counts_[7]; ++i) file_.justice.emplace_back(number());
        for (auto& list : file_.justice)
            for (std::uint32_t& each : list) each = literal();
        if (binary_) in_.get();  // reads the line end before the binary gates
        for (std::uint32_t i = 0; i < counts_[4]; ++i) gate(2 * (counts_[1] + counts_[2] + i + 1));
        std::string line;
        if (!binary_) std::getline(in_, line);
        while (std::getline(in_, line) && line != "c") file_.symbols.push_back(line);
    }

    void gate(std::uint32_t out) {
        if (!binary_) {
            out = literal();
            const std::uint32_t left = literal();
            file_.ands.push_back({out, left, literal()});
        } else {
            const std::uint32_t left = out - difference();
            file_.ands.push_back({out, left, left - difference()});
        }
        const AigerFile::And& last = file_.ands.back();
        if (last.left >= last.out || last.right > last.left) throw std::runtime_error("gates out of order");
    }

    std::uint32_t difference() {
        std::uint32_t value = 0;
        for (unsigned shift = 0; shift < 35; shift += 7) {
            const int byte = in_.get();
            if (byte < 0) throw std::runtime_error("the gates end early");
            value |= static_cast<std::uint32_t>(byte & 0x7F) << shift;
            if ((byte & 0x80) == 0) return value;
        }
        throw std::runtime_error("the encoding of a difference is too long");
    }

    std::istringstream in_;
    bool binary_ = false;
    std::vector<std::uint32_t> counts_ = {};
    AigerFile file_ = {};
};

}  // namespace

AigerFile read_aiger(const std::string& text) { return Reader(text).file(); }

std::vector<std::vector<bool>> aiger_run(const AigerFile& file, const std::vector<std::vector<bool>>& inputs) {
    std::vector<std::vector<bool>> run;
    std::vector<bool> values(file.most + 1);
    for (const std::vector<bool>& given : inputs) {
        for (std::size_t i = 0; i < file.inputs.size(); ++i) values[file.inputs[i] / 2] = given[i];
        for (const AigerFile::And& gate : file.ands)
            values[gate.out / 2] = aiger_value(values, gate.left) && aiger_value(values, gate.right);
        run.push_back(values);
        std::vector<bool> next;
        for (const AigerFile::Latch& latch : file.latches) next.push_back(aiger_value(values, latch.next));
        for (std::size_t i = 0; i < next.size(); ++i) values[file.latches[i].literal / 2] = next[i];
    }
    return run;
}

}  // namespace grafverif
