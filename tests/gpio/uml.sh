#!/bin/sh
# uml.sh - the truth check of `make check-uml`: ridgeline-gpio of both libgpiod versions on the kernel's own gpio-sim, in a
# user-mode Linux that uml_build.sh has built. Run by tests/run.sh. Bounded: eight minutes, then the kernel is killed.
#
# The guest's root is this machine's, so that every program and library is at its own path; what the tests write
# goes to a tmpfs on an empty folder of the build. The guest's first process is this script again, with --inside.
built=$(realpath "${BUILDDIR:-build}")
uml=$built/gpio/uml

if [ "$1" != --inside ]; then
    mkdir -p "$uml/tmp"
    printf '#include <sys/reboot.h>\nint main(void) { return reboot(RB_POWER_OFF); }\n' >"$uml/off.c"
    "${CC:-gcc}" "$uml/off.c" -o "$uml/off" || exit 1
    cat >"$uml/init" <<END
#!/bin/sh
export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin BUILDDIR='$built' TMPDIR='$uml/tmp' HOME=/
cd '$PWD' && sh tests/gpio/uml.sh --inside
exec '$uml/off'
END
    chmod +x "$uml/init"
    # A temporary file of the host in memory serves as the guest's memory.
    timeout -k 5 480 "$uml/linux" mem=192M root=/dev/root rootfstype=hostfs rootflags=/ rw quiet init="$uml/init" con=null con0=null,fd:1 \
        </dev/null >"$uml/log" 2>&1
    tr -d '\r' <"$uml/log" >"$uml/log.text"
    cat "$uml/log.text"
    # Nothing counts unless the guest came to its end.
    grep -q '^# gpio-sim: all was run' "$uml/log.text" && ! grep -q '^\[  FAILED  \]' "$uml/log.text"
    exit
fi

mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t devtmpfs dev /dev 2>/dev/null
mount -t configfs configfs /sys/kernel/config
mount -t tmpfs tmpfs "$uml/tmp"
. tests/cli/lib.sh

chip=/sys/kernel/config/gpio-sim/plotter
# A chip as a Raspberry Pi's, with one line in the hands of a driver; the switches are open.
plug_in() {
    mkdir -p $chip/bank0/line26/hog
    echo 28 >$chip/bank0/num_lines
    echo pinctrl-bcm2711 >$chip/bank0/label
    for line in 17 18 22 23 25 27; do
        mkdir $chip/bank0/line$line
        echo GPIO$line >$chip/bank0/line$line/name
    done
    echo "spi0 CS1" >$chip/bank0/line26/hog/name
    echo output-high >$chip/bank0/line26/hog/direction
    echo 1 >$chip/live
    where
    for line in 5 6 25; do echo pull-up >"$sim/sim_gpio$line/pull"; done
}
# A chip that is plugged in again may get another name.
where() {
    name=$(cat $chip/bank0/chip_name)
    sim=/sys/devices/platform/$(cat $chip/dev_name)/$name
}
unplug() {
    echo 0 >$chip/live
    rmdir $chip/bank0/line26/hog $chip/bank0/line* $chip/bank0 $chip
}

value() { cat "$sim/sim_gpio$1/value"; }
switch_x() { echo "$1" >"$sim/sim_gpio5/pull"; }
estop() { echo "$1" >"$sim/sim_gpio6/pull"; }
is_safe() {
    [ "$(value 18)" = 0 ] || { echo "the pen is down"; return 1; }
    [ "$(value 25)" = 1 ] || { echo "the motors are on"; return 1; }
}
# until_ COMMAND...: waits until it succeeds, for at most 20 s: however busy the machine is, the result is the same.
until_() {
    for wait in $(seq 200); do
        "$@" && return 0
        sleep 0.1
    done
    echo "in vain: $*"
    return 1
}
motors_are_on() { [ "$(value 25)" = 0 ]; }
job_has_ended() { ! grep -q '^State:.[^Z]' /proc/$job/status 2>/dev/null; }

