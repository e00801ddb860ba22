#!/bin/sh
# `ridgeline plot` from outside: files, pages, messages, exit statuses.
. tests/cli/lib.sh

every_suffix_is_written() {
    small_scene
    ridgeline plot small.gp -o a.svg -o a.png -o a.pdf -o a.vcd -o a.seg -o a.hpgl -o a.plt -o a.gcode
    head -c 5 a.svg | grep -q '<?xml'
    head -c 4 a.png | grep -q 'PNG'
    head -c 5 a.pdf | grep -q '%PDF-'
    grep -q x_step a.vcd
    head -1 a.seg | grep -q '^# camera '
    head -1 a.hpgl | grep -q '^IN;SP1;'
    cmp a.hpgl a.plt
    expect_text a.gcode G21 G90 'M3 S1000' M5
}

a_byte_order_mark_is_skipped() {
    printf '\357\273\277set isosamples 8\r\nload "more.gp"\r\nsplot "d.dat"\r\n' >mark.gp
    printf '\357\273\277title = 1\r\n' >more.gp
    printf '\357\273\2771 1 1\r\n1 2 2\r\n\r\n2 1 3\r\n2 2 5\r\n' >d.dat
    ridgeline plot mark.gp -o a.seg 2>err
    [ ! -s err ]
    [ -s a.seg ]
}

what_is_no_scene_is_bad_input() {
    mkdir folder
    expect_status 2 ridgeline plot folder -o a.svg 2>err
    expect_text err 'folder: Is a directory'
    for bad in 'f(a,b,c,d,e,f,g,h,i) = a' 'f(x) = f(x); print f(1)' 'load "bad.gp"'; do
        echo "$bad" >bad.gp
        expect_status 2 ridgeline plot bad.gp -o a.svg 2>err
        expect_text err '"bad.gp", line 1, column '
    done
    [ ! -e a.svg ]
}

seg_is_what_the_format_says() {
    ridgeline plot "$scenes/smooth.gp" -o a.seg
    awk 'NR == 1 { if (NF != 14 || $1 != "#" || $2 != "camera") exit bad = 1; next }
         NF != 4 { exit bad = 1 }
         { for (i = 1; i <= 4; i++) {
               if ($i !~ /^[0-9]+\.[0-9][0-9][0-9][0-9][0-9][0-9]+$/) exit bad = 1
               if ($i < 0 || $i > (i % 2 ? 297 : 210)) exit bad = 1 } }
         END { exit bad || NR < 1000 }' a.seg
}

runs_are_the_same() {
    ridgeline plot "$scenes/random.gp" -o a.seg -o a.vcd
    ridgeline plot "$scenes/random.gp" -o b.seg -o b.vcd
    cmp a.seg b.seg
    cmp a.vcd b.vcd
}

lines_end_on_the_limit_they_cross() {
    printf 'unset hidden3d\nset view 90,0\nset zrange [.2:.8]\nset xrange [-2:2]\nset yrange [-2:2]\n' >z.gp
    printf 'set isosamples 20\nset samples 21\nsplot exp(-x**2-y**2)\n' >>z.gp
    ridgeline plot z.gp -o z.seg
    # Seen from the side the limits are two heights of the page.
    awk 'NR > 1 { for (i = 2; i <= 4; i += 2) { n[$i]++; if (low == "" || $i < low) low = $i; if ($i > high) high = $i } }
         END { exit !(n[low] >= 40 && n[high] >= 16) }' z.seg
}

pages_are_numbered() {
    printf 'set isosamples 8\nsplot x*y\nsplot x+y\nreplot\n' >three.gp
    ridgeline plot three.gp -o a.svg -o b.seg >out 2>err
    [ ! -s out ]
    [ ! -s err ]
    [ "$(echo a*.svg b*.seg)" = "a-2.svg a-3.svg a.svg b-2.seg b-3.seg b.seg" ]
    cmp a-2.svg a-3.svg
}

scene_from_stdin() {
    printf 'splot x*y\n' | ridgeline plot - -o a.svg
    [ -s a.svg ]
}

continued_lines_comments_and_several_commands() {
    printf '# a comment\nset isosamples 8; f(x) = x**2 # another\nsplot f(x) \\\n  + f(y)\n' | ridgeline plot - -o a.seg
    printf 'set isosamples 8\nsplot x**2+y**2\n' | ridgeline plot - -o b.seg
    cmp a.seg b.seg
}

set_runs_before_the_scene() {
    small_scene
    ridgeline plot small.gp --set 'set paper a3' --set='set title "<big>"' -o a.svg
    expect_text a.svg 'width="420mm" height="297mm"' '<title>&lt;big&gt;</title>'
}

