#!/bin/sh
# bench_count.sh BUILDDIR BOARD STIM - runs an image in QEMU; prints the instructions that evaluating, projecting and hiding a
# surface takes the first time that it gets through, which on these boards is to see whether it fits: nothing moves yet.
BUILDDIR=$1
export BUILDDIR
board=$2
. tests/emu/lib.sh
mkdir -p "$work/keep"
address() { arm-none-eabi-nm "$build/firmware/$board.elf" | awk -v n="$1" '$3 == n { print "0x" $1; exit }'; }
qemu_more="-plugin $build/emu/count.so,from=$(address picture_kernel_memory),to=$(address picture_close),out=$work/count"
"run_$board" "$3" 99 || cat "$work/emu.err" >&2
cat "$work/count"
