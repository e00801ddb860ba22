#!/bin/sh
# uml.sh FOLDER PROGRAM... - boots FOLDER/linux (uml_build.sh) and in it runs ridgeline-gpio on the kernel's own gpio-sim: a jog, a
# second program on lines that are taken, a limit switch, SIGTERM, SIGKILL of the process that steps. Bounded to two minutes; no root needed.
# Called again inside as: uml.sh --inside.
fail() { echo "FAILED  $*"; bad=1; }
value() { cat "$sim/sim_gpio$1/value"; }
is_safe() { [ "$(value 18)" = 0 ] && [ "$(value 25)" = 1 ]; }
long_jog() { "$ridgeline" jog 400 300 --pins "$work/pins.cfg" --set 'set machine travel 20' >"$work/log" 2>&1; }

check_program() { # RIDGELINE_GPIO is set
    "$ridgeline" jog 1 2 --pins "$work/pins.cfg" >"$work/log" 2>&1 && is_safe || { fail jog; cat "$work/log"; }
    long_jog & job=$!
    sleep 2
    [ "$(value 25)" = 0 ] || fail "motors off while it moves"
    "$ridgeline" off --pins "$work/pins.cfg" 2>&1 | grep -q 'in use by "ridgeline"' || fail "lines in use"
    echo pull-down >"$sim/sim_gpio5/pull"
    wait $job && fail "the limit switch was not seen"
    echo pull-up >"$sim/sim_gpio5/pull"
    grep -q 'limit_x became active; stopped at' "$work/log" && is_safe || { fail limit; cat "$work/log"; }
    long_jog & job=$!
    sleep 2
    kill -TERM "$(pgrep -o -x ridgeline-gpio)"
    wait $job
    grep -q 'stopped by a signal at' "$work/log" && is_safe || { fail SIGTERM; cat "$work/log"; }
    long_jog & job=$!
    sleep 2
    kill -KILL "$(pgrep -n -x ridgeline-gpio)"
    wait $job
    grep -q 'was killed' "$work/log" || { fail SIGKILL; cat "$work/log"; }
}

if [ "$1" = --inside ]; then
    PATH=/usr/sbin:/usr/bin:/sbin:/bin
    mount -t proc proc /proc
    mount -t sysfs sysfs /sys
    mount -t devtmpfs dev /dev 2>/dev/null
    mount -t configfs configfs /sys/kernel/config
    mount -t tmpfs tmpfs /tmp
    work=/tmp bad=0
    chip=/sys/kernel/config/gpio-sim/plotter
    mkdir -p $chip/bank0
    echo 28 >$chip/bank0/num_lines
    echo pinctrl-bcm2711 >$chip/bank0/label
    echo 1 >$chip/live
    sim=/sys/devices/platform/$(cat $chip/dev_name)/$(cat $chip/bank0/chip_name)
    for line in 5 6 25; do echo pull-up >"$sim/sim_gpio$line/pull"; done
    printf 'chip pinctrl-bcm2711\nx_step 17\nx_dir 27\ny_step 22\ny_dir 23\npen 18\nenable 25 active_low\nlimit_x 5\nestop 6\n' >$work/pins.cfg
    ridgeline=$UML_RIDGELINE
    for RIDGELINE_GPIO in $UML_PROGRAMS; do
        export RIDGELINE_GPIO
        check_program
    done
    [ $bad = 0 ] && echo "ok      gpio-sim of Linux $(uname -r)"
    exec "$UML_POWEROFF"
fi

folder=$(realpath "$1")
shift
programs=$(realpath "$@" | tr '\n' ' ')
printf '#include <sys/reboot.h>\nint main(void) { return reboot(RB_POWER_OFF); }\n' >"$folder/off.c"
${CC:-gcc} "$folder/off.c" -o "$folder/off"
cat >"$folder/init" <<END
#!/bin/sh
UML_RIDGELINE=$(realpath "$RIDGELINE") UML_PROGRAMS='$programs' UML_POWEROFF=$folder/off
export UML_RIDGELINE UML_PROGRAMS UML_POWEROFF
exec sh $(realpath "$0") --inside
END
chmod +x "$folder/init"
timeout 120 "$folder/linux" mem=256M root=/dev/root rootfstype=hostfs rootflags=/ rw quiet init="$folder/init" con=null con0=null,fd:1 \
    </dev/null >"$folder/log" 2>&1
grep -aE '^(ok|FAILED) ' "$folder/log"
grep -aq '^ok ' "$folder/log" || { tail -40 "$folder/log"; exit 1; }
