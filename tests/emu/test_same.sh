#!/bin/sh
# test_same.sh - the same seeded scenes through the hidden-line kernels on the host and on emulated Cortex-M0 and M3: every
# piece of ink, and the operations that it took, must be the same. One hash a scene. Surfaces (same.c), arithmetic in the
# ways of 32 bits (same_numbers.c), solids, haloes and polygons (same_solids.c; a Pico's area sort and a micro:bit's instructions).
#
#     test_same.sh PROGRAM CORE SEED     that scene alone, made small if the two differ
#
# RIDGELINE_CASES multiplies the count, RIDGELINE_ROUND takes other seeds, as in tests/oracle/run_cases.h.
bare=${BUILDDIR:-build}/emu/bare
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
failed=0

on_host() { "$bare/$1" $2 >"$work/host"; }
on_core() { # program, core, arguments
    args=
    for a in $3; do args=$args,arg=$a; done
    machine=mps2-an385
    [ "$2" = m0 ] && machine=microbit
    timeout 1200 qemu-system-arm -M $machine -display none -monitor none -serial none \
        -semihosting-config "enable=on,target=native,arg=$1$args" -kernel "$bare/$1-$2.elf" >"$work/core.all" 2>&1
    # What QEMU 7.2 says of every program on these machines.
    grep -v '^Timer with period zero, disabling' "$work/core.all" >"$work/core"
}
differ() { # program, core, arguments
    on_host "$1" "$3"
    on_core "$1" "$2" "$3"
    ! cmp -s "$work/host" "$work/core"
}

# Leaves out rows and columns (objects) as long as host and core differ, and tells what is left.
shrink() { # program, core, seed
    drop=0
    parts=18
    [ "$1" = same ] || parts=5
    for bit in $(seq 0 $((parts - 1))); do
        try=$((drop | 1 << bit))
        differ "$1" "$2" "$3 cut $try" && drop=$try
    done
    differ "$1" "$2" "$3 cut $drop"
    echo "shrunk: $bare/$1 $3 cut $drop; host (<) and Cortex-$2 (>):"
    diff "$work/host" "$work/core" | head -20
    head -60 "$work/host"
}

if [ $# -eq 3 ]; then
    if differ "$1" "$2" "$3"; then shrink "$1" "$2" "$3" && exit 1; fi
    echo "scene $3 of $1: host and Cortex-$2 say the same"
    exit 0
fi

same_on() { # program, core, scenes
    count=$(awk -v n="$3" -v k="${RIDGELINE_CASES:-1}" 'BEGIN { printf "%d", n * k }')
    first=$((${RIDGELINE_ROUND:-0} * count))
    if ! differ "$1" "$2" "$first $count" && [ "$(wc -l <"$work/core")" -eq "$count" ]; then
        echo "[       OK ] ${1}_on_host_and_cortex_$2"
        echo "# $1 on host and Cortex-$2: $count scenes, the same ink and the same operations"
        return
    fi
    failed=$((failed + 1))
    seed=$(diff "$work/host" "$work/core" | sed -n 's/^< \([0-9]*\) .*/\1/p' | head -1)
    echo "FAILED $1 on Cortex-$2, of $(wc -l <"$work/core") scenes $(diff "$work/host" "$work/core" | grep -c '^<') differ, first ${seed:-none}"
    echo "repeat: sh tests/emu/test_same.sh $1 $2 ${seed:-0}"
    shrink "$1" "$2" "${seed:-0}"
}
same_on same m0 5000
same_on same m3 5000
same_on same_numbers m0 5000
same_on same_numbers m3 5000
same_on same_solids m0an 1500
same_on same_solids m3 1500
[ $failed -eq 0 ] && exit 0
echo "[  FAILED  ] $failed test(s), listed above"
exit 1
