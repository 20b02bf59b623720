// SPDX-License-Identifier: MIT
#include "read/sfc_text.hpp"

#include <algorithm>
#include <vector>

#include "grafverif/syntax/parse_st.hpp"
#include "read/draft.hpp"
#include "read/sfc.hpp"
#include "read/xml.hpp"
#include "syntax/readable.hpp"

namespace grafverif {

namespace {

std::string_view without_marks(std::string_view comment) {
    if (comment.starts_with("//")) return comment.substr(2);
    return comment.substr(2, comment.size() - 4);
}

/// A comment stands before what follows it, or behind what stands before it on its line.
void keep_comments(const st::File& file, std::string_view text, Draft& draft) {
    std::vector<Span> places;
    for (const st::Unit& unit : file.units) {
        places.push_back(unit.where);
        for (const st::Variable& one : unit.variables) places.push_back(one.name.where);
        for (const st::Network& network : unit.networks) {
            for (const st::Step& one : network.steps) places.push_back(one.where);
            for (const st::Transition& one : network.transitions) places.push_back(one.where);
        }
    }
    std::ranges::sort(places, {}, &Span::begin);
    for (const st::Comment& comment : file.comments) {
        const auto next = std::ranges::upper_bound(places, comment.where.begin, {}, &Span::begin);
        const bool same_line = next != places.begin() &&
                               text.substr(std::prev(next)->begin, comment.where.begin - std::prev(next)->begin).find('\n') == std::string_view::npos;
        const Span about = same_line ? *std::prev(next) : next == places.end() ? comment.where : *next;
        for (std::string& line : comment_lines(without_marks(comment.text))) draft.comment(about, std::move(line), same_line);
    }
}

}  // namespace

tree::File read_sfc_text(Id<Source> source, const Sources& sources, bool lossy, Diagnostics& diagnostics) {
    Draft draft(source, lossy, diagnostics);
    const Span whole = without_mark({source, 0, static_cast<std::uint32_t>(sources[source].text.size())}, sources);
    if (!is_readable(whole, sources, diagnostics)) return draft.take();
    st::File file;
    file.source = source;
    if (!st::parse_units({{whole, false}}, file, sources, diagnostics)) return draft.take();
    keep_comments(file, sources[source].text, draft);
    convert_charts(file, draft);
    return draft.take();
}

}  // namespace grafverif
