/* relay.c - head, then every stroke as its number of points and the points. */
#include "host/relay.h"

#include <string.h>

#include "error.h"
#include "version.h"

typedef struct head {
    char magic[32];
    uint64_t machine_bytes, strokes;
    machine_t machine;
} head_t;

static const char MAGIC[32] = "ridgeline relay " RIDGELINE_VERSION;

int relay_write(FILE *f, const machine_t *machine, const drawing_t *d) {
    head_t head = {.machine_bytes = sizeof *machine, .strokes = d ? d->strokes : 0, .machine = *machine};
    memcpy(head.magic, MAGIC, sizeof head.magic);
    if (fwrite(&head, sizeof head, 1, f) != 1) return ERR_FILE;
    for (size_t s = 0; s < head.strokes; s++) {
        size_t n;
        const page_point_t *p = drawing_stroke(d, s, &n);
        uint64_t points = n;
        if (fwrite(&points, sizeof points, 1, f) != 1 || fwrite(p, sizeof *p, n, f) != n) return ERR_FILE;
    }
    return fflush(f) ? ERR_FILE : 0;
}

int relay_read(FILE *f, machine_t *machine, drawing_t *d) {
    head_t head;
    pen_sink_t pen = drawing_sink(d);
    if (fread(&head, sizeof head, 1, f) != 1 || memcmp(head.magic, MAGIC, sizeof MAGIC) != 0 ||
        head.machine_bytes != sizeof *machine)
        return ERR_FILE;
    *machine = head.machine;
    for (uint64_t s = 0; s < head.strokes; s++) {
        uint64_t points;
        page_point_t p;
        if (fread(&points, sizeof points, 1, f) != 1) return ERR_FILE;
        for (uint64_t i = 0; i < points; i++) {
            if (fread(&p, sizeof p, 1, f) != 1) return ERR_FILE;
            int err = i ? pen.draw(pen.ctx, p) : pen.move(pen.ctx, p);
            if (err) return err;
        }
    }
    return 0;
}
