#!/bin/sh
# ridgeline-gpio, with the real libgpiod, on an emulated gpiochip that records from outside (emu.h). Every test runs with each
# version of the library that was built.
. tests/cli/lib.sh
case ${BUILDDIR:=build} in /*) built=$BUILDDIR ;; *) built=$root/$BUILDDIR ;; esac
emu=$built/gpio

emu_tool() { "$emu/emu_tool" "$@"; }
emu_judge() { "$emu/emu_judge" "$@"; }
emulated() { LD_PRELOAD=$emu/libgpioemu.so "$@"; }
# The program under the emulation; what it says is kept.
run() { emulated "$RIDGELINE" "$@" >out 2>err; }
draw() { run plot scene.gp --hal gpio --pins pins.cfg "$@"; }

# Two chips, the switches of pins.cfg open (pulled up), everybody else's lines free.
chips() {
    GPIOEMU=$PWD/emu
    export GPIOEMU
    rm -rf emu
    emu_tool init
    emu_tool chip pinctrl-bcm2711 58
    emu_tool chip expander 8
    for line in 5 6 17 18 22 23 25 27; do emu_tool name 0 $line GPIO$line; done
    emu_tool in 0 5 1
    emu_tool in 0 6 1
    cat >pins.cfg <<END
chip gpiochip0
x_step 17
x_dir GPIO27
y_step pinctrl-bcm2711:22
y_dir "GPIO23"
pen 18
enable 25 active_low   # the drivers' /ENABLE
limit_x 5
estop 6
END
    cat >scene.gp <<END
set paper 60,50
set machine speed 100 travel 150 accel 5000 lift 0.01 lower 0.01 enable 0.002 pulse 5
set isosamples 3,4
set samples 4
splot x*y
END
}

# until_so COMMAND...: tries again until it succeeds. What is waited for happens however slow the machine is; if it
# does not, that is an error after a minute of trying.
until_so() {
    tries=0
    until "$@"; do
        tries=$((tries + 1))
        [ $tries -lt 1200 ] || { echo "never so: $*"; return 1; }
        sleep 0.05
    done
}
x_has_moved() { [ "$(emu_tool rises 0 17)" -gt 50 ]; }

# Pen (18) up, motors (25, active low) off.
is_safe() {
    [ "$(emu_tool level 0 18)" = 0 ] || { echo "the pen is down"; return 1; }
    [ "$(emu_tool level 0 25)" = 1 ] || { echo "the motors are on"; return 1; }
    [ "$(emu_tool level 0 17)" = 0 ] && [ "$(emu_tool level 0 22)" = 0 ] || { echo "a step line is high"; return 1; }
}

says() {
    for text in "$@"; do
        grep -qF -- "$text" err || { echo "not said: $text"; cat err; return 1; }
    done
}

# pins_are_wrong LINES TEXT...: that pin file ends with status 2, says the texts, and touches nothing.
pins_are_wrong() {
    printf '%b' "$1" >pins.cfg
    shift
    expect_status 2 draw
    says "$@" "nothing was moved"
    emu_tool log | grep -q request && { echo "a line was taken"; return 1; }
    return 0
}
good='chip gpiochip0\nx_step 17\nx_dir 27\ny_step 22\ny_dir 23\npen 18\n'

pin_files_are_checked() {
    chips
    pins_are_wrong "${good}enable 25\nchip gpiochip7\n" 'pins.cfg:8:6: there is no chip "gpiochip7"'
    pins_are_wrong "${good}enable gpiochip3:25\n" 'pins.cfg:7:8: there is no chip "gpiochip3"'
    pins_are_wrong "${good}enable 25\nlimit_x 17\n" 'pins.cfg:8:9: line 17 of gpiochip0 is already x_step, on line 2'
    pins_are_wrong "${good}enable 25\nenable 24\n" 'pins.cfg:8:1: enable has been given already, on line 7'
    pins_are_wrong "${good}" 'pins.cfg: enable is missing'
    pins_are_wrong "${good}enable 25\nxstep 3\n" 'pins.cfg:8:1: unknown name "xstep"'
    pins_are_wrong "${good}enable 25 active_lo\n" 'pins.cfg:7:11: unknown word "active_lo"'
    pins_are_wrong "${good}enable 25 active_low active_high\n" 'pins.cfg:7:22: the polarity has been given already'
    pins_are_wrong "${good}enable 25 pull_up\n" 'pins.cfg:7:11: enable is an output'
    pins_are_wrong "${good}enable 58\n" 'pins.cfg:7:8: gpiochip0 has no line 58; its last is 57'
    pins_are_wrong "${good}enable GPIO99\n" 'pins.cfg:7:8: there is no line named "GPIO99"'
    pins_are_wrong "x_step 17\n" 'pins.cfg:1:8: line 17 of which chip?' 'pen is missing'
    pins_are_wrong "${good}enable gpiochip1:3\n" 'enable on gpiochip1: outputs must be on one chip'
    pins_are_wrong "${good}enable\n" 'pins.cfg:7:1: enable is on which line?'
    pins_are_wrong "${good}enable \"25\n" 'pins.cfg:7:8: the quote is not closed'
    pins_are_wrong "${good}enable 25 active_low active_low active_low x\n" 'pins.cfg:7:44: too much'
    emu_tool hog 0 25
    pins_are_wrong "${good}enable 25\n" 'pins.cfg:7:8: line 25 of gpiochip0 is in use by "kernel"'
}

a_line_in_use_is_named() {
    chips
    emulated gpioset --mode=signal gpiochip0 27=1 &
    gpioset_holds_it() { [ "$(emu_tool level 0 27)" = 1 ]; }
    until_so gpioset_holds_it
    expect_status 2 draw
    kill $!
    wait $! || true
    says 'pins.cfg:3:7: line 27 of gpiochip0 is in use by "gpioset"'
}

tools_accept_the_emulation() {
    chips
    [ $version = 2 ] && { tools_of_2_accept_the_emulation; return; }
    emulated gpiodetect >tool
    expect_text tool 'gpiochip0 [pinctrl-bcm2711] (58 lines)' 'gpiochip1 [expander] (8 lines)'
    emulated gpioinfo gpiochip0 >tool
    expect_text tool '"GPIO17"' 'unused' 'input'
    emulated gpioset gpiochip0 17=1
    [ "$(emu_tool level 0 17)" = 1 ]
    [ "$(emulated gpioget gpiochip0 5)" = 1 ]
    emu_tool in 0 5 0
    [ "$(emulated gpioget gpiochip0 5)" = 0 ]
}

tools_of_2_accept_the_emulation() {
    tool() { emulated "$emu/debian-v2/tool" "$@"; }
    tool gpiodetect >tool
    expect_text tool 'gpiochip0 [pinctrl-bcm2711] (58 lines)' 'gpiochip1 [expander] (8 lines)'
    tool gpioinfo -c gpiochip0 >tool
    expect_text tool '"GPIO17"' 'input'
    tool gpioset -t 0 GPIO17=1
    [ "$(emu_tool rises 0 17)" = 1 ]
    [ "$(tool gpioget -c gpiochip0 5)" = '"5"=active' ]
    emu_tool in 0 5 0
    [ "$(tool gpioget -c gpiochip0 5)" = '"5"=inactive' ]
}

dry_run_touches_nothing() {
    chips
    expect_status 0 draw --dry-run
    expect_text out "libgpiod $version." 'enable   gpiochip0 line 25 (GPIO25), active low' 'limit_y  none' 'would draw' ' min;' \
        'nothing was moved'
    emu_tool log | grep -q request && return 1
    return 0
}

what_lines_cannot_do_is_refused() {
    chips
    echo 'set machine pen servo; splot x*y' >scene.gp
    expect_status 2 draw
    says 'set machine pen servo: this board' 'nothing was moved'
    expect_status 2 run pen down --pins pins.cfg --set 'set machine pen solenoid'
    says 'hold it with all of the power'
    expect_status 2 run jog 1 1 --pins pins.cfg --set 'set machine invert enable'
    says 'active_low and active_high in the pin file'
    expect_status 2 run home --pins pins.cfg --set 'set machine home left,top'
    emu_tool log | grep -q request && return 1
    expect_status 0 run off --pins pins.cfg --set 'set machine pen servo'
    is_safe
}

# The latest deadline and the slowest write (us), and how far the time base moved (ms), as reported.
reported() {
    sed -n 's/.*the latest by \([0-9.]*\) us.*moved by \([0-9.]*\) ms in all; slowest write \([0-9.]*\) us.*/\1 \2 \3/p' err |
        awk '{ print $1 + $3, $2 }'
}

