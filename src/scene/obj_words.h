/* obj_words.h - what the parts of the OBJ reader share (obj_reader.h is the interface): words of the mesh's elements,
 * and details. */
#ifndef OBJ_WORDS_H
#define OBJ_WORDS_H

#include "scene/obj_reader.h"

/* Pool units that so many words take at the upper end. */
static inline size_t obj_word_units(int32_t words) {
    return ((size_t)words + 1) / 2;
}

/* Is there memory for so many vertices and words? */
bool obj_has_room(const obj_reader_t *r, int32_t nv, int32_t words);
/* Says why the word at hand is refused. Returns the error. */
int obj_refuse(obj_reader_t *r, enum data_grid_trouble why);
/* Adds a word. Returns 0 or an error. */
int obj_push(obj_reader_t *r, int32_t value);
/* Writes the head of the element at hand. */
void obj_set_head(obj_reader_t *r, enum mesh_kind kind, int32_t count);
/* Where word k is. */
static inline int32_t *obj_word(const obj_reader_t *r, int32_t k) {
    return (int32_t *)(void *)(r->pool->base + r->pool->high) - 1 - k;
}

/* ---- obj_detail.c: lines that begin with d ---- */

#define OBJ_TONE 't' /* obj_reader_t.what behind the word `tone` */

/* Is the word one of those that stand between vertices? */
bool obj_detail_word(const obj_reader_t *r);
/* Takes it: `h`, another contour follows; `tone`, a number does. */
int obj_detail_take(obj_reader_t *r);
/* The word behind `tone`. */
int obj_detail_tone(obj_reader_t *r);
/* The end of the line. */
int obj_detail_end(obj_reader_t *r);

#endif
