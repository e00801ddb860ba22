#!/bin/sh
# `ridgeline trace`: what it says of traces that `ridgeline plot` made.
. tests/cli/lib.sh

a_trace_is_legal_and_equal_to_itself() {
    small_scene
    ridgeline plot small.gp -o a.vcd
    ridgeline trace a.vcd >out
    ! grep -q '^!' out
    ridgeline trace a.vcd a.vcd
}

another_drawing_differs() {
    printf 'set isosamples 8\nsplot x*y\nsplot x+y\n' | ridgeline plot - -o a.vcd
    expect_status 1 ridgeline trace a.vcd a-2.vcd
}

a_faster_machine_is_faster() {
    small_scene
    ridgeline plot small.gp -o a.vcd
    ridgeline plot small.gp --set 'set machine speed 50' -o b.vcd
    [ "$(grep '^#' a.vcd | tail -1 | tr -d '#')" -lt "$(grep '^#' b.vcd | tail -1 | tr -d '#')" ]
    ridgeline trace b.vcd
}

what_is_no_trace_is_bad_input() {
    echo hello >a.vcd
    expect_status 2 ridgeline trace a.vcd
    expect_status 2 ridgeline trace missing.vcd
    expect_status 2 ridgeline trace
}

run_tests a_trace_is_legal_and_equal_to_itself another_drawing_differs a_faster_machine_is_faster \
    what_is_no_trace_is_bad_input
