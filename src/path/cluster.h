/* cluster.h - the ends that meet in one place, paired: straightest first.
 *
 * Two runs of one line are straighter than anything; directions are asked for only where three ends or more have a
 * choice. */
#ifndef CLUSTER_H
#define CLUSTER_H

#include "path/chain.h"

/* Pairs n free ends that meet, at most CHAIN_CLUSTER; `end` is overwritten. At most one stays free, or both of one run.
 */
void cluster_pair(const chain_t *c, int32_t *end, int n);

#endif
