#!/bin/sh
# Pens, outlines and creases of solids, measured as ink.
. tests/cli/lib.sh

# A cube as seen along (1, 1, 1): nine edges of the same length on the page, six of them the outline.
cube() {
    printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n'
    printf 'f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n'
} >cube.obj

# ink PEN COMMANDS: millimetres drawn with a pen, 0 for any
ink() {
    printf 'set view from 1e6,1e6,1e6 to 0,0,0\n%s\nsplot "cube.obj"\n' "$2" >ink.gp
    ridgeline plot ink.gp -o ink.seg 2>ink.err || { cat ink.err; return 1; }
    awk -v want="$1" 'BEGIN { pen = 1 } /^# pen/ { pen = $3 } /^#/ { next }
        NF == 4 && (want == 0 || want == pen) { s += sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) } END { printf "%.3f", s }' ink.seg
}

# ratio A B N/M: A / B within a thousandth
ratio() { awk -v a="$1" -v b="$2" -v n="$3" -v m="$4" 'BEGIN { d = a * m - b * n; exit !(b > 0 && d * d <= (b * m / 1000) ^ 2) }' || { echo "$1 is not $3/$4 of $2"; return 1; }; }

pens_take_their_lines() {
    cube
    for kernel in area convex; do
        all=$(ink 0 "set hidden3d $kernel")
        pens='set pen silhouette 2 crease 3'
        ratio "$(ink 0 "set hidden3d $kernel; $pens")" "$all" 9 9
        ratio "$(ink 2 "set hidden3d $kernel; $pens")" "$all" 6 9
        ratio "$(ink 3 "set hidden3d $kernel; $pens")" "$all" 3 9
        ratio "$(ink 1 "set hidden3d $kernel; set pen silhouette 2")" "$all" 3 9
        ratio "$(ink 4 "set hidden3d $kernel; set pen 4")" "$all" 9 9
    done
    dashed='set view 60,30; set hidden3d convex dashed; set pen hidden 5'
    behind=$(ink 5 "$dashed")
    ratio "$(ink 1 "$dashed")" "$(ink 0 'set view 60,30; set hidden3d convex')" 1 1
    awk -v a="$behind" -v b="$(ink 1 "$dashed")" 'BEGIN { exit !(a > .1 * b) }'
    echo "# test_tone: $all mm, $(ink 2 'set hidden3d area; set pen silhouette 2') mm of outline"
}

outlines_leave_creases_out() {
    cube
    all=$(ink 0 'set hidden3d area')
    for kernel in area convex none; do
        lines=$(ink 0 "set hidden3d $kernel")
        ratio "$(ink 0 "set hidden3d $kernel outline")" "$all" 6 9
        ratio "$(ink 0 "set hidden3d $kernel outline; set crease 80")" "$lines" 1 1
        ratio "$(ink 0 "set hidden3d $kernel; set crease 80")" "$lines" 1 1
    done
}

# A prism of 24 sides from the side: its creases are of 15 degrees.
creases_by_angle() {
    awk 'BEGIN { for (k = 0; k < 24; k++) { a = 6.283185307 * k / 24; printf "v %.9f %.9f -1\nv %.9f %.9f 1\n", cos(a), sin(a), cos(a), sin(a) }
        for (k = 0; k < 24; k++) printf "f %d %d %d %d\n", 2 * k + 1, 2 * ((k + 1) % 24) + 1, 2 * ((k + 1) % 24) + 2, 2 * k + 2
        printf "f"; for (k = 23; k >= 0; k--) printf " %d", 2 * k + 1; printf "\nf"; for (k = 0; k < 24; k++) printf " %d", 2 * k + 2; print "" }' >cube.obj
    for kernel in area convex; do
        a=$(ink 0 "set hidden3d $kernel") b=$(ink 0 "set hidden3d $kernel; set crease 20")
        c=$(ink 0 "set hidden3d $kernel outline; set crease 20") d=$(ink 0 "set hidden3d $kernel outline")
        awk -v a="$a" -v b="$b" -v c="$c" -v d="$d" 'BEGIN { exit !(a > 1.2 * b && b > 1.1 * d && (b - c) ^ 2 < 1e-4) }' || { echo "$a $b $c $d"; return 1; }
    done
}

