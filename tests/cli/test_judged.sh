#!/bin/sh
# The whole program against the exact reference: what `ridgeline plot -o x.seg` draws is judged line by line
# (tests/oracle/judge_seg.h): no run of missing or false ink longer than one step of 0.0125 mm.
. tests/cli/lib.sh
case ${BUILDDIR:=build} in /*) ;; *) BUILDDIR=$root/$BUILDDIR ;; esac
judge=$BUILDDIR/tools/judge_seg
# Default paper and margin.
page='-p 10,10,287,200'

# judged NX NY X0:X1 Y0:Y1 FUNCTION COMMANDS [judge option...]
judged() {
    nx=$1 ny=$2 x=$3 y=$4 f=$5 commands=$6
    shift 6
    {
        echo "set isosamples $nx,$ny; set samples $nx,$ny; set xrange [$x]; set yrange [$y]; set hidden3d"
        echo "$commands"
        echo "splot $f with lines"
    } >judged.gp
    verdict -f "$f" -n "$nx,$ny" -x "$x" -y "$y" "$@"
}

# profiles COUNT SAMPLES X0:X1 Y0:Y1 FUNCTION COMMANDS [judge option...]: by the horizon algorithm
profiles() {
    count=$1 samples=$2 x=$3 y=$4 f=$5 commands=$6
    shift 6
    {
        echo "set isosamples 10,$count; set samples $samples,10; set xrange [$x]; set yrange [$y]; set hidden3d horizon"
        echo "$commands"
        echo "splot $f with lines"
    } >judged.gp
    verdict -f "$f" -H "$count,$samples" -x "$x" -y "$y" "$@"
}

verdict() {
    ridgeline plot judged.gp -o judged.seg
    # shellcheck disable=SC2086
    "$judge" judged.seg $page "$@" >judged.txt || true
    cat judged.gp judged.txt
    awk '$1 == "missing_mm" || $1 == "false_mm" { found++; if ($2 > 0.0125) bad = 1 } END { exit bad || found != 2 }' judged.txt
}

sinc='sin(sqrt(x**2+y**2))/sqrt(x**2+y**2)'
noise='sin(12.9898*x+78.233*y)*1.7'

perspective_outside() {
    judged 40 40 -2:2 -2:2 'exp(-x**2-y**2)' 'set view from 6,8,3'
    judged 25 25 -2:2 -2:2 "$noise" 'set view from 6,-8,3'
    judged 12 40 -2:2 -1:7 'x**2-y**2' 'set view from -9,2,-30'
}
perspective_inside() {
    judged 25 25 -2:2 -2:2 "$noise" 'set view from .3,.2,4' -e .3,.2,4
    judged 21 21 -2:2 -2:2 "$noise" 'set view from 0,0,4' -e 0,0,4
    judged 16 16 -2:2 -2:2 "$noise" 'set view from .5,.1,-3' -e .5,.1,-3
}
perspective_in_a_grid_plane() {
    judged 17 17 -2:2 -2:2 "$noise" 'set view from .5,7,2' -e .5,7,2
    judged 17 17 -2:2 -2:2 'cos(2*x)*cos(2*y)' 'set view from 2,-7,1' -e 2,-7,1
    judged 2 17 -2:2 -2:2 "$noise" 'set view from -9,1,0' -e -9,1,0
}
gnuplots_views() {
    judged 40 40 -10:10 -10:10 "$sinc" 'set view 60,30'
    judged 21 21 -2:2 -2:2 "$noise" 'set view 90,45'
    judged 21 21 -2:2 -2:2 "$noise" 'set view 120,210,.8,1.5'
    judged 21 21 -2:2 -2:2 'x*x-y*y' 'set view 0,0'
    judged 15 21 0:1 -7:3 "$noise" 'set view 75,300'
    judged 3 400 -2:2 -2:2 'sin(13*x+878*y)' 'set view .5,0' # nearly from above: rows .3 mm apart, heights .6 mm
    judged 3 400 -2:2 -2:2 'sin(13*x+878*y)' 'set view 179.5,0'
}
holes() {
    judged 25 25 -2:2 -2:2 'sqrt(3.1-x*x-y*y)' 'set view 60,30'
    judged 21 21 -2:2 -2:2 'log(x+.7*y)' 'set view from 6,-8,3'
    judged 21 21 -2:2 -2:2 'tan(x)+.1*y' 'set view from 6,8,6; set zrange [-2:2]' -z -2:2
}
cliffs() {
    judged 25 25 -2:2 -2:2 'int(x+.013)*int(y+.017)' 'set view from 6,8,3'
    judged 25 25 -2:2 -2:2 'x*y>.0123?1:0' 'set view from 3,9,2'
}
# Depths that differ by 10^8 and more, the eye among the surface's heights.
steep() {
    judged 40 40 -10:10 -10:10 'x**9' 'set view from 6,8,3' -e 6,8,3
    judged 40 40 -3:3 -3:3 'x**9' 'set view from 1,2,.5' -e 1,2,.5
    judged 40 40 -4:4 -4:4 'exp(x*y)' 'set view from 6,8,3' -e 6,8,3
    judged 30 30 -3:3 -3:3 'x**9*y**3' 'set view from 6,8,3' -e 6,8,3
    judged 40 40 -3:3 -3:3 'sinh(4*x)*y' 'set view from 6,8,3' -e 6,8,3
}
horizon() {
    profiles 30 40 -2:2 -2:2 'exp(-x**2-y**2)' 'set view from 6,8,3'
    profiles 30 40 -2:2 -2:2 "$noise" 'set view from -1,8,3'
    profiles 30 40 -2:2 -2:2 'sin(3*x)*cos(2*y)' 'set view 60,30'
    profiles 30 40 -2:2 -2:2 'sin(3*x)*cos(2*y)' 'set view 50,0; set hidden3d horizon infinite' -I
    profiles 20 40 -2:2 -2:2 'sqrt(3.1-x*x-y*y)' 'set view from 1,8,3'
}
# The demo's own files, as they are.
demo_scenes() {
    cp "$scenes"/*.gp "$scenes"/*.dat .
    cp smooth.gp judged.gp
    verdict -f 'exp(-x**2-y**2)' -n 60,60 -x -2:2 -y -2:2
    cp sinc.gp judged.gp
    verdict -f "$sinc" -n 60,60 -x -12:12 -y -12:12
    # A nonuniform matrix as grid blocks: the judge reads those.
    awk '/^#/ { next } !n { for (i = 2; i <= NF; i++) x[i] = $i; n = NF; next }
         { for (i = 2; i <= n; i++) print x[i], $1, $i; print "" }' random60.dat >random.blocks
    cp random.gp judged.gp
    verdict -g random.blocks -e 6,8,3
}

run_tests demo_scenes perspective_outside perspective_inside perspective_in_a_grid_plane gnuplots_views holes cliffs steep horizon
