/* data_place.h - where a row of data is: set mapping, set polar, set logscale. */
#ifndef DATA_PLACE_H
#define DATA_PLACE_H

#include "scene/data_reader.h"

/* The columns p of a row become the place that is drawn: x, y, z, or of a curve x, y. */
#if CONFIG_SAMPLED || CONFIG_LOGSCALE
void data_place(const data_spec_t *s, num_t p[3]);
#else
static inline void data_place(const data_spec_t *s, num_t p[3]) {
    (void)s, (void)p;
}
#endif

/* Does it do anything? */
static inline bool data_is_placed(const data_spec_t *s) {
#if CONFIG_LOGSCALE
    if (s->log_base) return true;
#endif
#if CONFIG_SAMPLED
    return s->mapping != DATA_CARTESIAN;
#else
    return (void)s, false;
#endif
}

/* May rows of a surface have two columns? */
static inline bool data_is_mapped(const data_spec_t *s) {
#if CONFIG_SAMPLED
    return s->mapping >= DATA_CYLINDRICAL;
#else
    return (void)s, false;
#endif
}

#endif
