/* reentrant.h - a contour clipped by convex borders, a vertex at a time.
 *
 * Sutherland & Hodgman (1974, "Reentrant polygon clipping"): a contour goes through one border after the other, each of
 * which keeps no more than where the contour began and where it is. So it takes no memory but what it leaves.
 *
 * REENTRANT(ctx_t, place_t, borders) makes, of a file that has
 *
 *     bool is_inside(const ctx_t *c, int32_t border, const place_t *p)
 *     place_t crossing(const ctx_t *c, int32_t border, const place_t *a, const place_t *b)   of two on different sides
 *     int write(ctx_t *c, const place_t *p)                                                  what is inside of all
 *
 * and in its ctx_t an array `REENTRANT_BORDER(place_t) at[borders]`, zero before the first contour:
 *
 *     int put(ctx_t *c, int32_t border, place_t p)    the next place of a contour, for the borders from `border` on
 *     int put_end(ctx_t *c, int32_t border)           after the last one: the way back to the first
 *
 * Both return 0 or write's error. */
#ifndef REENTRANT_H
#define REENTRANT_H

#include <stdbool.h>
#include <stdint.h>

#define REENTRANT_BORDER(place_t)                                                                                      \
    struct {                                                                                                           \
        place_t first, last;                                                                                           \
        bool any;                                                                                                      \
    }

#define REENTRANT(ctx_t, place_t, borders)                                                                             \
    static int put(ctx_t *c, int32_t border, place_t p) {                                                              \
        struct {                                                                                                       \
            place_t p;                                                                                                 \
            int32_t border;                                                                                            \
        } todo[(borders) + 2] = {{p, border}};                                                                         \
        for (int32_t n = 1; n > 0;) {                                                                                  \
            p = todo[--n].p;                                                                                           \
            border = todo[n].border;                                                                                   \
            if (border == (borders)) {                                                                                 \
                int err = write(c, &p);                                                                                \
                if (err) return err;                                                                                   \
                continue;                                                                                              \
            }                                                                                                          \
            const bool inside = is_inside(c, border, &p), any = c->at[border].any;                                     \
            const place_t last = c->at[border].last;                                                                   \
            if (!any) c->at[border].first = p;                                                                         \
            c->at[border].any = true;                                                                                  \
            c->at[border].last = p;                                                                                    \
            if (inside) todo[n].p = p, todo[n++].border = border + 1;                                                  \
            if (any && is_inside(c, border, &last) != inside)                                                          \
                todo[n].p = crossing(c, border, &last, &p), todo[n++].border = border + 1;                             \
        }                                                                                                              \
        return 0;                                                                                                      \
    }                                                                                                                  \
    static int put_end(ctx_t *c, int32_t border) {                                                                     \
        for (; border < (borders); border++) {                                                                         \
            const place_t first = c->at[border].first, last = c->at[border].last;                                      \
            const bool crosses = c->at[border].any && is_inside(c, border, &first) != is_inside(c, border, &last);     \
            c->at[border].any = false;                                                                                 \
            int err = crosses ? put(c, border + 1, crossing(c, border, &last, &first)) : 0;                            \
            if (err) return err;                                                                                       \
        }                                                                                                              \
        return 0;                                                                                                      \
    }

#endif
