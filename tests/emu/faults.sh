# faults.sh - a program that goes wrong: the machine stops, pen up, motors off; for the tests of the boards, after lib.sh.
# How often the watchdog was fed, after it was set up and started; "wrong" if it was not so.
watchdog_fed() {
    sed -n 's/.*write (size 4, offset 0x000\(1....\), value \(.*\))/\1 \2/p' "$work/emu.log" | awk '
        BEGIN { want[1] = "10504 0x00040000"; want[2] = "10508 0x00000001"; want[3] = "10000 0x00000001" }
        $0 != (NR in want ? want[NR] : "10600 0x6e524635") { wrong = 1 }
        END { print (NR > 3 && !wrong ? NR - 3 : "wrong") }'
}
alone overrun
says 'fault: the stack has run over'
rests 0.9 0.91
if [ $board = rp2040 ]; then # QEMU's UARTs make no such errors
    alone line_faults
    says '^42.?$'
    says '^5.?$'
    says_times 4 'the line was damaged on its way and was not taken' 'four lines refused'
    alone data_faults
    says_times 3 'the line was damaged on its way and was not taken; the rows before it were. Send it again' 'three rows refused'
    "$build/emu/sim-$board" tests/emu/scenes/data.stim "$work/sim.vcd" "$work/sim.txt" 1
    if "$ridgeline" trace "$work/sim.vcd" "$work/emu.vcd" >"$work/difference" && grep -q '^same sequence' "$work/difference"; then
        echo "[       OK ] $board data_faults: the drawing is that of the undamaged rows"
    else
        bad 'data_faults: another drawing'
        head -3 "$work/difference"
    fi
fi
if [ $board = nrf51 ]; then # QEMU has no model of its watchdog, but says what is written to it
    qemu_more='-d guest_errors,unimp'
    alone hang
    before=$(watchdog_fed)
    alone hang_longer
    after=$(watchdog_fed)
    qemu_more=
    if [ "$before" = "$after" ] && [ "$before" != wrong ]; then
        echo "[       OK ] nrf51 hang: 8 s of 32,768 Hz are set, channel 0, started; $before reloads, none by interrupts in the 4 s after the main loop hangs"
    else
        bad "hang: the watchdog was fed $before, then $after times"
    fi
    return
fi
alone hang
[ $board = lm3s6965 ] || rests 8.5 9.2 # QEMU's reset of that chip does not show at its pins
says '<Idle.MPos:.Pen:up>'
says_times 2 'help, help board' 'the watchdog starts it again'
