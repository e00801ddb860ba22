#!/bin/sh
# test_lm3s6965.sh - the image of lm3s6965: its pins against the simulator's.
board=lm3s6965
. tests/emu/lib.sh
for s in smooth perspective corexy horizon rand cubes halo; do scene $s 1; done
finish
