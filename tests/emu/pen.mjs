// pen.mjs - is a servo's or a solenoid's signal, as recorded at the pin, what the pen's changes on the simulator ask for?
//
//     node pen.mjs SIM.vcd EMU.vcd servo UP_US DOWN_US GLIDE_S
//     node pen.mjs SIM.vcd EMU.vcd solenoid PULL_S HOLD_PERCENT [PERIOD_US TOLERANCE_US]
//
// Prints what was measured, or what is wrong. Then takes the pen out of both files, so that the other pins can be compared.
import { readFileSync, writeFileSync } from 'node:fs';

const [simFile, emuFile, kind, ...numbers] = process.argv.slice(2);
const [a, b, third = 40, within = 0.02] = numbers.map(Number);
const EARLY_US = 2; // an edge of the pen's own, by the tests' tolerance
const TICK_US = 1000; // the firmware looks at the pen's bit so often

// Changes of the pen in us, the time of the first change of any other pin, and the file without the pen.
function read(name) {
  let us = 0, scale = 1, first = -1, started = false, id = '';
  const pen = [], rest = [];
  for (const line of readFileSync(name, 'latin1').split('\n')) {
    const unit = /\$timescale\s+(\d+)\s*(\w+)/.exec(line);
    const signal = /\$var wire 1 (\S+) pen\b/.exec(line);
    if (signal) id = signal[1];
    if (unit) scale = Number(unit[1]) * { ps: 1e-6, ns: 1e-3, us: 1 }[unit[2]];
    if (/^#\d+$/.test(line)) us = Number(line.slice(1)) * scale;
    if (started && /^[01]./.test(line)) {
      if (line.slice(1) === id) {
        pen.push({ us, level: Number(line[0]) });
        continue;
      }
      if (first < 0) first = us;
    }
    if (line === '$end') started = true; // of the initial values
    rest.push(line);
  }
  writeFileSync(name, rest.filter((l, i) => !(/^#\d+$/.test(l) && /^#\d+$/.test(rest[i + 1] ?? ''))).join('\n'));
  return { pen, first, end: us };
}

const sim = read(simFile), emu = read(emuFile);
const problems = [];
const wrong = (us, what) => problems.push(`${((us - emu.first) / 1e6).toFixed(6)} s after the first edge: ${what}`);
// The simulator's changes, on the emulator's clock.
const change = sim.pen.map((p) => ({ us: p.us - sim.first + emu.first, level: p.level }));
if (change.length < 4) wrong(emu.first, 'the pen hardly moves in this scene');

// Pulses: where they begin and how wide they are. QEMU does not model that the LM3S6965's pads can be off for some cycles.
const OFF_US = 0.1, pulses = [];
for (let i = 0; i + 1 < emu.pen.length; i++)
  if (emu.pen[i].level && emu.pen[i + 1].us - emu.pen[i].us > OFF_US) pulses.push({ us: emu.pen[i].us, width: emu.pen[i + 1].us - emu.pen[i].us });

function judgeServo() {
  const PERIOD = 20000, glideUs = third * 1e6;
  let widest = 0, slowest = 0, between = 0, before = 0;
  pulses.forEach((p, i) => {
    if (i && Math.abs(p.us - pulses[i - 1].us - PERIOD) > 1) wrong(p.us, `${p.us - pulses[i - 1].us} us after the pulse before`);
    const last = change.filter((c) => c.us <= p.us).at(-1) ?? { us: -Infinity, level: 0 };
    const to = last.level ? b : a, from = last.level ? a : b;
    const since = p.us - last.us, off = Math.abs(p.width - to);
    if (p.us < emu.first) before++;
    if (since > PERIOD + TICK_US + glideUs) {
      widest = Math.max(widest, off);
      if (off > 1) wrong(p.us, `${p.width} us wide, not ${to}`);
    } else if (off > 1) {
      // On its way: never beyond the ends, and where an even way puts it, a period and a tick late at most.
      slowest = Math.max(slowest, since);
      const part = (t) => from + (to - from) * (glideUs ? Math.min(1, Math.max(0, t / glideUs)) : t > 0 ? 1 : 0);
      const ends = [part(since - PERIOD - TICK_US), part(since + TICK_US)].sort((x, y) => x - y);
      if (p.width < ends[0] - 2 || p.width > ends[1] + 2) wrong(p.us, `${p.width} us wide on its way, not ${ends}`);
      if (p.width > Math.min(from, to) + 1 && p.width < Math.max(from, to) - 1) between++;
    }
  });
  if (before < 3) wrong(emu.first, 'no pulses before the motors are on');
  if (emu.end - pulses.at(-1).us > PERIOD + b) wrong(emu.end, 'no pulses at the end');
  return `${pulses.length} pulses, ${before} before the motors were on, 20,000 us apart, ${widest.toFixed(3)} us at most beside ${a} or ${b} us;` +
    ` ${change.length} changes of the pen, ${between ? `each on its way for ${(slowest / 1000).toFixed(1)} ms at most, by ${between} pulses between` : 'each by the next pulse'}`;
}

function judgeSolenoid() {
  const PERIOD = third, pullUs = a * 1e6;
  let latest = 0, pulled = [Infinity, 0], held = 0, off = 0;
  for (let i = 0; i < change.length; i++) {
    if (!change[i].level) continue;
    const down = change[i].us, up = change[i + 1]?.us ?? emu.end;
    const mine = pulses.filter((p) => p.us >= down - EARLY_US && p.us < up + TICK_US + PERIOD);
    if (!mine.length) {
      wrong(down, 'no power');
      continue;
    }
    latest = Math.max(latest, mine[0].us - down);
    if (mine[0].us - down > TICK_US + PERIOD) wrong(down, `power only after ${mine[0].us - down} us`);
    pulled = [Math.min(pulled[0], mine[0].width), Math.max(pulled[1], mine[0].width)];
    if (Math.abs(mine[0].width - pullUs) > TICK_US + PERIOD && up - down > pullUs + TICK_US) wrong(down, `pulls for ${mine[0].width} us`);
    mine.slice(1).forEach((p, k) => {
      if (Math.abs(p.us + p.width - up) <= EARLY_US) return; // cut short by the pen's edge
      held++;
      off = Math.max(off, Math.abs(p.width - (PERIOD * b) / 100));
      if (Math.abs(p.width - (PERIOD * b) / 100) > within) wrong(p.us, `holds with ${p.width} of ${PERIOD} us`);
      if (k && Math.abs(p.us - mine[k].us - PERIOD) > within) wrong(p.us, `holds again after ${p.us - mine[k].us} us`);
    });
    const ended = mine.at(-1).us + mine.at(-1).width;
    if (ended > up + TICK_US + PERIOD || ended < up - PERIOD) wrong(up, `power ends ${ended - up} us later`);
  }
  const stray = pulses.filter((p) => !change.some((c, i) => c.level && p.us >= c.us - EARLY_US && p.us < (change[i + 1]?.us ?? emu.end) + TICK_US + PERIOD));
  if (stray.length) wrong(stray[0].us, `power while the pen is up, ${stray.length} times`);
  return `${change.length} changes of the pen: power after ${latest.toFixed(1)} us at most, all of it for ${pulled[0].toFixed(0)} to ${pulled[1].toFixed(0)} us, then ${held} pulses of ${b} % at ${1000 / PERIOD} kHz, ${off.toFixed(3)} us at most beside`;
}

const text = kind === 'servo' ? judgeServo() : judgeSolenoid();
if (problems.length) {
  console.log(`the ${kind}'s signal is wrong:`);
  for (const p of problems.slice(0, 10)) console.log(`  ${p}`);
  process.exit(1);
}
console.log(`# ${kind}: ${text}`);
