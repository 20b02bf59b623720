/*
dry[1]: no product is spilt
expected: satisfied
*/
A[] not Place_1.spilt

/*
filled[1]: a bottle that arrives is filled
expected: satisfied
*/
Place_1.empty && !MOVING --> FULL_1

/*
dry[2]: no product is spilt
expected: satisfied
*/
A[] not Place_2.spilt

/*
filled[2]: a bottle that arrives is filled
expected: satisfied
*/
Place_2.empty && !MOVING --> FULL_2

/*
dry[3]: no product is spilt
expected: satisfied
*/
A[] not Place_3.spilt

/*
filled[3]: a bottle that arrives is filled
expected: satisfied
*/
Place_3.empty && !MOVING --> FULL_3

/*
dry[4]: no product is spilt
expected: satisfied
*/
A[] not Place_4.spilt

/*
filled[4]: a bottle that arrives is filled
expected: satisfied
*/
Place_4.empty && !MOVING --> FULL_4

/*
still: no valve is open while the conveyor moves
expected: satisfied
*/
A[] not (MOVING && (VALVE_1 || VALVE_2 || VALVE_3 || VALVE_4))

/*
together: all four heads can fill at once
expected: satisfied
*/
E<> X_head_1_1 && X_head_2_1 && X_head_3_1 && X_head_4_1

/*
no_timelock: omitted; UPPAAL has no query for `no timelock`
*/
