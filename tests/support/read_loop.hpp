// SPDX-License-Identifier: MIT
// Closed loops from text or from the samples, composed: fixtures for tests of reports, replay and engines.
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

    /// The equations of the controllers, in order.
    std::vector<const Chart*> charts() const;
};

/// The first loop of `model`. Throws std::invalid_argument with the first error if it cannot be composed.
LoopUnderTest composed_loop(Model model, const ComposeOptions& options = {});

/// The first loop of `text`; components of templates/ may be used. Throws like composed_loop.
LoopUnderTest read_loop(const std::string& text, const ComposeOptions& options = {});

/// The first loop of samples/PATH.
LoopUnderTest read_sample(const std::string& path, const ComposeOptions& options = {});

}  // namespace grafverif
