// SPDX-License-Identifier: MIT
// What is fuzzed: everything that reads bytes which others wrote, and every verb on charts that nobody wrote. A target is
// a function of bytes, so that libFuzzer drives it (`./dev fuzz`) and a test replays what libFuzzer found, with any
// compiler (corpus_test).
//
// Readers take the bytes as they are. `verbs` takes them as choices: of a well-formed chart or loop, of a verb and of its
// options, so that a changed byte changes a meaning and never a spelling.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace grafverif::fuzz {

struct Target {
    std::string_view name = {};
    /// Which promise `bytes` breaks, with what is needed to see it; empty: none.
    std::string (*complaint)(std::string_view bytes) = nullptr;
};

std::span<const Target> targets();

std::string text_complaint(std::string_view bytes);
std::string import_complaint(std::string_view bytes);
std::string structured_text_complaint(std::string_view bytes);
std::string test_table_complaint(std::string_view bytes);
std::string exclusions_complaint(std::string_view bytes);
std::string scan_complaint(std::string_view bytes);
std::string plc_complaint(std::string_view bytes);
std::string simulate_complaint(std::string_view bytes);
std::string nusmv_complaint(std::string_view bytes);
std::string verifyta_complaint(std::string_view bytes);
std::string verbs_complaint(std::string_view bytes);

}  // namespace grafverif::fuzz
