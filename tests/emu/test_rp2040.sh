#!/bin/sh
# test_rp2040.sh - the image of rp2040 against the simulator: its pins within 0.8 of the 1 us it has, and its console.
board=rp2040
. tests/emu/lib.sh
for s in smooth perspective corexy horizon rand sinc status data cubes typed halo shadow shaded glass smooth60 rand60; do scene $s 0.8; done
scene rate 0.8 # as fast as `set machine` lets it
probe="$PWD/tests/emu/ram_probe.mjs $build/firmware/rp2040.elf"
. tests/emu/behave.sh
probe=
. tests/emu/power.sh
. tests/emu/wiring.sh
. tests/emu/faults.sh
# The board at a terminal (make try-pico), its lines from a pipe.
name=try-pico
printf 'set paper 40,40 margin 5; set isosamples 5\nsplot x*y\nprint 6*7\n' |
    EMU_MODULES=$build/emu timeout 100 node tests/emu/try.mjs "$build/firmware/rp2040.bin" "$work/try.svg" "$work/try.flash" >"$work/emu.said" 2>&1
says '^.5 strokes in [0-9.]+ s of the machine'
says '^42'
# Rows of inline data without a pause, in two drawings, five times what the board keeps: the sender heeds XON/XOFF, nothing is lost.
name=flow
awk 'BEGIN { print "set paper 40,40 margin 5; set machine speed 200 travel 200 accel 5000 lift 0.01 lower 0.01"
    for (k = 0; k < 2; k++) {
        print "splot \x27-\x27"
        for (y = 0; y < 8; y++) { for (x = 0; x < 15; x++) print x, y, (x * y * (k + 1)) % 7; print "" }
        print "e" }
    print "memory\nprint 6*7" }' |
    EMU_MODULES=$build/emu timeout 200 node tests/emu/try.mjs "$build/firmware/rp2040.bin" "$work/try.svg" "$work/try.flash" >"$work/emu.said" 2>&1
says_times 2 '^.[0-9]* strokes in' 'two drawings of 120 rows'
says '^42'
if grep -aqE 'error|warning|^line [0-9]' "$work/emu.said"; then bad "flow: something was lost"; fi
finish
