// SPDX-License-Identifier: MIT
#include "app/system/line_editor.hpp"

#include <histedit.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cwchar>
#include <utility>

#include "support/printable.hpp"

namespace grafverif::app {

struct LineEditor::Parts {
    std::string prompt = {};
    Complete complete = {};
    std::size_t (*last_word)(std::string_view) = nullptr;
    const std::atomic<bool>* stop = nullptr;
    EditLine* editor = nullptr;
    History* history = nullptr;
    bool gave_up = false;  ///< true if the user discarded the current line

    static Parts& of(EditLine* editor) {
        void* parts = nullptr;
        el_get(editor, EL_CLIENTDATA, &parts);
        return *static_cast<Parts*>(parts);
    }

    /// Stores the next character in `read`, and returns 1. Returns 0 at the end of input, or when `stop` is set while
    /// no character is available.
    static int character(EditLine* editor, wchar_t* read) {
        constexpr int poll_interval_ms = 50;
        std::mbstate_t state = {};
        while (!*of(editor).stop) {
            pollfd input{STDIN_FILENO, POLLIN, 0};
            if (::poll(&input, 1, poll_interval_ms) <= 0) continue;
            char byte = 0;
            const ssize_t count = ::read(STDIN_FILENO, &byte, 1);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) return 0;
            const std::size_t used = std::mbrtowc(read, &byte, 1, &state);
            if (used == static_cast<std::size_t>(-2)) continue;  // the bytes read so far are not a complete character
            if (used == static_cast<std::size_t>(-1)) *read = L'?';
            return 1;
        }
        return 0;
    }

    static char* shown_prompt(EditLine* editor) { return of(editor).prompt.data(); }

    /// Handles Ctrl-C: discards the line.
    static unsigned char give_up(EditLine* editor, int) {
        const LineInfo* const line = el_line(editor);
        el_cursor(editor, static_cast<int>(line->lastchar - line->cursor));
        el_deletestr(editor, static_cast<int>(el_line(editor)->lastchar - el_line(editor)->buffer));
        std::fputs("^C", stdout);
        of(editor).gave_up = true;
        return CC_NEWLINE;
    }

    static unsigned char suspend(EditLine*, int) {
        std::raise(SIGTSTP);
        return CC_REDISPLAY;
    }

    /// Handles Tab: inserts the common prefix of the candidates. If the prefix adds no character, lists the candidates.
    static unsigned char tab(EditLine* editor, int) {
        const Parts& parts = of(editor);
        const LineInfo* const info = el_line(editor);
        const std::string line(info->buffer, info->cursor);
        const std::vector<std::string> words = parts.complete(line);
        if (words.empty()) return CC_REFRESH_BEEP;
        std::string common = words.front();
        for (const std::string& word : words)
            common.resize(static_cast<std::size_t>(std::ranges::mismatch(common, word).in1 - common.begin()));
        std::string added = common.substr(std::min(common.size(), line.size() - parts.last_word(line)));
        if (words.size() == 1) added += ' ';
        if (!added.empty()) return el_insertstr(editor, added.c_str()) == 0 ? CC_REFRESH : CC_REFRESH_BEEP;
        std::string list = "\n";
        for (const std::string& word : words) list += printable(word) + "  ";
        std::puts(list.c_str());
        return CC_REDISPLAY;
    }
};

LineEditor::LineEditor(std::string prompt, Complete complete, std::size_t (*last_word)(std::string_view),
                       const std::atomic<bool>& stop)
    : parts_(std::make_unique<Parts>(Parts{std::move(prompt), std::move(complete), last_word, &stop})) {
    if (std::setlocale(LC_CTYPE, "") == nullptr || std::string_view(std::setlocale(LC_CTYPE, nullptr)) == "C")
        std::setlocale(LC_CTYPE, "C.UTF-8");
    constexpr int remembered = 1000;
    HistEvent event = {};
    parts_->history = history_init();
    history(parts_->history, &event, H_SETSIZE, remembered);
    history(parts_->history, &event, H_SETUNIQUE, 1);
    EditLine* const editor = parts_->editor = el_init("grafverif", stdin, stdout, stderr);
    el_set(editor, EL_CLIENTDATA, parts_.get());
    el_set(editor, EL_GETCFN, Parts::character);
    el_set(editor, EL_PROMPT, Parts::shown_prompt);
    el_set(editor, EL_EDITOR, "emacs");
    el_set(editor, EL_SIGNAL, 1);  // the library restores the terminal if a signal ends the program
    el_set(editor, EL_HIST, history, parts_->history);
    // The names are wide strings, because the library converts narrow names to copies that it never frees.
    el_wset(editor, EL_ADDFN, L"grafverif-complete", L"complete the word", Parts::tab);
    el_wset(editor, EL_ADDFN, L"grafverif-give-up", L"discard the line", Parts::give_up);
    el_wset(editor, EL_ADDFN, L"grafverif-stop", L"suspend the program until the shell resumes it", Parts::suspend);
    el_set(editor, EL_BIND, "^I", "grafverif-complete", nullptr);
    el_set(editor, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    el_source(editor, nullptr);
    el_set(editor, EL_SETTY, "-d", "-isig", nullptr);  // while a line is edited, Ctrl-C and Ctrl-Z raise no signals
    el_set(editor, EL_BIND, "^C", "grafverif-give-up", nullptr);
    el_set(editor, EL_BIND, "^Z", "grafverif-stop", nullptr);
}

LineEditor::~LineEditor() {
    el_end(parts_->editor);
    history_end(parts_->history);
}

std::optional<std::string> LineEditor::line() {
    std::fflush(stdout);
    // Prepares the terminal before the prompt is shown, so that keys pressed before the prompt are edited as well.
    el_set(parts_->editor, EL_PREP_TERM, 1);
    int count = 0;
    const char* const read = el_gets(parts_->editor, &count);
    if (std::exchange(parts_->gave_up, false)) return "";
    if (read == nullptr || count <= 0) return {};
    std::string text(read, static_cast<std::size_t>(count));
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    HistEvent event = {};
    if (text.find_first_not_of(" \t") != std::string::npos) history(parts_->history, &event, H_ENTER, text.c_str());
    return text;
}

}  // namespace grafverif::app
