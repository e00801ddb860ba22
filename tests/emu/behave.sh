# behave.sh - what a machine does when it is disturbed; for the tests of the boards, after lib.sh. switch_us: how late what a
# switch does may be.
within=0.8
[ $board = nrf51 ] && within=2
scene refused $within
says '^The paper reaches beyond the machine'
scene hold $within
says '^<Run.MPos:.*Pen:down'
scene stop $within 9
says '<Idle.MPos'
scene limit ${switch_us:-$within} 9
says 'ALARM: a limit switch closed; position unknown'
says '^Locked: the position is unknown'
says '<Alarm'
scene estop ${switch_us:-$within} 9
says 'ALARM: emergency stop, motors off; position unknown'
says '^unlocked'
scene bad_input $within
says 'line is too long and was not taken'
[ $board = nrf51 ] && return # its legs begin some ms after the simulator's: it takes that long to plan one
scene homing $within 9
says '^home'
says '<Idle.MPos'
