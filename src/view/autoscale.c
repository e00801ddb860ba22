/* autoscale.c - see autoscale.h. The rule was found by experiment with gnuplot 5.4 over spans of all decades. */
#include "view/autoscale.h"

#include "error.h"

/* The largest power of ten not above v > 0. */
static num_t power_of_ten_below(num_t v) {
    int32_t exp10;
    num_to_decimal(v, 1, &exp10); /* one digit, rounded: off by one decade at 9.5 and above */
    num_t p = num_from_decimal(1, exp10);
    return num_cmp(p, v) > 0 ? num_from_decimal(1, exp10 - 1) : p;
}

static num_t linear_step(num_t span) {
    /* Upper limits of span / power for each step, in tenths: 20 / span gives the candidate positions in a decade. */
    static const struct {
        uint8_t below_tenths, step_hundredths;
    } LADDER[] = {{5, 5}, {10, 10}, {20, 20}, {50, 50}, {100, 100}};
    num_t power = power_of_ten_below(span);
    num_t norm = num_div(span, power); /* 1 <= norm < 10 */
    for (unsigned k = 0; k < sizeof LADDER / sizeof LADDER[0]; k++)
        if (num_cmp(norm, num_from_decimal(LADDER[k].below_tenths, -1)) < 0)
            return num_mul(power, num_from_decimal(LADDER[k].step_hundredths, -2));
    return num_mul(power, num_from_i64(2));
}

num_t autoscale_step(num_t span, bool log) {
    const num_t step = linear_step(span), one = num_from_i64(1);
    return log && num_cmp(step, one) < 0 ? one : step;
}

static num_t round_down(num_t v, num_t step) {
    return num_mul(num_floor(num_div(v, step)), step);
}

static num_t round_up(num_t v, num_t step) {
    return num_mul(num_ceil(num_div(v, step)), step);
}

int autoscale_range(const range_t *set, enum autoscale_tics tics, num_t *lo, num_t *hi) {
    if (!set->auto_lo) *lo = set->lo;
    if (!set->auto_hi) *hi = set->hi;
    if (lo->undef || hi->undef) return ERR_VALUE;
    int order = num_cmp(*lo, *hi);
    if (order > 0 || (order == 0 && !set->auto_lo && !set->auto_hi)) return ERR_VALUE;
    if (order == 0) {
        num_t widen = num_sign(*lo) ? num_mul(num_abs(*lo), num_from_decimal(1, -2)) : num_from_i64(1);
        if (set->auto_lo) *lo = num_sub(*lo, widen);
        if (set->auto_hi) *hi = num_add(*hi, widen);
    }
    if (tics == AUTOSCALE_NONE) return 0;
    const num_t step = tics == AUTOSCALE_LOG ? num_from_i64(1) : autoscale_step(num_sub(*hi, *lo), false);
    if (set->auto_lo) *lo = round_down(*lo, step);
    if (set->auto_hi) *hi = round_up(*hi, step);
    return 0;
}