recording_is_the_simulators_trace() {
    chips
    "$RIDGELINE" plot scene.gp -o trace.vcd
    expect_status 0 draw
    # shellcheck disable=SC2046 # two words
    emu_judge trace.vcd $(reported) >judged || { cat judged err; return 1; }
    sed "s/^# /# libgpiod $version: /" judged
    sed -n "s/^ridgeline: \([0-9]* of .*\)/# libgpiod $version: \1/p" err
    is_safe
}

# Motors off and pen up come before everything else, and nothing else is driven before they are.
lines_are_taken_safely() {
    chips
    expect_status 0 run off --pins pins.cfg
    emu_tool log | grep request | head -1 | grep -q 'levels 0x2000000' # of all outputs only /ENABLE is high
    is_safe
}

a_stall_shifts_the_time_base() {
    chips
    "$RIDGELINE" plot scene.gp -o trace.vcd
    emu_tool when 0 rises 17 300 stall 60000
    emu_tool when 0 sets 3000 stall 20000
    expect_status 0 draw
    # shellcheck disable=SC2046
    emu_judge trace.vcd $(reported) || { cat err; return 1; }
    is_safe
}

# Every step arrives; how fast is printed, and not judged, since it depends on the machine and who else is on it: the best of a few.
twice_twenty_thousand_steps_a_second() {
    best_x=0 best_y=0
    for try in 1 2 3 4; do
        chips
        expect_status 0 run jog 70 70 --pins pins.cfg --set 'set machine travel 440 accel 20000 pulse 5'
        [ "$(emu_tool rises 0 17)" = 5600 ] && [ "$(emu_tool rises 0 22)" = 5600 ]
        emu_judge rate >rate
        { read -r x && read -r y; } <rate
        if [ "$x" -gt $best_x ]; then best_x=$x best_y=$y; fi
        if [ "$best_x" -ge 20000 ] && [ "$best_y" -ge 20000 ]; then break; fi
    done
    echo "# libgpiod $version: $best_x and $best_y steps/s on two axes at once"
}

