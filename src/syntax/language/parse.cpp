// SPDX-License-Identifier: MIT
#include "syntax/language/parse.hpp"

#include <algorithm>
#include <cstddef>

#include "support/memory_reserve.hpp"
#include "syntax/language/builder.hpp"
#include "syntax/language/display.hpp"
#include "syntax/language/lexer.hpp"
#include "syntax/language/readable.hpp"

namespace grafverif {

tree::File parse_file(Id<Source> source, const Sources& sources, Diagnostics& diagnostics,
                      const std::atomic<bool>* stop) {
    tree::File file;
    file.source = source;
    const std::size_t size = std::min(sources[source].text.size(), largest_text + 1);
    const Span whole = without_mark({source, 0, static_cast<std::uint32_t>(size)}, sources);
    const std::size_t errors = diagnostics.errors();
    if (is_readable(whole, sources, diagnostics)) {
        check_controls(whole, sources, diagnostics);
        tree::Builder build(file, diagnostics);
        tree::Lexer lexer(sources[source], whole, file, diagnostics, stop);
        tree::Parser parser = made_with_reserve([&] { return tree::Parser(lexer, build); });
        file.incomplete = parser.parse() != 0 || file.incomplete;
        file.broken = stop != nullptr && *stop;
        if (!file.broken) check_confusables(file, lexer.first_places(), diagnostics);
    } else {
        file.incomplete = true;
    }
    file.broken = file.broken || diagnostics.errors() != errors;
    return file;
}

}  // namespace grafverif
