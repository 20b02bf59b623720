// SPDX-License-Identifier: MIT
// Circuit -> AIGER 1.9 (Biere, Heljanko and Wieringa 2011: "AIGER 1.9 and beyond"), the format of the hardware model
// checking competition: inputs, latches that start with 0, and-gates; a `bad` state per property about states, a `justice`
// list per property about runs; the symbol table names them all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "circuit/circuit.hpp"

namespace grafverif::aiger {

enum class Form { Ascii, Binary };

/// One thing asked of the model: a bad state, or where `justice` is not empty a list of conditions.
struct Question {
    std::string name = {};
    Gates::Literal bad = Gates::no;
    std::vector<Gates::Literal> justice = {};
};

struct Written {
    std::string text = {};
    std::vector<std::size_t> inputs = {}, latches = {};  ///< those of the circuit, in the order of the file
    std::vector<Gates::Literal> literals = {};           ///< per node of the circuit: its literal there
};

/// The whole circuit, or the part of it that the questions depend on, with one input at least where there is any.
enum class Extent { Whole, Cone };
Written written(const Circuit& circuit, const std::vector<Question>& questions, Form form, Extent extent);

/// What a model checker is asked of the system: a question per target; where it can be that a property has no value, or a
/// variable leaves its range, whether it does.
std::vector<Question> questions_of(const TransitionSystem& system, const FlatSystem& flat, const Circuit& circuit);

/// JSON: what the inputs, latches and questions of the file are to the model, and its steps, inputs and outputs to the charts.
std::string map_of(const TransitionSystem& system, const FlatSystem& flat, const Circuit& circuit,
                   const Written& written);

}  // namespace grafverif::aiger
