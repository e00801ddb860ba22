#!/bin/sh
# test_same.sh - the same seeded scenes through the hidden-line kernels on the host and on emulated Cortex-M0 and M3: every
# piece of ink, and the operations that it took, must be the same. One hash a scene.
bare=${BUILDDIR:-build}/emu/bare
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
failed=0
"$bare/same" >"$work/host"
same_on() { # core, machine
    timeout 300 qemu-system-arm -M "$2" -display none -monitor none -serial none -semihosting-config enable=on,target=native \
        -kernel "$bare/same-$1.elf" >"$work/$1" 2>&1
    # What QEMU 7.2 says of every program on this machine.
    grep -v '^Timer with period zero, disabling' "$work/$1" >"$work/core"
    if cmp -s "$work/host" "$work/core"; then
        echo "[       OK ] scenes_are_the_same_on_a_$1"
        echo "# host and Cortex-$1: $(wc -l <"$work/core") scenes, the same ink and the same operations"
        return
    fi
    failed=$((failed + 1))
    seed=$(diff "$work/host" "$work/core" | sed -n 's/^< \([0-9]*\) .*/\1/p' | head -1)
    diff "$work/host" "$work/core" | head -4
    echo "the first scene that differs: $bare/same ${seed:-0}"
    "$bare/same" "${seed:-0}" | head -40
}
same_on m0 microbit
same_on m3 mps2-an385
[ $failed -eq 0 ] && exit 0
echo "[  FAILED  ] $failed test(s), listed above"
exit 1
