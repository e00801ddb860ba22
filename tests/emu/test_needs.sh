#!/bin/sh
# test_needs.sh - what the small boards say that a scene would need, against what it needs (needs.c).
failed=0
for board in nrf51 lm3s6965; do
    if said=$("${BUILDDIR:-build}/emu/needs-$board" $board); then
        echo "$said" | grep -E '^# |OK'
    else
        echo "$said"
        failed=1
    fi
done
exit $failed
