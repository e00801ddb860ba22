/* outbox.c - see outbox.h. */
#include "path/outbox.h"

void outbox_init(outbox_t *o, outbox_run_t *run, int32_t cap) {
    *o = (outbox_t){.run = run, .cap = cap};
    for (int32_t k = 0; k < cap; k++) run[k].us = 0;
}

static outbox_run_t *place(outbox_t *o, int32_t k) {
    int32_t at = o->first + k;
    return &o->run[at < o->cap ? at : at - o->cap];
}

void outbox_put(outbox_t *o, const run_t *run, int side, bool ends, int32_t us) {
    outbox_run_t *to = place(o, o->n++);
    if (to->us) o->filled = true;
    o->us += us - to->us;
    to->us = us;
    to->run = *run;
    to->run.to_hi &= RUN_HI_MASK;
    if (side) to->run.to_hi |= OUTBOX_BACK;
    if (ends) to->run.to_hi |= OUTBOX_ENDS;
}

int outbox_draw(outbox_t *o, const ink_map_t *map, simplify_t *out, int64_t *vertices, bool *over) {
    const run_t *r = &o->run[o->first].run;
    const uint32_t flags = r->to_hi;
    int side = flags & OUTBOX_BACK ? 1 : 0;
    page_point_t p;
    *over = false;
    if (o->started) {
        o->t = ink_next(run_family(r), o->t, o->last);
    } else {
        o->t = run_t_of(r, side);
        o->last = run_t_of(r, 1 - side);
        o->started = true;
    }
    ++*vertices;
    int err = 0;
    if (map->point(map->ctx, run_family(r), run_surface(r), run_line(r), o->t, &p)) {
        err = o->begun ? simplify_draw(out, p) : simplify_move(out, p);
        o->begun = true;
    }
    if (err || o->t != o->last) return err;
    o->first = o->first + 1 < o->cap ? o->first + 1 : 0;
    o->n--;
    o->started = false;
    if (!(flags & OUTBOX_ENDS)) return 0;
    o->begun = false;
    *over = true;
    return simplify_finish(out);
}
