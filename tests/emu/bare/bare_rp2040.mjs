// bare_rp2040.mjs - runs a program of bare.h in rp2040js, from flash: prints what it prints, and writes its cycles down at each
// bare_mark().
//
//     node bare_rp2040.mjs PROGRAM.bin MARK_ADDRESS OUT.txt
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
const require = createRequire(pathToFileURL(process.env.EMU_MODULES + '/'));
const { RP2040 } = require('rp2040js');

const [image, markAt, out] = process.argv.slice(2);
const FLASH = 0x10000000;
const mcu = new RP2040();
const { core } = mcu;
let done = false, failed = false;
const complain = (from, text) => {
  console.error(`${from}: ${text}`);
  failed = done = true;
};
mcu.logger = { debug() {}, info() {}, warn: complain, error: complain };
mcu.flash.set(readFileSync(image));
mcu.onBreak = (code) => {
  const [r0, r1] = core.registers;
  if (code !== 0xab) complain('core', `breakpoint ${code}`);
  else if (r0 === 4) {
    let text = '';
    for (let at = r1, c; (c = mcu.readUint8(at)) !== 0; at++) text += String.fromCharCode(c);
    process.stdout.write(text);
  } else if (r0 === 0x15) mcu.writeUint8(mcu.readUint32(r1), 0); // no arguments
  else {
    done = true;
    failed = r0 !== 0x18 || r1 !== 0x20026;
  }
};
core.VTOR = FLASH;
core.reset();
const mark = parseInt(markAt, 16) & ~1;
const counts = [];
let cycles = 0;
while (!done) {
  if (core.PC === mark) counts.push(cycles);
  cycles += core.executeInstruction();
}
writeFileSync(out, counts.join('\n') + '\n');
process.exit(failed ? 1 : 0);
