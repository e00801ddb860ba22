#!/bin/sh
# report.sh BUILDDIR OUT [SECTION] - runs the programs of the report and puts their sections together into OUT/README.md;
# or only that of SECTION, in place of what it wrote there before.
# Files that end in -times.tsv, and the columns of ns in the tables, differ from run to run; nothing else does.
set -e
bin=$1/report
out=$2
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
mkdir -p "$out"

# Solids on coarser lattices, haloes and the clipper on coarser pages (tools/solid_bits.c).
solid_bits() {
    printf 'kernel\tfamily\tbits\tscenes\twrong\tmissing_steps\tfalse_steps\tend_steps\tbytes\n' >"$out/solids-bits.tsv"
    printf 'kernel\tfamily\tbits\tns_per_element\n' >"$out/solids-bits-times.tsv"
    printf '\n## Bits of the lattices of solids, haloes and polygons\n\n'
    echo 'Bits below a step of A4. For the convex kernel and the area sort the lattice of the scene is coarser, for haloes and the clipper'
    echo 'that of the page. The references get the scene as it was; the ends of edges that the lattice moves count as ends. Clipper: area'
    printf 'over the length of the borders.\n\n'
    printf '| kernel | family | bits | scenes (beyond a step) | missing | false | end | bytes | ns per element |\n|---|---|--:|--:|--:|--:|--:|--:|--:|\n'
    for b in 28 22 18 16 14; do "$bin/solid_bits_$b"; done >"$tmp/solid-bits"
    awk -F '\t' -v OFS='\t' -v tsv="$out/solids-bits.tsv" -v times="$out/solids-bits-times.tsv" '
        { key = $1 "\t" $2; if (!(key in rows)) order[++n] = key; rows[key] = rows[key] $0 "\n"
          b = $3 + 0; off = $6 > $7 ? $6 : $7; if ($1 == "convex" || $1 == "area") { if (off > worst[b]) worst[b] = off }
          else if ($1 == "halo" && off > halo[b]) halo[b] = off }
        END {
            for (k = 1; k <= n; k++) for (m = split(rows[order[k]], line, "\n"); m > 1; m--) {
                split(line[m - 1], f, "\t"); bits = f[3]; shipped = sub("s$", "", bits) ? " (shipped)" : ""
                print f[1], f[2], bits, f[4], f[5], f[6], f[7], f[8], f[9] >>tsv
                print f[1], f[2], bits, f[10] >>times
                printf "| %s | %s | %s%s | %s (%s) | %s | %s | %s | %s | %s |\n", f[1], f[2], bits, shipped, f[4], f[5], f[6], f[7], f[8], f[9], f[10]
            }
            printf "\n**Shipped: 14 bits below a step for solids**, what 32-bit differences with products of 64 and determinants of 126 bits take,\n"
            printf "and 8.7 for haloes and polygons, those of the page. Fewer are no faster and take no less memory: a word is a word. With 8 bits\n"
            printf "solids are still right to %.3f steps; with 4 the longest wrong run has %.1f steps and with none %.0f: planes count as touching\n", worst[8], worst[4], worst[0]
            printf "within 4 units (SOLID_FLAT), which are then steps. A halo loses or wins a gap where edges no longer pass as they did: %.2f steps\n", halo[8]
            printf "with 8 bits, %.0f with 4.\n", halo[4]
        }' "$tmp/solid-bits"
}

# The section of a program, between marks by which it is found again.
section() {
    [ "$1" = bits ] || [ -x "$bin/report_$1" ] || return 0
    echo
    echo "<!-- $1 -->"
    if [ "$1" = bits ]; then solid_bits; else "$bin/report_$1" "$out"; fi
    echo "<!-- /$1 -->"
}
if [ -n "$3" ]; then
    grep -q "^<!-- /$3 -->" "$out/README.md" || { echo "report.sh: $out/README.md has no section $3" >&2; exit 1; }
    section "$3" >"$tmp/section"
    awk -v from="<!-- $3 -->" -v to="<!-- /$3 -->" -v file="$tmp/section" '
        $0 == from { skip = 1; getline line <file; while ((getline line <file) > 0) print line }
        !skip { print }
        $0 == to { skip = 0 }' "$out/README.md" >"$tmp/README.md"
    mv "$tmp/README.md" "$out/README.md"
    echo "$out/README.md"
    exit
fi

