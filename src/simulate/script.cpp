// SPDX-License-Identifier: MIT
#include "simulate/script.hpp"

#include <sstream>

namespace grafverif {

Script script_of(std::string_view text) {
    Script script;
    std::vector<std::size_t> open;
    std::istringstream lines{std::string(text)};
    std::uint32_t number = 1;
    for (std::string line; std::getline(lines, line); ++number) {
        Script::Line next{command_of(line), number};
        const bool ends = std::holds_alternative<EndCommand>(next.command);
        if (auto* const bad = std::get_if<BadCommand>(&next.command))
            script.error_texts.emplace_back(number, bad->error_text);
        if (std::holds_alternative<SaveCommand>(next.command))
            script.error_texts.emplace_back(number, "`save` is allowed only interactively; remove it from the script");
        if (ends && open.empty())
            script.error_texts.emplace_back(number, "this `}` does not close a `repeat`; remove it");
        if (std::holds_alternative<RepeatCommand>(next.command)) open.push_back(script.lines.size());
        else if (ends && !open.empty()) open.pop_back();
        script.lines.push_back(std::move(next));
    }
    for (const std::size_t each : open)
        script.error_texts.emplace_back(script.lines[each].number, "`repeat` is not closed; add `}`");
    return script;
}

}  // namespace grafverif
