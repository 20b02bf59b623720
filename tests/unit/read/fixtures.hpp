// SPDX-License-Identifier: MIT
// Small charts in other formats, written for these tests.
#pragma once

#include <string>

namespace grafverif::fixtures {

/// A chart with macro-steps, enclosing steps, forcing orders, synchronizations, times, and every kind of action and
/// term.
inline const std::string agrafe = R"(<?xml version="1.0" encoding="UTF-8"?>
<g:Grafcet xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:g="platform:/plugin/org.eclipse.gmf.grafcet/model/grafcet.ecore" xmlns:t="platform:/plugin/org.eclipse.gmf.grafcet/model/terms.ecore" name="all">
  <variableDeclarationContainer>
    <variableDeclarations name="a"><sort xsi:type="t:Bool"/></variableDeclarations>
    <!-- the motor -->
    <variableDeclarations name="M" variableDeclarationType="output"><sort xsi:type="t:Bool"/></variableDeclarations>
    <variableDeclarations name="n" variableDeclarationType="internal"><sort xsi:type="t:Integer"/></variableDeclarations>
    <variableDeclarations name="X1" variableDeclarationType="step" step="//@partialGrafcets.0/@steps.0"><sort xsi:type="t:Bool"/></variableDeclarations>
    <variableDeclarations name="level"><sort xsi:type="t:Integer"/></variableDeclarations>
  </variableDeclarationContainer>
  <partialGrafcets xsi:type="g:PartialGrafcet" name="G1">
    <steps xsi:type="g:Step" id="1" initial="true"/>
    <steps xsi:type="g:Step" id="2"/>
    <steps xsi:type="g:EnclosingStep" id="4" partialGrafcets="//@partialGrafcets.1"/>
    <macrosteps id="3" expansion="//@partialGrafcets.2"/>
    <transitions id="1" delayTime="2" resetTime="500" unit="ms" timeConditionType="timeDependent">
      <term xsi:type="t:And"><subterm xsi:type="t:Variable" variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.0"/>
        <subterm xsi:type="t:Not"><subterm xsi:type="t:LessThan"><subterm xsi:type="t:Variable" variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.4"/><subterm xsi:type="t:IntegerConstant" value="3"/></subterm></subterm></term>
    </transitions>
    <transitions id="2"><term xsi:type="t:FallingEdge"><subterm xsi:type="t:Variable" variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.3"/></term></transitions>
    <synchronizations/>
    <synchronizations/>
    <arcs source="//@partialGrafcets.0/@steps.0" target="//@partialGrafcets.0/@transitions.0"/>
    <arcs source="//@partialGrafcets.0/@transitions.0" target="//@partialGrafcets.0/@synchronizations.0"/>
    <arcs source="//@partialGrafcets.0/@synchronizations.0" target="//@partialGrafcets.0/@steps.1"/>
    <arcs source="//@partialGrafcets.0/@synchronizations.0" target="//@partialGrafcets.0/@macrosteps.0"/>
    <arcs source="//@partialGrafcets.0/@synchronizations.0" target="//@partialGrafcets.0/@steps.2"/>
    <arcs source="//@partialGrafcets.0/@steps.1" target="//@partialGrafcets.0/@synchronizations.1"/>
    <arcs source="//@partialGrafcets.0/@macrosteps.0" target="//@partialGrafcets.0/@synchronizations.1"/>
    <arcs source="//@partialGrafcets.0/@steps.2" target="//@partialGrafcets.0/@synchronizations.1"/>
    <arcs source="//@partialGrafcets.0/@synchronizations.1" target="//@partialGrafcets.0/@transitions.1"/>
    <arcs source="//@partialGrafcets.0/@transitions.1" target="//@partialGrafcets.0/@steps.0"/>
    <actionTypes xsi:type="g:ContinuousAction" id="1" delayTime="3" timeConditionType="timeDelayed"><variable variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.1"/></actionTypes>
    <actionTypes xsi:type="g:StoredAction" id="2" storedActionType="event"><term xsi:type="t:RisingEdge"><subterm xsi:type="t:Variable" variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.0"/></term>
      <variable variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.2"/><value xsi:type="t:IntegerConstant" value="7"/></actionTypes>
    <actionTypes xsi:type="g:ForcingOrder" id="3" partialGrafcet="//@partialGrafcets.3" forcedSteps="//@partialGrafcets.3/@steps.0" forcingOrderType="explicitSituation"/>
    <actionLinks step="//@partialGrafcets.0/@steps.1" actionType="//@partialGrafcets.0/@actionTypes.0"/>
    <actionLinks step="//@partialGrafcets.0/@steps.1" actionType="//@partialGrafcets.0/@actionTypes.1"/>
    <actionLinks step="//@partialGrafcets.0/@steps.0" actionType="//@partialGrafcets.0/@actionTypes.2"/>
  </partialGrafcets>
  <partialGrafcets xsi:type="g:PartialGrafcet" name="G2" enclosingStep="//@partialGrafcets.0/@steps.2"><steps xsi:type="g:Step" id="1" activationLink="true"/></partialGrafcets>
  <partialGrafcets xsi:type="g:MacrostepExpansion" name="E">
    <transitions id="1"><term xsi:type="t:BooleanConstant" value="true"/></transitions>
    <arcs source="//@partialGrafcets.2/@entryStep" target="//@partialGrafcets.2/@transitions.0"/>
    <arcs source="//@partialGrafcets.2/@transitions.0" target="//@partialGrafcets.2/@exitStep"/>
    <entryStep id="3"/><exitStep id="3"/>
  </partialGrafcets>
  <partialGrafcets xsi:type="g:PartialGrafcet" name="G4"><steps xsi:type="g:Step" id="41" initial="true"/></partialGrafcets>
</g:Grafcet>
)";

