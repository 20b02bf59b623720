/*
held[1]: the drill of a cell moves only while the part is clamped
expected: satisfied
*/
A[] not (D_1 > 0 && !CLAMP_OUT_1)

/*
released[1]: a cell never transfers a part that is still clamped
expected: satisfied
*/
A[] not (PUT_1 && !CLAMP_IN_1)

/*
held[2]: the drill of a cell moves only while the part is clamped
expected: satisfied
*/
A[] not (D_2 > 0 && !CLAMP_OUT_2)

/*
released[2]: a cell never transfers a part that is still clamped
expected: satisfied
*/
A[] not (PUT_2 && !CLAMP_IN_2)

/*
held[3]: the drill of a cell moves only while the part is clamped
expected: satisfied
*/
A[] not (D_3 > 0 && !CLAMP_OUT_3)

/*
released[3]: a cell never transfers a part that is still clamped
expected: satisfied
*/
A[] not (PUT_3 && !CLAMP_IN_3)

/*
no_timelock: omitted; UPPAAL has no query for `no timelock`
*/
