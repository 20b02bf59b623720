// SPDX-License-Identifier: MIT
// Writes the texts of a certificate in the format that `grafverif-certify` reads: the network with the caps of its
// clocks, states and runs (src/certify, docs/how-to/certificates.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/network_run.hpp"

namespace grafverif::certificate {

/// Limits of `grafverif-certify`: the depth of a term, and the length of a run in units of time.
inline constexpr std::size_t most_depth = 4000;
inline constexpr std::int64_t longest_run = 10'000'000;

/// Returns the checksum that the index of a certificate contains for a file: FNV-1a, 64 bits.
std::string checksum(std::string_view text);

/// Returns a name without characters that separate words. Different names remain different.
std::string word_of(std::string_view name);

/// True if the depth of some term of the network exceeds `most_depth`.
bool is_too_deep(const Network& flat);

/// Returns the text of an expanded network, in which `properties` replace the properties of the network. The patterns
/// of `properties` must be patterns that the timed engine supports. A property `reachable all steps` must be given as
/// one `reachable` for each step. The text also contains the caps of the clocks.
std::string network_text(const Network& flat, const std::vector<Property>& properties);

/// Appends the line of a state. Requires that clock values above the caps have been replaced by the caps.
void write_state(const Network& flat, const NetworkState& state, std::string& text);

/// Returns the length of a run in units of time.
std::int64_t units_of(const Run& run);

/// Returns the lines of a run, which end with `end`.
std::string run_text(const Network& flat, const Run& run);

}  // namespace grafverif::certificate
