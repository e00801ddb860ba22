#!/bin/sh
# sizes.sh DIR BOARD... - flash, RAM and a bound of the stack of each image. RAM is static data; the stack has what is left.
# The bound is loose: see stack.awk on calls through pointers. What drawings take is measured on the boards themselves.
dir=$1
shift
printf '%-10s %10s %10s %12s %12s\n' board 'flash' 'RAM' 'stack room' 'stack bound'
for board in "$@"; do
    set -- $("${CROSS}size" "$dir/$board.elf" | tail -1)
    room=$("${CROSS}nm" "$dir/$board.elf" | awk '$3 == "_stack_top" { t = $1 } $3 == "_stack_bottom" { b = $1 } END { print t, b }')
    room=$((0x${room% *} - 0x${room#* }))
    worst=$(find "$dir/$board" -name '*.ci' | sort | xargs awk -f firmware/tools/stack.awk | cut -d' ' -f1)
    [ "$worst" -lt 1000 ] && worst=- # a compiler cache does not keep the call graph
    printf '%-10s %10d %10d %12d %12s\n' "$board" $(($1 + $2)) $(($2 + $3)) "$room" "$worst"
done
echo 'The bound takes every call through a pointer to reach the deepest function there is. What drawings really took'
echo 'is told by `memory` at the console, and in docs/NUMBERS.md.'
