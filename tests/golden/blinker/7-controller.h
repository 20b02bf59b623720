/* blinker: controller written by grafverif from the equations of the chart */
/* One call is one PLC cycle: call it once per cycle of its task, with inputs that do not change during the call. */
/* With stability search: a call executes evolutions until the situation is stable, and then writes the outputs. */
/* FAULT is the reason of a stop: 1 no stable situation, 2 race of stored actions, 3 value outside its range. After a stop, the outputs do not change. */
#ifndef blinker_H_
#define blinker_H_

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* maximum number of evolutions per cycle; if it is exceeded, total instability is reported */
static const uint32_t blinker_MAX_EVOLUTIONS = 1000U;

typedef struct {
    bool BUTTON;
} blinker_inputs;

struct blinker_timer {
    bool running;
    bool q;
    uint32_t elapsed_ms;
};

typedef struct {
    /* outputs */
    bool LAMP;
    int16_t FAULT;  /* reason of the stop; 0 while running */
    /* internal */
    bool X_0;
    bool X_1;
    bool X_2;
    bool CF_t0;
    bool CF_t1;
    bool CF_t2;
    bool CF_t3;
    bool T_X1_2s_Q;
    bool T_X2_1s_Q;
    struct blinker_timer T_X1_2s;
    struct blinker_timer T_X2_1s;
    bool started;  /* the first evolution has been executed */
    bool stable;  /* the situation is stable */
    uint32_t evolutions;  /* evolutions in this cycle */
} blinker_state;

/* Sets the state at power-on. */
void blinker_init(blinker_state *self);

/* Executes one PLC cycle, elapsed_ms milliseconds after the previous one. */
void blinker_scan(blinker_state *self, const blinker_inputs *in, uint32_t elapsed_ms);

#ifdef __cplusplus
}
#endif

#endif
