/*
P8_P11_P17
expected: satisfied
*/
E<> L1C.moving_in && L2C.out && !s2

/*
P5_P11_P17: the cup is at chute 2, but s2 is off
expected: not satisfied
*/
E<> L1C.in && L2C.out && !s2

/*
P5_P11_P18
expected: satisfied
*/
E<> L1C.in && L2C.out && s2

/*
all_steps.X0: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_0

/*
all_steps.X1: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_1

/*
all_steps.X2: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_2

/*
all_steps.X3: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_3

/*
all_steps.X10: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_10

/*
all_steps.X11: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_11

/*
all_steps.X12: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_12

/*
all_steps.X13: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_13

/*
all_steps.X14: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_14

/*
all_steps.X15: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_15

/*
all_steps.X16: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_16

/*
all_steps.X17: every step can be reached
this step can become active; expected: satisfied
*/
E<> X_17

/*
over_a_chute: the cup moves down only over a chute
expected: satisfied
*/
A[] not (VCGO && !(s0 || s1 || s2 || s3))

/*
cup_up: the arm moves sideways only with the cup up
expected: satisfied
*/
A[] not ((L1CGO || L1CGI || L2CGO || L2CGI) && !vc_in)

/*
no_drop: a part is released only over the unloading chute
expected: satisfied
*/
A[] not (X_16 && !s0)

/*
serves_again: the machine can always return to rest: omitted; UPPAAL has no query for `always possible` (AG EF)
*/

/*
constraint_1: !(s0 && s1) && !(s0 && s2) && !(s0 && s3) && !(s1 && s2) && !(s1 && s3) && !(s2 && s3) holds for this plant
expected: satisfied
*/
A[] !(s0 && s1) && !(s0 && s2) && !(s0 && s3) && !(s1 && s2) && !(s1 && s3) && !(s2 && s3)

/*
L1C_constraint_1: !(L1C_in && L1C_out) holds for this plant
expected: satisfied
*/
A[] !(L1C_in && L1C_out)

/*
L2C_constraint_1: !(L2C_in && L2C_out) holds for this plant
expected: satisfied
*/
A[] !(L2C_in && L2C_out)

/*
VC_constraint_1: !(vc_in && vc_out) holds for this plant
expected: satisfied
*/
A[] !(vc_in && vc_out)