# fault STATUS TEXT WHEN...: the plot with that fault planted ends so, safe, having drawn a beginning of the trace.
fault() {
    want=$1 text=$2
    shift 2
    chips
    [ -e trace.vcd ] || "$RIDGELINE" plot scene.gp -o trace.vcd
    emu_tool when "$@"
    expect_status "$want" draw
    says "$text" || { cat err; return 1; }
    grep -qE 'at x -?[0-9.]+ mm, y -?[0-9.]+ mm \(-?[0-9]+, -?[0-9]+ steps\)' err || { echo "no position"; cat err; return 1; }
    emu_judge trace.vcd prefix || return 1
}

write_errors_stop_and_are_reported() {
    fault 1 'written: Input/output error' 0 sets 900 set-error 5
    is_safe
    fault 1 'cut the motors'"'"' power' 0 sets 900 set-error 5 -1
    fault 1 ': No such device; stopped at' 0 rises 17 200 unplug
    fault 1 'written: Device or resource busy' 0 sets 1200 set-error 16
    is_safe
}

position_is_that_of_the_pins() {
    fault 1 'limit_x became active' 0 rises 17 123 in 5 0
    steps=$(sed -n 's/.*(\([0-9]*\), [0-9]* steps).*/\1/p' err)
    [ "$steps" -ge 123 ] && [ "$steps" -le 124 ] || { echo "stopped at $steps"; return 1; }
    is_safe
}

a_busy_line_at_the_last_moment() {
    chips
    emu_tool when 0 requests 1 request-error 16
    expect_status 1 draw
    says 'taking the output lines of gpiochip0: Device or resource busy'
}

switches_stop_within_one_step() {
    for line in 5 6; do
        fault 1 'became active; stopped' 0 rises 17 150 in $line 0
        [ "$(emu_tool rises 0 17)" -le 151 ] || { echo "went on"; return 1; }
        is_safe
    done
    says 'emergency stop became active'
    # Active before the start: nothing moves.
    chips
    emu_tool in 0 6 0
    expect_status 1 draw
    says 'emergency stop active already: nothing was moved'
    [ "$(emu_tool rises 0 17)" = 0 ]
}

signals_stop_safely() {
    for signal in 2 15 1; do
        chips
        emu_tool when 0 rises 17 200 signal $signal
        expect_status 1 draw
        says 'stopped by a signal at'
        is_safe
        [ "$(emu_tool rises 0 17)" -lt 1000 ] # it brakes
    done
}

# A drawing of minutes, so that it is not over before this script gets its turn.
slow_scene() { sed -i 's/speed 100/speed 4/; s/isosamples.*/isosamples 30/' scene.gp; }

# A signal to the program that was started, as a terminal or systemd sends it.
a_signal_from_outside() {
    for signal in INT TERM HUP; do
        chips
        slow_scene
        LD_PRELOAD=$emu/libgpioemu.so "$RIDGELINE" plot scene.gp --hal gpio --pins pins.cfg >out 2>err &
        until_so x_has_moved
        kill -$signal $!
        rc=0
        wait $! || rc=$?
        [ $rc -ge 129 ] || { echo "exit status $rc"; cat err; return 1; }
        says 'stopped by a signal at x'
        is_safe
    done
}

