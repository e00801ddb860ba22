#!/bin/sh
# test_nrf51.sh - the image of the micro:bit against the simulator: its pins within 2 us, and its console. Switches have no
# interrupt in QEMU's model of the chip and are looked at by the main loop, so what they do comes some us late.
board=nrf51
. tests/emu/lib.sh
for s in small smooth perspective corexy horizon rand sinc status data cubes typed halo; do scene $s 2; done
for s in smooth60 rand60; do scene $s '2 rests'; done
scene help -
scene holes 2
scene halo_ends 2
scene cubes_many 2
says 'The scene does not fit: it may need [0-9]* bytes of memory, N are free. Nothing was drawn.'
scene data_many -
says 'the rows alone take 5[0-9]* bytes of memory, N are free'
says 'nothing was plotted yet'
scene halo_many 2
says '18 lines with [0-9]+ crossings may need [0-9]+ bytes of memory, N are free. Nothing was drawn.'
scene accel 2
says 'accel too high for this board at these steps per mm; most mm/s.2 .600.'
scene rate 2 # as fast as `set machine` lets it
switch_us=100
. tests/emu/behave.sh
. tests/emu/power.sh
. tests/emu/wiring.sh
. tests/emu/faults.sh
. tests/emu/typed.sh
finish
