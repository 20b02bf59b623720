/* SPDX-License-Identifier: MIT
 * Explores one model through the LTSmin interface alone. Prints `states N`, `label NAME N` with the number of states in
 * which each label is 1, and `fault ...` if the model contradicts its dependency matrices. A transition group may write
 * only the slots in its row of the write matrix. Its moves may depend only on slots in its row of the read matrix. */
#include <stdio.h>
#include <stdlib.h>

#include <ltsmin/pins.h>

struct test_type {
    int slots, labels;
    const char *slot_names[4096], *label_names[4096];
};
static struct test_type type;
static next_method_grey_t next_state;
static get_label_method_t state_label;
static matrix_t *both, *reads, *may_write, *must_write, *asked;
static int *initial;

void dm_create(matrix_t *m, int rows, int columns) {
    m->rows = rows;
    m->columns = columns;
    m->bits = calloc((size_t)rows * (size_t)columns + 1, 1);
}
void dm_set(matrix_t *m, int row, int column) { m->bits[row * m->columns + column] = 1; }
static int has(const matrix_t *m, int row, int column) { return m->bits[row * m->columns + column]; }
lts_type_t lts_type_create(void) { return &type; }
int lts_type_put_type(lts_type_t t, const char *name, data_format_t format, int *is_new) {
    (void)t, (void)name;
    *is_new = 1;
    return (int)format;
}
void lts_type_set_state_length(lts_type_t t, int length) { t->slots = length; }
void lts_type_set_state_name(lts_type_t t, int slot, const char *name) { t->slot_names[slot] = name; }
void lts_type_set_state_typeno(lts_type_t t, int slot, int number) { (void)t, (void)slot, (void)number; }
void lts_type_set_edge_label_count(lts_type_t t, int count) { (void)t, (void)count; }
void lts_type_set_edge_label_name(lts_type_t t, int label, const char *name) { (void)t, (void)label, (void)name; }
void lts_type_set_edge_label_typeno(lts_type_t t, int label, int number) { (void)t, (void)label, (void)number; }
void lts_type_set_state_label_count(lts_type_t t, int count) { t->labels = count; }
void lts_type_set_state_label_name(lts_type_t t, int label, const char *name) { t->label_names[label] = name; }
void lts_type_set_state_label_typeno(lts_type_t t, int label, int number) { (void)t, (void)label, (void)number; }
void lts_type_validate(lts_type_t t) {
    for (int i = 0; i < t->slots; ++i)
        for (int k = 0; k < i; ++k)
            if (strcmp(t->slot_names[i], t->slot_names[k]) == 0) printf("fault two slots `%s`\n", t->slot_names[i]);
}
void GBsetLTStype(model_t m, lts_type_t t) { (void)m, (void)t; }
void GBsetDMInfo(model_t m, matrix_t *x) { (void)m, both = x; }
void GBsetDMInfoRead(model_t m, matrix_t *x) { (void)m, reads = x; }
void GBsetDMInfoMayWrite(model_t m, matrix_t *x) { (void)m, may_write = x; }
void GBsetDMInfoMustWrite(model_t m, matrix_t *x) { (void)m, must_write = x; }
void GBsetStateLabelInfo(model_t m, matrix_t *x) { (void)m, asked = x; }
void GBsetInitialState(model_t m, int *state) {
    (void)m;
    initial = malloc(sizeof(int) * (size_t)type.slots);
    memcpy(initial, state, sizeof(int) * (size_t)type.slots);
}
void GBsetNextStateLong(model_t m, next_method_grey_t method) { (void)m, next_state = method; }
void GBsetStateLabelLong(model_t m, get_label_method_t method) { (void)m, state_label = method; }
void pins_chunk_put_at(model_t m, int t, const chunk text, int index) {
    static char *texts[4096];
    (void)m, (void)t;
    for (int i = 0; i < index; ++i)
        if (strcmp(texts[i], text.data) == 0) printf("fault two moves `%s`\n", text.data);
    texts[index] = text.data;
}

/* The states that were found: a hash table with open addressing. */
static int *states, *table, count, room = 1024, places = 4096;

