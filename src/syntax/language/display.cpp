// SPDX-License-Identifier: MIT
#include "syntax/language/display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "grafcet_parser.hpp"
#include "support/messages_notation.hpp"
#include "support/printable.hpp"
#include "support/text/skeleton.hpp"

namespace grafverif {

namespace {

/// Collects control characters, which change the display in editors and terminals. Stores the first position and the
/// number of further occurrences of each character.
class Controls {
public:
    explicit Controls(Span part) : part_(part) {}

    void note(std::uint32_t code, std::size_t at, std::size_t bytes) {
        const auto place = static_cast<std::uint32_t>(at);
        const auto [found, fresh] = seen_.try_emplace(code);
        if (fresh) found->second.where = {part_.source, place, place + static_cast<std::uint32_t>(bytes)};
        else ++found->second.more;
    }

    void report(Diagnostics& diagnostics) const {
        for (const auto& [code, seen] : seen_) {
            constexpr std::uint32_t carriage_return = 0x0D, next_line = 0x85, line = 0x2028, paragraph = 0x2029;
            const bool ends_line = code == carriage_return || code == next_line || code == line || code == paragraph;
            const bool control = code < 0xA0;
            diagnostics.add(ends_line ? messages::line_separator(seen.where, code, seen.more)
                            : control ? messages::control_character(seen.where, code, seen.more)
                                      : messages::bidi_control(seen.where, code, seen.more));
        }
    }

private:
    struct Occurrence {
        Span where = {};
        std::size_t more = 0;
    };
    Span part_;
    std::map<std::uint32_t, Occurrence> seen_ = {};
};

/// True if `text` begins with ASCII white space. A carriage return is white space only before a line feed.
bool is_blank(std::string_view text) {
    if (text.front() == '\r') return text.size() > 1 && text[1] == '\n';
    return std::string_view(" \t\n\f\v").find(text.front()) != std::string_view::npos;
}

/// A keyword, step variable or name with which another name can be confused.
struct Lookalike {
    std::string text = {};
    std::string_view what = {};
    Span where = {};
};

/// Returns `name` with fullwidth letters, digits and `_` replaced by ASCII characters.
std::string narrow(std::string_view name) {
    std::string text;
    for (std::size_t at = 0; at < name.size();) {
        const Glyph glyph = first_glyph(name.substr(at));
        constexpr std::uint32_t first_fullwidth = 0xFF01, last_fullwidth = 0xFF5E, offset = 0xFEE0;
        const bool fullwidth = glyph.code >= first_fullwidth && glyph.code <= last_fullwidth;
        if (fullwidth) text += static_cast<char>(glyph.code - offset);
        else text += name.substr(at, glyph.bytes);
        at += glyph.bytes;
    }
    return text;
}

/// Lists the non-ASCII characters of `name`, for example `U+0430, U+0443`.
std::string characters(std::string_view name) {
    std::string text;
    for (std::size_t at = 0; at < name.size();) {
        const Glyph glyph = first_glyph(name.substr(at));
        if (glyph.bytes > 1) text += fmt::format("{}U+{:04X}", text.empty() ? "" : ", ", glyph.code);
        at += glyph.bytes;
    }
    return text;
}

class Confusables {
public:
    Confusables(const tree::File& file, std::span<const Span> first_places) : file_(file) {
        using Symbols = tree::Parser::symbol_kind;
        for (int symbol = Symbols::S_GRAFCET; symbol <= Symbols::S_FALL; ++symbol)
            add(tree::Parser::symbol_name(static_cast<tree::Parser::symbol_kind_type>(symbol)), "keyword", {});
        for (const tree::Declaration& declaration : file.declarations)
            if (const auto* const chart = std::get_if<tree::Chart>(&declaration)) add_steps(chart->items);
        for (const Id<tree::Word> word : file.words.ids())
            add(file.words[word].text, "name", word.index < first_places.size() ? first_places[word.index] : Span{});
    }

    /// Returns a keyword, step variable or name that differs from `name` but looks the same, or null. If one of these
    /// texts contains only ASCII characters, returns this text; otherwise, returns the first text that was added before
    /// `name`.
    const Lookalike* like(std::string_view name) const {
        const auto found = by_skeleton_.find(skeleton(name));
        if (found == by_skeleton_.end()) return nullptr;
        const Lookalike* best = nullptr;
        for (const Lookalike& each : found->second) {
            if (each.text == name) break;  // of two similar texts, only the later one is reported
            if (best == nullptr) best = &each;
        }
        for (const Lookalike& each : found->second)
            if (all_ascii(each.text)) return &each;
        return best;
    }

private:
    void add(std::string text, std::string_view what, Span where) {
        std::vector<Lookalike>& same = by_skeleton_[skeleton(text)];
        if (std::ranges::find(same, text, &Lookalike::text) == same.end())
            same.push_back({std::move(text), what, where});
    }

    template <class Items>
    void add_steps(const Items& items) {
        for (const tree::ChartItem& item : items) {
            if (const auto* const step = std::get_if<tree::Step>(&item))
                add('X' + std::string(file_.text(step->name)), "step variable", step->name.where);
            if (const auto* const partial = std::get_if<tree::Partial>(&item)) add_steps(partial->items);
            if (const auto* const copies = std::get_if<tree::ReplicatedChartItems>(&item)) add_steps(copies->items);
        }
    }

    const tree::File& file_;
    std::unordered_map<std::string, std::vector<Lookalike>> by_skeleton_ = {};
};

}  // namespace

void check_controls(Span part, const Sources& sources, Diagnostics& diagnostics) {
    const std::string_view text = std::string_view(sources[part.source].text).substr(0, part.end);
    Controls controls(part);
    for (std::size_t at = part.begin; at < text.size();) {
        const Glyph glyph = first_glyph(text.substr(at));
        if (glyph.obeyed && !is_blank(text.substr(at))) controls.note(glyph.code, at, glyph.bytes);
        at += glyph.bytes;
    }
    controls.report(diagnostics);
}

void check_confusables(const tree::File& file, std::span<const Span> first_places, Diagnostics& diagnostics) {
    const auto is_wide = [](const tree::Word& word) { return !all_ascii(word.text); };
    if (std::ranges::none_of(file.words, is_wide)) return;
    const Confusables known(file, first_places);
    for (const Id<tree::Word> word : file.words.ids()) {
        const std::string& name = file.words[word].text;
        if (all_ascii(name) || word.index >= first_places.size()) continue;
        const Span where = first_places[word.index];
        if (const std::string ascii = narrow(name); ascii != name) {
            diagnostics.add(messages::fullwidth_character(where, name, ascii));
        } else if (const Lookalike* const other = known.like(name)) {
            diagnostics.add(
                messages::confusable_names(where, name, characters(name), other->what, other->text, other->where));
        }
    }
}

}  // namespace grafverif
