#!/bin/sh
# Parametric surfaces, from outside: the same ink as a surface of x and y where they are one, and gnuplot's own scenes.
. tests/cli/lib.sh
case ${BUILDDIR:=build} in /*) ;; *) BUILDDIR=$root/$BUILDDIR ;; esac
judge=$BUILDDIR/tools/judge_seg

# right FILE: against the exact reference of that surface of x and y. Its cells are flat: seen as a bow tie, a twisted cell of a
# surface hides what is inside of the tie, here what is inside of two triangles.
right() {
    "$judge" "$1" -f 'exp(-x**2)+y/4' -n 20,30 -x -2:2 -y -2:2 -p 10,10,287,200 >verdict || true
    awk '{ v[$1] = $2 } END { exit v["missing_mm"] > .0125 || v["false_mm"] > .0125 || v["end_steps"] > .25 || v["drawn_mm"] < 3000 }' verdict || { cat verdict; return 1; }
}

a_surface_of_x_and_y_is_the_same() {
    for view in '60,30' '20,200' 'from 6,8,3'; do
        printf 'set parametric; set isosamples 20,30; set view %s\nsplot [-2:2][-2:2] u,v,exp(-u**2)+v/4\n' "$view" | timeout 60 "$RIDGELINE" plot - -o a.seg
        right a.seg
    done
    printf 'set parametric; set dummy s,t; set urange [-2:2]; set vrange [2:-2]; set isosamples 20,30\nsplot s,t,exp(-s**2)+t/4\n' | timeout 60 "$RIDGELINE" plot - -o b.seg
    right b.seg
}

isolines_alone_without_hidden3d() {
    printf 'set isosamples 5,7; set samples 40,60; unset hidden3d\nsplot [-2:2][-1:2] x*x-sin(y)*x\n' | timeout 60 "$RIDGELINE" plot - -o a.seg
    printf 'set parametric; set isosamples 5,7; set samples 40,60; unset hidden3d\nsplot [-2:2][-1:2] u,v,u*u-sin(v)*u\n' | timeout 60 "$RIDGELINE" plot - -o b.seg
    length='!/^#/ { s += sqrt(($3 - $1) ^ 2 + ($4 - $2) ^ 2) } END { printf "%.2f\n", s }'
    [ "$(awk "$length" a.seg)" = "$(awk "$length" b.seg)" ]
}

ranges_leave_facets_out() {
    sphere='cos(u)*cos(v),cos(u)*sin(v),sin(u)'
    printf 'set parametric; set urange [-pi/2:pi/2]; set vrange [0:2*pi]; set isosamples 20,20\nsplot %s\nset zrange [0:*]\nreplot\nsplot [][][][][2:3] %s\n' $sphere $sphere >s.gp
    expect_status 2 timeout 60 "$RIDGELINE" plot s.gp -o s.seg 2>err
    expect_text err 'nothing to draw'
    [ "$(wc -l <s-2.seg)" -gt 50 ]
    [ ! -e s-3.seg ]
}

what_is_wrong_is_told() {
    printf 'set parametric\nsplot u,v\n' | expect_status 2 timeout 60 "$RIDGELINE" plot - -o a.seg 2>err
    expect_text err 'line 2, column 10: a parametric surface needs three expressions'
    printf 'set parametric\nsplot x,v,u\n' | expect_status 2 timeout 60 "$RIDGELINE" plot - -o a.seg 2>err
    expect_text err 'line 2, column 7: undefined variable: x'
    printf 'set nonlinear z via log10(z) inverse 10**z\nsplot x\n' | expect_status 2 timeout 60 "$RIDGELINE" plot - -o a.seg 2>err
    expect_text err 'line 2, column 7: nonlinear axes are not supported'
    printf 'set logscale cb\nset logscale; unset logscale\nsplot x\n' | timeout 60 "$RIDGELINE" plot - -o a.seg 2>err
}

surface2_dem_runs_to_its_end() {
    examples=/usr/share/doc/gnuplot/examples
    (cd $examples && timeout 60 "$RIDGELINE" plot surface2.dem -o "$OLDPWD/a.seg" </dev/null)
    for page in '' -2 -3 -4 -5 -6 -7 -8 -9; do [ "$(wc -l <"a$page.seg")" -gt 100 ]; done
}

run_tests a_surface_of_x_and_y_is_the_same isolines_alone_without_hidden3d ranges_leave_facets_out what_is_wrong_is_told \
    surface2_dem_runs_to_its_end