# no_pull, because gpio-sim takes a pull that a program asks for as its own switch.
pins() {
    printf 'chip pinctrl-bcm2711\nx_step 17\nx_dir GPIO27\ny_step 22\ny_dir 23\npen 18\nenable 25 active_low\nlimit_x 5 no_pull\nestop 6 no_pull\n' >pins.cfg
    printf '%b' "$1" >>pins.cfg
}
says() { expect_text err "$@"; }
run() { ridgeline "$@" >out 2>err; }
# A jog that lasts a minute unless something ends it; returns when it moves.
long_jog() {
    pins ''
    "$RIDGELINE" jog 800 600 --pins pins.cfg --set 'set machine travel 20' >out 2>err &
    job=$!
    until_ motors_are_on
}
ends_with() { # STATUS TEXT...
    until_ job_has_ended
    status=0
    wait $job || status=$?
    [ $status = "$1" ] || { echo "exit status $status instead of $1"; cat err; return 1; }
    shift
    says "$@"
}

tools_see_the_chip() {
    gpiodetect >tool
    expect_text tool '[pinctrl-bcm2711] (28 lines)'
}
what_is_taken_is_told() {
    pins 'limit_y 26\n'
    expect_status 2 run jog 1 1 --pins pins.cfg
    says 'pins.cfg:10:9: line 26 of '"$name"' is in use by "spi0 CS1"' 'nothing was moved'
    pins 'limit_y 28\n'
    expect_status 2 run jog 1 1 --pins pins.cfg
    says "$name"' has no line 28; its last is 27'
    pins 'limit_y gpiochip7:1\n'
    expect_status 2 run jog 1 1 --pins pins.cfg
    says 'there is no chip "gpiochip7"'
    is_safe
}
a_drawing_ends_safe() {
    pins ''
    printf 'set paper 40,30\nset isosamples 3\nset machine speed 60\nsplot x*y\n' >scene.gp
    expect_status 0 run plot scene.gp --hal gpio --pins pins.cfg
    sed -n "s/^ridgeline: \([0-9]* of .*\)/# gpio-sim, libgpiod $version: \1/p" err
    is_safe
}
a_second_program_is_refused() {
    long_jog
    expect_status 2 ridgeline off --pins pins.cfg 2>second
    expect_text second 'in use by "ridgeline"'
    gpioinfo >tool
    expect_text tool '"GPIO17"' '"ridgeline"'
    kill -TERM $job
    ends_with 143 'stopped by a signal at x'
    is_safe
}
switches_stop() {
    long_jog
    switch_x pull-down
    ends_with 1 'limit_x became active; stopped at x'
    is_safe
    expect_status 0 run jog 1 0 --pins pins.cfg # off the switch
    switch_x pull-up
    long_jog
    estop pull-down
    ends_with 1 'emergency stop became active; stopped at x'
    is_safe
    expect_status 1 run jog 1 0 --pins pins.cfg
    says 'emergency stop active already: nothing was moved'
    estop pull-up
}
signals_stop() {
    for signal in 1 2 15; do
        long_jog
        kill -$signal $job
        ends_with $((128 + signal)) 'stopped by a signal at x'
        is_safe
    done
}
killed_outright() {
    long_jog
    kill -KILL "$(pgrep -n -x ridgeline-gpio)"
    ends_with 137 'was killed (Killed) at x'
    is_safe
}
# The stepping process is told, and stops by itself; then nobody holds the lines, and they are as the wiring pulls them.
guardian_killed() {
    long_jog
    kill -KILL "$(pgrep -o -x ridgeline-gpio)"
    until_ is_safe
    nobody() { ! pgrep -x ridgeline-gpio >/dev/null; }
    until_ nobody
    is_safe
}
a_chip_that_goes_is_reported() {
    long_jog
    unplug
    ends_with 1 ': No such device; stopped at x'
    plug_in
}

tests='tools_see_the_chip what_is_taken_is_told a_drawing_ends_safe a_second_program_is_refused switches_stop signals_stop
    killed_outright guardian_killed a_chip_that_goes_is_reported'
plug_in
echo "# gpio-sim of Linux $(uname -r)"
all=
for version in 1 2; do
    for program in "$built/host/ridgeline-gpio" "$built/gpio/v2/ridgeline-gpio"; do
        ldd "$program" 2>/dev/null | grep -qE "libgpiod\.so\.$((version + 1))" || continue
        for t in $tests; do
            eval "${t}_with_libgpiod_$version() { trap 'cat err' EXIT; where; version=$version; RIDGELINE_GPIO=$program; export RIDGELINE_GPIO; $t; trap - EXIT; }"
            all="$all ${t}_with_libgpiod_$version"
        done
        break
    done
done
# shellcheck disable=SC2086 # a list
(run_tests $all)
echo "# gpio-sim: all was run"
