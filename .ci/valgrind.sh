#!/bin/sh
# valgrind.sh RIDGELINE TEST... - the program on the demo scenes, and test programs, without a wrong access or a leak.
ridgeline=$1
shift
failed=0
clean() {
    if valgrind -q --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite "$@" >/tmp/valgrind.$$ 2>&1; then
        echo "clean   $*"
    else
        cat /tmp/valgrind.$$
        echo "FAILED  $*"
        failed=1
    fi
    rm -f /tmp/valgrind.$$
}
for t in "$@"; do clean "$t"; done
out=$(mktemp -d)
for scene in tests/scenes/*.gp; do clean "$ridgeline" plot "$scene" -o "$out/a.seg" -o "$out/a.vcd"; done
rm -rf "$out"
exit $failed
