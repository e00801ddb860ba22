// rp2040.mjs - plays a test on a Pico's image (pico.mjs): pins into a VCD file, stim.h's files into console and
// switches, at exact virtual times.
//
//     node rp2040.mjs IMAGE.bin STIM OUT.vcd OUT.txt DRAWINGS [PROBE.mjs ARGUMENTS...]
//
// A probe's default export is given the emulator and the arguments; its step(pc, cycles, waiting) is called after every
// instruction and ends the run by returning true; finish() is called then.
// The run ends, too, when all has been played and no pin has moved for 30 s ($STILL_S). The file named by $STORE keeps the
// last 16 KB of flash for the next run. Any warning of the emulator fails the run.
import { readFileSync, openSync, writeSync, closeSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { mcu, core, clock, problems, complain, SIGNAL, BYTE_NS, watchPins, at, setInput, power, powerOn, keep, step, pass } from './pico.mjs';

const [image, stimFile, vcdFile, textFile, drawings, probeFile, ...probeArguments] = process.argv.slice(2);
const probe = probeFile ? (await import(pathToFileURL(probeFile))).default : null;
const QUIET_NS = 1e6 * Number(process.env.QUIET_MS ?? 20); // after the last drawing

// ---- the recording
const STILL_NS = 1e9 * Number(process.env.STILL_S ?? 30);
let moved = 0; // when a pin did, or the last thing to be played will be
let done = false, firstNs = -1, drawn = 0, written = -1, buffer = [];
const vcd = openSync(vcdFile, 'w');
const flush = () => {
  writeSync(vcd, buffer.join(''));
  buffer = [];
};
buffer.push('$timescale 1 ps $end\n$scope module plotter $end\n');
SIGNAL.forEach((name, i) => buffer.push(`$var wire 1 ${String.fromCharCode(33 + i)} ${name} $end\n`));
buffer.push('$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n');
SIGNAL.forEach((_, i) => buffer.push(`0${String.fromCharCode(33 + i)}\n`));
buffer.push('$end\n');
watchPins((signal, active) => {
  moved = Math.max(moved, clock.nanos);
  const ps = Math.round(clock.nanos * 1000);
  if (ps !== written) buffer.push(`#${ps}\n`);
  written = ps;
  buffer.push(`${active}${String.fromCharCode(33 + signal)}\n`);
  if (buffer.length > 10000) flush();
  if (firstNs < 0) {
    firstNs = clock.nanos;
    play(true);
  }
  if (signal === 5 && !active && ++drawn === Number(drawings)) at(clock.nanos + QUIET_NS, () => (done = true));
}, (process.env.TURNED ?? '').split(' '));

// ---- console and switches
let text = '';
mcu.uart[0].onByte = (byte) => (text += String.fromCharCode(byte));
const unescape = (s) =>
  s.replace(/\\(x..|.)/g, (_, e) =>
    e === 'r' ? '\r' : e === 'n' ? '\n' : e[0] === 'x' ? String.fromCharCode(parseInt(e.slice(1), 16)) : e);
const stims = readFileSync(stimFile, 'latin1').split('\n').filter((l) => l && !l.startsWith('#')).map((l) => {
  const [, time, verb, rest] = /^(\S+)\s+(\S+)\s?(.*)$/.exec(l);
  return { relative: time[0] === '+', ns: parseFloat(time) * 1000, verb, rest };
});
function play(relative) {
  const origin = relative ? clock.nanos : 0;
  for (const s of stims) {
    if (s.relative !== relative) continue;
    const ns = origin + s.ns;
    moved = Math.max(moved, ns);
    if (s.verb === 'type') [...unescape(s.rest)].forEach((c, i) => at(ns + i * BYTE_NS, () => mcu.uart[0].feedByte(c.charCodeAt(0))));
    else if (s.verb === 'fault') { // a byte as the UART's data register tells it, with its error bits
      at(ns, () => mcu.uart[0].feedByte(Number(s.rest)));
    } else if (s.verb === 'input') {
      const [name, value] = s.rest.split(' ');
      at(ns, () => setInput(name, value === '1'));
    } else if (s.verb === 'poke') at(ns, () => poke(...s.rest.split(' ').map(Number)));
    else if (s.verb === 'heal') at(ns, () => poked.forEach(([address, value]) => write16(address, value)));
    else if (s.verb === 'quit') at(ns, () => (done = power.off = true));
    else complain('stim', s.verb);
  }
}
const poked = [];
const write16 = (address, value) =>
  address >= 0x20000000 ? mcu.writeUint16(address, value) : new DataView(mcu.flash.buffer).setUint16(address & 0xffffff, value, true);
function poke(address, value) {
  poked.push([address, mcu.readUint16(address)]);
  write16(address, value);
}
const store = process.env.STORE;
powerOn(image, store);
play(false);

const probed = probe?.(mcu, ...probeArguments);
while (!done) {
  const pc = core.PC, waiting = core.waiting;
  // A program that goes round in one instruction waits, too.
  const stuck = poked.length && !core.waiting && mcu.readUint16(pc) === 0xe7fe && !core.checkForInterrupts();
  const cycles = step(stuck);
  if (probed?.step(pc, cycles, waiting)) done = true;
  pass(cycles);
  if (problems.length || clock.nanos > moved + STILL_NS) done = true;
}
buffer.push(`#${Math.round(clock.nanos * 1000)}\n`);
flush();
closeSync(vcd);
writeFileSync(textFile, text, 'latin1');
if (store) keep(store);
probed?.finish(text);
for (const p of problems) console.error(`rp2040js: ${p}`);
process.exit(problems.length ? 1 : 0);
