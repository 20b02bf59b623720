// SPDX-License-Identifier: MIT
// An external program that responds line by line and keeps running between the lines. Even if the program ends, does
// not respond or writes without end, the time and memory limits are observed. The destructor ends the program and all
// its descendants.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "app/system/child.hpp"
#include "pipeline/descriptor.hpp"

namespace grafverif::app {

struct LineProcessLimits {
    std::chrono::milliseconds response_timeout{10'000};  ///< time limit for one response

    /// Maximum length of a line in bytes; a longer response is a Flood.
    std::size_t longest_line = std::size_t{64} << 10U;
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag
};

struct Reply {
    enum class Kind {
        Line,     ///< `text` is the line, without its terminator
        Silent,   ///< there was no line within the time limit
        Ended,    ///< the program ended, or closed its output, before it responded
        Flood,    ///< several lines, or a line that is too long; `text` is the beginning
        Stopped,  ///< the cancellation flag was set
    };
    Kind kind = Kind::Line;
    std::string text = {};

    bool operator==(const Reply&) const = default;
};

class LineProcess {
public:
    /// Starts `command` in the shell. Throws std::system_error if the shell cannot be started.
    LineProcess(const std::string& command, const LineProcessLimits& limits);
    LineProcess(const LineProcess&) = delete;
    LineProcess& operator=(const LineProcess&) = delete;
    ~LineProcess();

    /// Sends `line` and waits for the response. After any reply other than Line, the connection has ended.
    Reply request(const std::string& line);
    /// Sends `line`, which has no response, together with the next line that `request` sends.
    void send(const std::string& line) { unsent_ += line + '\n'; }

    /// Only after Ended: returns how the program ended, with its last line on standard error. Waits briefly for the end
    /// of the program.
    std::string end_text();
    /// Only after Ended: true if the shell did not find the program of the command, or could not execute it.
    bool not_found();

private:
    using Steady = std::chrono::steady_clock;

    bool stopped() const { return limits_.stop != nullptr && limits_.stop->load(); }
    Reply result_for(const std::string& line);
    Reply result_so_far();
    void send();
    void receive();
    void listen();
    void wait(std::chrono::milliseconds longest);
    bool wait_for_end(std::chrono::milliseconds longest);

    LineProcessLimits limits_;
    Descriptor to_, from_, errors_;
    std::optional<Child> program_ = {};
    bool over_ = false;              ///< true if the last reply was not a line; the destructor then does not wait
    std::string unsent_ = {};        ///< text that has not been written to the program yet
    std::string received_ = {};      ///< the response received so far
    std::string error_output_ = {};  ///< the last part of the program's output on standard error
    void (*pipe_signal_before_)(int) = nullptr;
};

}  // namespace grafverif::app
