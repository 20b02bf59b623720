// SPDX-License-Identifier: MIT
#include "app/manual/completion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace grafverif::app {

namespace {

/// The values that a shell proposes for an option or operand. The proposed values follow from the name of the value in
/// the option table, for example `text|json`, `FILE`, `DIR` or `NAME`.
struct Completed {
    enum class Kind { Words, Files, Folders, Other };
    Kind kind = Kind::Other;
    std::string words = {};  ///< words of Kind::Words, separated by blanks
};

std::string command_names(std::span<const CliCommand> verbs) {
    std::string names;
    for (const CliCommand& verb : verbs) names += fmt::format("{}{}", names.empty() ? "" : " ", verb.name);
    return names;
}

Completed completed(const std::string& shown, std::span<const CliCommand> verbs) {
    using enum Completed::Kind;
    if (shown.find('|') != std::string::npos) {
        std::string words = shown;
        std::ranges::replace(words, '|', ' ');
        return {Words, words};
    }
    if (shown.find("COMMAND") != std::string::npos) return {Words, command_names(verbs)};
    if (shown == "DIR") return {Folders};
    if (shown.find("FILE") != std::string::npos || shown == "PROGRAM" || shown == "CMD") return {Files};
    return {};
}

std::string replaced(std::string text, char what, std::string_view by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) text.replace(at, 1, by);
    return text;
}

/// Escapes text for use within single quotes.
std::string quoted(const std::string& text) { return replaced(text, '\'', "'\\''"); }

std::string option_completions(const CliCommand& verb) {
    std::string words;
    for (const OptionText& option : option_texts(verb)) {
        words += fmt::format("{}--{}", words.empty() ? "" : " ", option.name);
        if (!option.letter.empty()) words += fmt::format(" -{}", option.letter);
    }
    return words;
}

// -- bash ------------------------------------------------------------------------------------------------------------

std::string bash_answer(const Completed& what) {
    switch (what.kind) {
    case Completed::Kind::Words: return fmt::format("_grafverif_words '{}'", what.words);
    case Completed::Kind::Files: return "_grafverif_paths -f";
    case Completed::Kind::Folders: return "_grafverif_paths -d";
    case Completed::Kind::Other: break;
    }
    return ":";
}

std::string bash_values(const CliCommand& verb, std::span<const CliCommand> verbs) {
    std::string rows;
    for (const OptionText& option : option_texts(verb)) {
        if (option.value.empty()) continue;
        const std::string letter = option.letter.empty() ? "" : fmt::format("'{} -{}' | ", verb.name, option.letter);
        rows += fmt::format("    {}'{} --{}') {}; return ;;\n", letter, verb.name, option.name,
                            bash_answer(completed(option.value, verbs)));
    }
    return rows;
}

// -- zsh -------------------------------------------------------------------------------------------------------------

std::string zsh_answer(const std::string& shown, std::span<const CliCommand> verbs) {
    const Completed what = completed(shown, verbs);
    const std::string name = what.kind == Completed::Kind::Words ? "word" : shown;
    switch (what.kind) {
    case Completed::Kind::Words: return fmt::format("{}:({})", name, what.words);
    case Completed::Kind::Files: return fmt::format("{}:_files", name);
    case Completed::Kind::Folders: return fmt::format("{}:_files -/", name);
    case Completed::Kind::Other: break;
    }
    return fmt::format("{}: ", name);
}

std::string zsh_option(const OptionText& option, std::span<const CliCommand> verbs) {
    std::string help = quoted(option.help);
    for (const auto& [what, by] : {std::pair{'[', "\\["}, {']', "\\]"}, {':', "\\:"}}) help = replaced(help, what, by);
    const std::string value = option.value.empty() ? "" : ":" + zsh_answer(option.value, verbs);
    if (option.letter.empty()) return fmt::format("'*--{}[{}]{}'", option.name, help, value);
    return fmt::format("'*'{{-{},--{}}}'[{}]{}'", option.letter, option.name, help, value);
}

// -- fish ------------------------------------------------------------------------------------------------------------

std::string fish_answer(const Completed& what) {
    switch (what.kind) {
    case Completed::Kind::Words: return fmt::format(" -x -a '{}'", what.words);
    case Completed::Kind::Files: return " -r -F";
    case Completed::Kind::Folders: return " -x -a '(__fish_complete_directories)'";
    case Completed::Kind::Other: break;
    }
    return " -x";
}

