// SPDX-License-Identifier: MIT
// Proof cores: the elements on which properties that hold depend. The loop is checked again with each element removed.
#pragma once

#include "grafverif/grafverif.hpp"
#include "grafverif/ir/why.hpp"
#include "pipeline/variants/variant_search.hpp"

namespace grafverif {

/// Analyses the properties in `report` that hold and are declared; see ProofExplanation. Each search explores at most
/// eight times the states of the first one, but at least 100 000, or the number that `options` allow; see
/// VariantSearch. Elements that are undecided at the deadline or when it is stopped stay open.
ProofExplanation why_it_holds(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                              const CheckOptions& options, const Report& report, const VariantBounds& bounds = {});

}  // namespace grafverif
