#!/bin/sh
# test_large.sh - the Pico's largest scenes, drawn to the end by its program with its memory, on the simulator: that they
# fit, and that nothing is late. In its emulator they take an hour (make bench-mcu-large).
ridgeline=${RIDGELINE:-build/host/ridgeline}
build=${BUILDDIR:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
failed=0
motion="--speed 200 --travel 200 --accel 5000 --lift 0.01 --lower 0.01"

large() { # name, n, function
    {
        echo "20000 type set isosamples $2; set view from 6,8,3\\r"
        echo '200000 type set xrange [-2:2]; set yrange [-2:2]\r'
        echo '400000 type set paper 40,30 margin 2\r'
        echo "600000 type set machine speed 200 travel 200 accel 5000 lift 0.01 lower 0.01\\r"
        echo "2000000 type splot $3\\r"
        echo '+2000000 type memory\r'
    } >"$work/large.stim"
    if "$build/emu/sim-rp2040" "$work/large.stim" "$work/large.vcd" "$work/large.txt" 1 &&
        "$ridgeline" trace "$work/large.vcd" $motion >"$work/trace.txt" &&
        grep -q 'end position *0 0 steps: home' "$work/trace.txt" &&
        grep -q 'pen at the end *up' "$work/trace.txt" && grep -q 'late deadlines: 0' "$work/large.txt"; then
        sed -n "s/.*: \([0-9]*\) events.*/# Pico, $1 $2x$2: \1 pin changes/p" "$work/trace.txt"
        sed -n 's/^picture: /#     /p' "$work/large.txt" | tr -d '\r'
        echo "[       OK ] $1 $2x$2"
    else
        cat "$work/large.txt" "$work/trace.txt"
        echo "[  FAILED  ] $1 $2x$2"
        failed=1
    fi
}
large smooth 1000 'exp(-x**2-y**2)'
large random 400 'rand(0)'
exit $failed
