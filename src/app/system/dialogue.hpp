// SPDX-License-Identifier: MIT
// Dialogue: another program that answers line by line, kept running between the lines. Whatever it does - it ends, keeps
// silent, writes without end - the dialogue goes on within its limits of time and memory, and ends cleanly: the program
// and all it has started are gone with the object.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "app/system/child.hpp"
#include "pipeline/descriptor.hpp"

namespace grafverif::app {

struct DialogueLimits {
    std::chrono::milliseconds patience{10'000};         ///< for one answer
    std::size_t longest_line = std::size_t{64} << 10U;  ///< bytes; a longer answer is a flood
    const std::atomic<bool>* stop = nullptr;            ///< set by somebody else: stop waiting
};

struct Reply {
    enum class Kind {
        Line,     ///< `text` is the line, without its end
        Silent,   ///< none came in time
        Ended,    ///< the program ended, or closed its output, before it had answered
        Flood,    ///< more than one line, or one without end; `text` is its beginning
        Stopped,  ///< we were asked to stop waiting
    };
    Kind kind = Kind::Line;
    std::string text = {};

    bool operator==(const Reply&) const = default;
};

class Dialogue {
public:
    /// Starts `command`, which the shell reads. Throws std::system_error.
    Dialogue(const std::string& command, const DialogueLimits& limits);
    Dialogue(const Dialogue&) = delete;
    Dialogue& operator=(const Dialogue&) = delete;
    ~Dialogue();

    /// Sends `line` and waits for the one that answers it. After any answer but a Line the dialogue is over.
    Reply ask(const std::string& line);
    /// Sends `line`, which has no answer, before the next one.
    void tell(const std::string& line) { unsent_ += line + '\n'; }

    /// After Ended: how the program did, with what it said last on its standard error. Waits a moment for its end.
    std::string end_text();
    /// After Ended: the shell found no such program, or could not run it.
    bool not_found();

private:
    using Steady = std::chrono::steady_clock;

    bool stopped() const { return limits_.stop != nullptr && limits_.stop->load(); }
    Reply answer_to(const std::string& line);
    Reply answer_so_far();
    void send();
    void receive();
    void listen();
    void wait(std::chrono::milliseconds longest);
    bool wait_for_end(std::chrono::milliseconds longest);

    DialogueLimits limits_;
    Descriptor to_, from_, errors_;
    std::optional<Child> program_ = {};
    bool over_ = false;        ///< the last answer was no line: its end need not be waited for
    std::string unsent_ = {};  ///< on its way to the program
    std::string heard_ = {};   ///< of the answer, so far
    std::string said_ = {};    ///< the last of its standard error
    void (*pipe_signal_before_)(int) = nullptr;
};

}  // namespace grafverif::app