static unsigned hash(const int *state) {
    unsigned h = 2166136261U;
    for (int i = 0; i < type.slots; ++i) h = (h ^ (unsigned)state[i]) * 16777619U;
    return h ^ h >> 15;
}
static int *at(int index) { return states + (size_t)index * (size_t)type.slots; }
static void add(const int *state) {
    if (2 * count > places) {
        places *= 4;
        free(table);
        table = calloc((size_t)places, sizeof(int));
        for (int i = 0; i < count; ++i) {
            unsigned h = hash(at(i)) & (unsigned)(places - 1);
            while (table[h]) h = (h + 1) & (unsigned)(places - 1);
            table[h] = i + 1;
        }
    }
    unsigned h = hash(state) & (unsigned)(places - 1);
    for (; table[h]; h = (h + 1) & (unsigned)(places - 1))
        if (memcmp(at(table[h] - 1), state, sizeof(int) * (size_t)type.slots) == 0) return;
    if (count == room) states = realloc(states, sizeof(int) * (size_t)type.slots * (size_t)(room *= 2));
    memcpy(at(count), state, sizeof(int) * (size_t)type.slots);
    table[h] = ++count;
}

static int moved, *reached;
static void found(void *context, transition_info_t *info, int *next, int *copied) {
    (void)context, (void)info, (void)copied;
    moved = 1;
    memcpy(reached, next, sizeof(int) * (size_t)type.slots);
}
static int step(int group, int *state) {
    moved = 0;
    next_state(0, group, state, found, 0);
    return moved;
}

/* A group that does not read a slot must make the same moves if the slot has its value from another state. */
static void compare(int group, int index, int *other, int *first) {
    const int slot = (index * 7 + group) % type.slots, from = (index * 13 + group * 5) % count;
    int *const state = at(index);
    if (has(reads, group, slot) || at(from)[slot] == state[slot]) return;
    const int could = step(group, state);
    memcpy(first, reached, sizeof(int) * (size_t)type.slots);
    memcpy(other, state, sizeof(int) * (size_t)type.slots);
    other[slot] = at(from)[slot];
    if (step(group, other) != could) printf("fault group %d reads %s\n", group, type.slot_names[slot]);
    for (int i = 0; could && moved && i < type.slots; ++i)
        if (first[i] != reached[i] && i != slot) printf("fault group %d reads %s\n", group, type.slot_names[slot]);
    if (could && moved && has(may_write, group, slot) && first[slot] != reached[slot])
        printf("fault group %d writes %s by what it was\n", group, type.slot_names[slot]);
}

int main(void) {
    pins_model_init(0);
    states = malloc(sizeof(int) * (size_t)type.slots * (size_t)room);
    table = calloc((size_t)places, sizeof(int));
    reached = malloc(sizeof(int) * (size_t)type.slots);
    int *const other = malloc(sizeof(int) * (size_t)type.slots), *const first = malloc(sizeof(int) * (size_t)type.slots);
    add(initial);
    for (int index = 0; index < count && count < 300000; ++index)
        for (int group = 0; group < reads->rows; ++group) {
            if (!step(group, at(index))) continue;
            for (int slot = 0; slot < type.slots; ++slot)
                if (reached[slot] != at(index)[slot] && !has(may_write, group, slot))
                    printf("fault group %d writes %s\n", group, type.slot_names[slot]);
            add(reached);
        }
    for (int index = 0; index < count; index += 1 + count / 2000)
        for (int group = 0; group < reads->rows; ++group) compare(group, index, other, first);
    printf("states %d\n", count);
    for (int label = 0; label < type.labels; ++label) {
        long times = 0;
        for (int index = 0; index < count; ++index) times += state_label(0, label, at(index)) != 0;
        printf("label %s %ld\n", type.label_names[label], times);
    }
    for (int group = 0; group < reads->rows; ++group)
        for (int slot = 0; slot < type.slots; ++slot)
            if (has(both, group, slot) != (has(reads, group, slot) | has(may_write, group, slot)) ||
                has(must_write, group, slot) > has(may_write, group, slot))
                printf("fault the matrices of group %d\n", group);
    return 0;
}
