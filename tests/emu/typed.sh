# typed.sh - the board at a terminal (make try-pico, try-m3, try-microbit), its lines from a pipe; for the tests of the boards, after lib.sh.
try() {
    timeout 200 sh tests/emu/try.sh $board "$build" "test-$board" >"$work/emu.said" 2>&1
}
name=try
rm -f "$build/try/test-$board".*
printf 'set paper 40,40 margin 5; set isosamples 5\nsplot x*y\nprint 6*7\n' | try
says '^.[578] strokes in [0-9.]+ s of the machine'
says '^42'
# Rows of inline data without a pause, in two drawings, several times what the board keeps of what is typed, and lines while it prints
# long texts: the sender heeds XON/XOFF, nothing is lost.
name=flow
awk 'BEGIN { print "set paper 40,40 margin 5; set machine speed 100 travel 100 accel 3000 lift 0.01 lower 0.01"
    for (k = 0; k < 2; k++) {
        print "splot \x27-\x27"
        for (y = 0; y < 8; y++) { for (x = 0; x < 15; x++) print x, y, (x * y * (k + 1)) % 7; print "" }
        print "e" }
    print "help\nshow all"
    for (k = 0; k < 20; k++) print "print " 7000 + k
    print "memory\nprint 6*7" }' | try
says_times 2 '^.[0-9]* strokes in' 'two drawings of 120 rows'
says_times 20 '^70[01][0-9]' 'twenty lines behind long texts'
says '^42'
if grep -aqE 'error|warning|^line [0-9]' "$work/emu.said"; then bad "flow: something was lost"; cat "$work/emu.said"; fi
