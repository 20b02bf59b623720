/*
back_to_rest: every filling ends with two empty tanks
expected: satisfied
*/
!X_1 --> X_1 && !l1 && !l2

/*
no_overflow: no tank ever overflows
expected: satisfied
*/
A[] not (LEVEL_1 == 6 || LEVEL_2 == 8)

/*
one_way_1: a tank is never filled and emptied simultaneously
expected: satisfied
*/
A[] not (V1 && W1)

/*
one_way_2: a tank is never filled and emptied simultaneously
expected: satisfied
*/
A[] not (V2 && W2)

/*
full_not_empty: a full tank is not empty
expected: satisfied
*/
A[] (!h1 || l1) && (!h2 || l2)

/*
no_deadlock
expected: satisfied
*/
A[] not deadlock

/*
no_timelock: omitted; UPPAAL has no query for `no timelock`
*/
