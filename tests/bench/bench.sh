#!/bin/sh
# bench.sh BUILDDIR - ns per facet of our kernel and program beside gnuplot hidden3d and PLplot plmesh, in one run.
# The whole program writes its drawing (.seg); gnuplot's figure is the CPU time of its process less that of an empty plot.
# Sizes: SIZES="10 60 200" make bench. gnuplot stops at 200 (random: 100), where a plot takes it seconds.
set -e
B=$1
SIZES=${SIZES:-10 20 30 40 50 60 100 200 400 1000 2000}
out=$B/bench/surfaces.txt
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
: >"$out"

"$B/bench/bench_surfaces" $SIZES >>"$out"

if [ -x "$B/bench/plmesh" ]; then
    "$B/bench/plmesh" $SIZES >>"$out" 2>/dev/null || echo "# PLplot failed" >&2
else
    echo "# PLplot's development files are not installed: its column is empty" >&2
fi

scene() { # shape n
    echo "set isosamples $2,$2; set samples $2,$2; set xrange [-2:2]; set yrange [-2:2]; set hidden3d"
    case $1 in
    smooth) echo 'f(x,y)=exp(-x**2-y**2)' ;;
    # Looks random, costs one sine, and is the same to every program.
    random) echo 'f(x,y)=.5+.5*sin(12345.678*x+54321.987*y)' ;;
    # Really random, which makes fewer segments: neighbours of that sine differ by a constant phase.
    rand) echo 'f(x,y)=rand(0)' ;;
    esac
}
facets_ns() { awk -v t="$1" -v n="$2" 'BEGIN { printf "%.1f", t * 1e9 / ((n - 1) * (n - 1)) }'; }

# Least CPU time of our program with its drawing written. A plot takes milliseconds, as little as the others' noise.
whole() { # shape n
    [ -x "$B/host/ridgeline" ] || return 0
    { scene "$1" "$2"; echo 'set view from 6,8,3'; } >"$tmp/whole.gp"
    if [ "$1" = data ]; then
        [ "$2" -le 1000 ] || return 0 # the file of a larger one takes longer to make than all of this
        "$B/bench/heights" "$2" >"$tmp/heights.dat"
        echo "splot '$tmp/heights.dat' with lines" >>"$tmp/whole.gp"
    else
        echo 'splot f(x,y) with lines' >>"$tmp/whole.gp"
    fi
    t=$("$B/bench/cpu_time" $(($2 < 400 ? 20 : $2 < 2000 ? 10 : 2)) "$B/host/ridgeline" plot "$tmp/whole.gp" -o "$tmp/whole.seg") &&
        echo "whole $1 $2 $(facets_ns "$t" "$2")" >>"$out"
}

for n in $SIZES; do
    whole rand "$n"
    whole data "$n"
done
for shape in smooth random; do
    for n in $SIZES; do
        repeat=3
        [ "$n" -ge 100 ] && repeat=1
        whole $shape "$n"
        most=200 # where a smooth plot takes gnuplot a second; on random heights it is four times slower at half the size
        [ $shape = random ] && most=100
        if [ "$n" -le $most ] && command -v gnuplot >/dev/null; then
            { echo 'set term dumb'; scene $shape "$n"; echo 'splot f(x,y) with lines'; } >"$tmp/full.gp"
            { echo 'set term dumb'; scene $shape 2; echo 'splot 0 with lines'; } >"$tmp/empty.gp"
            t=$("$B/bench/cpu_time" $repeat gnuplot "$tmp/full.gp" 2>/dev/null)
            e=$("$B/bench/cpu_time" 3 gnuplot "$tmp/empty.gp" 2>/dev/null)
            t=$(awk -v a="$t" -v b="$e" 'BEGIN { d = a - b; print (d > 0 ? d : 0) }')
            echo "gnuplot $shape $n $(facets_ns "$t" "$n")" >>"$out"
        fi
    done
done
command -v gnuplot >/dev/null || echo "# gnuplot is not installed: its column is empty" >&2

awk -v sizes="$SIZES" '
    { v[$1, $2, $3] = $4; if ($1 == "kernel") { pieces[$2, $3] = $5; bytes[$2, $3] = $6 } }
    function cell(who, shape, n) { return (who, shape, n) in v ? sprintf("%.0f", v[who, shape, n]) : "-" }
    function wide(c) { return who[c] == "kernel" || who[c] == "whole" ? 7 : 9 }
    function bar(c) { return c == 1 || who[c] != who[c - 1] ? " |" : " " }
    # slope of log(time) against log(facets), sizes of 60 and more, by least squares
    function growth(who, shape,   i, k, x, y, sx, sy, sxx, sxy) {
        k = sx = sy = sxx = sxy = 0
        for (i = 1; i <= count; i++) if (size[i] >= 60 && (who, shape, size[i]) in v && v[who, shape, size[i]] > 0) {
            x = 2 * log(size[i] - 1); y = x + log(v[who, shape, size[i]])
            k++; sx += x; sy += y; sxx += x * x; sxy += x * y
        }
        return k > 1 ? sprintf("%.2f", (k * sxy - sx * sy) / (k * sxx - sx * sx)) : "-"
    }
    END {
        count = split(sizes, size, " ")
        # who, which shape, and how wide
        columns = split("kernel.smooth kernel.random whole.smooth whole.random whole.rand whole.data plmesh.smooth plmesh.random " \
                        "gnuplot.smooth gnuplot.random", column, " ")
        for (c = 1; c <= columns; c++) { split(column[c], part, "."); who[c] = part[1]; shape[c] = part[2] }
        print "Surfaces from (6,8,3), ns of CPU time per facet"
        printf "%6s |%15s |%31s |%19s |%19s |%17s\n", "", "our kernel alone", "our program + .seg", "PLplot plmesh alone",
               "gnuplot hidden3d", "our memory (KB)"
        line = sprintf("%6s", "n")
        for (c = 1; c <= columns; c++) line = line bar(c) sprintf("%*s", wide(c), shape[c] == "rand" ? "rand(0)" : shape[c])
        printf "%s |%8s %8s\n", line, "smooth", "random"
        for (i = 1; i <= count; i++) {
            n = size[i]
            line = sprintf("%6d", n)
            for (c = 1; c <= columns; c++) line = line bar(c) sprintf("%*s", wide(c), cell(who[c], shape[c], n))
            printf "%s |%8.1f %8.1f\n", line, bytes["smooth", n] / 1024, bytes["random", n] / 1024
        }
        line = "growth"
        for (c = 1; c <= columns; c++) line = line bar(c) sprintf("%*s", wide(c), growth(who[c], shape[c]))
        print line " |  exponent of the time over facets, n >= 60"
        print "random: .5+.5*sin(12345.678*x+54321.987*y); data: uniform random heights from a file of lines x y z"
    }' "$out"
