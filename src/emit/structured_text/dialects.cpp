// SPDX-License-Identifier: MIT
// Defines the dialects. CODESYS and TwinCAT: the reserved words are those of the pages "Keywords" and "Compiler Error
// C0543" of the online help of CODESYS 3 and TwinCAT 3, and the operators and types of CODESYS. Siemens: the file
// format follows published SCL sources of S7-1500 projects. The reserved words for Siemens are the keywords of SCL and
// the attribute names in block headers; the list may be incomplete. The dialects were not tested with the tools of the
// vendors.
#include "emit/structured_text/dialects.hpp"

#include <algorithm>
#include <array>

#include "support/overloaded.hpp"

namespace grafverif::structured_text {

namespace {

// Each line of the following lists contains several words.
// clang-format off
constexpr auto codesys_words = std::to_array<std::string_view>({
    "ADR", "ADRINST", "ANDN", "AND_THEN", "ANY_CHAR", "ANY_CHARS", "ANY_DERIVED", "ANY_DURATION", "ANY_ELEMENTARY",
    "ANY_MAGNITUDE", "ANY_SIGNED", "BIT", "BITADR", "CALC", "CALCN", "CHAR_TO", "END_PROPERTY", "INDEXOF", "INI",
    "JMPC", "JMPCN", "LDATE_AND_TIME", "LDN", "LTIME_OF_DAY", "ORN", "OR_ELSE", "PARAMS", "PERSISTENT", "POINTER",
    "PROPERTY", "PVOID", "R", "REFERENCE", "RETC", "RETCN", "S", "SIZEOF", "STN", "TO_CHAR", "TO_WCHAR", "UNION",
    "UXINT", "VAR_GENERIC", "VAR_INST", "VAR_STAT", "WCHAR_TO", "XINT", "XORN", "XSIZEOF", "XWORD",
});
constexpr auto siemens_words = std::to_array<std::string_view>({
    "AUTHOR", "BEGIN", "BLOCK_DB", "BLOCK_FB", "BLOCK_FC", "BLOCK_SDB", "BLOCK_SFB", "BLOCK_SFC", "CONST", "COUNTER",
    "DATA_BLOCK", "DB_ANY", "END_CONST", "END_DATA_BLOCK", "END_LABEL", "END_ORGANIZATION_BLOCK", "END_REGION",
    "FAMILY", "GOTO", "KNOW_HOW_PROTECT", "LABEL", "NAME", "NIL", "OK", "ORGANIZATION_BLOCK", "POINTER", "REGION",
    "S5TIME", "STANDARD", "TIMER", "TITLE", "TOF_TIME", "TON_TIME", "UNLINKED", "VARIANT", "VERSION", "VOID",
});
// clang-format on

const std::array rows = {
    DialectRow{.dialect = Dialect::Iec},
    DialectRow{.dialect = Dialect::Codesys, .reserved = codesys_words},
    DialectRow{.dialect = Dialect::Twincat, .file = FileForm::PouFile, .reserved = codesys_words},
    DialectRow{.dialect = Dialect::Siemens,
               .file = FileForm::Source,
               .on_delay = "TON_TIME",
               .off_delay = "TOF_TIME",
               .prefix = "#",
               .quote = "\"",
               .attributes = "{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\n",
               .begin = "BEGIN",
               .spelling = scl_spelling,
               .reserved = siemens_words},
};

}  // namespace

const DialectRow& row_of(Dialect dialect) {
    const auto found = std::ranges::find(rows, dialect, &DialectRow::dialect);
    if (found == rows.end()) unreachable();
    return *found;
}

}  // namespace grafverif::structured_text