# A box of 2 x 2 x 2 on a square of 12 x 12, from straight above: a unit is s mm.
ground() {
    printf 'v -6 -6 0\nv 6 -6 0\nv 6 6 0\nv -6 6 0\nf 1 2 3 4\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 2\nv 1 -1 2\nv 1 1 2\nv -1 1 2\n'
    printf 'f 9 10 11 12\nf 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\nf 8 5 9 12\nf 8 7 6 5\n'
} >cube.obj

above='set view 0,0; set hidden3d area; set shadow outline; set pen shadow 2 hatch 3'

# Shadows to the four sides, of 2 x 1 each, have borders of 2 + 1 + 1 each, and none where they meet the box.
lights_cast_shadows_of_their_own() {
    ground
    s=$(awk -v l="$(ink 1 "$above")" 'BEGIN { print l / 56 }')
    side=$(awk -v s="$s" 'BEGIN { print 4 * s }')
    lights='set light 1,0,2' n=1
    ratio "$(ink 2 "$above; $lights")" "$side" 1 1
    for more in 2:-1,0,2 3:0,1,2 4:0,-1,2; do
        lights="$lights; set light ${more%:*} ${more#*:}" n=$((n + 1))
        ratio "$(ink 2 "$above; $lights")" "$side" $n 1
    done
    ratio "$(ink 2 "$above; $lights; unset light 2")" "$side" 3 1
    ratio "$(ink 2 "$above; $lights; unset light; set light 1,0,2")" "$side" 1 1
    echo "# test_tone: $n lights, borders of shadows of $(ink 2 "$above; $lights") mm, $(awk -v s="$side" -v n=$n 'BEGIN { printf "%.3f", s * n }') mm by arithmetic"
}

# The same box on a strip that reaches 205 behind it. A light that falls in flatly makes shadows of 200, or to the end of the strip,
# with a border on both sides; one that does not fall in at all makes none.
grazing_light_casts_long_shadows() {
    ground
    sed 's/^v 6 -6 0/v 206 -6 0/; s/^v 6 6 0/v 206 6 0/' cube.obj >strip.obj && mv strip.obj cube.obj
    s=$(awk -v l="$(ink 1 "$above")" 'BEGIN { print l / 456 }')
    for case in 100,0,1:402 200,0,1:410 1e3,0,1:410 2e3,0,1:410 1,0,0:0 1,0,-1e-6:0; do
        got=$(ink 2 "$above; set light -${case%:*}")
        awk -v a="$got" -v b="$s" -v n="${case#*:}" 'BEGIN { exit !((a - n * b) ^ 2 <= (.001 * b) ^ 2) }' || { echo "light -${case%:*}: $got"; return 1; }
    done
    echo "# test_tone: a light at 1 to 100, a shadow bordered by $(ink 2 "$above; set light -100,0,1") mm, $(awk -v s="$s" 'BEGIN { printf "%.3f", 402 * s }') mm by arithmetic"
}

# Two lights from one side, one lower: the shorter shadow lies in the longer one, and is darker.
shadows_overlap() {
    ground
    two="$above; set hatch 20,1; set light 1,0,2; set light 2 1,0,1"
    s=$(awk -v l="$(ink 1 "$above")" 'BEGIN { print l / 56 }')
    # borders: 2 + 2 x 1 of the short one, 2 + 2 x 2 of the long one, of which the short one's sides are drawn once
    ratio "$(ink 2 "$two")" "$(awk -v s="$s" 'BEGIN { print 8 * s }')" 1 1
    # of at most 1.97: 2 x 1 without any light are hatched crosswise, 2 x 1 with .894 every second line, all else with 1.60 every fourth
    got=$(ink 3 "$two")
    awk -v a="$got" -v s="$s" 'BEGIN { b = (4 + 1 + 140 / 4) * s * s; exit !((a - b) ^ 2 < (.02 * b) ^ 2) }' || { echo "$got, s $s"; return 1; }
}

