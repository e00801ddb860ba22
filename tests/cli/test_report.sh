#!/bin/sh
# The numbers report in small: its programs run, write what they promise, and what is shipped is right.
. tests/cli/lib.sh
build=$(dirname "$RIDGELINE")/..

errors_by_bits_and_sizes() {
    "$build/report/report_error" . --quick >section.md
    for f in lattice.tsv lattice-times.tsv sizes.tsv lattice.svg sizes.svg; do [ -s $f ]; done
    # Nobody is off by more than a step as shipped, everybody with no bits below it.
    awk -F '\t' 'NR > 1 && $4 == 15 && ($5 > 1 || $6 > 1 || $9 > .25 || $5 == "failed") { print; bad = 1 }
        NR > 1 && $4 == 0 && $9 > .25 { coarse[$1] = 1 }
        END { for (k in coarse) n++; exit bad || n != 3 }' lattice.tsv
    expect_text section.md '| perimeter | 15 (shipped) |'
}

solids_haloes_polygons() {
    "$build/report/report_solids" . --quick >section.md
    # Each kernel is there and within its limits.
    awk -F '\t' 'NR > 1 { kernels[$1] = 1 }
        NR > 1 && ($6 > 0 || $7 == 0 || $8 > 1 || $9 > 1 || $10 > .25) { print; bad = 1 }
        END { for (k in kernels) n++; exit bad || n != 4 }' solids.tsv
    expect_text section.md '| clip | spiky | 100 |'
}

bits_of_solids_haloes_polygons() {
    # What is shipped is right in all families; on a page without bits below a step haloes and polygons are not.
    "$build/report/solid_bits_28" >bits.tsv
    awk -F '\t' '{ off = $6 > $7 ? $6 : $7 }
        $3 ~ /s$/ { families[$1 $2] = 1; if ($5 > 0 || off > .1 || $8 > .25) { print; bad = 1 }; fine[$1 $2] = off }
        $3 == "0" { if (off <= 10 * fine[$1 $2]) { print; bad = 1 }; coarse++ }
        END { for (k in families) n++; exit bad || n != 12 || coarse != 4 }' bits.tsv
}

the_same_numbers_twice() {
    for k in a b; do
        mkdir $k
        "$build/report/report_error" $k --quick >$k/README.md
        "$build/report/report_solids" $k --quick >>$k/README.md
    done
    sh "$root/tests/report/twice.sh" a b >same
    # And a number that is none of a time is not overlooked.
    sed -i 's/^| perimeter | 15 (shipped) | 0/| perimeter | 15 (shipped) | 9/' b/README.md
    ! sh "$root/tests/report/twice.sh" a b >differs
}

run_tests the_same_numbers_twice errors_by_bits_and_sizes solids_haloes_polygons bits_of_solids_haloes_polygons