# Instructions of the kernel alone, counted by callgrind. Skipped where valgrind is not installed.
costs() {
    command -v valgrind >/dev/null || return 0
    printf 'kernel\tfamily\tn\tbits\tfacets\tinstructions_per_facet\n' >"$out/instructions.tsv"
    printf '\n## Instructions per facet\n\nx86-64 instructions of the kernel, counted by callgrind (60 x 60 points).\n\n'
    printf '| kernel | family | bits | instructions per facet |\n|---|---|--:|--:|\n'
    for kernel in perimeter windows horizon; do
        for family in smooth random cliffs grazing far; do
            bits=15
            [ $kernel$family = perimeterrandom ] && bits="0 4 8 15"
            for b in $bits; do
                facets=$(valgrind --tool=callgrind --callgrind-out-file="$tmp/cg" --toggle-collect=perimeter_draw \
                    --toggle-collect=horizon_draw "$bin/report_error" --cost $kernel $family 60 "$b" 2>"$tmp/log")
                sum=$(sed -n 's/.*Collected : //p' "$tmp/log")
                per=$(awk -v s="$sum" -v f="$facets" 'BEGIN { printf "%.0f", s / f }')
                printf '%s\t%s\t60\t%s\t%s\t%s\n' $kernel $family "$b" "$facets" "$per" >>"$out/instructions.tsv"
                echo "| $kernel | $family | $b | $per |"
            done
        done
    done
    echo
    echo "The bits of the lattice change the count only by what else is drawn. For comparison, from a count made once apart"
    echo "from this report, per extra facet and smooth / random: PLplot's plmesh 4,099 / 3,531, NCAR's SRFACE 3,760 / 2,697,"
    echo "gnuplot's hidden3d 23,900 / 40,700."
}

{ section hard && section hard_solids && section clipper && section lights; } >"$tmp/hard" && sh tests/report/boards.sh "$1" "$out" >"$tmp/boards" &
beside=$!
{
    echo '# The numbers report'
    echo
    echo 'Written by `make report`. Seeds are fixed: the same commit gives the same numbers, times aside.'
    printf 'Versions: %s; %s; %s;\n' "$(${CC:-gcc} --version | head -1)" "$(uname -sm)" "$(valgrind --version 2>/dev/null || echo no valgrind)"
    printf '%s;\n' "$(${CROSS:-arm-none-eabi-}gcc --version | head -1)"
    printf '%s; node %s; rp2040js %s.\n' "$(qemu-system-arm --version | head -1)" "$(node --version)" \
        "$(sed -n 's/.*"rp2040js": "\(.*\)".*/\1/p' tests/emu/package.json)"
    echo 'A step is 0.0125 mm on A4. Errors are told by `tests/oracle/judge.h`, against an exact reference: ink is missing'
    echo 'where a line is visible, also when moved by one step, and not drawn; false where it is drawn and hidden, also then.'
    echo 'Every table is there as `.tsv`, too.'
    cat <<'END'

What Ridgeline's arithmetic is worth: how far its drawings are from exact ones, and what that costs.

- [What is shipped, and why](#what-is-shipped-and-why), kernel by kernel, with plots of error against time: the summary of all that follows.
- What is varied: [bits of the lattice](#bits-of-the-lattice), those [of solids, haloes and polygons](#bits-of-the-lattices-of-solids-haloes-and-polygons),
  [sizes](#sizes-as-shipped), [tolerances of horizons](#simpler-horizons), [formats of expressions](#formats-of-expressions);
  [on the boards](#boards-what-a-facet-costs), with every row [there](boards.md).
- [Hard surfaces](hard.md) and [hard solids and haloes](hard-solids.md), each with its picture, its error, and a naive drawing beside it,
  [hard pairs of polygons](hard-clipper.md) with what each operation gives of them, [hard lights](hard-lights.md) beside rays;
  what is not exact and with what bound is [here](#hard-cases) and [here](#hard-cases-of-solids-and-haloes).
- [Only what a scene needs](#only-what-a-scene-needs): memory and operations beside those of a method that models everything.
- The papers' experiments: [Anderson](#andersons-table-1-and-figure-11) and [his open question](#his-open-question),
  [Greenspun and Little](#greenspun-and-littles-horizon), [Weiler and Atherton](#how-the-work-of-the-area-sort-grows).

END
    "$bin/report_error" "$out"
    "$bin/report_simplify" "$out"
    costs
    wait $beside # begun above, beside the others: they have no times
    cat "$tmp/boards"
    section formats
    cat "$tmp/hard"
    for s in needs papers solids growth bits; do section $s; done
    sh tests/report/boards.sh --errors "$out"
    section pareto
    echo
    echo '![error over bits and families](landscape.svg)'
    echo
    echo "Drawn by Ridgeline from its own report: the perimeter's longest missing or false run, a power of ten for each unit"
    echo 'of height, over bits below a step (from the left: 0, 2, 4, 6, 8, 12, 15) and families of scenes.'
} >"$tmp/README.md"
"$1/host/ridgeline" plot tests/report/figure1.gp -o "$out/figure1.svg"
# One row a family, one column a number of bits: powers of ten of the worst run, down to a thousandth of a step.
awk -F '\t' '$1 == "perimeter" { worst = $7 > $8 ? $7 : $8; z = log(worst > .001 ? worst : .001) / log(10)
    if (!($2 in row)) order[++rows] = $2
    row[$2] = row[$2] " " sprintf("%.3f", z) }
    END { for (i = 1; i <= rows; i++) print row[order[i]] }' "$out/lattice.tsv" >"$tmp/landscape.dat"
printf 'set view 60,50\nsplot "%s" matrix with lines\n' "$tmp/landscape.dat" >"$tmp/landscape.gp"
"$1/host/ridgeline" plot "$tmp/landscape.gp" -o "$out/landscape.svg"
mv "$tmp/README.md" "$out/README.md"
echo "$out/README.md"
