#!/bin/sh
# Runs cmocka programs one after another; ends with the line `N passed, N failed`.
passed=0 failed=0
for t in "$@"; do
    log=$(mktemp)
    "$t" >"$log" 2>&1
    rc=$?
    p=$(grep -c '^\[       OK \]' "$log")
    f=$(grep -c '^\[  FAILED  \] [a-zA-Z_0-9]*$' "$log")
    f=$(sed -n 's/^\[  FAILED  \] \([0-9]*\) test(s).*/\1/p' "$log" | tail -1)
    f=${f:-0}
    [ $rc -ne 0 ] && [ "$f" -eq 0 ] && f=1
    if [ "$f" -ne 0 ]; then cat "$log"; fi
    printf '%-48s %3d ok %3d failed\n' "${t##*/tests/}" "$p" "$f"
    grep -E '^# ' "$log"
    passed=$((passed + p)) failed=$((failed + f))
    rm -f "$log"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