# A lamp at height 4 right above the box's side: its shadow is as in perspective.
lamps_cast_shadows_too() {
    ground
    s=$(awk -v l="$(ink 1 "$above")" 'BEGIN { print l / 56 }')
    # the corners p of the roof fall on p + (p - (20,0,22)) / 10: (-3.1, 1.1), (-0.9, 1.1) and so on; from there to (1, 1)
    ratio "$(ink 2 "$above; set light from 20,0,22")" \
        "$(awk -v s="$s" 'BEGIN { print s * (2.2 + 2 * (2.2 + sqrt(1.9 ^ 2 + .1 ^ 2))) }')" 1 1
    expect_status 2 ridgeline_lamp 'set light from 0,0,1'
    expect_text ink.err 'outside of the scene'
}

ridgeline_lamp() {
    printf '%s\n%s\nsplot "cube.obj"\n' "$above" "$1" >lamp.gp
    ridgeline plot lamp.gp -o lamp.svg 2>ink.err
}

# Seen from straight above, what is lit from the side by a plane z = x has one tone, by arithmetic.
surfaces_are_shaded() {
    # strokes PEN COMMANDS EXPRESSION
    strokes() {
        printf 'set isosamples 9\nset xrange [0:1]\nset yrange [0:1]\nset zrange [-1:1]\n%s\nsplot %s\n' "$2" "$3" >shade.gp
        ridgeline plot shade.gp -o shade.seg 2>ink.err || { cat ink.err; return 1; }
        awk -v want="$1" 'BEGIN { pen = 1 } /^# pen/ { pen = $3 } /^#/ { next }
            NF == 4 && (want == 0 || want == pen) { s += sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) } END { printf "%.3f", s }' shade.seg
    }
    view='set view 0,0; set hatch 30,0.5; set pen hatch 2; set border 0; unset tics'
    area=$(strokes 2 "$view; set light 0,0,-1" x*0 | awk '{ print $1 / 4 }') # both families: 4 mm to the square millimetre
    for case in 0,0,1:0 1,0,1:0.5 5,0,4:1 2,0,1:2 5,0,1:3 1,0,0:4; do
        got=$(strokes 2 "$view; set light ${case%:*}" x*0)
        awk -v a="$got" -v b="$area" -v k="${case#*:}" 'BEGIN { exit !((a - k * b) ^ 2 <= (.01 * b) ^ 2) }' || { echo "light ${case%:*}: $got, area $area"; return 1; }
    done
    # nothing but the border, and all of the grid
    ratio "$(strokes 1 "$view; set hidden3d outline" x*0)" "$(strokes 1 "$view" x*0)" 4 18
    echo "# test_tone: a flat surface of $area mm^2 in six tones"
    # with a hole the hatching has one too
    awk -v a="$(strokes 2 "$view; set light 0,0,-1" '(x-.5)**2+(y-.5)**2 < .01 ? NaN : 0')" -v b="$area" 'BEGIN { exit !((a - b * 4 * 60 / 64) ^ 2 < (.01 * b) ^ 2) }'
}

# Between two lamps a sheet has the same tones wherever that is.
lamps_are_weighed_at_the_sheet() {
    sheet() { # x of its left border
        printf 'set xrange [%d:%d]\nset yrange [0:10]\nset zrange [-5:5]\nset hatch 30,1\nset hidden3d outline\nset pen hatch 2\n' "$1" $(($1 + 10))
        printf 'set light from %d,5,10\nset light 2 from %d,5,10\nset view 45,30\nsplot 0*x\n' $(($1 - 5)) $(($1 + 15))
    }
    for at in 0 1000; do
        sheet $at >far.gp
        ridgeline plot far.gp -o $at.seg
        awk '/^# pen/ { pen = $3 } /^#/ { next } pen == 2 { s += sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) } END { printf "%.1f", s }' $at.seg >$at.mm
    done
    cmp 0.mm 1000.mm
}

