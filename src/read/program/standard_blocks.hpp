// SPDX-License-Identifier: MIT
// The standard function blocks of IEC 61131-3 (2.5.2.3) as Structured Text: bistable elements, edge detection, counters
// and timers.
#pragma once

#include <string_view>

namespace grafverif::program {

/// The bodies of the blocks are taken from the standard. While the variable RUNNING of a timer is true, its variable
/// ELAPSED advances between two scans, even if the block is not called. Programs cannot access ELAPSED and RUNNING.
///
/// The standard permits several behaviours in some cases; the implementation is as follows. Counters stop at the limits
/// of INT. If the preset time is zero, the output Q of TON becomes true in the scan of the rising edge of IN. A pulse
/// of TP with a preset time of zero ends in the scan in which it begins. A change of the preset time while Q is true
/// does not affect TON.
inline constexpr std::string_view standard_blocks = R"(
FUNCTION_BLOCK SR
VAR_INPUT S1, R : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := S1 OR (NOT R AND Q1);
END_FUNCTION_BLOCK
FUNCTION_BLOCK RS
VAR_INPUT S, R1 : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := NOT R1 AND (S OR Q1);
END_FUNCTION_BLOCK
FUNCTION_BLOCK R_TRIG
VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR M : BOOL; END_VAR
Q := CLK AND NOT M;
M := CLK;
END_FUNCTION_BLOCK
FUNCTION_BLOCK F_TRIG
VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR M : BOOL; END_VAR
Q := NOT CLK AND NOT M;
M := NOT CLK;
END_FUNCTION_BLOCK
FUNCTION_BLOCK CTU
VAR_INPUT CU, R : BOOL; PV : INT; END_VAR VAR_OUTPUT Q : BOOL; CV : INT; END_VAR VAR M : BOOL; END_VAR
IF R THEN CV := 0;
ELSIF CU AND NOT M AND CV < 32767 THEN CV := CV + 1;
END_IF;
M := CU;
Q := CV >= PV;
END_FUNCTION_BLOCK
FUNCTION_BLOCK CTD
VAR_INPUT CD, LD : BOOL; PV : INT; END_VAR VAR_OUTPUT Q : BOOL; CV : INT; END_VAR VAR M : BOOL; END_VAR
IF LD THEN CV := PV;
ELSIF CD AND NOT M AND CV > -32768 THEN CV := CV - 1;
END_IF;
M := CD;
Q := CV <= 0;
END_FUNCTION_BLOCK
FUNCTION_BLOCK CTUD
VAR_INPUT CU, CD, R, LD : BOOL; PV : INT; END_VAR
VAR_OUTPUT QU, QD : BOOL; CV : INT; END_VAR VAR MU, MD : BOOL; END_VAR
IF R THEN CV := 0;
ELSIF LD THEN CV := PV;
ELSIF NOT (CU AND NOT MU AND CD AND NOT MD) THEN
  IF CU AND NOT MU AND CV < 32767 THEN CV := CV + 1;
  ELSIF CD AND NOT MD AND CV > -32768 THEN CV := CV - 1;
  END_IF;
END_IF;
MU := CU;
MD := CD;
QU := CV >= PV;
QD := CV <= 0;
END_FUNCTION_BLOCK
FUNCTION_BLOCK TON
VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR RUNNING : BOOL; ELAPSED : TIME; END_VAR
IF NOT IN THEN
  RUNNING := FALSE;
  ELAPSED := T#0s;
  Q := FALSE;
  ET := T#0s;
ELSE
  RUNNING := TRUE;
  IF NOT Q THEN
    IF ELAPSED >= PT THEN
      Q := TRUE;
      ET := PT;
    ELSE
      ET := ELAPSED;
    END_IF;
  END_IF;
END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK TOF
VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR RUNNING : BOOL; ELAPSED : TIME; END_VAR
IF IN THEN
  RUNNING := FALSE;
  ELAPSED := T#0s;
  Q := TRUE;
  ET := T#0s;
ELSIF Q THEN
  RUNNING := TRUE;
  IF ELAPSED >= PT THEN
    RUNNING := FALSE;
    ELAPSED := T#0s;
    Q := FALSE;
    ET := PT;
  ELSE
    ET := ELAPSED;
  END_IF;
END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK TP
VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR RUNNING, OVER : BOOL; ELAPSED : TIME; END_VAR
IF IN AND NOT RUNNING AND NOT OVER THEN
  RUNNING := TRUE;
  Q := TRUE;
END_IF;
IF RUNNING THEN
  IF ELAPSED >= PT THEN
    RUNNING := FALSE;
    ELAPSED := T#0s;
    OVER := TRUE;
    Q := FALSE;
    ET := PT;
  ELSE
    ET := ELAPSED;
  END_IF;
END_IF;
IF OVER AND NOT IN THEN
  OVER := FALSE;
  ET := T#0s;
END_IF;
END_FUNCTION_BLOCK
)";

}  // namespace grafverif::program
