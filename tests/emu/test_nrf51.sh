#!/bin/sh
# test_nrf51.sh - the image of the micro:bit: its motors make the simulator's steps, and it ends at home, pen up, motors
# off. Single edges are not compared: its interrupt takes longer than the 2 us that would be asked of them.
board=nrf51
. tests/emu/lib.sh
steps() { # what a trace did, without the times
    "$ridgeline" trace "$1" | sed -n -e 's/^ *\([xy] steps *[0-9]*, from [-0-9]* to [-0-9]*\).*/\1/p' -e '/end position\|pen at the end\|motors at end/p'
}
stim=tests/emu/scenes/small.stim
if ! "$build/emu/sim-$board" $stim "$work/sim.vcd" "$work/sim.txt" 1; then
    bad "small: simulator"
elif ! run_nrf51 $stim; then
    bad "small: emulator"
    head -20 "$work/emu.err" "$work/emu.txt"
else
    steps "$work/sim.vcd" >"$work/sim.steps"
    steps "$work/emu.vcd" >"$work/emu.steps"
    if [ -s "$work/sim.steps" ] && diff "$work/sim.steps" "$work/emu.steps"; then
        echo "[       OK ] $board small"
        echo "# $board small: same steps; $("$ridgeline" trace "$work/sim.vcd" "$work/emu.vcd" | head -1)"
    else
        bad "small: other steps"
        cat "$work/emu.txt"
    fi
fi
finish
