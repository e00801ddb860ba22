#!/bin/sh
# soak.sh MINUTES PROGRAM... - runs property tests in rounds, each with seeds of its own, until the time is over. Ends with
# the number of scenes tried. What a failure prints (the scene, the command that repeats it, the scene made small) is shown,
# the soak goes on, and ends with the list of such commands and status 1. RIDGELINE_CASES (10) says how many times as many
# cases a round has as `make test`, ROUND with which round to begin.
end=$(($(date +%s) + $1 * 60))
shift
RIDGELINE_CASES=${RIDGELINE_CASES:-10}
export RIDGELINE_CASES
round=${ROUND:-1}
scenes=0
log=$(mktemp)
repeat=$(mktemp)
trap 'rm -f "$log" "$repeat"' EXIT
trap 'exit 1' INT TERM
while [ "$(date +%s)" -lt "$end" ]; do
    for t in "$@"; do
        left=$((end - $(date +%s)))
        [ $left -gt 0 ] || break
        run=$t
        [ "${t%.sh}" = "$t" ] || run="sh $t"
        # The last program is ended in the middle: what it has found by then is in its output.
        RIDGELINE_ROUND=$round timeout "$left" $run >"$log" 2>&1
        rc=$?
        if [ $rc -ne 124 ] && [ $rc -ne 0 ] || grep -q FAILED "$log"; then
            cat "$log"
            echo "failed in round $round: RIDGELINE_CASES=$RIDGELINE_CASES RIDGELINE_ROUND=$round $run"
            sed -n 's/^#* *repeat: //p; s/^# FAILED:* \(RIDGELINE_SEED=[0-9]* [^: ]*\).*/\1/p' "$log" | sort -u >>"$repeat"
            [ -s "$repeat" ] || echo "RIDGELINE_CASES=$RIDGELINE_CASES RIDGELINE_ROUND=$round $run" >>"$repeat"
        fi
        n=$(sed -n 's/^# .*: \([0-9]*\) \(scenes\|frames\|pairs\|drawings\|faces\).*/\1/p' "$log" | awk '{ s += $1 } END { print s + 0 }')
        scenes=$((scenes + n))
        echo "round $round, ${t##*/}: $n scenes, $scenes in all"
    done
    round=$((round + 1))
done
# User and system time of what was run.
times >"$log"
rate=$(awk -v n="$scenes" 'NR == 2 { gsub("[ms]", " "); s = $1 * 60 + $2 + $3 * 60 + $4
    if (s > 0) printf " in %.1f minutes of CPU time, %.2f million an hour", s / 60, n / s * 3600 / 1e6 }' "$log")
if [ -s "$repeat" ]; then
    echo "$scenes scenes$rate, $(wc -l <"$repeat") failed:"
    cat "$repeat"
    exit 1
fi
echo "$scenes scenes$rate, none failed"
