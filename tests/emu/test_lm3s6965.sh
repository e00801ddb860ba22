#!/bin/sh
# test_lm3s6965.sh - the image of lm3s6965 against the simulator: its pins within 0.8 us, at its highest rate within 1 us, and its console.
# Its flash controller, which QEMU lacks, is scope_flash.c.
board=lm3s6965
. tests/emu/lib.sh
for s in smooth perspective corexy horizon rand sinc status data cubes typed halo smooth60; do scene $s 0.8; done
scene help -
scene rand60 0.8
scene rate 1 # as fast as `set machine` lets it
. tests/emu/behave.sh
. tests/emu/power.sh
. tests/emu/wiring.sh
. tests/emu/faults.sh
. tests/emu/typed.sh
finish
