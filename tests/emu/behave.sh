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
# How many steps each motor takes between its changes of direction.
legs() { # VCD
    awk '/^\$var/ { name[$4] = $5 } /^\$end$/ { begun = 1 } !begun || !/^[01]/ { next }
        { pin = name[substr($0, 2)]; m = substr(pin, 1, 1); up = /^1/ }
        pin ~ /_dir/ { if (n[m]) print m, forward[m] ? n[m] : -n[m]; n[m] = 0; forward[m] = up }
        pin ~ /_step/ && up { n[m]++ }
        END { for (m in n) print m, forward[m] ? n[m] : -n[m] }' "$1" | sort -s -k1,1
}
if [ $board = nrf51 ]; then # it plans each leg for some ms, so a switch is met some steps sooner or later: its legs are those of the simulator within 30 steps
    scene homing - 9
    legs "$work/sim.vcd" >"$work/legs"
    if legs "$work/emu.vcd" | paste "$work/legs" - | awk '{ d = $2 - $4; if ($1 != $3 || d > 30 || d < -30) bad = 1; said = said " " $1 $4 }
        END { print "# nrf51 homing: legs in steps:" said; exit bad || NR < 6 }'; then
        echo '[       OK ] nrf51 homing: the legs of the simulator'
    else
        bad 'homing: other legs than the simulator'
        legs "$work/emu.vcd" | paste "$work/legs" -
    fi
else
    scene homing $within 9
fi
says '^home'
says '<Idle.MPos'
