/*
goes_out: the lamp never stays lit
expected: satisfied
*/
LAMP --> !LAMP

/*
dark_at_rest: at rest the lamp is dark
in quiescent states; expected: satisfied
*/
A[] (PLC.W && stable && !EVOL_PL && !EVOL_TI && !T_X1_2s_P && !T_X2_1s_P && !(Lamp.dark && LAMP) && !(Lamp.lit && !LAMP)) imply not (X_0 && LAMP)