inline const std::string agrafe_text = R"(grafcet all {
    input a;
    input level: int 0..4;
    // the motor
    output M;
    internal n: int 0..7 = 0;

    partial G1 {
        initial step 1 { force G4 := {41}; }
        step 2 { M after 3s; n := 7 on event rise(a); }
        enclosing step 4 encloses G2;
        macro step M3 expands E;

        transition t1: 1 -> 2, M3, 4 when 2ms/(a && !(level < 3))/500ms;
        transition t2: 2, M3, 4 -> 1 when fall(G1.X1);
    }

    partial G2 {
        linked step 1;
    }

    expansion E {
        entry step E3;
        exit step S3;

        transition E_t1: E3 -> S3 when true;
    }

    partial G4 {
        initial step 41;
    }
}
)";

/// A chart in the dialect of CODESYS, which has connected conditions, refers to actions of steps by their GUIDs, and
/// has branches with a jump.
inline const std::string plcopen = R"(<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0200">
  <types><pous><pou name="press" pouType="program">
    <interface>
      <inputVars><variable name="start"><type><BOOL/></type></variable><variable name="stop"><type><BOOL/></type></variable></inputVars>
      <outputVars><variable name="down"><type><BOOL/></type></variable><variable name="lamp"><type><BOOL/></type></variable></outputVars>
      <localVars><variable name="n"><type><INT/></type></variable></localVars>
    </interface>
    <actions><action name="count"><body><ST><xhtml xmlns="http://www.w3.org/1999/xhtml">IF start AND n &lt; 5 THEN lamp := TRUE; END_IF</xhtml></ST></body></action>
      <action name="set"><body><ST><xhtml xmlns="http://www.w3.org/1999/xhtml">n := 3;</xhtml></ST></body></action></actions>
    <body><SFC>
      <step localId="0" initialStep="true" name="Init"><connectionPointIn/></step>
      <selectionDivergence localId="1"><connectionPointIn><connection refLocalId="0"/></connectionPointIn></selectionDivergence>
      <inVariable localId="2"><connectionPointOut/><expression>start</expression></inVariable>
      <transition localId="3"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><condition><connectionPointIn><connection refLocalId="2"/></connectionPointIn></condition></transition>
      <inVariable localId="4"><connectionPointOut/><expression>stop</expression></inVariable>
      <transition localId="5"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><condition><connectionPointIn><connection refLocalId="4"/></connectionPointIn></condition></transition>
      <step localId="6" name="Lower"><connectionPointIn><connection refLocalId="3"/></connectionPointIn>
        <addData><data name="http://www.3s-software.com/plcopenxml/sfc/element"><attributes xmlns=""><attribute guid="a6b08bd8-b696-47e3-9cbf-7408b61c9ff8">count</attribute><attribute guid="a2621e18-7de3-4ea6-ae6d-89e9e0b7befd">set</attribute></attributes></data></addData></step>
      <actionBlock localId="7"><connectionPointIn><connection refLocalId="6"/></connectionPointIn><action qualifier="D" duration="T#2s"><reference name="down"/></action></actionBlock>
      <transition localId="8"><connectionPointIn><connection refLocalId="6"/></connectionPointIn><condition><inline name=""><ST><p>Lower.T &gt;= T#5s OR stop</p></ST></inline></condition></transition>
      <jumpStep localId="9" targetName="Init"><connectionPointIn><connection refLocalId="8"/></connectionPointIn></jumpStep>
      <jumpStep localId="10" targetName="Init"><connectionPointIn><connection refLocalId="5"/></connectionPointIn></jumpStep>
    </SFC></body>
  </pou></pous></types>
</project>
)";

inline const std::string plcopen_text =
    R"(// A Sequential Function Chart makes one evolution per scan: check this chart with `--mode every-cycle`.
grafcet press {
    input start, stop;
    output down, lamp;
    internal n: int 0..5 = 0;

    initial step Init;
    step Lower {
        down after 2s;
        lamp := start && n < 5 || !(start && n < 5) && lamp on activation;
        n := 3 on deactivation;
    }

    transition Init -> Lower when start;
    transition Init -> Init when stop && !start;
    transition Lower -> Init when 5s/XLower || stop;
}
)";

inline const std::string sfc = R"((* a press *)
PROGRAM press
  VAR_INPUT go, done : BOOL; END_VAR (* the operator *)
  VAR_OUTPUT down, lamp, horn : BOOL; END_VAR
  INITIAL_STEP Wait: lamp(R); END_STEP
  STEP Left: down(N); lamp(S); END_STEP
  STEP Right: horn(SL, T#3s); horn(P); END_STEP
  TRANSITION both FROM Wait TO (Left, Right) := go; END_TRANSITION
  TRANSITION FROM (Left, Right) TO Wait := done XOR go; END_TRANSITION
END_PROGRAM
)";

}  // namespace grafverif::fixtures
