#!/bin/sh
# The language beside gnuplot's: random expressions and scripts typed to both. `make compare-gnuplot` tries more.
. tests/cli/lib.sh
case ${BUILDDIR:=build} in /*) ;; *) BUILDDIR=$root/$BUILDDIR ;; esac

both_answer_the_same() {
    command -v gnuplot >/dev/null || { echo "# not compared with gnuplot: it is not installed"; return 0; }
    HOME=$PWD "$BUILDDIR/tools/compare_gnuplot" "$RIDGELINE" 20261129 500 120 || {
        [ $? -eq 5 ] && echo "# not compared with gnuplot: no pseudo-terminal can be had here"
    }
}

run_tests both_answer_the_same
