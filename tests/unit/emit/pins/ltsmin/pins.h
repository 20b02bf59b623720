/* SPDX-License-Identifier: MIT
 * The part of LTSmin's interface used by the C files of `grafverif pins`, redeclared for tests and defined in explorer.c. */
#ifndef GRAFVERIF_TEST_PINS_H
#define GRAFVERIF_TEST_PINS_H

#include <string.h>

typedef struct test_model *model_t;
typedef struct test_type *lts_type_t;
typedef struct {
    int rows, columns;
    char *bits;
} matrix_t;
typedef struct {
    int *labels;
    int group;
    int por_proviso;
} transition_info_t;
#define GB_TI(labels, group) {(labels), (group), 0}
typedef struct {
    unsigned len;
    char *data;
} chunk;
#define chunk_str(s) ((chunk){(unsigned)strlen(s), (s)})
typedef enum { LTStypeEnum, LTStypeBool, LTStypeSInt32 } data_format_t;

typedef void (*TransitionCB)(void *context, transition_info_t *info, int *next, int *copied);
typedef int (*next_method_grey_t)(model_t model, int group, int *state, TransitionCB callback, void *context);
typedef int (*get_label_method_t)(model_t model, int label, int *state);

extern void dm_create(matrix_t *m, int rows, int columns);
extern void dm_set(matrix_t *m, int row, int column);
extern lts_type_t lts_type_create(void);
extern int lts_type_put_type(lts_type_t type, const char *name, data_format_t format, int *is_new);
extern void lts_type_set_state_length(lts_type_t type, int length);
extern void lts_type_set_state_name(lts_type_t type, int slot, const char *name);
extern void lts_type_set_state_typeno(lts_type_t type, int slot, int number);
extern void lts_type_set_edge_label_count(lts_type_t type, int count);
extern void lts_type_set_edge_label_name(lts_type_t type, int label, const char *name);
extern void lts_type_set_edge_label_typeno(lts_type_t type, int label, int number);
extern void lts_type_set_state_label_count(lts_type_t type, int count);
extern void lts_type_set_state_label_name(lts_type_t type, int label, const char *name);
extern void lts_type_set_state_label_typeno(lts_type_t type, int label, int number);
extern void lts_type_validate(lts_type_t type);
extern void GBsetLTStype(model_t model, lts_type_t type);
extern void GBsetDMInfo(model_t model, matrix_t *m);
extern void GBsetDMInfoRead(model_t model, matrix_t *m);
extern void GBsetDMInfoMayWrite(model_t model, matrix_t *m);
extern void GBsetDMInfoMustWrite(model_t model, matrix_t *m);
extern void GBsetStateLabelInfo(model_t model, matrix_t *m);
extern void GBsetInitialState(model_t model, int *state);
extern void GBsetNextStateLong(model_t model, next_method_grey_t method);
extern void GBsetStateLabelLong(model_t model, get_label_method_t method);
extern void pins_chunk_put_at(model_t model, int type, const chunk text, int index);
extern void pins_model_init(model_t model);

#endif
