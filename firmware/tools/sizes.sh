#!/bin/sh
# sizes.sh DIR BOARD... - flash, RAM and a bound of the stack of each image. RAM is static data; the stack has what is left.
# PATHS=1 prints the way to the deepest point, too. Fails if a bound is more than there is, or if pointers.txt does not say all that
# a bound depends on; with STALE=1 (tests/emu/test_images.sh) also if it says what is not so any more (of all boards together).
dir=$1
shift
boards=$*
rules=${RULES:-firmware/tools/pointers.txt} # another one is for its test
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
printf '%-10s %10s %10s %12s %12s\n' board 'flash' 'RAM' 'stack room' 'stack bound'
for board in $boards; do
    elf=$dir/$board.elf
    set -- $("${CROSS}size" "$elf" | tail -1)
    room=$("${CROSS}nm" "$elf" | awk '$3 == "_stack_top" { t = $1 } $3 == "_stack_bottom" { b = $1 } END { print t, b }')
    room=$((0x${room% *} - 0x${room#* }))
    "${CROSS}objdump" -d --no-show-raw-insn "$elf" >"$work/code"
    own=firmware/tools/pointers_$board.txt
    [ -e "$own" ] || own=
    {
        cat $own "$rules"
        sed -n 's/^ *\([0-9a-f]*\):\tblx\{0,1\}\tr[0-9].*/\1/p' "$work/code" | "${CROSS}addr2line" -afi -e "$elf"
        "${CROSS}readelf" -rW "$elf"
        "${CROSS}objdump" -t -s -j .text -j .data "$elf"
        cat "$work/code"
    } | awk -f firmware/tools/stack.awk >"$work/said"
    worst=$(head -1 "$work/said")
    sed -n 's/^used //p' "$work/said" >>"$work/used"
    printf '%-10s %10d %10d %12d %12s\n' "$board" $(($1 + $2)) $(($2 + $3)) "$room" "${worst%% *}"
    if grep "^!" "$work/said"; then failed=1; fi
    [ "${worst%% *}" -le "$room" ] || { echo "! $board: the stack may run over (PATHS=1 tells where)" && failed=1; }
    [ -n "$PATHS" ] && printf '    %s\n' "${worst#* }"
done
if [ "$(echo "$boards" | wc -w)" -ge 3 ]; then
    cat firmware/tools/pointers_*.txt "$rules" | awk '/^#/ || !NF { next } $2 == "->" { print $1; next }
        $2 == "without" || $2 == "under" { print $1; print $3; next } { print $2 }' | tr '|' '\n' | sort -u >"$work/words"
    sort -u "$work/used" | comm -23 "$work/words" - >"$work/stale"
    [ -s "$work/stale" ] && [ -n "$STALE" ] && failed=1
    [ -s "$work/stale" ] && echo "! pointers.txt is about nothing any more: $(tr '\n' ' ' <"$work/stale")"
fi
echo 'The bound is of all functions that can call one another, interrupts included, as firmware/tools/pointers.txt tells. What'
echo 'drawings really took is told by `memory` at the console, and in docs/NUMBERS.md.'
exit $failed
