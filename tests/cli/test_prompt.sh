#!/bin/sh
# The prompt, on a terminal. What is typed is typed when the program has printed what a person would have waited for.
. tests/cli/lib.sh
case ${BUILDDIR:=build} in /*) ;; *) BUILDDIR=$root/$BUILDDIR ;; esac

export HOME=. TERM=dumb

# at_terminal COMMAND... <dialogue: runs it on a terminal; the transcript goes to stdout.
at_terminal() { "$BUILDDIR/tools/terminal" "$@"; }
# says LINE...: the dialogue that types each at its prompt.
says() {
    for line in "$@"; do printf 'wait ridgeline> \ntype %s\\n\n' "$line"; done
}

a_plot_at_the_prompt_becomes_plot_svg() {
    says 'set isosamples 8' 'splot x*y' 'splot x+y' quit | at_terminal "$RIDGELINE" >out
    expect_text out 'ridgeline> ' plot.svg
    [ -s plot.svg ]
    [ ! -e plot-2.svg ]
}

an_error_does_not_end_it() {
    says 'splot x+*y' 'print 40+2' quit | at_terminal "$RIDGELINE" >out
    expect_text out '^' 42
    [ ! -e plot.svg ]
}

outputs_can_be_chosen() {
    says 'set isosamples 8' 'splot x*y' quit | at_terminal "$RIDGELINE" -o a.seg -o a.png --set 'set paper a5' >out
    [ -s a.seg ]
    [ -s a.png ]
    [ ! -e plot.svg ]
}

ctrl_c_takes_a_line_back() {
    at_terminal "$RIDGELINE" >out <<'END'
wait ridgeline> 
type print 41
wait print 41
type \003
wait ridgeline> 
type splot "-"\n
wait \n> 
type \003
wait ridgeline> 
type print 40+2\n
wait \n42
wait ridgeline> 
type quit\n
END
}

ctrl_c_ends_a_plot_that_takes_too_long() {
    got=0
    at_terminal "$RIDGELINE" plot - -o a.svg >out <<'END' || got=$?
type set isosamples 30000; splot sin(x)*cos(y)\n\004
wait %
type \003
END
    [ $got -eq 130 ] || { echo "exit status $got"; cat out; return 1; }
    [ ! -e a.svg ]
}

ctrl_c_stops_a_plot_at_the_prompt() {
    at_terminal "$RIDGELINE" >out <<'END'
wait ridgeline> 
type set isosamples 30000; splot sin(x)*cos(y)\n
wait %
type \003
wait stopped
wait ridgeline> 
type set isosamples 8; replot\n
wait plot.svg
wait ridgeline> 
type quit\n
END
    [ -s plot.svg ]
}

ctrl_c_ends_a_pause() {
    at_terminal "$RIDGELINE" >out <<'END'
wait ridgeline> 
type pause -1 "ready?"\n
wait \nready?
type \003
wait ridgeline> 
type pause 1000 "soon"; print 1\n
wait \nsoon
type \003
wait ridgeline> 
type pause -1 "go"; print 40+2\n
wait \ngo
type \n
wait \n42
wait ridgeline> 
type quit\n
END
    if grep -qx 1 out; then return 1; fi
}

# What was said of one line does not silence the next.
trouble_with_a_file_is_over_with_the_next_line() {
    says 'splot x' 'splot x+*y' quit | at_terminal "$RIDGELINE" -o missing/a.svg >out
    expect_text out 'missing/a.svg: No such file' '^'
}

the_end_of_input_ends_it() {
    says 'print 40+2' >dialogue
    printf 'wait \\n42\nwait ridgeline> \nkeys\ntype \\004\n' >>dialogue
    expect_status 0 at_terminal "$RIDGELINE" <dialogue >out
}

history_is_kept() {
    says 'print 1' 'print 2' 'print 2' quit | at_terminal "$RIDGELINE" >out
    [ "$(grep -c 'print' .ridgeline_history)" -eq 2 ]
}

without_a_terminal_it_reads_a_script() {
    printf 'set isosamples 8\nsplot x*y\nprint 40+2\n' | ridgeline >out
    grep -qx 42 out
    [ -s plot.svg ]
    printf 'splot x+*y\n' >bad
    expect_status 2 ridgeline <bad 2>err
    expect_text err '^'
}

the_tab_key_knows_words() {
    says 'uns\011hid\011' 'print 40+2; sho\011xyp\011' 'fro\011' quit | at_terminal "$RIDGELINE" >out
    expect_text out 42 'set xyplane' 'unknown command: fro'
    grep -q 'unset.*hidden3d' .ridgeline_history
}

if at_terminal true </dev/null >/dev/null 2>&1; then
    run_tests a_plot_at_the_prompt_becomes_plot_svg an_error_does_not_end_it outputs_can_be_chosen ctrl_c_takes_a_line_back \
        ctrl_c_ends_a_plot_that_takes_too_long ctrl_c_stops_a_plot_at_the_prompt ctrl_c_ends_a_pause \
        trouble_with_a_file_is_over_with_the_next_line the_end_of_input_ends_it history_is_kept the_tab_key_knows_words without_a_terminal_it_reads_a_script
else
    echo "# the prompt itself is not tested: no pseudo-terminal can be had here"
    run_tests without_a_terminal_it_reads_a_script
fi
