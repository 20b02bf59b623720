#include "blinker.h"

static void blinker_advance(struct blinker_timer *timer, uint32_t elapsed_ms)
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
static void blinker_ton(struct blinker_timer *timer, bool input, uint32_t preset_ms)
{
    if (!input) {
        timer->elapsed_ms = 0U;
    }
    timer->running = input;
    timer->q = input && (timer->elapsed_ms >= preset_ms);
}

void blinker_init(blinker_state *self)
{
    self->LAMP = false;
    self->X_0 = true;
    self->X_1 = false;
    self->X_2 = false;
    self->CF_t0 = false;
    self->CF_t1 = false;
    self->CF_t2 = false;
    self->CF_t3 = false;
    self->T_X1_2s_Q = false;
    self->T_X2_1s_Q = false;
    self->T_X1_2s.running = false;
    self->T_X1_2s.q = false;
    self->T_X1_2s.elapsed_ms = 0U;
    self->T_X2_1s.running = false;
    self->T_X2_1s.q = false;
    self->T_X2_1s.elapsed_ms = 0U;
    self->FAULT = 0;
    self->started = false;
    self->stable = false;
    self->evolutions = 0U;
}

void blinker_scan(blinker_state *self, const blinker_inputs *in, uint32_t elapsed_ms)
{
    blinker_advance(&self->T_X1_2s, elapsed_ms);
    blinker_advance(&self->T_X2_1s, elapsed_ms);
    if (self->FAULT != 0) {
        return;
    }
    /* time, sampled once per cycle */
    blinker_ton(&self->T_X1_2s, self->X_1, 2000U);
    self->T_X1_2s_Q = self->T_X1_2s.q;
    blinker_ton(&self->T_X2_1s, self->X_2, 1000U);
    self->T_X2_1s_Q = self->T_X2_1s.q;
    self->evolutions = 0;
    while (self->evolutions == 0 || (!self->stable && self->FAULT == 0 && self->evolutions < blinker_MAX_EVOLUTIONS))
        {
        if (!self->started) {
            /* the first evolution activates the initial steps */
            self->started = true;
            self->stable = false;
        } else {
            /* firing conditions */
            self->CF_t0 = self->X_0 && in->BUTTON;
            self->CF_t1 = self->X_1 && self->T_X1_2s_Q;
            self->CF_t2 = self->X_2 && self->T_X2_1s_Q && in->BUTTON;
            self->CF_t3 = self->X_2 && self->T_X2_1s_Q && !in->BUTTON;
            self->stable = !(self->CF_t0 || self->CF_t1 || self->CF_t2 || self->CF_t3);
            /* steps and stored values */
            self->X_0 = self->CF_t3 || (self->X_0 && !self->CF_t0);
            self->X_1 = self->CF_t0 || self->CF_t2 || (self->X_1 && !self->CF_t1);
            self->X_2 = self->CF_t1 || (self->X_2 && !(self->CF_t2 || self->CF_t3));
        }
        blinker_ton(&self->T_X1_2s, self->X_1, 2000U);
        self->T_X1_2s_Q = self->T_X1_2s_Q && self->X_1;
        blinker_ton(&self->T_X2_1s, self->X_2, 1000U);
        self->T_X2_1s_Q = self->T_X2_1s_Q && self->X_2;
        self->evolutions = self->evolutions + 1;
    }
    if (!self->stable && self->FAULT == 0) {
        self->FAULT = 1;
    }
    if (self->FAULT == 0) {
        /* outputs */
        self->LAMP = self->X_1;
    }
    /* each timer is called with the current value of its input */
    blinker_ton(&self->T_X1_2s, self->X_1, 2000U);
    blinker_ton(&self->T_X2_1s, self->X_2, 1000U);
}
