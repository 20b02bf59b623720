// SPDX-License-Identifier: MIT
// Programs and a chart that the tests of `compare` vary.
#pragma once

#include "run_program.hpp"

namespace grafverif::app {

inline const std::string latch =
    "PROGRAM latch\nVAR_INPUT on, off : BOOL; END_VAR\nVAR_OUTPUT L : BOOL; END_VAR\n"
    "IF on THEN L := TRUE; END_IF;\nIF off THEN L := FALSE; END_IF;\nEND_PROGRAM\n";

inline const std::string counter =
    "PROGRAM counter\nVAR_INPUT a : BOOL; n : USINT; END_VAR\nVAR_OUTPUT q : INT; END_VAR\nVAR e : R_TRIG; END_VAR\n"
    "e(CLK := a);\nIF e.Q THEN q := q + 1; END_IF;\nEND_PROGRAM\n";

inline const std::string delay =
    "PROGRAM delay\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nVAR t : TON; END_VAR\n"
    "t(IN := a, PT := T#2s);\nq := t.Q;\nEND_PROGRAM\n";

inline const std::string lamp =
    "grafcet lamp {\n    input on, off;\n    output L;\n\n    initial step 0;\n    step 1 { L; }\n\n"
    "    transition t0: 0 -> 1 when on && !off;\n    transition t1: 1 -> 0 when off;\n}\n";

inline std::string with(std::string text, const std::string& before, const std::string& after) {
    return text.replace(text.find(before), before.size(), after);
}

inline Result compared(const std::string& a, const std::string& b, std::vector<std::string> options = {}) {
    const Folder folder;
    options.insert(options.begin(), {"compare", folder.write("a", a), folder.write("b", b)});
    return grafverif(options);
}

/// Adds a task to a program.
inline std::string every(const std::string& program, const std::string& name, const std::string& interval) {
    return program + "CONFIGURATION c\nTASK t(INTERVAL := " + interval +
           ", PRIORITY := 1);\nPROGRAM p WITH t : " + name + ";\nEND_CONFIGURATION\n";
}

}  // namespace grafverif::app
