/* shade.c - see shade.h. */
#include "hidden/surface/shade.h"

#include "hidden/surface/envelope.h"

#define ONE_Q30 (INT32_C(1) << 30)
#define SIGHT_BITS 32 /* of a height that is multiplied by a distance of 30 */

static int sign(int64_t v) {
    return (v > 0) - (v < 0);
}

/* Where a linear function from v0 to v1 leaves the side s (not 0). */
static int32_t turn(int64_t v0, int64_t v1, int s) {
    if (sign(v1) != -s) return ONE_Q30;
    const uint64_t n = (uint64_t)(v0 < 0 ? -v0 : v0), m = (uint64_t)(v1 < 0 ? -v1 : v1);
    return (int32_t)pencil_fraction(n, n + m);
}

/* Hidden is where k is above m's line of sight to one end and below that to the other: `over` is how far k is above m,
 * `sight` how far above the line of sight to m's near end. Both begin on the same side. */
static shade_t between(const int64_t over[2], const int64_t sight[2]) {
    const int s = sign(over[0]);
    if (s == 0) return (shade_t){0, sign(over[1]) * sign(sight[1]) < 0 ? ONE_Q30 : 0};
    const int32_t a = turn(over[0], over[1], s), b = turn(sight[0], sight[1], s);
    return (shade_t){pencil_min(a, b), pencil_max(a, b)};
}

/* What is less than noise apart touches. */
static int64_t apart(int64_t v, int64_t w, int64_t noise) {
    const int64_t d = v - w;
    return d > noise || d < -noise ? d : 0;
}

shade_t shade_in_chart(const pencil_t k[2], const pencil_t m[2]) {
    const int64_t n = ENVELOPE_NOISE, over[2] = {apart(k[0].w, m[0].w, n), apart(k[1].w, m[1].w, n)};
    return between(over, (const int64_t[2]){over[0], apart(k[1].w, m[0].w, n)});
}

static uint64_t size(int64_t v) {
    return (uint64_t)(v < 0 ? -v : v);
}

shade_t shade_in_space(const int64_t k_z[2], const int64_t m_z[2], const int32_t d[2], int64_t noise) {
    const int64_t over[2] = {apart(k_z[0], m_z[0], noise), apart(k_z[1], m_z[1], noise)};
    const uint64_t all = size(over[0]) | size(k_z[1]) | size(m_z[0]);
    int shift = 0;
    while (all >> shift >> SIGHT_BITS != 0) shift++;
    const int64_t far = k_z[1] >> shift, near = m_z[0] >> shift;
    return between(over, (const int64_t[2]){(over[0] >> shift) * d[0], far * d[0] - near * d[1]});
}
