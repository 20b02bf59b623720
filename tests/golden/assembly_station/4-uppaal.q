/*
PROP_R_1.X1: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_1

/*
PROP_R_1.X2: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_2

/*
PROP_R_1.X3: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_3

/*
PROP_R_1.X4: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_4

/*
PROP_R_1.X5: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_5

/*
PROP_R_1.X6: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_6

/*
PROP_R_1.X7: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_7

/*
PROP_R_1.X8: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_8

/*
PROP_R_1.X9: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_9

/*
PROP_R_1.X10: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_10

/*
PROP_R_1.X11: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_11

/*
PROP_R_1.X12: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_12

/*
PROP_R_1.X13: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_13

/*
PROP_R_1.X14: each step can be reached
this step can become active; expected: satisfied
*/
E<> X_14

/*
PROP_R_2_X1: no step is active forever: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X2: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X3: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X4: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X5: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X6: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X7: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X8: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X9: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X10: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X11: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X12: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X13: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_2_X14: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
PROP_R_3: the pallet is served in one place
expected: satisfied
*/
A[] X_1 + X_3 + X_4 + X_5 + X_6 + X_7 + X_8 + X_9 + X_10 + X_11 + X_14 == 1

/*
PROP_R_4: the manipulator does one action at a time
expected: satisfied
*/
A[] X_5 + X_6 + X_7 + X_8 + X_9 + X_10 + X_12 + X_13 == 1

/*
PROP_R_5: a pallet waits while the manipulator returns
expected: satisfied
*/
A[] !X_11 || X_2

/*
PROP_R_6: waiting pallets are served
expected: satisfied
*/
A[] !X_2 || X_3 || X_4 || X_5 || X_6 || X_7 || X_8 || X_9 || X_10 || X_11

/*
PROP1: the orders of the horizontal cylinder exclude each other
expected: satisfied
*/
A[] not (L_H_C && R_H_C)

/*
PROP2: the arm does not move down while it moves sideways
expected: satisfied
*/
A[] not (D_V_C && (L_H_C || R_H_C))

/*
PROP3: the arm does not move sideways while it is down
expected: satisfied
*/
A[] not (v_c_d && (L_H_C || R_H_C))

/*
PROP4: the arm is down only at the ends of the horizontal cylinder
expected: satisfied
*/
A[] !D_V_C || (h_c_l && !h_c_r && !R_H_C) || (!h_c_l && h_c_r && !L_H_C)

/*
H_Cyl_constraint_1: !(h_c_r && h_c_l) holds for this plant
expected: satisfied
*/
A[] !(h_c_r && h_c_l)

/*
V_Cyl_constraint_1: !(v_c_u && v_c_d) holds for this plant
expected: satisfied
*/
A[] !(v_c_u && v_c_d)
