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
# Where a write is over in a few instructions and the console's pace moves its beginning from run to run, halving can pass it by: then once more.
power_cuts() { # us after which a save begins to write, at the latest is done, halvings
    name=cut scenes=tests/emu/scenes
    rm -rf "$work/keep"
    mkdir -p "$work/keep"
    "run_$board" $scenes/cut_begin.stim 99 || bad 'cut: emulator'
    cp "$work/keep/emu" "$work/first"
    lo=$1 hi=$2 torn=0 cuts=0
    for i in $(seq $((3 * $3))); do
        [ $i -gt "$3" ] && [ $torn -gt 0 ] && break
        [ $((i % $3)) = 1 ] && lo=$1 hi=$2
        us=$(((lo + hi) / 2)) cuts=$((cuts + 1))
        sed "s/+1500000 type @CUT/+$((1500000 + us)) quit/" $scenes/cut_save.stim >"$work/cut.stim"
        cp "$work/first" "$work/keep/emu"
        "run_$board" "$work/cut.stim" 99 || bad 'cut: emulator'
        cp "$work/keep/emu" "$work/keep/sim"
        timeout 60 "$build/emu/sim-$board" $scenes/cut_end.stim "$work/sim.vcd" "$work/sim.txt" 99 "$work/keep/sim"
        said "$work/sim.txt" | tr -d '\r' >"$work/emu.said"
        case $(sed -n '/print a/{n;p;}' "$work/emu.said")$(grep -c '^saved' "$work/emu.said") in
        11) cmp -s "$work/first" "$work/keep/emu" || torn=$((torn + 1)) half=$us
            lo=$us ;;
        21) hi=$us ;;
        *)
            bad "cut after $us us: neither the old scene nor the new"
            cat "$work/emu.said"
            return
            ;;
        esac
    done
    if [ $torn -gt 0 ]; then
        echo "[       OK ] $board: the power fails $cuts times while a scene is saved; $torn times it was half written, and the old one is there"
        echo "# $board: half written after $half us, done after $hi us"
    else
        bad "cut: never half written, between $lo and $hi us"
    fi
}
if [ $board = nrf51 ]; then power_cuts 20000 40000 12; else power_cuts 20000 120000 6; fi # an erase is milliseconds long; not in QEMU's model of the nRF51
