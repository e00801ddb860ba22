# power.sh - what is kept without power; for the tests of the boards, after lib.sh.
within=0.8
[ $board = nrf51 ] && within=2
scene keep $within 9
says '^saved'
again button $within
says '^> start'
again autorun_on $within 9
again autorun $within
says '^autorun'
scene save_drawing $within 9
says '^saved'
again autorun $within
says '^autorun'

# The power fails while a scene is saved: when, is looked for by halves between a save that has not begun and one that is
# done. Every time what is kept, read by the simulator, is the scene before or the new one; in some of them it was half written.
power_cuts() { # what is counted: us or writes; before a save begins to write, when it is done at the latest, halvings
    name=cut scenes=tests/emu/scenes
    rm -rf "$work/keep"
    mkdir -p "$work/keep"
    "run_$board" $scenes/cut_begin.stim 99 || bad 'cut: emulator'
    cp "$work/keep/emu" "$work/first"
    lo=$2 hi=$3 torn=0
    for _ in $(seq "$4"); do
        after=$(((lo + hi) / 2)) us=10000000
        if [ "$1" = us ]; then us=$after; else cut=$after; fi
        sed "s/+1500000 type @CUT/+$((1500000 + us)) quit/" $scenes/cut_save.stim >"$work/cut.stim"
        cp "$work/first" "$work/keep/emu"
        "run_$board" "$work/cut.stim" 99 || bad 'cut: emulator'
        cut=
        cp "$work/keep/emu" "$work/keep/sim"
        timeout 60 "$build/emu/sim-$board" $scenes/cut_end.stim "$work/sim.vcd" "$work/sim.txt" 99 "$work/keep/sim"
        said "$work/sim.txt" | tr -d '\r' >"$work/emu.said"
        case $(sed -n '/print a/{n;p;}' "$work/emu.said")$(grep -c '^saved' "$work/emu.said") in
        11) cmp -s "$work/first" "$work/keep/emu" || torn=$((torn + 1)) half=$after
            lo=$after ;;
        21) hi=$after ;;
        *)
            bad "cut after $after $1: neither the old scene nor the new"
            cat "$work/emu.said"
            return
            ;;
        esac
    done
    if [ $torn -gt 0 ]; then
        echo "[       OK ] $board: the power fails $4 times while a scene is saved; $torn times it was half written, and the old one is there"
        echo "# $board: half written after $half $1, done after $hi $1"
    else
        bad "cut: never half written, between $lo and $hi $1"
    fi
}
# An erase is milliseconds long, but takes no time in QEMU's model of the nRF51; there it is the words that are counted.
if [ $board = nrf51 ]; then power_cuts writes 0 500 9; else power_cuts us 20000 120000 6; fi
