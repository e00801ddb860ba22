#!/bin/sh
# try.sh BOARD BUILD [NAME] - the console of an emulated board in this terminal (try.mjs); what is drawn and kept goes to BUILD/try/NAME.*.
. tests/emu/qemu.sh
export EMU_MODULES="$2/emu" QEMU_SAYS
to=$2/try/${3:-$1}
mkdir -p "$2/try"
if [ "$1" = rp2040 ]; then exec node tests/emu/try.mjs "$to.svg" pico "$2/firmware/rp2040.bin" "$to.flash"; fi
run_by="node tests/emu/try.mjs $to.svg qemu" serial=stdio more= turned=
qemu "$1" "$2" "$to.flash" live=1
