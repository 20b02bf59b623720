/*
held_1: the drill of cell 1 moves only while the part is clamped
expected: satisfied
*/
A[] not (D_1 > 0 && !CLAMP_OUT_1)

/*
released_1: cell 1 never transfers a part that is still clamped
expected: satisfied
*/
A[] not (PUT_1 && !CLAMP_IN_1)

/*
held_2: the drill of cell 2 moves only while the part is clamped
expected: satisfied
*/
A[] not (D_2 > 0 && !CLAMP_OUT_2)

/*
released_2: cell 2 never transfers a part that is still clamped
expected: satisfied
*/
A[] not (PUT_2 && !CLAMP_IN_2)

/*
held_3: the drill of cell 3 moves only while the part is clamped
expected: satisfied
*/
A[] not (D_3 > 0 && !CLAMP_OUT_3)

/*
released_3: cell 3 never transfers a part that is still clamped
expected: satisfied
*/
A[] not (PUT_3 && !CLAMP_IN_3)

/*
no_timelock: omitted; UPPAAL has no query for `no timelock`
*/
