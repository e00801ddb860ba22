/* waiting.c - see waiting.h. */
#include "path/waiting.h"

#include "error.h"

static int wait_piece(void *ctx, const ink_piece_t *piece) {
    waiting_t *w = ctx;
    if (w->n == w->cap) return ERR_FULL;
    if (!run_fits(piece)) return ERR_VALUE;
    w->run[w->n++] = run_pack(piece);
    w->some = true;
    return 0;
}

ink_sink_t waiting_sink(waiting_t *w) {
    return (ink_sink_t){w, wait_piece};
}

int waiting_pause(waiting_t *w) {
    int err = 0;
    for (int32_t k = 0; k < w->n && err == 0; k++) {
        const ink_piece_t piece = run_unpack(&w->run[k]);
        err = w->next.piece(w->next.ctx, &piece);
    }
    w->n = 0;
    w->some = false;
    return err;
}
