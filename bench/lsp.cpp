// SPDX-License-Identifier: MIT
// bench_lsp [STEPS [KEYSTROKES]] measures the response times of the language server during typing.
//
// Each keystroke changes one character. Two times are measured after each keystroke: the time until the diagnostics
// arrive, and then the time until the responses to all requests that an editor sends after a change
// have arrived. Both times are measured in real time and in processor time, including background
// threads.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "lsp/server.hpp"

namespace {

using namespace grafverif;
using Clock = std::chrono::steady_clock;

/// Returns a ring of steps with actions, and with conditions on some inputs.
std::string chart_of(int steps) {
    std::string text =
        "grafcet ring {\n    input A0, A1, A2, A3, A4, A5, A6, A7;\n    output O0, O1, O2, O3;\n\n    initial step "
        "0;\n";
    for (int k = 1; k < steps; ++k) text += fmt::format("    step {} {{ O{}; }}\n", k, k % 4);
    for (int k = 0; k < steps; ++k)
        text +=
            fmt::format("    transition t{}: {} -> {} when A{} && !A{};\n", k, k, (k + 1) % steps, k % 8, (k + 3) % 8);
    return text + "}\n";
}

std::string quoted(const std::string& text) {
    std::string json = "\"";
    for (const char byte : text) {
        if (byte == '\n') json += "\\n";
        else if (byte == '"' || byte == '\\') json += fmt::format("\\{}", byte);
        else json += byte;
    }
    return json + "\"";
}

/// The input and output streams of a server in this process, with functions for the client.
class Wire {
public:
    void say(const std::string& body) {
        const std::lock_guard hold(door_);
        there_ += rpc::framed(body);
        wake_.notify_all();
    }
    void hear(const std::string& part) {
        std::unique_lock hold(door_);
        wake_.wait(hold, [&] { return back_.find(part) != std::string::npos; });
        back_.clear();
    }
    std::size_t give(std::span<char> buffer) {
        std::unique_lock hold(door_);
        wake_.wait(hold, [&] { return !there_.empty(); });
        const std::size_t count = std::min(buffer.size(), there_.size());
        std::copy_n(there_.begin(), count, buffer.begin());
        there_.erase(0, count);
        return count;
    }
    void take(std::string_view bytes) {
        const std::lock_guard hold(door_);
        back_ += bytes;
        wake_.notify_all();
    }

private:
    std::mutex door_ = {};
    std::condition_variable wake_ = {};
    std::string there_ = {}, back_ = {};
};

/// Collects measured times.
class Times {
public:
    void begin() { clock_ = Clock::now(), processor_ = std::clock(); }
    void end() {
        elapsed_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - clock_).count());
        used_.push_back(1e3 * static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC);
    }
    void print(const char* what) {
        std::ranges::sort(elapsed_);
        std::ranges::sort(used_);
        fmt::print("{:<16} median {:5.1f} ms, slowest {:5.1f} ms; of the processor {:5.1f} and {:5.1f} ms\n", what,
                   elapsed_[elapsed_.size() / 2], elapsed_.back(), used_[used_.size() / 2], used_.back());
    }

private:
    Clock::time_point clock_ = {};
    std::clock_t processor_ = 0;
    std::vector<double> elapsed_ = {}, used_ = {};
};

const std::string address = R"("uri": "file:///nowhere/ring.grafcet")";

void begin(Wire& wire, const std::string& text) {
    wire.say(R"({"id": -1, "method": "initialize", "params": {"capabilities": {}}})");
    wire.hear("serverInfo");
    wire.say(fmt::format(
        R"({{"method": "textDocument/didOpen", "params": {{"textDocument": {{{}, "version": 0, "text": {}}}}}}})",
        address, quoted(text)));
    wire.hear("\"version\":0");
}

struct Place {
    int line = 0;
    std::size_t character = 0;
    std::string json(std::size_t beyond = 0) const {
        return fmt::format(R"({{"line": {}, "character": {}}})", line, character + beyond);
    }
};
/// Returns the position after the first letter of the condition of the last transition.
Place place_in(const std::string& text) {
    const std::size_t at = text.rfind("when A") + 6;
    return {static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')),
            at - text.rfind('\n', at) - 1};
}

/// Types a letter that makes the name of an input unknown if `number` is odd; otherwise removes the
/// letter.
void type(Wire& wire, int number, const Place& at) {
    wire.say(fmt::format(
        R"({{"method": "textDocument/didChange", "params": {{"textDocument": {{{}, "version": {}}}, "contentChanges": [{{"range": {{"start": {}, "end": {}}}, "text": "{}"}}]}}}})",
        address, number, at.json(), at.json(number % 2 == 1 ? 0 : 1), number % 2 == 1 ? "A" : ""));
    wire.hear(fmt::format("\"version\":{}", number));
}

void ask(Wire& wire, int id, const char* what, const std::string& more) {
    wire.say(fmt::format(R"({{"id": {}, "method": "textDocument/{}", "params": {{"textDocument": {{{}}}{}}}}})", id,
                         what, address, more));
    wire.hear(fmt::format("\"id\":{},", id));
}

}  // namespace

int main(int count, char** values) {
    const int steps = count > 1 ? std::atoi(values[1]) : 1000, keystrokes = count > 2 ? std::atoi(values[2]) : 50;
    Wire wire;
    std::thread server([&] {
        lsp::converse([&](std::span<char> buffer) { return wire.give(buffer); },
                      [&](std::string_view bytes) { wire.take(bytes); }, {});
    });
    const std::string text = chart_of(steps);
    const Place place = place_in(text);
    begin(wire, text);
    const std::string position = ", \"position\": " + place.json();
    const std::vector<std::pair<const char*, std::string>> questions = {
        {"completion", position}, {"hover", position}, {"semanticTokens/full", ""}, {"codeLens", ""}};
    Times told;
    std::vector<Times> answered(questions.size());
    for (int k = 1; k <= keystrokes; ++k) {
        told.begin();
        type(wire, k, place);
        told.end();
        for (std::size_t i = 0; i < questions.size(); ++i) {
            answered[i].begin();
            ask(wire, 10 * k + static_cast<int>(i), questions[i].first, questions[i].second);
            answered[i].end();
        }
    }
    fmt::print("{} steps, {} keystrokes\n", steps, keystrokes);
    told.print("diagnostics");
    for (std::size_t i = 0; i < questions.size(); ++i) answered[i].print(questions[i].first);
    wire.say(R"({"method": "exit"})");
    server.join();
}