# A bowed sheet, its cells not flat, with a box over it: the shadow's border is one closed line, and no edge of a cell is.
surfaces_take_shadows() {
    cube
    scene() {
        printf 'set view from 5,-9,30 to 0,0,0\nset hidden3d area\nset shadow outline\nset pen shadow 2\nset isosamples 20\n%s\n' "$1" >mixed.gp
        printf 'splot [-4:4][-4:4] %s\n' "$2" >>mixed.gp
        ridgeline plot mixed.gp -o mixed.seg 2>ink.err && [ ! -s ink.err ] || { cat ink.err; return 1; }
        awk 'BEGIN { pen = 1 } /^# pen/ { pen = $3 } /^#/ { next }
            NF == 4 && pen == 2 { s += sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) } END { printf "%.3f", s }' mixed.seg
    }
    with=$(scene 'set light 1,1,3' '.05*x*y, "cube.obj" translate -0.5,-0.5,2')
    flat=$(scene 'set light 1,1,3' '0*x*y, "cube.obj" translate -0.5,-0.5,2')
    without=$(scene 'set light 1,1,3' '.05*x*y, "cube.obj" scale 0.001')
    awk -v a="$without" 'BEGIN { exit !(a < .5) }' # no edge of a cell
    awk -v a="$with" -v b="$flat" 'BEGIN { exit !(a > 20 && (a - b) ^ 2 < (.1 * b) ^ 2) }' || { echo "$with, $flat"; return 1; }
    echo "# test_tone: the border of a box's shadow on a bowed sheet is $with mm long"
}

# A saddle, whose cells are all twisted, seen from so low that it is folded: its outline is closed, so every upright line
# through it meets it at least twice.
outlines_of_surfaces_are_closed() {
    for kernel in outline 'area outline; set shadow' 'area outline; set hatch 30,1; set shadow'; do
        for n in 5 10 21 40; do
            printf 'set view from 30,-22,18\nset isosamples %d\nset pen hatch 2\nset hidden3d %s\nsplot [-3:3][-3:3] x*y/4\n' $n "$kernel" >outline.gp
            ridgeline plot outline.gp -o outline.seg
            awk '/^# pen/ { pen = $3 } /^#/ || NF != 4 || pen == 2 { next }
                { a = $1 < $3 ? $1 : $3; b = $1 + $3 - a; n++; x0[n] = a; x1[n] = b; lo = n == 1 || a < lo ? a : lo; hi = b > hi ? b : hi }
                END { for (k = 1; k < 400; k++) { x = lo + (hi - lo) * (k + .01) / 400; c = 0
                    for (i = 1; i <= n; i++) c += x0[i] < x && x <= x1[i]
                    if (c < 2) { print "the outline is open at " x " mm"; exit 1 } } }' outline.seg || { echo "$kernel, $n"; return 1; }
        done
    done
}

