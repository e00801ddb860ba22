#!/bin/sh
# test_nrf51.sh - the image of the micro:bit: its pins against the simulator's.
board=nrf51
. tests/emu/lib.sh
for s in small; do scene $s 2; done
finish
