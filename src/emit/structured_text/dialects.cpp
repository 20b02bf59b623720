// SPDX-License-Identifier: MIT
// The rows follow the manuals of the vendors. CODESYS 3.5 and TwinCAT 3: "Keywords" of the online help. Siemens:
// "Programming with SCL" of the system manual of STEP 7 (TIA Portal) for S7-1200 and S7-1500.
#include "emit/structured_text/dialects.hpp"

#include <algorithm>
#include <array>

#include "support/overloaded.hpp"

namespace grafverif::structured_text {

namespace {

// Each line of the following lists contains several words.
// clang-format off
constexpr auto codesys_words = std::to_array<std::string_view>({
    "ADR", "ADRINST", "AND_THEN", "BIT", "BITADR", "CALC", "CALCN", "INDEXOF", "INI", "JMPC", "JMPCN", "LDATE_AND_TIME",
    "LTIME_OF_DAY", "OR_ELSE", "PARAMS", "PERSISTENT", "POINTER", "PROPERTY", "PVOID", "REFERENCE", "RETC", "RETCN",
    "SIZEOF", "STN", "UNION", "UXINT", "VAR_GENERIC", "VAR_INST", "VAR_STAT", "XINT", "XSIZEOF", "XWORD",
});
constexpr auto siemens_words = std::to_array<std::string_view>({
    "AUTHOR", "BEGIN", "CONST", "COUNTER", "DATA_BLOCK", "DB_ANY", "END_CONST", "END_DATA_BLOCK", "END_LABEL",
    "END_ORGANIZATION_BLOCK", "END_REGION", "FAMILY", "GOTO", "KNOW_HOW_PROTECT", "LABEL", "NIL", "OK",
    "ORGANIZATION_BLOCK", "POINTER", "REGION", "S5TIME", "STANDARD", "TIMER", "TITLE", "TOF_TIME", "TON_TIME", "VARIANT",
    "VERSION", "VOID",
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
