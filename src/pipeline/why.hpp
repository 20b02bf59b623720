// SPDX-License-Identifier: MIT
// Determines proof cores: the elements of a loop on which the proofs of its properties depend. For each element, checks
// the loop again without this element.
#pragma once

#include "explain/ablation.hpp"
#include "grafverif/grafverif.hpp"
#include "grafverif/ir/why.hpp"
#include "pipeline/variants/variant_search.hpp"

namespace grafverif {

/// Analyses the properties in `report` that hold and are declared; see ProofExplanation. Each search explores at most
/// the number of states that `options` allow. By default, this number is eight times the number of states of the first
/// search, but at least 100,000 (see VariantSearch). Elements that are undecided when the analysis is stopped or
/// reaches its deadline remain undecided.
ProofExplanation why_it_holds(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                              const CheckOptions& options, const Report& report, const VariantBounds& bounds = {});

/// Converts an element of a PLC program to an element of the explanation.
ProofExplanation::ModelElement model_element(const ProgramElement& element);

/// Sorts the elements by kind, and numbers elements with equal names. Statements are numbered only if their positions
/// are also equal.
void order_elements(ProofExplanation& why);

}  // namespace grafverif
