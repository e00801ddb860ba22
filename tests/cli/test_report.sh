#!/bin/sh
# The numbers report in small: its programs run, write what they promise, and what is shipped is right.
. tests/cli/lib.sh
build=$(dirname "$RIDGELINE")/..

errors_by_bits_and_sizes() {
    "$build/report/report_error" . --quick >section.md
    for f in lattice.tsv lattice-times.tsv sizes.tsv lattice.svg pareto.svg sizes.svg; do [ -s $f ]; done
    # Nobody is off by more than a step as shipped, everybody with no bits below it.
    awk -F '\t' 'NR > 1 && $4 == 15 && ($5 > 1 || $6 > 1 || $9 > .25 || $5 == "failed") { print; bad = 1 }
        NR > 1 && $4 == 0 && $9 > .25 { coarse[$1] = 1 }
        END { for (k in coarse) n++; exit bad || n != 3 }' lattice.tsv
    expect_text section.md '| perimeter | 15 (shipped) |'
}

run_tests errors_by_bits_and_sizes