stats_tell_every_page() {
    printf 'set isosamples 8\nsplot x*y\nsplot x+y\n' | ridgeline plot - -o a.svg --stats s.json
    [ "$(grep -c '"page":' s.json)" -eq 2 ]
    expect_text s.json '"facets": 49' '"files": ["a.svg"]' '"files": ["a-2.svg"]' '"pen_down_mm"' '"plotting_s"' \
        '"stage_s"' '"memory_bytes"'
}

a_table_when_asked() {
    small_scene
    ridgeline plot small.gp -v >out
    [ "$(wc -l <out)" -eq 2 ]
    expect_text out facets plotting 'small '
}

print_goes_to_stdout() {
    printf 'print 1+1\nprint 2**0.5\n' | ridgeline plot - >out 2>err
    grep -qx 2 out
    grep -q '^1\.4142135' out
    [ ! -s err ]
}

data_beside_the_scene_is_found() {
    ridgeline plot "$scenes/random.gp" -o a.seg
    [ "$(wc -l <a.seg)" -gt 1000 ]
}

inline_data() {
    printf "splot '-' matrix with lines\n1 2 3\n2 1 2\n3 2 1\ne\nprint 7\n" | ridgeline plot - -o a.seg >out
    grep -qx 7 out
    [ "$(wc -l <a.seg)" -gt 4 ]
}

an_error_shows_line_column_and_caret() {
    printf 'set isosamples 8\nsplot x*y\nsplot x+*y\nprint 7\n' >bad.gp
    expect_status 2 ridgeline plot bad.gp -o a.svg >out 2>err
    expect_text err 'splot x+*y' '^' bad.gp
    grep -qE '(bad\.gp:3:|line 3)' err
    # The caret stands under the second operator.
    awk '/splot x\+\*y/ { at = index($0, "+*") + 1 } /\^/ && at { if (index($0, "^") == at) good = 1 } END { exit !good }' err
    [ -s a.svg ]
    [ ! -e a-2.svg ]
    [ ! -s out ]
}

bad_input_draws_nothing_and_says_2() {
    for text in 'splot' 'splot x*' 'splt x' 'set xrange [1:' 'splot foo(x)' 'splot nope' "splot 'missing.dat'" 'set zorro 3' 'splot log(-1)' \
        'splot (((((x' "load 'missing.gp'" "splot '-' matrix"; do
        printf '%s\n' "$text" >bad.gp
        expect_status 2 ridgeline plot bad.gp -o a.svg 2>err
        [ -s err ]
        [ ! -e a.svg ]
    done
    expect_status 2 ridgeline plot missing.gp -o a.svg 2>err
    expect_text err missing.gp
}

