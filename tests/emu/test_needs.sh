#!/bin/sh
# test_needs.sh - what the small boards say that a scene would need, against what it needs (needs.c).
failed=0
for board in nrf51 lm3s6965; do
    if "${BUILDDIR:-build}/emu/needs-$board" $board >"${TMPDIR:-/tmp}/needs.$$"; then
        grep -E '^# |OK' "${TMPDIR:-/tmp}/needs.$$"
    else
        cat "${TMPDIR:-/tmp}/needs.$$"
        failed=1
    fi
    rm -f "${TMPDIR:-/tmp}/needs.$$"
done
exit $failed
