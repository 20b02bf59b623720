// SPDX-License-Identifier: MIT
// Reads closed loops from text or from the samples and composes them. The functions are fixtures for tests of reports,
// replay and engines.
#pragma once

#include <string>
#include <vector>

#include "compose/compose.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif {

struct LoopUnderTest {
    Model model = {};
    Network network = {};

    /// Returns the charts of the controllers, in order.
    std::vector<const Chart*> charts() const;
};

/// Composes the first loop of `model`. Throws std::invalid_argument with the first error if the loop cannot be
/// composed.
LoopUnderTest composed_loop(Model model, const ComposeOptions& options = {});

/// Composes the first loop of `text`, which may use components of templates/. Throws the exceptions of composed_loop.
LoopUnderTest read_loop(const std::string& text, const ComposeOptions& options = {});

/// Composes the first loop of samples/PATH.
LoopUnderTest read_sample(const std::string& path, const ComposeOptions& options = {});

}  // namespace grafverif
