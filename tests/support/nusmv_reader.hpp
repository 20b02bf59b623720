// SPDX-License-Identifier: MIT
// A reader for the part of the NuSMV language that the emitter writes, with the operator precedences of NuSMV 2.6.
// Tests compare an emitted text with the TransitionSystem from which it was generated.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

struct NusmvModel {
    struct Variable {
        std::string name = {};
        Type type = {};
        std::vector<std::string> values = {};  ///< the values of an enumeration
        bool chosen = false;                   ///< the variable is declared with IVAR
    };
    struct Instance {
        std::string name = {}, module = {};
        std::vector<std::string> arguments = {};
    };
    struct Specification {
        std::string keyword = {}, name = {};
        std::string formula = {};  ///< the tokens of the formula, separated by one space
    };
    struct Module {
        std::string name = {};
        std::vector<std::string> parameters = {};
        std::vector<Variable> variables = {};
        std::vector<Instance> instances = {};
        std::map<std::string, Id<Expr>> initial = {}, next = {}, defines = {};
        std::vector<Id<Expr>> invariants = {}, transitions = {}, justice = {};
        std::vector<Specification> specifications = {};
    };

    Exprs exprs = {};                           ///< Variable leaves contain an index into `identifiers`.
    std::vector<std::string> identifiers = {};  ///< the identifiers in the text: `x`, `instance.x`
    std::vector<Module> modules = {};
    std::string error_text = {};  ///< the first element that could not be read; empty if there is none

    Id<Expr> leaf(std::string_view identifier);
};

NusmvModel read_nusmv(std::string_view text);

}  // namespace grafverif
