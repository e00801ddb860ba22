#!/bin/sh
# run.sh PROGRAM... - runs test programs, JOBS at a time, and ends with the line `N passed, N failed`.
#
# A program is a cmocka binary, a script of tests/cli (which prints cmocka's lines), or a libFuzzer binary, which is run for
# FUZZ_SECONDS (10) from FUZZ_SEED (1; 0 is another every time) and counts as one test. One line each as they finish; the
# output of those that fail is shown, and of the others the lines that begin with `# `, which are measurements.
run_fuzzer() {
    name=${1##*/}
    mkdir -p "$work/corpus-$name"
    set -- "$1" "$work/corpus-$name"
    [ -d "tests/fuzz/corpus/$name" ] && set -- "$@" "tests/fuzz/corpus/$name"
    [ -e "tests/fuzz/$name.dict" ] && set -- "$@" "-dict=tests/fuzz/$name.dict"
    "$@" -max_total_time="${FUZZ_SECONDS:-10}" -seed="${FUZZ_SEED:-1}" -timeout=120 -print_final_stats=1 -artifact_prefix="$BUILDDIR/fuzz/" -verbosity=0 >"$log" 2>&1
    rc=$?
    if [ $rc -eq 0 ]; then
        echo "[       OK ] $name" >>"$log"
        sed -n 's/^stat::number_of_executed_units: */# inputs tried: /p' "$log" >"$log.n" && cat "$log.n" >>"$log"
    fi
}

run_one() { # number, program
    log=$work/$1.log
    start=$(date +%s%N)
    case $2 in
    */fuzz/fuzz_*) run_fuzzer "$2" ;;
    *.sh) sh "$2" >"$log" 2>&1; rc=$? ;;
    *) "$2" >"$log" 2>&1; rc=$? ;;
    esac
    ms=$((($(date +%s%N) - start) / 1000000))
    p=$(grep -c '^\[       OK \]' "$log")
    f=$(sed -n 's/^\[  FAILED  \] \([0-9]*\) test(s).*/\1/p' "$log" | tail -1)
    f=${f:-0}
    # A crash, or a program that checked nothing, is a failure too.
    [ $rc -ne 0 ] && [ "$f" -eq 0 ] && f=1
    [ $rc -eq 0 ] && [ "$p" -eq 0 ] && ! grep -q '^# skipped' "$log" && f=1
    echo "$p $f" >"$work/$1.count"
    {
        [ "$f" -ne 0 ] && { echo "--- $2 (exit status $rc)"; cat "$log"; echo "---"; }
        name=${2#"$BUILDDIR"/}
        printf '%-44s %4d ok %3d failed %4d.%01d s\n' "${name#tests/}" "$p" "$f" $((ms / 1000)) $((ms % 1000 / 100))
        [ "$f" -eq 0 ] && grep '^# ' "$log"
    } >"$log.out"
    # One program's lines stay together.
    flock "$work/lock" cat "$log.out"
}

if [ "$1" = --one ]; then
    work=$2
    run_one "$3" "$4"
    exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
BUILDDIR=${BUILDDIR:-build}
export BUILDDIR
i=0
for t in "$@"; do
    i=$((i + 1))
    printf '%s\n%s\n%s\n' "$work" $i "$t" >>"$work/list"
done
touch "$work/list"
xargs -r -d '\n' -n 3 -P "${JOBS:-1}" sh "$0" --one <"$work/list"

passed=0 failed=0
for c in "$work"/*.count; do
    [ -e "$c" ] || continue
    read -r p f <"$c"
    passed=$((passed + p)) failed=$((failed + f))
    i=$((i - 1))
done
failed=$((failed + i)) # programs that left no count
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
