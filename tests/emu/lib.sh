# lib.sh - for the tests of the boards: runs an image in its emulator and the same program on the simulator, and compares
# what the pins did and what the console said. Prints cmocka's lines.
#
#     scene NAME US [DRAWINGS]    tests/emu/scenes/NAME.stim, or the board's own of that name, in both; every edge within US microseconds of the other's
#                                 ("2 rests": from the end of each rest with the pen up, where the chip has still to compute, which takes no time on the simulator;
#                                 "-": the pins are not compared); the run ends after so many drawings (1), or with the scene's own `quit`
#     again NAME US [DRAWINGS]    the same on the board of the last scene: its power was off and is on again
#     alone NAME                  a scene on the board without the simulator, in which its memory is poked; rests LEAST MOST: what its pins did
#     says TEXT                   ... and the console of the last scene said that (an extended regular expression)
# A scene is played on a new board, on which nothing has been saved. turned="pen enable ..." tells which pins have levels turned
# round (set machine invert), pen="servo 1000 2000 0" or "solenoid 0.05 30" what is at the pen's pin: then pen.mjs judges that. probe="PROBE.mjs ARGUMENTS": for rp2040.mjs. cut=N: for scope.c.
ridgeline=${RIDGELINE:-build/host/ridgeline}
build=${BUILDDIR:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
failed=0
turned= pen= probe= cut=
. tests/emu/qemu.sh

run_lm3s6965() { run_qemu "$@"; }
run_nrf51() { run_qemu "$@"; }
run_qemu() { # stim, drawings
    serial=file:$work/emu.txt more="-D $work/emu.log ${qemu_more-}" run_by="timeout ${emu_s:-300}"
    qemu $board "$build" "$work/keep/emu" "vcd=$work/emu.vcd,stim=$1,drawings=$2${cut:+,cut=$cut}" >"$work/emu.said" 2>&1 || return 1
    cat "$work/emu.said" "$work/emu.log" 2>/dev/null | grep -vE "$QEMU_SAYS" >"$work/emu.err"
    [ ! -s "$work/emu.err" ]
}

run_rp2040() { # stim, drawings
    TURNED=$turned STORE=$work/keep/emu EMU_MODULES=$build/emu timeout 300 node tests/emu/rp2040.mjs "$build/firmware/rp2040.bin" "$1" \
        "$work/emu.vcd" "$work/emu.txt" "$2" $probe >"$work/emu.err" 2>&1 && [ ! -s "$work/emu.err" ]
}

# What both consoles say alike: not the board's name, nor numbers that were true a moment earlier or later, nor flow control,
# which depends on how fast a board is, nor how much of the memory pointers take, nor the prompt at the end, before which settings may be written to flash.
said() {
    LC_ALL=C tr -d '\021\023' <"$1" | LC_ALL=C sed -e 's/ on [a-z0-9]*; help/ on BOARD; help/' \
        -e 's/MPos:[-0-9.,]*/MPos:/; s/Done:[0-9]*/Done:/; s/Left:[0-9?]*/Left:/' \
        -e 's/memory, [0-9]* are free/memory, N are free/' -e '${/^> $/d;}'
}

scene() { # name, most us that an edge may differ, drawings
    rm -rf "$work/keep"
    again "$@"
}

scene_file() { # name: the board's own, or that of all
    if [ -e "tests/emu/scenes/$board/$1.stim" ]; then cat "tests/emu/scenes/$board/$1.stim"; else cat "tests/emu/scenes/$1.stim"; fi
}

# The board by itself: addresses are put for the @names of its program.
alone() { # name
    name=$1
    stim=$work/alone.stim
    scene_file "$1" >"$stim"
    for n in $(grep -o '@[a-z_]*' "$stim" | sort -u); do
        address=$(arm-none-eabi-nm "$build/firmware/$board.elf" | awk -v n="${n#@}" '$3 == n { print $1; exit }')
        sed -i "s/$n/0x$address/" "$stim"
    done
    rm -rf "$work/keep" "$work"/emu.*
    mkdir -p "$work/keep"
    if "run_$board" "$stim" 99; then
        said "$work/emu.txt" >"$work/emu.said"
        echo "[       OK ] $board $1"
    else
        bad "$1: emulator"
        head -20 "$work/emu.err" "$work/emu.txt"
    fi
}

# The scene that was played alone lowered the pen, and left motors off, pen up and steps low: so many seconds after the first edge,
# least and most.
rests() {
    if awk -v least="$1" -v most="$2" '/^\$timescale/ { unit = $3 == "ps" ? 1e-12 : 1e-9 }
        /^#/ { t = substr($0, 2) * unit }
        begun && /^[01]./ { id = substr($0, 2); v = substr($0, 1, 1) + 0
            if (v != level[id]) { if (!n++) first = t; last = t; down += id == "%" && v }
            level[id] = v }
        /^\$end$/ { begun = 1 }
        END { s = last - first; printf "# the pins are at rest %.3f s after the first edge\n", s
            exit !(down && s >= least && s <= most && !level["!"] && !level["#"] && !level["%"] && !level["&"]) }' "$work/emu.vcd"; then
        echo "[       OK ] $board $name: motors off, pen up"
    else
        bad "$name: not at rest"
        tail -5 "$work/emu.vcd"
    fi
}

again() {
    name=$1
    stim=tests/emu/scenes/$board/$1.stim
    [ -e "$stim" ] || stim=tests/emu/scenes/$1.stim
    mkdir -p "$work/keep"
    rm -f "$work"/sim.* "$work"/emu.* "$work"/difference
    if ! timeout 120 "$build/emu/sim-$board" "$stim" "$work/sim.vcd" "$work/sim.txt" "${3:-1}" "$work/keep/sim"; then
        bad "$1: simulator"
    elif ! "run_$board" "$stim" "${3:-1}"; then
        bad "$1: emulator"
        head -20 "$work/emu.err" "$work/emu.txt"
    else
        # Nothing moves: right where the scene ends by itself, and not where it waits for a drawing.
        if [ "$(grep -c '^[01]' "$work/sim.vcd")" = 6 ] && ! grep -q ' quit$' "$stim"; then
            bad "$1: nothing is drawn"
            cat "$work/emu.txt"
            return
        fi
        if [ -n "$pen" ] && ! node tests/emu/pen.mjs "$work/sim.vcd" "$work/emu.vcd" $pen; then
            bad "$1: pen"
            return
        fi
        limit=${2% rests}
        "$ridgeline" trace $([ "$limit" != "$2" ] && echo --rests --tolerance "$limit") "$work/sim.vcd" "$work/emu.vcd" >"$work/difference"
        [ "$2" = - ] && echo 'same sequence, difference 0 us at most' >"$work/difference"
        rests=$(sed -n 's/^\([0-9]* rests\) with the pen up differ, \([0-9.]*\) s.*/; \1 with the pen up took \2 s longer here/p' "$work/difference")
        us=$(sed -n '1s/^same sequence.* difference \([0-9.]*\) us at most.*/\1/p' "$work/difference")
        said "$work/sim.txt" >"$work/sim.said"
        said "$work/emu.txt" >"$work/emu.said"
        if [ -z "$us" ] || { [ "$2" != - ] && ! awk "BEGIN { exit !($us <= $limit) }"; }; then
            bad "$1: pins differ"
            cat "$work/difference" "$work/emu.txt"
        elif ! diff -a "$work/sim.said" "$work/emu.said" >"$work/difference"; then
            bad "$1: the consoles say different things"
            cat "$work/difference"
        else
            echo "[       OK ] $board $1"
            [ "$2" = - ] && return
            echo "# $board $1: $us us at most between $(grep -c '^[01]' "$work/emu.vcd") pin changes here and on the simulator$rests"
        fi
    fi
}

says() { # text
    if LC_ALL=C grep -aqE -e "$1" "$work/emu.said"; then
        echo "[       OK ] $board $name: says $1"
    else
        bad "$name: does not say $1"
        cat "$work/emu.said"
    fi
}

says_times() { # number, text, what it shows
    if [ "$(grep -ac -e "$2" "$work/emu.said")" = "$1" ]; then
        echo "[       OK ] $board $name: $3"
    else
        bad "$name: does not say $1 times $2"
        cat "$work/emu.txt"
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
