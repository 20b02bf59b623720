/*
P14: the station always returns to rest
expected: satisfied
*/
!(X_0 && V_IN && H_IN) --> X_0 && V_IN && H_IN

/*
P15: no horizontal move unless the cup is up
expected: satisfied
*/
A[] not ((H_G_OUT || H_G_IN) && !V_IN)

/*
no_deadlock
expected: satisfied
*/
A[] not deadlock

/*
no_timelock: omitted; UPPAAL has no query for `no timelock`
*/
