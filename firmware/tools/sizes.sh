#!/bin/sh
# sizes.sh DIR BOARD... - flash, RAM and a bound of the stack of each image. RAM is static data; the stack has what is left.
# PATHS=1 prints the way to the deepest point, too.
dir=$1
shift
printf '%-10s %10s %10s %12s %12s\n' board 'flash' 'RAM' 'stack room' 'stack bound'
for board in "$@"; do
    elf=$dir/$board.elf
    set -- $("${CROSS}size" "$elf" | tail -1)
    room=$("${CROSS}nm" "$elf" | awk '$3 == "_stack_top" { t = $1 } $3 == "_stack_bottom" { b = $1 } END { print t, b }')
    room=$((0x${room% *} - 0x${room#* }))
    own=firmware/tools/pointers_$board.txt
    [ -e "$own" ] || own=
    worst=$({ cat $own firmware/tools/pointers.txt; "${CROSS}objdump" -t -s -j .text -j .data "$elf"; "${CROSS}objdump" -d --no-show-raw-insn "$elf"; } |
        awk -f firmware/tools/stack.awk)
    printf '%-10s %10d %10d %12d %12s\n' "$board" $(($1 + $2)) $(($2 + $3)) "$room" "${worst%% *}"
    [ "${worst%% *}" -le "$room" ] || echo "! $board: the stack may run over (PATHS=1 tells where)"
    [ -n "$PATHS" ] && printf '    %s\n' "${worst#* }"
done
echo 'The bound is of all functions that can call one another, interrupts included, as firmware/tools/pointers.txt tells. What'
echo 'drawings really took is told by `memory` at the console, and in docs/NUMBERS.md.'
