/*
one_order: the door is never ordered both ways
expected: satisfied
*/
A[] not (OPEN && CLOSE)

/*
no_forced_bolt: a locked door is never moved
expected: satisfied
*/
A[] not ((OPEN || CLOSE) && LOCK)

/*
cycle_ends: every cycle that has started ends
expected: satisfied
*/
X_4 --> X_0

/*
warned: light and buzzer are on whenever the door moves
in quiescent states; expected: satisfied
*/
A[] (PLC.W && stable && !EVOL_PL && !EVOL_TI && !T_X40_5s_P && !T_X42_5s_P && !(Door.still && CLOSE && !OPEN && DOOR < 50) && !(Door.going_out && !CLOSE) && !(Door.still && OPEN && !CLOSE && DOOR > 0) && !(Door.going_in && !OPEN) && !(Door_Sen.in && DOOR >= 2) && !(Door_Sen.between && DOOR < 2) && !(Door_Sen.between && DOOR >= 48) && !(Door_Sen.out && DOOR < 48) && !(Bolt.unlocked && LOCK) && !(Bolt.locked && !LOCK) && !(Warning_Light.dark && LIGHT) && !(Warning_Light.lit && !LIGHT) && !(Warning_Buzzer.silent && BUZZER) && !(Warning_Buzzer.sounding && !BUZZER)) imply not ((OPEN || CLOSE) && !(LIGHT && BUZZER))

/*
no_deadlock
expected: satisfied
*/
A[] not deadlock

/*
no_timelock: omitted; UPPAAL has no query for `no timelock`
*/

/*
no_race: no two stored actions assign different values to one variable
expected: satisfied
*/
A[] not race
