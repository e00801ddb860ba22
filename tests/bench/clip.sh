#!/bin/sh
# Intersections of stars with holes by our clipper and by the libraries that are installed, as one table.
# usage: clip.sh BUILDDIR
B=$1
for peer in clipper1 boost_clip; do
    [ -x "$B/bench/$peer" ] || echo "# $peer is not installed: its column is empty" >&2
done
{
    "$B/bench/bench_clip"
    for peer in clipper1 boost_clip; do [ -x "$B/bench/$peer" ] && "$B/bench/$peer"; done
} | awk '
    { ms[$1, $2, $3] = $4; area[$1, $2, $3] = $5; if ($1 == "ridgeline") key[++keys] = $2 SUBSEP $3 }
    # an area that is off by more than rounding is a wrong result
    function cell(who, k,   d) {
        if (!((who, k) in ms)) return sprintf("%12s", "-")
        d = area[who, k] - area["ridgeline", k]
        return sprintf("%10.4f%-2s", ms[who, k], d * d > 1e-12 * area["ridgeline", k] ^ 2 ? " *" : "")
    }
    END {
        print "Intersection of two stars with holes of n vertices each, ms of CPU time"
        printf "%6s %6s %10s   %10s   %10s\n", "", "n", "ours", "Clipper 6", "Boost"
        for (i = 1; i <= keys; i++) {
            split(key[i], part, SUBSEP)
            printf "%6s %6d %s %s %s\n", part[1], part[2], cell("ridgeline", key[i]), cell("clipper1", key[i]), cell("boost", key[i])
        }
        print "(* the area of the result differs by more than a millionth)"
    }'
