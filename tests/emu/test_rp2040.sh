#!/bin/sh
# test_rp2040.sh - the image of rp2040: its pins against the simulator's.
board=rp2040
. tests/emu/lib.sh
for s in smooth perspective corexy horizon rand cubes halo shadow; do scene $s 1; done
finish
