# faults.sh - a program that goes wrong: the machine stops, pen up, motors off; for the tests of the boards, after lib.sh.
alone overrun
says 'fault: the stack has run over'
rests 0.9 0.91
if [ $board = rp2040 ]; then # QEMU's UARTs make no such errors
    alone line_faults
    says '^42.?$'
    says '^5.?$'
    says_times 4 'the line was damaged on its way and was not taken' 'four lines refused'
fi
[ $board = nrf51 ] && return # QEMU has no model of its watchdog
alone hang
[ $board = lm3s6965 ] || rests 8.5 9.2 # QEMU's reset of that chip does not show at its pins
says '<Idle.MPos:.Pen:up>'
says_times 2 'help, help board' 'the watchdog starts it again'
