#!/bin/sh
# test_images.sh - what the link refuses, and the Pico's UF2 file read back.
build=${BUILDDIR:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
failed=0

# A program of one line on the smallest board: does it link, and if not, why?
link() { # body
    printf '#include <stdio.h>\n#include <stdlib.h>\nvolatile float f; volatile double d; volatile int i; char *volatile p;\nvoid start_reset(void) { %s; for (;;) continue; }\n' "$1" >"$work/a.c"
    arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb -Os -ffreestanding -nostartfiles --specs=nano.specs -Wl,--gc-sections -Llinker \
        -T linker/nrf51.ld "$work/a.c" -o "$work/a.elf" >"$work/said" 2>&1
}
refused() { # body, what the linker script says
    if ! link "$1" && grep -q ": $2\$" "$work/said"; then
        echo "[       OK ] $1 does not link: $2"
    else
        echo "$1 should not link"
        cat "$work/said"
        failed=$((failed + 1))
    fi
}
if link 'i = 3'; then echo '[       OK ] integers link'; else cat "$work/said"; failed=1; fi
refused 'p = malloc(8)' heap
refused 'sprintf(p, "%d", i)' stdio
refused 'f = f * i' float
refused 'd = d + i' double

if node - "$build/firmware/rp2040.uf2" "$build/firmware/rp2040.bin" <<'END'; then
const { readFileSync } = require('fs');
const [uf2, bin] = process.argv.slice(2).map((f) => readFileSync(f));
const want = (ok, what) => { if (!ok) { console.log('uf2: ' + what); process.exit(1); } };
const blocks = uf2.length / 512;
want(Number.isInteger(blocks) && blocks % 16 === 0, 'whole sectors of 4 KB');
want(blocks * 256 >= bin.length && (blocks - 16) * 256 < bin.length, 'as many as the image needs');
for (let i = 0; i < blocks; i++) {
  const u = (at) => uf2.readUInt32LE(512 * i + at);
  want(u(0) === 0x0a324655 && u(4) === 0x9e5d5157 && u(508) === 0x0ab16f30, 'magic numbers');
  want(u(8) === 0x2000 && u(28) === 0xe48bff56, 'family RP2040');
  want(u(12) === 0x10000000 + 256 * i && u(16) === 256 && u(20) === i && u(24) === blocks, 'addresses and numbers');
  for (let k = 0; k < 256; k++) {
    const at = 256 * i + k;
    want(uf2[512 * i + 32 + k] === (at < bin.length ? bin[at] : 0xff), 'contents');
  }
}
let crc = 0xffffffff;
for (let i = 0; i < 252; i++) {
  crc ^= bin[i] << 24;
  for (let k = 0; k < 8; k++) crc = crc & 0x80000000 ? (crc << 1) ^ 0x04c11db7 : crc << 1;
}
want(crc >>> 0 === bin.readUInt32LE(252), 'checksum of the boot loader');
console.log(`# rp2040.uf2: ${blocks} blocks, ${bin.length} bytes of image`);
END
    echo '[       OK ] rp2040.uf2: family, addresses, padding, checksum of the boot loader'
else
    failed=$((failed + 1))
fi
# The bound of the stack, which is no bound if there are calls through pointers that pointers.txt does not know.
bound() { # rules
    CROSS=arm-none-eabi- STALE=1 RULES=$1 sh firmware/tools/sizes.sh "$build/firmware" rp2040 lm3s6965 nrf51
}
doubted() { # rules, what is said about them
    if ! bound "$1" >"$work/sizes" && grep -q "^! .*$2" "$work/sizes"; then
        echo "[       OK ] a bound is not believed: $2"
    else
        echo "pointers.txt should be refused: $2"
        cat "$work/sizes"
        failed=$((failed + 1))
    fi
}
sed 's/|take_hidden|take_ink/|take_ink/' firmware/tools/pointers.txt >"$work/lacks_target"
sed 's/^wait_for_slot|/wait_for_none|/' firmware/tools/pointers.txt >"$work/lacks_rule"
sed 's/^dashes  *dash_piece/&|dash_nothing/' firmware/tools/pointers.txt >"$work/stale"
doubted "$work/lacks_target" 'in which line .* is take_hidden?'
doubted "$work/lacks_rule" 'what does .*wait_for_slot'
doubted "$work/stale" 'nothing any more: .*dash_nothing'
if bound firmware/tools/pointers.txt >"$work/sizes" 2>"$work/said" &&
    [ "$(awk 'NR > 1 && NR <= 4 && $5 > 2000' "$work/sizes" | wc -l)" = 3 ]; then
    echo '[       OK ] the stack of all images has a bound'
    sed -n '2,4s/^/# flash, RAM, stack room, stack bound: /p' "$work/sizes"
    sed 's/^/# /' "$work/said"
else
    cat "$work/sizes" "$work/said"
    failed=$((failed + 1))
fi
[ "$failed" -eq 0 ] && exit 0
echo "[  FAILED  ] $failed test(s), listed above"
exit 1
