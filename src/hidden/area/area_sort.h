/* area_sort.h - what the sort and its windows share (area.h is the interface). */
#ifndef AREA_SORT_H
#define AREA_SORT_H

#include "hidden/area/area.h"
#include "hidden/area/area_pool.h"

typedef struct area {
    area_faces_t faces;
    area_pool_t pool;
    void *clip_mem;
    size_t clip_bytes;
    clip_t clip;
    struct {
        area_list_t outside;
        int32_t face;
    } * stack;
    int32_t depth;
    area_box_t window; /* that is being sorted */
    bool sink_failed;
    /* Z subdivision: what of the window nothing visible covers yet, in one of two stores; NULL without. */
    poly_t *open;
    clip_out_t store[2];
    int which;
    uint8_t *state; /* of each face of the scene, enum area_state */
    const area_sink_t *sink;
    area_stats_t *stats;
    size_t fixed; /* bytes of the memory that do not depend on the window */
} area_t;

/* The part of a box where a plane is above 0: at most 6 vertices. */
int32_t area_half_of(const area_box_t *box, const area_plane_t *plane, poly_vertex_t v[8]);
/* Ends of a face's edges, or of those of a body's sharp faces, come out roughly: area_wires.h draws them. */
void area_roughen(area_t *a, const area_face_t *f);
/* Where the polygon p of face `of` is to face `than`, where both are: in one plane they hide nothing of each other, and
 * AREA_THROUGH says that they cut through each other. An edge of p in the plane of what hides its face is seen, as a
 * line: the face is made rough for it. */
enum { AREA_BEHIND, AREA_TOGETHER, AREA_IN_FRONT, AREA_THROUGH };
int area_compare(area_t *a, const poly_t *p, int32_t of, int32_t than);
/* Gives the visible pieces of a list to the sink, of a silhouette what is in each of its body's faces, and takes them
 * out of what is open and of the pool. Returns 0, ERR_FULL or the sink's error. */
int area_show(area_t *a, area_list_t list);
/* Gives what is visible of a list of pieces, nearest first, to the sink. Returns 0, ERR_FULL or the sink's error. */
int area_sort_list(area_t *a, area_list_t list);

/* A window with more faces than this allows is not even tried. */
#define PIECES_PER_FACE 3
/* The same of all that lies in a window of the page, halved where it must be (area_window.c). tick may be NULL. */
int area_windows(area_t *a, area_box_t all, void (*tick)(void *ctx, int32_t done, int32_t of), void *tick_ctx);

#endif
