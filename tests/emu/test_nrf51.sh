#!/bin/sh
# test_nrf51.sh - the image of the micro:bit against the simulator: its pins within 2 us, and its console. Switches have no
# interrupt in QEMU's model of the chip and are looked at by the main loop, so what they do comes some us late.
board=nrf51
. tests/emu/lib.sh
for s in small smooth perspective corexy horizon rand status data; do scene $s 2; done
switch_us=100
. tests/emu/behave.sh
. tests/emu/power.sh
finish
