#!/bin/sh
# boards.sh BUILDDIR OUT - what drawings and expressions cost on a Cortex-M0 and M3 (instructions, QEMU) and on an RP2040 (cycles,
# rp2040js): runs tests/emu/bare/count, writes OUT/boards.tsv and the section on stdout. Same numbers from the same commit and compiler.
set -e
bare=$1/emu/bare
out=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A Cortex-M0's instructions are run as they are by a Cortex-M3 that has the memory for 40 x 40 points: no instruction of it counts
# differently there.
for program in count count_solids; do
    for core in m0an m3; do
        timeout 600 qemu-system-arm -M mps2-an385 -display none -monitor none -serial none -semihosting-config enable=on,target=native \
            -plugin "$bare/counter.so,out=$work/$program-$core.marks" -kernel "$bare/$program-$core.elf" >"$work/$program-$core.lines" 2>&1
    done
    mark=$(${CROSS:-arm-none-eabi-}nm "$bare/$program-rp2040.elf" | awk '$3 == "bare_mark" { print $1 }')
    EMU_MODULES=$1/emu timeout 900 node tests/emu/bare/bare_rp2040.mjs "$bare/$program-rp2040.bin" "$mark" "$work/$program-rp2040.marks" \
        >"$work/$program-rp2040.lines"
done
for core in m0an m3 rp2040; do
    cat "$work/count-$core.lines" "$work/count_solids-$core.lines" >"$work/$core.lines"
    for program in count count_solids; do
        awk 'NR % 2 { before = $1; next } { print $1 - before }' "$work/$program-$core.marks"
    done >"$work/$core.spent"
done
cmp "$work/m0an.lines" "$work/m3.lines" && cmp "$work/m0an.lines" "$work/rp2040.lines" # the same elements everywhere
{
    printf 'what\tof\tbits\telements\tm0_instructions\tm3_instructions\trp2040_cycles\n'
    paste "$work/m0an.lines" "$work/m0an.spent" "$work/m3.spent" "$work/rp2040.spent"
} >"$out/boards.tsv"

awk -F '\t' '/^(perimeter|windows|horizon|convex|area|halo|clip)/ { drawing[++n] = $0 } END {
    print "\n## Boards: what a facet costs\n"
    print "Instructions (cycles on the RP2040) per facet of the kernel alone, 40 x 40 points (with holes for windows), heights at hand; and per edge"
    print "(convex, halo), face that looks at the eye (area sort) and vertex (clip). The scenes are the same everywhere; so are the pieces and the"
    print "operations (tests/emu/test_same.sh).\n"
    print "| kernel | family | bits | Cortex-M0 | Cortex-M3 | RP2040 cycles | RP2040 at 125 MHz |"
    print "|---|---|--:|--:|--:|--:|--:|"
    for (i = 1; i <= n; i++) {
        split(drawing[i], f, "\t")
        if (f[4] < 0)
            printf "| %s | %s | %s | does not fit into a Pico | | | |\n", f[1], f[2], f[3]
        else
            printf "| %s | %s | %s | %.0f | %.0f | %.0f | %.1f us |\n", f[1], f[2], f[3] == 15 || f[1] ~ /^(convex|area|halo|clip)/ ? f[3] " (shipped)" : f[3], f[5] / f[4], f[6] / f[4], f[7] / f[4], f[7] / f[4] / 125
    }
}' "$out/boards.tsv"
awk -F '\t' '$1 ~ /^(Q|float|double|num_t)/ { line[++n] = $0 } END {
    print "\n## Boards: what a point costs in each number format\n"
    print "Written out without an interpreter; fixed point with a polynomial of its own precision for exp, float and double by the compiler'"'"'s library.\n"
    print "| format | expression | Cortex-M0 | Cortex-M3 | RP2040 cycles |"
    print "|---|---|--:|--:|--:|"
    for (i = 1; i <= n; i++) {
        split(line[i], f, "\t")
        printf "| %s | `%s` | %.0f | %.0f | %.0f |\n", f[1] == "num_t" ? "shipped (num_t)" : f[1], f[2], f[5] / f[4], f[6] / f[4], f[7] / f[4]
        cost[f[1] f[2]] = f[5] / f[4]
    }
    e = "exp(-x**2-y**2)"
    printf "\nOn a Cortex-M0 `%s` takes %.0f instructions as shipped, %.0f in Q16.16, %.0f in Q32.32, %.0f in float and %.0f in double: the range of a double", e, \
        cost["num_t" e], cost["Q16.16" e], cost["Q32.32" e], cost["float" e], cost["double" e]
    print " costs less here than the precision of a float does from the library, and a few times what a format would that cannot hold most functions."
}' "$out/boards.tsv"
