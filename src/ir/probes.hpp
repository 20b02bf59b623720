// SPDX-License-Identifier: MIT
// Vacuity probes: additional `reachable` properties. Probes are added to a model before the model is checked, but not
// before it is written to a file. If a probe is violated, the associated property holds vacuously, and the `text` of
// the probe states the reason. The name of a probe, such as `NAME.(premise)`, consists of the name of the associated
// property and the type of the probe. A property in the input language cannot have the name of a probe.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafverif/ir/property.hpp"

namespace grafverif {

/// Creates a probe: if `term` is never true, `property` holds vacuously. `kind` is `premise`, `scope` or `settled`.
inline Property probe_of(const Property& property, std::string_view kind, Id<Expr> term, std::string never) {
    return {.name = property.name + ".(" + std::string(kind) + ')',
            .text = std::move(never),
            .pattern = Pattern::Reachable,
            .operands = {term},
            .origin = property.origin};
}

inline bool is_probe(const Property& property) { return property.name.ends_with(')'); }

/// Returns the name of the property to which a probe belongs, or an empty string if `property` is not a probe.
inline std::string_view probed_by(const Property& property) {
    return is_probe(property) ? std::string_view(property.name).substr(0, property.name.rfind(".("))
                              : std::string_view();
}

}  // namespace grafverif
