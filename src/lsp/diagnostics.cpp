// SPDX-License-Identifier: MIT
#include "lsp/diagnostics.hpp"

#include <utility>

#include "support/printable.hpp"
#include "support/text/documentation.hpp"

namespace grafverif::lsp {

Places::Places(const Sources& sources, const std::string& main,
               const std::function<std::string(const std::string& path)>& shown)
    : main_(shown(main)) {
    for (const Source& source : sources) {
        texts_.emplace_back(source.text);
        paths_.push_back(shown(source.name));
    }
}

Place Places::of(Span where) const {
    if (where.source.index >= texts_.size()) return {main_, {}};
    return {paths_[where.source.index], texts_[where.source.index].range(where.begin, where.end)};
}

std::vector<LspDiagnostic> lsp_diagnostics(const Diagnostics& diagnostics, const Places& places) {
    std::vector<LspDiagnostic> all;
    for (const Diagnostic& diagnostic : diagnostics.all()) {
        LspDiagnostic one{places.of(diagnostic.where), diagnostic.severity, diagnostic.code,
                          printable(diagnostic.message)};
        one.page = diagnostic_page(diagnostic.code);
        for (const Diagnostic& note : diagnostic.notes) {
            if (note.where.source.valid()) one.related.push_back({places.of(note.where), printable(note.message)});
            else one.message += "\n" + printable(note.message);
        }
        if (diagnostic.fix) one.fix = Edit{places.of(diagnostic.fix->where), diagnostic.fix->replacement};
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace grafverif::lsp
