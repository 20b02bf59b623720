// SPDX-License-Identifier: MIT
// A reader of the part of the NuSMV language that the emitter writes, with NuSMV 2.6's own precedences. Tests compare
// an emitted text with the TransitionSystem that it came from.
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
        std::vector<std::string> values = {};  ///< of an enumeration
        bool chosen = false;                   ///< IVAR
    };
    struct Instance {
        std::string name = {}, module = {};
        std::vector<std::string> arguments = {};
    };
    struct Specification {
        std::string keyword = {}, name = {};
        std::string formula = {};  ///< its tokens, separated by one space
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

    Exprs exprs = {};                           ///< Variable leaves refer to `identifiers` by index
    std::vector<std::string> identifiers = {};  ///< as written: `x`, `instance.x`
    std::vector<Module> modules = {};
    std::string error_text = {};  ///< the first element that could not be read; empty: none

    Id<Expr> leaf(std::string_view identifier);
};

NusmvModel read_nusmv(std::string_view text);

}  // namespace grafverif
