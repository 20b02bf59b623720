/* oven_door: controller written by grafverif from the equations of the chart */
/* One call is one PLC cycle: call it once per cycle of its task, with inputs that do not change during the call. */
/* With stability search: a call executes evolutions until the situation is stable, and then writes the outputs. */
/* FAULT is the reason of a stop: 1 no stable situation, 2 race of stored actions, 3 value outside its range. After a stop, the outputs do not change. */
#ifndef oven_door_H_
#define oven_door_H_

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* maximum number of evolutions per cycle; if it is exceeded, total instability is reported */
static const uint32_t oven_door_MAX_EVOLUTIONS = 1000U;

typedef struct {
    bool START;
    bool FREE;
    bool SEAL;
} oven_door_inputs;

struct oven_door_timer {
    bool running;
    bool q;
    uint32_t elapsed_ms;
};

typedef struct {
    /* outputs */
    bool LIGHT;
    bool BUZZER;
    bool CLOSE;
    bool OPEN;
    bool LOCK;
    int16_t FAULT;  /* reason of the stop; 0 while running */
    /* internal */
    bool M_LOCK;  /* image of LOCK */
    bool X_0;
    bool X_1;
    bool X_2;
    bool X_3;
    bool X_4;
    bool X_10;
    bool X_40;
    bool X_42;
    bool X_20;
    bool CF_t0;
    bool CF_t1;
    bool CF_t2;
    bool CF_t3;
    bool CF_t10;
    bool CF_t40;
    bool CF_t42;
    bool CF_t20;
    bool CF_t4;
    bool T_X40_5s_Q;
    bool T_X42_5s_Q;
    struct oven_door_timer T_X40_5s;
    struct oven_door_timer T_X42_5s;
    bool started;  /* the first evolution has been executed */
    bool stable;  /* the situation is stable */
    uint32_t evolutions;  /* evolutions in this cycle */
} oven_door_state;

/* Sets the state at power-on. */
void oven_door_init(oven_door_state *self);

/* Executes one PLC cycle, elapsed_ms milliseconds after the previous one. */
void oven_door_scan(oven_door_state *self, const oven_door_inputs *in, uint32_t elapsed_ms);

#ifdef __cplusplus
}
#endif

#endif
