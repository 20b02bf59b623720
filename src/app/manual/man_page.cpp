// SPDX-License-Identifier: MIT
#include "app/manual/man_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace grafverif::app {

namespace {

/// Returns text as man(7) source, with the text between backticks in bold. No line of the text is interpreted as a
/// request.
std::string troff(std::string_view text) {
    std::string result;
    bool bold = false;
    for (const char c : text) {
        if (result.empty() || result.back() == '\n')
            if (c == '.' || c == '\'') result += "\\&";
        if (c == '\\') result += "\\e";
        else if (c == '-') result += "\\-";
        else if (c == '`') result += (bold = !bold) ? "\\fB" : "\\fR";
        else result += c;
    }
    return result;
}

/// Returns an option as it is entered: `-o, --output FILE`.
std::string troff(const OptionText& option) {
    std::string text = option.letter.empty() ? "" : fmt::format("\\fB\\-{}\\fR, ", option.letter);
    text += fmt::format("\\fB\\-\\-{}\\fR", troff(option.name));
    return option.value.empty() ? text : text + fmt::format(" \\fI{}\\fR", troff(option.value));
}

std::string title(std::string name, std::string_view version) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return fmt::format(".TH \"{}\" 1 \"\" \"grafverif {}\" \"GRAFCET charts and model checkers\"\n.nh\n.ad l\n",
                       troff(name), version);
}

constexpr std::string_view exit_status =
    ".SH EXIT STATUS\n"
    ".TP\n"
    "0\n"
    "success, all verdicts as expected\n"
    ".TP\n"
    "1\n"
    "unexpected verdict or model error\n"
    ".TP\n"
    "2\n"
    "invalid input or usage\n"
    ".TP\n"
    "3\n"
    "unknown verdict, or stopped by a time or memory limit or a signal\n"
    ".TP\n"
    "4\n"
    "internal error\n";

}  // namespace

std::string man_page(std::span<const CliCommand> verbs, std::string_view version) {
    std::string page = title("grafverif", version);
    page +=
        ".SH NAME\n"
        "grafverif \\- verify GRAFCET charts (IEC 60848) in closed loop with their plants\n"
        ".SH SYNOPSIS\n"
        ".B grafverif\n"
        ".I COMMAND\n"
        "[\\fIFILE\\fR] [\\fIoptions\\fR]\n"
        ".SH DESCRIPTION\n"
        "Verifies a GRAFCET chart in closed loop with a plant built from library components, draws and replays\n"
        "counterexamples, and writes models for UPPAAL, NuSMV and other model checkers. Reports every construct that\n"
        "cannot be translated or decided exactly.\n"
        ".PP\n"
        "\\fIFILE\\fR can be \\fB\\-\\fR for standard input. Outputs are written completely or not at all.\n"
        ".SH COMMANDS\n";
    for (const CliCommand& verb : verbs)
        page += fmt::format(".TP\n\\fBgrafverif\\-{}\\fR(1)\n{}\n", troff(verb.name), troff(verb.summary));
    page += exit_status;
    return page +
           ".SH SEE ALSO\n"
           "The manual pages of the commands; the documentation in /usr/share/doc/grafverif, if installed.\n";
}

std::string man_page(const CliCommand& verb, std::string_view version) {
    std::string page = title("grafverif-" + verb.name, version);
    page += fmt::format(".SH NAME\ngrafverif\\-{} \\- {}\n.SH SYNOPSIS\n.B grafverif {}\n", troff(verb.name),
                        troff(verb.summary), troff(verb.name));
    if (!verb.operand.empty()) page += fmt::format(".I {}\n", troff(verb.operand));
    page += fmt::format("[\\fIoptions\\fR]\n.SH DESCRIPTION\n{}\n.SH OPTIONS\n", troff(verb.description));
    for (const OptionText& option : option_texts(verb))
        page += fmt::format(".TP\n{}\n{}\n", troff(option), troff(option.help));
    page += exit_status;
    if (!verb.examples.empty()) page += ".SH EXAMPLES\n";
    for (const std::string& example : verb.examples) page += fmt::format(".PP\n.nf\n    {}\n.fi\n", troff(example));
    return page + ".SH SEE ALSO\n.BR grafverif (1)\n";
}

}  // namespace grafverif::app
