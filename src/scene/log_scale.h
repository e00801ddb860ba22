/* log_scale.h - a place on a logarithmic axis. */
#ifndef LOG_SCALE_H
#define LOG_SCALE_H

#include "config.h"
#include "num/func.h"
#include "num/num.h"

#if CONFIG_LOGSCALE
/* The logarithm of v; v itself if the base is 0: a linear axis. Undefined at 0 and below. */
num_t log_scale(num_t base, num_t v);
#endif

#endif
