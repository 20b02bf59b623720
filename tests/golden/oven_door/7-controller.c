#include "oven_door.h"

static void oven_door_advance(struct oven_door_timer *timer, uint32_t elapsed_ms)
{
    if (timer->running) {
        if (elapsed_ms < (UINT32_MAX - timer->elapsed_ms)) {
            timer->elapsed_ms += elapsed_ms;
        } else {
            timer->elapsed_ms = UINT32_MAX;
        }
    }
}

/* on-delay timer TON of IEC 61131-3 */
static void oven_door_ton(struct oven_door_timer *timer, bool input, uint32_t preset_ms)
{
    if (!input) {
        timer->elapsed_ms = 0U;
    }
    timer->running = input;
    timer->q = input && (timer->elapsed_ms >= preset_ms);
}

void oven_door_init(oven_door_state *self)
{
    self->LIGHT = false;
    self->BUZZER = false;
    self->CLOSE = false;
    self->OPEN = false;
    self->LOCK = false;
    self->M_LOCK = false;
    self->X_0 = true;
    self->X_1 = false;
    self->X_2 = false;
    self->X_3 = false;
    self->X_4 = false;
    self->X_10 = false;
    self->X_40 = false;
    self->X_42 = false;
    self->X_20 = false;
    self->CF_t0 = false;
    self->CF_t1 = false;
    self->CF_t2 = false;
    self->CF_t3 = false;
    self->CF_t10 = false;
    self->CF_t40 = false;
    self->CF_t42 = false;
    self->CF_t20 = false;
    self->CF_t4 = false;
    self->T_X40_5s_Q = false;
    self->T_X42_5s_Q = false;
    self->T_X40_5s.running = false;
    self->T_X40_5s.q = false;
    self->T_X40_5s.elapsed_ms = 0U;
    self->T_X42_5s.running = false;
    self->T_X42_5s.q = false;
    self->T_X42_5s.elapsed_ms = 0U;
    self->FAULT = 0;
    self->started = false;
    self->stable = false;
    self->evolutions = 0U;
}

void oven_door_scan(oven_door_state *self, const oven_door_inputs *in, uint32_t elapsed_ms)
{
    oven_door_advance(&self->T_X40_5s, elapsed_ms);
    oven_door_advance(&self->T_X42_5s, elapsed_ms);
    if (self->FAULT != 0) {
        return;
    }
    /* time, sampled once per cycle */
    oven_door_ton(&self->T_X40_5s, self->X_40, 5000U);
    self->T_X40_5s_Q = self->T_X40_5s.q;
    oven_door_ton(&self->T_X42_5s, self->X_42, 5000U);
    self->T_X42_5s_Q = self->T_X42_5s.q;
    self->evolutions = 0;
    while (self->evolutions == 0 || (!self->stable && self->FAULT == 0 && self->evolutions <
        oven_door_MAX_EVOLUTIONS)) {
        if (!self->started) {
            /* the first evolution activates the initial steps */
            self->started = true;
            self->stable = false;
        } else {
            /* firing conditions */
            self->CF_t0 = self->X_0 && in->START;
            self->CF_t1 = self->X_1 && !in->START;
            self->CF_t2 = self->X_2 && in->FREE;
            self->CF_t3 = self->X_2 && in->SEAL;
            self->CF_t10 = self->X_10 && in->SEAL;
            self->CF_t40 = self->X_40 && self->T_X40_5s_Q;
            self->CF_t42 = self->X_42 && self->T_X42_5s_Q;
            self->CF_t20 = self->X_20 && in->FREE;
            self->CF_t4 = self->X_3 && self->X_4;
            self->stable = !(self->CF_t0 || self->CF_t1 || self->CF_t2 || self->CF_t3 || self->CF_t10 || self->CF_t40
                || self->CF_t42 || self->CF_t20 || self->CF_t4);
            if (self->CF_t10 && !self->X_40 && self->CF_t3 && !self->X_42) {
                self->FAULT = 2;
            }
            /* steps and stored values */
            self->M_LOCK = (self->CF_t10 && !self->X_40) || (self->M_LOCK && !(self->CF_t3 && !self->X_42));
            self->X_0 = self->CF_t4 || (self->X_0 && !self->CF_t0);
            self->X_1 = self->CF_t0 || (self->X_1 && !self->CF_t1);
            self->X_2 = self->CF_t1 || (self->X_2 && !(self->CF_t2 || self->CF_t3));
            self->X_3 = self->CF_t40 || self->CF_t20 || (self->X_3 && !self->CF_t4);
            self->X_4 = self->CF_t1 || (self->X_4 && !self->CF_t4);
            self->X_10 = self->CF_t2 || (self->X_10 && !self->CF_t10);
            self->X_40 = self->CF_t10 || (self->X_40 && !self->CF_t40);
            self->X_42 = self->CF_t3 || (self->X_42 && !self->CF_t42);
            self->X_20 = self->CF_t42 || (self->X_20 && !self->CF_t20);
        }
        oven_door_ton(&self->T_X40_5s, self->X_40, 5000U);
        self->T_X40_5s_Q = self->T_X40_5s_Q && self->X_40;
        oven_door_ton(&self->T_X42_5s, self->X_42, 5000U);
        self->T_X42_5s_Q = self->T_X42_5s_Q && self->X_42;
        self->evolutions = self->evolutions + 1;
    }
    if (!self->stable && self->FAULT == 0) {
        self->FAULT = 1;
    }
    if (self->FAULT == 0) {
        /* outputs */
        self->LIGHT = self->X_1 || self->X_4;
        self->BUZZER = self->X_4;
        self->CLOSE = self->X_10;
        self->OPEN = self->X_20;
        self->LOCK = self->M_LOCK;
    }
    /* each timer is called with the current value of its input */
    oven_door_ton(&self->T_X40_5s, self->X_40, 5000U);
    oven_door_ton(&self->T_X42_5s, self->X_42, 5000U);
}
