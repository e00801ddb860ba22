/* log_scale.c - see log_scale.h. */
#include "scene/log_scale.h"

#if CONFIG_LOGSCALE
num_t log_scale(num_t base, num_t v) {
    if (base.m == 0 || v.undef) return v;
    if (num_sign(v) <= 0) return num_undef();
    const num_t log = func_log10(v);
    return num_cmp(base, num_from_i64(10)) == 0 ? log : num_div(log, func_log10(base));
}
#endif
