/* obj_detail.c - details of an OBJ file: `d a b ...`, a line on the face before it; `d a b c ... h d e f ...`, closed
 * ones; with `tone P` behind, one polygon with these contours that gives back P percent of the light. Each contour is
 * an element of the mesh, and the last word of a closed one says its tone (mesh_tone). */
#include "scene/obj_words.h"

#include "config.h"

static bool is(const obj_reader_t *r, const char *word, int32_t n) {
    for (int32_t k = 0; k < n; k++)
        if (r->token_len != n || r->token[k] != word[k]) return false;
    return true;
}

bool obj_detail_word(const obj_reader_t *r) {
    return is(r, "h", 1) || is(r, "tone", 4);
}

static int end_line(obj_reader_t *r) {
    const int32_t count = r->mesh.words - r->head - 1;
    if (count < 2) return obj_refuse(r, DATA_SHORT);
    obj_set_head(r, MESH_DETAIL, count);
    r->mesh.details += count - 1;
    return 0;
}

#if CONFIG_AREA

/* The contour at hand goes back to its first vertex. */
static int close(obj_reader_t *r) {
    mesh_t *m = &r->mesh;
    if (m->words - r->contour < 3) return obj_refuse(r, DATA_SHORT);
    const int32_t first = *obj_word(r, r->contour);
    int err = *obj_word(r, m->words - 1) != first ? obj_push(r, first) : 0;
    if (err) return err;
    m->details += m->words - r->contour - 1;
    err = obj_push(r, mesh_tone_word(MESH_PLAIN, r->rings++ == 0));
    obj_set_head(r, MESH_DETAIL, m->words - r->head - 1);
    return err;
}

int obj_detail_take(obj_reader_t *r) {
    int err = close(r);
    if (err) return err;
    if (r->token_len > 1) {
        r->what = OBJ_TONE;
        return 0;
    }
    r->head = r->mesh.words;
    r->contour = r->head + 1;
    return obj_push(r, 0);
}

int obj_detail_tone(obj_reader_t *r) {
    int32_t percent = 0, k = 0;
    for (; k < r->token_len && r->token[k] >= '0' && r->token[k] <= '9' && percent <= 100; k++)
        percent = percent * 10 + r->token[k] - '0';
    if (k < r->token_len || percent > 100 || r->rings == 0) return obj_refuse(r, DATA_TONE);
    int32_t at = r->detail;
    for (bool first = true; r->rings > 0; r->rings--, first = false) {
        at += *obj_word(r, at) >> 2;
        *obj_word(r, at++) = mesh_tone_word(percent, first);
    }
    return 0;
}

int obj_detail_end(obj_reader_t *r) {
    if (r->what == OBJ_TONE) return r->rings ? obj_refuse(r, DATA_TONE) : 0; /* no number came */
    if (r->rings) return close(r);
    return end_line(r);
}

#else

/* Without tones there is one line, and the rest is passed over like a name. */
int obj_detail_take(obj_reader_t *r) {
    const int err = end_line(r);
    r->what = 'g';
    return err;
}

int obj_detail_tone(obj_reader_t *r) {
    (void)r;
    return 0;
}

int obj_detail_end(obj_reader_t *r) {
    return end_line(r);
}

#endif