std::string fish_quoted(const std::string& text) { return replaced(replaced(text, '\\', "\\\\"), '\'', "\\'"); }

}  // namespace

std::string bash_completion(std::span<const CliCommand> verbs) {
    std::string values, options, operands;
    for (const CliCommand& verb : verbs) {
        values += bash_values(verb, verbs);
        options += fmt::format("        {}) _grafverif_words '{}' ;;\n", verb.name, option_completions(verb));
        operands += fmt::format("        {}) {} ;;\n", verb.name, bash_answer(completed(verb.operand, verbs)));
    }
    return fmt::format(R"(# bash completion of grafverif, generated by `grafverif completion bash`
_grafverif_words() {{ mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }}
_grafverif_paths() {{
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen "$1" -- "$word")
}}
_grafverif() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} subcommand=${{COMP_WORDS[1]}}
    COMPREPLY=()
    [ "$before" != = ] || before=${{COMP_WORDS[COMP_CWORD - 2]}}
    [ "$word" != = ] || word=
    if [ "$COMP_CWORD" -eq 1 ]; then
        _grafverif_words '{0} help --help --version'
        return
    fi
    case "$subcommand $before" in
    'help help') _grafverif_words '{0}'; return ;;
{1}    esac
    case "$word" in
    -*)
        case "$subcommand" in
{2}        esac
        ;;
    *)
        case "$subcommand" in
{3}        esac
        ;;
    esac
}}
complete -F _grafverif grafverif
)",
                       command_names(verbs), values, options, operands);
}

std::string zsh_completion(std::span<const CliCommand> verbs) {
    std::string names, cases;
    for (const CliCommand& verb : verbs) {
        names += fmt::format("            '{}:{}'\n", verb.name, quoted(replaced(verb.summary, ':', "\\:")));
        cases += fmt::format("    {})\n        _arguments \\\n", verb.name);
        for (const OptionText& option : option_texts(verb))
            cases += fmt::format("            {} \\\n", zsh_option(option, verbs));
        cases += verb.operand.empty()
                     ? "            ;;\n"
                     : fmt::format("            '*:{}'\n        ;;\n", zsh_answer(verb.operand, verbs));
    }
    return fmt::format(R"(#compdef grafverif
# zsh completion of grafverif, generated by `grafverif completion zsh`
_grafverif() {{
    if (( CURRENT == 2 )); then
        local -a subcommands=(
{0}            'help:describe the options of a command'
        )
        _describe subcommand subcommands
        return
    fi
    local subcommand=$words[2]
    shift words
    (( CURRENT-- ))
    case $subcommand in
    help) _arguments '*:word:({2})' ;;
{1}    esac
}}
_grafverif "$@"
)",
                       names, cases, command_names(verbs));
}

std::string fish_completion(std::span<const CliCommand> verbs) {
    std::string text = R"(# fish completion of grafverif, generated by `grafverif completion fish`
function __grafverif_command
    set -l words (commandline -opc)
    test (count $words) -ge 2; and test "$words[2]" = "$argv[1]"
end

complete -c grafverif -f
complete -c grafverif -n __fish_use_subcommand -l version -d 'print the version'
complete -c grafverif -n __fish_use_subcommand -a help -d 'describe the options of a command'
)";
    text += fmt::format("complete -c grafverif -n '__grafverif_command help' -a '{}'\n", command_names(verbs));
    for (const CliCommand& verb : verbs) {
        text += fmt::format("complete -c grafverif -n __fish_use_subcommand -a {} -d '{}'\n", verb.name,
                            fish_quoted(verb.summary));
        const std::string condition = fmt::format("complete -c grafverif -n '__grafverif_command {}'", verb.name);
        const Completed operand = completed(verb.operand, verbs);
        if (operand.kind == Completed::Kind::Files) text += condition + " -F\n";
        if (operand.kind == Completed::Kind::Words) text += fmt::format("{} -a '{}'\n", condition, operand.words);
        for (const OptionText& option : option_texts(verb)) {
            text += fmt::format("{} -l {}", condition, option.name);
            if (!option.letter.empty()) text += fmt::format(" -s {}", option.letter);
            if (!option.value.empty()) text += fish_answer(completed(option.value, verbs));
            text += fmt::format(" -d '{}'\n", fish_quoted(option.help));
        }
    }
    return text;
}

}  // namespace grafverif::app
