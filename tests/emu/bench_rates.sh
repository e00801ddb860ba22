#!/bin/sh
# bench_rates.sh BUILDDIR [BOARD...] - the highest rate of steps on both motors at once whose edges all leave when the
# simulator's do, within 1 us (2 us on the Cortex-M0): images that refuse no speed draw lines at 44 degrees, 400 steps a
# mm, faster and faster, until they are not in time.
BUILDDIR=$1
export BUILDDIR
shift
. tests/emu/lib.sh

# board, us allowed, first rate, step, pulse in us, mm of paper
search() {
    board=$1 rate=$3 best=none
    while [ "$rate" -lt 2000000 ]; do
        awk -v r="$rate" -v pulse="$5" -v mm="$6" 'BEGIN {
            v = r / 400 * 1.41 # mm/s; a quarter of a line is for speeding up
            printf "20000 type set machine speed 5 travel 5 steps 400 pulse %s setup %s accel %d\\r\n", pulse, pulse, v * v / (mm - 10) * 2
            printf "200000 type set paper %d,%d margin 5; set isosamples 2; set view 0,44\\r\n", mm, mm
            printf "400000 type set machine lift 0.05 lower 0.05 speed %.1f travel %.1f\\r\n600000 type splot x+y\\r\n", v, v }' >"$work/rate.stim"
        rm -rf "$work"/emu.* "$work"/keep
        mkdir -p "$work/keep"
        "$build/emu/sim-$board" "$work/rate.stim" "$work/sim.vcd" "$work/sim.txt" 1 && "run_$board" "$work/rate.stim" 1 ||
            { cat "$work/emu.err"; return 1; }
        said=$("$ridgeline" trace "$work/sim.vcd" "$work/emu.vcd" | head -1)
        if grep -q '\^' "$work/sim.txt"; then
            printf '%-10s %8d   the machine is refused: %s\n' "$board" "$rate" "$(grep -A1 '\^' "$work/sim.txt" | tail -1)"
            break
        fi
        us=$(printf '%s\n' "$said" | sed -n 's/^same sequence.* difference \([0-9.]*\) us at most.*/\1/p')
        printf '%-10s %8d   %9.2f us, %d pin changes\n' "$board" "$rate" "${us:-999999}" "$(grep -c '^[01]' "$work/sim.vcd")"
        awk -v us="${us:-999999}" -v most="$2" 'BEGIN { exit !(us <= most) }' || break
        best=$rate
        rate=$((rate + $4))
    done
    printf '%-10s highest rate in time, within %s us: %s steps/s on each of two motors\n\n' "$board" "$2" "$best"
}

printf '%-10s %8s   %s\n' board steps/s 'worst edge against the simulator'
for b in "${@:-nrf51 lm3s6965 rp2040}"; do
    for b in $b; do
        case $b in
        nrf51) search nrf51 2 18000 500 10 40 ;;
        lm3s6965) search lm3s6965 1 50000 4000 2 40 ;;
        rp2040) search rp2040 1 200000 50000 0.25 60 ;;
        esac
    done
done
