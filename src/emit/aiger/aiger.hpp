// SPDX-License-Identifier: MIT
// Writes a Circuit as AIGER 1.9 (Biere, Heljanko and Wieringa 2011: "AIGER 1.9 and beyond"), the format of the hardware
// model checking competition. The file contains inputs, latches that start with 0, and and-gates. Each state property
// is a `bad` state, and each property of runs is a `justice` list. The symbol table contains the names of all inputs,
// latches and properties.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "circuit/circuit.hpp"

namespace grafverif::aiger {

enum class Form { Ascii, Binary };

/// A property of the file: a bad state, or a list of justice conditions if `justice` is not empty.
struct AigerProperty {
    std::string name = {};
    Gates::Literal bad = Gates::no;
    std::vector<Gates::Literal> justice = {};
};

struct AigerText {
    std::string text = {};
    /// Indices of the inputs and latches of the circuit, in the order of the file.
    std::vector<std::size_t> inputs = {}, latches = {};
    std::vector<Gates::Literal> literals = {};  ///< literal in the file for each node of the circuit
};

/// Selects the complete circuit, or only the cone of the properties. If the circuit has inputs, the cone contains at
/// least one of them.
enum class Extent { Whole, Cone };
AigerText written(const Circuit& circuit, const std::vector<AigerProperty>& questions, Form form, Extent extent);

/// Returns the properties for a model checker, one per target of the circuit. If the terms of a property may be
/// undefined, or a variable may leave its range, the result also contains a property for the reachability of this
/// fault.
std::vector<AigerProperty> queries_of(const TransitionSystem& system, const FlatSystem& flat, const Circuit& circuit);

/// Returns a JSON map from the inputs, latches and properties of the file to the elements of the model. The map also
/// relates steps, inputs and outputs to the charts.
std::string map_of(const TransitionSystem& system, const FlatSystem& flat, const Circuit& circuit,
                   const AigerText& written);

}  // namespace grafverif::aiger
