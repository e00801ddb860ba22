// ram_probe.mjs - does what makes steps and what stops them run from RAM? Flash is slow where the chip's cache has other code.
//
// A probe of rp2040.mjs: notes each function in flash of which an instruction is executed in PendSV (edges are planned),
// or in the interrupts of the alarm, the DMA and the switches. One that is not allowed fails the run.
import { execFileSync } from 'node:child_process';

const RAM = 0x20000000;
const WATCHED = [14, 16 + 1, 16 + 11, 16 + 13];
const ALLOWED = ['__aeabi_uidiv', '__udivsi3']; // twice every half millisecond while braking

export default function probe(mcu, elf) {
  const { core } = mcu, watched = new Uint8Array(64), at = new Set();
  for (const n of WATCHED) watched[n] = 1;
  let inRam = 0, exception = 0; // that pc is of: the instruction after it may be another's
  return {
    step(pc) {
      const seen = watched[exception];
      exception = core.IPSR;
      if (!seen) return false;
      if (pc >= RAM) inRam++;
      else at.add(pc);
      return false;
    },
    finish() {
      const symbols = execFileSync('arm-none-eabi-nm', ['-n', elf], { encoding: 'latin1' }).split('\n')
        .map((l) => /^(\w+) [tTwW] ([^$].*)$/.exec(l)).filter(Boolean).map((m) => ({ at: parseInt(m[1], 16), name: m[2] }));
      const names = new Set([...at].map((pc) => symbols.filter((s) => s.at <= pc).at(-1)?.name ?? pc.toString(16)));
      for (const name of names) if (!ALLOWED.includes(name)) mcu.logger.error('flash', `${name} is executed there in an interrupt of the steps`);
      if (!inRam) mcu.logger.error('ram', 'no interrupt of the steps');
    },
  };
}
