// SPDX-License-Identifier: MIT
// An external program that answers line by line and keeps running between the lines. If the program ends, is
// silent or writes without end, the connection stays within its limits of time and memory. The destructor ends the
// program and all its descendants.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "app/system/child.hpp"
#include "pipeline/descriptor.hpp"

namespace grafverif::app {

struct LineProcessLimits {
    std::chrono::milliseconds patience{10'000};         ///< for one response
    std::size_t longest_line = std::size_t{64} << 10U;  ///< bytes; a longer response is a flood
    const std::atomic<bool>* stop = nullptr;            ///< cancellation flag
};

struct Reply {
    enum class Kind {
        Line,     ///< `text` is the line, without its terminator
        Silent,   ///< no line within the time limit
        Ended,    ///< the program ended, or closed its output, before it answered
        Flood,    ///< more than one line, or one without end; `text` is its beginning
        Stopped,  ///< the cancellation flag was set
    };
    Kind kind = Kind::Line;
    std::string text = {};

    bool operator==(const Reply&) const = default;
};

class LineProcess {
public:
    /// Starts `command` in the shell. Throws std::system_error.
    LineProcess(const std::string& command, const LineProcessLimits& limits);
    LineProcess(const LineProcess&) = delete;
    LineProcess& operator=(const LineProcess&) = delete;
    ~LineProcess();

    /// Sends `line` and waits for the response. After any reply other than Line the connection is over.
    Reply ask(const std::string& line);
    /// Sends `line`, which has no response, before the next one.
    void send(const std::string& line) { unsent_ += line + '\n'; }

    /// After Ended: how the program ended, with its last line on standard error. Waits briefly for its end.
    std::string end_text();
    /// After Ended: true if the shell found no such program, or could not run it.
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
    bool over_ = false;        ///< the last reply was not a line: do not wait for the end of the program
    std::string unsent_ = {};  ///< not yet written to the program
    std::string heard_ = {};   ///< the response so far
    std::string said_ = {};    ///< the end of its standard error
    void (*pipe_signal_before_)(int) = nullptr;
};

}  // namespace grafverif::app
