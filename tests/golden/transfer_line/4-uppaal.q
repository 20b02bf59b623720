/*
held_1: the drill of cell 1 leaves its rest only while the part is clamped
expected: satisfied
*/
A[] not (D_1 > 0 && !CLAMP_OUT_1)

/*
released_1: cell 1 hands no part on that is still clamped
expected: satisfied
*/
A[] not (PUT_1 && !CLAMP_IN_1)

/*
held_2: the drill of cell 2 leaves its rest only while the part is clamped
expected: satisfied
*/
A[] not (D_2 > 0 && !CLAMP_OUT_2)

/*
released_2: cell 2 hands no part on that is still clamped
expected: satisfied
*/
A[] not (PUT_2 && !CLAMP_IN_2)

/*
held_3: the drill of cell 3 leaves its rest only while the part is clamped
expected: satisfied
*/
A[] not (D_3 > 0 && !CLAMP_OUT_3)

/*
released_3: cell 3 hands no part on that is still clamped
expected: satisfied
*/
A[] not (PUT_3 && !CLAMP_IN_3)

/*
no_timelock: omitted; UPPAAL has no query for `no timelock`
*/
