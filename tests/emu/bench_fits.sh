#!/bin/sh
# bench_fits.sh BUILDDIR BOARD... - the largest scenes that a board takes: those that its console, on the simulator with the
# board's memory, does not refuse. Random and smooth grids, and a typed lattice with haloes: a ladder with a brace in each field.
build=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
small='set paper 20,20 margin 1; set view 60,30'
quick='set machine steps 20 speed 200 travel 200 accel 5000 lift 0.001 lower 0.001'
grid() { # expression, n
    printf '20000 type %s\\r\n150000 type %s\\r\n400000 type set isosamples %d; splot %s\\r\n' "$small" "$quick" "$2" "$1"
}
random() { grid 'rand(0)' "$1"; }
smooth() { grid 'exp(-x**2-y**2)' "$1"; }
lattice() { # fields of four struts
    awk -v n="$1" -v small="$small" -v quick="$quick" 'BEGIN {
        printf "20000 type %s\\r\n150000 type %s\\r\n", small, quick
        printf "300000 type set hidden3d halo; splot '"'-'"' solid\\r\n400000 type v 0 0 0\\rv 1 0 0\\r\n"
        for (k = 1; k <= n; k++)
            printf "%d type v 0 %g %d\\rv 1 0 %d\\rl -4 -2\\rl -3 -1\\rl -2 -1\\rl -4 -1\\r\n", 400000 + 100000 * k, k % 2 / 4, k, k
        printf "%d type e\\r\n", 600000 + 100000 * n }'
}
fits() { # board, scene, n
    "$2" "$3" >"$work/stim"
    timeout 120 "$build/emu/sim-$1" "$work/stim" /dev/null "$work/txt" 1 2>/dev/null
    ! grep -aq 'does not fit\|more data than\|exhausted\|more rows' "$work/txt"
}
most() { # board, scene, most that is tried
    lo=2 hi=$3
    while [ $((hi - lo)) -gt 1 ]; do
        n=$(((lo + hi) / 2))
        if fits "$1" "$2" $n; then lo=$n; else hi=$n; fi
    done
    echo $lo
}
for board in "$@"; do
    r=$(most "$board" random 1000) s=$(most "$board" smooth 1000) l=$(most "$board" lattice 600)
    echo "$board: random ${r}x$r, smooth ${s}x$s, lattice of $((4 * l)) struts with haloes"
done
