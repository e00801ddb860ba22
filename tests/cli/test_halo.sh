#!/bin/sh
# test_halo.sh - haloed lines from outside: who is cut, by how much, in every kind of view; settings and messages.
. tests/cli/lib.sh

# A bar along x and one along y a unit above it, each two units long.
bars() {
    cat <<'END'
set paper 100,100
set hidden3d halo
END
    printf '%s\n' "$@"
    cat <<'END'
splot '-' solid
v -1 0 0
v 1 0 0
v 0 -1 .2
v 0 1 .2
l 1 2
l 3 4
e
END
}

drawn() { awk '!/^#/ && NF == 4 { print sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) }' "$1"; }
total() { drawn "$1" | awk '{ s += $1 } END { printf "%.3f", s }'; }

# From above the bar along x is the farther one, from below the other; W to either side, whatever the view.
test_who_is_cut() {
    for view in "set view 0,0" "set view from 0,0,9" "set view from 0,0,90"; do
        bars "$view" "set halo 2" >a.gp
        ridgeline plot a.gp -o a.seg
        # the gap is 4 mm, and it is in the horizontal line
        awk '!/^#/ && NF == 4 { h = ($4 - $2) ^ 2 < 1e-6; n[h]++ } END { exit !(n[1] == 2 && n[0] == 1) }' a.seg
        bars "$view" "set halo 0" >b.gp
        ridgeline plot b.gp -o b.seg
        awk "BEGIN { d = $(total b.seg) - $(total a.seg) - 4; exit !(d * d < 1e-4) }"
    done
    for view in "set view 180,0" "set view from 0,0,-9"; do
        bars "$view" "set halo 2" >a.gp
        ridgeline plot a.gp -o a.seg
        awk '!/^#/ && NF == 4 { h = ($4 - $2) ^ 2 < 1e-6; n[h]++ } END { exit !(n[1] == 1 && n[0] == 2) }' a.seg
    done
}

# A gap that is seen from one side stays in its place in perspective: the crossing is not in the middle of the bar there.
test_perspective_place() {
    cat >p.gp <<'END'
set paper 200,100
set hidden3d halo
set halo 1
set view from 0,-4,.01 to 0,0,0
splot '-' solid
v -1 0 -1
v 1 8 1
v -.2 -1 -1
v -.2 -1 1
l 1 2
l 3 4
e
END
    ridgeline plot p.gp -o p.seg
    # the slanting bar ends 1 / sin before the upright one, on both sides
    awk '!/^#/ && NF == 4 {
        dx = $3 - $1; dy = $4 - $2
        if (dx * dx < 1e-2) { x = ($1 + $3) / 2; next }
        l[n++] = $1; l[n++] = $3
    } END {
        for (k = 0; k < n; k++) { d = l[k] - x; if (d * d < 4) { g = d * d; if ((sqrt(g) - 1) ^ 2 < 1e-4) good++ } }
        exit good != 2
    }' p.seg
}

# Zero is the plain wire frame; a surface of a function has a halo too, and shows more of itself with a narrower one.
test_surface() {
    for w in 0 0.3 0.6 1.2; do
        printf 'set isosamples 20\nset view from 6,8,3\nset xrange [-2:2]; set yrange [-2:2]\nset hidden3d halo\nset halo %s\nsplot exp(-x**2-y**2)\n' $w >s.gp
        ridgeline plot s.gp -o s.seg
        echo "$(total s.seg)"
    done >lengths
    sed -e 's/set halo.*//' -e 's/set hidden3d halo/unset hidden3d/' -e 's/^set isosamples.*/set isosamples 20; set samples 20/' s.gp >n.gp
    ridgeline plot n.gp -o n.seg
    awk -v all="$(total n.seg)" 'NR == 1 { if (($1 - all) ^ 2 > 1) exit 1 } NR > 1 { if ($1 >= last) exit 1 } { last = $1 }' lengths
    sed 's/set view from 6,8,3/set view 50,40/' s.gp >r.gp
    ridgeline plot r.gp -o r.seg
}

# The order of the lines in the file does not matter.
test_order() {
    ridgeline plot "$scenes/pylon.gp" -o a.seg
    grep -v '^l' "$scenes/pylon.obj" >pylon.obj
    grep '^l' "$scenes/pylon.obj" | awk '{ print "l", $3, $2 }' | sort -r >>pylon.obj
    cp "$scenes/pylon.gp" .
    ridgeline plot pylon.gp -o b.seg
    awk "BEGIN { d = $(total a.seg) - $(total b.seg); exit !(d * d < .01) }"
}

test_ends() {
    cat >e.gp <<'END'
set paper 100,100
set view 0,0
set hidden3d halo
splot '-' solid
v -1 0 0
v 1 0 0
v 0 .02 .2
v 0 1 .2
l 1 2
l 3 4
e
END
    ridgeline plot --set 'set halo 2' e.gp -o a.seg
    [ "$(drawn a.seg | wc -l)" -eq 2 ]
    ridgeline plot --set 'set halo 2 ends' e.gp -o b.seg
    [ "$(drawn b.seg | wc -l)" -eq 3 ]
}

test_messages() {
    for bad in 'set halo' 'set halo 0.001' 'set halo -1' 'set halo 200' 'set halo 1 foo' 'set halo 1,2'; do
        echo "$bad" >m.gp
        expect_status 2 ridgeline plot m.gp 2>said
        expect_text said 'line 1, column'
    done
    printf 'set halo 0.8 ends\nshow halo\nset halo 0.25\nshow halo\nset halo ends\nshow halo\nunset halo\nshow halo\n' >m.gp
    ridgeline plot m.gp >said
    printf 'set halo 0.8 ends\nset halo 0.25\nset halo 0.25 ends\nset halo 0.5\n' | cmp - said
}

run_tests test_who_is_cut test_perspective_place test_surface test_order test_ends test_messages
