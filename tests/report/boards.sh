#!/bin/sh
# boards.sh BUILDDIR OUT - what drawings and expressions cost on a Cortex-M0 and M3 (instructions, QEMU) and on an RP2040 (cycles,
# rp2040js): runs tests/emu/bare/count and count_solids, writes OUT/boards.tsv and the section on stdout. Same numbers from the same
# commit and compiler. boards.sh --errors OUT: the same rows beside the errors of their families, which other programs left in OUT.
set -e

# Every kernel, family and number of bits; the first row of a kernel and family is that of the bits that are shipped, in both tables.
# lattice.tsv and solids-bits.tsv come first and bring the errors, steps.
if [ "$1" = --errors ]; then
    awk -F '\t' '
        function most(a, b, c) { a += 0; b += 0; c += 0; return a > b ? a > c ? a : c : b > c ? b : c }
        FNR == 1 { file++; next }
        file == 1 { error[$1, $2, $4] = most($5, $6, $9); next }
        file == 2 { error[$1, $2, $3] = most($6, $7, $8); next }
        { shipped = !seen[$1, $2]++ }
        !(($1, $2, $3) in error) || $4 <= 0 { next }
        { if (!(($1, $2) in rows)) order[++n] = $1 SUBSEP $2
          rows[$1, $2] = rows[$1, $2] sprintf("| %s | %s | %s%s | %.2f | %.0f | %.0f | %.0f | %.1f us |\n", $1, $2, $3, shipped ? " (shipped)" : "",
              error[$1, $2, $3], $5 / $4, $6 / $4, $7 / $4, $7 / $4 / 133) }
        END {
            print "# Error against speed on the boards\n"
            print "Error: the longest missing or false run or the largest displacement of an end, in steps, of the family'"'"'s scenes on the host (the"
            print "clipper: area over length), as in the tables over bits in [the report](README.md). Cost per facet, segment, edge, face or vertex of"
            print "the kernel alone: instructions, on the RP2040 cycles, and their time at 133 MHz. What is not a board'"'"'s to vary: the bits of a page'"'"'s"
            print "lattice in the motion (a step is a step), and float and double, which no kernel uses.\n"
            print "| kernel | family | bits | error | Cortex-M0 | Cortex-M3 | RP2040 cycles | RP2040 |"
            print "|---|---|--:|--:|--:|--:|--:|--:|"
            for (i = 1; i <= n; i++) printf "%s", rows[order[i]]
        }' "$2/lattice.tsv" "$2/solids-bits.tsv" "$2/boards.tsv" >"$2/boards.md"
    exit
fi

bare=$1/emu/bare
out=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
programs='count count_solids count_solids_22 count_solids_18 count_solids_16 count_solids_14'

# A Cortex-M0's instructions are run as they are by a Cortex-M3 that has the memory for 40 x 40 points: no instruction of it counts
# differently there.
for program in $programs; do
    for core in m0an m3; do
        timeout 600 qemu-system-arm -M mps2-an385 -display none -monitor none -serial none -semihosting-config enable=on,target=native \
            -plugin "$bare/counter.so,out=$work/$program-$core.marks" -kernel "$bare/$program-$core.elf" >"$work/$program-$core.lines" 2>&1
    done
    mark=$(${CROSS:-arm-none-eabi-}nm "$bare/$program-rp2040.elf" | awk '$3 == "bare_mark" { print $1 }')
    EMU_MODULES=$1/emu timeout 900 node tests/emu/bare/bare_rp2040.mjs "$bare/$program-rp2040.bin" "$mark" "$work/$program-rp2040.marks" \
        >"$work/$program-rp2040.lines"
done
for core in m0an m3 rp2040; do
    for program in $programs; do
        cat "$work/$program-$core.lines" >>"$work/$core.lines"
        awk 'NR % 2 { before = $1; next } { print $1 - before }' "$work/$program-$core.marks" >>"$work/$core.spent"
    done
done
cmp "$work/m0an.lines" "$work/m3.lines" && cmp "$work/m0an.lines" "$work/rp2040.lines" # the same elements everywhere
{
    printf 'what\tof\tbits\telements\tm0_instructions\tm3_instructions\trp2040_cycles\n'
    paste "$work/m0an.lines" "$work/m0an.spent" "$work/m3.spent" "$work/rp2040.spent"
} >"$out/boards.tsv"

awk -F '\t' '/^(perimeter|windows|horizon|convex|area|halo|clip)/ {
    if (!(($1, $2) in first)) { first[$1, $2] = $0; order[++n] = $1 SUBSEP $2 }
    else if ($4 > 0) {
        split(first[$1, $2], f, "\t")
        ratio = $7 / $4 / (f[7] / f[4]) * 100
        if (!(($1, $2) in least) || ratio < least[$1, $2]) least[$1, $2] = ratio
        if (ratio > most[$1, $2]) most[$1, $2] = ratio
    } } END {
    print "\n## Boards: what a facet costs\n"
    print "Instructions (cycles on the RP2040) per facet of the kernel alone, 40 x 40 points (with holes for windows), heights at hand; and per edge"
    print "(convex, halo), face that looks at the eye (area sort) and vertex (clip), of scenes that a Pico has room for. The scenes are the same"
    print "everywhere; so are the pieces and the operations (tests/emu/test_same.sh). As shipped; the last column says what 0, 2, 4 and 8 bits below a"
    print "step would take instead: [every row, beside its error](boards.md).\n"
    print "| kernel | family | bits | Cortex-M0 | Cortex-M3 | RP2040 cycles | RP2040 at 133 MHz | with 0 to 8 bits |"
    print "|---|---|---|--:|--:|--:|--:|--:|"
    for (i = 1; i <= n; i++) {
        split(first[order[i]], f, "\t")
        if (f[4] < 0)
            printf "| %s | %s | %s | does not fit into a Pico | | | | |\n", f[1], f[2], f[3]
        else
            printf "| %s | %s | %s | %.0f | %.0f | %.0f | %.1f us | %.0f to %.0f %% |\n", f[1], f[2], f[3], f[5] / f[4], f[6] / f[4], f[7] / f[4], \
                f[7] / f[4] / 133, least[order[i]], most[order[i]]
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
