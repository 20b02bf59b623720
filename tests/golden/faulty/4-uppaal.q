/*
P15: no horizontal move unless the cup is up
expected: satisfied
*/
A[] not ((H_G_OUT || H_G_IN) && !V_IN)

/*
P16: a vertical move ordered from a stuck cylinder is reported
expected: satisfied
*/
V_S && (V_G_OUT || V_G_IN) --> ERROR_V_OUT || ERROR_V_IN

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
no_timelock: left out; UPPAAL has no query for `no timelock`
*/