data_that_is_no_data_is_named() {
    printf '0;0;1\n0;1;2\n\n1;0;3\n' >s.csv
    echo 'splot "s.csv"' >bad.gp
    expect_status 2 ridgeline plot bad.gp -o a.svg 2>err
    [ "$(cat err)" = '0;1;2
^
"s.csv", line 2, column 1: not a number' ]
}

what_the_machine_cannot_reach_leaves_no_trace() {
    small_scene
    expect_status 1 ridgeline plot small.gp --set 'set machine size 100,100' -o a.vcd 2>err
    expect_text err 'the paper reaches beyond the machine'
    [ ! -e a.vcd ]
}

# A unit of 10^180 or 10^-180: squares of lengths are no numbers any more. All powers of two, so that the drawing is the same.
a_scene_is_drawn_in_any_unit() {
    for view in 'from 6*s,8*s,3*s' '60,30; set zrange [-s:s]'; do
        for s in 1.0 '2.0**600' '2.0**-600'; do
            printf 's = %s; set xrange [-2*s:2*s]; set yrange [-2*s:2*s]\nset isosamples 16; set xyplane at -s; set view %s\n' "$s" "$view"
            echo 'splot s*exp(-(x/s)**2-(y/s)**2)'
        done >unit.gp
        ridgeline plot unit.gp -o u.seg
        for page in u u-2 u-3; do grep -v '#' $page.seg >$page.ink; done
        [ -s u.ink ]
        cmp u.ink u-2.ink
        cmp u.ink u-3.ink
    done
}

steps_that_leave_no_time_for_pulses_are_told() {
    small_scene
    expect_status 1 ridgeline plot small.gp --set 'set machine pulse 100 setup 200 speed 40' -o a.vcd 2>err
    expect_text err 'a.vcd: so fast the steps leave no time for pulses and DIR set-up: set machine speed'
    [ ! -e a.vcd ]
    ridgeline plot small.gp --set 'set machine accel 1 speed 1 travel 2000' -o a.vcd
    ridgeline trace a.vcd >judgement
}

a_scene_behind_the_eye_is_told() {
    echo 'set view from 0,0,500 to 0,0,900; splot x*y' >bad.gp
    expect_status 2 ridgeline plot bad.gp -o a.svg 2>err
    expect_text err 'behind the eye'
}

a_known_but_ignored_option_is_warned_of_once() {
    printf 'set isosamples 8\nset key left\nset key right\nsplot x*y\n' | ridgeline plot - -o a.svg 2>err
    [ "$(grep -c key err)" -ge 1 ]
    [ -s a.svg ]
}

bad_options_get_a_hint() {
    small_scene
    for arguments in '--frobnicate' 'plot' 'plot small.gp --colour' 'plot small.gp -o' 'plot small.gp -o a.doc' 'plot small.gp small.gp' 'frob'; do
        # shellcheck disable=SC2086
        expect_status 2 ridgeline $arguments 2>err
        grep -qE -- '--help|must end in' err
    done
    [ "$(ls)" = "$(printf 'err\nsmall.gp')" ]
}

what_is_not_the_inputs_fault_says_1() {
    small_scene
    expect_status 1 ridgeline plot small.gp -o missing/a.svg 2>err
    expect_text err 'missing/a.svg: No such file'
    expect_status 1 ridgeline plot small.gp --stats missing/s.json 2>err
    expect_text err 'missing/s.json'
}

help_and_version() {
    ridgeline --help | grep -q 'ridgeline plot SCENE'
    ridgeline --version | grep -qE '^ridgeline [0-9]+\.[0-9]+'
}

pause_does_not_wait_without_a_terminal() {
    printf 'set isosamples 8\nsplot x*y\npause -1 "Return?"\npause 3600\nsplot x\n' | timeout 20 "$RIDGELINE" plot - -o a.svg
    [ -s a-2.svg ]
}

hidden_dem_runs_to_its_end() {
    examples=/usr/share/doc/gnuplot/examples
    if [ ! -e $examples/hidden.dem ]; then
        echo "gnuplot-doc is not installed"
        return 1
    fi
    ridgeline plot $examples/hidden.dem -o a.svg </dev/null
    [ "$(ls a*.svg | wc -l)" -eq 7 ]
    (cd $examples && ridgeline plot hidden.dem -o "$OLDPWD/b.seg" </dev/null)
    for page in '' -2 -3 -4 -5 -6 -7; do [ "$(wc -l <"b$page.seg")" -gt 100 ]; done
}

data_blocks() {
    printf '0 0 1\n0 1 2\n\n1 0 3\n1 1 0\n' >d.dat
    printf 'splot "d.dat"\n' | ridgeline plot - -o file.seg
    { printf '$grid << EOD\n'; cat d.dat; printf 'EOD\n# nothing of it is a command: splot\nsplot $grid with lines title "a"\n'; } >scene.gp
    ridgeline plot scene.gp -o block.seg
    cmp file.seg block.seg
    printf 'load "scene.gp"; splot $grid using 1:2:3\n' | ridgeline plot - -o load.seg
    cmp file.seg load.seg && cmp file.seg load-2.seg
    # Written anew, it is drawn anew.
    printf '$d<<END\n0 0\n0 1\nEND\nsplot $d matrix\n$d << END\n0 2 0\n0 0 0\nEND\nreplot\n' | ridgeline plot - -o r.seg
    [ "$(wc -l <r-2.seg)" -gt "$(wc -l <r.seg)" ]
    expect_status 2 ridgeline plot - -o b.seg 2>err <<-'.'
	$open << EOD
	1 2 3
	.
    expect_text err 'the data block has no end'
    printf 'splot $none\n' | expect_status 2 ridgeline plot - -o b.seg 2>err
    expect_text err 'line 1, column 7: cannot read the data file: $none'
    printf '$ d << E\n' | expect_status 2 ridgeline plot - -o b.seg 2>err
    expect_text err 'column 1: the name of a data block expected'
}

surfaces_over_different_points_hide_each_other() {
    printf '0 0 0\n0 9 0\n\n9 0 0\n9 9 0\n' >flat.dat
    cat >several.gp <<'.'
set xrange [0:9]; set yrange [0:9]; set zrange [0:6]; set view 0,0; set isosamples 12
splot 5 + 0*x
splot 'flat.dat', 5 + 0*x
set view 180,0; replot
set hidden3d area; set hatch 45,5; replot
.
    ridgeline plot several.gp -o several.seg --stats several.json
    # From above there is one, from below the other, whose border is that of both.
    awk -F'[:,]' '/"pen_down_mm"/ { down[++n] = $2 }
        END { exit !(n == 4 && (d = down[2] - down[1]) * d < 1e-4 && down[3] < down[1] / 3 && down[3] > 100 && down[4] > down[3]) }' several.json
}

errors_in_data_show_the_row() {
    printf '0 0 1\r\n0 1 2\r\n\r\n1 0 bar\r\n1 1 4\r\n' >bad.dat
    echo 'splot "bad.dat"' | expect_status 2 ridgeline plot - 2>err
    printf '1 0 bar\n    ^\n"bad.dat", line 4, column 5: not a number\n' | cmp - err
    printf 'splot "-"\n0 0 1\n\t0 1 x\ne\n' >bad.gp
    printf '\t0 1 x\n\t    ^\n"bad.gp", line 3, column 6: not a number\n' >want
    expect_status 2 ridgeline plot bad.gp 2>err
    cmp want err
    echo 'load "bad.gp"' | expect_status 2 ridgeline plot - 2>err
    cmp want err
    echo 'splot "bad.dat" skip 4 using 1:2:(1+nobody)' | expect_status 2 ridgeline plot - 2>err
    expect_text err 'line 1, column 37: undefined variable: nobody'
}

autoscaled_ends_stay_within_bounds() {
    n=0
    # A bound that the data cross is where the range ends; one that they do not reach changes nothing.
    while IFS='@' read -r bounded plain scene; do
        n=$((n + 1))
        printf '%s\n%s\n' "set $bounded" "$scene" | ridgeline plot - -o "bounded.seg"
        printf '%s\n%s\n' "set $plain" "$scene" | ridgeline plot - -o "plain.seg"
        cmp bounded.seg plain.seg || { echo "$bounded is not $plain"; return 1; }
    done <<'.'
zrange [0<*:]@zrange [0:]@splot x*y
zrange [-500<*:]@zrange [*:]@splot x*y
zrange [*<-150:*<60]@zrange [-150:60]@splot x*y
zrange [:150<*<500]@zrange [:150]@splot x*y
zrange [-50 < * < 0 : * ]@zrange [-50:]@unset hidden3d; splot x*y
zrange [-50<*:]@zrange [-50:]@set hidden3d horizon; splot x*y
xrange [-2<*:*<2]; set yrange [*<-20:]@xrange [-2:2]; set yrange [-20:]@splot x*y
xrange [*:*<2]@xrange [*:2]@plot x**2
yrange [-1<*:*<5]@yrange [*:5]@plot x**2
zrange [0<*<9:]; set zrange [0:]@zrange [0:]@splot x*y
zrange [1<*:]; set logscale z@zrange [1:]; set logscale z@splot exp(x)+0.1
.
    [ $n -eq 11 ]
    echo 'set zrange [-20<*<-5:5<*<20]; show zrange' | ridgeline plot - >out
    [ "$(cat out)" = 'set zrange [-20<*<-5:5<*<20]' ]
    echo 'set xrange [1<*<]' | expect_status 2 ridgeline plot - 2>err
    expect_text err 'column 17: a value expected'
    echo 'splot x \\ # more' | expect_status 2 ridgeline plot - 2>err
    expect_text err 'column 9: nothing may stand behind a'
}

an_empty_page_is_told() {
    printf '0 0 NaN\n0 1 2\n\n1 0 3\n1 1 4\n' >holes.dat
    echo 'splot "holes.dat"' | ridgeline plot - -o a.svg 2>err
    expect_text err 'page 1 is empty'
    echo 'print 1' | ridgeline plot - -o b.svg 2>err >out
    expect_text err 'nothing was written; stdin plots nothing'
    [ ! -e b.svg ]
}

what_cannot_be_printed_is_told() {
    [ -e /dev/full ] || return 0
    for words in --version help; do expect_status 1 ridgeline $words 2>err >/dev/full; done
    echo 'print 1' | expect_status 1 ridgeline plot - 2>err >/dev/full
    expect_text err 'standard output: No space left'
}

no_progress_off_a_terminal() {
    ridgeline plot "$scenes/smooth.gp" --set 'set isosamples 700' -o a.seg 2>err
    [ ! -s err ]
}

run_tests every_suffix_is_written a_scene_behind_the_eye_is_told data_that_is_no_data_is_named what_the_machine_cannot_reach_leaves_no_trace a_scene_is_drawn_in_any_unit steps_that_leave_no_time_for_pulses_are_told a_byte_order_mark_is_skipped what_is_no_scene_is_bad_input seg_is_what_the_format_says runs_are_the_same lines_end_on_the_limit_they_cross pages_are_numbered scene_from_stdin \
    continued_lines_comments_and_several_commands set_runs_before_the_scene stats_tell_every_page a_table_when_asked \
    print_goes_to_stdout data_beside_the_scene_is_found inline_data an_error_shows_line_column_and_caret \
    bad_input_draws_nothing_and_says_2 a_known_but_ignored_option_is_warned_of_once bad_options_get_a_hint \
    what_is_not_the_inputs_fault_says_1 help_and_version pause_does_not_wait_without_a_terminal \
    hidden_dem_runs_to_its_end data_blocks surfaces_over_different_points_hide_each_other errors_in_data_show_the_row autoscaled_ends_stay_within_bounds an_empty_page_is_told what_cannot_be_printed_is_told no_progress_off_a_terminal