# A sheet of 4 x 4 over one of 2 x 2 that it covers by half, from straight above; dashes by arithmetic: 2 mm and gaps of 1.5.
glass_is_looked_through() {
    printf 'v -2 -2 2\nv 2 -2 2\nv 2 2 2\nv -2 2 2\nf 1 2 3 4\n' >glass.obj
    printf 'v 1 -1 0\nv 3 -1 0\nv 3 1 0\nv 1 1 0\nf 1 2 3 4\n' >cube.obj
    look='set view 0,0; set hidden3d area; set pen hidden 5 hatch 3'
    # ink with the sheet in front; `splot "cube.obj"` is put behind the last command
    solid="$look; splot 'glass.obj', 'cube.obj'; set pen 8"
    clear="$look; splot 'glass.obj' translucent, 'cube.obj'; set pen 8"
    first() { # pen, commands: the first page only
        ink 0 "$2" >/dev/null
        awk -v want="$1" 'BEGIN { pen = 1 } /^# pen/ { pen = $3 } /^#/ { next }
            NF == 4 && (want == 0 || want == pen) { s += sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) } END { printf "%.3f", s }' ink.seg
    }
    s=$(awk -v l="$(first 0 "$solid")" 'BEGIN { print l / 20 }')
    ratio "$(first 1 "$clear")" "$(first 0 "$solid")" 1 1
    got=$(first 5 "$clear")
    awk -v s="$s" -v got="$got" 'function dashes(l, n) { n = int((l + 1.5) / 3.5); return l * 4 * n / (7 * n - 3) }
        BEGIN { b = dashes(2 * s) + 2 * dashes(s); exit !((got - b) ^ 2 < .01) }' || { echo "$got, s $s"; return 1; }
    # what is behind is hatched as ever, crosswise 4 s^2; the glass with every fourth line, which are there already behind 2 s^2 of it
    got=$(first 3 "set hatch 20,0.5; set shadow; set light 0,0,-1; $clear")
    awk -v s="$s" -v got="$got" 'BEGIN { b = 2 * (2 * 4 + (16 - 2) / 4) * s * s; exit !((got - b) ^ 2 < (.01 * b) ^ 2) }' || { echo "hatch $got, s $s"; return 1; }
    # lit from above the sheet below is not hatched, though the glass is in the way
    got=$(first 3 "set hatch 20,0.5; set shadow; set light 0,0,1; $clear")
    awk -v s="$s" -v got="$got" 'BEGIN { b = 2 * 4 * s * s; exit !((got - b) ^ 2 < (.01 * b) ^ 2) }' || { echo "lit $got, s $s"; return 1; }
    printf 'splot x*y translucent\n' >bad.gp
    ! ridgeline plot bad.gp >out 2>&1
    expect_text out 'column'
}

# A box with a pane for a front and a stick in it: by the names of materials, groups and objects, in a file and inline.
glass_has_a_name() {
    printf 'v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 4\nv 4 0 4\nv 4 4 4\nv 0 4 4\nv 1 2 2\nv 3 2 2\nl 9 10\n' >body
    printf 'f 1 2 3 4\nf 5 6 7 8\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n' >walls
    printf 'f 1 2 6 5\n' >front
    { cat body; printf 'usemtl stone\n'; cat walls; printf 'usemtl clear-glass\n'; cat front; } >material.obj
    { cat body; printf 'g front pane\n'; cat front; printf 'g\n'; cat walls; } >group.obj
    { cat body; printf 'o pane\n'; cat front; printf 'o stone\n'; cat walls; } >object.obj
    { cat body; printf 'usemtl clear-glass\no pane\n'; cat front; printf 'o stone\n'; cat walls; } >both.obj
    drawn() { # elements
        printf 'set view from 2,-20,9\nset hidden3d area\nset pen hidden 2\nset hatch 30,1\nset shadow\nset light -1,-3,2\nsplot %s\n' "$1" >ink.gp
        ridgeline plot ink.gp -o ink.seg 2>ink.err || { cat ink.err; return 1; }
        [ ! -s ink.err ] && grep -v '^#' ink.seg | sort >"$2"
    }
    drawn "'material.obj'" solid.seg
    drawn "'material.obj' translucent 'wood' 'clear-glass'" material.seg
    drawn "'group.obj' translucent 'pane'" group.seg
    drawn "'object.obj' translucent 'pane'" object.seg
    cmp material.seg group.seg && cmp material.seg object.seg
    [ "$(wc -l <material.seg)" -gt "$(wc -l <solid.seg)" ]
    # the material goes on behind the next object: all of it is clear then
    drawn "'both.obj' translucent 'clear-glass'" both.seg
    drawn "'both.obj' translucent" all.seg
    cmp both.seg all.seg
    { printf 'set view from 2,-20,9\nset hidden3d area\nset pen hidden 2\nset hatch 30,1\nset shadow\nset light -1,-3,2\n'
        printf "splot '-' solid translucent 'pane'\n"; cat group.obj; printf 'e\n'; } >ink.gp
    ridgeline plot ink.gp -o ink.seg && grep -v '^#' ink.seg | sort | cmp - group.seg
    printf "set hidden3d area\nsplot 'group.obj' translucent 'pain'\n" >bad.gp
    ridgeline plot bad.gp >out 2>&1
    expect_text out 'no face in the data belongs to pain'
    printf "splot 'group.obj' translucent ''\n" >bad.gp
    expect_status 2 ridgeline plot bad.gp >out 2>&1
    expect_text out 'line 1, column 31' 'the name of a group'
}

