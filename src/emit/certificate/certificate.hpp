// SPDX-License-Identifier: MIT
// Texts of a certificate: the network, states and runs, as `grafverif-certify` reads them
// (src/certify, docs/how-to/certificates.md).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/network_run.hpp"

namespace grafverif::certificate {

/// Limit of `grafverif-certify`: the depth of a term.
inline constexpr std::size_t most_depth = 4000;
/// Value in the state of a fragment that the fragment does not contain.
inline constexpr std::int64_t unknown_value = std::numeric_limits<std::int64_t>::min();

/// Returns the checksum that the index of a certificate contains for a file: FNV-1a, 64 bits, as a number.
std::string checksum(std::string_view text);

/// Returns a name without characters that separate words. Different names remain different.
std::string word_of(std::string_view name);

/// Returns the reason why no certificate of the network can be written, or an empty string: the depth of a term exceeds
/// `most_depth`, or a number is `unknown_value`.
std::string obstacle(const Network& flat);

/// Returns the text of an expanded network without its properties, and with `properties`, whose patterns must be those
/// of the timed engine. A property `reachable all steps` must be given as one `reachable` for each step.
std::string network_text(const Network& flat, const std::vector<Property>& properties);

/// Returns all values of a state in the order of its line. Clocks must have been replaced by their caps.
std::vector<std::int64_t> state_values(const Network& flat, const NetworkState& state);

/// Returns the text of a set of states: one line per state, in increasing order.
std::string states_text(std::vector<std::vector<std::int64_t>> states);

/// Returns the lines of a run, which end with `end`: the states after the initial state, after each edge and each unit
/// of time. A delay ends at the first state that does not change. The result is empty if the text is too long.
std::optional<std::string> run_text(const Network& flat, const Run& run, std::size_t most_bytes);

}  // namespace grafverif::certificate
