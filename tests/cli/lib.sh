# lib.sh - for tests of the program from outside. A test is a shell function: it fails when one of its commands does. run_tests
# runs each in an empty folder ($PWD then), and prints what cmocka would, and its lines that begin with `# `.
root=$PWD
case ${RIDGELINE:=build/host/ridgeline} in /*) ;; *) RIDGELINE=$root/$RIDGELINE ;; esac
scenes=$root/tests/scenes

ridgeline() { "$RIDGELINE" "$@"; }

# ours SCRIPT [OUT]: draws a script, within some seconds.
ours() { timeout 20 "$RIDGELINE" plot "$1" ${2:+-o "$2"}; }

# expect_status N command...: runs the command and wants that exit status.
expect_status() {
    want=$1
    shift
    got=0
    "$@" || got=$?
    [ "$got" -eq "$want" ] || { echo "exit status $got instead of $want: $*"; return 1; }
}

# expect_text file text...: every text must be in the file, as it stands.
expect_text() {
    file=$1
    shift
    for text in "$@"; do
        grep -qF -- "$text" "$file" || { echo "not in $file: $text"; cat "$file"; return 1; }
    done
}

# expect_mistakes: lines `SCRIPT@text of the message` on standard input; each script is refused so, within some seconds.
expect_mistakes() {
    while IFS='@' read -r wrong reason; do
        echo "$wrong" >mistake.gp
        expect_status 2 ours mistake.gp 2>err
        expect_text err "$reason"
    done
}

# A scene that takes no time.
small_scene() { printf 'set isosamples 8\nsplot x*y\n' >small.gp; }

run_tests() {
    failed=0
    for t in "$@"; do
        folder=$(mktemp -d)
        (
            cd "$folder" || exit 1
            set -e
            "$t"
        ) >"$folder.log" 2>&1
        rc=$?
        if [ $rc -eq 0 ]; then
            echo "[       OK ] $t"
            grep '^# ' "$folder.log"
        else
            cat "$folder.log"
            echo "[  FAILED  ] $t"
            failed=$((failed + 1))
        fi
        rm -rf "$folder" "$folder.log"
    done
    [ $failed -eq 0 ] || echo "[  FAILED  ] $failed test(s), listed above"
    exit $failed
}
