#!/bin/sh
# Solids from outside: files of three formats, moved, among surfaces, with mistakes.
. tests/cli/lib.sh
case ${BUILDDIR:=build} in /*) ;; *) BUILDDIR=$root/$BUILDDIR ;; esac

ink() { awk 'NR > 1 { s += sqrt(($1-$3)^2 + ($2-$4)^2) } END { printf "%.3f\n", s }' "$1"; }
# near A B: equal to 0.05 mm
near() { awk "BEGIN { d = $1 - $2; exit !(d < 0.05 && d > -0.05) }" || { echo "ink $1 and $2 mm"; return 1; }; }

cube() {
    printf 'o cube\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n'
    printf 'f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n'
}

# Convex against perimeter: the cells of a(x)+b(y) are flat, so both know the same surface. (A wire too short to see makes
# it a scene of solids.)
a_surface_of_facets_is_the_surface() {
    for view in 'from 12,-14,9 to 0,0,0' 'from 9,3,2 to 0,0,0' 'from 1,-7,0 to 0,0,0' 'from 2,1,5 to 0,0,-1' 60,30 75,110; do
        printf 'set xrange [-4:4]; set yrange [-4:4]; set isosamples 30; set view %s\nunset border; unset tics
f(x,y) = sin(2*x)*.8 + cos(y)*.7\nsplot f(x,y)\nsplot f(x,y), "-" solid\nv 0 0 0\nv 0 0 .00001\nl 1 2\ne\n' "$view" >s.gp
        ridgeline plot s.gp -o s.seg 2>/dev/null
        near "$(ink s.seg)" "$(ink s-2.seg)"
        echo "# $view: perimeter $(ink s.seg) mm, convex $(ink s-2.seg) mm"
    done
}

formats_are_the_same_body() {
    cube >a.obj
    awk '/^v/ { x[++n] = $2 " " $3 " " $4 }
         /^f/ { for (k = 3; k < 5; k++) print " facet normal 0 0 0\n outer loop\n vertex " x[$2] "\n vertex " x[$k] "\n vertex " \
                    x[$(k+1)] "\n endloop\n endfacet" }' a.obj | { echo solid s; cat; echo endsolid s; } >a.stl
    awk 'BEGIN { print "COFF\n8 6 12" } /^v/ { print $2, $3, $4, "255 0 0 255" } /^f/ { print 4, $2-1, $3-1, $4-1, $5-1 }' a.obj >c.off
    awk 'BEGIN { print "OFF # a cube\n8 6 12" } /^v/ { print $2, $3, $4 } /^f/ { print 4, $2-1, $3-1, $4-1, $5-1, "1 0 0" }' a.obj >a.off
    for f in obj stl off; do
        echo "splot 'a.$f' rotate 10,20,30 translate 1,2,3 scale 2" >a.gp
        ridgeline plot a.gp -o $f.seg
    done
    sed -i 's/a.off/c.off/' a.gp
    ridgeline plot a.gp -o c.seg
    cmp off.seg c.seg
    near "$(ink obj.seg)" "$(ink off.seg)"
    near "$(ink obj.seg)" "$(ink stl.seg)" # its diagonals are no edges
    [ "$(sed 1d obj.seg | wc -l)" -ge 9 ]
}

a_binary_stl_is_read() {
    { # a tetrahedron: little-endian floats, of 0, 1
        o='\0\0\0\0' i='\0\0\200\77' n='\0\0\0\0\0\0\0\0\0\0\0\0'
        printf 'solid but binary'; head -c 64 /dev/zero; printf '\4\0\0\0'
        printf "$n$o$o$o$o$i$o$i$o$o\0\0"; printf "$n$o$o$o$i$o$o$o$o$i\0\0"
        printf "$n$o$o$o$o$o$i$o$i$o\0\0"; printf "$n$i$o$o$o$i$o$o$o$i\0\0"
    } >t.STL
    [ "$(wc -c <t.STL)" -eq 284 ]
    echo "splot 't.STL'" >t.gp
    ridgeline plot t.gp -o t.seg
    [ "$(sed 1d t.seg | wc -l)" -ge 5 ]
}

what_is_wrong_is_said() {
    printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 z\n' >a.stl
    echo 'splot "a.stl"' >a.gp
    expect_status 2 ridgeline plot a.gp -o a.svg 2>err
    expect_text err '"a.stl", line 4, column 12: not a number'
    printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n' >a.off
    echo 'splot "a.off"' >a.gp
    expect_status 2 ridgeline plot a.gp -o a.svg 2>err
    expect_text err '"a.off", line 6, column 7: there is no vertex of this number'
    printf 'v 0 0 0\nv 1 0 0\nf 1 2 7\n' >a.obj
    echo 'splot "a.obj"' >a.gp
    expect_status 2 ridgeline plot a.gp -o a.svg 2>err
    expect_text err 'line 3, column 7: there is no vertex of this number'
    printf 'v 0 0 0\nv 1 0 0\nf 1 2\n' >a.obj
    expect_status 2 ridgeline plot a.gp -o a.svg 2>err
    expect_text err 'line 3, column 6: this line lacks a number'
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\033[2Jx\n' >a.obj
    ridgeline plot a.gp -o b.svg 2>err
    expect_text err 'line 5 of a.obj: ?[2Jx is not supported'
    for bad in 'splot x*y translate 1,2,3' 'splot "a.obj" translate 1,2' 'splot "a.obj" scale 0' 'splot "a.obj" crease 90' \
        'plot "a.obj"' 'splot "a.obj" matrix solid' 'splot "a.obj" using 1:2:3' \
        'splot "a.obj" index 1' 'splot "a.obj" every 2 scale 2'; do
        echo "$bad" >b.gp
        expect_status 2 ridgeline plot b.gp -o a.svg 2>err
        expect_text err '"b.gp", line 1, column '
    done
    [ ! -e a.svg ]
    { cube; printf 'p 1\nusemtl red\np 2\n'; } >a.obj
    ridgeline plot a.gp -o a.seg 2>err
    [ "$(wc -l <err)" -eq 1 ]
    expect_text err 'line 16 of a.obj: p is not supported'
}

# Damaged STL and OFF: what is missing is an error, what is too much a warning.
damaged_files() {
    { head -c 80 /dev/zero; printf '\2\0\0\0'; head -c 60 /dev/zero; } >a.stl
    echo 'splot "a.stl"' >a.gp
    expect_status 2 ridgeline plot a.gp 2>err
    expect_text err 'should have 2 facets, but ends after 1'
    head -c 50 /dev/zero >a.stl
    expect_status 2 ridgeline plot a.gp 2>err
    expect_text err '84 bytes at least'
    { # one facet, 3 bytes more
        head -c 80 /dev/zero; printf '\1\0\0\0'; head -c 24 /dev/zero
        printf '\0\0\200\77\0\0\0\0\0\0\0\0\0\0\200\77\0\0\200\77\0\0\0\0\0\0xyz'
    } >a.stl
    ridgeline plot a.gp -o a.seg 2>err
    expect_text err 'warning: 3 bytes behind the last of its 1 facets'
    zeros=$(printf '%070d' 0)
    printf '\357\273\277solid s\r\nfacet normal nan 0 0\r\nouter loop\r\nvertex 0 0 0\r\nvertex 1.%s 0 0\r\nvertex 1 1 0\r
endloop\r\nendfacet\r\nendsolid' "$zeros" >a.stl # the mark of UTF-8, Windows line ends, a long number, no line end
    ridgeline plot a.gp -o b.seg 2>err
    [ ! -s err ]
    near "$(ink a.seg)" "$(ink b.seg)"
    printf 'off\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 2 1 0' >a.off
    echo 'splot "a.off"' >a.gp
    ridgeline plot a.gp -o b.seg 2>err
    expect_text err '"a.off", line 7, column 1: warning: this and what follows is beyond the counts'
    near "$(ink a.seg)" "$(ink b.seg)"
}

# A net of cells that are not flat, and a mast of twisted sides through it: whichever way they are cut.
cells_that_are_not_flat() {
    awk 'BEGIN { n = 30; for (i = 0; i <= n; i++) for (j = 0; j <= n; j++) printf "v %.6f %.6f %.6f\n", i / 3, j / 3, sin(i * .7) * cos(j * .6)
             for (i = 0; i < n; i++) for (j = 0; j < n; j++) { a = i * (n + 1) + j + 1; print "f", a, a + n + 1, a + n + 2, a + 1 }
             for (k = 0; k < 9; k++) for (j = 0; j < 5; j++) { t = .3 * k + j * 1.2566
                 printf "v %.6f %.6f %.6f\n", 5 + cos(t), 5 + sin(t), k * .5 - 1 }
             b = (n + 1) * (n + 1) + 1
             for (k = 0; k < 8; k++) for (j = 0; j < 5; j++) print "f", b + 5*k + j, b + 5*k + (j+1)%5, b + 5*k + 5 + (j+1)%5, b + 5*k + 5 + j }' >net.obj
    for view in 55,30 80,110 'from 30,-20,9'; do
        printf "set view $view\nsplot 'net.obj'\n" >a.gp
        ridgeline plot a.gp -o a.seg
        "$BUILDDIR/tools/judge_solid" a.seg net.obj >report || { cat report; return 1; }
        awk -v view="$view" '{ v[$1] = $2 } END { print "# net, view " view ": of " v["places"] " places " v["judged"] " judged, " \
            v["missing"] " missing, " v["false"] " false"; exit v["judged"] < .8 * v["places"] }' report
    done
    printf 'v 0 0 0\nv 1 0 0\nv 1 1 .1\nv .5 2 0\nv 0 1 0\nf 1 2 3 4 5\n' >five.obj
    printf "splot 'five.obj'\n" >a.gp
    ridgeline plot a.gp -o a.seg
    expect_status 2 "$BUILDDIR/tools/judge_solid" a.seg five.obj 2>err
    expect_text err 'more than four corners, and they are not in a plane: line 6'
}

# Edges that come close to the eye, for a scene a million times as large, and go on behind it: where nothing hides,
# nothing is lost.
close_to_the_eye() {
    for seed in 1 2 3 4 5 6 7 8; do
        awk -v seed=$seed 'function r(a) { return (2 * rand() - 1) * a } BEGIN {
            srand(seed)
            for (k = 0; k < 60; k++) printf "v %.6f %.6f %.6f\nv %.6f %.6f %.6f\nl -2 -1\n", r(8), r(8), r(8), r(8), r(8), r(8)
            print "v -900000 3 1\nv 900000 -4 1\nl -2 -1" }' >a.obj
        printf "set view from .$seed,.2,.3 to $seed,3,1\nsplot 'a.obj'\nunset hidden3d\nreplot\n" >a.gp
        ridgeline plot a.gp -o a.seg 2>err
        awk "BEGIN { d = $(ink a.seg) - $(ink a-2.seg); exit !(d < .5 && d > -.5 && $(ink a.seg) > 1000) }"
        echo "# $(ink a.seg) mm of wires near the eye, $(ink a-2.seg) unhidden"
    done
}

# Lines that end with CR alone; a binary STL that begins with `solid` and is not as long as it says.
lines_and_lengths() {
    cube >a.obj
    printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n' >b.off
    printf 'solid two words\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid two words\n' >c.stl
    for f in a.obj b.off c.stl; do
        tr '\n' '\r' <$f >mac.${f#*.}
        printf "splot '$f'\n" >lf.gp
        printf "splot 'mac.${f#*.}'\n" >cr.gp
        ridgeline plot lf.gp -o lf.seg
        ridgeline plot cr.gp -o cr.seg 2>err
        [ ! -s err ]
        cmp lf.seg cr.seg
    done
    printf 'v 0 0 0\rv 1 0 0\rv 0 1 nought\rf 1 2 3\r' >mac.obj
    printf "splot 'mac.obj'\n" >cr.gp
    expect_status 2 ridgeline plot cr.gp -o cr.seg 2>err
    expect_text err 'line 3, column 7'
    { printf 'solid but binary'; head -c 64 /dev/zero; printf '\3\0\0\0'; head -c 100 /dev/zero; } >a.stl
    echo "splot 'a.stl'" >a.gp
    expect_status 2 ridgeline plot a.gp -o a.seg 2>err
    expect_text err 'should have 3 facets, but ends after 2'
}

words_that_change_nothing_are_told() {
    cube >a.obj
    printf "set hidden3d halo dashed\nset hidden3d area seams\nset hidden3d dashed seams\nsplot 'a.obj'\n" >a.gp
    ridgeline plot a.gp -o a.seg 2>err
    expect_text err 'line 1: warning: set hidden3d: dashed is ignored in this mode' \
        'line 2: warning: set hidden3d: seams is ignored in this mode'
    [ "$(wc -l <err)" -eq 2 ]
}

# However often a mesh is there, its smooth edges are no lines.
smooth_twice() {
    awk 'BEGIN {
        n = 12; m = 24; pi = atan2(0, -1)
        for (i = 0; i <= n; i++)
            for (j = 0; j < m; j++)
                printf "v %.6f %.6f %.6f\n", sin(pi*i/n)*cos(2*pi*j/m), sin(pi*i/n)*sin(2*pi*j/m), cos(pi*i/n)
        for (i = 0; i < n; i++)
            for (j = 0; j < m; j++) {
                a = i*m + j + 1; b = i*m + (j + 1) % m + 1
                print "f", a, a + m, b + m
                print "f", a, b + m, b
            }
    }' >one.obj
    { cat one.obj; awk '/^f/ { print "f", $4, $3, $2 }' one.obj; } >twice.obj
    for mode in convex halo area; do
        printf "set hidden3d $mode\nset crease 40\nsplot 'one.obj'\nsplot 'twice.obj'\nsplot 'one.obj', 'one.obj'\n" >a.gp
        ridgeline plot a.gp -o a.seg
        near "$(ink a.seg)" "$(ink a-2.seg)"
        near "$(ink a.seg)" "$(ink a-3.seg)"
    done
}

rows_as_they_are_typed() {
    cube >a.obj
    { echo 'set view 65,40'; echo "splot '-' solid translate 1,0,0"; cat a.obj; echo e; } >a.gp
    printf "set view 65,40\nsplot 'a.obj' translate 1,0,0\n" >b.gp
    ridgeline plot a.gp -o a.seg
    ridgeline plot b.gp -o b.seg
    cmp a.seg b.seg
}

hidden_parts_are_dashed() {
    cube >a.obj
    printf "splot 'a.obj'\nset hidden3d dashed; replot\nunset hidden3d; replot\n" >a.gp
    ridgeline plot a.gp -o a.seg
    awk "BEGIN { a = $(ink a.seg); b = $(ink a-2.seg); c = $(ink a-3.seg); exit !(a < b && b < c && (b - a) / (c - a) < 0.7) }"
    # exactly along an axis nothing hidden is left
    printf "set view 90,0\nsplot 'a.obj'\n" >b.gp
    ridgeline plot b.gp -o b.seg
    [ "$(sed 1d b.seg | wc -l)" -eq 4 ]
}

# Two boxes side by side, one half as high: their common corner and ground line are drawn once, however it is hidden.
what_falls_together_is_drawn_once() {
    { cube; cube | sed 's/^v 0/v -1/; s/^v 1/v 0/; s/ 1$/ .5/' | awk '/^f/ { for (k = 2; k <= NF; k++) $k += 8 } 1'; } >a.obj
    for mode in 'unset hidden3d' 'set hidden3d convex' 'set hidden3d halo' 'set hidden3d area' 'set hidden3d dashed'; do
        printf "set view 70,30\n$mode\nsplot 'a.obj' rotate 10,20,30\n" >a.gp
        ridgeline plot a.gp -o a.seg
        awk 'NR > 1 { for (k = 1; k < n; k++) { # both ends of the shorter on the other
                 ux = x[k] - $1; uy = y[k] - $2; vx = $3 - $1; vy = $4 - $2; l = sqrt(vx * vx + vy * vy)
                 wx = a[k] - $1; wy = b[k] - $2; s = (ux * vx + uy * vy) / l; t = (wx * vx + wy * vy) / l
                 d = (ux * vy - uy * vx) / l; e = (wx * vy - wy * vx) / l
                 if (s > t) { r = s; s = t; t = r }
                 if (d * d < 1e-6 && e * e < 1e-6 && t > .01 && s < l - .01) { print "twice: " $0; bad = 1 } }
                 x[n] = $1; y[n] = $2; a[n] = $3; b[n++] = $4 } END { exit bad }' n=1 a.seg
    done
}

# A prism whose roof goes up and down: however it is cut into triangles, its outline has no gap, so no end of a line is alone.
an_outline_is_closed() {
    awk 'BEGIN { for (z = 0; z < 2; z++) for (k = 0; k < 6; k++) { a = k * 1.0471975512; h = z ? 1 + (k % 2 ? .3 : -.3) : 0
                   printf "v %.9f %.9f %.9f\n", cos(a), sin(a), h }
                 print "f 6 5 4 3 2 1\nf 7 8 9 10 11 12"; for (k = 0; k < 6; k++) { n = (k + 1) % 6; print "f", k + 1, n + 1, n + 7, k + 7 } }' >a.obj
    for view in 50,25 50,40 35,10 from' '3,-4,2.5 from' '2,5,4; do
        printf "set view $view\nsplot 'a.obj'\n" >a.gp
        ridgeline plot a.gp -o a.seg
        awk 'BEGIN { n = 0 } NR > 1 { for (k = 1; k < 4; k += 2) { x[n] = $k; y[n++] = $(k + 1) } }
             END { for (i = 0; i < n; i++) { c = 0; for (j = 0; j < n; j++) c += (x[i] - x[j])^2 + (y[i] - y[j])^2 < .01
                     if (c < 2) { print "alone: " x[i], y[i]; bad = 1 } } exit bad || n < 20 }' a.seg
    done
}

# Bodies pushed into each other: with seams no line ends in the open, without they do. Dashed, hidden seams too.
bodies_that_meet_have_seams() {
    cube >a.obj
    awk 'BEGIN { split("0 0 2 0 2 .7 .7 .7 .7 2 0 2", p, " "); for (h = 0; h < 2; h++) for (i = 1; i < 12; i += 2) print "v", p[i], p[i + 1], h
             print "f 6 5 4 3 2 1\nf 7 8 9 10 11 12"; for (i = 0; i < 6; i++) print "f", i + 1, (i + 1) % 6 + 1, (i + 1) % 6 + 7, i + 7 }' >l.obj
    for view in 60,30 35,70 'from 5,-4,3'; do
        for how in 'seams' 'convex'; do
            printf "set view $view; set hidden3d $how\nsplot 'a.obj', 'a.obj' rotate 20,30,40 translate .4,.3,.5, 'l.obj' rotate 70,0,20 translate .8,.5,.1\n" >a.gp
            ridgeline plot a.gp -o $how.seg
            awk 'NR > 1 { x[n] = $1; y[n] = $2; a[n] = $3; b[n++] = $4 }
                 function open(u, v, i,  k, dx, dy, t) { for (k = 0; k < n; k++) { if (k == i) continue
                     dx = a[k] - x[k]; dy = b[k] - y[k]; t = ((u - x[k]) * dx + (v - y[k]) * dy) / (dx * dx + dy * dy); t = t < 0 ? 0 : t > 1 ? 1 : t
                     if ((u - x[k] - t * dx)^2 + (v - y[k] - t * dy)^2 < .0004) return 0 } return 1 }
                 END { for (i = 0; i < n; i++) loose += open(x[i], y[i], i) + open(a[i], b[i], i); print loose + 0 }' n=0 $how.seg >$how.loose
        done
        [ "$(cat seams.loose)" -eq 0 ]
        [ "$(cat convex.loose)" -gt 0 ]
    done
    sed -i 's/convex/dashed seams/' a.gp
    ridgeline plot a.gp -o d.seg
    awk "BEGIN { exit !($(ink d.seg) > $(ink seams.seg) * 1.1) }"
    printf "set hidden3d dashed seams; show hidden3d; unset hidden3d; show hidden3d\n" >b.gp
    ridgeline plot b.gp -o b.svg >out 2>&1 || true
    expect_text out 'set hidden3d perimeter dashed seams' 'unset hidden3d'
}

# One body in a knot of 5,760 triangles, 2,500 angles of concave faces, a field of 576 cogwheels (21,888 faces, of which the largest have
# 36 corners): held against rays at random places, in both kinds of views.
thousands_of_concave_parts() {
    awk 'BEGIN { n = 240; m = 12; for (i = 0; i < n; i++) { t = 6.28318530718 * i / n; r = 2 + cos(3 * t); w = r * cos(2 * t)
             for (j = 0; j < m; j++) { u = 6.28318530718 * j / m; o = .4 * cos(u)
                 printf "v %.7f %.7f %.7f\n", (r + o) * cos(2 * t), (r + o) * sin(2 * t), -sin(3 * t) + .4 * sin(u) } }
             for (i = 0; i < n; i++) for (j = 0; j < m; j++) { a = i * m + j + 1; d = i * m + (j + 1) % m + 1
                 b = (i + 1) % n * m + j + 1; c = (i + 1) % n * m + (j + 1) % m + 1; print "f", a, b, c "\nf", a, c, d } }' >knot.obj
    awk 'BEGIN { split("0 0 2 0 2 .7 .7 .7 .7 2 0 2", p, " "); for (k = 0; k < 2500; k++) { t = .3 * k
             for (h = 0; h < 2; h++) for (i = 1; i < 12; i += 2)
                 printf "v %.6f %.6f %d\n", 3 * (k % 50) + p[i] * cos(t) - p[i + 1] * sin(t), 3 * int(k / 50) + p[i] * sin(t) + p[i + 1] * cos(t), h
             print "f -7 -8 -9 -10 -11 -12\nf -6 -5 -4 -3 -2 -1"; for (i = 0; i < 6; i++) print "f", i - 12, (i + 1) % 6 - 12, (i + 1) % 6 - 6, i - 6 } }' >angles.obj
    awk 'BEGIN { n = 36; for (k = 0; k < 576; k++) { for (h = 0; h < 2; h++) for (i = 0; i < n; i++) { r = i % 4 < 2 ? 1 : .75
             printf "v %.6f %.6f %.2f\n", 2.2 * (k % 24) + r * cos(6.28318530718 * i / n), 2.2 * int(k / 24) + r * sin(6.28318530718 * i / n), .3 * (k % 5) + .4 * h }
             s = "f"; for (i = n; i > 0; i--) s = s " " i - 1 - 2 * n; print s; s = "f"; for (i = 0; i < n; i++) s = s " " i - n; print s
             for (i = 0; i < n; i++) print "f", i - 2 * n, (i + 1) % n - 2 * n, (i + 1) % n - n, i - n } }' >cogs.obj
    for body in knot angles cogs; do
        for view in 55,30 'from 150,-90,70'; do
            [ "$body$view" = 'knotfrom 150,-90,70' ] && view='from 5,-4,3'
            printf "set view $view\nsplot '$body.obj'\n" >a.gp
            ridgeline plot a.gp -o a.seg
            "$BUILDDIR/tools/judge_solid" a.seg $body.obj >report || { cat report; return 1; }
            awk -v what="$body, view $view" '{ v[$1] = $2 } END { print "# " what ": " v["faces"] " faces, " v["segments"] \
                " segments; of " v["places"] " places on edges " v["judged"] " judged, " v["missing"] " missing, " v["false"] " of as many on segments false"
                exit v["judged"] < .9 * v["places"] || v["visible"] < .2 * v["places"] }' report
        done
    done
}

# Two long boards, flush in part of an edge, behind 39 posts: of lines that coincide each has 40 visible parts.
what_coincides_behind_a_fence() {
    awk 'function bar(x, y, z, a, b, c,   k) {
             for (k = 0; k < 8; k++) print "v", x + a * (k % 2), y + b * (int(k / 2) % 2), z + c * int(k / 4)
             print "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3" }
         BEGIN { bar(0, 0, 0, 40, 1, 1); bar(-1, 0, 1, 42, 1, 1)
                 for (k = 0; k < 39; k++) bar(k + .4 + k % 3 / 10, -3 - k / 50, -3 - k / 70, .3 + k / 200, .2 + k / 300, 8 + k / 30) }' >fence.obj
    for mode in 'offset 0' halo dashed area; do
        printf "set view 70,10\nset hidden3d $mode\nsplot 'fence.obj'\n" >"a.gp"
        ours a.gp "${mode% 0}.seg" 2>/dev/null
    done
    near "$(ink offset.seg)" "$(ink area.seg)"
    echo "# behind a fence: $(ink offset.seg) mm, with haloes $(ink halo.seg), dashed $(ink dashed.seg)"
}

run_tests what_coincides_behind_a_fence a_surface_of_facets_is_the_surface formats_are_the_same_body a_binary_stl_is_read what_is_wrong_is_said damaged_files \
    rows_as_they_are_typed hidden_parts_are_dashed what_falls_together_is_drawn_once an_outline_is_closed \
    bodies_that_meet_have_seams thousands_of_concave_parts lines_and_lengths words_that_change_nothing_are_told smooth_twice \
    close_to_the_eye cells_that_are_not_flat
