// SPDX-License-Identifier: MIT
// TestSequence as a table that an engineer reads and a spreadsheet opens (CSV, RFC 4180):
//
//   sequence,step,wait,cycles,s,h1,h2,l1,l2,V1,V2,W1,W2,situation
//   1,1,,2,0,0,0,0,0,0,0,0,0,{1}
//
// `sequence` and `step` count from 1; each sequence starts at power-on. Step 0 is the scan that activates the initial
// steps (TestSequence::Sequence::activation), which is compared but is no test step. `wait`: the time to let pass before the
// step with the inputs of the step before, `5s` or `250ms`; empty: none. `cycles`: the scans to apply the inputs for.
// Then one column per input, one per output; Booleans are 0 and 1. The last column is the situation to expect.
#pragma once

#include <iosfwd>

#include "grafverif/ir/test_sequence.hpp"

namespace grafverif {

void print_test_csv(std::ostream& out, const TestSequence& test);

}  // namespace grafverif
