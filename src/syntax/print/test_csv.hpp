// SPDX-License-Identifier: MIT
// Prints a TestSequence as a table for engineers and spreadsheets (CSV, RFC 4180):
//
//   sequence,step,wait,cycles,s,h1,h2,l1,l2,V1,V2,W1,W2,situation
//   1,1,,2,0,0,0,0,0,0,0,0,0,{1}
//
// `sequence` and `step` count from 1; each sequence starts at power-on. Step 0 is the scan that activates the initial
// steps (TestSequence::Sequence::activation); its outputs are compared, but it does not count as a test step. `wait` is
// the time that passes before the step, such as `5s` or `250ms`; it may be empty. During this time, the inputs have the
// values of the previous step. `cycles` is the number of scans with the inputs of this step. The next columns contain
// the values of the inputs and outputs, one column each; Booleans are 0 and 1. The last column is the expected
// situation.
#pragma once

#include <iosfwd>

#include "grafverif/ir/test_sequence.hpp"

namespace grafverif {

void print_test_csv(std::ostream& out, const TestSequence& test);

}  // namespace grafverif
