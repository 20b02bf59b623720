/*
P15: no horizontal move unless the cup is up
expected: satisfied
*/
A[] not ((H_G_OUT || H_G_IN) && !V_IN)

/*
P16: a vertical move ordered from a stuck cylinder is reported
expected: not satisfied
*/
V_S && (V_G_OUT || V_G_IN) --> ERROR_V_OUT || ERROR_V_IN

/*
P16_settled: it is reported if the order lasts longer than the instant
in quiescent states; expected: satisfied
*/
(PLC.W && stable && !EVOL_PL && !EVOL_TI && !T_X2_3s_P && !T_X10_5s_P && !T_X22_5s_P && !T_watchdog_out_XW1_12s_P && !T_watchdog_in_XW6_12s_P && !(H_Act.still && H_G_OUT && !H_G_IN && H < 20) && !(H_Act.going_out && !H_G_OUT) && !(H_Act.still && H_G_IN && !H_G_OUT && H > 0) && !(H_Act.going_in && !H_G_IN) && !(V_Act.still && V_G_OUT && !V_G_IN && !V_S && V < 10) && !(V_Act.going_out && (!V_G_OUT || V_S)) && !(V_Act.still && V_G_IN && !V_G_OUT && !V_S && V > 0) && !(V_Act.going_in && (!V_G_IN || V_S)) && !(H_Sen.in && H >= 2) && !(H_Sen.in_mid && H < 2) && !(H_Sen.in_mid && H >= 9 && H <= 11) && !(H_Sen.mid && H < 9) && !(H_Sen.mid && H > 11) && !(H_Sen.mid_out && H >= 9 && H <= 11) && !(H_Sen.mid_out && H >= 18) && !(H_Sen.out && H < 18) && !(H_Sen.in_mid && H > 11) && !(H_Sen.mid_out && H < 9) && !(V_Sen.in && V >= 1) && !(V_Sen.between && V < 1) && !(V_Sen.between && V >= 9) && !(V_Sen.out && V < 9) && !(Cup.released && P) && !(Cup.sucking && !P) && !(Tester.idle && TEST) && !(Tester.testing && !TEST) && !(Tester.passed && !TEST) && !(Tester.failed && !TEST)) && (V_S && (V_G_OUT || V_G_IN)) --> (PLC.W && stable && !EVOL_PL && !EVOL_TI && !T_X2_3s_P && !T_X10_5s_P && !T_X22_5s_P && !T_watchdog_out_XW1_12s_P && !T_watchdog_in_XW6_12s_P && !(H_Act.still && H_G_OUT && !H_G_IN && H < 20) && !(H_Act.going_out && !H_G_OUT) && !(H_Act.still && H_G_IN && !H_G_OUT && H > 0) && !(H_Act.going_in && !H_G_IN) && !(V_Act.still && V_G_OUT && !V_G_IN && !V_S && V < 10) && !(V_Act.going_out && (!V_G_OUT || V_S)) && !(V_Act.still && V_G_IN && !V_G_OUT && !V_S && V > 0) && !(V_Act.going_in && (!V_G_IN || V_S)) && !(H_Sen.in && H >= 2) && !(H_Sen.in_mid && H < 2) && !(H_Sen.in_mid && H >= 9 && H <= 11) && !(H_Sen.mid && H < 9) && !(H_Sen.mid && H > 11) && !(H_Sen.mid_out && H >= 9 && H <= 11) && !(H_Sen.mid_out && H >= 18) && !(H_Sen.out && H < 18) && !(H_Sen.in_mid && H > 11) && !(H_Sen.mid_out && H < 9) && !(V_Sen.in && V >= 1) && !(V_Sen.between && V < 1) && !(V_Sen.between && V >= 9) && !(V_Sen.out && V < 9) && !(Cup.released && P) && !(Cup.sucking && !P) && !(Tester.idle && TEST) && !(Tester.testing && !TEST) && !(Tester.passed && !TEST) && !(Tester.failed && !TEST)) && (ERROR_V_OUT || ERROR_V_IN)

/*
P16_under_way: it is reported unless the cup has already arrived at the top
expected: satisfied
*/
V_S && (V_G_OUT || (V_G_IN && V >= 1)) --> ERROR_V_OUT || ERROR_V_IN

/*
P16_or_rest: it is reported, or the station returns to rest first
expected: satisfied
*/
V_S && (V_G_OUT || V_G_IN) --> ERROR_V_OUT || ERROR_V_IN || X_0

/*
no_false_alarm: no error is reported unless the cylinder is stuck
expected: satisfied
*/
A[] not ((ERROR_V_OUT || ERROR_V_IN) && !V_S)

/*
no_deadlock
expected: satisfied
*/
A[] not deadlock

/*
no_timelock: omitted; UPPAAL has no query for `no timelock`
*/
