#!/bin/sh
# `set hidden3d area`: shadows and hatching, measured as ink. Seen from straight above and lit so that what is lit is not
# hatched, a box of 2 x 2 x 2 on a square of 8 x 8 has outlines of 40 units and a shadow of 1 x 2.
. tests/cli/lib.sh

ground() {
    printf 'v -4 -4 0\nv 4 -4 0\nv 4 4 0\nv -4 4 0\nf 1 2 3 4\n'
    printf 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 2\nv 1 -1 2\nv 1 1 2\nv -1 1 2\n'
    printf 'f 9 10 11 12\nf 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\nf 8 5 9 12\nf 8 7 6 5\n'
} >ground.obj

# ink COMMANDS: millimetres drawn
ink() {
    printf 'set view 0,0\nset hidden3d area\n%s\nsplot "ground.obj"\n' "$1" >ink.gp
    ridgeline plot ink.gp -o ink.seg 2>ink.err || { cat ink.err; return 1; }
    awk '/^#/ { next } NF == 4 { s += sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) } END { printf "%.3f", s }' ink.seg
}

# close A B PARTS: |A - B| within a thousandth of B times PARTS
close_to() { awk -v a="$1" -v b="$2" -v p="$3" 'BEGIN { d = a - b; exit !(d * d <= (b * p / 1000) ^ 2) }' || { echo "$1 is not $2"; return 1; }; }

shadow_is_hatched_crosswise() {
    ground
    lines=$(ink '')
    shade=$(ink 'set hatch 30,1; set light 0.5,0,1; set shadow')
    # two families of lines, 1 mm apart, over 2 units of area
    close_to "$(awk -v a="$shade" -v b="$lines" 'BEGIN { print a - b }')" \
        "$(awk -v b="$lines" 'BEGIN { s = b / 40; print 2 * 2 * s * s }')" 10
    echo "# test_area: $lines mm of outlines, $shade mm with its shadow"
}

without_shadow_lit_faces_stay_white() {
    ground
    lines=$(ink '')
    close_to "$(ink 'set hatch 30,1; set light 0.5,0,1')" "$lines" 0.01
    close_to "$(ink 'set hatch 30,1; set light 0.5,0,1; set shadow off')" "$lines" 0.01
    close_to "$(ink 'set hatch 30,1; set light 0.5,0,1; set shadow; unset hatch')" "$lines" 0.01
}

slopes_make_tones() {
    ground
    lines=$(ink '')
    all=$(awk -v b="$lines" 'BEGIN { s = b / 40; print 64 * s * s }')
    for light in 1,0,1:0.25 4,0,3:0.5 2,0,1:1 5,0,1:1.5 1,0,-1:2; do
        got=$(ink "set hatch 10,1; set light ${light%:*}")
        close_to "$(awk -v a="$got" -v b="$lines" 'BEGIN { print a - b }')" \
            "$(awk -v a="$all" -v k="${light#*:}" 'BEGIN { print a * k }')" 10
    done
}

faces_that_cut_through_each_other_are_reported() {
    printf 'v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\nv 1 -1 -1\nv 1 3 -1\nv 1.2 3 1\nv 1.2 -1 1\nf 5 6 7 8\n' >cut.obj
    printf 'set hidden3d area\nsplot "cut.obj"\n' >cut.gp
    ridgeline plot cut.gp -o cut.svg 2>err
    expect_text err 'cut through each other'
}

# pinwheel N: N bars around a circle, each rising over the next: no order of depth exists.
pinwheel() {
    awk -v n="$1" 'BEGIN { for (k = 0; k < n; k++) {
        a = 6.283185307 * k / n; b = 6.283185307 * (k + 1) / n
        x0 = cos(a) + .3 * (cos(a) - cos(b)); y0 = sin(a) + .3 * (sin(a) - sin(b))
        x1 = cos(b) + .3 * (cos(b) - cos(a)); y1 = sin(b) + .3 * (sin(b) - sin(a))
        l = sqrt((x1 - x0) ^ 2 + (y1 - y0) ^ 2); u = -(y1 - y0) / l * .2 / n; w = (x1 - x0) / l * .2 / n
        printf "v %f %f 0\nv %f %f 0\nv %f %f 1\nv %f %f 1\nf -4 -3 -2 -1\n", x0 + u, y0 + w, x0 - u, y0 - w, x1 - u, y1 - w, x1 + u, y1 + w
    } }' >ground.obj
}

cyclic_overlap_has_no_first() {
    for n in 3 4 12; do
        pinwheel $n
        area=$(ink '')
        convex=$(ink 'set hidden3d convex')
        all=$(ink 'set hidden3d none')
        close_to "$area" "$convex" 0.01
        awk -v a="$area" -v b="$all" 'BEGIN { exit !(a < .99 * b) }' || { echo "nothing was hidden"; return 1; }
        echo "# test_area: $n bars in a circle: $all mm, $area mm visible, $convex mm by the convex kernel"
    done
}

holes_are_holes() {
    printf 'v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nv 1 1 0\nv 3 1 0\nv 3 5 0\nv 1 5 0\nv 5 2 0\nv 7 2 0\nv 6 4 0\n' >ground.obj
    printf 'f 1 2 3 4 h 5 6 7 8 h 9 10 11\n' >>ground.obj
    lines=$(ink '')
    got=$(ink 'set hatch 10,0.5; set light 1,0,1')
    # borders of 32, 12 and 2 + 2 sqrt 5; an area of 64 - 8 - 2 with every fourth of two lines to the millimetre
    close_to "$(awk -v a="$got" -v b="$lines" 'BEGIN { print a - b }')" \
        "$(awk -v b="$lines" 'BEGIN { s = b / (46 + 2 * sqrt(5)); print 54 * s * s / 2 }')" 10
    close_to "$(ink 'set hidden3d convex')" "$lines" 0.01
    close_to "$(ink 'set hidden3d none')" "$lines" 0.01
    # a hole that is all of it leaves nothing
    for hole in '1 2 3 4' '3 4 1 2' '4 3 2 1'; do
        printf 'v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nf 1 2 3 4 h %s\nv 9 0 0\nv 9 1 0\nv 9 0 1\nf 5 6 7\n' "$hole" >ground.obj
        awk -v a="$(ink '')" 'BEGIN { exit !(a > 10 && a < 50) }' || { echo "a hole $hole"; return 1; }
    done
    printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 h 3 2\n' >bad.obj
    printf 'splot "bad.obj"\n' >bad.gp
    expect_status 2 ridgeline plot bad.gp -o bad.svg 2>err
    expect_text err 'line 4'
}

settings_are_answered() {
    printf 'set hatch 30\nset light 1,2,3\nset shadow\nshow hatch\nshow light\nshow shadow\nunset hatch\nshow hatch\n' >show.gp
    ridgeline plot show.gp >out 2>&1 || true
    expect_text out 'set hatch 30,1' 'set light 1,2,3' 'set shadow' 'unset hatch'
    for bad in 'set hatch' 'set hatch 400,1' 'set hatch 0,0.01' 'set light 0,0,0' 'set light 1,2' 'set shadow maybe'; do
        printf '%s\n' "$bad" >bad.gp
        ! ridgeline plot bad.gp >out 2>&1 || { echo "taken: $bad"; return 1; }
    done
}

run_tests cyclic_overlap_has_no_first holes_are_holes shadow_is_hatched_crosswise without_shadow_lit_faces_stay_white slopes_make_tones \
    faces_that_cut_through_each_other_are_reported settings_are_answered
