#!/bin/sh
# test_rp2040.sh - the image of rp2040 against the simulator: its pins within 0.8 of the 1 us it has, and its console.
board=rp2040
. tests/emu/lib.sh
for s in smooth perspective corexy horizon rand sinc status data cubes halo shadow shaded glass smooth60 rand60; do scene $s 0.8; done
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
finish