# A square of 4 x 4 with a line of 6 on it, of which it shows 4, a square of 1 x 1, and a line that is beside it; a smaller
# sheet in front hides 1 of the line and half of the square.
details_end_with_their_face() {
    printf 'v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nf 1 2 3 4\nv -3 1 0\nv 3 1 0\nv 0 -1 0\nv 1 -1 0\nv 1 0 0\nv 0 0 0\nv 3 -2 0\nv 3 2 0\n' >cube.obj
    printf 'd 5 6\nd 7 8 9 10 7\nd 11 12\n' >>cube.obj
    printf 'v -0.5 -1.5 1\nv 0.5 -1.5 1\nv 0.5 1.5 1\nv -0.5 1.5 1\nf 1 2 3 4\n' >front.obj
    look='set view 0,0; set hidden3d area; set pen detail 2'
    first() { # pen, commands, elements
        printf '%s\nsplot %s\n' "$2" "$3" >ink.gp
        ridgeline plot ink.gp -o ink.seg 2>ink.err || { cat ink.err; return 1; }
        awk -v want="$1" 'BEGIN { pen = 1 } /^# pen/ { pen = $3 } /^#/ { next }
            NF == 4 && (want == 0 || want == pen) { s += sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) } END { printf "%.3f", s }' ink.seg
    }
    ratio "$(first 2 "$look" '"cube.obj"')" "$(first 1 "$look" '"cube.obj"')" 8 16
    ratio "$(first 2 "$look" '"cube.obj", "front.obj"')" "$(first 1 "$look" '"cube.obj", "front.obj"')" 5 24
    # seen from behind it is there too: both sides of an open face may be; from the side it is not
    ratio "$(first 2 "$look; set view 180,0" '"cube.obj"')" "$(first 1 "$look; set view 180,0" '"cube.obj"')" 8 16
    # other kernels take them for lines
    ratio "$(first 0 "set view 0,0" '"cube.obj"')" "$(first 1 "$look" '"cube.obj"')" 30 16
    printf 'v 0 0 0\nv 1 0 0\nd 1 2\nf 1 2 1\n' >bad.obj
    printf 'splot "bad.obj"\n' >bad.gp
    expect_status 2 ridgeline plot bad.gp -o bad.svg 2>err
    expect_text err 'line 3' 'a face before it'
}

# A square of 8 x 8, lit squarely, so without hatching, with a patch of 4 x 4 that has a hole of 2 x 2 and a smaller one
# on it; hatch lines of a tone are so many a pitch. A wall throws its shadow on half of it.
patches_have_tones() {
    printf 'v -4 -4 0\nv 4 -4 0\nv 4 4 0\nv -4 4 0\nf 1 2 3 4\n' >square.obj
    printf 'v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n' >>square.obj
    lit='set view 0,0; set hidden3d area; set pen hatch 3 detail 2; set hatch 30,0.4; set light 0,0,1'
    hatched() { # detail lines, lines a pitch, area, more commands, length of edges
        { cat square.obj; printf '%s\n' "$1"; } >cube.obj
        s=$(awk -v l="$(ink 1 "$lit")" 'BEGIN { print l / '"${5:-32}"' }')
        awk -v l="$(ink 3 "$lit; $4")" -v s="$s" -v n="$2" -v a="$3" 'BEGIN { want = n * a * s * s / .4; print "# test_tone: " l " mm of hatching, " want
            exit !((l - want) ^ 2 <= (.02 * want) ^ 2) }'
    }
    hatched 'd 5 6 7 8 h 9 10 11 12' 0 0
    hatched 'd 5 6 7 8 tone 100' 0 0
    hatched 'd 5 6 7 8 tone 60' .5 16
    hatched 'd 5 6 7 8 h 9 10 11 12 tone 60' .5 12
    hatched 'd 5 6 7 8 h 9 10 11 12 tone 20' 1.5 12
    hatched 'd 5 6 7 8 h 12 11 10 9 tone 0' 2 12
    hatched "d 5 6 7 8 tone 60
