// bench_probe.mjs - where a Pico's cycles go, watched from outside: rp2040.mjs asks it after every instruction.
//
// A phase begins at the first instruction of a function and ends where that returns to. Its cycles are its own: those of
// phases inside it, of interrupts, and of waiting for the machine are counted apart. The board's program knows nothing
// of this.
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';

const FLASH = 0x10000000;
// The functions that begin a phase.
const PHASES = {
  measure: ['grid_measure'],
  build: ['solid_build'],
  once: ['once_build'],
  view: ['picture_camera', 'page_map_setup', 'solid_map_setup'],
  hide: ['perimeter_draw_several', 'plain_draw', 'horizon_draw', 'convex_draw', 'halo_ink_draw'],
  evaluate: ['expr_run'],
  ink: ['join_piece', 'path_finish', 'path_advance'],
  motion: ['pen_move', 'pen_draw', 'carriage_begin', 'carriage_end'],
};

function symbolsOf(elf) {
  return execFileSync('arm-none-eabi-nm', ['-S', elf], { encoding: 'latin1' }).split('\n')
    .map((l) => /^(\w+) (\w+) [tTwW] (.+)$/.exec(l)).filter(Boolean)
    .map((m) => ({ at: parseInt(m[1], 16) & ~1, size: parseInt(m[2], 16), name: m[3] }))
    .filter((s) => s.at >= FLASH && s.size > 0).sort((a, b) => a.at - b.at);
}

// until: what ends the run: `hidden` (all is hidden, ordering begins), `step` (the machine begins to move), `pen` (the pen is
// lowered), `again` (it is lowered after a ctrl-X and another line), or `quit` of the stimulus. out: where the report goes, as JSON. profile: how many of the dearest functions to list.
export default function probe(mcu, elf, until, out, profile = '0') {
  const { core, clock } = mcu;
  const symbols = symbolsOf(elf);
  const of = new Int32Array(1 << 20).fill(-1); // by halfword of flash: the function
  symbols.forEach((s, i) => of.fill(i, (s.at - FLASH) >> 1, (s.at - FLASH + s.size) >> 1));
  const enters = new Map();
  for (const [phase, names] of Object.entries(PHASES))
    for (const s of symbols) if (names.includes(s.name)) enters.set(s.at, phase);
  const tell = symbols.find((s) => s.name === 'picture_tell').at;
  const interesting = new Uint8Array(1 << 20);
  const finish = symbols.find((s) => s.name === 'path_finish').at;
  const draw = symbols.find((s) => s.name === 'picture_draw').at; // before it, it may have been tried whether all fits,
  const only = symbols.find((s) => s.name === 'picture_measure')?.at; // or only measured, which counts
  for (const a of [...enters.keys(), tell, draw, only]) interesting[(a - FLASH) >> 1] = 1;

  const ms = {}; // when what happened first
  const note = (what) => (ms[what] ??= clock.nanos / 1e6);
  const feed = mcu.uart[0].feedByte.bind(mcu.uart[0]);
  mcu.uart[0].feedByte = (byte) => {
    if (byte === 24) ms.stopped = clock.nanos / 1e6;
    if (byte === 13) {
      ms.line = clock.nanos / 1e6;
      delete ms.step;
      delete ms.pen;
    }
    feed(byte);
  };
  // Pins are set up at power-on; what counts is what they do after the line.
  const watch = (gpio, what) => mcu.gpio[gpio].addListener((state) => state === 1 && ms.line && note(what));
  watch(2, 'step');
  watch(4, 'step');
  watch(6, 'pen');

  const flat = new Float64Array(symbols.length + 1);
  const cycles = { other: 0, interrupts: 0, waiting: 0 };
  for (const phase of Object.keys(PHASES)) cycles[phase] = 0;
  const stack = [];
  let kept = false, phase = 'other', back = -1, backSP = 0, stage = -1, low = 0x7fffffff;
  return {
    step(pc, n, waiting) {
      if (core.SP < low && stage >= 0) low = core.SP;
      if ((until === 'step' || until === 'pen') && ms[until] !== undefined) return true;
      if (until === 'again' && ms.line > ms.stopped && ms.pen !== undefined) return true;
      if (waiting) {
        cycles.waiting += n;
        return false;
      }
      if (core.IPSR) {
        cycles.interrupts += n;
        return false;
      }
      const k = ((pc - FLASH) >>> 1) & 0xfffff;
      while (pc === back && core.SP >= backSP) ({ phase, back, backSP } = stack.pop());
      if (interesting[k]) {
        if (pc === only) kept = true;
        if (pc === draw && !kept) Object.keys(cycles).forEach((c) => (cycles[c] = 0));
        if (pc === tell && core.registers[1] !== stage) {
          stage = core.registers[1];
          if (stage === 0 && !(kept && cycles.measure)) Object.keys(cycles).forEach((c) => (cycles[c] = 0));
        }
        if (pc === finish) {
          note('hidden');
          if (until === 'hidden') return true;
        }
        const next = enters.get(pc);
        if (next) {
          stack.push({ phase, back, backSP });
          phase = next;
          back = core.LR & ~1;
          backSP = core.SP;
        }
      }
      cycles[phase] += n;
      if (stage >= 0) flat[of[k] + 1] += n;
      return false;
    },
    finish() {
      const top = symbols.map((s, i) => [s.name, flat[i + 1]]).filter((s) => s[1]).sort((a, b) => b[1] - a[1]);
      writeFileSync(out, JSON.stringify({ cycles, ms, stack: low, top: top.slice(0, Number(profile)) }));
    },
  };
}
