# lib.sh - for the tests of the boards: runs an image in its emulator and the same program on the simulator with one
# scene, and compares what the pins did. Prints cmocka's lines.
ridgeline=${RIDGELINE:-build/host/ridgeline}
build=${BUILDDIR:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
failed=0

# What QEMU 7.2 says of every program on these boards, and nothing else, is let pass: it looks for a vector table before one
# is loaded; a timer of its own has no clock yet; the LM3S6965's flash controller, and so the register that times
# it, is not modelled (the program says that settings could not be kept).
quiet() {
    grep -v -e "Invalid read at addr 0x[04], size 4, region '(null)', reason: rejected" \
        -e '^Timer with period zero, disabling' -e '^SSYS: write at bad offset 0x140' "$@"
}

run_lm3s6965() { # stim
    gpio=/machine/unattached/device
    wires= i=0
    for n in x_step x_dir y_step y_dir pen enable; do wires=$wires,pin=$n:${gpio}[9]@$i i=$((i + 1)); done
    i=0
    for n in limit_x limit_y button estop; do wires=$wires,input=$n:${gpio}[12]@$i:low i=$((i + 1)); done
    # 16 ns an instruction: 62 million a second on a 50 MHz chip. No sleeping: see hal_idle of the port.
    run_qemu lm3s6965evb 4 "$1" "$wires"
}

run_nrf51() { # stim
    gpio=/machine/nrf51
    wires=
    for n in x_step@3 x_dir@2 y_step@1 y_dir@18 pen@20 enable@16; do wires=$wires,pin=${n%@*}:$gpio@${n#*@}; done
    for n in limit_x@23 limit_y@22 button@17 estop@21; do wires=$wires,input=${n%@*}:$gpio@${n#*@}:low; done
    run_qemu microbit 6 "$1" "$wires"
}

run_qemu() { # machine, 2^n ns an instruction, stim, wires
    timeout 300 qemu-system-arm -M "$1" -display none -monitor none -serial "file:$work/emu.txt" \
        -icount "shift=$2,align=off,sleep=off" -d guest_errors -D "$work/emu.log" \
        -plugin "$build/emu/scope.so,vcd=$work/emu.vcd,stim=$3,drawings=${drawings:-1}$4" -kernel "$build/firmware/$board.elf" \
        >"$work/emu.said" 2>&1 || return 1
    cat "$work/emu.said" "$work/emu.log" 2>/dev/null | quiet >"$work/emu.err"
    [ ! -s "$work/emu.err" ]
}

run_rp2040() { # stim
    EMU_MODULES=$build/emu timeout 300 node tests/emu/rp2040.mjs "$build/firmware/rp2040.bin" "$1" \
        "$work/emu.vcd" "$work/emu.txt" 1 >"$work/emu.err" 2>&1 && [ ! -s "$work/emu.err" ]
}

scene() { # name, most us that an edge may differ
    stim=tests/emu/scenes/$1.stim
    rm -f "$work"/*
    if ! "$build/emu/sim-$board" "$stim" "$work/sim.vcd" "$work/sim.txt" 1; then
        bad "$1: simulator"
    elif ! "run_$board" "$stim"; then
        bad "$1: emulator"
        head -20 "$work/emu.err" "$work/emu.txt"
    else
        "$ridgeline" trace "$work/sim.vcd" "$work/emu.vcd" >"$work/difference"
        us=$(sed -n '1s/^same sequence.* difference \([0-9.]*\) us at most.*/\1/p' "$work/difference")
        if [ -n "$us" ] && awk "BEGIN { exit !($us <= $2) }"; then
            echo "[       OK ] $board $1"
            echo "# $board $1: $(sed -n '1s/^same sequence: //p' "$work/difference")"
        else
            bad "$1: pins differ"
            cat "$work/difference" "$work/emu.txt"
        fi
    fi
}

bad() {
    echo "$board $*"
    failed=$((failed + 1))
}

finish() {
    [ "$failed" -eq 0 ] && exit 0
    echo "[  FAILED  ] $failed test(s), listed above"
    exit 1
}