d 9 10 11 12 tone 30" .625 16 # .5 of 12 and 1 of 4
    # closed, whether it says so or not: outlines of 16 and 8
    ratio "$(ink 2 "$lit")" "$(ink 1 "$lit")" 24 32
    { cat square.obj; printf 'd 5 6 7 8 5 h 9 10 11 12 9 tone 60\n'; } >cube.obj
    ratio "$(ink 2 "$lit")" "$(ink 1 "$lit")" 24 32
    # light from (1, 0, 1) past a wall of 8 x 2: 16 in its shadow, dark whatever is there, 8 of the patch at .6 of .707
    hatched 'd 5 6 7 8 tone 60
v 2 -4 0
v 2 4 0
v 2 4 2
v 2 -4 2
f 13 14 15 16' 50 1 'set shadow; set light 1,0,1' 40 # 2 of 16, 1 of 8, .25 of 40
    for bad in 'd 5 6 7 tone' 'd 5 6 7 tone 101' 'd 5 6 7 tone 5 5' 'd 5 6 7 tone -1'; do
        { cat square.obj; printf '%s\n' "$bad"; } >bad.obj
        printf 'splot "bad.obj"\n' >bad.gp
        expect_status 2 ridgeline plot bad.gp -o bad.svg 2>err
        expect_text err 'column 1' 'a tone is one number from 0 to 100'
    done
}

settings_are_answered() {
    printf 'show pen\nset pen 3\nshow pen\nset pen hatch 2, shadow 8\nshow pen\nset crease 30.5\nshow crease\nset hidden3d area outline\nshow hidden3d\n' >show.gp
    printf 'unset pen\nunset crease\nset hidden3d area silhouette\nshow pen\nshow crease\nunset hidden3d\nset hidden3d area\nshow hidden3d\nhelp pen\nhelp crease\n' >>show.gp
    ridgeline plot show.gp >out 2>&1 || true
    expect_text out 'set pen 1' 'set pen 3' 'set pen crease 3 silhouette 3 hidden 3 hatch 2 shadow 8 detail 3' 'set crease 30.5' \
        'set hidden3d area outline' 'set crease 0' 'set pen N'
    printf 'set light 2 -1,-2,3\nset light 3 from 1,2,3.5\nshow light\nunset light 1\nshow light\nunset light\nshow light\nset light 2-1,2,3\nshow light\nset shadow outline\nshow shadow\n' >show.gp
    ridgeline plot show.gp >out 2>&1 || true
    expect_text out 'set light 2 -1,-2,3' 'set light 3 from 1,2,3.5' 'set light -1,-2,3' 'set light 1,2,3' 'set shadow outline'
    for bad in 'set light 5 1,2,3' 'set light 0 1,2,3' 'set light 2' 'set light from 1,2' 'unset light x' 'unset light 5' 'set shadow outlines' 'set pen' 'set pen 0' 'set pen 9' 'set pen hatch' 'set pen ink 2' 'set pen hatch 2 3' 'set crease' 'set crease 90' 'set hidden3d area outlines'; do
        printf '%s\n' "$bad" >bad.gp
        ! ridgeline plot bad.gp >out 2>&1 || { echo "taken: $bad"; return 1; }
        expect_text out 'bad.gp", line 1, column'
    done
}

run_tests pens_take_their_lines outlines_leave_creases_out creases_by_angle lights_cast_shadows_of_their_own grazing_light_casts_long_shadows shadows_overlap lamps_cast_shadows_too surfaces_are_shaded lamps_are_weighed_at_the_sheet surfaces_take_shadows outlines_of_surfaces_are_closed glass_is_looked_through glass_has_a_name details_end_with_their_face patches_have_tones settings_are_answered