killed_outright() {
    fault 137 'was killed (Killed) at' 0 rises 17 200 signal 9
    is_safe
    # and the time from its last write to the guardian's
    emu_tool log | awk '$2 == "set" { if ($4 != pid && pid) { printf "# safe %.0f us after the last step of a killed process\n",
        ($1 - t) / 1000; exit } pid = $4; t = $1 }'
    # A chip whose released lines become inputs: the guardian still holds them.
    chips
    emu_tool release-to-input
    emu_tool when 0 rises 17 200 signal 9
    expect_status 137 draw
    emu_tool log | grep -B1 -m1 release | head -1 | grep -q 'levels 0x2000'
}

# The guardian killed: the stepping process stops by itself.
guardian_killed() {
    chips
    slow_scene
    LD_PRELOAD=$emu/libgpioemu.so "$RIDGELINE" plot scene.gp --hal gpio --pins pins.cfg >out 2>err &
    until_so x_has_moved
    guardian=$(emu_tool log | sed -n 's/.*request pid \([0-9]*\) .*/\1/p' | head -1)
    kill -KILL "$guardian"
    wait $! || true
    is_safe_now() { is_safe >/dev/null; }
    until_so is_safe_now
}

# A carriage 8 mm from its switch on line 5: homing meets it and stops 2 mm off.
home_finds_the_switch() {
    chips
    emu_tool axis 0 0 17 27 5 640 0 0
    expect_status 0 run home --pins pins.cfg
    [ "$(emu_tool position 0)" = 160 ] || { emu_tool position 0; return 1; }
    is_safe
    # Standing on it: only off. Then a wire that is broken.
    chips
    emu_tool axis 0 0 17 27 5 -10 0 0
    expect_status 0 run home --pins pins.cfg
    [ "$(emu_tool position 0)" = 150 ] || { emu_tool position 0; return 1; }
    chips
    expect_status 1 run home --pins pins.cfg --set 'set machine size 20,20'
    says 'limit_x was not met within 24 mm'
    is_safe
}

jog_moves_the_lifted_pen() {
    chips
    expect_status 0 run jog 1.5 -2 --pins pins.cfg
    [ "$(emu_tool rises 0 17)" = 120 ] && [ "$(emu_tool rises 0 22)" = 160 ] && [ "$(emu_tool rises 0 18)" = 0 ]
    is_safe
    expect_status 2 run jog 1 --pins pins.cfg
    expect_status 0 run jog -1 -1 --pins pins.cfg --dry-run
    expect_text out 'by -1.000 mm, -1.000 mm'
}

pen_goes_down_and_up() {
    chips
    expect_status 0 run pen down --for 1 --pins pins.cfg
    [ "$(emu_tool rises 0 18)" = 1 ]
    is_safe
    expect_status 0 run pen up --pins pins.cfg
    expect_status 2 run pen sideways --pins pins.cfg
}

without_real_time_a_warning() {
    chips
    command -v setpriv >/dev/null || return 0
    [ "$(id -u)" = 0 ] || return 0
    chmod 777 . && chmod -R a+rwX emu
    LD_PRELOAD=$emu/libgpioemu.so setpriv --reuid 65534 --clear-groups "$RIDGELINE" jog 1 1 --pins pins.cfg >out 2>err
    says 'no real-time scheduling' 'steps will come late'
}

tests='tools_accept_the_emulation pin_files_are_checked a_line_in_use_is_named dry_run_touches_nothing what_lines_cannot_do_is_refused lines_are_taken_safely
    recording_is_the_simulators_trace a_stall_shifts_the_time_base twice_twenty_thousand_steps_a_second
    write_errors_stop_and_are_reported position_is_that_of_the_pins a_busy_line_at_the_last_moment
    switches_stop_within_one_step signals_stop_safely a_signal_from_outside killed_outright guardian_killed
    home_finds_the_switch jog_moves_the_lifted_pen pen_goes_down_and_up without_real_time_a_warning'

all=
for version in 1 2; do
    for program in "$built/host/ridgeline-gpio" "$built/gpio/v2/ridgeline-gpio"; do
        ldd "$program" 2>/dev/null | grep -qE "libgpiod\.so\.$((version + 1))" || continue
        for t in $tests; do
            eval "${t}_with_libgpiod_$version() { version=$version; RIDGELINE_GPIO=$program; export RIDGELINE_GPIO; $t; }"
            all="$all ${t}_with_libgpiod_$version"
        done
        break
    done
done
# shellcheck disable=SC2086 # a list
run_tests $all
