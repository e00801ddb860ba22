#!/bin/sh
# The language with every capacity at its smallest: built apart, because capacities are compiled in.
. tests/cli/lib.sh

capacities='-DCONFIG_LINE_MAX=80 -DCONFIG_LOAD_DEPTH=0 -DCONFIG_READ_CHUNK=16 -DCONFIG_PLOT_ITEMS=1 -DCONFIG_DATA_COLUMNS=3
    -DCONFIG_PLOT_CODE=64 -DCONFIG_JOINS=1 -DCONFIG_NAME_MAX=16 -DCONFIG_SYMBOLS=24 -DCONFIG_POOL=512 -DCONFIG_STACK=32
    -DCONFIG_CALLS=8'

a_session_with_the_smallest_capacities() {
    src=$root/src
    ls "$src"/error.c "$src"/said.c "$src"/num/*.c "$src"/lang/*.c "$src"/motion/machine.c "$src"/scene/*.c |
        xargs -P 2 -n 12 ${CC:-gcc} -std=c11 -O0 -D_DEFAULT_SOURCE $capacities -I"$src" -I"$root" -c
    ar rcs core.a ./*.o # of src/scene only what the language wants
    ${CC:-gcc} -std=c11 -O0 -D_DEFAULT_SOURCE $capacities -I"$src" -I"$root" "$root"/tests/small/small_session.c core.a -lcmocka -lm -o small
    ./small
}

run_tests a_session_with_the_smallest_capacities
