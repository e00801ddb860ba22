#!/bin/sh
# test_rp2040.sh - the image of rp2040 against the simulator: its pins within 0.8 of the 1 us it has, and its console.
board=rp2040
. tests/emu/lib.sh
for s in smooth perspective corexy horizon rand sinc status data cubes typed halo shadow shaded glass polygons smooth60 rand60; do scene $s 0.8; done
scene rate 0.8 # as fast as `set machine` lets it
probe="$PWD/tests/emu/ram_probe.mjs $build/firmware/rp2040.elf"
. tests/emu/behave.sh
probe=
. tests/emu/power.sh
. tests/emu/wiring.sh
. tests/emu/faults.sh
. tests/emu/typed.sh
finish
