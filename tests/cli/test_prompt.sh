#!/bin/sh
# The prompt, on a terminal that `script` pretends to be.
. tests/cli/lib.sh

export HOME=. TERM=dumb

# Types stdin into the program's terminal.
at_terminal() { script -qec "$*" /dev/null; }

a_plot_at_the_prompt_becomes_plot_svg() {
    printf 'set isosamples 8\nsplot x*y\nsplot x+y\nquit\n' | at_terminal "$RIDGELINE" >out
    expect_text out 'ridgeline> ' plot.svg
    [ -s plot.svg ]
    [ ! -e plot-2.svg ]
}

an_error_does_not_end_it() {
    printf 'splot x+*y\nprint 40+2\nquit\n' | at_terminal "$RIDGELINE" >out
    expect_text out '^' 42
    [ ! -e plot.svg ]
}

outputs_can_be_chosen() {
    printf 'set isosamples 8\nsplot x*y\nquit\n' | at_terminal "$RIDGELINE -o a.seg -o a.png --set 'set paper a5'" >out
    [ -s a.seg ]
    [ -s a.png ]
    [ ! -e plot.svg ]
}

ctrl_c_takes_a_line_back() {
    {
        sleep 0.4; printf 'print 41'; sleep 0.2; printf '\003'
        sleep 0.2; printf 'splot "-"\n'; sleep 0.2; printf '\003'
        sleep 0.2; printf 'print 40+2\nquit\n'
    } | at_terminal "$RIDGELINE" >out
    tr -d '\r' <out | grep -qx 42
}

history_is_kept() {
    printf 'print 1\nprint 2\nprint 2\nquit\n' | at_terminal "$RIDGELINE" >out
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

a_long_job_says_how_far_it_is() {
    printf 'set isosamples 3000\nset view from 6,8,3\nsplot exp(-x**2-y**2)\n' >long.gp
    at_terminal "$RIDGELINE plot long.gp" </dev/null >out
    grep -q '%' out
}

if script -qec true /dev/null </dev/null >/dev/null 2>&1; then
    run_tests a_plot_at_the_prompt_becomes_plot_svg an_error_does_not_end_it outputs_can_be_chosen ctrl_c_takes_a_line_back history_is_kept \
        without_a_terminal_it_reads_a_script a_long_job_says_how_far_it_is
else
    echo "# the prompt itself is not tested: no pseudo-terminal can be had here"
    run_tests without_a_terminal_it_reads_a_script
fi
