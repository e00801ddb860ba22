// rp2040.mjs - runs a Pico's image in rp2040js, watched from outside: pins into a VCD file, stim.h's files into console and
// switches, at exact virtual times.
//
//     node rp2040.mjs IMAGE.bin STIM OUT.vcd OUT.txt DRAWINGS [PROBE.mjs ARGUMENTS...]
//
// A probe's default export is given the emulator and the arguments; its step(pc, cycles, waiting) is called after every
// instruction and ends the run by returning true; finish() is called then.
// The package's own run loop is not used: time is advanced instruction by instruction, and what was pending before WFI ends it.
// The boot ROM is stood in for: the boot loader's checksum is checked, it is copied to RAM and entered, as the ROM does; and
// flash routines are found where the ROM has them. The run ends, too, when all has been played and no pin has moved for 30 s ($STILL_S). The file named by $STORE keeps the last 16 KB of flash for the next run. Any warning of the emulator fails the run.
import { readFileSync, openSync, writeSync, closeSync, writeFileSync, existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
const require = createRequire(pathToFileURL(process.env.EMU_MODULES + '/'));
const { RP2040, GPIOPinState } = require('rp2040js');

const [image, stimFile, vcdFile, textFile, drawings, probeFile, ...probeArguments] = process.argv.slice(2);
const probe = probeFile ? (await import(pathToFileURL(probeFile))).default : null;
const BIT_NS = 1e9 / 115200;
const QUIET_NS = 1e6 * Number(process.env.QUIET_MS ?? 20); // after the last drawing
const PIN = { 2: [0, 0], 3: [1, 0], 4: [2, 0], 5: [3, 0], 6: [4, 0], 7: [5, 1] }; // GPIO: signal, active low
const TURNED = (process.env.TURNED ?? '').split(' '); // signals whose level is turned round
const SIGNAL = ['x_step', 'x_dir', 'y_step', 'y_dir', 'pen', 'enable'];
const INPUT = { limit_x: 10, limit_y: 11, button: 12, estop: 13 };

const mcu = new RP2040();
const { core, clock } = mcu;
const problems = [];
const complain = (from, text) => {
  if (problems.length < 20) problems.push(`${from}: ${text}`);
};
mcu.logger = { debug() {}, info() {}, warn: complain, error: complain };
mcu.onBreak = (code) => romCall(code);

// ---- what the boot ROM offers
const rom = new Uint16Array(mcu.bootrom.buffer);
const ROM_NAMES = ['IF', 'EX', 'RE', 'RP', 'FC', 'CX'];
const ROM_LOOKUP = 0x7f, ROM_FIRST = 0x40;
rom[0x14 / 2] = 0x300;
rom[0x18 / 2] = 0x201;
rom[0x200 / 2] = 0xbe00 | ROM_LOOKUP; // bkpt; bx lr
rom[0x202 / 2] = 0x4770;
ROM_NAMES.forEach((_, i) => {
  rom[(0x100 + 4 * i) / 2] = 0xbe00 | (ROM_FIRST + i);
  rom[(0x102 + 4 * i) / 2] = 0x4770;
});
let writable = false;
function romCall(code) {
  const r = core.registers;
  if (code === ROM_LOOKUP) {
    const i = ROM_NAMES.findIndex((s) => (s.charCodeAt(0) | (s.charCodeAt(1) << 8)) === r[1]);
    r[0] = i < 0 ? 0 : (0x100 + 4 * i) | 1;
    return;
  }
  const name = ROM_NAMES[code - ROM_FIRST];
  if (name === 'EX') writable = true;
  else if (name === 'CX') writable = false;
  else if (name === 'RE') {
    if (!writable || r[0] & 4095 || r[1] & 4095) complain('flash', 'erase');
    mcu.flash.fill(0xff, r[0], r[0] + r[1]);
    clock.tick(45e6);
  } else if (name === 'RP') {
    if (!writable || r[0] & 255 || r[2] & 255) complain('flash', 'program');
    for (let i = 0; i < r[2]; i++) mcu.flash[r[0] + i] &= mcu.readUint8(r[1] + i);
    clock.tick((0.7e6 * r[2]) / 256);
  } else if (name === undefined) {
    complain('core', `breakpoint ${code}`);
    done = true;
  }
}

// ---- PIO by virtual time. The package runs it by a timer of the host, without its clock divider; its queues cannot be joined.
for (const pio of mcu.pio) {
  pio.run = () => {};
  for (const sm of pio.machines) {
    const { checkWait, writeUint32 } = sm;
    const periodNs = () => ((sm.clockDivInt || 65536) + sm.clockDivFrac / 256) * (1e9 / mcu.clkSys);
    let on = false;
    const alarm = clock.createAlarm(() => {
      sm.step();
      pio.checkChangedPins();
      if (sm.waiting) return;
      let n = 1;
      if (pio.instructions[sm.pc] === (0x40 | sm.pc)) { // a loop that only counts x down
        n += sm.x;
        sm.x = 0;
      }
      alarm.schedule(n * periodNs());
    });
    sm.clkDivRestart = () => {};
    sm.checkWait = () => {
      const was = sm.waiting;
      checkWait.call(sm);
      if (was && !sm.waiting && on) alarm.schedule(periodNs());
    };
    sm.writeUint32 = (offset, value) => {
      if (offset === 8 && (sm.shiftCtrl ^ value) & 0xc0000000) {
        sm.txFIFO = new sm.txFIFO.constructor(value & 0x40000000 ? 8 : 4);
        sm.updateDMATx();
      }
      writeUint32.call(sm, offset, value);
    };
    sm.enabledChanged = () => {
      if (sm.enabled === on) return;
      on = sm.enabled;
      if (on && !sm.waiting) alarm.schedule(periodNs());
      else alarm.cancel();
    };
  }
  const { writeUint32 } = pio;
  pio.writeUint32 = (offset, value) => {
    writeUint32.call(pio, offset, value);
    for (const sm of pio.machines) sm.enabledChanged();
    pio.checkChangedPins();
  };
}

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
const level = [0, 0, 0, 0, 0, 0];
for (const gpio of Object.keys(PIN)) {
  const [signal, usual] = PIN[gpio], low = usual ^ TURNED.includes(SIGNAL[signal]);
  mcu.gpio[gpio].addListener((state) => {
    const driven = state === GPIOPinState.High || state === GPIOPinState.Low; // else the resistor's: at rest
    const active = driven ? (state === GPIOPinState.High ? 1 : 0) ^ low : 0;
    if (active === level[signal]) return;
    level[signal] = active;
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
  });
}

// ---- console and switches
let text = '';
const { writeUint32: writeUart } = mcu.uart[0];
mcu.uart[0].writeUint32 = (offset, value) => {
  if (offset !== 4) writeUart.call(mcu.uart[0], offset, value); // RSR, which the package lacks: clears errors
};
mcu.uart[0].onByte = (byte) => (text += String.fromCharCode(byte));
const at = (ns, what) => clock.createAlarm(what).schedule(Math.max(0, ns - clock.nanos));
const unescape = (s) =>
  s.replace(/\\(x..|.)/g, (_, e) =>
    e === 'r' ? '\r' : e === 'n' ? '\n' : e[0] === 'x' ? String.fromCharCode(parseInt(e.slice(1), 16)) : e);
const stims = readFileSync(stimFile, 'latin1').split('\n').filter((l) => l && !l.startsWith('#')).map((l) => {
  const [, time, verb, rest] = /^(\S+)\s+(\S+)\s?(.*)$/.exec(l);
  return { relative: time[0] === '+', ns: parseFloat(time) * 1000, verb, rest };
});
const setInput = (pin, value) => {
  if (mcu.gpio[pin].rawInputValue !== value) mcu.gpio[pin].setInputValue(value);
};
function play(relative) {
  const origin = relative ? clock.nanos : 0;
  for (const s of stims) {
    if (s.relative !== relative) continue;
    const ns = origin + s.ns;
    moved = Math.max(moved, ns);
    if (s.verb === 'type') [...unescape(s.rest)].forEach((c, i) => at(ns + i * 10 * BIT_NS, () => mcu.uart[0].feedByte(c.charCodeAt(0))));
    else if (s.verb === 'fault') { // a byte as the UART's data register tells it, with its error bits
      at(ns, () => mcu.uart[0].feedByte(Number(s.rest)));
    } else if (s.verb === 'input') {
      const [name, value] = s.rest.split(' ');
      at(ns, () => setInput(INPUT[name], value !== '1'));
    } else if (s.verb === 'poke') at(ns, () => poke(...s.rest.split(' ').map(Number)));
    else if (s.verb === 'heal') at(ns, () => poked.forEach(([address, value]) => write16(address, value)));
    else if (s.verb === 'quit') at(ns, () => (done = true));
    else complain('stim', s.verb);
  }
}
for (const pin of Object.values(INPUT)) setInput(pin, true);
const poked = [];
const write16 = (address, value) =>
  address >= 0x20000000 ? mcu.writeUint16(address, value) : new DataView(mcu.flash.buffer).setUint16(address & 0xffffff, value, true);
function poke(address, value) {
  poked.push([address, mcu.readUint16(address)]);
  write16(address, value);
}

// ---- power on: what the boot ROM does
mcu.flash.fill(0xff);
mcu.flash.set(readFileSync(image), 0);
const STORE_AT = 0x200000 - 16384, store = process.env.STORE;
if (store && existsSync(store)) mcu.flash.set(readFileSync(store), STORE_AT);
const boot = mcu.flash.slice(0, 256);
let crc = 0xffffffff;
for (let i = 0; i < 252; i++) {
  crc ^= boot[i] << 24;
  for (let k = 0; k < 8; k++) crc = crc & 0x80000000 ? (crc << 1) ^ 0x04c11db7 : crc << 1;
}
if (crc >>> 0 !== new DataView(boot.buffer).getUint32(252, true)) complain('boot2', 'checksum');
function enterBoot() {
  mcu.sram.set(boot, 0x41f00);
  core.SP = 0x20041f00;
  core.PC = 0x20041f00;
}
enterBoot();
play(false);

// ---- what the watchdog resets, as the firmware asks it to: everything but the oscillators
const timer = mcu.peripherals[0x40054], watchdog = mcu.peripherals[0x40058];
watchdog.onWatchdogTrigger = () => {
  for (const alarm of timer.alarms) timer.disarmAlarm(alarm);
  timer.intRaw = timer.intEnable = timer.intForce = 0;
  for (const channel of mcu.pwm.channels) channel.reset();
  mcu.sio.gpioValue = mcu.sio.gpioOutputEnable = 0;
  for (const pin of mcu.gpio) {
    pin.ctrl = 0x1f;
    pin.checkForUpdates();
  }
  watchdog.enable = watchdog.timer.enable = watchdog.alarm.enable = false;
  core.pendingInterrupts = core.enabledInterrupts = 0;
  core.pendingPendSV = core.pendingSystick = core.waiting = core.PM = false;
  core.IPSR = 0;
  enterBoot();
};

const probed = probe?.(mcu, ...probeArguments);
while (!done) {
  let cycles;
  const pc = core.PC, waiting = core.waiting;
  // A program that goes round in one instruction waits, too.
  const stuck = poked.length && !core.waiting && mcu.readUint16(pc) === 0xe7fe && !core.checkForInterrupts();
  if (core.waiting || stuck) {
    cycles = Math.max(1, Math.ceil((clock.nanosToNextAlarm * mcu.clkSys) / 1e9 - 1e-6));
    core.cycles += cycles;
  } else {
    const before = core.cycles;
    core.executeInstruction();
    cycles = core.cycles - before;
  }
  if (probed?.step(pc, cycles, waiting)) done = true;
  clock.tick((cycles * 1e9) / mcu.clkSys);
  if (core.waiting && core.checkForInterrupts()) core.waiting = false;
  if (problems.length || clock.nanos > moved + STILL_NS) done = true;
}
buffer.push(`#${Math.round(clock.nanos * 1000)}\n`);
flush();
closeSync(vcd);
writeFileSync(textFile, text, 'latin1');
if (store) writeFileSync(store, mcu.flash.slice(STORE_AT, STORE_AT + 16384));
probed?.finish(text);
for (const p of problems) console.error(`rp2040js: ${p}`);
process.exit(problems.length ? 1 : 0);
