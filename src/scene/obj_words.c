/* obj_words.c - see obj_words.h. */
#include "scene/obj_words.h"

#include "error.h"

_Static_assert(sizeof(packed_t) == 2 * sizeof(int32_t), "two words are a unit of the pool");

#define WORDS_MOST (INT32_MAX / 4) /* so that heads have room for their kind */

bool obj_has_room(const obj_reader_t *r, int32_t nv, int32_t words) {
    return (size_t)nv * 3 + obj_word_units(words) <= r->pool->high - r->pool->low;
}

int obj_refuse(obj_reader_t *r, enum data_grid_trouble why) {
    r->trouble = why;
    r->at = r->token_at;
    return why == DATA_FULL ? ERR_FULL : ERR_DATA;
}

int obj_push(obj_reader_t *r, int32_t value) {
    mesh_t *m = &r->mesh;
    if (m->words == WORDS_MOST || !obj_has_room(r, m->nv, m->words + 1)) return obj_refuse(r, DATA_FULL);
    *obj_word(r, m->words++) = value;
    return 0;
}

void obj_set_head(obj_reader_t *r, enum mesh_kind kind, int32_t count) {
    *obj_word(r, r->head) = count << 2 | (int32_t)kind;
}
