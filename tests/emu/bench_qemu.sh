#!/bin/sh
# bench_qemu.sh BUILDDIR BOARD STIM - runs an image in QEMU until the stimulus quits; prints what its console said.
BUILDDIR=$1
export BUILDDIR
board=$2
. tests/emu/lib.sh
mkdir -p "$work/keep"
"run_$board" "$3" 99 || cat "$work/emu.err" >&2
cat "$work/emu.txt"
