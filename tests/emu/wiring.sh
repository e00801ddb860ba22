# wiring.sh - levels turned round, in the board's memory from the first moment on; for the tests of the boards, after lib.sh.
within=${within:-0.8}
scene polarity_set -
turned='x_step y_step pen enable'
again polarity_kept ${switch_us:-$within} 9
says 'ALARM: a limit switch closed'
turned=
# What is at the pen's pin follows its bit within 1 ms; pen.mjs judges it.
pen='solenoid 0.03 40'
[ $board = rp2040 ] || pen="$pen 1000 50" # by the program: 1 kHz, an edge when nothing more urgent goes on
scene solenoid $within
pen=
[ $board = rp2040 ] || return 0
pen='servo 1000 1600 0'
scene servo $within
pen='servo 1900 1200 0.1'
scene servo_glide $within
pen=
