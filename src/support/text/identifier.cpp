// SPDX-License-Identifier: MIT
#include "support/text/identifier.hpp"

#include <unicode/normalizer2.h>
#include <unicode/translit.h>
#include <unicode/uchar.h>
#include <unicode/unistr.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>

#include "support/printable.hpp"

namespace grafverif {

namespace {

bool is_ascii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Throws if a call of the library ICU failed, because no memory is available or its data file does not match its
/// version.
void demand(UErrorCode status, const char* what) {
    if (status == U_MEMORY_ALLOCATION_ERROR) throw std::bad_alloc();
    if (U_FAILURE(status) != 0) throw std::runtime_error(std::string("ICU has no ") + what);
}

icu::UnicodeString units_of(std::string_view text) {
    return icu::UnicodeString::fromUTF8(icu::StringPiece(text.data(), static_cast<std::int32_t>(text.size())));
}

std::string text_of(const icu::UnicodeString& units) {
    std::string text;
    return units.toUTF8String(text);
}

std::unique_ptr<icu::Transliterator> latin_letters() {
    UErrorCode status = U_ZERO_ERROR;
    std::unique_ptr<icu::Transliterator> letters(
        icu::Transliterator::createInstance("Any-Latin; de-ASCII", UTRANS_FORWARD, status));
    demand(status, "transliteration `Any-Latin; de-ASCII`");
    return letters;
}

}  // namespace

std::size_t identifier_length(std::string_view identifier) {
    for (std::size_t at = 0; at < identifier.size();) {
        const Glyph glyph = first_glyph(identifier.substr(at));
        const auto code = static_cast<UChar32>(glyph.code);
        const bool fits = at == 0 ? code == '_' || u_hasBinaryProperty(code, UCHAR_XID_START) != 0
                                  : u_hasBinaryProperty(code, UCHAR_XID_CONTINUE) != 0;
        if (!glyph.well_formed || !fits) return at;
        at += glyph.bytes;
    }
    return identifier.size();
}

std::string composed(std::string_view name) {
    if (is_ascii(name)) return std::string(name);
    UErrorCode status = U_ZERO_ERROR;
    const icu::Normalizer2* form = icu::Normalizer2::getNFCInstance(status);
    demand(status, "Normalization Form C");
    const icu::UnicodeString normal = form->normalize(units_of(name), status);
    demand(status, "Normalization Form C");
    return text_of(normal);
}

std::string in_ascii(std::string_view name) {
    if (is_ascii(name)) return std::string(name);
    // The transliterator is kept for later calls, because its construction is slow.
    thread_local const std::unique_ptr<icu::Transliterator> latin = latin_letters();
    icu::UnicodeString units = units_of(name);
    latin->transliterate(units);
    std::string spelled = text_of(units);
    std::erase_if(spelled, [](char c) { return static_cast<unsigned char>(c) >= 0x80 || c == '\'' || c == '"'; });
    return spelled;
}

}  // namespace grafverif
