// SPDX-License-Identifier: MIT
// `manual` and `completion`: write the tables of commands and options as manual pages and shell scripts.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "app/commands.hpp"
#include "app/manual/completion.hpp"
#include "app/manual/man_page.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

ExitCode manual(CommandContext& job, const Streams& streams) {
    const std::vector<CliCommand> verbs = all_commands();
    if (job.options.operands.empty()) {
        deliver(man_page(verbs, GRAFVERIF_VERSION), job, streams);
        return ExitCode::Done;
    }
    const std::string& name = job.options.operands[0];
    const auto found = std::ranges::find(verbs, name, &CliCommand::name);
    if (found == verbs.end()) {
        streams.err << fmt::format("grafverif: error: {}; see `grafverif --help`\n", printable(unknown_command(name)));
        return ExitCode::Input;
    }
    deliver(man_page(*found, GRAFVERIF_VERSION), job, streams);
    return ExitCode::Done;
}

ExitCode completion(CommandContext& job, const Streams& streams) {
    const std::string& shell = job.options.operands[0];
    const std::vector<CliCommand> verbs = all_commands();
    if (shell == "bash") deliver(bash_completion(verbs), job, streams);
    else if (shell == "zsh") deliver(zsh_completion(verbs), job, streams);
    else deliver(fish_completion(verbs), job, streams);
    return ExitCode::Done;
}

CliCommand manual_usage() {
    return {"manual",
            "[COMMAND]",
            0,
            1,
            "write a manual page",
            "Writes the manual page of COMMAND in the format of `man`; without COMMAND, the page of the program.\n"
            "Installed packages contain all pages.",
            {"grafverif manual check | man -l -"},
            {OptionGroup::Output}};
}

CliCommand completion_usage() {
    return {"completion",
            "bash|zsh|fish",
            1,
            1,
            "write a completion script for a shell",
            "Writes a script that completes commands, options and the values of options. Installed packages contain\n"
            "the scripts of all shells.",
            {"grafverif completion bash >~/.local/share/bash-completion/completions/grafverif",
             "grafverif completion zsh >~/.zfunc/_grafverif",
             "grafverif completion fish >~/.config/fish/completions/grafverif.fish"},
            {OptionGroup::Output}};
}

}  // namespace grafverif::app
