// SPDX-License-Identifier: MIT
// Fuzz targets: all readers of external input, and every command on generated charts. A target is a function of bytes,
// so that libFuzzer can call it (`./dev fuzz`) and a test can replay the findings with any compiler (corpus_test).
//
// Readers get the bytes unchanged. The target `commands` interprets the bytes as choices of a
// well-formed chart or loop, of a command and of its options. A changed byte then changes the
// meaning of the input and not its spelling.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace grafverif::fuzz {

struct Target {
    std::string_view name = {};
    /// Returns a description of the guarantee that is violated by `bytes`, with the data to reproduce the failure, or
    /// an empty string.
    std::string (*error_text)(std::string_view bytes) = nullptr;
};

std::span<const Target> targets();

std::string text_complaint(std::string_view bytes);
std::string import_complaint(std::string_view bytes);
std::string structured_text_complaint(std::string_view bytes);
std::string program_complaint(std::string_view bytes);
std::string test_table_complaint(std::string_view bytes);
std::string exclusions_complaint(std::string_view bytes);
std::string scan_complaint(std::string_view bytes);
std::string plc_complaint(std::string_view bytes);
std::string monitor_complaint(std::string_view bytes);
std::string simulate_complaint(std::string_view bytes);
std::string nusmv_complaint(std::string_view bytes);
std::string verifyta_complaint(std::string_view bytes);
std::string mcp_complaint(std::string_view bytes);
std::string commands_complaint(std::string_view bytes);

}  // namespace grafverif::fuzz
